//! Drives that hardly ever come back to just the same: what a net of their behaviours stands for, and what it does not.

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::ops::ControlFlow;

use super::*;
use crate::behaviours::covers::{Covers, Gap, LATEST, gap};
use crate::behaviours::walks::Style;
use crate::behaviours::{AllHeld, any};
use crate::rng::Rng;

const STEP_S: f64 = 0.02;
/// The drive swings by 0.4 m in this time, and stops in another: neither is a multiple of a step.
const PERIOD_S: f64 = 2.6173;
const RAMP_S: f64 = 0.3713;
const REACTION: usize = 3;

/// How the pace goes to what is asked for, and what else is remembered.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// In a straight line.
    Ramp,
    /// As a filter does it, ever slower.
    Filter,
    /// In a straight line; from the 20th demand on none is heard.
    Deaf,
}

struct Drive {
    kind: Kind,
    rows: Vec<[f64; 2]>,
    numbers: BTreeMap<[i64; 2], OutputClass>,
}

#[derive(Clone)]
struct State {
    phase: f64,
    pace: f64,
    demanded: usize,
    demands: usize,
}

/// Widths: 10 mm and 0.05 m/s.
const WIDTH: [f64; 2] = [0.01, 0.05];

impl Drive {
    fn new(kind: Kind) -> Self {
        Self { kind, rows: Vec::new(), numbers: BTreeMap::new() }
    }

    fn after(&self, state: &State, reading: usize) -> State {
        let is_new = reading == 1 && state.demanded == 0;
        let demands = state.demands + usize::from(is_new);
        let demanded = if reading == 1 { state.demanded + 1 } else { 0 };
        let hears = self.kind != Kind::Deaf || demands < 20;
        let wanted = if demanded > REACTION && hears { 0.0 } else { 1.0 };
        let by = STEP_S / RAMP_S;
        let pace = match self.kind {
            Kind::Filter => state.pace + (wanted - state.pace) * by,
            Kind::Ramp | Kind::Deaf => state.pace + (wanted - state.pace).clamp(-by, by),
        };
        let phase = (state.phase + 0.5 * (state.pace + pace) * STEP_S / PERIOD_S).fract();
        State { phase, pace, demanded, demands }
    }

    fn row(state: &State) -> Vec<f64> {
        let angle = std::f64::consts::TAU * state.phase;
        vec![0.4 * libm::sin(angle), 0.4 * libm::cos(angle) * std::f64::consts::TAU / PERIOD_S * state.pace]
    }
}

impl Machine for Drive {
    type State = State;
    type Error = Infallible;

    fn readings(&self) -> usize {
        2
    }

    fn alike(&self, one: OutputClass, other: OutputClass) -> bool {
        one == other
    }

    fn switches(&self, _: OutputClass, _: [OutputClass; 3]) -> bool {
        false
    }

    fn begin(&mut self) -> Result<(State, OutputClass), Infallible> {
        Ok((State { phase: 0.0, pace: 1.0, demanded: 0, demands: 0 }, 0))
    }

    fn hold_each(&mut self, _: &[Hold<'_, State>]) -> Result<AllHeld<State>, Infallible> {
        Ok(None)
    }
}

impl Measured for Drive {
    fn begin_rows(&mut self) -> Result<(State, Vec<f64>), Infallible> {
        let (state, _) = self.begin()?;
        Ok((state.clone(), Self::row(&state)))
    }

    fn rows_each(&mut self, holds: &[Hold<'_, State>]) -> Result<Option<AllRows<State>>, Infallible> {
        let mut all: AllRows<State> = Vec::new();
        for Hold { from, reading, steps, last } in holds {
            let mut state = match from {
                Begins::At(state) => (*state).clone(),
                Begins::After(number) => all[*number].1.clone(),
            };
            let mut rows = Vec::new();
            for _ in 0..*steps {
                state = self.after(&state, *reading);
                rows.extend(Self::row(&state));
            }
            rows.drain(..if *last { rows.len() - 2 } else { 0 });
            all.push((rows, state));
        }
        Ok(Some(all))
    }

    fn columns(&self) -> usize {
        2
    }

    #[expect(clippy::cast_possible_truncation, reason = "a few widths")]
    fn traits(&self, row: &[f64]) -> Vec<f32> {
        vec![(row[0] / WIDTH[0]) as f32, (row[1] / WIDTH[1]) as f32]
    }

    fn place(&self, traits: &[f32]) -> [f32; 3] {
        [traits[0], traits[1], 0.0]
    }

    #[expect(clippy::cast_possible_truncation, reason = "a few thousand")]
    fn number(&mut self, row: &[f64], traits: &[f32]) -> OutputClass {
        let next = self.rows.len() as OutputClass;
        let number = *self.numbers.entry([0, 1].map(|n| (4.0 * traits[n]).round() as i64)).or_insert(next);
        if number == next {
            self.rows.push([row[0], row[1]]);
        }
        number
    }

    #[expect(clippy::cast_possible_truncation, reason = "a few thousand")]
    fn nearest(&self, traits: &[f32], widths: f32, counts: &dyn Fn(OutputClass) -> bool) -> Option<(OutputClass, f32)> {
        let all = (0..self.rows.len() as OutputClass).filter(|shown| counts(*shown));
        let far =
            all.filter_map(|shown| Some((shown, apart(traits, &self.traits(&self.rows[shown as usize]), widths)?)));
        far.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    fn off(&self, row: &[f64], shown: OutputClass) -> Option<(f64, [f64; 2])> {
        let stands = self.rows[shown as usize];
        let by = [(row[0] - stands[0]).abs(), (row[1] - stands[1]).abs()];
        Some((stands[1].abs(), by))
    }
}

const EXTENT: Extent<'static> = Extent { held: &[40; 2], steps: usize::MAX, most: 200_000 };

fn found(drive: &mut Drive) -> Behaviours {
    let found = find(drive, EXTENT, &mut |_| ControlFlow::Continue(())).unwrap();
    assert_eq!(found.ended, BehaviourSearchEnd::Closed, "{:?}: {} instants", drive.kind, found.count());
    found
}

/// By walks of each style: the worst of place, speed and time, or nothing where something has nothing that stands for it.
fn worst(drive: &mut Drive, covers: &Covers) -> Option<([f64; 2], usize)> {
    let (mut rng, mut worst) = (Rng::new(5), ([0.0_f64; 2], 0));
    for style in Style::ALL {
        let Gap::Within(all) = gap(drive, covers, &style.drawn(&mut rng, &any(2), 0, (40, 600))).unwrap() else {
            return None;
        };
        for off in all {
            (0..2).for_each(|n| worst.0[n] = worst.0[n].max(off.by[n]));
            worst.1 = worst.1.max(off.late);
        }
    }
    Some(worst)
}

/// Whatever a drive does lies within two widths of what stands for it, also where it comes to rest ever slower. Without any stays that are
/// a little shorter, it is farther.
#[test]
fn a_net_holds_what_never_comes_back_to_just_the_same() {
    for kind in [Kind::Ramp, Kind::Filter] {
        let mut drive = Drive::new(kind);
        let net = found(&mut drive);
        let covers = Covers::new(&net, 50);
        let (by, late) = worst(&mut drive, &covers).unwrap_or_else(|| panic!("{kind:?}"));
        assert!(by[0] <= 2.0 * WIDTH[0] && by[1] <= 3.0 * WIDTH[1] && late <= LATEST, "{kind:?}: {by:?} {late}");
        assert!(by[0] > 0.0 && by[1] > 0.0, "{kind:?}: nothing is just the same");
    }
}

/// What is heard no more after many demands is not what a net says.
#[test]
fn a_net_does_not_hold_what_counts() {
    let mut drive = Drive::new(Kind::Deaf);
    let net = found(&mut drive);
    let covers = Covers::new(&net, 50);
    assert_eq!(worst(&mut drive, &covers), None);
}

/// Every history of eight changes at any of some moments, run on its own and compared with every instant of the net, one by one: one of the
/// same reading that has lasted as long, but for the steps allowed, is no farther away than twice the worst of the walks.
#[test]
fn every_history_lies_within_twice_what_walks_show() {
    let mut drive = Drive::new(Kind::Ramp);
    let net = found(&mut drive);
    let covers = Covers::new(&net, 50);
    let (by, late) = worst(&mut drive, &covers).unwrap();
    let mut rng = Rng::new(9);
    let (mut checked, mut beyond) = (0, 0);
    for _ in 0..60 {
        let mut state = drive.begin().unwrap().0;
        for change in 0..8 {
            let reading = change % 2;
            for lasted in 0..1 + rng.below(30) {
                state = drive.after(&state, reading);
                let row = Drive::row(&state);
                let near = |allowed: f64| {
                    covers.longest.iter().any(|((its, shown), longest)| {
                        let stands = drive.rows[*shown as usize];
                        *its == reading
                            && *longest as usize + 2 * late >= lasted
                            && (stands[0] - row[0]).abs() <= allowed * by[0]
                            && (stands[1] - row[1]).abs() <= allowed * by[1]
                    })
                };
                assert!(near(2.0), "{lasted} {row:?}");
                beyond += usize::from(!near(0.0));
                checked += 1;
            }
        }
    }
    assert!(checked > 3_000 && beyond > checked / 2, "{beyond} of {checked}");
}
