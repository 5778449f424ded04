//! The exhaustive search as tests look into it: all of its findings to the last bit, with how many sequences begin so, and of a person
//! who takes some of the actions only.

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use fmi_hazard::hazard::Finding;
use fmi_hazard::host::{Hosted, PlantError};
use fmi_hazard::human::{Action, Repertoire};
use fmi_hazard::scan::{Prepared, StateChoice};
use fmi_hazard::search::exhaustive::{Account, Budget, Expanded, Expansion, PriorState, SearchEvent, exhaust};
use fmi_hazard::sequences::{Expander, Merge, State};

/// No bound, and what is too far away is dropped.
pub const BUDGET: Budget = Budget { states: usize::MAX, bytes: usize::MAX, work: u64::MAX, drop: true };

/// Where, when and how a finding happens, to the last bit, and how many sequences begin so.
pub type Unsafe = BTreeMap<String, u128>;

pub fn key(finding: &Finding) -> String {
    // The calmest of many sequences stands for all, so the actions before the last are left out.
    format!("{:?} {:?}", finding.actions.last(), Finding { actions: Vec::new(), ..finding.clone() })
}

pub fn expander(prepared: &Prepared, merge: Merge) -> Expander<Hosted> {
    let (cell, binding) = (prepared.cell.clone(), prepared.binding.clone());
    Expander::new(cell, binding, prepared.plant(StateChoice::Auto), prepared.policy(StateChoice::Auto), merge, 2)
        .unwrap()
}

pub fn exhausted<E: Expansion<Unsafe = Finding>>(expansion: &mut E, budget: Budget) -> (Account, Unsafe)
where
    E::Error: std::fmt::Debug,
{
    let mut found = Unsafe::new();
    let account = exhaust(expansion, budget, &mut |told| {
        if let SearchEvent::UnsafeState(met) = told {
            *found.entry(key(&met.unsafe_state)).or_default() += u128::try_from(met.sequences).unwrap();
        }
        ControlFlow::Continue(())
    });
    (account.unwrap(), found)
}

/// A person who takes some of the actions only.
pub struct Few(pub Expander<Hosted>, Vec<Action>, Repertoire);

impl Few {
    pub fn of(prepared: &Prepared, actions: &[Action]) -> Self {
        Self(expander(prepared, Merge::Auto), actions.to_vec(), prepared.cell.repertoire.clone())
    }
}

impl Expansion for Few {
    type State = State;
    type Unsafe = Finding;
    type Error = PlantError;

    fn actions(&self) -> usize {
        self.1.len()
    }
    fn horizon(&self) -> usize {
        self.0.horizon()
    }
    fn effort(&self, action: usize) -> u32 {
        self.1[action].effort()
    }
    fn start(&mut self) -> Result<State, PlantError> {
        self.0.start()
    }
    fn may_matter(&self, state: &State, remaining: usize) -> bool {
        self.0.may_matter(state, remaining)
    }
    fn expand(
        &mut self,
        depth: usize,
        states: &[(&State, PriorState)],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Option<Vec<Expanded<State, Finding>>>, PlantError> {
        let Some(mut all) = self.0.expand(depth, states, go_on)? else { return Ok(None) };
        for one in &mut all {
            let few = |action: usize| self.1.iter().position(|few| self.2.index(*few) == Some(action));
            one.noted.retain_mut(|noted| few(noted.action).map(|action| noted.action = action).is_some());
            one.effects = self.1.iter().map(|action| one.effects[self.2.index(*action).unwrap()].clone()).collect();
        }
        Ok(Some(all))
    }
    fn release_before(&mut self, depth: usize) {
        self.0.release_before(depth);
    }
    fn bytes(&self) -> usize {
        self.0.bytes()
    }
}
