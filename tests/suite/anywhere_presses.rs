//! Controls in the search from anywhere: whoever walks and presses is where it says that somebody may be, and the examples whose flaw
//! is a reset.

use std::path::Path;

use fmi_hazard::geometry::Vec3;
use fmi_hazard::host::Recall;
use fmi_hazard::human::{Action, ControlledBy, Posture, Presses, Start, Walk};
use fmi_hazard::reachability::instants::RobotGroup;
use fmi_hazard::reachability::machine::Machine;
use fmi_hazard::reachability::reading_regions::ReadingRegions;
use fmi_hazard::reachability::{History, ReachabilitySearch as Search};
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::{Prepared, prepare};
use fmi_hazard::search::Rng;
use fmi_hazard::search::tracks::explore;
use fmi_hazard::sim::robot::RobotFrame;
use fmi_hazard::sim::sensors::SensorTarget;
use serde_json::Value;

use crate::common::{examples, fmi_hazard};
use crate::sample;

/// Communication steps: over the mat, a press, and what the robot then begins to do.
const STEPS: usize = 50;

/// Edge of a cell of the floor, m: the search's own where all is looked at, else a larger one, with which more is taken to be possible.
fn floor_m(larger_m: f64) -> f64 {
    if sample::is_whole() { 0.025 } else { larger_m }
}

/// What the robot does along all histories, with so many presses.
fn histories(prepared: &Prepared, presses: u32) -> Vec<History> {
    let cell = &*prepared.cell;
    let search = Search::on_cells_of(floor_m(0.05), cell, std::iter::empty(), 0.0, prepared.stop()).unwrap();
    let part = RobotGroup { sensors: vec![true], links: vec![true; cell.links.len()].into() };
    let zones = ReadingRegions::new(&search, &[false], &part.sensors, (1.6 * cell.step_s, STEPS), presses).unwrap();
    let nobody =
        SensorTarget { feet: [Vec3::ZERO; 2], besides: None, body: None, position: Vec3::ZERO, heading_rad: 0.0 };
    let people = vec![nobody; zones.readings.len()];
    let recall = Recall::new(prepared.plant(StateChoice::Auto), prepared.policy(StateChoice::Auto)).unwrap();
    let mut machine = Machine::new(recall, (cell, &prepared.binding), (&zones, people), (&part, presses));
    explore(&mut machine, STEPS, 2, &mut |machine, taken| {
        machine.look(taken);
        true
    })
    .unwrap();
    machine.instants().histories()
}

/// Whether somebody may be there while the robot is so and a sensor reports that.
fn is_in(of: &[History], frame: &RobotFrame, readings: &[bool], at: Vec3) -> bool {
    let places = |frame: &RobotFrame| frame.links.iter().map(|link| link.bounding_sphere()).collect::<Vec<_>>();
    let wanted = places(frame);
    of.iter().filter(|history| history.readings == [Some(readings[0])]).any(|history| {
        let near: [f64; 2] = [0, 1].map(|n| history.fields[n].least([at.x, at.y], 0.0));
        let is_near = |within_m: [f64; 2]| (0..2).all(|n| near[n] <= within_m[n] + 1e-9);
        history.seen.iter().any(|seen| is_near(seen.within_m) && places(&seen.frame) == wanted)
    })
}

/// Random walks over the mat, each on a fresh FMU, with one press at random by whoever may: at every step the person is where some
/// history says that they may be while the robot is as it is. Without presses that is not so: the robot starts again.
#[test]
fn whoever_walks_and_presses_is_in_the_sets() {
    if !sample::is_turn(3, 12) {
        return;
    }
    let dir = examples();
    for (example, by) in
        sample::some([("reset-inside", ControlledBy::Person), ("reset-outside", ControlledBy::Anyone)], 2)
    {
        let prepared = prepare(&dir.path().join(example).join("cell.toml"), None).unwrap();
        assert_eq!(prepared.cell.controls[0].by, by);
        let [without, with] = [0, 1].map(|presses| histories(&prepared, presses));
        let mut rng = Rng::new(31);
        let mut uniform = |low: f64, high: f64| {
            low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
        };
        let (mut looked_at, mut restarted) = (0, 0);
        for _ in 0..120 {
            let start = Start::new(uniform(-0.9, 0.6), uniform(-1.95, -1.88), uniform(70.0, 110.0));
            let Ok(there) = prepared.standing(start, 0, 5) else { continue };
            let pressed = 3 + usize::from(uniform(0.0, 1.0) > 0.7);
            let actions: Vec<Action> = (0..5)
                .map(|number| {
                    let turns = [Walk::Forward, Walk::Left45, Walk::Right45, Walk::Stop];
                    let turn = if number < 3 { 0.0 } else { uniform(0.0, 3.99) };
                    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "one of four")]
                    let walk = turns[turn as usize];
                    let action = Action::new(walk, if number < 3 { Posture::Upright } else { Posture::Left });
                    action.pressing(if number == pressed { Presses::one(0) } else { Presses::NONE })
                })
                .collect();
            let mut simulation = there.simulation(StateChoice::Auto, false).unwrap();
            let instants = simulation.watch(&actions, &[]).unwrap().instants;
            // More often than looked at nobody is to come and go.
            if instants.windows(2).filter(|pair| pair[0].readings != pair[1].readings).count() > 2 {
                continue;
            }
            // What is reported there is what the step before it began with.
            for instant in instants[1..].iter().filter(|instant| instant.frame.may_harm) {
                let (readings, frame, at) = (&instant.readings, &instant.frame, instant.position);
                assert!(is_in(&with, frame, readings, at), "{example}: {at:?} after {start:?} {actions:?}");
                looked_at += 1;
                restarted += usize::from(!is_in(&without, frame, readings, at));
            }
        }
        assert!(looked_at > 1000 && restarted > 30, "{example}: {looked_at} {restarted}");
    }
}

/// From where a hand gets to the button one is soon in front of the robot in the flawed cell; in the repaired one not without the mat
/// between.
#[test]
fn whoever_has_pressed_is_near_the_button() {
    let dir = examples();
    for (file, is_inside) in [("cell.toml", true), ("fixed.toml", false)] {
        let prepared = prepare(&dir.path().join("reset-inside").join(file), None).unwrap();
        let cell = &*prepared.cell;
        let search = Search::on_cells_of(floor_m(0.1), cell, std::iter::empty(), 0.0, prepared.stop()).unwrap();
        let stride_m = 1.6 * cell.step_s;
        let zones = ReadingRegions::new(&search, &[false], &[true], (stride_m, 100), 1).unwrap();
        let pressed: Vec<_> = zones.ways.iter().filter(|way| way.pressed == Presses::one(0)).collect();
        assert!(pressed.len() > 2, "{file}: {} ways", pressed.len());
        let unseen = pressed.iter().filter(|way| !zones.readings[way.to][0]);
        let nearest = unseen.map(|way| way.field.least([0.0, 0.5], 0.0)).fold(f64::INFINITY, f64::min);
        assert_eq!(nearest < 1.5, is_inside, "{file}: {nearest}");
        assert!(search.may_work(Presses::one(0), cell.start.xy_m()) || is_inside);
        assert!(!search.may_work(Presses::one(0), [0.9, 1.9]));
        // Whoever leaves a part of the floor may be at once in all that is a step from it, whichever way they came there.
        for (number, way) in zones.ways.iter().enumerate().filter(|(_, way)| !way.unchanged) {
            let on = zones.next(number).iter().map(|(next, _)| &zones.ways[*next]);
            for next in on.filter(|next| next.pressed.is_none()) {
                assert_eq!(next.left, Some(way.area), "{file}: from {} to {}", way.area, next.area);
            }
        }
        let ways_back =
            zones.ways.iter().filter(|way| zones.readings[way.to][0] && way.pressed.is_none() && !way.is_first);
        let [front, inside] = [[0.0, -1.75], [0.0, -1.05]]
            .map(|at| ways_back.clone().map(|way| way.field.least(at, 0.0)).filter(|least| *least <= stride_m).count());
        assert!(front > 0 && inside > 0, "{file}: {front} {inside}");
        // Nobody works it whom the cell file does not let.
        let none = ReadingRegions::new(&search, &[false], &[true], (stride_m, 100), 0).unwrap();
        assert!(none.ways.iter().all(|way| way.pressed.is_none()) && none.ways.len() < zones.ways.len());
    }
}

/// On a strip of floor nobody is hit in a second in a repaired one, pressing or not.
#[test]
fn a_reset_that_does_nothing_while_somebody_is_inside_is_enough_on_a_strip_of_floor() {
    if !sample::is_turn(0, 12) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let strip = "extends = \"fixed.toml\"\nname = \"strip\"\n[human]\nfloor_m = [[-0.8, -2.0], [-0.3, -2.0], [-0.3, 0.2], [-0.8, 0.2]]\n";
    std::fs::write(dir.join("reset-outside/strip.toml"), strip).unwrap();
    is_enough(dir, "reset-outside/strip.toml");
}

/// Nobody is hit in a second, and nothing is left open but how often the control is worked, which somebody has to accept.
fn is_enough(dir: &Path, file: &str) {
    let options = ["--from", "anywhere", "--until", "1s", "--no-advice", "--out", "out"];
    let output = fmi_hazard(dir).args(["scan", file]).args(options).output().unwrap();
    assert_eq!(output.status.code(), Some(4), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(dir.join("out/anywhere.json")).unwrap();
    let fixed: Value = serde_json::from_str(&text).unwrap();
    assert!(fixed["presses"] == 1 && fixed["verdict"] == "inconclusive" && fixed["open"] == 0, "{fixed}");
    assert!(fixed["hazards"].as_array().unwrap().is_empty(), "{fixed}");
    let all = fixed["obligations"].as_array().unwrap().iter();
    let open: Vec<&Value> = all.filter(|one| one["standing"] == "open").collect();
    assert!(open.len() == 1 && open[0]["need"] == "presses", "{open:?}");
    assert!(open[0]["accept"].as_str().unwrap().contains("what = \"presses\""), "{open:?}");
}

/// The flawed example with a strip of mat that is 0.3 m deep, so that a second is enough, and whatever else: what is found of it.
fn thin(dir: &Path, more: &str) -> Value {
    let thin = "extends = \"cell.toml\"\nname = \"thin\"\n[remove]\nsensor = [\"mat\"]\n[[sensor]]\nname = \"mat\"\nkind = \"mat\"\n\
                variable = \"plc.mat_clear\"\nactive = false\nzone = { polygon_m = [[-1, -1.3], [1, -1.3], [1, -1], [-1, -1]] }\n";
    std::fs::write(dir.join("reset-inside/thin.toml"), format!("{thin}{more}")).unwrap();
    let options = ["--from", "anywhere", "--until", "1s", "--max-states", "60000", "--no-advice", "--out", "out"];
    let output = fmi_hazard(dir).args(["scan", "reset-inside/thin.toml"]).args(options).output().unwrap();
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    let read = |file: &str| -> Value {
        serde_json::from_str(&std::fs::read_to_string(dir.join("out").join(file)).unwrap()).unwrap()
    };
    let (found, scan) = (read("anywhere.json"), read("scan.json"));
    assert!(found["presses"] == 1 && scan["settings"]["presses"] == 1, "{found}");
    for hazard in scan["hazards"].as_array().unwrap() {
        assert!(hazard["confirmed"] == true && hazard["worked"][0]["name"] == "reset", "{hazard}");
    }
    assert!(found["hazards"].as_array().unwrap().len() > 3 && found["open"] == 0, "{found}");
    found
}

/// On a part of the floor: who comes in and presses is hit, and no floor is left open.
#[test]
fn a_reset_with_somebody_inside_is_found_on_a_part_of_the_floor() {
    if !sample::is_turn(2, 12) {
        return;
    }
    let part = "[human]\nstart = { xy_m = [-0.6, -1.55], heading_deg = 90 }\n\
                floor_m = [[-0.8, -1.65], [0.1, -1.65], [0.1, 0.4], [-0.8, 0.4]]\n";
    let found = thin(examples().path(), part);
    let confirmed = found["hazards"].as_array().unwrap().iter().filter(|hazard| hazard["confirmed"] == true).count();
    assert!(confirmed > 3, "{found}");
}

/// On all of it every way is shown by a run, and nothing is left open.
#[test]
#[ignore = "a minute: all the floor; `a_reset_with_somebody_inside_is_found_on_a_part_of_the_floor` is a part of it"]
fn a_reset_with_somebody_inside_is_found_from_anywhere() {
    let found = thin(examples().path(), "");
    assert!(found["hazards"].as_array().unwrap().iter().all(|hazard| hazard["confirmed"] == true), "{found}");
    // Whoever comes and goes more often, and presses more often, is another question.
    let all = found["obligations"].as_array().unwrap().iter();
    let open: Vec<&str> = all.filter(|one| one["standing"] == "open").filter_map(|one| one["need"].as_str()).collect();
    assert!(open.iter().all(|need| ["changes", "presses"].contains(need)), "{open:?}");
}

#[test]
#[ignore = "a minute: all the floor; `a_reset_that_does_nothing_while_somebody_is_inside_is_enough_on_a_strip_of_floor` is a strip of it"]
fn a_reset_that_does_nothing_while_somebody_is_inside_is_enough_on_all_the_floor() {
    is_enough(examples().path(), "reset-outside/fixed.toml");
}
