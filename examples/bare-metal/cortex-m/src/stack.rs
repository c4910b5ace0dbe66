//! Stack depth: free memory is filled with a pattern, and overwritten words were used.

use core::ptr;

/// No value that programs write often.
const PAINT: u32 = 0xCCCC_CCCC;

/// Bytes below the stack pointer that stay as they are: the compiler may read the pointer before the
/// function that paints has saved its registers.
const ROOM: usize = 128;

unsafe extern "C" {
    /// The lowest word of the stack: the linker script defines it.
    static mut _stack_end: u32;
    /// The word after the highest.
    static mut _stack_start: u32;
}

/// Bytes in use now; what is free is painted.
#[inline(never)]
pub(crate) fn paint() -> usize {
    let mut word = &raw mut _stack_end;
    let here: *mut u32 = ptr::with_exposed_provenance_mut(cortex_m::register::msp::read() as usize);
    while word < here.wrapping_byte_sub(ROOM) {
        // SAFETY: so far below the stack pointer memory belongs to no one.
        unsafe { word.write_volatile(PAINT) };
        word = word.wrapping_add(1);
    }
    depth(here)
}

/// The most bytes that were in use since the last call of [`paint`].
pub(crate) fn deepest() -> usize {
    let mut word = &raw mut _stack_end;
    // SAFETY: the stack ends above the words that were painted, so that the loop ends within it.
    while unsafe { word.read_volatile() } == PAINT {
        word = word.wrapping_add(1);
    }
    depth(word)
}

fn depth(word: *mut u32) -> usize {
    (&raw mut _stack_start).addr() - word.addr()
}
