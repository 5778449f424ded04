//! Plain enumeration: what an exhaustive search is compared with.

use std::collections::BTreeMap;

use fmi_hazard::hazard::{Finding, Identity};
use fmi_hazard::host::Hosted;
use fmi_hazard::human::Action;
use fmi_hazard::record::hazard::Hazard;
use fmi_hazard::record::model::ScanReport;
use fmi_hazard::scan::{Prepared, StateChoice};
use fmi_hazard::search::{End, Environment as _};
use fmi_hazard::sim::Simulation;

use super::exhausted::Unsafe;
use super::guarded::every_sequence;

/// Every sequence, taken one action after the other, and no state compared with another. By replay, what an action does is worked out each
/// time; else it is remembered, by all inputs of the FMU until then, where the person stands and what the sensors have seen.
pub struct Enumeration<'a> {
    simulation: Simulation<Hosted>,
    actions: &'a [Action],
    name: &'a dyn Fn(&Finding) -> String,
    pub found: Unsafe,
    pub harmless: u128,
}

impl<'a> Enumeration<'a> {
    /// Of these actions; with what is found called by `name`.
    pub fn of(
        prepared: &Prepared,
        state: StateChoice,
        actions: &'a [Action],
        name: &'a dyn Fn(&Finding) -> String,
    ) -> Self {
        let simulation = prepared.simulation(state, false).unwrap();
        let left = u32::try_from(simulation.horizon()).unwrap();
        let mut all = Self { simulation, actions, name, found: Unsafe::new(), harmless: 0 };
        all.simulation.reset().unwrap();
        all.below(left);
        all
    }

    fn below(&mut self, left: u32) {
        let here = self.simulation.save();
        for &action in self.actions {
            self.simulation.restore(&here).unwrap();
            let end = self.simulation.take(action).unwrap().end;
            match (end, self.simulation.take_findings().as_slice()) {
                (Some(End::Unsafe), [finding]) => {
                    let rest = u128::try_from(self.actions.len()).unwrap().pow(left - 1);
                    *self.found.entry((self.name)(finding)).or_default() += rest;
                }
                (Some(End::Horizon), []) => self.harmless += 1,
                (None, []) => self.below(left - 1),
                (end, findings) => panic!("{end:?}: {findings:?}"),
            }
        }
    }

    pub fn hazardous(&self) -> u128 {
        self.found.values().sum()
    }
}

/// A whole scan of every sequence of all actions against plain enumeration: its hazards, how many sequences are of each, and all counts.
/// Tells how many sequences are hazardous.
pub fn whole_scan_as_enumerated(prepared: &Prepared, state: StateChoice, of: &str) -> (u128, ScanReport) {
    let all: Vec<Action> = prepared.cell.repertoire.all().collect();
    let report = every_sequence(prepared, false);
    let links: Vec<String> = prepared.cell.links.iter().map(|link| link.name.clone()).collect();
    let name = |finding: &Finding| {
        let (id, contact) = (Identity::of(finding, &links).id(), &finding.contact);
        format!("{id}: {} {}", contact.region, links[contact.link])
    };
    let plain = Enumeration::of(prepared, state, &all, &name);
    let counted = |hazard: &Hazard| {
        let sequences: u128 = hazard.sequences.as_ref().unwrap().parse().unwrap();
        (format!("{}: {} {}", hazard.id, hazard.body_region, hazard.robot_link), sequences)
    };
    let found: BTreeMap<String, u128> = report.hazards.iter().map(counted).collect();
    assert_eq!(found, plain.found, "{of}");
    let certificate = report.certificate.as_ref().unwrap();
    let [total, hazardous, harmless, excluded] =
        [&certificate.sequences, &certificate.hazardous, &certificate.harmless, &certificate.excluded]
            .map(|count| count.parse::<u128>().unwrap());
    let horizon = u32::try_from(plain.simulation.horizon()).unwrap();
    assert_eq!(total, u128::try_from(all.len()).unwrap().pow(horizon), "{of}");
    assert_eq!(hazardous, plain.hazardous(), "{of}");
    // What cannot meet the robot any more is dropped, and harmless.
    assert_eq!(harmless + excluded, plain.harmless, "{of}");
    assert_eq!(hazardous + harmless + excluded, total, "{of}");
    assert!(certificate.merged > 0, "{of}: no state is merged");
    (hazardous, report)
}
