//! What happens around a program while it runs.

/// Keys, inputs and the end of a run, each at its cycle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Events {
    /// The most cycles.
    pub cycles: Option<u64>,
    /// Bytes typed, each before the step of its cycle.
    pub keys: Vec<(u64, u8)>,
    /// The cycle from which HALT_REQUEST is true.
    pub halt: Option<u64>,
    /// Inputs by name, their volts, and the cycle from which they read so.
    pub sensors: Vec<(String, f64, u64)>,
}
