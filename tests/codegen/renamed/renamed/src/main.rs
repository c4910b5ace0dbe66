//! The runtime under another name, re-exported by a module of this crate.
#![deny(warnings)]

mod robot {
    pub(crate) use ::motion as runtime;
}

mod direct {
    tip_macros::include_tip!(pub(crate) "count.prg" as Direct, runtime = ::motion);
}

mod indirect {
    tip_macros::include_tip!(pub(crate) "count.prg" as Indirect, runtime = crate::robot::runtime);
}

mod inline {
    tip_macros::tip!(pub(crate) Inline, "3.1\n\nDEF_VAR N\nN = 1\nN = N + 41\nEND\n", runtime = ::motion);
}

use motion::machine::{Machine, Status};
use motion::program::End;
use motion::robot::{For, Titan8};

fn main() {
    let results = [
        counted(direct::Direct::new()),
        counted(indirect::Indirect::new()),
        counted(inline::Inline::new()),
    ];
    assert_eq!(results, [Some(3.0), Some(3.0), Some(42.0)]);
}

/// Scalar 1 when the program is over (scalar 0 is VAR_KEY).
fn counted<P: For<Titan8>>(program: P) -> Option<f64> {
    let mut machine = Machine::simulated(program);
    while machine.cycle().is_running() {}
    assert_eq!(machine.status(), Status::Finished(End::End));
    machine.program().scalar(1).and_then(|(_, value)| value)
}
