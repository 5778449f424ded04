//! Causes: hazards that an engineer would call one flaw, under one stable id.
//!
//! Of one cause are hazards of the same robot, at the body or at an arm, of which the same sensors report the person at the
//! contact, all of them only just or one for long, and whose places hang together. So a sensor that does not see, one that
//! sees too late, and a robot that does not heed it are three causes, and two openings of a fence are two. The region of the
//! body, the link and the phase of the programme are left out: one flaw shows itself at many. `docs/src/method.md` compares this with other definitions.

use std::collections::BTreeMap;

use sha2::{Digest as _, Sha256};

use super::part::BodyOrArm;
use super::place::PLACE_CELL_M;

/// Hazards belong together if neither where people stand nor where they are hit is farther apart than this, m. Before a fence
/// with two openings people may stand anywhere, but arms are hit behind the one or the other.
pub const TOGETHER_M: f64 = 1.0;

/// A robot that stops has stopped after so long, as a rule, s.
pub const LONG_S: f64 = 0.5;

/// Places of one cause among several of the same kind are told apart by the square of this edge that the middle of their
/// contacts is nearest to, m.
const SQUARE_M: f64 = 2.0;

/// What tells causes apart but for the place.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Kind {
    /// Name of the robot.
    pub robot: String,
    /// What is hit.
    pub part: BodyOrArm,
    /// Names of the sensors that report the person at the contact.
    pub reporting: Vec<String>,
    /// Whether one of them has done so for longer than [`LONG_S`]: then the robot is not too late, it does not heed it.
    pub long: bool,
    /// The criterion that it breaks, where that is not the transient force: being clamped is another flaw than being hit.
    pub criterion: Option<&'static str>,
    /// Names of the controls that are worked on the shortest and calmest way there: a restart with somebody inside is another flaw
    /// than a stop that comes too late.
    pub worked: Vec<String>,
}

/// A hazard as causes see it.
#[derive(Clone, Debug, PartialEq)]
pub struct Member {
    /// What tells it apart.
    pub kind: Kind,
    /// Where the person stands at the contact, floor plan, m.
    pub person_m: [f64; 2],
    /// Where the robot touches them, floor plan, m.
    pub contact_m: [f64; 2],
}

/// Hazards that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// Stable id, for instance `C-7f3a21`.
    pub id: String,
    /// What they have in common.
    pub kind: Kind,
    /// Which of the members.
    pub members: Vec<usize>,
}

/// The causes of hazards, in the order of their first members.
#[must_use]
pub fn causes(all: &[Member]) -> Vec<Cause> {
    let mut of_kind: BTreeMap<&Kind, Vec<usize>> = BTreeMap::new();
    for (number, member) in all.iter().enumerate() {
        of_kind.entry(&member.kind).or_default().push(number);
    }
    let mut causes = Vec::new();
    for (kind, members) in of_kind {
        let places = together(all, &members);
        let several = places.len() > 1;
        for members in places {
            let square = several.then(|| square(all, &members));
            causes.push(Cause { id: id(kind, square), kind: kind.clone(), members });
        }
    }
    causes.sort_by_key(|cause| cause.members[0]);
    // Two that are in one square all the same.
    for number in 1..causes.len() {
        let (before, this) = causes.split_at_mut(number);
        let twins = before.iter().filter(|other| other.id.starts_with(&this[0].id)).count();
        if twins > 0 {
            this[0].id += &format!("-{}", twins + 1);
        }
    }
    causes
}

/// How far apart they are, m: where the persons stand, or where they are hit, whichever is farther.
#[must_use]
pub fn apart(a: &Member, b: &Member) -> f64 {
    let between = |a: [f64; 2], b: [f64; 2]| libm::hypot(a[0] - b[0], a[1] - b[1]);
    between(a.person_m, b.person_m).max(between(a.contact_m, b.contact_m))
}

/// Members by place: each is no farther than [`TOGETHER_M`] from another one of its place.
fn together(all: &[Member], members: &[usize]) -> Vec<Vec<usize>> {
    let mut left = members.to_vec();
    let mut places = Vec::new();
    while let Some(first) = left.first().copied() {
        let mut place = vec![first];
        left.remove(0);
        let mut next = 0;
        while let Some(&from) = place.get(next) {
            next += 1;
            let near = |other: &usize| apart(&all[from], &all[*other]) <= TOGETHER_M;
            place.extend(left.iter().copied().filter(near));
            left.retain(|other| !near(other));
        }
        place.sort_unstable();
        places.push(place);
    }
    places
}

/// The square that the middle of the members' contacts is nearest to. Each quarter metre counts once, however many hazards
/// are there.
fn square(all: &[Member], members: &[usize]) -> [i64; 2] {
    #[expect(clippy::cast_possible_truncation, reason = "metres on a shop floor")]
    let cells: std::collections::BTreeSet<[i64; 2]> = members
        .iter()
        .map(|&member| all[member].contact_m.map(|metres| (metres / PLACE_CELL_M).floor() as i64))
        .collect();
    [0, 1].map(|axis| {
        #[expect(clippy::cast_precision_loss, reason = "squares on a shop floor")]
        let sum = cells.iter().map(|cell| (cell[axis] as f64 + 0.5) * PLACE_CELL_M).sum::<f64>();
        #[expect(clippy::cast_precision_loss, clippy::cast_possible_truncation, reason = "metres on a shop floor")]
        let square = (sum / cells.len() as f64 / SQUARE_M).round() as i64;
        square
    })
}

fn id(kind: &Kind, square: Option<[i64; 2]>) -> String {
    let part = kind.part.words();
    let place = square.map_or_else(String::new, |[x, y]| format!("{x},{y}"));
    let long = if kind.long { "long" } else { "" };
    // Names may hold any character but this one.
    let mut text = format!("{}\0{part}\0{}\0\0{long}\0{place}", kind.robot, kind.reporting.join("\0"));
    if let Some(criterion) = kind.criterion {
        text += &format!("\0{criterion}");
    }
    if !kind.worked.is_empty() {
        text += &format!("\0worked\0{}", kind.worked.join("\0"));
    }
    let hash = Sha256::digest(text.as_bytes());
    format!("C-{:02x}{:02x}{:02x}", hash[0], hash[1], hash[2])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Hit where they stand.
    fn member(part: BodyOrArm, reporting: &[&str], person_m: [f64; 2]) -> Member {
        let reporting = reporting.iter().map(|&name| name.to_owned()).collect();
        Member {
            kind: Kind { robot: "r".to_owned(), part, reporting, long: false, criterion: None, worked: Vec::new() },
            person_m,
            contact_m: person_m,
        }
    }

    #[test]
    fn what_is_seen_and_what_is_hit_tell_causes_apart() {
        let all = [
            member(BodyOrArm::Arm, &["mat"], [0.0, 0.0]),
            member(BodyOrArm::Arm, &[], [0.0, 0.0]),
            member(BodyOrArm::Arm, &["mat"], [0.5, 0.0]),
            member(BodyOrArm::Body, &[], [0.0, 0.0]),
        ];
        let long = |mut member: Member| {
            member.kind.long = true;
            member
        };
        let all = [&all[..], &[long(all[0].clone())]].concat();
        let found = causes(&all);
        let members: Vec<&[usize]> = found.iter().map(|cause| cause.members.as_slice()).collect();
        assert_eq!(members, [&[0, 2][..], &[1], &[3], &[4]]);
        let mut ids: Vec<&str> = found.iter().map(|cause| cause.id.as_str()).collect();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), 4);
    }

    /// A chain of places hangs together however long it is; a gap of more than a metre parts it.
    #[test]
    fn places_hang_together() {
        let at = |x: f64| member(BodyOrArm::Arm, &[], [x, 0.0]);
        let chain: Vec<Member> = (0..9).map(|i| at(f64::from(i) * 0.9)).collect();
        assert_eq!(causes(&chain).len(), 1);
        let two = [at(0.0), at(3.0), at(0.9), at(3.5)];
        let found = causes(&two);
        assert_eq!(found.iter().map(|cause| cause.members.clone()).collect::<Vec<_>>(), [vec![0, 2], vec![1, 3]]);
        assert_ne!(found[0].id, found[1].id);
        // People may stand anywhere before a fence: behind which opening they are hit, tells.
        let reaching = |x: f64, contact: f64| Member { contact_m: [contact, 1.0], ..at(x) };
        assert_eq!(causes(&[reaching(-0.4, -1.3), reaching(0.4, 1.3), reaching(0.0, -1.0)]).len(), 2);
    }

    /// The id of a cause rests on what it is, not on which of its hazards a search met.
    #[test]
    fn ids_do_not_depend_on_the_hazards_that_were_met() {
        let at = |x: f64| member(BodyOrArm::Body, &["scanner"], [x, 1.0]);
        let few = causes(&[at(0.1)]);
        let many = causes(&[at(0.6), at(0.1), at(-0.3)]);
        assert_eq!(few[0].id, many[0].id);
        // Of two places each keeps its own, whichever is worse.
        let one = causes(&[at(0.1), at(4.1), at(4.4)]);
        let other = causes(&[at(4.2), at(0.0)]);
        assert_eq!([&one[0].id, &one[1].id], [&other[1].id, &other[0].id]);
    }

    #[test]
    fn two_places_in_one_square_have_two_ids() {
        let at = |x: f64, y: f64| member(BodyOrArm::Body, &[], [x, y]);
        let found = causes(&[at(-0.9, 0.0), at(0.2, 0.0)]);
        assert_eq!(found.len(), 2);
        assert_eq!(found[1].id, format!("{}-2", found[0].id));
    }
}
