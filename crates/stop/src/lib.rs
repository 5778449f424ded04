//! When work has to end: because somebody asked for it, or because its time is up.
//!
//! A [`Stop`] is handed down to whatever may take long: arm searches and calls of FMUs look at it while they are under way.
//! What they had not finished is thrown away, so nothing half done is ever taken for a result. Work has two parts: the
//! search, and what follows it (confirming what was found, writing it); the second has a little time of its own.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

mod meter;

pub use meter::count_work;

/// What is left to do after somebody asked may take this long.
const GRACE: Duration = Duration::from_millis(800);

/// Of the time for all, this part is for what follows the search, and at least and at most so much.
const SHARE: u32 = 10;
const RESERVE: [Duration; 2] = [Duration::from_millis(500), Duration::from_secs(15)];

/// Says when work has to end. Clones say the same.
#[derive(Clone, Debug)]
pub struct Stop(Arc<Inner>);

#[derive(Debug)]
struct Inner {
    base: Instant,
    /// Nanoseconds after `base` at which the search ends, and at which everything does.
    search: AtomicU64,
    all: AtomicU64,
    /// Somebody asked.
    asked: AtomicBool,
    /// The search is over.
    finishing: AtomicBool,
}

impl Default for Stop {
    /// Never, until somebody asks.
    fn default() -> Self {
        Self(Arc::new(Inner {
            base: Instant::now(),
            search: AtomicU64::new(u64::MAX),
            all: AtomicU64::new(u64::MAX),
            asked: AtomicBool::new(false),
            finishing: AtomicBool::new(false),
        }))
    }
}

impl PartialEq for Stop {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for Stop {}

impl Stop {
    fn now(&self) -> u64 {
        u64::try_from(self.0.base.elapsed().as_nanos()).unwrap_or(u64::MAX)
    }

    /// The search ends now, and everything soon.
    pub fn ask(&self) {
        // First, so that a time limit that is set just now is cut short by whoever of the two comes last.
        self.0.asked.store(true, Ordering::SeqCst);
        let now = self.now();
        let grace = u64::try_from(GRACE.as_nanos()).unwrap_or(u64::MAX);
        self.0.search.fetch_min(now, Ordering::SeqCst);
        self.0.all.fetch_min(now.saturating_add(grace), Ordering::SeqCst);
    }

    /// From now on a search may take so long, with what follows it.
    pub fn within(&self, time: Duration) {
        let reserve = (time / SHARE).clamp(RESERVE[0], RESERVE[1]);
        let now = self.now();
        let after = |time: Duration| now.saturating_add(u64::try_from(time.as_nanos()).unwrap_or(u64::MAX));
        self.0.search.store(after(time.saturating_sub(reserve)), Ordering::SeqCst);
        self.0.all.store(after(time), Ordering::SeqCst);
        if self.is_asked() {
            self.ask();
        }
    }

    /// A search begins.
    pub fn searching(&self) {
        self.0.finishing.store(false, Ordering::Release);
    }

    /// The search is over; what was found is looked at once more.
    pub fn finishing(&self) {
        self.0.finishing.store(true, Ordering::Release);
    }

    /// Whether somebody asked.
    #[must_use]
    pub fn is_asked(&self) -> bool {
        self.0.asked.load(Ordering::SeqCst)
    }

    /// Whether the search has to end.
    #[must_use]
    pub fn ends_search(&self) -> bool {
        meter::looked();
        let end = self.0.search.load(Ordering::Relaxed);
        end != u64::MAX && self.now() >= end
    }

    /// Whether whatever is under way has to end.
    #[must_use]
    pub fn is_due(&self) -> bool {
        meter::looked();
        let end = if self.0.finishing.load(Ordering::Acquire) { &self.0.all } else { &self.0.search };
        let end = end.load(Ordering::Relaxed);
        end != u64::MAX && self.now() >= end
    }

    /// Time that the search has left, if its time is limited.
    #[must_use]
    pub fn left(&self) -> Option<Duration> {
        let end = self.0.search.load(Ordering::Relaxed);
        (end != u64::MAX).then(|| Duration::from_nanos(end.saturating_sub(self.now())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_asks_ends_the_search_at_once_and_the_rest_soon() {
        let stop = Stop::default();
        let other = stop.clone();
        assert!(!stop.is_due() && !stop.ends_search() && stop.left().is_none());
        other.ask();
        assert!(stop.is_due() && stop.ends_search() && stop.is_asked());
        stop.finishing();
        assert!(!stop.is_due(), "what was found may be confirmed");
        std::thread::sleep(GRACE);
        assert!(stop.is_due());
    }

    #[test]
    fn time_is_kept_back_for_what_follows_the_search() {
        let stop = Stop::default();
        stop.within(Duration::from_secs(100));
        assert!(!stop.is_due() && !stop.is_asked());
        let left = stop.left().unwrap();
        assert!(left <= Duration::from_secs(90) && left > Duration::from_secs(80), "{left:?}");
        stop.within(Duration::from_millis(500));
        assert!(stop.is_due() && !stop.is_asked(), "nothing is left but the reserve");
        stop.finishing();
        assert!(!stop.is_due());
        // A new limit does not make anybody forget that somebody asked.
        stop.ask();
        stop.within(Duration::from_secs(100));
        assert!(stop.ends_search());
    }
}
