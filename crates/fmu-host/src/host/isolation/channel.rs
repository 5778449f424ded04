//! Memory that two processes share, one of which asks and one of which answers, with a futex to sleep on.
//!
//! One question is under way at a time. Whoever has the turn writes its area and then raises a counter; the other side
//! reads the area only after it has seen the counter. What the answering side wrote is bytes from a stranger: it is
//! copied out first and decoded then.
#![expect(unsafe_code, reason = "maps shared memory and copies bytes out of it and into it")]

use std::fs::File;
use std::io;
use std::os::fd::{AsFd, OwnedFd};
use std::ptr::{self, NonNull};
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};
use std::time::Duration;

use rustix::fs::{MemfdFlags, SealFlags, fcntl_add_seals, ftruncate, memfd_create};
use rustix::mm::{MapFlags, ProtFlags, mmap, munmap};
use rustix::thread::futex;

/// Bytes of one area: the longest message.
pub(super) const AREA: usize = 8 << 20;
/// Bytes before the areas.
const HEAD: usize = 64 << 10;
const SIZE: usize = HEAD + 2 * AREA;
/// Most processes that can be parked as saved states.
pub(super) const SLOTS: usize = 8192;

/// What a parked process is to do: nothing yet, or begin to live; anything else: go.
pub(super) const PARKED: u32 = 0;
pub(super) const LIVE: u32 = 1;
/// What a parked process is told that nobody needs any more.
pub(super) const GO: u32 = 2;
/// What it answers to that, as the last thing it does: until then its place is its own.
pub(super) const GONE: u32 = 3;

/// What both sides read and write at any time.
#[repr(C)]
pub(super) struct Head {
    /// Questions asked so far; the answering side sleeps on it.
    asked: AtomicU32,
    /// Bytes of the question.
    question: AtomicU32,
    /// Answers given so far.
    answered: AtomicU32,
    /// Bytes of the answer.
    answer: AtomicU32,
    /// Raised with every answer and every death; the asking side sleeps on it.
    bell: AtomicU32,
    /// The process that answers.
    pub(super) alive: AtomicU32,
    /// How the answering process ended, see [`super::process::ProcessEnd`]; 0 while it lives.
    pub(super) death: AtomicU32,
    /// The call that the answering process is in, see [`crate::host::activity::Activity`].
    pub(super) activity: AtomicU64,
    /// What each parked process is to do.
    slots: [AtomicU32; SLOTS],
}

/// One side of the shared memory. The memory stays the same over a fork.
pub(super) struct Channel {
    memory: NonNull<u8>,
}

// SAFETY: the memory is shared between processes anyway; the head is atomics, the areas are used by turns.
unsafe impl Send for Channel {}

impl Head {
    /// Where the parked process of this number looks for what it is to do.
    pub(super) fn slot(&self, number: u32) -> Option<&AtomicU32> {
        self.slots.get(usize::try_from(number).ok()?)
    }

    /// Tells a parked process what to do.
    pub(super) fn tell(&self, number: u32, what: u32) {
        if let Some(slot) = self.slot(number) {
            slot.store(what, Ordering::Release);
            let _ = futex::wake(slot, futex::Flags::empty(), u32::MAX);
        }
    }
}

impl Channel {
    /// Fresh memory and the file that another process maps it from.
    pub(super) fn create() -> io::Result<(Self, OwnedFd)> {
        let file = memfd_create("fmi-hazard", MemfdFlags::CLOEXEC | MemfdFlags::ALLOW_SEALING)?;
        ftruncate(&file, SIZE as u64)?;
        // Nobody can make it smaller under the feet of the other side.
        fcntl_add_seals(&file, SealFlags::SHRINK | SealFlags::GROW | SealFlags::SEAL)?;
        Ok((Self::map(&file)?, file))
    }

    /// The memory behind `file`, which another process created.
    pub(super) fn open(file: File) -> io::Result<Self> {
        if file.metadata()?.len() != SIZE as u64 {
            return Err(io::Error::other("this is not the shared memory of a worker"));
        }
        Self::map(&file)
    }

    fn map(file: &impl AsFd) -> io::Result<Self> {
        // SAFETY: a new mapping at a place the system chooses; nothing else is there.
        let memory =
            unsafe { mmap(ptr::null_mut(), SIZE, ProtFlags::READ | ProtFlags::WRITE, MapFlags::SHARED, file, 0)? };
        NonNull::new(memory.cast()).map(|memory| Self { memory }).ok_or_else(|| io::Error::other("no memory"))
    }

    /// The counters.
    pub(super) const fn head(&self) -> &Head {
        // SAFETY: the mapping is page-aligned, longer than a head and zeroed at first, which is a valid head; it lives as
        // long as `self`, and a head is only atomics.
        unsafe { self.memory.cast::<Head>().as_ref() }
    }

    /// Writes a question and wakes the other side. Returns its number.
    pub(super) fn ask(&self, message: &[u8]) -> u32 {
        let head = self.head();
        let length = self.put(HEAD, message);
        head.question.store(length, Ordering::Relaxed);
        let number = head.asked.load(Ordering::Relaxed).wrapping_add(1);
        head.asked.store(number, Ordering::Release);
        let _ = futex::wake(&head.asked, futex::Flags::empty(), u32::MAX);
        number
    }

    /// Waits for the question after number `last`.
    pub(super) fn next_question(&self, last: u32) -> (u32, Vec<u8>) {
        let head = self.head();
        loop {
            let asked = head.asked.load(Ordering::Acquire);
            if asked != last {
                return (asked, self.take(HEAD, head.question.load(Ordering::Relaxed)));
            }
            let _ = futex::wait(&head.asked, futex::Flags::empty(), asked, None);
        }
    }

    /// Number of the last question.
    pub(super) fn asked(&self) -> u32 {
        self.head().asked.load(Ordering::Acquire)
    }

    /// Gives the answer to question `number`.
    pub(super) fn answer(&self, number: u32, message: &[u8]) {
        let head = self.head();
        let length = self.put(HEAD + AREA, message);
        head.answer.store(length, Ordering::Relaxed);
        head.answered.store(number, Ordering::Release);
        self.ring();
    }

    /// The answer to question `number`, if it is there.
    pub(super) fn answer_to(&self, number: u32) -> Option<Vec<u8>> {
        let head = self.head();
        (head.answered.load(Ordering::Acquire) == number)
            .then(|| self.take(HEAD + AREA, head.answer.load(Ordering::Relaxed)))
    }

    /// Wakes the asking side.
    pub(super) fn ring(&self) {
        let bell = &self.head().bell;
        bell.fetch_add(1, Ordering::Release);
        let _ = futex::wake(bell, futex::Flags::empty(), u32::MAX);
    }

    /// How often the bell was rung.
    pub(super) fn times_rung(&self) -> u32 {
        self.head().bell.load(Ordering::Acquire)
    }

    /// Sleeps until the bell rings again after it had rung `rung` times, or this time is over.
    pub(super) fn sleep(&self, rung: u32, at_most: Duration) {
        let time = futex::Timespec { tv_sec: 0, tv_nsec: i64::from(at_most.subsec_nanos()) };
        let _ = futex::wait(&self.head().bell, futex::Flags::empty(), rung, Some(&time));
    }

    fn put(&self, at: usize, message: &[u8]) -> u32 {
        let length = message.len().min(AREA);
        // SAFETY: `at` is the beginning of an area and the length at most that of an area; the other side does not use
        // this area while this side has the turn, and Rust holds no reference into it.
        unsafe { ptr::copy_nonoverlapping(message.as_ptr(), self.memory.as_ptr().add(at), length) };
        u32::try_from(length).unwrap_or(0)
    }

    fn take(&self, at: usize, length: u32) -> Vec<u8> {
        let length = usize::try_from(length).unwrap_or(0).min(AREA);
        let mut message = vec![0; length];
        // SAFETY: as in `put`; should a misbehaving process write at the same time, the bytes are nonsense and nothing
        // else.
        unsafe { ptr::copy_nonoverlapping(self.memory.as_ptr().add(at), message.as_mut_ptr(), length) };
        message
    }
}

impl Drop for Channel {
    fn drop(&mut self) {
        // SAFETY: what `map` mapped, unmapped once; references into it are bound to `self`.
        let _ = unsafe { munmap(self.memory.as_ptr().cast(), SIZE) };
    }
}

const _: () = assert!(size_of::<Head>() <= HEAD);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn questions_and_answers_by_turns() {
        let (asking, file) = Channel::create().unwrap();
        let answering = Channel::open(File::from(file)).unwrap();
        let server = std::thread::spawn(move || {
            let mut last = 0;
            for _ in 0..1000 {
                let (number, question) = answering.next_question(last);
                answering.answer(number, &question.iter().rev().copied().collect::<Vec<u8>>());
                last = number;
            }
        });
        for i in 0..1000_u32 {
            let number = asking.ask(&i.to_le_bytes());
            let answer = loop {
                let rung = asking.times_rung();
                if let Some(answer) = asking.answer_to(number) {
                    break answer;
                }
                asking.sleep(rung, Duration::from_millis(100));
            };
            assert_eq!(answer, i.to_be_bytes());
        }
        server.join().unwrap();
    }

    #[test]
    fn other_files_are_not_mapped() {
        assert!(Channel::open(tempfile::tempfile().unwrap()).is_err());
    }
}
