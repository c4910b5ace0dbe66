//! Golden output. The files in `golden` are compiled here as they stand, with every warning denied;
//! a test of `tip-harness` holds the compiler to them.
#![deny(warnings, missing_docs)]
#![allow(unreachable_pub, reason = "nothing of a test can be reached")]

use tip_runtime::program::Program;

mod counting {
    include!("../../../codegen/golden/counting.rs");
}
mod branches {
    include!("../../../codegen/golden/branches.rs");
}
mod motion {
    include!("../../../codegen/golden/motion.rs");
}

#[test]
fn a_program_is_constructed_without_running_anything() {
    static COUNTING: counting::Counting = counting::Counting::new();
    static BRANCHES: branches::Branches = branches::Branches::new();
    static MOTION: motion::Motion = motion::Motion::new();
    let programs: [&dyn Program; 3] = [&COUNTING, &BRANCHES, &MOTION];
    for program in programs {
        assert_eq!(program.at(), 0);
        assert_eq!(program.scalar(0), Some(("VAR_KEY", None)));
    }
}
