//! Runs the programs on a Cortex-M4. Their traces go to the debugger's standard output; their bytes of
//! memory, and the time that a cycle of a gait takes, go to its standard error.
#![no_std]
#![no_main]

mod stack;

use core::fmt::Write;
use core::mem::size_of;
use core::panic::PanicInfo;
use cortex_m::Peripherals;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::{ExceptionFrame, entry, exception};
use cortex_m_semihosting::debug::{self, EXIT_FAILURE, EXIT_SUCCESS};
use cortex_m_semihosting::hio::{self, HostStream};
use tip_runtime::hardware::Hardware;
use tip_runtime::machine::{Machine, Mismatch};
use tip_runtime::program::Program;
use tip_runtime::special::Special;

#[entry]
fn main() -> ! {
    debug::exit(match run() {
        Some(true) => EXIT_SUCCESS,
        _ => EXIT_FAILURE,
    });
    loop {
        cortex_m::asm::wfi();
    }
}

/// Returns true if all programs ended themselves, and the walk with mass and the tripod went on; `None` if that is not known.
fn run() -> Option<bool> {
    let mut trace = hio::hstdout().ok()?;
    let mut report = hio::hstderr().ok()?;
    let (trace, report) = (&mut trace, &mut report);
    let steered = measure("tripod", robots::hexapod, robots::steer, trace, report)?;
    time_cycles(report)?;
    let walked = measure("walk", robots::walker, robots::run, trace, report)?;
    let grasped = measure("grasp", robots::hand, robots::run, trace, report)?;
    let threaded = measure("threads", robots::threaded, robots::run, trace, report)?;
    let swung = measure(
        "walk with mass",
        robots::heavy_walker,
        robots::begin,
        trace,
        report,
    )?;
    Some(walked && grasped && threaded && swung && steered)
}

/// Runs one program, and reports its bytes of memory.
#[inline(never)]
fn measure<P: Program, H: Hardware<L, J>, S: Special, const L: usize, const J: usize>(
    name: &str,
    make: fn() -> Result<Machine<P, H, L, J, (), S>, Mismatch>,
    run: fn(&mut Machine<P, H, L, J, (), S>, &mut HostStream) -> bool,
    trace: &mut HostStream,
    report: &mut HostStream,
) -> Option<bool> {
    let before = stack::paint();
    // Used where it is: a move would need the room of a second machine.
    let mut made = make();
    let robot = made.as_mut().ok()?;
    let making = stack::deepest().checked_sub(before)?;
    let before = stack::paint();
    let ended = run(robot, trace);
    let cycle = stack::deepest().checked_sub(before)?;
    let (program, machine) = (size_of::<P>(), size_of_val(robot));
    let plant = size_of::<H>();
    writeln!(
        report,
        "{name}: program {program}, plant {plant}, machine with both {machine}; \
         stack of making it {making}, of its deepest cycle {cycle}"
    )
    .ok()?;
    Some(ended)
}

/// Reports the ticks of the system timer that cycles of the tripod take, on average and at most. `None` if that cannot be known.
#[inline(never)]
fn time_cycles(report: &mut HostStream) -> Option<()> {
    /// The timer counts down from here, again and again.
    const TOP: u32 = 0x00FF_FFFF;
    const CYCLES: u32 = 250;
    let mut timer = Peripherals::take()?.SYST;
    timer.set_clock_source(SystClkSource::Core);
    timer.set_reload(TOP);
    timer.clear_current();
    timer.enable_counter();
    let mut made = robots::hexapod();
    let robot = made.as_mut().ok()?;
    robot.key(b'W');
    let (mut sum, mut most) = (0_u32, 0);
    for _ in 0..CYCLES {
        let before = SYST::get_current();
        robot.cycle();
        let ticks = before.wrapping_sub(SYST::get_current()) & TOP;
        (sum, most) = (sum.wrapping_add(ticks), ticks.max(most));
    }
    let mean = sum / CYCLES;
    writeln!(report, "tripod: ticks of a cycle {mean}, at most {most}").ok()
}

/// Handler of a stack overflow, among others.
#[exception]
unsafe fn HardFault(_: &ExceptionFrame) -> ! {
    debug::exit(EXIT_FAILURE);
    cortex_m::asm::udf()
}

/// Every program needs one; the script beside this package looks that none of its callers is left.
#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    cortex_m::asm::udf()
}
