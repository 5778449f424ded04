//! Floating-point mode: some FMUs leave another rounding mode behind, which would change every number after them.
#![expect(unsafe_code, reason = "sets a register of the processor")]

/// Round to nearest, no trap, subnormal numbers kept: the mode in which programs start and Rust computes.
pub(super) fn restore() {
    #[cfg(target_arch = "x86_64")]
    {
        // MXCSR as the x86-64 psABI (section 3.2.1) has it at the start of a process.
        let mode: u32 = 0x1f80;
        // SAFETY: reads four bytes that live here, and gives the register the only value Rust code may run with.
        unsafe { std::arch::asm!("ldmxcsr [{}]", in(reg) &raw const mode, options(nostack, readonly)) };
    }
    #[cfg(target_arch = "aarch64")]
    {
        // SAFETY: gives the register the only value Rust code may run with.
        unsafe { std::arch::asm!("msr fpcr, {}", in(reg) 0_u64, options(nostack, nomem)) };
    }
}
