//! Vectors, rotations, segments against segments, boxes and half-spaces. Metres, radians.

pub type V3 = [f64; 3];
pub type M3 = [V3; 3];

pub const UNIT: M3 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

pub fn add(a: V3, b: V3) -> V3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn sub(a: V3, b: V3) -> V3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn scaled(a: V3, k: f64) -> V3 {
    a.map(|x| x * k)
}

pub fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn length(a: V3) -> f64 {
    dot(a, a).sqrt()
}

pub fn between(a: V3, b: V3, t: f64) -> V3 {
    add(a, scaled(sub(b, a), t))
}

/// Matrix times vector.
pub fn turned(m: &M3, v: V3) -> V3 {
    m.map(|row| dot(row, v))
}

/// Transposed matrix times vector.
pub fn turned_back(m: &M3, v: V3) -> V3 {
    [0, 1, 2].map(|j| m[0][j] * v[0] + m[1][j] * v[1] + m[2][j] * v[2])
}

pub fn product(a: &M3, b: &M3) -> M3 {
    a.map(|row| [0, 1, 2].map(|j| row[0] * b[0][j] + row[1] * b[1][j] + row[2] * b[2][j]))
}

/// Rotation by `angle` about the unit vector `axis`.
pub fn about(axis: V3, angle: f64) -> M3 {
    let (s, c) = (libm::sin(angle), libm::cos(angle));
    let [x, y, z] = axis;
    let t = 1.0 - c;
    [
        [t * x * x + c, t * x * y - s * z, t * x * z + s * y],
        [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
        [t * x * z - s * y, t * y * z + s * x, t * z * z + c],
    ]
}

/// Roll, pitch, yaw in degrees about the fixed axes.
pub fn rpy(degrees: V3) -> M3 {
    let [x, y, z] = degrees.map(f64::to_radians);
    product(&about(UNIT[2], z), &product(&about(UNIT[1], y), &about(UNIT[0], x)))
}

pub fn nearest_on(p: V3, a: V3, b: V3) -> V3 {
    let d = sub(b, a);
    let l = dot(d, d);
    if l > 0.0 { between(a, b, (dot(sub(p, a), d) / l).clamp(0.0, 1.0)) } else { a }
}

/// The nearest points of two segments: the best of the four ends against the other segment, and of the two lines where
/// their nearest points lie within both.
pub fn nearest(a: [V3; 2], b: [V3; 2]) -> (V3, V3) {
    let mut best = (a[0], nearest_on(a[0], b[0], b[1]));
    let mut least = f64::MAX;
    let mut offer = |p: V3, q: V3| {
        let d = dot(sub(p, q), sub(p, q));
        if d < least {
            (best, least) = ((p, q), d);
        }
    };
    let (u, v, w) = (sub(a[1], a[0]), sub(b[1], b[0]), sub(a[0], b[0]));
    let (uu, uv, vv, uw, vw) = (dot(u, u), dot(u, v), dot(v, v), dot(u, w), dot(v, w));
    let det = uu * vv - uv * uv;
    if det > 1e-12 * uu * vv {
        let (s, t) = ((uv * vw - vv * uw) / det, (uu * vw - uv * uw) / det);
        if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
            offer(between(a[0], a[1], s), between(b[0], b[1], t));
        }
    }
    for end in a {
        offer(end, nearest_on(end, b[0], b[1]));
    }
    for end in b {
        offer(nearest_on(end, a[0], a[1]), end);
    }
    best
}

/// What stands still, or is taken for a wall.
#[derive(Debug, Clone, PartialEq)]
pub enum Solid {
    /// An upright box along the axes.
    Box { low: V3, high: V3 },
    /// Everything where `dot(normal, x) > from`.
    Half { normal: V3, from: f64 },
}

impl Solid {
    /// Distance of the segment; where it enters, how deep it does, negative: no smaller motion takes all of it out.
    pub fn gap(&self, s: [V3; 2]) -> f64 {
        match self {
            Self::Half { normal, from } => from - dot(*normal, s[0]).max(dot(*normal, s[1])),
            Self::Box { low, high } => {
                let apart = box_distance(*low, *high, s);
                if apart > 0.0 { apart } else { -box_depth(*low, *high, s) }
            }
        }
    }
}

fn box_distance(low: V3, high: V3, s: [V3; 2]) -> f64 {
    let d = sub(s[1], s[0]);
    let mut cuts = [0.0; 8];
    let mut count = 1;
    for i in 0..3 {
        if d[i] != 0.0 {
            for edge in [low[i], high[i]] {
                let t = (edge - s[0][i]) / d[i];
                if t > 0.0 && t < 1.0 {
                    cuts[count] = t;
                    count += 1;
                }
            }
        }
    }
    cuts[count] = 1.0;
    let cuts = &mut cuts[..=count];
    cuts.sort_by(f64::total_cmp);
    let distance = |t: f64| {
        let p = between(s[0], s[1], t);
        let out = |i: usize| (low[i] - p[i]).max(p[i] - high[i]).max(0.0);
        out(0) * out(0) + out(1) * out(1) + out(2) * out(2)
    };
    let mut least = distance(0.0).min(distance(1.0));
    // Between two cuts the square of the distance is one parabola.
    for pair in cuts.windows(2) {
        let p = between(s[0], s[1], 0.5 * (pair[0] + pair[1]));
        let (mut ab, mut bb) = (0.0, 0.0);
        for i in 0..3 {
            let edge = if p[i] < low[i] {
                low[i]
            } else if p[i] > high[i] {
                high[i]
            } else {
                continue;
            };
            ab += (s[0][i] - edge) * d[i];
            bb += d[i] * d[i];
        }
        // Within the box the middle is as near as any, and not at an edge, where rounding decides.
        let t = if bb > 0.0 { (-ab / bb).clamp(pair[0], pair[1]) } else { 0.5 * (pair[0] + pair[1]) };
        least = least.min(distance(t));
    }
    least.sqrt()
}

/// The largest distance from the faces that a point of the segment has within the box.
fn box_depth(low: V3, high: V3, s: [V3; 2]) -> f64 {
    let d = sub(s[1], s[0]);
    let mut lines = [(0.0, 0.0); 6];
    for i in 0..3 {
        lines[2 * i] = (s[0][i] - low[i], d[i]);
        lines[2 * i + 1] = (high[i] - s[0][i], -d[i]);
    }
    let depth = |t: f64| lines.iter().map(|(c, m)| c + m * t).fold(f64::MAX, f64::min);
    let mut deepest = depth(0.0).max(depth(1.0));
    for (i, (c, m)) in lines.iter().enumerate() {
        for (k, n) in &lines[i + 1..] {
            let t = (k - c) / (m - n);
            if t > 0.0 && t < 1.0 {
                deepest = deepest.max(depth(t));
            }
        }
    }
    deepest.max(0.0)
}
