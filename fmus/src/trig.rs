//! Sine, cosine and arc functions from additions, products and square roots only.
//!
//! The system's libm gives other last bits on other machines, and the cells have no dependencies, so that they build
//! with nothing but a compiler. IEEE 754 fixes the result of every operation used here; the values are therefore the
//! same bits everywhere. Accuracy: about 2 ulp for arguments of a few turns, which is what joint angles need.

use std::f64::consts::{FRAC_PI_2, PI};

/// pi/2 in three parts. The first two have 33 significant bits, so that a small integer times either is exact.
const HALF_PI_HIGH: f64 = 1.570_796_326_734_125_6;
const HALF_PI_MIDDLE: f64 = 6.077_100_506_303_966e-11;
const HALF_PI_LOW: f64 = 2.022_266_248_795_950_7e-21;

/// Returns (sin x, cos x), x in radians, |x| below about 1e5.
pub fn sin_cos(x: f64) -> (f64, f64) {
    let quarter_turns = (x / FRAC_PI_2).round();
    let rest = ((x - quarter_turns * HALF_PI_HIGH) - quarter_turns * HALF_PI_MIDDLE) - quarter_turns * HALF_PI_LOW;
    let (sine, cosine) = (sine_near_zero(rest), cosine_near_zero(rest));
    let quadrant = quarter_turns.rem_euclid(4.0);
    if quadrant < 0.5 {
        (sine, cosine)
    } else if quadrant < 1.5 {
        (cosine, -sine)
    } else if quadrant < 2.5 {
        (-sine, -cosine)
    } else {
        (-cosine, sine)
    }
}

/// Taylor series to x^17: the remainder is below 1e-19 for |x| <= pi/4.
fn sine_near_zero(x: f64) -> f64 {
    let square = x * x;
    let mut sum = 1.0;
    for n in [16.0, 14.0, 12.0, 10.0, 8.0, 6.0, 4.0, 2.0] {
        sum = 1.0 - square / (n * (n + 1.0)) * sum;
    }
    x * sum
}

/// Taylor series to x^18.
fn cosine_near_zero(x: f64) -> f64 {
    let square = x * x;
    let mut sum = 1.0;
    for n in [17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0, 1.0] {
        sum = 1.0 - square / (n * (n + 1.0)) * sum;
    }
    sum
}

/// The angle of the point (x, y), in (-pi, pi], radians; 0 for the origin.
pub fn atan2(y: f64, x: f64) -> f64 {
    if x == 0.0 && y == 0.0 {
        return 0.0;
    }
    let (small, large) = if y.abs() <= x.abs() { (y.abs(), x.abs()) } else { (x.abs(), y.abs()) };
    let octant = arctangent(small / large);
    let quarter = if y.abs() <= x.abs() { octant } else { FRAC_PI_2 - octant };
    let half = if x < 0.0 { PI - quarter } else { quarter };
    if y < 0.0 { -half } else { half }
}

/// arctan on [0, 1]: the angle is halved twice, then summed as a series (remainder below 1e-18 for t <= tan(pi/16)).
fn arctangent(t: f64) -> f64 {
    let halved = t / (1.0 + (1.0 + t * t).sqrt());
    let quartered = halved / (1.0 + (1.0 + halved * halved).sqrt());
    let square = quartered * quartered;
    let mut sum = 0.0;
    for n in [25.0, 23.0, 21.0, 19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0, 1.0] {
        sum = 1.0 / n - square * sum;
    }
    4.0 * quartered * sum
}

/// The angle in [0, pi] whose cosine is x, |x| <= 1.
pub fn acos(x: f64) -> f64 {
    atan2(((1.0 - x) * (1.0 + x)).max(0.0).sqrt(), x)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::disallowed_methods, reason = "the standard library is the independent reference here")]
    use super::*;

    #[test]
    fn agrees_with_the_standard_library() {
        let mut worst: f64 = 0.0;
        for step in -40_000..=40_000 {
            let x = f64::from(step) * 0.000_5;
            let (sine, cosine) = sin_cos(x);
            worst = worst.max((sine - x.sin()).abs()).max((cosine - x.cos()).abs());
        }
        assert!(worst < 5e-16, "sin or cos is off by {worst:e}");
        let mut worst: f64 = 0.0;
        for step in -3_000..=3_000 {
            let angle = f64::from(step) * 0.001;
            let (y, x) = (2.5 * angle.sin(), 2.5 * angle.cos());
            worst = worst.max((atan2(y, x) - y.atan2(x)).abs()).max((acos(angle / 3.0) - (angle / 3.0).acos()).abs());
        }
        assert!(worst < 1e-15, "atan2 or acos is off by {worst:e}");
    }

    #[test]
    fn the_axes_are_exact() {
        assert_eq!(atan2(0.0, 2.0), 0.0);
        assert_eq!(atan2(3.0, 0.0), FRAC_PI_2);
        assert_eq!(atan2(-3.0, 0.0), -FRAC_PI_2);
        assert_eq!(atan2(0.0, -1.0), PI);
        assert_eq!(sin_cos(0.0), (0.0, 1.0));
    }
}
