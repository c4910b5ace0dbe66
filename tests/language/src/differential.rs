//! Comparison of generated code with the interpreter.

use crate::generated;

/// Runs a case on both engines: each gives the expected trace.
///
/// # Panics
/// Traces a case as [`tip_harness::traced`] does.
pub fn traced(case: &str) {
    tip_harness::traced(case, Some(generated::case));
}

/// Runs a case on both engines, once for each line that is expected to stop it.
///
/// # Panics
/// Runs a case as [`tip_harness::stopped`] does.
pub fn stopped(case: &str) {
    tip_harness::stopped(case, Some(generated::case));
}
