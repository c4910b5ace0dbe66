//! Start and end of the process, and its system calls.

use core::arch::{asm, naked_asm};
use core::fmt;
use core::panic::PanicInfo;

/// The kernel jumps here with an aligned stack; a function expects one that a call has pushed to.
#[cfg(target_arch = "x86_64")]
#[unsafe(naked)]
#[unsafe(no_mangle)]
unsafe extern "C" fn _start() -> ! {
    naked_asm!("xor ebp, ebp", "call {main}", "ud2", main = sym main)
}

#[cfg(target_arch = "aarch64")]
#[unsafe(naked)]
#[unsafe(no_mangle)]
unsafe extern "C" fn _start() -> ! {
    naked_asm!("mov x29, #0", "mov x30, #0", "b {main}", main = sym main)
}

extern "C" fn main() -> ! {
    exit(crate::run())
}

#[cfg(target_arch = "x86_64")]
fn exit(status: u8) -> ! {
    // SAFETY: exit_group (231) takes one number and does not come back.
    unsafe {
        asm!("syscall", in("rax") 231, in("rdi") u64::from(status), options(noreturn));
    }
}

#[cfg(target_arch = "aarch64")]
fn exit(status: u8) -> ! {
    // SAFETY: exit_group (94) takes one number and does not come back.
    unsafe {
        asm!("svc 0", in("x8") 94, in("x0") u64::from(status), options(noreturn));
    }
}

/// Standard output.
pub(crate) struct Output;

impl fmt::Write for Output {
    fn write_str(&mut self, mut text: &str) -> fmt::Result {
        while !text.is_empty() {
            let written = usize::try_from(write(text)).map_err(|_| fmt::Error)?;
            text = text.get(written..).ok_or(fmt::Error)?;
        }
        Ok(())
    }
}

/// Returns the number of bytes written, or a negative error.
#[cfg(target_arch = "x86_64")]
fn write(text: &str) -> isize {
    let mut result = 1;
    // SAFETY: write (1) to standard output (1) only reads the text; the kernel clobbers rcx and r11.
    unsafe {
        asm!("syscall", inout("rax") result, in("rdi") 1, in("rsi") text.as_ptr(), in("rdx") text.len(),
             out("rcx") _, out("r11") _, options(nostack));
    }
    result
}

#[cfg(target_arch = "aarch64")]
fn write(text: &str) -> isize {
    let mut result = 1;
    // SAFETY: write (64) to standard output (1) only reads the text.
    unsafe {
        asm!("svc 0", in("x8") 64, inout("x0") result, in("x1") text.as_ptr(), in("x2") text.len(),
             options(nostack));
    }
    result
}

unsafe extern "C" {
    /// Nobody defines it: the link fails if the panic handler can be reached.
    safe fn a_panic_path_is_left() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    a_panic_path_is_left()
}
