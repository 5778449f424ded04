//! Sensors, and the table of arms and planes: which run, and how deep.
//!
//! The front of a plane is the side of the start. Samples are kept from the FMU's own start on, with a bit for each sensor.

use super::body::{Body, Place};
use super::cell::{Cell, Sensor, Zone};
use super::geometry::{Solid, V3};
use super::robot::History;

/// Of the hand, m/s.
const HAND_SPEED: f64 = 2.0;
const LONG_AGO: usize = 64;
/// Shoulder joint to finger tips.
const ARM: f64 = 0.85;
/// A plane as a wall is so thick.
const THICK: f64 = 0.01;

/// What is known at the start of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Sample {
    /// Sensors that see the body.
    pub seen: u8,
    /// Sensors of which the FMU is told: those, but of what it evaluates itself what it does not know; and of arms.
    pub told: u8,
    /// Bits of where the person is, for an FMU that is told.
    pub at: [u64; 2],
}

/// What all sensors see of this body.
pub fn seen(cell: &Cell, body: &Body) -> u8 {
    let sees = |sensor: &Sensor| match &sensor.zone {
        Zone::Floor(polygon) => body.feet.iter().any(|foot| inside(polygon, *foot)),
        Zone::Plane(_) => in_plane(sensor, body),
    };
    cell.sensors.iter().enumerate().map(|(i, s)| u8::from(sees(s)) << i).sum()
}

/// What is known of this body there; `upright` is that of the same person who does not bend.
pub fn samples(cell: &Cell, body: &Body, upright: &Body, at: [f64; 2]) -> Sample {
    let (seen, if_upright) = (seen(cell, body), seen(cell, upright));
    let evaluated: u8 = cell.sensors.iter().enumerate().map(|(i, sensor)| u8::from(sensor.evaluated) << i).sum();
    let at = if cell.pose.is_empty() { [0; 2] } else { at.map(f64::to_bits) };
    Sample { seen, told: seen & !(evaluated & if_upright), at }
}

fn inside(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let mut inside = false;
    for (i, [x0, y0]) in polygon.iter().enumerate() {
        let [x1, y1] = polygon[(i + 1) % polygon.len()];
        if (*y0 > y) != (y1 > y) && x < x0 + (y - y0) / (y1 - y0) * (x1 - x0) {
            inside = !inside;
        }
    }
    inside
}

/// Whether head, trunk or legs pass through the plane.
pub fn in_plane(sensor: &Sensor, body: &Body) -> bool {
    let Zone::Plane([low, high]) = sensor.zone else { return false };
    body.parts.iter().any(|part| Solid::Box { low, high }.gap(part.core) <= part.radius)
}

/// What the FMU gets at each step: samples when the response time is over. Before the first, the person stood at the start.
pub fn inputs(cell: &Cell, raw: &[Sample]) -> History {
    let told = |t: usize, i: usize| raw[t.saturating_sub(cell.sensors[i].delay)].told & (1 << i);
    (0..raw.len()).map(|t| ((0..cell.sensors.len()).map(|i| told(t, i)).sum(), raw[t].at)).collect()
}

/// The planes of a cell: number of the sensor, axis and place along it, and 1 where behind is towards more.
fn planes(cell: &Cell) -> Vec<(usize, usize, f64, f64)> {
    let mut all = Vec::new();
    for (i, sensor) in cell.sensors.iter().enumerate() {
        if let Zone::Plane([low, high]) = sensor.zone {
            let axis = usize::from(low[1] == high[1]);
            all.push((i, axis, low[axis], if Place::START.xy(cell)[axis] < low[axis] { 1.0 } else { -1.0 }));
        }
    }
    all
}

/// Samples since the body was first seen by a sensor, that one included; 0 for never, 64 for long ago.
pub fn seen_for(raw: &[Sample], sensor: usize) -> usize {
    raw.iter().position(|r| r.seen & (1 << sensor) != 0).map_or(0, |first| (raw.len() - first).min(LONG_AGO))
}

/// Whether a contact of head, trunk or legs is too deep behind a plane that the body is in.
pub fn too_deep(cell: &Cell, body: &Body, raw: &[Sample], point: V3) -> bool {
    planes(cell).into_iter().any(|(i, axis, at, behind)| {
        let k = seen_for(raw, i);
        k < LONG_AGO && in_plane(&cell.sensors[i], body) && behind * (point[axis] - at) > depth(cell, k + 1)
    })
}

fn depth(cell: &Cell, samples: usize) -> f64 {
    HAND_SPEED * cell.step * f64::from(u32::try_from(samples).expect("few"))
}

/// How an arm may be with respect to all planes: the run, and the walls that stand for planes and depths.
#[derive(Debug, Clone)]
pub struct Way {
    /// Samples with what the arm has broken.
    pub raw: Vec<Sample>,
    pub walls: Vec<Solid>,
    /// Depths that the walls stand for; what is less deep in all of them at the same robot need not be asked.
    pub kind: Vec<(u8, f64)>,
    /// Where the page leaves something open: samples from before the person begins, and arms back through a plane, of which
    /// nothing here asks that they do cross it.
    pub unsure: bool,
}

struct Row {
    kind: u8,
    depth: f64,
    broken: std::ops::Range<usize>,
    plate: bool,
    in_front: bool,
    unsure: bool,
}

/// All combinations of rows for an arm with this shoulder.
pub fn ways(cell: &Cell, body: &Body, raw: &[Sample], shoulder: V3) -> Vec<Way> {
    let mut all = vec![Way { raw: raw.to_vec(), walls: Vec::new(), kind: Vec::new(), unsure: false }];
    for (i, axis, at, behind) in planes(cell) {
        let mut rows = rows(cell, body, raw, i, behind * (shoulder[axis] - at));
        // No link is ever less deep than that.
        let sweep = cell.sweep();
        let least = sweep.iter().flat_map(|(core, radius)| core.map(|p| behind * (p[axis] - at) - radius));
        let least = least.fold(f64::MAX, f64::min);
        rows.retain(|row| row.in_front || row.depth >= least);
        let mut next = Vec::new();
        for way in &all {
            for row in &rows {
                let mut way = way.clone();
                way.raw[row.broken.clone()].iter_mut().for_each(|r| r.told |= 1 << i);
                way.unsure |= row.unsure;
                way.kind.push((row.kind, row.depth));
                if row.depth < f64::MAX {
                    let mut normal = [0.0; 3];
                    normal[axis] = if row.in_front { -behind } else { behind };
                    way.walls.push(Solid::Half { normal, from: normal[axis] * at + row.depth });
                }
                if let (true, Zone::Plane([mut low, mut high])) = (row.plate, cell.sensors[i].zone.clone()) {
                    low[axis] -= 0.5 * THICK;
                    high[axis] += 0.5 * THICK;
                    way.walls.push(Solid::Box { low, high });
                }
                next.push(way);
            }
        }
        all = next;
    }
    all
}

/// The rows of one plane. `behind` is the depth of the shoulder.
fn rows(cell: &Cell, body: &Body, raw: &[Sample], sensor: usize, behind: f64) -> Vec<Row> {
    let now = raw.len();
    let k = seen_for(raw, sensor);
    let first = now - k;
    let limit = |samples: usize| if k >= LONG_AGO { f64::MAX } else { depth(cell, samples) };
    let plain = |kind, depth, plate| Row { kind, depth, broken: now..now, plate, in_front: false, unsure: false };
    let mut all = Vec::new();
    // Broken in the samples before `end`, more and more, until the arm is as deep as it gets.
    let mut broken = |kind: u8, least: usize, end: usize, known: usize, reach: f64, plate: bool, in_front: bool| {
        for n in least.. {
            let all_of_them = end < n;
            let unsure = end < n + cell.lead_in || in_front;
            let deep = depth(cell, known + n + 1);
            let depth = if all_of_them || deep >= reach { f64::MAX } else { deep };
            // Of a body in the plane the FMU may tell itself, and late: the arm is there as long.
            let until = if kind == 0 && cell.sensors[sensor].evaluated { now } else { end };
            all.push(Row { kind, depth, broken: end.saturating_sub(n)..until, plate, in_front, unsure });
            if depth == f64::MAX {
                break;
            }
        }
    };
    if in_plane(&cell.sensors[sensor], body) {
        broken(0, 1, first, k, behind + ARM + cell.held, false, false);
        all.push(plain(0, limit(k + 1), false));
    } else if behind <= 0.0 {
        broken(1, 0, now, 0, behind + ARM + cell.held, false, false);
        all.push(plain(2, 0.0, true));
    } else {
        broken(3, 0, now, 0, ARM + cell.held - behind, false, true);
        if k > 0 && k < LONG_AGO {
            broken(4, 1, first, k, behind + ARM + cell.held, true, false);
        }
        all.push(plain(4, if k == 0 { f64::MAX } else { limit(k + 1) }, true));
    }
    all
}
