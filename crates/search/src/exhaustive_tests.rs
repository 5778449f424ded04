//! The exhaustive search on a puzzle, against plain enumeration of all sequences.

use std::collections::BTreeMap;

use num_bigint::BigUint;

use super::*;

/// A token on a ring of 11 fields moves by -1, 0, 1 or 3. From even fields, action 3 is unsafe on fields that are
/// multiples of 5 at odd times; action 2 cannot be evaluated on field 7.
struct Ring {
    horizon: usize,
    /// States asked for, to see that equal ones are asked for once.
    expanded: usize,
    drop_beyond: Option<i64>,
    /// Whether the search goes on behind an unsafe state: there, fields that are multiples of 4 are pinching.
    goes_on: bool,
    /// Whether each expansion counts as work.
    works: bool,
}

const MOVES: [i64; 4] = [0, 1, -1, 3];

impl Ring {
    fn new(horizon: usize) -> Self {
        Self { horizon, expanded: 0, drop_beyond: None, goes_on: false, works: false }
    }

    fn pinches(field: i64, action: usize) -> bool {
        field % 4 == 0 && action != 2
    }

    fn effect(depth: usize, field: i64, action: usize) -> Effect<(usize, i64, usize)> {
        match action {
            3 if field % 5 == 0 && depth % 2 == 1 => Effect::Unsafe { met: (depth, field, action), then: None },
            2 if field == 7 => Effect::NotEvaluated("seven".to_owned()),
            _ => Effect::To(action),
        }
    }
}

impl Expansion for Ring {
    type State = i64;
    type Unsafe = (usize, i64, usize);
    type Error = ();

    fn actions(&self) -> usize {
        MOVES.len()
    }
    fn horizon(&self) -> usize {
        self.horizon
    }
    fn effort(&self, action: usize) -> u32 {
        [0, 1, 1, 5][action]
    }
    fn start(&mut self) -> Result<i64, ()> {
        Ok(2)
    }
    fn may_matter(&self, state: &i64, remaining: usize) -> bool {
        self.drop_beyond.is_none_or(|_| !(remaining == 1 && state % 5 != 0))
    }
    fn expand(
        &mut self,
        depth: usize,
        states: &[(&i64, PriorState)],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Option<ExpandedBy<Self>>, ()> {
        if !go_on() {
            return Ok(None);
        }
        self.expanded += states.len();
        let effect = |field: i64, before: PriorState, action: usize| match Self::effect(depth, field, action) {
            Effect::Unsafe { met, .. } if self.goes_on && before != PriorState::Unsafe => {
                Effect::Unsafe { met, then: Some(action) }
            }
            Effect::Unsafe { .. } if before == PriorState::Unsafe => Effect::To(action),
            effect => effect,
        };
        let expand = |field: i64, before: PriorState| Expanded {
            next: MOVES.iter().map(|m| (field + m).rem_euclid(11)).collect(),
            effects: (0..MOVES.len()).map(|a| effect(field, before, a)).collect(),
            noted: (0..MOVES.len())
                .filter(|a| before != PriorState::Safe && Self::pinches(field, *a))
                .map(|action| Noted { action, met: (depth, field, action), of: Of::Unsafe })
                .collect(),
        };
        Ok(Some(states.iter().map(|(field, before)| expand(**field, *before)).collect()))
    }
    fn release_before(&mut self, _: usize) {}
    fn bytes(&self) -> usize {
        0
    }
    fn work(&self) -> u64 {
        if self.works { self.expanded as u64 } else { 0 }
    }
}

const BUDGET: Budget = Budget { states: usize::MAX, bytes: usize::MAX, work: u64::MAX, drop: true };

/// Sequences by unsafe state, and the calmest that leads there.
type Unsafe = BTreeMap<(usize, i64, usize), (u64, u32, Vec<u32>)>;

fn exhausted(ring: &mut Ring, budget: Budget) -> (Account, Unsafe) {
    let mut met = Unsafe::new();
    let account = exhaust(ring, budget, &mut |told| {
        if let SearchEvent::UnsafeState(m) = told {
            let effort = m.prefixes.effort;
            let sequences = u64::try_from(m.sequences).unwrap();
            assert!(met.insert(m.unsafe_state, (sequences, effort, m.prefixes.calmest.clone())).is_none());
        }
        ControlFlow::Continue(())
    });
    (account.unwrap(), met)
}

/// Every sequence on its own, without merging.
fn enumerated(horizon: usize) -> (Unsafe, [u64; 3]) {
    let (mut met, mut fates) = (Unsafe::new(), [0; 3]);
    let ring = Ring::new(horizon);
    for code in 0..MOVES.len().pow(u32::try_from(horizon).unwrap()) {
        let actions: Vec<usize> = (0..horizon).map(|i| code / MOVES.len().pow(u32::try_from(i).unwrap()) % 4).collect();
        let (mut field, mut effort, mut fate) = (2_i64, 0, 1);
        for (depth, &action) in actions.iter().enumerate() {
            match Ring::effect(depth, field, action) {
                Effect::To(_) => field = (field + MOVES[action]).rem_euclid(11),
                Effect::NotEvaluated(_) => {
                    fate = 2;
                    break;
                }
                Effect::Unsafe { met: state, .. } => {
                    fate = 0;
                    let prefix: Vec<u32> = actions[..depth].iter().map(|a| u32::try_from(*a).unwrap()).collect();
                    let entry = met.entry(state).or_insert((0, effort, prefix.clone()));
                    entry.0 += 1;
                    if (effort, &prefix) < (entry.1, &entry.2) {
                        (entry.1, entry.2) = (effort, prefix);
                    }
                    break;
                }
            }
            effort += ring.effort(action);
        }
        fates[fate] += 1;
    }
    (met, fates)
}

#[test]
fn every_sequence_is_accounted_for_as_in_plain_enumeration() {
    for horizon in 1..=8 {
        let mut ring = Ring::new(horizon);
        let (account, met) = exhausted(&mut ring, BUDGET);
        let (expected, [hazardous, harmless, not_evaluated]) = enumerated(horizon);
        assert_eq!(met, expected, "horizon {horizon}");
        assert_eq!(account.hazardous, BigUint::from(hazardous));
        assert_eq!(account.harmless, BigUint::from(harmless));
        assert_eq!(account.not_evaluated, BigUint::from(not_evaluated));
        assert_eq!(account.covered() + account.not_evaluated.clone(), account.total);
        assert_eq!((account.depth, account.stopped), (horizon, Stopped::Complete));
        assert!(ring.expanded <= 11 * horizon, "equal states are expanded once: {}", ring.expanded);
    }
}

/// What is met behind an unsafe state, and the calmest that leads there: by plain enumeration.
fn enumerated_behind(horizon: usize) -> BTreeMap<(usize, i64, usize), (u32, Vec<u32>)> {
    let ring = Ring::new(horizon);
    let mut noted: BTreeMap<(usize, i64, usize), (u32, Vec<u32>)> = BTreeMap::new();
    for code in 0..MOVES.len().pow(u32::try_from(horizon).unwrap()) {
        let actions = (0..horizon).map(|i| code / MOVES.len().pow(u32::try_from(i).unwrap()) % 4);
        let (mut field, mut effort, mut prefix, mut is_unsafe) = (2_i64, 0, Vec::new(), false);
        for (depth, action) in actions.enumerate() {
            if is_unsafe && Ring::pinches(field, action) {
                let one = (effort, prefix.clone());
                let known = noted.entry((depth, field, action)).or_insert_with(|| one.clone());
                *known = one.min(known.clone());
            }
            match Ring::effect(depth, field, action) {
                Effect::NotEvaluated(_) => break,
                Effect::Unsafe { .. } => is_unsafe = true,
                Effect::To(_) => {}
            }
            field = (field + MOVES[action]).rem_euclid(11);
            effort += ring.effort(action);
            prefix.push(u32::try_from(action).unwrap());
        }
    }
    noted
}

/// Behind the first unsafe state it goes on: counts stay, and what comes there is noted with the calmest sequence.
#[test]
fn what_comes_behind_is_noted_as_in_plain_enumeration_and_counts_nothing() {
    for horizon in 1..=7 {
        let mut noted: BTreeMap<(usize, i64, usize), (u32, Vec<u32>)> = BTreeMap::new();
        let mut ring = Ring { goes_on: true, ..Ring::new(horizon) };
        let account = exhaust(&mut ring, BUDGET, &mut |told| {
            if let SearchEvent::Noted { unsafe_state, prefixes, with_end } = told {
                assert!(!with_end && prefixes.count == BigUint::ZERO);
                let one = (prefixes.effort, prefixes.calmest.clone());
                assert!(noted.insert(unsafe_state, one).is_none(), "told once");
            }
            ControlFlow::Continue(())
        });
        let account = account.unwrap();
        assert_eq!(noted, enumerated_behind(horizon), "horizon {horizon}");
        assert!(horizon < 4 || !noted.is_empty());
        let (plain, _) = exhausted(&mut Ring::new(horizon), BUDGET);
        let counts = |a: &Account| [a.hazardous.clone(), a.harmless.clone(), a.not_evaluated.clone()];
        assert_eq!(counts(&account), counts(&plain));
        assert_eq!((account.states(), plain.states_behind()), (plain.states(), 0));
        assert!(ring.expanded <= 11 * horizon, "a state is expanded once for all that lead there: {}", ring.expanded);
    }
}

/// What comes behind an unsafe state may take half of a budget, and costs the rest nothing.
#[test]
fn what_comes_behind_is_given_up_before_what_is_safe_until_then() {
    let run = |goes_on: bool, budget: Budget| {
        let mut ring = Ring { goes_on, works: true, ..Ring::new(8) };
        let account = exhaust(&mut ring, budget, &mut |_| ControlFlow::Continue(())).unwrap();
        (account, ring.expanded)
    };
    let ((plain, least), (whole, _)) = (run(false, BUDGET), run(true, BUDGET));
    assert!(whole.behind_cut.is_none() && whole.states_behind() > 0);
    // As much work as the search takes without.
    let (cut, _) = run(true, Budget { work: least as u64, ..BUDGET });
    assert_eq!((cut.stopped, &cut.hazardous), (Stopped::Complete, &plain.hazardous));
    assert!(cut.behind_cut.is_some_and(|actions| 0 < actions && actions < 8), "{cut:?}");
}

#[test]
fn dropping_by_a_sound_bound_changes_nothing_but_the_work() {
    // The last of 7 actions is at an even time and never unsafe; that of 8 is, from fields that are a move away before it.
    for horizon in [7, 8] {
        let mut dropping = Ring { drop_beyond: Some(0), ..Ring::new(horizon) };
        let (with, met) = exhausted(&mut dropping, BUDGET);
        let (without, all) = exhausted(&mut Ring::new(horizon), Budget { drop: false, ..BUDGET });
        assert_eq!(met, all, "{horizon}");
        assert_eq!(with.hazardous, without.hazardous);
        assert!(with.excluded > BigUint::ZERO);
        // The bound is about the last action alone.
        let (last, before) = with.levels.split_last().unwrap();
        assert!(last.dropped > 0 && before.iter().all(|level| level.dropped == 0), "{:?}", with.levels);
        // On the last level nothing is evaluated from states that were dropped, so those count as excluded.
        assert!(with.harmless.clone() + &with.excluded >= without.harmless);
    }
}

#[test]
fn a_budget_or_a_wish_ends_it_with_what_is_known() {
    let (account, _) = exhausted(&mut Ring::new(8), Budget { states: 12, ..BUDGET });
    assert_eq!(account.stopped, Stopped::Budget);
    assert!(account.depth < 8 && account.covered() < account.total);
    let account = exhaust(&mut Ring::new(8), BUDGET, &mut |told| match told {
        SearchEvent::Progress { depth: 3, .. } => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    });
    let account = account.unwrap();
    assert_eq!((account.stopped, account.depth), (Stopped::Asked, 3));
    // In the middle of a level as well: what it had begun is not counted.
    let mut asked = 0;
    let account = exhaust(&mut Ring::new(8), BUDGET, &mut |told| {
        asked += i32::from(matches!(told, SearchEvent::Working));
        if asked > 5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let account = account.unwrap();
    assert_eq!((account.stopped, account.depth), (Stopped::Asked, 5));
    assert!(account.covered() < account.total);
}

#[test]
fn what_failed_is_told_with_its_calmest_sequence() {
    let mut failed = Vec::new();
    let account = exhaust(&mut Ring::new(4), BUDGET, &mut |told| {
        if let SearchEvent::Failed { reason, action, prefixes } = told {
            failed.push((reason, prefixes.calmest.clone(), action));
        }
        ControlFlow::Continue(())
    });
    assert!(account.unwrap().not_evaluated > BigUint::ZERO && !failed.is_empty());
    for (reason, prefix, action) in failed {
        let field = prefix.iter().fold(2_i64, |field, &a| (field + MOVES[a as usize]).rem_euclid(11));
        assert_eq!((reason.as_str(), field, action), ("seven", 7, 2));
    }
}

#[test]
fn counts_do_not_overflow() {
    let account = exhaust(&mut Ring::new(40), BUDGET, &mut |_| ControlFlow::Continue(())).unwrap();
    assert_eq!(account.total, BigUint::from(4_u32).pow(40));
    assert_eq!(account.covered() + account.not_evaluated.clone(), account.total);
}
