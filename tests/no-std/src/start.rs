//! Where the process begins and ends.

use core::arch::{asm, naked_asm};
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

unsafe extern "C" {
    /// Nobody defines it: the link fails if the panic handler can be reached.
    safe fn a_panic_path_is_left() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    a_panic_path_is_left()
}
