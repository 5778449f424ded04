//! How everything stands that follows the FMU's outputs, as one number: what it means, the cell knows.

/// Which state each thing that follows the FMU is in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Arrangement(u16);

impl Arrangement {
    /// So many can be told apart.
    pub const MOST: usize = 1 << 16;

    /// Nothing of it is in the way, and every sensor counts.
    pub const NONE: Self = Self(0);

    /// That with a number.
    #[must_use]
    pub const fn new(number: u16) -> Self {
        Self(number)
    }

    /// Its number.
    #[must_use]
    pub const fn number(self) -> u16 {
        self.0
    }

    /// Whether it is [`Self::NONE`].
    #[must_use]
    pub const fn is_none(self) -> bool {
        self.0 == 0
    }
}
