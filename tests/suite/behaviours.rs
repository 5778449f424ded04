//! Behaviours of an FMU whose stop restarts by itself, or is latched: whatever is reported to it, it does what they say.

use std::ops::ControlFlow;

use crate::common::write;
use crate::restarts::{WATCHES, cell, folder};
use fmi_hazard::geometry::{Solid, Vec3};
use fmi_hazard::host::{Plant as _, Policy, Recall};
use fmi_hazard::reachability::held::HeldReadings;
use fmi_hazard::reachability::instants::{Instants, RobotGroup};
use fmi_hazard::reachability::internal_sensors::sensor_target;
use fmi_hazard::reachability::machine::Machine as ByHistories;
use fmi_hazard::reachability::of_behaviours::seen_by;
use fmi_hazard::reachability::reading_regions::ReadingRegions;
use fmi_hazard::reachability::reduced::Nearly;
use fmi_hazard::reachability::{History, ReachabilitySearch, ReachableInstant};
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::search::Rng;
use fmi_hazard::search::behaviours::stays::Stays;
use fmi_hazard::search::behaviours::walks::{Style, Walked, walk};
use fmi_hazard::search::behaviours::{BehaviourSearchEnd, Extent, any, find};
use fmi_hazard::search::tracks::explore;
use fmi_hazard::sim::robot::RobotFrame;
use fmi_hazard::standards::iso_13855::WALKING_SPEED_M_S;

/// Latched, the slide of a gantry has some thousand behaviours for all time; where it restarts, within some steps, one for each moment at
/// which it was stopped and freed, and more. Walks of each style show nothing else. What restarts is looked at as far as walks go.
#[test]
fn an_fmu_does_what_its_behaviours_say() {
    for (fmu, latched_by, steps, ended) in [
        ("gantry.fmu", "PLC", usize::MAX, BehaviourSearchEnd::Closed),
        ("gantry-fmi3.fmu", "nobody", 60, BehaviourSearchEnd::Steps),
        ("gantry.fmu", "host", usize::MAX, BehaviourSearchEnd::Closed),
    ] {
        let dir = folder(fmu);
        let prepared = prepare(&write(dir.path(), "cell.toml", &cell(WATCHES[0], latched_by)), None).unwrap();
        let readings = [vec![false], vec![true]];
        let people = vec![sensor_target(&prepared.cell, ([0.0, -1.1], 0.0)); 2];
        let parts = (&*prepared.cell, &*prepared.binding);
        let mut machine = HeldReadings::new(
            prepared.plant(StateChoice::Auto),
            parts,
            (readings.into_iter().map(|one| vec![one]).collect(), any(2)),
            people,
        );
        let extent = Extent { held: &[30; 2], steps, most: 50_000 };
        let found = find(&mut machine, extent, &mut |_| ControlFlow::Continue(())).unwrap();
        assert_eq!(found.ended, ended, "{fmu} {latched_by}: {} behaviours", found.count());
        assert!(found.count() > 500, "{}", found.count());
        let mut rng = Rng::new(3);
        for style in Style::ALL {
            let walked = walk(&mut machine, &found, &style.drawn(&mut rng, &any(2), 0, (30, 400))).unwrap();
            assert!(
                matches!(walked, Walked::Alike(alike) if alike >= steps.min(400)),
                "{latched_by} {style:?}: {walked:?}"
            );
        }
    }
}

/// What is seen of all histories of up to three changes within 0.8 s, each way with its robots, lies within what behaviours stand for.
#[test]
fn behaviours_stand_for_all_that_histories_lead_to() {
    let states = stand_for_all(40, 3);
    assert!(states > 10_000, "{states}");
}

/// The same of all histories there are, as far as memory goes.
#[test]
#[ignore = "two minutes, a GB: all changes; `behaviours_stand_for_all_that_histories_lead_to` follows three"]
fn behaviours_stand_for_histories_of_any_number_of_changes() {
    let states = stand_for_all(84, usize::MAX);
    assert!(states > 1_000_000, "{states}");
}

/// Looks at both: robots that stand for others are as large, as fast, and as long there. That they are made larger for it is not in vain: as
/// they are, they do not stand for all. The answer is how many states of the FMU histories have.
fn stand_for_all(steps: usize, changes: usize) -> usize {
    let dir = folder("gantry.fmu");
    let prepared = prepare(&write(dir.path(), "cell.toml", &cell(WATCHES[0], "nobody")), None).unwrap();
    let (cell, binding) = (&*prepared.cell, &*prepared.binding);
    let part = RobotGroup { sensors: vec![true], links: vec![true; cell.links.len()].into() };
    let plant = || prepared.plant(StateChoice::Auto);
    let robots = RobotFrame::new(cell, binding, &plant().restart().unwrap());
    let search = ReachabilitySearch::new(cell, std::iter::once(&robots), 0.5, prepared.stop()).unwrap();
    let step_m = WALKING_SPEED_M_S * cell.step_s;
    let zones =
        ReadingRegions::by_sides(&search, &[false], &part.sensors, step_m, &|all| (0..all.len()).collect()).unwrap();
    let people = || vec![sensor_target(cell, ([0.0, -1.1], 0.0)); zones.readings.len()];

    let mut recall = Recall::new(plant(), Policy::States { max_checkpoints: usize::MAX }).unwrap();
    recall.ends_at(steps);
    recall.merge_equal_states().unwrap();
    let mut exact = ByHistories::new(recall, (cell, binding), (&zones, people()), (&part, 0));
    explore(&mut exact, steps, changes, &mut |machine, taken| {
        machine.look(taken);
        true
    })
    .unwrap();
    let (states, exact) = (exact.recall().states(), exact.instants().histories());

    let mut machine = HeldReadings::new(
        plant(),
        (cell, binding),
        (zones.readings.iter().map(|one| vec![one.clone()]).collect(), zones.others()),
        people(),
    );
    let extent = Extent { held: &[30; 2], steps, most: 2_000_000 };
    let found = find(&mut machine, extent, &mut |_| ControlFlow::Continue(())).unwrap();
    assert_ne!(found.ended, BehaviourSearchEnd::Most);
    let stays = Stays::find(&found, &zones, u32::try_from(2 * steps).unwrap());
    let mut instants = Instants::new((cell, binding), &zones, &part);
    let outputs = |number| machine.outputs(found.shown(number));
    seen_by(&mut instants, &found, (&stays, &zones), (&outputs, true), &prepared.stop()).unwrap();
    let nearly = Nearly { apart_m: 0.01, faster_m_s: 0.03, farther_m: 0.05 };
    let few = instants.reduced(nearly, &prepared.stop()).unwrap();

    let within = |one: &ReachableInstant, all: &History| all.seen.iter().any(|stands| stands_for(stands, one));
    let (mut all, mut as_they_are) = (0, 0);
    for (way, history) in exact.iter().enumerate() {
        let (own, wide) = &few[way];
        assert_eq!(history.readings, own.readings);
        for one in &history.seen {
            assert!(within(one, wide), "{way} {}", one.step);
            as_they_are += usize::from(within(one, own));
            all += 1;
        }
    }
    let stand: usize = few.iter().map(|(own, _)| own.seen.len()).sum();
    assert!(all > 900 && stand < all && as_they_are < all, "{all} {stand} {as_they_are}");
    states
}

/// Whether links of robots at an instant are within those of others at another, no faster, and people have come no farther.
fn stands_for(stands: &ReachableInstant, one: &ReachableInstant) -> bool {
    let (wide, own) = (&stands.frame, &one.frame);
    let lies_within = |(link, solid): (usize, &Solid)| {
        let (Solid::Capsule(wide), Solid::Capsule(own)) = (&wide.links[link], solid) else { panic!("a capsule") };
        let far = |at: Vec3| {
            let along = wide.b - wide.a;
            let share = ((at - wide.a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            (at - wide.a - along * share).length()
        };
        [own.a, own.b].into_iter().all(|at| far(at) + own.radius <= wide.radius + 1e-9)
    };
    own.links.iter().enumerate().all(lies_within)
        && own.speed_bounds.iter().zip(&wide.speed_bounds).all(|(own, wide)| *own <= wide + 1e-9)
        && one.within_m.iter().zip(stands.within_m).all(|(own, wide)| *own <= wide + 1e-9)
        && one.depth_m <= stands.depth_m + 1e-9
}
