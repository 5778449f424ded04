//! Where the actions from a place lead, and what there is for the sensors to see on the way.

use std::collections::{BTreeMap, BTreeSet};

use super::{Expander, State};
use crate::host::Plant;
use crate::human::walk::WalkTrace;
use crate::human::{Action, Place, Posture};
use crate::sim::threads::shared_out;
use crate::sim::world::{Sight, World};

/// A way that some of the actions from a place lead.
pub(super) struct Way {
    pub(super) walked: WalkTrace,
    /// What there is to see on it, for postures that the sensors tell apart.
    pub(super) sights: Vec<Vec<Sight>>,
}

/// An action without a control, from a place.
#[derive(Clone, Copy)]
pub(super) struct Move {
    /// As the person takes it there.
    pub(super) taken: Action,
    /// Which way it leads.
    pub(super) way: usize,
    /// Which of its sights there is to see.
    pub(super) sight: usize,
}

/// Where the actions from a place lead, and what there is for the sensors to see on the way.
pub(super) struct Ahead {
    pub(super) ways: Vec<Way>,
    /// In the order of the actions.
    pub(super) moves: Vec<Move>,
}

impl Ahead {
    fn new(world: &World, place: Place) -> Self {
        let repertoire = &world.cell.repertoire;
        let (mut ways, mut moves): (Vec<Way>, Vec<Move>) = (Vec::new(), Vec::with_capacity(repertoire.moves()));
        for &walk in repertoire.walks() {
            // Whoever stands goes the same way in every posture; of the low ones each may get elsewhere.
            let mut known: Vec<(Posture, usize)> = Vec::new();
            let mut seen: Vec<(Posture, usize, usize)> = Vec::new();
            for &posture in repertoire.postures() {
                let taken = world.taken(&place, Action::new(walk, posture));
                let goes_as = if taken.posture().is_low() { taken.posture() } else { Posture::Upright };
                let way = match known.iter().find(|(as_well, _)| *as_well == goes_as) {
                    Some((_, way)) => *way,
                    None => {
                        known.push((goes_as, ways.len()));
                        ways.push(Way { walked: world.walk(place, taken), sights: Vec::new() });
                        ways.len() - 1
                    }
                };
                let Way { walked, sights } = &mut ways[way];
                let seen_as = if world.posture_is_unseen_on(walked) { goes_as } else { taken.posture() };
                let sight = match seen.iter().find(|(as_well, of, _)| (*as_well, *of) == (seen_as, way)) {
                    Some((_, _, sight)) => *sight,
                    None => {
                        seen.push((seen_as, way, sights.len()));
                        sights.push(world.sights(walked, seen_as));
                        sights.len() - 1
                    }
                };
                moves.push(Move { taken, way, sight });
            }
        }
        Self { ways, moves }
    }
}

impl<P: Plant> Expander<P> {
    /// Where the actions from each of these states lead, worked out on all threads; nothing if told to stop.
    pub(super) fn look_ahead(
        &self,
        states: &[&State],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Option<BTreeMap<Place, Ahead>> {
        let places: BTreeSet<Place> = states.iter().map(|state| state.place).collect();
        let places: Vec<Place> = places.into_iter().collect();
        let world = &self.world;
        let looked = shared_out(self.workers, places.len(), go_on, |numbers, _| {
            numbers.map(|number| Ahead::new(world, places[number])).collect::<Vec<_>>()
        })?;
        Some(places.iter().copied().zip(looked.into_iter().flatten()).collect())
    }
}
