//! A value for each analogue input of a robot.

use crate::command::Port;

/// A value for each input that a robot may have; what a robot lacks keeps the value of the beginning. Joints are not
/// among them, since their potentiometers are read as angles, and channels lead to other inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inputs<T = f64>([T; Port::INPUTS]);

impl<T: Copy> Inputs<T> {
    /// Creates inputs that all have one value.
    pub const fn all(value: T) -> Self {
        Inputs([value; Port::INPUTS])
    }

    /// Returns the value of an input; `None` for a joint, a channel, or a number that no robot has.
    pub fn get(&self, port: Port) -> Option<T> {
        self.0.get(port.place()?).copied()
    }

    /// Returns the value of an input, to be changed.
    pub fn get_mut(&mut self, port: Port) -> Option<&mut T> {
        self.0.get_mut(port.place()?)
    }

    /// Gives an input a value; `false` where [`get`](Self::get) gives `None`.
    pub fn set(&mut self, port: Port, value: T) -> bool {
        self.get_mut(port).map(|place| *place = value).is_some()
    }

    /// Returns the values of a kind, in the order of its numbers; `port` selects the kind.
    pub fn of(&self, port: Port) -> &[T] {
        self.0.get(port.places()).unwrap_or_default()
    }
}

impl Inputs {
    /// Reads what was set, where something was.
    pub(crate) fn replace(&mut self, set: &Inputs<Option<f64>>) {
        for (read, set) in self.0.iter_mut().zip(&set.0) {
            *read = set.unwrap_or(*read);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::MAX;

    // clauses: 7.32
    #[test]
    fn each_input_has_a_place_of_its_own() {
        let soles = (1..).take(MAX).map(Port::Paw);
        let ports = || {
            Port::Knob(1)
                .named()
                .chain(soles.clone())
                .chain([Port::Antenna])
        };
        let mut inputs = Inputs::all(0);
        for (number, port) in (1..).zip(ports()) {
            assert!(inputs.set(port, number), "{port}");
        }
        assert_eq!(ports().count(), Port::INPUTS);
        for (number, port) in (1..).zip(ports()) {
            assert_eq!(inputs.get(port), Some(number), "{port}");
        }
        assert_eq!(inputs.of(Port::Knob(1)), [1, 2, 3]);
        assert_eq!(inputs.of(Port::Antenna), [13]);
    }

    // clauses: 7.32
    #[test]
    fn what_is_no_input_by_itself_has_no_value() {
        let mut inputs = Inputs::all(1.0);
        for port in [
            Port::Knob(0),
            Port::Knob(4),
            Port::Paw(0),
            Port::Paw(10),
            Port::Joint(1, 1),
            Port::Channel(13),
        ] {
            assert!(!inputs.set(port, 2.0), "{port:?}");
            assert_eq!(inputs.get(port), None, "{port:?}");
        }
        assert_eq!(inputs, Inputs::all(1.0));
    }
}
