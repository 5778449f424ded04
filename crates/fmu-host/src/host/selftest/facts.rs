//! What the first run and the FMUs tell besides outputs.

use fmu_self_test::Untried;
use serde::{Deserialize, Serialize};

use super::motion;
use crate::fmi::Slave;
use crate::host::system::SystemSetup;

/// What the first run and the FMUs tell besides outputs.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(in crate::host) struct Facts {
    /// Whether each FMU is run with its Event Mode.
    pub event_mode: Vec<bool>,
    /// Why half steps would say nothing.
    pub against_half_steps: Option<Untried>,
    /// Why the other of with Event Mode and without would say nothing.
    pub against_other_mode: Option<Untried>,
    /// See [`fmu_self_test::SelfTest::remarks`].
    pub remarks: Vec<String>,
}

impl Facts {
    /// After the first run.
    pub(in crate::host) fn of(slaves: &[Slave], setup: &SystemSetup) -> Self {
        let remark = |(slave, name): (&Slave, &String)| {
            let at_s = slave.left_event_s()?;
            let of = if slaves.len() > 1 { format!("`{name}`") } else { "the FMU".to_owned() };
            Some(format!(
                "{of} says at t = {at_s:.3} s, at the end of a step, that an event is to be handled in Event Mode, which its \
                 modelDescription.xml does not offer (hasEventMode): it is stepped on without. Ask its maker whether it \
                 handles its events by itself"
            ))
        };
        Self {
            event_mode: slaves.iter().map(Slave::prefers_event_mode).collect(),
            against_half_steps: motion::against_half_steps(slaves, setup),
            against_other_mode: motion::against_other_mode(slaves),
            remarks: slaves.iter().zip(&setup.names).filter_map(remark).collect(),
        }
    }
}
