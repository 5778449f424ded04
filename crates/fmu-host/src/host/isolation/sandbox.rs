//! What a worker must not do, enforced by the kernel: Landlock for files, network and signals, seccomp for system calls.
//!
//! The rules are for the live process and all copies of it, before any code of an FMU is loaded. What the kernel of this
//! machine does not offer is told, so that the user knows.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use landlock::{
    ABI, Access as _, AccessFs, AccessNet, BitFlags, CompatLevel, Compatible as _, PathBeneath, PathFd, Ruleset,
    RulesetAttr as _, RulesetCreatedAttr as _, RulesetStatus, Scope,
};
use seccompiler::{
    BpfProgram, SeccompAction, SeccompCmpArgLen, SeccompCmpOp, SeccompCondition, SeccompFilter, SeccompRule,
};
use serde::{Deserialize, Serialize};

/// What a worker may do.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Rules {
    /// Folders that may be read.
    pub read: Vec<PathBuf>,
    /// Folders that may be written.
    pub write: Vec<PathBuf>,
    /// Whether the process may copy itself.
    pub fork: bool,
}

/// Where libraries and what they read lie. Nothing in there is private.
const SYSTEM: [&str; 14] = [
    "/lib",
    "/lib32",
    "/lib64",
    "/usr/lib",
    "/usr/lib32",
    "/usr/lib64",
    "/usr/local/lib",
    "/usr/share/zoneinfo",
    "/etc/ld.so.cache",
    "/etc/localtime",
    "/dev/null",
    "/dev/zero",
    "/dev/urandom",
    "/proc/self",
];

/// Confines this process. Returns what of it the kernel does not offer.
pub(super) fn enter(rules: &Rules) -> Result<Vec<String>, String> {
    let mut missing = files_and_network(rules).map_err(|e| e.to_string())?;
    match system_calls(rules) {
        Ok(()) => {}
        Err(error) => missing.push(format!("system calls are not filtered ({error})")),
    }
    Ok(missing)
}

fn files_and_network(rules: &Rules) -> Result<Vec<String>, landlock::RulesetError> {
    let abi = ABI::V6;
    let read = AccessFs::from_read(abi);
    let mut ruleset = Ruleset::default()
        .set_compatibility(CompatLevel::BestEffort)
        .handle_access(AccessFs::from_all(abi))?
        .handle_access(AccessNet::from_all(abi))?
        .scope(Scope::from_all(abi))?
        .create()?;
    let system = SYSTEM.iter().map(|path| (Path::new(path), read));
    let own = rules.read.iter().map(|path| (path.as_path(), read));
    let write = rules.write.iter().map(|path| (path.as_path(), AccessFs::from_all(abi)));
    for (path, access) in system.chain(own).chain(write) {
        // What is not there needs no rule.
        let Ok(file) = PathFd::new(path) else { continue };
        let access: BitFlags<AccessFs> = if path.is_dir() { access } else { access & AccessFs::from_file(abi) };
        ruleset = ruleset.add_rule(PathBeneath::new(file, access))?;
    }
    let status = ruleset.restrict_self()?;
    Ok(match status.ruleset {
        RulesetStatus::FullyEnforced => Vec::new(),
        RulesetStatus::PartiallyEnforced => {
            vec!["this kernel's Landlock is an older one: some of network and signals is not covered by it".to_owned()]
        }
        RulesetStatus::NotEnforced => vec!["this kernel has no Landlock: files can be read and written".to_owned()],
    })
}

/// System calls that fail with "operation not permitted".
const REFUSED: [libc::c_long; 26] = [
    libc::SYS_execve,
    libc::SYS_execveat,
    libc::SYS_socket,
    libc::SYS_socketpair,
    libc::SYS_connect,
    libc::SYS_bind,
    libc::SYS_listen,
    libc::SYS_kill,
    libc::SYS_rt_sigqueueinfo,
    libc::SYS_rt_tgsigqueueinfo,
    libc::SYS_pidfd_send_signal,
    libc::SYS_pidfd_getfd,
    libc::SYS_ptrace,
    libc::SYS_process_vm_readv,
    libc::SYS_process_vm_writev,
    libc::SYS_setsid,
    libc::SYS_setpgid,
    libc::SYS_mount,
    libc::SYS_umount2,
    libc::SYS_unshare,
    libc::SYS_setns,
    libc::SYS_bpf,
    libc::SYS_io_uring_setup,
    libc::SYS_perf_event_open,
    libc::SYS_keyctl,
    libc::SYS_shmget,
];

fn system_calls(rules: &Rules) -> Result<(), Box<dyn std::error::Error>> {
    let arch = std::env::consts::ARCH.try_into()?;
    let filter =
        |calls: BTreeMap<i64, Vec<SeccompRule>>, error: i32| -> Result<BpfProgram, seccompiler::BackendError> {
            let action = SeccompAction::Errno(u32::try_from(error).unwrap_or(1));
            SeccompFilter::new(calls, SeccompAction::Allow, action, arch)?.try_into()
        };
    let mut refused: BTreeMap<i64, Vec<SeccompRule>> = REFUSED.iter().map(|call| (*call, Vec::new())).collect();
    if !rules.fork {
        // Threads are welcome, other processes are not. The C library falls back to `clone`, whose flags can be seen
        // here, when there is no `clone3`.
        let threads = libc::CLONE_THREAD as u64;
        let not_a_thread = SeccompCondition::new(0, SeccompCmpArgLen::Qword, SeccompCmpOp::MaskedEq(threads), 0)?;
        refused.insert(libc::SYS_clone, vec![SeccompRule::new(vec![not_a_thread])?]);
        #[cfg(target_arch = "x86_64")]
        refused.extend([(libc::SYS_fork, Vec::new()), (libc::SYS_vfork, Vec::new())]);
        let absent = BTreeMap::from([(libc::SYS_clone3, Vec::new())]);
        seccompiler::apply_filter(&filter(absent, libc::ENOSYS)?)?;
    }
    seccompiler::apply_filter(&filter(refused, libc::EPERM)?)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Landlock is about the thread that asks for it: this one stays free.
    #[test]
    fn what_may_be_read_may_not_be_written() {
        let dir = tempfile::tempdir().unwrap();
        let folders = ["read", "write", "neither"].map(|name| dir.path().join(name));
        for folder in &folders {
            std::fs::create_dir(folder).unwrap();
            std::fs::write(folder.join("old"), "old").unwrap();
        }
        let rules = Rules { read: vec![folders[0].clone()], write: vec![folders[1].clone()], fork: false };
        let tried = std::thread::spawn(move || {
            let missing = files_and_network(&rules).unwrap();
            let done = folders.map(|folder| {
                let reads = std::fs::read(folder.join("old")).is_ok();
                let writes = ["old", "new"].map(|name| std::fs::write(folder.join(name), "new").is_ok());
                (reads, writes)
            });
            (missing, done)
        });
        let (missing, done) = tried.join().unwrap();
        if let Some(lacks) = missing.iter().find(|missing| missing.contains("has no Landlock")) {
            println!("NOT TESTED on this machine: {lacks}");
            return;
        }
        assert_eq!(done, [(true, [false; 2]), (true, [true; 2]), (false, [false; 2])]);
    }
}
