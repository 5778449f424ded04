//! How far a search got, and what of the floor it did not look at to the end: all on which nobody was found to be hit, unless everything
//! that sensors may report was followed.

use std::collections::BTreeSet;

use super::map::{Walkable, rectangles};
use crate::reachability::told_in;
use crate::record::reachability::ReachabilityResult;

/// How some of a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum End {
    /// All that was to be looked at was.
    Whole,
    /// Some was not, for a reason that is told.
    Short,
    /// It was stopped, or its time was up.
    Stopped,
}

impl End {
    /// How both together did.
    pub(crate) fn and(self, other: Self) -> Self {
        self.max(other)
    }
}

/// What was not looked at to the end, where a search ended so. What was done is done for some of what sensors report only, so of no floor
/// it is known that nobody is hit there. Gives that in words.
pub(super) fn not_looked_at(found: &mut ReachabilityResult, walkable: &Walkable, end: End) -> Option<String> {
    if end == End::Whole {
        return None;
    }
    let hit: BTreeSet<[i64; 2]> = found.floor.iter().map(|cell| told_in(cell.xy_m)).collect();
    let left: BTreeSet<[i64; 2]> = walkable.cells.difference(&hit).copied().collect();
    found.not_looked_at = left.len();
    found.not_looked_at_m = [rectangles(&left), walkable.beyond_m.clone()].concat();
    let cells = found.not_looked_at;
    (cells > 0).then(|| {
        let were = if cells == 1 { "cell of the floor was" } else { "cells of the floor were" };
        format!("{cells} {were} not looked at to the end: whether anybody is hit there is not known")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn together_they_got_as_far_as_the_one_that_got_least_far() {
        use End::{Short, Stopped, Whole};
        assert_eq!([Whole.and(Whole), Whole.and(Short), Short.and(Whole)], [Whole, Short, Short]);
        assert_eq!([Short.and(Stopped), Stopped.and(Whole)], [Stopped, Stopped]);
    }
}
