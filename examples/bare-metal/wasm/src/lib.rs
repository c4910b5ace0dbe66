//! The programs as a WebAssembly module: its host gives one function and calls one.
#![no_std]

use core::fmt::{self, Write};
use core::panic::PanicInfo;

#[link(wasm_import_module = "host")]
unsafe extern "C" {
    /// The host writes `length` bytes from `text`.
    fn write(text: *const u8, length: usize);
}

struct Host;

impl Write for Host {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        // SAFETY: the host only reads the text, and before it returns.
        unsafe { write(text.as_ptr(), text.len()) };
        Ok(())
    }
}

/// Writes the traces. Returns 1 if all programs ended themselves, and the walk with mass and the tripod went on, else 0.
#[unsafe(no_mangle)]
pub extern "C" fn run() -> u32 {
    let steered = robots::hexapod().is_ok_and(|mut robot| robots::steer(&mut robot, &mut Host));
    let walked = robots::walker().is_ok_and(|mut robot| robots::run(&mut robot, &mut Host));
    let grasped = robots::hand().is_ok_and(|mut robot| robots::run(&mut robot, &mut Host));
    let threaded = robots::threaded().is_ok_and(|mut robot| robots::run(&mut robot, &mut Host));
    let swung = robots::heavy_walker().is_ok_and(|mut robot| robots::begin(&mut robot, &mut Host));
    u32::from(walked && grasped && threaded && swung && steered)
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
