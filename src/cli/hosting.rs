//! The options that say where FMUs run and what they may do there.

use std::time::Duration;

use super::exit::Failure;
use super::output;
use crate::host::isolation::{Guard, Limits};
use crate::scan::Hosting;
use crate::stop::Stop;

/// Longest time of a call unless told otherwise.
const TIMEOUT: Duration = Duration::from_secs(10);

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
    /// Longest time of one call of the FMU, s; or with its unit, as 50ms or 2m
    #[arg(long, value_name = "TIME", default_value = "10", value_parser = time_of_a_call)]
    fmu_timeout: Duration,
    /// Most memory of a process in which the FMU runs, MB
    #[arg(long, default_value_t = MEMORY_MB, value_parser = clap::value_parser!(u64).range(64..))]
    fmu_memory: u64,
}

impl Default for HostingArguments {
    fn default() -> Self {
        Self { in_process: false, trust_fmu: false, fmu_timeout: TIMEOUT, fmu_memory: MEMORY_MB }
    }
}

impl HostingArguments {
    /// An option of these that was given, and is not as it is anyway.
    pub(super) fn given(&self) -> Option<&'static str> {
        let given = [
            ("--in-process", self.in_process),
            ("--trust-fmu", self.trust_fmu),
            ("--fmu-timeout", self.fmu_timeout != TIMEOUT),
            ("--fmu-memory", self.fmu_memory != MEMORY_MB),
        ];
        given.into_iter().find(|(_, is)| *is).map(|(option, _)| option)
    }

    /// Hands on the options that change what an FMU can do, and so what comes out.
    pub(super) fn told(&self, add: &mut dyn FnMut(&str, Option<String>)) {
        if self.trust_fmu {
            add("--trust-fmu", None);
        }
        if self.fmu_timeout != TIMEOUT {
            add("--fmu-timeout", Some(self.fmu_timeout.as_secs_f64().to_string()));
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
        let limits = Limits {
            call: self.fmu_timeout,
            memory: self.fmu_memory * 1_000_000,
            stop: stop.clone(),
            ..Limits::default()
        };
        Ok(Hosting::Workers { program, guard, limits })
    }
}

/// Seconds, or a time with its unit, from a millisecond to a day.
fn time_of_a_call(text: &str) -> Result<Duration, String> {
    let form = |e| format!("{e}: give it in seconds, or as 50ms, 5s or 2m");
    let time = match text.trim().parse() {
        Ok(seconds) => Duration::try_from_secs_f64(seconds).map_err(|e| form(e.to_string()))?,
        Err(_) => humantime::parse_duration(text).map_err(|e| form(e.to_string()))?,
    };
    let allowed = Duration::from_millis(1)..=Duration::from_secs(86_400);
    if allowed.contains(&time) { Ok(time) } else { Err("it is not from 1ms to 1day".to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_of_a_call_are_seconds_or_have_a_unit() {
        let of = |text: &str| time_of_a_call(text).ok().map(|time| time.as_millis());
        let given =
            ["10", "0.05", "50ms", "2m", "1day", "0", "0.0005", "100us", "86401", "-1", "NaN", "inf", "soon", ""];
        let right = [Some(10_000), Some(50), Some(50), Some(120_000), Some(86_400_000)];
        assert_eq!(given.map(of)[..5], right);
        assert_eq!(given.map(of)[5..], [None; 9]);
    }
}
