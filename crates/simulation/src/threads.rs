//! Independent work on all threads, with results that do not tell which thread did what.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher as _};
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

/// What a thread takes at a time.
const BLOCK: usize = 16;

/// What `work` gives for the numbers from 0 to `count`, some of them at a time, on so many threads; in order, whichever
/// thread did it. Nothing if `go_on`, asked now and then, says no, or `work` raises its flag.
pub fn shared_out<T: Send>(
    threads: usize,
    count: usize,
    go_on: &mut dyn FnMut() -> bool,
    work: impl Fn(Range<usize>, &AtomicBool) -> T + Sync,
) -> Option<Vec<T>> {
    let (next, stopped) = (AtomicUsize::new(0), AtomicBool::new(false));
    let take = |go_on: &mut dyn FnMut() -> bool| {
        let mut done = Vec::new();
        loop {
            let from = next.fetch_add(BLOCK, Ordering::Relaxed);
            if !go_on() {
                stopped.store(true, Ordering::Relaxed);
            }
            if from >= count || stopped.load(Ordering::Relaxed) {
                return done;
            }
            done.push((from, work(from..count.min(from + BLOCK), &stopped)));
        }
    };
    let mut all: Vec<(usize, T)> = std::thread::scope(|scope| {
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(|| take(&mut || true))).collect();
        let own = take(go_on);
        let joined = others.into_iter().map(|t| t.join().unwrap_or_else(|p| std::panic::resume_unwind(p)));
        std::iter::once(own).chain(joined).flatten().collect()
    });
    all.sort_unstable_by_key(|(from, _)| *from);
    (!stopped.into_inner()).then(|| all.into_iter().map(|(_, done)| done).collect())
}

/// Parts of a [`Memo`], so that threads rarely wait for each other, and most entries of one; then it is emptied.
const PARTS: usize = 64;
const KEPT: usize = 1 << 14;

/// What follows from a key and nothing else, worked out by whichever thread comes first.
#[derive(Debug)]
pub(super) struct Memo<K, V>([Mutex<BTreeMap<K, V>>; PARTS]);

impl<K: Ord + Hash, V: Copy> Memo<K, V> {
    pub(super) fn new() -> Self {
        Self(std::array::from_fn(|_| Mutex::default()))
    }

    /// What belongs to `key`: `work` gives it if it is not known.
    pub(super) fn of(&self, key: K, work: impl FnOnce() -> V) -> V {
        let mut hash = DefaultHasher::new();
        key.hash(&mut hash);
        let part = usize::try_from(hash.finish() % PARTS as u64).unwrap_or(0);
        let lock = || self.0[part].lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = lock().get(&key) {
            return *known;
        }
        let value = work();
        let mut part = lock();
        if part.len() >= KEPT {
            part.clear();
        }
        part.insert(key, value);
        value
    }
}
