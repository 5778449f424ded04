//! Sine and cosine from additions and products only.
//!
//! The system's libm gives other last bits on other machines, and the cells have no dependencies, so that they build
//! with nothing but a compiler. IEEE 754 fixes the result of every operation used here; the values are therefore the
//! same bits everywhere. Accuracy: about 2 ulp for arguments of a few turns, which is what joint angles need.

use std::f64::consts::FRAC_PI_2;

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
    }
}
