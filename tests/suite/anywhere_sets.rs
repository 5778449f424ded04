//! Where the search from anywhere says that people may be, and robots: against ordinary scans from other places, random walks on fresh
//! FMUs, and the FMU in smaller steps.

use std::collections::BTreeSet;

use crate::common::anywhere::{cell, look, mat, two_bars};
use crate::common::guarded::{every_sequence, guarded};
use crate::common::write;
use crate::sample;
use fmi_hazard::geometry::{Capsule, Solid, Vec3};
use fmi_hazard::host::{Plant as _, Recall};
use fmi_hazard::human::{Presses, Start};
use fmi_hazard::reachability::instants::RobotGroup;
use fmi_hazard::reachability::machine::Machine;
use fmi_hazard::reachability::reading_regions::{ReadingRegions, ReadingTransition};
use fmi_hazard::reachability::{History, ReachabilitySearch as Search, ReachableInstant as AnInstant};
use fmi_hazard::record::model::Verdict;
use fmi_hazard::record::reachability::{HarmfulPose, ReachabilityResult};
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::search::Rng;
use fmi_hazard::search::tracks::{PossibleStep, explore};
use fmi_hazard::sim::robot::RobotFrame;
use fmi_hazard::sim::sensors::{SensorTarget, input_row, sees};
use tempfile::TempDir;

/// By legs alone: nobody bends.
#[test]
fn whatever_a_scan_of_somebody_upright_from_a_random_place_finds_is_found() {
    if !sample::is_turn(1, 6) {
        return;
    }
    whatever_is_found_is_found("bend_forward_deg = 0\nbend_lateral_deg = 0\n", 60, 1).is_the_same_with_one_thread();
}

#[test]
#[ignore = "half a minute: arms as well; `whatever_a_scan_of_somebody_upright_from_a_random_place_finds_is_found` is without them"]
fn whatever_a_scan_from_a_random_place_finds_is_found() {
    whatever_is_found_is_found("", 60, 3).is_the_same_with_one_thread();
}

#[test]
#[ignore = "minutes: a rod at every place; `from_anywhere_a_rod_reaches_what_hands_do_not` has one on a strip of floor"]
fn whatever_a_scan_of_somebody_with_a_rod_finds_is_found() {
    whatever_is_found_is_found("held_m = 0.3\n", 24, 1);
}

/// What was found of a cell file's text, in a folder with what that names.
struct Whole(TempDir, String, ReachabilityResult);

impl Whole {
    fn is_the_same_with_one_thread(&self) {
        let json = |found: &ReachabilityResult| serde_json::to_string(found).unwrap();
        assert_eq!(json(&look(self.0.path(), &self.1, 1.2, 1)), json(&self.2));
    }
}

fn whatever_is_found_is_found(held: &str, starts: usize, regions: usize) -> Whole {
    let dir = guarded();
    let text = cell(0.45, "").replace("[human]\n", &format!("[human]\n{held}"));
    let found = look(dir.path(), &text, 1.2, 2);
    assert_eq!(found.verdict, Verdict::HazardsFound, "{found:#?}");
    assert!(found.hazards.iter().all(|hazard| hazard.confirmed), "{found:#?}");
    let half_m = 0.5 * found.cell_m + 1e-9;
    let is_hazardous = |start: &Start| {
        let near = |at: [f64; 2]| (0..2).all(|axis| (at[axis] - start.xy_m()[axis]).abs() <= half_m);
        found.floor.iter().any(|cell| near(cell.xy_m)) || found.open_m.iter().any(|open| near(*open))
    };
    let prepared = prepare(&dir.path().join("cell.toml"), None).unwrap();
    let mut rng = Rng::new(11);
    let mut uniform = |low: f64, high: f64| {
        low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
    };
    let (mut met, mut harmless) = (BTreeSet::new(), 0);
    for _ in 0..starts {
        let start = Start::new(uniform(-1.9, 1.9), uniform(-1.9, 1.9), uniform(0.0, 360.0));
        let lead_in = [0, 10, 25, 50][(0..3).filter(|part| uniform(0.0, 4.0) > f64::from(*part) + 1.0).count()];
        let report = every_sequence(&prepared.standing(start, lead_in, 1).unwrap(), false);
        for hazard in report.hazards.iter().filter(|hazard| hazard.actions[0].to_string().starts_with("stop")) {
            // An arm that only just gets there is within the tolerance of the sets.
            if hazard.arm.is_some() && hazard.distance_m > -found.arm_tolerance_m && !held.is_empty() {
                continue;
            }
            assert!(is_hazardous(&start), "{start:?} {hazard:#?}");
            met.insert(hazard.body_region);
        }
        harmless += usize::from(!is_hazardous(&start));
    }
    assert!(met.len() >= regions && harmless > 3, "{met:?} {harmless}");
    Whole(dir, text, found)
}

/// Every hazard of complete searches from places outside of a mat lies where the sets say that there may be one: of somebody who
/// walks in, at several moments. The bar goes on for 0.3 s, so they get half a metre far: with sets for somebody who walks at half of
/// the speed, some are lost.
#[test]
#[ignore = "a minute: complete searches of who walks in; `whoever_walks_in_strides_is_where_fields_say` and the next test have walks of their own instead"]
fn whatever_complete_searches_find_of_who_walks_in_is_in_the_sets() {
    let dir = guarded();
    let mat = mat("mat", "clear", [-1.6, -1.6, 1.6, 1.6]);
    let late = format!("{}\"plc.t_react\" = 0.3\n", cell(0.9, &mat));
    let found = look(dir.path(), &late, 1.0, 2);
    // They start where nobody sees them.
    let seen = |hazard: &&HarmfulPose| hazard.confirmed && hazard.sensors[0].person_detected;
    let walks = found.hazards.iter().find(seen).expect("somebody who is seen is hit");
    let outside = walks.start_m.map(f64::abs);
    assert!(walks.walks_in && !walks.id.is_empty() && outside[0].max(outside[1]) > 1.6, "{walks:#?}");
    let half_m = 0.5 * found.cell_m + 1e-9;
    let near = |at: [f64; 2], to: [f64; 2]| (0..2).all(|axis| (at[axis] - to[axis]).abs() <= half_m);
    let prepared = prepare(&dir.path().join("cell.toml"), None).unwrap();
    let mut rng = Rng::new(23);
    let (mut told, mut deepest) = (0, 0.0_f64);
    for number in 0..12_u32 {
        let around = f64::from(number) * 0.53;
        let far = 1.75 / libm::cos(around).abs().max(libm::sin(around).abs());
        let turned = f64::from(u32::try_from(rng.below(90)).unwrap()) - 45.0;
        let start = Start::new(far * libm::cos(around), far * libm::sin(around), around.to_degrees() + 180.0 + turned);
        let lead_in = [0, 7, 16][number as usize % 3];
        let report = every_sequence(&prepared.standing(start, lead_in, 3).unwrap(), false);
        for hazard in &report.hazards {
            let at = hazard.person_xy_m;
            // An arm that only just gets there is within the tolerance of the sets.
            if hazard.arm.is_some() && hazard.distance_m > -found.arm_tolerance_m {
                continue;
            }
            let is_told =
                found.floor.iter().any(|cell| near(cell.xy_m, at)) || found.open_m.iter().any(|o| near(*o, at));
            assert!(is_told, "{at:?} from {start:?} after {lead_in}: {hazard:#?}");
            told += usize::from(hazard.sensors[0].person_detected);
            deepest = deepest.max(1.6 - at[0].abs().max(at[1].abs()));
        }
    }
    assert!(told > 5 && deepest > 0.4, "{told} {deepest}");
}

/// The bar every two milliseconds, before and after a mat stops it, against what communication steps of 20 ms make of it: no point of it
/// is outside of what it is taken to sweep around them, which is hardly larger than it has to be.
#[test]
fn wherever_the_bar_is_between_two_steps_it_is_within_what_it_sweeps() {
    if !sample::is_turn(3, 6) {
        return;
    }
    const FINE: usize = 10;
    let dir = guarded();
    let mat = mat("mat", "clear", [-1.6, -1.6, 1.6, 1.6]);
    let prepared_at = |step_s: f64| {
        let text = format!("{}[time]\nstep_s = {step_s}\n", cell(0.45, &mat));
        prepare(&write(dir.path(), "cell.toml", &text), None).unwrap()
    };
    let (prepared, fine, steps) = (prepared_at(0.02), prepared_at(0.002), 40);
    let (cell, binding) = (&*prepared.cell, &*prepared.binding);
    let search = Search::new(cell, std::iter::empty(), 0.0, prepared.stop()).unwrap();
    let part = RobotGroup { sensors: vec![true], links: vec![true].into() };
    let zones = ReadingRegions::new(&search, &[false], &part.sensors, (1.6 * cell.step_s, steps), 0).unwrap();
    let entered = zones.ways.iter().position(|way| way.from.is_some() && way.is_first).expect("a way onto the mat");
    let nobody =
        SensorTarget { feet: [Vec3::ZERO; 2], besides: None, body: None, position: Vec3::ZERO, heading_rad: 0.0 };
    let people = vec![nobody.clone(); zones.readings.len()];
    let recall = Recall::new(prepared.plant(StateChoice::Auto), prepared.policy(StateChoice::Auto)).unwrap();
    let mut machine = Machine::new(recall, (cell, binding), (&zones, people), (&part, 0));
    let look = &mut |machine: &mut Machine<'_, _>, taken: &PossibleStep<'_, _>| {
        machine.look(taken);
        true
    };
    explore(&mut machine, steps, 1, look).unwrap();
    let swept = machine.instants().histories_between();
    let core = |frame: &RobotFrame| match &frame.links[0] {
        Solid::Capsule(bar) => *bar,
        other => panic!("{other:?}"),
    };
    let mut tightest = 0.0_f64;
    for entered_at in [1, 3, 11, 26] {
        let mut inputs = Vec::new();
        for step in 0..steps * FINE {
            input_row(cell, &fine.binding, &[step >= entered_at * FINE], &nobody, Presses::NONE, &mut inputs);
        }
        let mut plant = fine.plant(StateChoice::Replay);
        plant.restart().unwrap();
        let outputs = plant.advance(steps * FINE, &inputs).unwrap();
        for (step, row) in (1..).zip(outputs.chunks(fine.binding.columns())) {
            let frame = RobotFrame::new(&fine.cell, &fine.binding, row);
            if !frame.may_harm {
                continue;
            }
            let bar = core(&frame);
            let history = &swept[if step > entered_at * FINE { entered } else { 0 }];
            // What it is nearest to, by the share of what that has grown.
            let share =
                |wide: Capsule| (bar.a - wide.a).length().max((bar.b - wide.b).length()) / (wide.radius - bar.radius);
            let least = history.seen.iter().map(|seen| share(core(&seen.frame))).fold(f64::INFINITY, f64::min);
            assert!(least <= 1.0 + 1e-6, "{step} {entered_at}: {least}");
            tightest = tightest.max(least);
        }
    }
    assert!(tightest > 0.95, "{tightest}");
}

/// Random walks with strides so long that no rounding to cells of the floor hides one: wherever somebody is a stride after a sample, the
/// fields say that they may be, and whatever is reported of them next may follow as soon.
#[test]
fn whoever_walks_in_strides_is_where_fields_say() {
    if !sample::is_turn(8, 12) {
        return;
    }
    const STRIDE_M: f64 = 0.3;
    let dir = guarded();
    let mats = [mat("square", "clear", [-0.8, -0.8, 0.8, 0.8]), mat("beside", "clear", [1.1, -1.5, 2.0, 1.5])].concat();
    let prepared = prepare(&write(dir.path(), "cell.toml", &cell(0.45, &mats)), None).unwrap();
    let search = Search::new(&prepared.cell, std::iter::empty(), 0.0, prepared.stop()).unwrap();
    let (none, steps) = (vec![false; 2], 12);
    let zones = ReadingRegions::new(&search, &none, &[true; 2], (STRIDE_M, steps), 0).unwrap();
    let mut rng = Rng::new(5);
    let mut uniform = |low: f64, high: f64| {
        low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
    };
    let reported = |[x, y]: [f64; 2], heading_rad: f64| -> Vec<bool> {
        let position = Vec3::new(x, y, 0.0);
        let feet = prepared.cell.body.feet(position, heading_rad);
        let seen = SensorTarget { feet, besides: None, body: None, position, heading_rad };
        prepared.cell.sensors.iter().map(|sensor| sees(sensor, &seen)).collect()
    };
    let (mut walked, mut changed) = (0, 0);
    // A quarter of the walks is the first of all.
    let part = if sample::is_whole() { 1 } else { 4 };
    for _ in 0..4000 / part {
        let (mut at, mut heading) = ([uniform(-1.2, 2.3), uniform(-1.6, 1.6)], uniform(0.0, 6.3));
        if reported(at, heading) != none {
            continue;
        }
        let (mut way, mut lasting, mut since_first) = (0, 0, 0);
        for _ in 0..steps {
            let towards = uniform(0.0, 6.3);
            let next = [at[0] + STRIDE_M * libm::cos(towards), at[1] + STRIDE_M * libm::sin(towards)];
            if !search.has_room(next) {
                continue;
            }
            walked += 1;
            #[expect(clippy::cast_precision_loss, reason = "a few strides")]
            let far = |steps: usize| steps as f64 * STRIDE_M + 1e-9;
            let [own, origin] = [&zones.ways[way].field, zones.origin()].map(|field| field.least(next, 0.0));
            let is_first = zones.ways[way].from.is_none();
            assert!(own <= far(if is_first { 0 } else { lasting + 1 }), "{at:?} {next:?} {:?} {own}", zones.ways[way]);
            assert!(origin <= far(since_first + 2), "{at:?} {next:?} {origin}");
            (at, heading) = (next, uniform(0.0, 6.3));
            let readings = reported(at, heading);
            if readings == zones.readings[zones.ways[way].to] {
                (lasting, since_first) = (lasting + 1, since_first + usize::from(!is_first));
                continue;
            }
            let may = |(other, least): &&(usize, usize)| {
                zones.readings[zones.ways[*other].to] == readings && *least <= lasting
            };
            let follows = zones.next(way).iter().find(may);
            let Some((other, _)) = follows else { panic!("{readings:?} after {:?} {lasting}", zones.ways[way]) };
            since_first = if is_first { 0 } else { since_first + 1 };
            (way, lasting, changed) = (*other, 0, changed + 1);
        }
    }
    assert!(part * walked > 18_000 && part * changed > 2400, "{walked} {changed}");
    assert!(!sample::is_whole() || (walked > 20_000 && changed > 3000), "{walked} {changed}");
}

/// Random walks over two mats, one of which tells 60 ms late, on a fresh FMU each: at every step the person is where the histories say that somebody may be while the
/// robots are as they are, those of both sensors together and of each robot by its own alone. With the sensors changed over it is not so.
#[test]
fn whoever_walks_over_two_mats_is_in_the_sets_of_both_and_of_each() {
    if !sample::is_turn(6, 12) {
        return;
    }
    const STEPS: usize = 24;
    let dir = guarded();
    let text = two_bars(["a", "b"]).replace("name = \"mat b\"\n", "name = \"mat b\"\ndelay_ms = 60\n");
    let prepared = prepare(&write(dir.path(), "cell.toml", &text), None).unwrap();
    assert_eq!(prepared.cell.sensors[1].delay_steps, 3);
    let cell = &*prepared.cell;
    let stride_m = 1.6 * cell.step_s;
    let search = Search::new(cell, std::iter::empty(), 0.0, prepared.stop()).unwrap();
    let nobody =
        SensorTarget { feet: [Vec3::ZERO; 2], besides: None, body: None, position: Vec3::ZERO, heading_rad: 0.0 };
    let histories = |sensors: [bool; 2], links: [bool; 2]| {
        let part = RobotGroup { sensors: sensors.to_vec(), links: links.to_vec().into() };
        let zones = ReadingRegions::new(&search, &[false; 2], &part.sensors, (stride_m, STEPS), 0).unwrap();
        let recall = Recall::new(prepared.plant(StateChoice::Auto), prepared.policy(StateChoice::Auto)).unwrap();
        let people = vec![nobody.clone(); zones.readings.len()];
        let mut machine = Machine::new(recall, (cell, &prepared.binding), (&zones, people), (&part, 0));
        explore(&mut machine, STEPS, 3, &mut |machine, taken| {
            machine.look(taken);
            true
        })
        .unwrap();
        machine.instants().histories()
    };
    let only = |number: usize| [0, 1].map(|n| n == number);
    let core = |frame: &RobotFrame, robot: usize| match &frame.links[robot] {
        Solid::Capsule(bar) => (bar.a, bar.b),
        other => panic!("{other:?}"),
    };
    // For each robot: by both sensors, by its own, and by the other.
    let all = histories([true; 2], [true; 2]);
    let own = [0, 1].map(|robot| histories(only(robot), only(robot)));
    let other = [0, 1].map(|robot| histories(only(1 - robot), only(robot)));
    let is_in = |of: &[History], (frame, robot): (&RobotFrame, usize), readings: &[bool], at: [f64; 2]| {
        let same = |history: &&History| {
            history.readings.iter().zip(readings).all(|(own, reading)| own.is_none_or(|own| own == *reading))
        };
        of.iter().filter(same).any(|history| {
            let is_near =
                |seen: &AnInstant| (0..2).all(|n| history.fields[n].least(at, 0.0) <= seen.within_m[n] + 1e-9);
            history.seen.iter().any(|seen| core(&seen.frame, robot) == core(frame, robot) && is_near(seen))
        })
    };
    let mut rng = Rng::new(7);
    let mut uniform = |low: f64, high: f64| {
        low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
    };
    let mut plant = prepared.plant(StateChoice::Replay);
    let (mut seen, mut lost) = (0, 0);
    let (walks, least) = if sample::is_whole() { (300, [1000, 100]) } else { (40, [60, 4]) };
    for _ in 0..walks {
        // Around the narrow way between the mats.
        let (mut at, mut heading, mut inputs, mut places) =
            ([uniform(-0.6, 0.6), uniform(-2.6, 2.6)], uniform(0.0, 6.3), Vec::new(), Vec::<(Vec<bool>, _)>::new());
        for _ in 0..STEPS {
            let position = Vec3::new(at[0], at[1], 0.0);
            let person = SensorTarget {
                feet: cell.body.feet(position, heading),
                besides: None,
                body: None,
                position,
                heading_rad: heading,
            };
            let readings: Vec<bool> = cell.sensors.iter().map(|sensor| sees(sensor, &person)).collect();
            let late = places.len().checked_sub(3).is_some_and(|then: usize| places[then].0[1]);
            input_row(cell, &prepared.binding, &[readings[0], late], &person, Presses::NONE, &mut inputs);
            if uniform(0.0, 1.0) < 0.2 {
                heading = uniform(0.0, 6.3);
            }
            at = [at[0] + stride_m * libm::cos(heading), at[1] + stride_m * libm::sin(heading)];
            places.push((readings, at));
        }
        let changes = places.windows(2).filter(|two| two[0].0 != two[1].0).count();
        if changes > 3 || places[0].0 != [false; 2] {
            continue;
        }
        plant.restart().unwrap();
        let outputs = plant.advance(STEPS, &inputs).unwrap();
        for (row, (readings, at)) in outputs.chunks(prepared.binding.columns()).zip(&places) {
            let frame = RobotFrame::new(cell, &prepared.binding, row);
            for robot in (0..2).filter(|robot| frame.may_harm_by(&only(*robot), 0.0)) {
                let of = |histories: &[History]| is_in(histories, (&frame, robot), readings, *at);
                assert!(of(&all) && of(&own[robot]), "{robot} {readings:?} {at:?}: {} {}", of(&all), of(&own[robot]));
                seen += usize::from(readings.contains(&true));
                lost += usize::from(!of(&other[robot]));
            }
        }
    }
    assert!(seen > least[0] && lost > least[1], "{seen} {lost}");
}

/// Smaller cells of the floor exclude more: whatever may be with small ones may be with larger ones.
#[test]
fn smaller_cells_of_the_floor_leave_less() {
    let dir = guarded();
    let post = "[[obstacle]]\nname = \"post\"\ncentre_m = [0.6, 0.2, 1.1]\nsize_m = [0.2, 0.2, 2.2]\n";
    let text = cell(0.45, &format!("{post}{}", mat("mat", "clear", [-0.53, -0.53, 0.53, 0.53])));
    let prepared = prepare(&write(dir.path(), "cell.toml", &text), None).unwrap();
    let cell = &prepared.cell;
    let (step_m, steps) = (1.6 * cell.step_s, 40);
    let at_sizes = [0.1, 0.05, 0.025].map(|floor_m| {
        let search = Search::on_cells_of(floor_m, cell, std::iter::empty(), 0.0, prepared.stop()).unwrap();
        let zones = ReadingRegions::new(&search, &[false], &[true], (step_m, steps), 0).unwrap();
        (search.ground().1, search.floor().clone(), zones)
    });
    let mut less = 0;
    for sizes in at_sizes.windows(2) {
        let [(large_unseen, large, large_zones), (unseen, floor, zones)] = sizes else { panic!("two sizes") };
        for (cell, &is_unseen) in unseen.iter().enumerate() {
            let at = floor.middle(cell);
            let of_large = |is: &dyn Fn(usize) -> bool| large.within(at, 0.0).any(is);
            assert!(!floor.is_open(cell) || of_large(&|cell| large.is_open(cell)), "{at:?}");
            assert!(!is_unseen || of_large(&|cell| large_unseen[cell]), "{at:?}");
            less += usize::from(!is_unseen && of_large(&|cell| large_unseen[cell]));
        }
        for way in &zones.ways {
            let same = |other: &&ReadingTransition| {
                large_zones.readings[other.to] == zones.readings[way.to] && other.is_first == way.is_first
            };
            let other = large_zones.ways.iter().find(same).expect("what small cells leave large ones do");
            for at in (0..floor.cells()).map(|cell| floor.middle(cell)) {
                let [own, large] = [way, other].map(|way| way.field.least(at, 0.0));
                assert!(large <= own + 1e-9, "{at:?}: {large} before {own}");
            }
        }
    }
    assert!(less > 100, "{less}");
}
