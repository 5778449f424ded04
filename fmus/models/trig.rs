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

/// (sin x, cos x) of each x, in radians, |x| below about 1e5. Side by side, the long chains of operations overlap.
pub fn sin_cos_of_all<const N: usize>(x: [f64; N]) -> [(f64, f64); N] {
    let quarter_turns = x.map(|x| nearest(x / FRAC_PI_2));
    let rest: [f64; N] = std::array::from_fn(|k| {
        let turns = f64::from(quarter_turns[k]);
        ((x[k] - turns * HALF_PI_HIGH) - turns * HALF_PI_MIDDLE) - turns * HALF_PI_LOW
    });
    let (sines, cosines) = (sines_near_zero(rest), cosines_near_zero(rest));
    std::array::from_fn(|k| {
        let (sine, cosine) = (sines[k], cosines[k]);
        match quarter_turns[k] & 3 {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        }
    })
}

/// The nearest whole number, of two the one further from zero, as `f64::round` says; without a call into a library.
#[expect(
    clippy::cast_possible_truncation,
    reason = "some turns; what is no number becomes 0, as its sine is none either"
)]
fn nearest(x: f64) -> i32 {
    let whole = x as i32;
    let part = x - f64::from(whole);
    whole + i32::from(part >= 0.5) - i32::from(part <= -0.5)
}

/// Taylor series to x^17: the remainder is below 1e-19 for |x| <= pi/4.
fn sines_near_zero<const N: usize>(x: [f64; N]) -> [f64; N] {
    let squares = x.map(|x| x * x);
    let mut sums = [1.0; N];
    for n in [16.0, 14.0, 12.0, 10.0, 8.0, 6.0, 4.0, 2.0] {
        sums = std::array::from_fn(|k| 1.0 - squares[k] / (n * (n + 1.0)) * sums[k]);
    }
    std::array::from_fn(|k| x[k] * sums[k])
}

/// Taylor series to x^18.
fn cosines_near_zero<const N: usize>(x: [f64; N]) -> [f64; N] {
    let squares = x.map(|x| x * x);
    let mut sums = [1.0; N];
    for n in [17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0, 1.0] {
        sums = std::array::from_fn(|k| 1.0 - squares[k] / (n * (n + 1.0)) * sums[k]);
    }
    sums
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
            let [(sine, cosine)] = sin_cos_of_all([x]);
            worst = worst.max((sine - x.sin()).abs()).max((cosine - x.cos()).abs());
        }
        assert!(worst < 5e-16, "sin or cos is off by {worst:e}");
    }
}
