//! Whose a hazard is that is met in a changed cell: of the cause that is worked against, of another one that the scan knows, or
//! of none of them.

use std::collections::BTreeSet;

use crate::cell::Workcell;
use crate::hazard::cause::{Kind, Member, TOGETHER_M, apart, causes};
use crate::hazard::{BodyOrArm, Finding};
use crate::record::hazard::Hazard;
use crate::scan::causes::member;
use crate::scan::prepare::Prepared;

/// Whose a hazard is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Whose {
    /// Of the cause that is worked against.
    Own,
    /// Of another cause of the same scan.
    Others,
    /// Of none: the change brought it about, or made it another one.
    Nobodys,
}

/// The cause that is worked against, and the others of the scan.
pub(super) struct TargetCause {
    /// Ids of its hazards: it is gone when none of them is there, whatever else is at the same place.
    ids: BTreeSet<String>,
    own: Vec<Member>,
    others: Vec<Member>,
}

impl TargetCause {
    /// The cause of `hazard`, among those of all hazards of its scan.
    pub(crate) fn new(prepared: &Prepared, hazard: &Hazard, known: &[Hazard]) -> Self {
        let mut all: Vec<Member> = known.iter().map(|hazard| member(prepared, hazard)).collect();
        let number = known.iter().position(|other| other.id == hazard.id).unwrap_or_else(|| {
            all.push(member(prepared, hazard));
            all.len() - 1
        });
        let of_it = causes(&all).into_iter().find(|cause| cause.members.contains(&number));
        let of_it = of_it.map_or_else(|| vec![number], |cause| cause.members);
        let ids = of_it.iter().filter_map(|&number| Some(known.get(number)?.id.clone())).chain([hazard.id.clone()]);
        let ids = ids.collect();
        let (mut own, mut others) = (Vec::new(), Vec::new());
        for (number, member) in all.into_iter().enumerate() {
            if of_it.contains(&number) { own.push(member) } else { others.push(member) }
        }
        Self { ids, own, others }
    }

    /// Whether the scan knows other causes.
    pub(crate) fn is_one_of_several(&self) -> bool {
        !self.others.is_empty()
    }

    /// Whose the hazard of this id is: first by that, then by what the sensors report at the contact and where that is. Since
    /// when they do depends on what is changed, and tells nothing; what they report may, too, and then the place tells.
    pub(crate) fn whose(&self, id: &str, met: &Member) -> Whose {
        let near = |known: &&Member| apart(known, met) <= TOGETHER_M;
        let who = |kind: &Kind| (kind.robot.clone(), kind.part, kind.criterion);
        let there = |known: &&Member| who(&known.kind) == who(&met.kind) && near(known);
        let alike = |known: &&Member| there(known) && known.kind.reporting == met.kind.reporting;
        if self.ids.contains(id) || self.own.iter().any(|known| alike(&known)) {
            Whose::Own
        } else if self.others.iter().any(|known| alike(&known)) {
            Whose::Others
        } else if self.own.iter().any(|known| there(&known)) {
            Whose::Own
        } else if self.others.iter().any(|known| there(&known)) {
            Whose::Others
        } else {
            Whose::Nobodys
        }
    }
}

/// A finding as causes see it.
pub(super) fn member_of(cell: &Workcell, finding: &Finding) -> Member {
    let robot = cell.links[finding.contact.link].robot;
    let reports = cell.sensors.iter().zip(&finding.sensors).filter(|(_, reports)| **reports);
    let (person, contact) = (finding.person, finding.contact.on_robot);
    Member {
        kind: Kind {
            robot: cell.robots[robot].name.clone(),
            part: BodyOrArm::of(finding.contact.region),
            reporting: reports.map(|(sensor, _)| sensor.name.clone()).collect(),
            long: false,
            criterion: finding.class.beside_force(),
            worked: Vec::new(),
        },
        person_m: [person.x, person.y],
        contact_m: [contact.x, contact.y],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(part: BodyOrArm, reporting: &[&str], x: f64) -> Member {
        let reporting = reporting.iter().map(|&name| name.to_owned()).collect();
        Member {
            kind: Kind { robot: "r".to_owned(), part, reporting, long: false, criterion: None, worked: Vec::new() },
            person_m: [x, 0.0],
            contact_m: [x, 1.0],
        }
    }

    #[test]
    fn hazards_are_told_apart_by_what_is_reported_and_where() {
        let aim = TargetCause {
            ids: ["H-1".to_owned()].into(),
            own: vec![at(BodyOrArm::Arm, &[], 0.0)],
            others: vec![
                at(BodyOrArm::Arm, &["mat"], 0.5),
                at(BodyOrArm::Arm, &[], 4.0),
                at(BodyOrArm::Body, &[], 0.0),
            ],
        };
        for (met, whose) in [
            (at(BodyOrArm::Arm, &[], 0.9), Whose::Own),
            (at(BodyOrArm::Arm, &["mat"], 0.9), Whose::Others),
            (at(BodyOrArm::Arm, &[], 3.5), Whose::Others),
            (at(BodyOrArm::Body, &[], -0.5), Whose::Others),
            // What reports has changed: still at the place of its own cause, or of another one.
            (at(BodyOrArm::Arm, &["curtain"], 0.9), Whose::Own),
            (at(BodyOrArm::Arm, &["curtain"], 4.0), Whose::Others),
            (at(BodyOrArm::Body, &["mat"], 0.0), Whose::Others),
            (at(BodyOrArm::Arm, &[], 2.0), Whose::Nobodys),
            (at(BodyOrArm::Body, &[], 2.0), Whose::Nobodys),
        ] {
            assert_eq!(aim.whose("H-2", &met), whose, "{met:?}");
            assert_eq!(aim.whose("H-1", &met), Whose::Own, "{met:?}");
        }
    }
}
