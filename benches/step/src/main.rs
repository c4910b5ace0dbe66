//! Prints the tables of docs/performance.md: instructions counted by valgrind, times, and sizes from the
//! symbols of this very program. With LuaJIT in the place of Lua 5.4 it prints times alone.

mod instructions;
mod sizes;
mod table;
mod times;

use native::motion::Motion;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [entrant, motion, cycles] = arguments.as_slice() {
        return instructions::run(entrant, motion, cycles.parse()?);
    }
    let times: Vec<_> = Motion::ALL.into_iter().map(times::measure).collect();
    println!("Nanoseconds of a control cycle, the least measured\n");
    table::print(&Motion::ALL, |name, motion| {
        times[motion as usize].get(name).copied()
    });
    if cfg!(feature = "luajit") {
        return Ok(());
    }
    println!("\nInstructions of a control cycle\n");
    table::print(&Motion::ALL, instructions::count);
    println!("\nBytes of machine code for each step\n");
    table::print(&Motion::ALL, sizes::code);
    println!("\nBytes of state\n");
    table::print(&Motion::ALL, sizes::state);
    Ok(())
}
