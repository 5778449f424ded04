//! Numbers, and what a process said, as people read them.

use std::fmt;

/// A number as a person writes it: very small and very large ones with an exponent, not with hundreds of zeros.
#[must_use]
pub fn number(value: f64) -> String {
    let plain = value == 0.0 || !value.is_finite() || (1e-5..1e16).contains(&value.abs());
    if plain { value.to_string() } else { format!("{value:e}") }
}

/// A message, and the last lines that were printed before it.
pub struct Said<'a> {
    /// The message.
    pub message: &'a str,
    /// The lines.
    pub printed: &'a [String],
}

impl fmt::Display for Said<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message)?;
        if !self.printed.is_empty() {
            f.write_str("\nthe last lines that it printed:")?;
        }
        self.printed.iter().try_for_each(|line| write!(f, "\n  {line}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, text) in [
            (0.0, "0"),
            (-0.02, "-0.02"),
            (1e-300, "1e-300"),
            (-2.5e-9, "-2.5e-9"),
            (1e300, "1e300"),
            (1e9, "1000000000"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(number(value), text);
        }
    }
}
