//! Which controls of the cell are worked in an action, as a set of their numbers.

use std::fmt;

/// Controls that are worked, by their numbers in the cell file, from 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Presses(u8);

impl Presses {
    /// Most controls of a cell: each doubles the number of actions.
    pub const MOST: usize = 6;

    /// None.
    pub const NONE: Self = Self(0);

    /// The sets of so many controls, the empty one first.
    pub fn all(controls: usize) -> impl Iterator<Item = Self> {
        (0..1_u8 << controls.min(Self::MOST)).map(Self)
    }

    /// This one alone; it must be below [`Self::MOST`].
    #[must_use]
    pub const fn one(control: usize) -> Self {
        assert!(control < Self::MOST, "there are no more controls");
        Self(1 << control)
    }

    /// Both together.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Those that are in one of the two only.
    #[must_use]
    pub const fn either(self, other: Self) -> Self {
        Self(self.0 ^ other.0)
    }

    /// Those that are in both.
    #[must_use]
    pub const fn common(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// Whether it is among them.
    #[must_use]
    pub const fn has(self, control: usize) -> bool {
        control < Self::MOST && self.0 >> control & 1 == 1
    }

    /// Whether there are none.
    #[must_use]
    pub const fn is_none(self) -> bool {
        self.0 == 0
    }

    /// How many there are.
    #[must_use]
    pub const fn count(self) -> u32 {
        self.0.count_ones()
    }

    /// Their numbers, in order.
    pub fn numbers(self) -> impl Iterator<Item = usize> {
        (0..Self::MOST).filter(move |control| self.has(*control))
    }

    /// Number of the set among [`Presses::all`].
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// The set with this number, if there is one.
    pub(super) fn from_index(index: usize) -> Option<Self> {
        u8::try_from(index).ok().filter(|bits| *bits < 1 << Self::MOST).map(Self)
    }
}

impl fmt::Display for Presses {
    /// As in an action's text: `+press1+press3`, counted from 1.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.numbers().try_for_each(|control| write!(f, "+press{}", control + 1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_are_what_they_are_made_of() {
        assert_eq!(Presses::all(0).collect::<Vec<_>>(), [Presses::NONE]);
        let two = Presses::one(0).and(Presses::one(2));
        assert_eq!(two.numbers().collect::<Vec<_>>(), [0, 2]);
        assert!(
            two.has(2)
                && !two.has(1)
                && two.count() == 2
                && two.either(two).is_none()
                && two.common(Presses::one(2)) == Presses::one(2)
        );
        assert_eq!(Presses::all(3).nth(two.index()), Some(two));
        assert_eq!(Presses::all(Presses::MOST).count(), 64);
        assert_eq!(Presses::from_index(64), None);
        assert_eq!(two.to_string(), "+press1+press3");
    }
}
