//! The values of a sweep, and the little arithmetic with which a campaign file says what follows from them: `= -1 + width`.

use std::collections::BTreeMap;

/// Values by the names of their axes.
pub type Values = BTreeMap<String, f64>;

/// Digits behind the point that count: 0.1 + 0.2 is 0.3 here.
const ROUND: f64 = 1e9;

/// Without what binary fractions leave over.
#[must_use]
pub(crate) fn rounded(value: f64) -> f64 {
    let rounded = (value * ROUND).round() / ROUND;
    // No minus in front of a zero.
    if rounded == 0.0 { 0.0 } else { rounded }
}

/// `steps` values from `from` to `to`, both included.
#[must_use]
pub(crate) fn steps(from: f64, to: f64, steps: u32) -> Vec<f64> {
    let last = f64::from(steps.max(2) - 1);
    (0..steps).map(|step| rounded(from + (to - from) * f64::from(step) / last)).collect()
}

/// What `text` (without its `=`) comes to.
///
/// # Errors
/// What is wrong with it, for people.
pub(crate) fn evaluate(text: &str, values: &Values) -> Result<f64, String> {
    let mut reader = Reader { rest: text, values, depth: 0 };
    let value = reader.sum()?;
    reader.skip();
    match reader.rest.chars().next() {
        Some(left) => Err(format!("`{left}` is not expected here")),
        None if value.is_finite() => Ok(rounded(value)),
        None => Err("it comes to no number".to_owned()),
    }
}

/// Brackets within brackets.
const DEEPEST: usize = 20;

struct Reader<'a> {
    rest: &'a str,
    values: &'a Values,
    depth: usize,
}

impl Reader<'_> {
    fn skip(&mut self) {
        self.rest = self.rest.trim_start();
    }

    /// Takes this letter, if it comes next.
    fn takes(&mut self, letter: char) -> bool {
        self.skip();
        let rest = self.rest.strip_prefix(letter);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    fn sum(&mut self) -> Result<f64, String> {
        let mut value = self.product()?;
        loop {
            if self.takes('+') {
                value += self.product()?;
            } else if self.takes('-') {
                value -= self.product()?;
            } else {
                return Ok(value);
            }
        }
    }

    fn product(&mut self) -> Result<f64, String> {
        let mut value = self.factor()?;
        loop {
            if self.takes('*') {
                value *= self.factor()?;
            } else if self.takes('/') {
                value /= self.factor()?;
            } else {
                return Ok(value);
            }
        }
    }

    fn factor(&mut self) -> Result<f64, String> {
        if self.takes('-') {
            return Ok(-self.atom()?);
        }
        self.atom()
    }

    fn atom(&mut self) -> Result<f64, String> {
        if self.takes('(') {
            self.depth += 1;
            if self.depth > DEEPEST {
                return Err("there are too many brackets".to_owned());
            }
            let value = self.sum()?;
            self.depth -= 1;
            return if self.takes(')') { Ok(value) } else { Err("a `)` is missing".to_owned()) };
        }
        self.skip();
        let end = self.rest.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '.')).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        if word.is_empty() {
            return Err("a number or the name of a sweep is missing".to_owned());
        }
        if word.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return word.parse().map_err(|_| format!("`{word}` is no number"));
        }
        self.values.get(word).copied().ok_or_else(|| format!("no sweep is called `{word}`"))
    }
}

/// A value as it stands in names and tables.
#[must_use]
pub(crate) fn shown(value: f64) -> String {
    format!("{}", rounded(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_and_products_are_those_of_school() {
        let values = Values::from([("w".to_owned(), 0.3), ("depth_2".to_owned(), 4.0)]);
        for (text, expected) in [
            (" -1 + w", -0.7),
            ("2*w - 1", -0.4),
            ("-(w + 0.1) * depth_2 / 2", -0.8),
            ("0.1 + 0.2", 0.3),
            ("depth_2", 4.0),
            ("w - w", 0.0),
        ] {
            assert_eq!(evaluate(text, &values), Ok(expected), "{text}");
        }
        for (text, words) in [
            ("", "missing"),
            ("w +", "missing"),
            ("width", "no sweep is called `width`"),
            ("(w", "`)` is missing"),
            ("w w", "not expected"),
            ("1.2.3", "no number"),
            ("1 / 0", "no number"),
            (&"(".repeat(5000), "too many brackets"),
        ] {
            let told = evaluate(text, &values).unwrap_err();
            assert!(told.contains(words), "{text}: {told}");
        }
    }

    #[test]
    fn steps_are_what_one_would_write() {
        assert_eq!(steps(0.1, 1.0, 10), [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]);
        assert_eq!(steps(1.0, -1.0, 3), [1.0, 0.0, -1.0]);
        assert_eq!(steps(2.0, 5.0, 1), [2.0]);
        assert_eq!([shown(0.1 + 0.2), shown(1.0), shown(-0.0)], ["0.3", "1", "0"]);
    }
}
