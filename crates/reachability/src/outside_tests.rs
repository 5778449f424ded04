//! Where people get to, by hand, and against a lattice of places that is gone through one by one.

use std::collections::BTreeSet;

use super::*;
use crate::cell::Workcell;
use crate::cell::error::Source;
use crate::cell::file::validate::validate;
use crate::human::walk::Walker;
use crate::human::{Place, Start};
use crate::search::Rng;
use crate::stop::Stop;

const START: &str = "start = { xy_m = [0, -3], heading_deg = 90 }\n";

/// A bar with these parts around it.
fn cell(parts: &str, human: &str) -> Workcell {
    let text = format!(
        "schema = 1\nname = \"t\"\nfmu = \"t.fmu\"\n[[robot]]\nname = \"r\"\nbase = {{ xyz_m = [0, 0, 0.5] }}\n\
         moving_mass_kg = 20\npayload_kg = 1\n[[robot.joint]]\nname = \"axis\"\naxis = [0, 0, 1]\n\
         angle = {{ variable = \"q\", unit = \"rad\" }}\nspeed = {{ variable = \"qd\", unit = \"rad/s\" }}\n\
         [[robot.link]]\nname = \"bar\"\njoint = \"axis\"\n\
         capsule = {{ from_m = [0, 0, 0], to_m = [0.3, 0, 0], radius_m = 0.05 }}\n{parts}\n[human]\n{human}"
    );
    validate(&Source::new("t.toml", &text)).unwrap()
}

fn search(cell: &Workcell) -> ReachabilitySearch<'_> {
    ReachabilitySearch::on_cells_of(0.025, cell, std::iter::empty(), 0.0, Stop::default()).unwrap()
}

/// A wall between two corners.
fn wall(name: &str, a: [f64; 2], b: [f64; 2]) -> String {
    let middle = [0, 1].map(|axis| 0.5 * (a[axis] + b[axis]));
    let size = [0, 1].map(|axis| (b[axis] - a[axis]).abs().max(0.02));
    let ([x, y], [w, d]) = (middle, size);
    format!("[[obstacle]]\nname = \"{name}\"\ncentre_m = [{x}, {y}, 1.1]\nsize_m = [{w}, {d}, 2.2]\n")
}

/// A fence of 1.4 m with such a gap in front.
fn fence(gap_m: f64) -> String {
    let (h, g) = (0.7, 0.5 * gap_m);
    [
        wall("back", [-h, h], [h, h]),
        wall("left", [-h, -h], [-h, h]),
        wall("right", [h, -h], [h, h]),
        wall("front left", [-h, -h], [-g, -h]),
        wall("front right", [g, -h], [h, -h]),
    ]
    .concat()
}

/// A mat over a rectangle, from low x and y to high, m, turned about the origin.
fn mat(name: &str, [x0, y0, x1, y1]: [f64; 4], turned_rad: f64) -> String {
    let (sin, cos) = libm::sincos(turned_rad);
    let corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(|[x, y]| [cos * x - sin * y, sin * x + cos * y]);
    format!(
        "[[sensor]]\nname = \"{name}\"\nkind = \"mat\"\nvariable = \"clear\"\nactive = false\nzone = {{ polygon_m = \
         {corners:?} }}\n"
    )
}

/// The body is 0.28 m wide. Through a gap of 0.27 m the floor that is rounded outwards still leads in.
#[test]
fn a_room_is_outside_if_its_gap_is_wider_than_a_person() {
    for (gap_m, is_open, is_outside) in [(0.0, false, false), (0.27, true, false), (0.295, true, true)] {
        let cell = cell(&fence(gap_m), START);
        let search = search(&cell);
        assert_eq!(search.floor().any_open([0.3, 0.3], 0.0), is_open, "{gap_m} m");
        assert_eq!(search.comes_to([0.3, 0.3], &[]), is_outside, "{gap_m} m");
        // Outside, beyond the floor that is looked at, against the wall by a hair, and in it.
        assert!(search.comes_to([0.0, -1.0], &[]) && search.comes_to([50.0, 0.0], &[]));
        assert!(search.comes_to([0.5, -0.8501], &[]) && !search.comes_to([0.5, -0.8499], &[]));
    }
    // Who starts in a closed room is in it, and outside of it people are anyway.
    let cell = cell(&fence(0.0), "start = { xy_m = [0.4, 0.4], heading_deg = 90 }\n");
    let search = search(&cell);
    assert!([[0.4, 0.4], [-0.3, 0.1], [0.0, -1.0]].into_iter().all(|at| search.comes_to(at, &[])));
}

/// Where the floor ends, people come from where they start; where a region says so, from there.
#[test]
fn people_come_from_where_the_cell_file_says() {
    let floor = "floor_m = [[-0.4, -1.6], [0.4, -1.6], [0.4, 0.5], [-0.4, 0.5]]\nstart = { xy_m = [0, -1.4], heading_deg = 90 }\n";
    for (gap_m, is) in [(0.27, false), (0.295, true)] {
        let cell = cell(&fence(gap_m), floor);
        let search = search(&cell);
        assert_eq!([[0.0, -1.0], [0.0, 0.2]].map(|at| search.comes_to(at, &[])), [true, is], "{gap_m} m");
        // No floor is there.
        assert!(!search.comes_to([0.45, -1.0], &[]) && !search.comes_to([0.0, -2.0], &[]));
    }
    let region = |low: f64| {
        format!("{START}start_region_m = [[-0.2, {low}], [0.2, {low}], [0.2, {}], [-0.2, {}]]\n", low + 0.4, low + 0.4)
    };
    let told = |gap_m: f64, low: f64, start: &str| {
        let cell = cell(&fence(gap_m), &region(low).replace(START, start));
        let search = search(&cell);
        [[0.0, 0.3], [0.0, -1.0], [50.0, 0.0]].map(|at| search.comes_to(at, &[]))
    };
    let inside = "start = { xy_m = [0.4, 0.4], heading_deg = 90 }\n";
    assert_eq!(told(0.295, -1.4, START), [true, true, true]);
    assert_eq!(told(0.27, -1.4, START), [false, true, true]);
    // From the room alone, which is shut; and through a gap that is wide enough.
    assert_eq!(told(0.27, -0.2, inside), [true, false, false]);
    assert_eq!(told(0.295, -0.2, inside), [true, true, true]);
}

/// Feet are 0.18 m apart. Who walks to and fro along a gap between mats, at 45 degrees to it, keeps them off those if it is wider than
/// 0.127 m; and if the gap is turned by 0.5 rad, at the 61 and 74 degrees that are headings of a scan then, if it is wider than 0.086 m.
/// Across a narrower one they would stand, and do not get there.
#[test]
fn a_gap_between_mats_is_outside_if_feet_get_through() {
    for turned in [0.0, 0.5] {
        for (gap_m, is) in [(0.05, false), (0.08, false), (0.15, true), (0.2, true)] {
            let g = 0.5 * gap_m;
            let mats = [mat("left", [-1.0, -1.0, -g, 1.0], turned), mat("right", [g, -1.0, 1.0, 1.0], turned)].concat();
            let cell = cell(&mats, START);
            let search = search(&cell);
            let on_the_way = [0.3 * -libm::sin(turned), 0.3 * libm::cos(turned)];
            let told = |matter: &[bool]| [[0.0, 0.0], on_the_way].map(|at| search.comes_to(at, matter));
            assert_eq!(told(&[true; 2]), [is; 2], "{gap_m} m, turned by {turned}");
            // Over the mat that does not matter.
            assert_eq!(told(&[true, false]), [true; 2]);
            let unseen = search.may_begin([0.0, 0.0], turned, &[Some(false); 2]);
            assert!(unseen, "{gap_m} m: rounded outwards somebody gets there unseen");
        }
    }
}

/// A plane in a wide gap, from the floor or above heads, and a door in it that nothing sees.
#[test]
fn planes_that_see_people_and_doors_that_are_closed_keep_them_out() {
    let curtain = |low: f64| {
        format!(
            "[[sensor]]\nname = \"curtain\"\nkind = \"light_curtain\"\nzone = {{ line_m = [[-0.5, -0.7], [0.5, -0.7]], heights_m = \
             [{low}, 2.2] }}\nvariable = \"clear\"\nactive = false\n"
        )
    };
    for (low, is) in [(0.0, false), (1.95, true)] {
        let cell = cell(&format!("{}{}", fence(1.0), curtain(low)), START);
        let search = search(&cell);
        assert_eq!([[true], [false]].map(|matter| search.comes_to([0.0, 0.0], &matter)), [is, true], "{low} m");
    }
    let door = "[[obstacle]]\nname = \"leaf\"\ncentre_m = [0, -0.7, 1.1]\nsize_m = [1.0, 0.02, 2.2]\nopened_by = \"door\"\n\
                [[control]]\nname = \"door\"\nkind = \"toggled\"\nvariable = \"closed\"\nreleased = true\npressed = false\n\
                at_m = [0.4, -0.78, 1.05]\nto_m = [0.4, -0.62, 1.05]\n";
    let cell = cell(&format!("{}{door}", fence(1.0)), START);
    let search = search(&cell);
    assert!(search.floor().any_open([0.0, 0.0], 0.0) && !search.comes_to([0.0, 0.0], &[]));
}

/// Random walls against a lattice of 5 mm, each place of which is looked at by the rules of a walk: people are where it leads, and wherever
/// it leads that leaves 10 mm more room.
#[test]
fn among_random_walls_people_get_where_a_lattice_of_places_leads() {
    const STEP_M: f64 = 0.005;
    const HALF: i32 = 130;
    let mut rng = Rng::new(23);
    let mut uniform = |low: f64, high: f64| {
        low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
    };
    let (mut inside, mut outside, mut unsure) = (0, 0, 0);
    for _ in 0..8 {
        // A room of four walls with a gap at a corner, about as wide as a person.
        let mut end = || uniform(0.14, 0.28) - 0.45;
        let walls = [
            wall("a", [-0.45, end()], [-0.45, 0.45]),
            wall("b", [0.45, -0.45], [0.45, 0.45]),
            wall("c", [end(), -0.45], [0.45, -0.45]),
            wall("d", [-0.45, 0.45], [0.45, 0.45]),
        ];
        let cell = cell(&walls.concat(), START);
        let search = search(&cell);
        let obstacles: Vec<Cuboid> = cell.obstacles.iter().map(|obstacle| obstacle.cuboid).collect();
        let place = |[x, y]: [i32; 2]| [x, y].map(|n| f64::from(n) * STEP_M);
        let lattice = |more_m: f64| {
            let wider: Vec<Cuboid> =
                obstacles.iter().map(|o| Cuboid { half: o.half + Vec3::new(more_m, more_m, 0.0), ..*o }).collect();
            let is_free = |at: [i32; 2]| {
                let [x, y] = place(at);
                let start = Start::new(x, y, 0.0);
                let (body, moving) = (&cell.body, &[][..]);
                let walker =
                    Walker { body, start: &start, sub_step_len_m: 0.032, obstacles: &wider, moving, strides: 1 };
                walker.is_free(Place::START, Posture::Upright)
            };
            let free: BTreeSet<[i32; 2]> =
                (-HALF..=HALF).flat_map(|x| (-HALF..=HALF).map(move |y| [x, y])).filter(|at| is_free(*at)).collect();
            let is_edge = |at: &&[i32; 2]| at.iter().any(|n| n.abs() == HALF);
            let mut next: Vec<[i32; 2]> = free.iter().filter(is_edge).copied().collect();
            let mut reached: BTreeSet<[i32; 2]> = next.iter().copied().collect();
            while let Some([x, y]) = next.pop() {
                for to in (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| [x, y])) {
                    if free.contains(&to) && reached.insert(to) {
                        next.push(to);
                    }
                }
            }
            reached
        };
        let (exactly, with_room) = (lattice(0.0), lattice(0.01));
        for at in (-HALF..=HALF).step_by(9).flat_map(|x| (-HALF..=HALF).step_by(9).map(move |y| [x, y])) {
            let is = search.comes_to(place(at), &[]);
            assert!(exactly.contains(&at) || !is, "{:?} among {walls:?}", place(at));
            assert!(is || !with_room.contains(&at), "{:?} among {walls:?}", place(at));
            let in_room = at.iter().all(|n| n.abs() < 80);
            inside += usize::from(in_room && is);
            outside += usize::from(in_room && !is);
            unsure += usize::from(!is && exactly.contains(&at));
        }
    }
    assert!(inside > 50 && outside > 50, "{inside} {outside} {unsure}");
}

/// A post 150 m away makes cells of the floor larger and not more of them; and where all is 150 m from the hall's origin, there is no floor
/// between. Nothing of the robot is held here, which a search adds.
#[test]
fn floors_have_no_more_cells_than_told_however_far_away_something_is() {
    let (near, far) = (wall("near", [2.0, 0.0], [2.1, 0.1]), wall("far", [150.0, 120.0], [150.1, 120.1]));
    let floor = |walls: &str| search(&cell(walls, START)).floor().clone();
    let (of_near, of_far, of_both) = (floor(&near), floor(&far), floor(&(near + &far)));
    for one in [&of_near, &of_far] {
        assert!((one.cell_m() - FLOOR_M).abs() < 1e-12 && one.cells() < 100_000, "{}", one.cells());
    }
    assert!(of_far.bounds().0[0] > 140.0 && of_near.holds([0.0, 0.0], 1.0));
    assert!((900_000..=1_010_000).contains(&of_both.cells()), "{}", of_both.cells());
    assert!(of_both.holds([0.0, 0.0], 1.0) && of_both.holds([150.0, 120.0], 0.5));
}
