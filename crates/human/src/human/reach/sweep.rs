//! What elbow and wrist sweep while the joint angles are within a box: how far they get in a direction.
//!
//! Everything is told in the frame of the shoulder of a left arm; a right arm is the same in a mirror.
//!
//! **Why the bounds hold.** Let f be the coordinate of a point of the arm along a unit vector, a function of the four
//! angles. Along one of them, f is a constant and a circular motion, so its second derivative is minus the part of the
//! point's distance vector from that joint's axis that is along the vector. A function of one variable is above the line
//! through its values at the ends of an interval of half width h by at most b (1 - t^2), where t runs from -1 to 1 and b is
//! h^2 / 2 times the most that its second derivative is below zero. Joint by joint, this bounds f by the interpolation
//! between the 16 corners of the box plus the sum of b (1 - t^2) over the joints. The interpolation falls from a corner at
//! least as steeply as the flattest of the box's edges along that joint, if all of them rise to the same side: with s for
//! half of what it falls along that edge, a joint adds no more than the maximum of b (1 - t^2) - s (1 - t), which is
//! (2 b - s)^2 / (4 b), and nothing if s is above 2 b.

use crate::geometry::Vec3;
use crate::human::arm::ArmModel;

/// Coordinates along a direction, from those in the middle of the box, m.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    pub(super) low: f64,
    pub(super) high: f64,
}

impl Range {
    /// Of what does not move.
    pub(super) const NONE: Self = Self { low: 0.0, high: 0.0 };

    /// The same, farther to both sides.
    pub(super) const fn wider(self, by: f64) -> Self {
        Self { low: self.low - by, high: self.high + by }
    }

    /// How far from the middle, m.
    pub(super) const fn most(self) -> f64 {
        self.high.max(-self.low)
    }
}

/// Sine and cosine of an angle.
pub(super) type Turn = (f64, f64);

/// See the top of this file.
pub(super) struct Sweep {
    half: [f64; 4],
    /// The abduction at both ends.
    abduction: [Turn; 2],
    /// Before abduction, the wrist forwards and upwards by flexion, rotation and elbow, and sidewards by the last two, m.
    forwards: [f64; 8],
    upwards: [f64; 8],
    sidewards: [f64; 4],
    /// Before abduction, the elbow forwards and upwards by flexion, m.
    elbow: [(f64, f64); 2],
    /// How much of the forearm is along the upper arm, by elbow, as a part of the upper arm's length.
    stretched: [f64; 2],
    /// Elbow and wrist in the middle.
    middle: [Vec3; 2],
    /// How far elbow and wrist can be from each joint's axis, m.
    levers: Levers,
}

/// How far elbow and wrist can be from each joint's axis, m.
#[derive(Clone, Copy)]
pub(super) struct Levers {
    pub(super) elbow: [f64; 2],
    pub(super) wrist: [f64; 4],
}

impl Sweep {
    /// Of an arm within a box of half widths `half`; `middle` and `halves` are the turns by what the angles are in the
    /// middle and by the half widths.
    pub(super) fn of(arm: &ArmModel, half: [f64; 4], middle: &[Turn; 4], halves: &[Turn; 4], levers: Levers) -> Self {
        let [abduction, flexion, rotation, bend]: [[Turn; 2]; 4] = std::array::from_fn(|j| {
            let ((s, c), (sin, cos)) = (middle[j], halves[j]);
            [(s * cos - c * sin, c * cos + s * sin), (s * cos + c * sin, c * cos - s * sin)]
        });
        let (upper, fore) = (arm.upper_arm_m, arm.forearm_m);
        let mut this = Self {
            half,
            abduction,
            forwards: [0.0; 8],
            upwards: [0.0; 8],
            sidewards: [0.0; 4],
            elbow: flexion.map(|(s, c)| (upper * s, -upper * c)),
            stretched: bend.map(|(_, c)| fore * c / upper),
            middle: arm.at(middle),
            levers,
        };
        for (r, (sin_r, cos_r)) in rotation.into_iter().enumerate() {
            for (e, (sin_e, cos_e)) in bend.into_iter().enumerate() {
                let (forwards, upwards) = (fore * sin_e * cos_r, -upper - fore * cos_e);
                this.sidewards[2 * r + e] = -fore * sin_e * sin_r;
                for (f, (sin, cos)) in flexion.into_iter().enumerate() {
                    this.forwards[4 * f + 2 * r + e] = forwards * cos - upwards * sin;
                    this.upwards[4 * f + 2 * r + e] = forwards * sin + upwards * cos;
                }
            }
        }
        this
    }

    /// The wrist in each corner of the box: the bits of its number are abduction, flexion, rotation and elbow, from the
    /// highest on, set at the upper end.
    fn corners(&self) -> [Vec3; 16] {
        std::array::from_fn(|corner| {
            let (rest, (sin, cos)) = (corner & 7, self.abduction[corner >> 3]);
            let (side, up) = (self.sidewards[rest & 3], self.upwards[rest]);
            Vec3::new(self.forwards[rest], side * cos - up * sin, side * sin + up * cos)
        })
    }

    /// The elbow in each corner: abduction and flexion.
    fn elbows(&self) -> [Vec3; 4] {
        std::array::from_fn(|corner| {
            let ((sin, cos), (forwards, up)) = (self.abduction[corner >> 1], self.elbow[corner & 1]);
            Vec3::new(forwards, -up * sin, up * cos)
        })
    }

    /// How far the wrist gets from where it is in the middle at most, m, and the joint whose halving shrinks what is swept
    /// most: the one with the longest edge between corners. That of the elbow counts half: what blocks an arm often
    /// blocks it there.
    pub(super) fn size(&self) -> (f64, usize) {
        let (wrists, elbows) = (self.corners(), self.elbows());
        let farthest = wrists.iter().map(|w| (*w - self.middle[1]).length_squared()).fold(0.0, f64::max).sqrt();
        let bulge: f64 = (0..4).map(|j| 0.5 * self.half[j] * self.half[j] * self.levers.wrist[j]).sum();
        let longest: [f64; 4] = std::array::from_fn(|j| {
            longest_edge(&wrists, 8 >> j) + if j < 2 { 0.5 * longest_edge(&elbows, 2 >> j) } else { 0.0 }
        });
        let widest = (1..4).fold(0, |best, j| if longest[j] > longest[best] { j } else { best });
        (farthest + bulge + ROUNDING_M, widest)
    }

    /// Along `n`, no longer than a unit vector, in the frame of the shoulder.
    pub(super) fn elbow(&self, n: Vec3) -> Range {
        self.elbow_by_corner(n).1
    }

    fn elbow_by_corner(&self, n: Vec3) -> ([f64; 4], Range) {
        let (mut values, mut across) = ([0.0; 4], [0.0; 4]);
        for (a, (sin, cos)) in self.abduction.into_iter().enumerate() {
            let up = n.z * cos - n.y * sin;
            for (f, (forwards, upwards)) in self.elbow.into_iter().enumerate() {
                across[2 * a + f] = up * upwards;
                values[2 * a + f] = n.x * forwards + up * upwards;
            }
        }
        let all = Extremes::of(&values);
        let [abduction, flexion] = [0, 1].map(|j| 0.5 * self.half[j] * self.half[j]);
        let [far, near] = self.levers.elbow;
        let slack = abduction * far + flexion * near;
        let first = bulge(abduction, far, slack, Extremes::of(&across), rise::<4, 2>(&values));
        let second = bulge(flexion, near, slack, all, rise::<4, 1>(&values));
        (values, all.beyond(&[first, second], n.dot(self.middle[0])))
    }

    /// Of elbow and wrist along `n`, no longer than a unit vector, in the frame of the shoulder.
    pub(super) fn both(&self, n: Vec3) -> [Range; 2] {
        let (elbows, elbow) = self.elbow_by_corner(n);
        let mut values = [0.0; 16];
        // How far the wrist is from each joint's axis, along `n`.
        let mut from_axes = [[0.0; 16]; 4];
        for (a, (sin, cos)) in self.abduction.into_iter().enumerate() {
            let (side, up) = (n.y * cos + n.z * sin, n.z * cos - n.y * sin);
            for i in 0..8 {
                let (x, y, z) = (n.x * self.forwards[i], side * self.sidewards[i & 3], up * self.upwards[i]);
                let (corner, at_elbow) = (8 * a + i, elbows[2 * a + (i >> 2)]);
                values[corner] = x + y + z;
                from_axes[0][corner] = y + z;
                from_axes[1][corner] = x + z;
                from_axes[2][corner] = x + y + z - at_elbow - at_elbow * self.stretched[i & 1];
                from_axes[3][corner] = x + y + z - at_elbow;
            }
        }
        let squares = self.half.map(|h| 0.5 * h * h);
        let levers = self.levers.wrist;
        let rises = [rise::<16, 8>(&values), rise::<16, 4>(&values), rise::<16, 2>(&values), rise::<16, 1>(&values)];
        let bulges: [Bulge; 4] = std::array::from_fn(|j| {
            let slack: f64 = (0..4).map(|i| squares[i] * levers[i.max(j)]).sum();
            bulge(squares[j], levers[j], slack, Extremes::of(&from_axes[j]), rises[j])
        });
        [elbow, Extremes::of(&values).beyond(&bulges, n.dot(self.middle[1]))]
    }
}

/// Length of the longest edge between corners whose numbers differ by `bit`, m.
fn longest_edge(corners: &[Vec3], bit: usize) -> f64 {
    let edges = (0..corners.len()).filter(|c| c & bit == 0).map(|c| (corners[c | bit] - corners[c]).length_squared());
    edges.fold(0.0, f64::max).sqrt()
}

/// Least and most of some numbers.
#[derive(Clone, Copy)]
struct Extremes {
    least: f64,
    most: f64,
}

impl Extremes {
    fn of<const N: usize>(values: &[f64; N]) -> Self {
        let (mut least, mut most) = (*values, *values);
        let mut count = N;
        while count > 1 {
            count /= 2;
            for i in 0..count {
                least[i] = if least[i + count] < least[i] { least[i + count] } else { least[i] };
                most[i] = if most[i + count] > most[i] { most[i + count] } else { most[i] };
            }
        }
        Self { least: least[0], most: most[0] }
    }

    /// With what is beyond the interpolation.
    fn beyond(self, bulges: &[Bulge], middle: f64) -> Range {
        let above: f64 = bulges.iter().map(|b| b.above).sum();
        let below: f64 = bulges.iter().map(|b| b.below).sum();
        Range { low: self.least - below - middle - ROUNDING_M, high: self.most + above - middle + ROUNDING_M }
    }
}

/// Half of what the numbers of corners rise along the edges between those whose numbers differ by `BIT`.
fn rise<const N: usize, const BIT: usize>(values: &[f64; N]) -> Extremes {
    // Edges that are counted twice change nothing.
    let rises: [f64; N] = std::array::from_fn(|i| 0.5 * (values[i | BIT] - values[i & !BIT]));
    Extremes::of(&rises)
}

/// More than what rounding can do to coordinates of an arm, m.
const ROUNDING_M: f64 = 1e-12;

/// What a joint adds beyond the corners, above and below, m.
struct Bulge {
    above: f64,
    below: f64,
}

/// Of a joint of which half the square of the half width is `square`; `from_axis` is how far the point is from its axis
/// along the direction in the corners, in the box by at most `slack` more, and never by more than `lever`; `rise` is half of
/// what it rises along the edges.
fn bulge(square: f64, lever: f64, slack: f64, from_axis: Extremes, rise: Extremes) -> Bulge {
    let slope = rise.least.max(-rise.most).max(0.0);
    let beyond = |from_axis: f64| {
        let most = square * (from_axis + slack).clamp(0.0, lever);
        let left = 2.0 * most - slope;
        if left > 0.0 { left * left / (4.0 * most) } else { 0.0 }
    };
    Bulge { above: beyond(from_axis.most), below: beyond(-from_axis.least) }
}
