//! Figures in words: shares and bounds with the digits that mean something, large numbers, how many of something.

/// A part of a whole, with the digits that mean something.
pub fn percent(part: f64) -> String {
    match 100.0 * part {
        p if p <= 0.0 => "0 %".to_owned(),
        p if p >= 99.95 => "100 %".to_owned(),
        p => match places(p) {
            Some(places) => format!("{p:.places$} %"),
            None => "less than 0.0001 %".to_owned(),
        },
    }
}

/// Decimal places with which a percentage is told; none if it is too small for that.
fn places(percentage: f64) -> Option<usize> {
    match percentage {
        p if p >= 9.95 => Some(0),
        p if p >= 0.095 => Some(1),
        p if p >= 0.000_095 => {
            // Two digits that are not zero.
            let places = (-libm::floor(libm::log10(p)) + 1.0).clamp(2.0, 6.0);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "2 to 6")]
            let places = places as usize;
            Some(places)
        }
        _ => None,
    }
}

/// A bound from above: never rounded down.
pub fn at_most(part: f64) -> String {
    rounded(part, f64::ceil)
}

/// A bound from below: never rounded up.
pub fn at_least(part: f64) -> String {
    rounded(part, f64::floor)
}

fn rounded(part: f64, to: fn(f64) -> f64) -> String {
    let Some(places) = places(100.0 * part) else { return percent(part) };
    let scale = (0..places).fold(100.0, |scale, _| 10.0 * scale);
    // What is a round figure but for the last bits stays it.
    let nearest = (part * scale).round();
    let whole = if (part * scale - nearest).abs() < 1e-9 { nearest } else { to(part * scale) };
    percent(whole / scale)
}

/// A number with its thousands set apart.
#[must_use]
pub fn grouped(digits: &str) -> String {
    let first = (digits.len() + 2) % 3 + 1;
    let (head, tail) = digits.split_at(first.min(digits.len()));
    let groups = tail.as_bytes().chunks(3).map(|c| String::from_utf8_lossy(c).into_owned());
    std::iter::once(head.to_owned()).chain(groups).collect::<Vec<_>>().join(",")
}

/// So many of them.
#[must_use]
pub fn plural(n: usize, one: &str) -> String {
    if n == 1 { format!("1 {one}") } else { format!("{n} {one}s") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_have_the_digits_that_mean_something() {
        for (part, words) in [
            (0.0, "0 %"),
            (1.0, "100 %"),
            (0.254_6, "25 %"),
            (0.033_46, "3.3 %"),
            (0.009_97, "1.0 %"),
            (0.000_97, "0.1 %"),
            (0.000_041, "0.0041 %"),
            (0.000_001_2, "0.00012 %"),
            (0.000_000_1, "less than 0.0001 %"),
        ] {
            assert_eq!(percent(part), words);
        }
    }

    #[test]
    fn bounds_hold_as_they_are_printed() {
        let bounds =
            [(0.019_3, "2.0 %", "1.9 %"), (0.02, "2.0 %", "2.0 %"), (0.254_6, "26 %", "25 %"), (0.0, "0 %", "0 %")];
        for (part, above, below) in bounds {
            assert_eq!([at_most(part), at_least(part)], [above, below]);
        }
        assert_eq!([at_most(0.999_1), at_least(0.999_9)], ["100 %", "99 %"]);
    }
}
