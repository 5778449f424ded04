//! An action from a state: where it leads everybody, what is sensed on the way, and what the FMU answers.
//!
//! Where something follows the FMU, what it says in a step changes the next one. So the action is gone as if nothing changed in it; and
//! where the FMU says otherwise, again amid what it said, until it says the same ([`World::walks_amid`](super::World::walks_amid)). An
//! FMU that cannot finish an action tried so is not asked further: the action counts as not evaluated.

use std::sync::Arc;

use super::robots::Robots;
use super::sensors::DelayLine;
use super::world::{InputTrace, Places, Walks, World};
use crate::host::{Advanced, NodeId, Plant, PlantError};
use crate::human::{Action, Arrangement, Presses};

/// Where an action begins.
#[derive(Clone, Copy, Debug)]
pub struct ActionStart<'a> {
    /// State of the FMU.
    pub node: NodeId,
    /// Where people stand.
    pub places: Places,
    /// What sensors have still to report.
    pub delays: &'a [DelayLine],
    /// Controls that are switched over.
    pub switched: Presses,
}

impl ActionStart<'_> {
    /// What sensors and controls tell in an action that leads everybody so.
    pub(super) fn sense(&self, world: &World, walks: &Walks, action: Action) -> InputTrace {
        let worked = world.worked_by(&walks.starts(), action);
        world.sense(self.delays, self.switched, &world.raw_readings_of_all(walks, action), &worked)
    }
}

/// What became of an action.
pub struct CarriedOut {
    /// Where people went.
    pub walks: Walks,
    /// What sensors saw and reported.
    pub sensed: InputTrace,
    /// What the FMU did.
    pub advanced: Advanced,
}

impl<P: Plant> Robots<P> {
    /// Where everybody begins, amid what the FMU says then.
    pub fn starts(&self) -> Places {
        let (world, outputs) = (self.world(), self.recall.outputs(NodeId::ROOT));
        let row = world.binding.rows(outputs, None, world.cell.step_s);
        world.starts().amid(world.arrangement(&row))
    }

    /// Where everybody is after the action into `node` that has led them to these places: amid what the FMU says then.
    pub fn amid_what_is_said(&mut self, ends: &Places, node: NodeId) -> Places {
        if !self.world().follows() {
            return *ends;
        }
        self.said(node).last().map_or(*ends, |said| ends.amid(*said))
    }

    /// An action, as everybody takes it; what the FMU is told besides, `tell` adds.
    ///
    /// # Errors
    /// When the FMU fails.
    pub(super) fn go(
        &mut self,
        from: &ActionStart<'_>,
        action: Action,
        tell: &dyn Fn(&mut InputTrace),
    ) -> Result<CarriedOut, PlantError> {
        let walks = self.world().walks(from.places, action);
        self.go_along(from, walks, action, tell)
    }

    /// The same, tried first along these ways.
    ///
    /// # Errors
    /// When the FMU fails.
    pub fn go_along(
        &mut self,
        from: &ActionStart<'_>,
        mut walks: Walks,
        action: Action,
        tell: &dyn Fn(&mut InputTrace),
    ) -> Result<CarriedOut, PlantError> {
        let rounds = self.world().cell.steps_per_action;
        for _ in 0..=rounds {
            let mut sensed = from.sense(self.world(), &walks, action);
            tell(&mut sensed);
            let advanced = self.advance(from.node, &sensed.inputs)?;
            let Advanced::To(node) = advanced else { return Ok(CarriedOut { walks, sensed, advanced }) };
            let Some(said) = self.says_otherwise(&walks, node) else {
                return Ok(CarriedOut { walks, sensed, advanced });
            };
            walks = self.world().walks_amid(from.places, action, &said);
        }
        Err(PlantError::of("the FMU says in a step what follows from later ones: nothing can follow its outputs"))
    }

    /// What the FMU said after each step of the action into `node`, if everybody does not walk amid that.
    pub fn says_otherwise(&mut self, walks: &Walks, node: NodeId) -> Option<Arc<[Arrangement]>> {
        if !self.world().follows() {
            return None;
        }
        let said = self.said(node);
        (!walks.are_amid(&said)).then_some(said)
    }
}
