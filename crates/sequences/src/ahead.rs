//! Where the actions from a place lead, and what there is for the sensors to see on the way.

use std::collections::{BTreeMap, BTreeSet};

use super::{Expander, State};
use crate::host::Plant;
use crate::human::walk::WalkTrace;
use crate::human::{Action, Place, Posture, Presses, Walk, Who};
use crate::sim::threads::shared_out;
use crate::sim::world::{Occupant, Places, RawReadings};

/// A way that some of the actions from a place lead.
pub(super) struct WalkPath {
    pub(super) walked: WalkTrace,
    /// What there is to see on it, for postures that the sensors tell apart.
    pub(super) sights: Vec<Vec<RawReadings>>,
}

/// An action without a control but those of doors, from a place.
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
    pub(super) ways: Vec<WalkPath>,
    /// In the order of the actions, for each set of doors that are worked.
    pub(super) moves: Vec<(Presses, Vec<Move>)>,
}

/// Ways that were worked out already.
#[derive(Default)]
struct WalkCache {
    ways: Vec<WalkPath>,
    /// Which of them an action leads that opens and closes these doors.
    leads: Vec<((Walk, Posture, Presses), usize)>,
    /// Which of the sights of a way there is to see in a posture.
    shows: Vec<(Posture, usize, usize)>,
}

impl Ahead {
    fn new(own: &Occupant, place: Place) -> Self {
        let mut known = WalkCache::default();
        let sets = Presses::all(if own.doors().is_none() { 0 } else { Presses::MOST });
        let doors = sets.filter(|doors| doors.common(own.doors()) == *doors);
        let moves = doors.map(|doors| (doors, Self::moves(own, place, doors, &mut known))).collect();
        Self { ways: known.ways, moves }
    }

    /// How the person takes the action with this number, in which these doors are worked.
    pub(super) fn taken(&self, number: usize, doors: Presses) -> Move {
        let (_, moves) = self.moves.iter().find(|(worked, _)| *worked == doors).unwrap_or(&self.moves[0]);
        moves[number % moves.len()]
    }

    fn moves(own: &Occupant, place: Place, doors: Presses, known: &mut WalkCache) -> Vec<Move> {
        let WalkCache { ways, leads, shows } = known;
        let repertoire = &own.cell.repertoire;
        let mut moves = Vec::with_capacity(repertoire.moves());
        let controls = (0..own.cell.controls.len()).map(Presses::one);
        let others = controls.filter(|control| control.common(own.doors()).is_none());
        let all = others.fold(doors, Presses::and);
        for &walk in repertoire.walks() {
            // Whoever stands goes the same way in every posture; of the low ones each may get elsewhere, and to other doors.
            for &posture in repertoire.postures() {
                let taken = own.taken(&place, Action::new(walk, posture));
                let stands_as = if taken.posture().is_low() { taken.posture() } else { Posture::Upright };
                let goes_as = (walk, stands_as, own.walk_opens(place, taken.pressing(doors)));
                let way = match leads.iter().find(|(as_well, _)| *as_well == goes_as) {
                    Some((_, way)) => *way,
                    None => {
                        leads.push((goes_as, ways.len()));
                        ways.push(WalkPath { walked: own.walk(place, taken.pressing(doors)), sights: Vec::new() });
                        ways.len() - 1
                    }
                };
                let WalkPath { walked, sights } = &mut ways[way];
                // Hands that get to controls are looked for here, on all threads, and remembered.
                let _ = own.worked(walked, taken.pressing(all));
                let seen_as = if own.posture_is_unseen_on(walked) { stands_as } else { taken.posture() };
                let sight = match shows.iter().find(|(as_well, of, _)| (*as_well, *of) == (seen_as, way)) {
                    Some((_, _, sight)) => *sight,
                    None => {
                        shows.push((seen_as, way, sights.len()));
                        sights.push(own.sights(walked, seen_as));
                        sights.len() - 1
                    }
                };
                moves.push(Move { taken, way, sight });
            }
        }
        moves
    }
}

/// The same from every place at which one of the people is in some state.
pub(super) struct Outlook {
    first: BTreeMap<Place, Ahead>,
    second: BTreeMap<Place, Ahead>,
}

impl Outlook {
    /// Where the actions of one of the people lead from where they are; nothing if they are not there.
    pub(super) fn of(&self, who: Who, places: &Places) -> Option<&Ahead> {
        match who {
            Who::First => self.first.get(&places.first),
            Who::Second => self.second.get(places.second.as_ref()?),
        }
    }
}

impl<P: Plant> Expander<P> {
    /// Where the actions from each of these states lead, worked out on all threads; nothing if told to stop.
    pub(super) fn look_ahead(&self, states: &[&State], go_on: &mut dyn FnMut() -> bool) -> Option<Outlook> {
        let of = |who: Who| states.iter().filter_map(move |state| Some((who, *state.places.of(who)?)));
        let places: BTreeSet<(Who, Place)> = Who::ALL.into_iter().flat_map(of).collect();
        let places: Vec<(Who, Place)> = places.into_iter().collect();
        let world = &self.world;
        let looked = shared_out(self.workers, places.len(), go_on, |numbers, _| {
            let of = |(who, place): &(Who, Place)| Ahead::new(world.of(*who).unwrap_or(&world.first), *place);
            places[numbers].iter().map(of).collect::<Vec<_>>()
        })?;
        let mut outlook = Outlook { first: BTreeMap::new(), second: BTreeMap::new() };
        for ((who, place), ahead) in places.into_iter().zip(looked.into_iter().flatten()) {
            let of = match who {
                Who::First => &mut outlook.first,
                Who::Second => &mut outlook.second,
            };
            of.insert(place, ahead);
        }
        Some(outlook)
    }
}
