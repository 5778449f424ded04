//! How much work a thread does from one look at whether it has to end to the next: counted where tests are built, and nowhere else.
//!
//! A loop that never looks ends no scan within a second, and nobody sees it until somebody presses Ctrl-C at that moment. So whatever may be
//! done millions of times counts itself here, and a thread that once looked may not do more than [`MOST`] before it looks again: any test
//! that comes by such a loop fails. Work is counted in what takes about 10 ns: a capsule's distance from a line, a corner of a hull that is
//! looked at, a few cells of the floor.

#[cfg(metered)]
use std::cell::Cell;

/// Some ten milliseconds of work.
#[cfg(metered)]
pub(crate) const MOST: u64 = 2_000_000;

#[cfg(metered)]
thread_local! {
    /// Work since this thread last looked; nothing as long as it never did.
    static SINCE: Cell<Option<u64>> = const { Cell::new(None) };
}

/// So much was done.
#[inline]
pub fn count_work(units: usize) {
    #[cfg(metered)]
    SINCE.with(|since| {
        if let Some(before) = since.get() {
            let now = before + units as u64;
            since.set(Some(now));
            assert!(now <= MOST, "{now} units of work since anybody looked whether it is time to end");
        }
    });
    #[cfg(not(metered))]
    let _ = units;
}

/// This thread looks.
#[inline]
pub(super) fn looked() {
    #[cfg(metered)]
    SINCE.with(|since| since.set(Some(0)));
}

#[cfg(all(test, metered))]
mod tests {
    use super::*;

    /// What all other tests rest on that come by long loops.
    #[test]
    #[should_panic(expected = "units of work since anybody looked")]
    fn who_works_too_long_without_looking_is_stopped() {
        // Nobody waits for a thread that never looks.
        count_work(3 * usize::try_from(MOST).unwrap());
        for _ in 0..3 {
            looked();
            count_work(usize::try_from(MOST).unwrap());
        }
        count_work(1);
    }
}
