//! What happens to a simulated robot, and when: keys, sensors, a halt request, as the command line spells them.

use std::fmt;
use std::str::FromStr;
use tip_runtime::command::Port;
use tip_runtime::console::Scripted;

/// A key and the cycle before whose step it is pressed.
pub type Key = (u64, u8);

/// All that happens around a run, and how long it may take.
///
/// Its text is that of the options of `tipc run`, in one line: `--keys 3:a --sensor VR1=8@300 --halt 500 --cycles 900`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inputs {
    /// Keys that are pressed.
    pub keys: Vec<Key>,
    /// Inputs that read something else.
    pub sensors: Vec<Sensor>,
    /// The cycle before whose step a halt is requested.
    pub halt: Option<u64>,
    /// The most cycles.
    pub cycles: Option<u64>,
}

impl Inputs {
    /// Whether anything is to happen.
    pub fn happen(&self) -> bool {
        !(self.keys.is_empty() && self.sensors.is_empty() && self.halt.is_none())
    }

    /// The keys and the halt request in front of another console.
    pub fn console<C>(&self, inner: C) -> Scripted<C> {
        let keys = Scripted::around(self.keys.clone(), inner);
        match self.halt {
            Some(cycle) => keys.halt(cycle),
            None => keys,
        }
    }
}

impl fmt::Display for Inputs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut options = Vec::new();
        if !self.keys.is_empty() {
            options.push(format!("--keys {}", Keys(self.keys.clone())));
        }
        let sensors = self.sensors.iter();
        options.extend(sensors.map(|sensor| format!("--sensor {sensor}")));
        options.extend(self.halt.map(|cycle| format!("--halt {cycle}")));
        options.extend(self.cycles.map(|cycles| format!("--cycles {cycles}")));
        f.write_str(&options.join(" "))
    }
}

impl FromStr for Inputs {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut inputs = Inputs::default();
        let mut words = text.split_whitespace();
        while let Some(option) = words.next() {
            let value = words
                .next()
                .ok_or_else(|| format!("{option} needs a value"))?;
            let number = || {
                value
                    .parse()
                    .map_err(|_| format!("'{value}' is no number of cycles"))
            };
            match option {
                "--keys" => inputs.keys.extend(value.parse::<Keys>()?.0),
                "--sensor" => inputs.sensors.push(value.parse()?),
                "--halt" => inputs.halt = Some(number()?),
                "--cycles" => inputs.cycles = Some(number()?),
                _ => return Err(format!("'{option}' is no option of a run")),
            }
        }
        Ok(inputs)
    }
}

/// The keys of a run.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Keys(pub Vec<Key>);

impl fmt::Display for Keys {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let keys = self.0.iter().map(|(cycle, byte)| match byte {
            byte if byte.is_ascii_alphanumeric() => format!("{cycle}:{}", char::from(*byte)),
            byte => format!("{cycle}:0x{byte:02X}"),
        });
        f.write_str(&keys.collect::<Vec<_>>().join(","))
    }
}

impl FromStr for Keys {
    type Err = String;

    /// Reads `CYCLE:CHAR,CYCLE:CHAR…`.
    fn from_str(text: &str) -> Result<Self, String> {
        text.split(',')
            .map(parse_key)
            .collect::<Result<_, _>>()
            .map(Keys)
    }
}

fn parse_key(text: &str) -> Result<Key, String> {
    let wrong = || format!("'{text}' is not CYCLE:CHAR, such as 3:a or 3:0x1B");
    let (cycle, key) = text.split_once(':').ok_or_else(wrong)?;
    let cycle = cycle.trim().parse().map_err(|_| wrong())?;
    let byte = match (key.as_bytes(), key.strip_prefix("0x")) {
        (&[byte], _) if byte.is_ascii() => byte,
        (_, Some(digits)) if digits.len() <= 2 && !digits.starts_with('+') => {
            u8::from_str_radix(digits, 16).map_err(|_| wrong())?
        }
        _ => return Err(wrong()),
    };
    Ok((cycle, byte))
}

/// An input that reads a value from a cycle on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensor {
    /// Which input.
    pub port: Port,
    /// What it reads: V.
    pub volts: f64,
    /// The first cycle of which this is true.
    pub cycle: u64,
}

impl fmt::Display for Sensor {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}@{}", self.port, self.volts, self.cycle)
    }
}

impl FromStr for Sensor {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = |what: &str| format!("{what}; expected NAME=VALUE@CYCLE, such as VR1=8@300");
        let (name, rest) = text.split_once('=').ok_or_else(|| wrong("no '='"))?;
        let (volts, cycle) = rest.split_once('@').ok_or_else(|| wrong("no '@'"))?;
        let name = name.trim().to_ascii_uppercase();
        let port = name
            .parse()
            .map_err(|_| wrong(&format!("'{name}' is no input")))?;
        let volts = match volts.trim().parse::<f64>() {
            Ok(volts) if volts.is_finite() => volts,
            _ => return Err(wrong(&format!("'{volts}' is no number of volts"))),
        };
        let cycle = cycle
            .trim()
            .parse()
            .map_err(|_| wrong(&format!("'{cycle}' is no cycle")))?;
        Ok(Sensor { port, volts, cycle })
    }
}

/// Sensors in the order in which they come to read something else.
#[derive(Clone, Debug)]
pub struct Due {
    /// The next one last.
    sensors: Vec<Sensor>,
}

impl Due {
    /// Those of a run. Of two for the same cycle the one that stands behind the other wins.
    pub fn new(sensors: &[Sensor]) -> Self {
        let mut sensors = sensors.to_vec();
        sensors.reverse();
        sensors.sort_by_key(|sensor| std::cmp::Reverse(sensor.cycle));
        Due { sensors }
    }

    /// The next one that is to be set before the step of `cycle`.
    pub fn next(&mut self, cycle: u64) -> Option<Sensor> {
        self.sensors.pop_if(|sensor| sensor.cycle <= cycle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_characters_or_hexadecimal_bytes() {
        let keys = |text: &str| text.parse::<Keys>();
        assert_eq!(keys("3:a"), Ok(Keys(vec![(3, b'a')])));
        assert_eq!(
            keys("0:0,0::,12:0x1B,12:0x2c"),
            Ok(Keys(vec![(0, b'0'), (0, b':'), (12, 0x1B), (12, 0x2C)]))
        );
        for wrong in [
            "", "3", "3:", "x:a", "3:ab", "3:0x100", "3:0xG0", "3:あ", "3:a,",
        ] {
            assert!(keys(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_sensor_names_an_input_a_voltage_and_a_cycle() {
        let sensor = |text: &str| text.parse::<Sensor>();
        let expected = |port, volts, cycle| Ok(Sensor { port, volts, cycle });
        for (text, expected) in [
            ("VR1=8@300", expected(Port::Knob(1), 8.0, 300)),
            ("paw4=-0.5@0", expected(Port::Paw(4), -0.5, 0)),
            ("J23=1@7", expected(Port::Joint(2, 3), 1.0, 7)),
            ("ANTENNA=5@1", expected(Port::Antenna, 5.0, 1)),
        ] {
            assert_eq!(sensor(text), expected);
        }
        for wrong in [
            "VR1",
            "VR1=8",
            "VR4=8@1",
            "PAW5=8@1",
            "VR0=8@1",
            "J0=1@1",
            "J123=1@1",
            "X=1@1",
            "VR1=inf@1",
            "VR1=8@-1",
            "VR1=@1",
        ] {
            assert!(sensor(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn inputs_are_read_from_what_they_are_written_as() {
        let text = "--keys 0:F,3:0x2C,9:0x1B --sensor J23=-0.5@7 --sensor ANTENNA=1@0 --halt 5 --cycles 90";
        let inputs: Inputs = text.parse().unwrap();
        assert_eq!(inputs.keys, [(0, b'F'), (3, b','), (9, 0x1B)]);
        assert_eq!(inputs.to_string(), text);
        assert_eq!("".parse(), Ok(Inputs::default()));
        for wrong in ["--keys", "--halt x", "--cycles -1", "--out 3", "VR1=8@3"] {
            assert!(wrong.parse::<Inputs>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn of_two_sensors_for_a_cycle_the_later_wins() {
        let sensor = |text: &str| text.parse::<Sensor>().unwrap();
        let late = sensor("VR1=1@5");
        let (first, second) = (sensor("VR1=2@3"), sensor("VR1=3@3"));
        let mut due = Due::new(&[late, first, second]);
        assert_eq!(due.next(2), None);
        let at_three = [due.next(3), due.next(3), due.next(3)];
        assert_eq!(at_three, [Some(first), Some(second), None]);
        assert_eq!(due.next(9), Some(late));
    }
}
