//! The options that say where FMUs run and what they may do there.

use std::time::Duration;

use super::exit::Failure;
use super::output;
use crate::host::isolation::{Guard, Limits};
use crate::scan::Hosting;
use crate::stop::Stop;

/// Longest time of a call unless told otherwise, s.
const TIMEOUT_S: u64 = 10;

/// Memory of a process unless told otherwise, MB.
const MEMORY_MB: u64 = 4000;

#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Where the FMU runs")]
pub(super) struct HostingArguments {
    /// Run the FMU in this process, for debugging: a crash of it ends everything
    #[arg(long, conflicts_with = "trust_fmu")]
    in_process: bool,
    /// Let the FMU do what you may do: read and write files, use the network, start programs. For FMUs that need a
    /// licence server or another tool
    #[arg(long)]
    trust_fmu: bool,
    /// Longest time of one call of the FMU, s
    #[arg(long, default_value_t = TIMEOUT_S, value_parser = clap::value_parser!(u64).range(1..86_400))]
    fmu_timeout: u64,
    /// Most memory of a process in which the FMU runs, MB
    #[arg(long, default_value_t = MEMORY_MB, value_parser = clap::value_parser!(u64).range(64..))]
    fmu_memory: u64,
}

impl Default for HostingArguments {
    fn default() -> Self {
        Self { in_process: false, trust_fmu: false, fmu_timeout: TIMEOUT_S, fmu_memory: MEMORY_MB }
    }
}

impl HostingArguments {
    /// Hands on the options that change what an FMU can do, and so what comes out.
    pub(super) fn told(&self, add: &mut dyn FnMut(&str, Option<String>)) {
        if self.trust_fmu {
            add("--trust-fmu", None);
        }
        if self.fmu_timeout != TIMEOUT_S {
            add("--fmu-timeout", Some(self.fmu_timeout.to_string()));
        }
        if self.fmu_memory != MEMORY_MB {
            add("--fmu-memory", Some(self.fmu_memory.to_string()));
        }
    }

    /// What `--in-process` and the like choose.
    pub(super) fn hosting(&self) -> Result<Hosting, Failure> {
        self.heeding(&Stop::default())
    }

    /// The same; whatever the FMU does ends when `stop` says so.
    pub(super) fn heeding(&self, stop: &Stop) -> Result<Hosting, Failure> {
        if self.in_process {
            output::warning("the FMU runs in this process: a crash of it ends everything, it may do what you may");
            return Ok(Hosting::InProcess(stop.clone()));
        }
        let program = std::env::current_exe()
            .map_err(|e| Failure::unusable(format!("this program cannot find itself to start a worker: {e}")))?;
        let guard = if self.trust_fmu { Guard::Trusted } else { Guard::Sandboxed };
        if self.trust_fmu {
            output::warning("the FMU is trusted: it can read and write your files, use the network and start programs");
        }
        let call = Duration::from_secs(self.fmu_timeout);
        let limits = Limits { call, memory: self.fmu_memory * 1_000_000, stop: stop.clone(), ..Limits::default() };
        Ok(Hosting::Workers { program, guard, limits })
    }
}
