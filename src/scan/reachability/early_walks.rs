//! Who is hit by robots that restart by themselves, before it is known what they do on all histories: walks to where they come, whatever
//! sensors report on the way. Nothing follows from walks on which nobody is hit.

use std::time::Instant;

use super::demonstrate::sensors;
use super::guided_walks::Guided;
use super::random_walks::Seek;
use super::{AnalysisContext, SEED};
use crate::reachability::{History, Moment, ReachabilitySearch as Search, known};
use crate::search::Rng;

/// They are run for this part of the time that is left.
const SHARE: u32 = 10;

impl AnalysisContext<'_> {
    /// Runs walks to where robots of some histories come, and tells of those on which somebody is hit.
    pub(super) fn soon(&mut self, search: &Search<'_>, first: &[bool], histories: &[History]) {
        let stop = self.prepared.stop();
        let ends_at = stop.left().map(|left| Instant::now() + left / SHARE);
        let Some((history, harms)) = search.near_robots(histories, &mut Rng::new(SEED)) else { return };
        let seek = Seek { prepared: self.prepared, search, first, history: &history, any_time: true };
        let guided = Guided { seek, few: None, until: self.steps() };
        let goes_on = || !stop.is_due() && ends_at.is_none_or(|ends_at| Instant::now() < ends_at);
        let mut found = Vec::new();
        guided.each(&harms, SEED, &goes_on, &mut |harm, way, finding| {
            found.push((*harm, way.clone(), finding.clone()));
        });
        for (harm, way, finding) in found {
            self.rest.shown.add(&finding, &way, &self.links);
            let as_told = sensors(self.prepared, &known(&finding.sensors));
            let (at, step) = (finding.person, way.lead_in + finding.step);
            // Where and when somebody is hit is told of the time that was asked for.
            if step <= self.steps() {
                self.met.push((Moment { xy_m: [at.x, at.y], step, ratio: finding.contact.ratio() }, false));
            }
            let place = self.place(&harm, &way, Some(&finding), &as_told, 1);
            self.tell_of(place);
        }
    }
}
