//! Findings of the same kind under one stable id.
//!
//! A hazard's identity is what the engineer would call the same problem: class, body region, robot link, sensor states,
//! programme phase, the 0.25 m square of floor the person stands on, and which of two people it is. Its id is a hash of exactly these, so the
//! same hazard has the same id in every scan of the same cell.

use std::collections::BTreeMap;

use num_bigint::BigUint;
use sha2::{Digest as _, Sha256};

use super::criterion::Class;
use super::finding::Finding;
use super::place::place_cell;
use crate::human::{Action, Who};
use crate::standards::BodyRegion;

/// What makes two findings the same hazard.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Identity {
    class: Class,
    region: BodyRegion,
    link: String,
    sensors: Vec<bool>,
    phase: Option<i64>,
    place: (i64, i64),
    who: Who,
}

impl Identity {
    /// The identity of `finding`; `link_names` names the robot link shapes.
    #[must_use]
    pub fn of(finding: &Finding, link_names: &[String]) -> Self {
        Self {
            class: finding.class,
            region: finding.contact.region,
            link: link_names[finding.contact.link].clone(),
            sensors: finding.sensors.clone(),
            phase: finding.phase,
            place: place_cell(finding.person),
            who: finding.who,
        }
    }

    /// The id shown to people, for instance `H-7f3a21`.
    #[must_use]
    pub fn id(&self) -> String {
        let sensors: String = self.sensors.iter().map(|&s| if s { '1' } else { '0' }).collect();
        let phase = self.phase.map_or_else(|| "-".to_owned(), |p| p.to_string());
        let class = self.class.name();
        let who = if self.who == Who::Second { "|second" } else { "" };
        let (x, y) = self.place;
        let text = format!("{class}|{}|{}|{sensors}|{phase}|{x},{y}{who}", self.region, self.link);
        let hash = Sha256::digest(text.as_bytes());
        format!("H-{:02x}{:02x}{:02x}", hash[0], hash[1], hash[2])
    }
}

/// A hazard: its worst finding and how often it was met.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Stable id.
    pub id: String,
    /// The finding with the highest force ratio; the earlier found of equals.
    pub worst: Finding,
    /// Iteration (from 1) in which the hazard was first met.
    pub first_iteration: u64,
    /// Number of findings.
    pub times_found: u64,
    /// Earliest time of contact over all its findings, s.
    pub earliest_s: f64,
    /// The finding with the fewest actions; of these the calmest, then the first in the order of actions.
    pub shortest: Finding,
    /// How many sequences of full length begin with a finding of this group, where all were looked at.
    pub sequences: Option<BigUint>,
}

/// Order of sequences: fewer actions, then less effort, then the order of actions.
#[must_use]
pub fn calmness(actions: &[Action]) -> (usize, u32, Vec<Action>) {
    (actions.len(), actions.iter().map(|a| a.effort()).sum(), actions.to_vec())
}

/// All hazards of a scan.
#[derive(Clone, Debug, Default)]
pub struct Groups {
    groups: BTreeMap<Identity, Group>,
}

impl Groups {
    /// Takes in a finding of `iteration`; returns its group's id if the group is new.
    pub fn add(&mut self, finding: Finding, iteration: u64, link_names: &[String]) -> Option<String> {
        self.add_counted(finding, None, iteration, link_names)
    }

    /// The same for a finding that stands for so many sequences of full length.
    pub fn add_counted(
        &mut self,
        finding: Finding,
        sequences: Option<BigUint>,
        iteration: u64,
        link_names: &[String],
    ) -> Option<String> {
        let identity = Identity::of(&finding, link_names);
        if let Some(group) = self.groups.get_mut(&identity) {
            group.times_found += 1;
            group.earliest_s = group.earliest_s.min(finding.time_s);
            group.sequences = match (group.sequences.take(), sequences) {
                (Some(all), Some(more)) => Some(all + more),
                (known, more) => known.or(more),
            };
            if calmness(&finding.actions) < calmness(&group.shortest.actions) {
                group.shortest = finding.clone();
            }
            if finding.contact.ratio() > group.worst.contact.ratio() {
                group.worst = finding;
            }
            return None;
        }
        let id = identity.id();
        let earliest_s = finding.time_s;
        let group = Group {
            id: id.clone(),
            shortest: finding.clone(),
            worst: finding,
            first_iteration: iteration,
            times_found: 1,
            earliest_s,
            sequences,
        };
        self.groups.insert(identity, group);
        Some(id)
    }

    /// Hazards with the worst first.
    #[must_use]
    pub fn ranked(&self) -> Vec<&Group> {
        let mut all: Vec<&Group> = self.groups.values().collect();
        all.sort_by(|a, b| b.worst.contact.ratio().total_cmp(&a.worst.contact.ratio()).then(a.id.cmp(&b.id)));
        all
    }

    /// Adds these hazards to those of another search of the same cell, whose figures hold where both met a hazard.
    /// Returns the ids that the other one did not meet.
    pub fn added_to(self, other: &mut Self) -> Vec<String> {
        let mut added = Vec::new();
        for (identity, group) in self.groups {
            match other.groups.get_mut(&identity) {
                Some(known) => known.first_iteration = group.first_iteration,
                None => {
                    added.push(group.id.clone());
                    other.groups.insert(identity, group);
                }
            }
        }
        added
    }

    /// The hazard with this id.
    #[must_use]
    pub fn get(&self, id: &str) -> Option<&Group> {
        self.groups.values().find(|group| group.id == id)
    }

    /// Every hazard, to replace its shortest sequence.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = (&Identity, &mut Group)> {
        self.groups.iter_mut()
    }

    /// Whether there is such a hazard.
    #[must_use]
    pub fn has(&self, identity: &Identity) -> bool {
        self.groups.contains_key(identity)
    }

    /// What tells the hazards apart.
    pub fn identities(&self) -> impl Iterator<Item = &Identity> {
        self.groups.keys()
    }

    /// Number of hazards.
    #[must_use]
    pub fn len(&self) -> usize {
        self.groups.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.groups.is_empty()
    }
}
