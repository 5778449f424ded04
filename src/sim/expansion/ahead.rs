//! Where the actions from a place lead, and what there is for the sensors to see on the way.

use std::collections::{BTreeMap, BTreeSet};

use super::{Expander, State};
use crate::host::Plant;
use crate::human::walk::WalkTrace;
use crate::human::{Action, Place, Posture, Walk};
use crate::sim::threads::shared_out;
use crate::sim::world::{Sight, World};

/// Where the actions from a place lead, and what there is for the sensors to see on the way.
pub(super) struct Ahead {
    /// By walk.
    pub(super) walks: Vec<WalkTrace>,
    /// By walk and posture; one posture only where the sensors see all alike.
    pub(super) sights: Vec<Vec<Vec<Sight>>>,
}

impl Ahead {
    fn new(world: &World, place: Place) -> Self {
        let walk = |w| world.walk(place, Action::new(w, Posture::Upright));
        let walks: Vec<WalkTrace> = Walk::ALL.into_iter().map(walk).collect();
        let sights = |walked: &WalkTrace| {
            let told_apart = if world.posture_is_unseen_on(walked) { &Posture::ALL[..1] } else { &Posture::ALL };
            told_apart.iter().map(|&bent| world.sights(walked, bent)).collect()
        };
        Self { sights: walks.iter().map(sights).collect(), walks }
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
