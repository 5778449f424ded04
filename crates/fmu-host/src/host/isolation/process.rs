//! The few system calls with which a worker's processes are made and watched.
//!
//! A worker is a small family: the *keeper*, which runs nothing of the FMU, and its children: the *live* process, which
//! does, and parked copies of it. Whoever of the family loses its parent becomes a child of the keeper, so the keeper
//! sees how each one ends.
#![expect(unsafe_code, reason = "fork, wait and signals have no safe form")]

use std::os::fd::{AsRawFd, BorrowedFd};
use std::{fmt, io};

/// How a process ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ProcessEnd {
    /// It left by itself, with this exit code.
    Exit(u8),
    /// This signal ended it.
    Signal(u8),
}

impl ProcessEnd {
    /// As a number that is never 0.
    pub(super) fn code(self) -> u32 {
        match self {
            Self::Exit(code) => 0x100 | u32::from(code),
            Self::Signal(signal) => 0x200 | u32::from(signal),
        }
    }

    /// Back from [`ProcessEnd::code`]; nothing for 0.
    pub(super) fn of(code: u32) -> Option<Self> {
        let low = u8::try_from(code & 0xff).unwrap_or(0);
        match code >> 8 {
            0 => None,
            1 => Some(Self::Exit(low)),
            _ => Some(Self::Signal(low)),
        }
    }
}

impl fmt::Display for ProcessEnd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (number, name) = match *self {
            Self::Exit(code) => return write!(f, "exit code {code}"),
            Self::Signal(number) => match i32::from(number) {
                libc::SIGSEGV => (number, "SIGSEGV, invalid memory access"),
                libc::SIGBUS => (number, "SIGBUS, invalid memory access"),
                libc::SIGABRT => (number, "SIGABRT, abort"),
                libc::SIGFPE => (number, "SIGFPE, arithmetic error"),
                libc::SIGILL => (number, "SIGILL, invalid instruction"),
                libc::SIGSYS => (number, "SIGSYS, forbidden system call"),
                libc::SIGKILL => (number, "SIGKILL, killed from outside"),
                libc::SIGTERM => (number, "SIGTERM"),
                libc::SIGXCPU => (number, "SIGXCPU, out of processor time"),
                _ => (number, "signal"),
            },
        };
        write!(f, "signal {number}, {name}")
    }
}

/// Which side of a fork this is.
pub(super) enum Fork {
    Parent(i32),
    Child,
}

/// Makes a copy of this process.
///
/// Only for processes with one thread: others do not survive in the copy.
pub(super) fn fork() -> io::Result<Fork> {
    // SAFETY: the processes of a worker that call this have one thread (the keeper never starts one; the live process
    // is asked before), so no lock is held by a thread that the copy lacks.
    match unsafe { libc::fork() } {
        0 => Ok(Fork::Child),
        child if child > 0 => Ok(Fork::Parent(child)),
        _ => Err(io::Error::last_os_error()),
    }
}

/// Ends this process at once, without the exit handlers an FMU may have left.
pub(super) fn leave(code: i32) -> ! {
    // SAFETY: takes no pointers and does not return.
    unsafe { libc::_exit(code) }
}

/// Waits until a child ends; nothing if there are none.
pub(super) fn wait_for_any_child() -> Option<(i32, ProcessEnd)> {
    loop {
        let mut status = 0;
        // SAFETY: `status` is a valid place for a number.
        let child = unsafe { libc::waitpid(-1, &raw mut status, 0) };
        if child < 0 {
            if io::Error::last_os_error().kind() == io::ErrorKind::Interrupted {
                continue;
            }
            return None;
        }
        if libc::WIFEXITED(status) {
            return Some((child, ProcessEnd::Exit(u8::try_from(libc::WEXITSTATUS(status)).unwrap_or(u8::MAX))));
        }
        if libc::WIFSIGNALED(status) {
            return Some((child, ProcessEnd::Signal(u8::try_from(libc::WTERMSIG(status)).unwrap_or(u8::MAX))));
        }
    }
}

/// Orphans of this process's family become its children.
pub(super) fn adopt_orphans() {
    // SAFETY: this option takes a plain number.
    let _ = unsafe { libc::prctl(libc::PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0) };
}

/// The process group of a process, if there is such a process.
pub(super) fn group_of(pid: i32) -> Option<i32> {
    // 0 would mean ourselves.
    if pid <= 0 {
        return None;
    }
    // SAFETY: takes a plain number.
    let group = unsafe { libc::getpgid(pid) };
    (group > 0).then_some(group)
}

/// Kills a process, or with a negative number its whole group.
pub(super) fn kill(pid: i32) {
    // 0 and 1 would mean ourselves and the system.
    if pid.unsigned_abs() > 1 {
        // SAFETY: takes plain numbers.
        let _ = unsafe { libc::kill(pid, libc::SIGKILL) };
    }
}

/// From now on the whole process group of this process is killed when the other end of the pipe `life` closes: when the
/// program that started the worker is gone, however it ended.
pub(super) fn die_with(life: BorrowedFd<'_>) -> io::Result<()> {
    let fd = life.as_raw_fd();
    // SAFETY: plain numbers, on a file descriptor that is open.
    let group = unsafe { libc::getpgrp() };
    for (command, argument) in
        [(libc::F_SETOWN, -group), (F_SETSIG, libc::SIGKILL), (libc::F_SETFL, libc::O_ASYNC | libc::O_NONBLOCK)]
    {
        // SAFETY: as above.
        if unsafe { libc::fcntl(fd, command, argument) } < 0 {
            return Err(io::Error::last_os_error());
        }
    }
    Ok(())
}

/// Of Linux, missing in the library: which signal tells of a file descriptor's news (fcntl(2)).
const F_SETSIG: libc::c_int = 10;

/// Number of this process.
pub(super) fn own_pid() -> u32 {
    std::process::id()
}
