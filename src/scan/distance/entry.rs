//! Where people get onto a mat or into a field: the parts of its edge that a foot can come to from floor that is joined to where
//! people come from, past no sensor of the same input.

use crate::cell::Workcell;
use crate::geometry::polygon::{contains, distance_to_edge};
use crate::geometry::{Cuboid, Vec3};
use crate::human::{Arrangement, Floor};
use crate::stop::Stop;

/// Longest piece of an edge that is looked at as one, m.
const PIECE_M: f64 = 0.02;
/// Edge of the cells of the floor, m, in rooms up to so many cells long.
const CELL_M: f64 = 0.02;
const MOST_CELLS: f64 = 1500.0;
/// So much floor around everything is looked at, m.
const AROUND_M: f64 = 0.6;
/// Steps in which a mat is looked over, m.
const ACROSS_M: f64 = 0.01;

/// The entrances of a mat or field.
pub(super) struct Entrances {
    /// Pieces of its edge.
    pub pieces: Vec<[[f64; 2]; 2]>,
    /// How deep it is at such a piece, m, where somebody may be behind it who stepped over it.
    pub stepped_over_m: Option<f64>,
}

impl Entrances {
    /// Of a polygon among those that tell the same, which has to be so deep not to be stepped over, if that matters.
    pub(super) fn new(
        cell: &Workcell,
        together: &[&[[f64; 2]]],
        polygon: &[[f64; 2]],
        least_depth_m: Option<f64>,
        stop: &Stop,
    ) -> Option<Self> {
        let seen = |at: [f64; 2]| together.iter().any(|polygon| contains(polygon, at));
        let floor = outside(cell, together, &seen, stop)?;
        let foot_m = {
            let [left, right] = cell.body.feet(Vec3::ZERO, 0.0);
            0.5 * (left - right).length()
        };
        let comes_to = |at: [f64; 2]| floor.any_open(at, foot_m + 1e-9);
        let mut entrances = Self { pieces: Vec::new(), stepped_over_m: None };
        for (from, to) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
            let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
            let length = libm::hypot(dx, dy);
            if length <= 0.0 {
                continue;
            }
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousand pieces")]
            let count = (length / PIECE_M).ceil() as u32;
            let at = |n: u32| {
                let share = f64::from(n) / f64::from(count);
                [from[0] + share * dx, from[1] + share * dy]
            };
            let across = [-dy / length, dx / length];
            for piece in (0..count).map(|n| [at(n), at(n + 1)]) {
                let middle = [0.5 * (piece[0][0] + piece[1][0]), 0.5 * (piece[0][1] + piece[1][1])];
                // An edge between two fields is none.
                let beside =
                    [-1.0, 1.0].map(|side| [middle[0] + side * 1e-6 * across[0], middle[1] + side * 1e-6 * across[1]]);
                let [one, other] = beside.map(seen);
                if (one && other) || !comes_to(middle) {
                    continue;
                }
                entrances.pieces.push(piece);
                let side = if one { -1.0 } else { 1.0 };
                let inwards = across.map(|component| side * component);
                let depth_m = least_depth_m.and_then(|least_m| depth_m((middle, inwards), least_m, &seen, &floor));
                entrances.stepped_over_m = [entrances.stepped_over_m, depth_m].into_iter().flatten().reduce(f64::min);
            }
        }
        Some(entrances)
    }
}

/// How deep it is from a point of the edge inwards, m, if it is not as deep as it has to be and there is floor behind it.
fn depth_m(
    (edge, inwards): ([f64; 2], [f64; 2]),
    least_m: f64,
    seen: &dyn Fn([f64; 2]) -> bool,
    floor: &Floor,
) -> Option<f64> {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some hundred at most")]
    let steps = (least_m / ACROSS_M).floor() as u32;
    let at = |n: u32| {
        let far = f64::from(n) * ACROSS_M + 1e-6;
        [edge[0] + far * inwards[0], edge[1] + far * inwards[1]]
    };
    let behind = (0..steps).find(|n| !seen(at(*n)))?;
    floor.any_open(at(behind), 0.0).then(|| f64::from(behind) * ACROSS_M)
}

/// The floor that people come to before any of some polygons tells of them.
fn outside(cell: &Workcell, together: &[&[[f64; 2]]], seen: &dyn Fn([f64; 2]) -> bool, stop: &Stop) -> Option<Floor> {
    // Doors are taken to be open, and nothing to be there that follows the FMU.
    let obstacles: Vec<Cuboid> = cell.standing(cell.doors(), Arrangement::NONE);
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    let mut hold = |at: [f64; 2], far: f64| {
        for axis in 0..2 {
            low[axis] = low[axis].min(at[axis] - far);
            high[axis] = high[axis].max(at[axis] + far);
        }
    };
    let regions = cell.floor.iter().chain(&cell.start_region).map(Vec::as_slice);
    together.iter().copied().chain(regions).flatten().for_each(|corner| hold(*corner, AROUND_M));
    for cuboid in &obstacles {
        let reach = [Vec3::X, Vec3::Y].map(|axis| {
            let along = [Vec3::X * cuboid.half.x, Vec3::Y * cuboid.half.y, Vec3::Z * cuboid.half.z];
            along.iter().map(|half| (cuboid.rotation * *half).dot(axis).abs()).sum::<f64>()
        });
        for [sx, sy] in [[-1.0, -1.0], [1.0, 1.0]] {
            hold([cuboid.centre.x + sx * reach[0], cuboid.centre.y + sy * reach[1]], AROUND_M);
        }
    }
    let starts: Vec<[f64; 2]> =
        cell.beginnings.iter().map(|beginning| beginning.start.xy_m()).filter(|start| !seen(*start)).collect();
    starts.iter().for_each(|start| hold(*start, AROUND_M));
    let longest = (high[0] - low[0]).max(high[1] - low[1]);
    let cell_m = CELL_M.max(longest / MOST_CELLS);
    let floor = cell.bounded(Floor::new(&cell.body, &obstacles, (low, high), cell_m, stop)?, stop)?;
    // A cell may be cut by an edge: it is passed where its middle is outside, or no deeper inside than it is wide.
    let middles: Vec<[f64; 2]> = (0..floor.cells()).map(|cell| floor.middle(cell)).collect();
    let unseen = |at: [f64; 2]| {
        !seen(at)
            || together.iter().all(|polygon| !contains(polygon, at) || distance_to_edge(polygon, at) <= 0.5 * cell_m)
    };
    floor.joined_to_the_outside(&starts, |cell| unseen(middles[cell]), stop)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::error::Source;

    /// As deep as a mat has to be.
    const DEEP: Option<f64> = Some(crate::standards::iso_13855::MAT_DEPTH_M);

    /// A cell with a mat and fences, from its text.
    fn cell(mats: &str, more: &str) -> Workcell {
        let text = format!(
            "schema = 1\nname = \"t\"\nfmu = \"t.fmu\"\n[[robot]]\nname = \"r\"\nbase = {{ xyz_m = [0, 0, 0.9] }}\n\
             moving_mass_kg = 40\npayload_kg = 3\n[[robot.joint]]\nname = \"table\"\naxis = [0, 0, 1]\n\
             angle = {{ variable = \"q\", unit = \"rad\" }}\nspeed = {{ variable = \"qd\", unit = \"rad/s\" }}\n\
             [[robot.link]]\nname = \"bar\"\njoint = \"table\"\n\
             capsule = {{ from_m = [0, 0, 0], to_m = [0.8, 0, 0], radius_m = 0.05 }}\n{mats}\n\
             [human]\nstart = {{ xy_m = [0, -3], heading_deg = 90 }}\n{more}"
        );
        crate::cell::file::validate::validate(&Source::new("t.toml", &text)).unwrap()
    }

    const MAT: [[f64; 2]; 4] = [[-1.0, -1.8], [1.0, -1.8], [1.0, 2.0], [-1.0, 2.0]];

    /// The least and greatest x and y of the entrances.
    fn spans(entrances: &Entrances) -> [f64; 4] {
        let ends = entrances.pieces.iter().flatten();
        ends.fold([f64::MAX, f64::MIN, f64::MAX, f64::MIN], |[a, b, c, d], [x, y]| {
            [a.min(*x), b.max(*x), c.min(*y), d.max(*y)]
        })
    }

    #[test]
    fn fences_leave_the_open_side_of_a_mat() {
        let fence = |name: &str, centre: &str, size: &str| {
            format!("[[obstacle]]\nname = \"{name}\"\ncentre_m = {centre}\nsize_m = {size}\n")
        };
        let left = fence("left", "[-1, 0.1, 1]", "[0.02, 3.8, 2]");
        let right = fence("right", "[1, 0.1, 1]", "[0.02, 3.8, 2]");
        let back = fence("back", "[0, 2, 1]", "[2.02, 0.02, 2]");
        let all = Entrances::new(&cell("", ""), &[&MAT], &MAT, DEEP, &Stop::default()).unwrap();
        assert!(all.pieces.len() == 2 * (100 + 190) && all.stepped_over_m.is_none());
        let open =
            Entrances::new(&cell(&format!("{left}{right}{back}"), ""), &[&MAT], &MAT, DEEP, &Stop::default()).unwrap();
        let [from, to, low, high] = spans(&open);
        assert!(from > -1.01 && to < 1.01 && low < -1.79, "{:?}", spans(&open));
        // Around the ends of the fences a foot may come to the corners only.
        assert!(high < -1.6, "{high}");
        // Without the back, from there as well; with floor in front only, not.
        let open = Entrances::new(&cell(&format!("{left}{right}"), ""), &[&MAT], &MAT, DEEP, &Stop::default()).unwrap();
        assert!(spans(&open)[3] > 1.99);
        let floor = "floor_m = [[-3, -4], [3, -4], [3, -1.5], [-3, -1.5]]";
        let open =
            Entrances::new(&cell(&format!("{left}{right}"), floor), &[&MAT], &MAT, DEEP, &Stop::default()).unwrap();
        assert!(spans(&open)[3] < -1.5 + 0.2, "{:?}", spans(&open));
        // All around closed.
        let front = fence("front", "[0, -1.8, 1]", "[2.02, 0.02, 2]");
        let none =
            Entrances::new(&cell(&format!("{left}{right}{back}{front}"), ""), &[&MAT], &MAT, DEEP, &Stop::default())
                .unwrap();
        assert!(none.pieces.is_empty());
    }

    #[test]
    fn two_mats_side_by_side_are_one_and_a_narrow_one_is_stepped_over() {
        let (front, behind) = (
            [[-1.0, -1.8], [1.0, -1.8], [1.0, -1.3], [-1.0, -1.3]],
            [[-1.0, -1.3], [1.0, -1.3], [1.0, -0.7], [-1.0, -0.7]],
        );
        let of =
            |together: &[&[[f64; 2]]]| Entrances::new(&cell("", ""), together, &front, DEEP, &Stop::default()).unwrap();
        let alone = of(&[&front]);
        // From in front, from both sides and from behind: 0.5 m.
        assert!((alone.stepped_over_m.unwrap() - 0.5).abs() < 0.011, "{:?}", alone.stepped_over_m);
        let both = of(&[&front, &behind]);
        assert!(both.stepped_over_m.is_none(), "{:?}", both.stepped_over_m);
        // Its edge towards the other is none.
        assert_eq!(both.pieces.len() + 100, alone.pieces.len());
    }
}
