//! Whether generated code does what the interpreter does.

use crate::generated;

/// Runs a case on both engines: each gives the expected trace.
///
/// # Panics
/// As [`tip_harness::traced`].
pub fn traced(case: &str) {
    tip_harness::traced(case, Some(generated::case));
}

/// Runs a case on both engines, once for each line that is expected to stop it.
///
/// # Panics
/// As [`tip_harness::stopped`].
pub fn stopped(case: &str) {
    tip_harness::stopped(case, Some(generated::case));
}
