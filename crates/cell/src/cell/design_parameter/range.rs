//! How far something may be turned: as far as it goes, and as far as the cell file lets it.

/// Most steps that a range of a cell file is searched in.
const MOST: f64 = 100_000.0;

/// How far something may be turned.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct ParameterRange {
    /// Steps to try at most.
    pub steps: u32,
    /// Where the range of the cell file ends, in what a step is counted in: the last step goes no farther.
    pub farthest: Option<f64>,
    /// What the cell file allows, in words, if that is where the steps end.
    pub end: Option<String>,
}

impl ParameterRange {
    /// In steps of `step`: `possible` is as far as the thing goes, `usual` the steps that are tried unless the cell file says
    /// something, `allowed` how far that lets it go, with words.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "bounded")]
    pub(crate) fn new(step: f64, possible: f64, usual: u32, allowed: Option<(f64, String)>) -> Self {
        let whole = |room: f64| (room / step + 1e-9).floor().clamp(0.0, MOST) as u32;
        match allowed {
            None => Self { steps: whole(possible).min(usual), farthest: None, end: None },
            Some((allowed, words)) if allowed <= possible => {
                let steps = (allowed / step - 1e-9).ceil().clamp(0.0, MOST) as u32;
                Self { steps, farthest: Some(allowed.max(0.0)), end: Some(words) }
            }
            Some(_) => Self { steps: whole(possible), farthest: None, end: None },
        }
    }

    /// So many steps of `step`, no farther than the cell file allows.
    pub(crate) fn amount(&self, steps: u32, step: f64) -> f64 {
        let amount = f64::from(steps) * step;
        self.farthest.map_or(amount, |farthest| amount.min(farthest))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_step_ends_where_the_range_does() {
        let words = || "0.255 m".to_owned();
        let room = ParameterRange::new(0.01, 9.0, 20, Some((0.255, words())));
        assert_eq!((room.steps, room.end.clone()), (26, Some(words())));
        assert!((room.amount(25, 0.01) - 0.25).abs() < 1e-12 && (room.amount(26, 0.01) - 0.255).abs() < 1e-12);
        // Whole steps need no shorter one; a range goes beyond what is usual, and not beyond what is possible.
        assert_eq!(ParameterRange::new(0.01, 9.0, 20, Some((0.3, words()))).steps, 30);
        assert_eq!(
            ParameterRange::new(0.01, 0.1, 20, Some((0.3, words()))),
            ParameterRange { steps: 10, ..ParameterRange::default() }
        );
        assert_eq!(ParameterRange::new(0.01, 9.0, 20, None).steps, 20);
        assert_eq!(ParameterRange::new(0.01, 9.0, 20, Some((-0.1, words()))).steps, 0);
    }
}
