//! The exhaustive search at light curtains against plain enumeration. There, states that are merged have to be equal as well in where the
//! robots would be had the curtain told of an arm.

use std::path::Path;

use crate::common::enumerated::{Enumeration, whole_scan_as_enumerated};
use crate::common::exhausted::{BUDGET, Few, exhausted, key};
use crate::common::{examples, write};
use crate::sample;
use fmi_hazard::human::{Action, Posture, Presses, Walk};
use fmi_hazard::scan::{Prepared, StateChoice, prepare::prepare};

/// An example with something else in it, started nearer, of so many actions.
fn cell(dir: &Path, (example, base): (&str, &str), more: &str, [x, y]: [f64; 2], actions: u32) -> Prepared {
    let start = format!("[human]\nstart = {{ xy_m = [{x}, {y}], heading_deg = 90 }}\n");
    let search = format!("[search]\nactions = {actions}\nreach_tolerance_m = 0.05\n");
    let text = format!("extends = \"{base}.toml\"\nname = \"near\"\n{more}{start}{search}");
    prepare(&write(&dir.join(example), &format!("near-{base}.toml"), &text), None).unwrap()
}

/// The example whose curtain has room below, three of the cell's own 48 actions from just before it: a whole scan against every sequence.
fn room_below_as_in_plain_enumeration(state: StateChoice) {
    let dir = examples();
    let of_one = |base: &str| {
        let prepared = cell(dir.path(), ("under-curtain", base), "", [0.1, -0.1], 3);
        assert_eq!(prepared.cell.repertoire.all().count(), 48);
        let (hazardous, report) = whole_scan_as_enumerated(&prepared, state, base);
        (hazardous, report.hazards.len())
    };
    let of_one = &of_one;
    let [flawed, fixed] = std::thread::scope(|scope| {
        ["cell", "fixed"].map(|base| scope.spawn(move || of_one(base))).map(|one| one.join().unwrap())
    });
    assert!(flawed.0 > 1000 && flawed.1 > 10, "{flawed:?}: little to compare");
    assert_eq!(fixed, (0, 0));
}

#[test]
fn a_curtain_with_room_below_as_in_plain_enumeration() {
    if !sample::is_turn(1, 4) {
        return;
    }
    room_below_as_in_plain_enumeration(StateChoice::Auto);
}

/// Every sequence from a fresh instance of the FMU.
#[test]
#[ignore = "half a minute: nothing is remembered; the same without `and_no_saved_state` does"]
fn a_curtain_with_room_below_as_in_plain_enumeration_and_no_saved_state() {
    room_below_as_in_plain_enumeration(StateChoice::Replay);
}

/// Anyone presses the reset at any time: a robot that stands then goes on, if the curtain is clear. While it still moves a press does
/// nothing, and the FMU is in the same state as without; but had the curtain told of an arm before, the robot might have stood already.
const RESET: &str = "[remove]\ninputs = [\"plc.reset\"]\n\
                     [[control]]\nname = \"reset\"\nvariable = \"plc.reset\"\nby = \"anyone\"\n\
                     [parameters]\n\"plc.t_react\" = 0.0\n\"ctrl.t_ramp\" = 0.35\n\"ctrl.phase0\" = 3.54\n";

fn actions(moves: &[(Walk, Posture)], controls: usize) -> Vec<Action> {
    let actions = moves.iter().map(|(walk, posture)| Action::new(*walk, *posture));
    Presses::all(controls).flat_map(|presses| actions.clone().map(move |action| action.pressing(presses))).collect()
}

/// Some of the actions, and more of them, with every finding to the last bit: below a curtain and back until nothing can happen any more,
/// and through one, with the robot as it would be had the curtain told of the arm.
#[test]
fn below_a_curtain_and_through_it_as_in_plain_enumeration() {
    if !sample::is_turn(10, 12) {
        return;
    }
    let dir = examples();
    let below = [
        (Walk::Forward, Posture::Crawling),
        (Walk::Stop, Posture::Forward),
        (Walk::Forward, Posture::Upright),
        (Walk::Left90, Posture::Upright),
    ];
    let through = [
        (Walk::Stop, Posture::Upright),
        (Walk::Stop, Posture::ForwardLeft),
        (Walk::Forward, Posture::Forward),
        (Walk::Left45, Posture::ForwardRight),
        (Walk::Right90, Posture::Left),
    ];
    let resetting = [(Walk::Forward, Posture::Upright), (Walk::Stop, Posture::Upright), (Walk::Stop, Posture::Forward)];
    let (below, through, resetting) = (actions(&below, 0), actions(&through, 0), actions(&resetting, 1));
    let cells = [
        (("under-curtain", "cell"), "", -0.1, &below, 8, true),
        (("under-curtain", "fixed"), "", -0.1, &below, 8, false),
        (("light-curtain", "cell"), "", -0.5, &through, 6, true),
        (("light-curtain", "fixed"), "", -0.5, &through, 6, false),
        (("light-curtain", "fixed"), RESET, -0.15, &resetting, 6, true),
    ];
    for (number, (of, more, y, few, horizon, hazards)) in cells.into_iter().enumerate() {
        // One of the repaired twins, in which nothing is found.
        if !hazards && !sample::takes(number / 2, 2) {
            continue;
        }
        let prepared = cell(dir.path(), of, more, [0.1, y], horizon);
        let mut expansion = Few::of(&prepared, few);
        let (account, found) = exhausted(&mut expansion, BUDGET);
        let plain = Enumeration::of(&prepared, StateChoice::Auto, few, &key);
        assert_eq!(found, plain.found, "{of:?}");
        let [hazardous, harmless, excluded] = [&account.hazardous, &account.harmless, &account.excluded]
            .map(|count| u128::try_from(count.clone()).unwrap());
        assert_eq!((hazardous, harmless + excluded), (plain.hazardous(), plain.harmless), "{of:?}");
        assert_eq!(hazardous + harmless + excluded, u128::try_from(few.len()).unwrap().pow(horizon), "{of:?}");
        assert_eq!(found.len() > 5, hazards, "{of:?}");
        assert!(expansion.0.recall().merges().merged > 0, "{of:?}: no state is merged");
        assert!(excluded > 0 || of.0 == "light-curtain", "{of:?}: nothing is excluded");
        let told = found.keys().any(|key| key.contains("Through {"));
        assert_eq!(told, hazards && of.0 == "light-curtain", "{of:?}");
    }
}
