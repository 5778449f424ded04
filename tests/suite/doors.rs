//! Doors that have a leaf: closed it is in the way of walks and arms, open it is not. The example whose flaw is what the controller
//! makes of an open door.

use std::sync::Arc;

use fmi_hazard::human::{Action, Place, Posture, Presses, Walk};
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::{Prepared, prepare};
use fmi_hazard::search::Rng;
use fmi_hazard::sim::World;

use crate::common::pair::Pair;
use crate::common::{examples, fmi_hazard, scan_json, write};
use crate::sample;

/// The first control of the example, and the second.
const DOOR: Presses = Presses::one(0);
const RESET: Presses = Presses::one(1);

/// The repaired example with something else in it.
fn prepared(dir: &std::path::Path, more: &str) -> Prepared {
    let text = format!("extends = \"fixed.toml\"\nname = \"variant\"\n{more}");
    prepare(&write(&dir.join("door-edge"), "variant.toml", &text), None).unwrap()
}

/// A robot that stops at once can be started again at once: six actions are enough.
const AT_ONCE: &str = "[search]\nactions = 6\n[parameters]\n\"ctrl.t_ramp\" = 0.05\n\"plc.t_react\" = 0.0\n";

fn world(prepared: &Prepared) -> World {
    World::new(Arc::clone(&prepared.cell), Arc::clone(&prepared.binding))
}

fn go(presses: Presses) -> Action {
    Action::new(Walk::Forward, Posture::Upright).pressing(presses)
}

/// By hand: the leaf's face is at y = -1.62 and the body 0.14 m thick before it, so nobody gets farther than -1.76 while it is closed.
/// From -2.04, that is eight steps of 0.032 m.
#[test]
fn a_leaf_is_in_the_way_while_it_is_closed() {
    let dir = examples();
    let prepared = prepared(dir.path(), "[human]\nstart = { xy_m = [0.2, -2.04], heading_deg = 90 }\n");
    let world = world(&prepared);
    let y = |place: &Place| world.first.position(place).y;
    let walk = |mut place: Place, actions: &[Action]| {
        for action in actions {
            place = world.first.walk(place, *action).end();
        }
        place
    };
    let stopped = walk(world.first.start(), &[go(Presses::NONE); 3]);
    assert!((y(&stopped) + 1.784).abs() < 1e-9 && stopped.open().is_none(), "{}", y(&stopped));
    // Opened, it stays open, and is no more in the way of bends than of walks.
    let inside = walk(stopped, &[go(DOOR), go(Presses::NONE)]);
    assert!((y(&inside) + 1.784 - 0.64).abs() < 1e-9 && inside.open() == DOOR, "{}", y(&inside));
    let bends = |open| {
        let walked = world.first.walk(stopped.with_open(open), Action::new(Walk::Stop, Posture::Forward));
        let sensed = world.sense(
            &world.delays_at_start(),
            open,
            &world.first.sights(&walked, Posture::Forward),
            &world.first.worked(&walked, go(Presses::NONE)),
        );
        let body = world.first.body_of(&world.first.stance(&walked, (0, 9), Posture::Forward, &sensed));
        body.parts()[0].1.a.y
    };
    assert!(bends(DOOR) > bends(Presses::NONE) + 0.1, "{} {}", bends(DOOR), bends(Presses::NONE));
    // Closed behind the person, it keeps them in; who is out of reach of the handle leaves it as it is.
    let back = [Action::new(Walk::Left90, Posture::Upright), Action::new(Walk::Left90, Posture::Upright)];
    let out = [go(Presses::NONE); 6];
    let near = walk(inside, &back[..1]);
    let shut = walk(near, &[Action::new(Walk::Stop, Posture::Upright).pressing(DOOR)]);
    assert!(shut.open().is_none(), "{:?}", world.first.position(&near));
    assert!(y(&walk(walk(shut, &back[1..]), &out)) > -1.6 + 0.14);
    assert!(y(&walk(walk(near, &back[1..]), &out)) < -1.6 - 0.14);
    let far = walk(inside, &[go(Presses::NONE), go(Presses::NONE), go(DOOR)]);
    assert_eq!(far.open(), DOOR);
    // It does not close on who stands in the doorway, and the FMU is not told that it did.
    let doorway = walk(stopped, &[go(DOOR)]);
    assert!(y(&doorway) > -1.6 - 0.14 && y(&doorway) < -1.6 + 0.14, "{}", y(&doorway));
    let stands = Action::new(Walk::Stop, Posture::Upright).pressing(DOOR);
    let walked = world.first.walk(doorway, stands);
    assert!(world.first.worked(&walked, stands).presses.is_none() && walked.end().open() == DOOR);
    // Nor on who bends through it from before; upright there it does.
    let before = world.first.start().with_open(DOOR);
    for (posture, closes) in [(Posture::Upright, true), (Posture::Forward, false), (Posture::ForwardLeft, false)] {
        let works = Action::new(Walk::Stop, posture).pressing(DOOR);
        assert_eq!(world.first.walk(before, works).end().open().is_none(), closes, "{posture:?}");
    }
}

/// Nobody presses a button on the other side of a door that closes or opens in the same action; before or after, they do.
#[test]
fn no_hand_is_where_a_door_moves() {
    let dir = examples();
    // A button in the way of the leaf's edge, outside, and one inside.
    let button = |y: f64| {
        format!(
            "[remove]\ncontrol = [\"reset\"]\n[[control]]\nname = \"reset\"\nvariable = \"plc.reset\"\nat_m = [0.2, {y}, 1.1]\n\
             [human]\nstart = {{ xy_m = [0.2, -2.04], heading_deg = 90 }}\n"
        )
    };
    let stands = |presses| Action::new(Walk::Stop, Posture::Upright).pressing(presses);
    let both = DOOR.and(RESET);
    for (y, outside) in [(-1.7, true), (-1.4, false)] {
        let prepared = prepared(dir.path(), &button(y));
        let world = world(&prepared);
        let before = world.first.walk(world.first.start(), go(Presses::NONE)).end();
        let inside = [go(DOOR), go(Presses::NONE)].iter().fold(before, |at, a| world.first.walk(at, *a).end());
        let back = Action::new(Walk::Right90, Posture::Upright);
        let inside = world.first.walk(inside, back).end().with_open(Presses::NONE);
        for (at, same_side) in [(before, outside), (inside, !outside)] {
            let worked = |open, presses| {
                let walked = world.first.walk(at.with_open(open), stands(presses));
                world.first.worked(&walked, stands(presses)).presses
            };
            let told = format!("y {y}, from {:?}", world.first.position(&at));
            // What is on this side is always in reach, what is on the other side through an open door.
            assert_eq!(worked(Presses::NONE, RESET) == RESET, same_side, "{told}");
            assert_eq!(worked(DOOR, RESET), RESET, "{told}");
            for open in [Presses::NONE, DOOR] {
                assert_eq!(worked(open, both), if same_side { both } else { DOOR }, "{told}, {open:?}");
            }
        }
    }
}

/// The door is opened when the FMU says so before the action, closed always, and the reset does not care: action by action against
/// what the same hands do without a lock, of which presses are left out by what the outputs said. A door that is locked while the robot
/// moves keeps everybody out.
#[test]
fn a_locked_door_is_not_opened() {
    if !sample::is_turn(2, 4) {
        return;
    }
    let dir = examples();
    let locked = |while_: &str, begins: &str| -> Prepared {
        let handle = "to_m = [0.4, -1.52, 1.05]\n";
        let text = std::fs::read_to_string(dir.path().join("door-edge/cell.toml")).unwrap();
        assert_eq!(text.matches(handle).count(), 1);
        let text = text.replace(handle, &format!("{handle}{while_}\n"));
        let text =
            text.replace("[human]\n", &format!("[human]\nbegins_s = {begins}\n")).replace("actions = 7", "actions = 5");
        prepare(&write(dir.path(), "door-edge/locked.toml", &text), None).unwrap()
    };
    let (free, leg) = (locked("", "[0.0]"), "works_while = { variable = \"ctrl.leg\", is = 1 }");
    let (world, mut rng) = (world(&free), Rng::new(3));
    let (mut kept_out, mut opened, mut closed) = (0, 0, 0);
    for begins in ["[0.0]", "[0.5]", "[1.0]"] {
        let cell = locked(leg, begins);
        let mut simulation = cell.simulation(StateChoice::Auto, false).unwrap();
        let (width, steps) = (cell.binding.outputs.len(), cell.cell.steps_per_action);
        let legs = cell.binding.outputs.iter().position(|output| output.port.name == "ctrl.leg").unwrap();
        for _ in 0..60 {
            let presses = |n: usize| [Presses::NONE, DOOR, RESET, DOOR.and(RESET)][n];
            let mut action = |number: usize| {
                let walk = [Walk::Forward, Walk::Stop, Walk::Left90, Walk::Right90][rng.below(4)];
                // What the FMU says before the first action is not among its outputs here.
                let pressed = if number == 0 { Presses::NONE } else { presses(rng.below(4)) };
                Action::new(walk, Posture::Upright).pressing(pressed)
            };
            let actions: Vec<Action> = (0..5).map(&mut action).collect();
            let watched = simulation.watch(&actions, &[]).unwrap();
            let mut place = world.first.start();
            for (number, action) in actions.iter().enumerate() {
                let said =
                    number.checked_sub(1).map(|before| watched.outputs[(before + 1) * steps * width - width + legs]);
                let is_open = place.open() == DOOR;
                let is_locked = !is_open && action.presses().has(0) && said.is_some_and(|leg| leg != 1.0);
                let left = if is_locked { action.presses().common(RESET) } else { action.presses() };
                let walked = world.first.walk(place, action.pressing(left));
                let worked = world.first.worked(&walked, action.pressing(left)).presses;
                assert_eq!(watched.worked[number], worked, "{begins} {number} {actions:?}");
                kept_out += usize::from(is_locked && world.first.worked(&walked, *action).presses.has(0));
                opened += usize::from(!is_open && worked.has(0));
                closed += usize::from(is_open && worked.has(0) && said != Some(1.0));
                place = walked.end();
            }
        }
    }
    assert!(kept_out > 5 && opened > 5 && closed > 0, "{kept_out} {opened} {closed}");
    // The flawed cell of the pair below, which has hazards without the lock.
    let standing = "works_while = { variable = \"plc.stop_state\", is = 3 }";
    let cell = std::fs::read_to_string(dir.path().join("door-edge/cell.toml")).unwrap();
    let cell = cell.replace("to_m = [0.4, -1.52, 1.05]\n", &format!("to_m = [0.4, -1.52, 1.05]\n{standing}\n"));
    write(dir.path(), "door-edge/locked.toml", &format!("{}\n{AT_ONCE}", cell.replace("[search]\nactions = 7\n", "")));
    let mut scan = fmi_hazard(dir.path());
    scan.args(["scan", "door-edge/locked.toml", "--strategy", "exhaustive", "--no-advice", "--out", "locked"]);
    scan.assert().code(0);
    assert_eq!(scan_json(&dir.path().join("locked"))["certificate"]["complete"], true);
}

/// The same with the robot near the door, the reset beside the handle and the person before both: three actions are enough. Of all
/// that could be changed only what the controller makes of an open door may be.
const NEAR: &str = "[[robot]]\nname = \"CRX-10iA/L\"\nbase = { xyz_m = [0, 0.1, 0.505], rpy_deg = [0, 0, -90] }\n\
                    [parameters]\n\"ctrl.t_ramp\" = 0.05\n\"plc.t_react\" = 0.0\n\
                    [human]\nstart = { xy_m = [0.2, -1.95], heading_deg = 90 }\n\
                    [remove]\ncontrol = [\"reset\"]\n\
                    [[control]]\nname = \"reset\"\nvariable = \"plc.reset\"\nat_m = [0.0, -2.0, 1.1]\n\
                    [search]\nactions = 3\nreach_tolerance_m = 0.05\n\
                    [explain]\nrobot = { \"CRX-10iA/L\" = { fixed = true } }\n\
                    obstacle = { \"fence left\" = { fixed = true }, \"fence right\" = { fixed = true }, \
                    \"fence back\" = { fixed = true }, \"fence front left\" = { fixed = true }, \
                    \"fence front right\" = { fixed = true }, \"door leaf\" = { fixed = true } }\n\
                    [explain.parameters]\n\"plc.t_react\" = { fixed = true }\n\"ctrl.t_ramp\" = { fixed = true }\n\
                    \"ctrl.speed_scale\" = { fixed = true }\n\"ctrl.phase0\" = { fixed = true }\n";

#[test]
fn a_door_that_stops_on_an_edge_only_is_found_told_and_mended() {
    if !sample::is_turn(3, 6) {
        return;
    }
    found_told_and_mended(NEAR);
}

#[test]
#[ignore = "a minute: six actions, and all changes tried; the same without `from_farther_away` has three and one"]
fn a_door_that_stops_on_an_edge_only_is_found_told_and_mended_from_farther_away() {
    found_told_and_mended(AT_ONCE);
}

fn found_told_and_mended(changes: &str) {
    let dir = examples();
    let pair = Pair::scanned(dir.path(), "door-edge", changes, 144);
    for sentence in pair.causes() {
        assert!(
            sentence.starts_with("The person opens door at ") && sentence.contains("the person presses reset at"),
            "{sentence}"
        );
    }
    for hazard in pair.hazards() {
        assert!(hazard["worked"][0]["opens"] == true, "{hazard}");
    }
    let page = std::fs::read_to_string(dir.path().join("flawed/report.html")).unwrap();
    assert!(page.contains("\"opened_by\":\"door\""));
    // What helps is a parameter of the FMU.
    let told = pair.worst_explained(dir.path());
    assert!(told.contains("plc.hold_while_open = true") && told.contains("the person opens door"), "{told}");
}

#[test]
fn mistakes_about_doors_are_told() {
    let dir = examples();
    for (changed, to, problem) in [
        ("opened_by = \"door\"", "opened_by = \"gate\"", "is opened by `gate`, which is no control"),
        ("opened_by = \"door\"", "opened_by = \"reset\"", "which does not stay as it was put"),
        (
            "[human]",
            "[[sensor]]\nname = \"curtain\"\nkind = \"light_curtain\"\nvariable = \"plc.door_closed\"\nactive = false\n\
             zone = { line_m = [[-1, 0], [1, 0]], heights_m = [0, 2] }\n[human]",
            "obstacle `door leaf` opens, in a cell with a light curtain",
        ),
    ] {
        let text = std::fs::read_to_string(dir.path().join("door-edge/cell.toml")).unwrap();
        assert!(text.contains(changed));
        let file = write(&dir.path().join("door-edge"), "wrong.toml", &text.replace(changed, to));
        let error = prepare(&file, None).err().unwrap().to_string();
        assert!(error.contains(problem), "{error}");
    }
    // From anywhere they are taken to be open, which is told: of the floor in front of the door.
    let floor = "extends = \"fixed.toml\"\nname = \"small\"\n[human]\nstart = { xy_m = [0.2, -2.0], heading_deg = 90 }\n\
                 floor_m = [[-0.2, -2.2], [0.5, -2.2], [0.5, -1.2], [-0.2, -1.2]]\n";
    write(dir.path(), "door-edge/small.toml", floor);
    let mut scan = fmi_hazard(dir.path());
    let ran = scan
        .args([
            "scan",
            if sample::is_whole() { "door-edge/fixed.toml" } else { "door-edge/small.toml" },
            "--from",
            "anywhere",
            "--until",
            "1s",
            "--presses",
            "0",
            "--no-advice",
            "--out",
            "any",
        ])
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&ran.stdout);
    assert!(told.contains("all doors are taken to be open"), "{told}");
    assert_ne!(scan_json(&dir.path().join("any"))["verdict"], "none_found");
}
