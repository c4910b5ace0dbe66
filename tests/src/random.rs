//! The slice of the differential campaign that every run of the tests goes through.

use random_programs::{Specimen, program};

/// How many programs are compiled and run.
const PROGRAMS: u64 = 200;

/// Programs of fixed seeds for every robot.
pub fn specimens() -> impl Iterator<Item = Specimen> {
    (0..PROGRAMS).map(program)
}
