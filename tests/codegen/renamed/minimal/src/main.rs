//! The smallest controller: one program, one robot.
#![deny(warnings)]

use tip_runtime::machine::{Machine, Status};
use tip_runtime::program::End;

tip_macros::tip!(Rise, "3.1\n\nSTAND_UP 50\nSIT_DOWN 50\nEND\n");

fn main() {
    let mut machine = Machine::simulated(Rise::new());
    while machine.cycle().is_running() {}
    assert_eq!(machine.status(), Status::Finished(End::End));
}
