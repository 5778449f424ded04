//! How far a shape reaches along thirteen axes, to both sides: how far away something is at least is soon told by that.

use super::Vec3;

/// The ranges of a shape along the axes of a cube, the diagonals of its sides and those of its space, in its own frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slices([[f64; 2]; 13]);

/// One over the root of 2, and of 3.
const BY_ROOTS: [f64; 2] = [std::f64::consts::FRAC_1_SQRT_2, 0.577_350_269_189_625_8];

impl Slices {
    /// Of what holds these points.
    pub(super) fn of(points: &[Vec3]) -> Self {
        let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 13];
        for point in points {
            for (range, at) in ranges.iter_mut().zip(along(*point)) {
                *range = [range[0].min(at), range[1].max(at)];
            }
        }
        Self(ranges)
    }

    /// The segment between `a` and `b` is no nearer than this, m.
    pub(super) fn at_least(&self, a: Vec3, b: Vec3) -> f64 {
        let mut most = f64::NEG_INFINITY;
        for (([low, high], from), to) in self.0.iter().zip(along(a)).zip(along(b)) {
            most = most.max((low - from.max(to)).max(from.min(to) - high));
        }
        most
    }
}

/// Where a point is along the axes.
fn along(Vec3 { x, y, z }: Vec3) -> [f64; 13] {
    let [flat, deep] = BY_ROOTS;
    [
        x,
        y,
        z,
        (x + y) * flat,
        (x - y) * flat,
        (y + z) * flat,
        (y - z) * flat,
        (z + x) * flat,
        (z - x) * flat,
        (x + y + z) * deep,
        (x + y - z) * deep,
        (x - y + z) * deep,
        (y + z - x) * deep,
    ]
}
