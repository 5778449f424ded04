//! How much of a posture's bend is taken, in sixteenths.

/// Share of a posture's bend, in whole sixteenths from 0 (upright) to 16 (the full bend).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BendFraction(u8);

impl BendFraction {
    /// Number of fractions, upright and full included.
    pub(crate) const STEPS: usize = 17;
    /// No bend at all.
    pub const UPRIGHT: Self = Self(0);
    /// The bend that the posture asks for.
    pub const FULL: Self = Self(16);
    /// Every fraction once, from upright to full.
    pub const ALL: [Self; Self::STEPS] = {
        let mut all = [Self::UPRIGHT; Self::STEPS];
        let mut sixteenths = 1;
        while sixteenths <= Self::FULL.0 {
            all[sixteenths as usize] = Self(sixteenths);
            sixteenths += 1;
        }
        all
    };

    /// `sixteenths` / 16 of the bend, if that is no more than all of it.
    #[cfg(test)]
    pub(crate) const fn new(sixteenths: u8) -> Option<Self> {
        if sixteenths <= Self::FULL.0 { Some(Self(sixteenths)) } else { None }
    }

    /// Whole sixteenths, 0..=16.
    #[must_use]
    pub const fn sixteenths(self) -> u8 {
        self.0
    }

    /// The fraction as a number from 0 to 1.
    #[must_use]
    pub(crate) fn share(self) -> f64 {
        f64::from(self.0) / 16.0
    }
}
