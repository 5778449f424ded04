//! Floating-point mode: some FMUs leave another rounding mode behind, which would change every number after them.
#![expect(unsafe_code, reason = "reads and sets a register of the processor")]

use std::sync::atomic::{AtomicBool, Ordering};

static CHANGED: AtomicBool = AtomicBool::new(false);

/// Round to nearest, no trap, subnormal numbers kept: the mode in which programs start and Rust computes.
pub(super) fn restore() {
    #[cfg(target_arch = "x86_64")]
    {
        // MXCSR as the x86-64 psABI (section 3.2.1) has it at the start of a process; its low six bits are flags of what
        // happened.
        let (mut found, mode) = (0_u32, 0x1f80_u32);
        // SAFETY: writes the register's four bytes to a place of four bytes.
        unsafe { std::arch::asm!("stmxcsr [{}]", in(reg) &raw mut found, options(nostack)) };
        if found & !0x3f != mode {
            CHANGED.store(true, Ordering::Relaxed);
            // SAFETY: reads four bytes that live here, and gives the register the only value Rust code may run with.
            unsafe { std::arch::asm!("ldmxcsr [{}]", in(reg) &raw const mode, options(nostack, readonly)) };
        }
    }
    #[cfg(target_arch = "aarch64")]
    {
        let found: u64;
        // SAFETY: reads a register.
        unsafe { std::arch::asm!("mrs {}, fpcr", out(reg) found, options(nostack, nomem)) };
        if found != 0 {
            CHANGED.store(true, Ordering::Relaxed);
            // SAFETY: gives the register the only value Rust code may run with.
            unsafe { std::arch::asm!("msr fpcr, {}", in(reg) 0_u64, options(nostack, nomem)) };
        }
    }
}

/// Whether it ever had to be.
pub(super) fn was_changed() -> bool {
    CHANGED.load(Ordering::Relaxed)
}
