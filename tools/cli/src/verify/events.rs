//! Inputs as a list of events, which a search can add to and a shrinker take from.

use tip_runtime::command::Port;
use tipc::lockstep::Inputs;
use tipc::lockstep::inputs::Sensor;

/// Something that happens before the step of a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Event {
    pub(super) cycle: u64,
    pub(super) what: What,
}

/// What happens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum What {
    /// A key is pressed.
    Key(u8),
    /// An input reads so many volts from now on.
    Volts(Port, f64),
    /// A halt is requested.
    Halt,
}

/// The events of some inputs.
pub(super) fn of(inputs: &Inputs) -> Vec<Event> {
    let event = |cycle, what| Event { cycle, what };
    let keys = inputs.keys.iter();
    let keys = keys.map(|(cycle, byte)| event(*cycle, What::Key(*byte)));
    let sensors = inputs.sensors.iter();
    let sensors = sensors.map(|sensor| event(sensor.cycle, What::Volts(sensor.port, sensor.volts)));
    let halt = inputs.halt.map(|cycle| event(cycle, What::Halt));
    keys.chain(sensors).chain(halt).collect()
}

/// The inputs that some events make. Of several halt requests the first one counts.
pub(super) fn inputs(events: &[Event], cycles: Option<u64>) -> Inputs {
    let mut inputs = Inputs {
        cycles,
        ..Inputs::default()
    };
    let mut events = events.to_vec();
    events.sort_by_key(|event| event.cycle);
    for Event { cycle, what } in events {
        match what {
            What::Key(byte) => inputs.keys.push((cycle, byte)),
            What::Volts(port, volts) => inputs.sensors.push(Sensor { port, volts, cycle }),
            What::Halt => inputs.halt = inputs.halt.or(Some(cycle)),
        }
    }
    inputs
}
