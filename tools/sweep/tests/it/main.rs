//! Sweeps: axes, cases and results.

mod axes;
mod cases;
mod compiled;
mod results;
mod surroundings;

use tip_sweep::{Axis, Spec, Sweep, SweepError};

/// A specification of a program for TITAN VIII with these axes.
fn spec(text: &str, axes: &[&str]) -> Spec {
    let json = serde_json::json!({ "program": { "name": "p.prg", "text": text } });
    let spec: Spec = serde_json::from_value(json).expect("a specification");
    let axes = axes.iter().map(|axis| axis.parse::<Axis>());
    Spec {
        vary: axes.collect::<Result<_, _>>().expect("axes"),
        ..spec
    }
}

fn sweep(text: &str, axes: &[&str]) -> Result<Sweep, SweepError> {
    Sweep::new(spec(text, axes))
}

/// The reason why a sweep is refused.
fn refused(text: &str, axes: &[&str]) -> String {
    let refused = sweep(text, axes).expect_err("it is wrong");
    refused.to_string()
}

/// A program that lifts a foot by a number of millimetres.
const LIFT: &str = "3.1\nLifts a foot\nDEF_VAR Z\nZ = 20\nREL_PTP F1 0 0 Z\nWAIT_INPOS F1\nEND\n";
