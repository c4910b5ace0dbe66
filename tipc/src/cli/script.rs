//! What happens to a simulated robot, and when: `--keys` and `--sensor`.

use std::str::FromStr;
use tip_runtime::command::Port;

/// A key and the cycle before whose step it is pressed.
pub(super) type Key = (u64, u8);

/// The keys of a run.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Keys(pub(super) Vec<Key>);

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
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sensor {
    /// Its name as AD_IN has it.
    pub(super) name: String,
    /// Which input.
    pub(super) port: Port,
    /// What it reads: V.
    pub(super) volts: f64,
    /// The first cycle of which this is true.
    pub(super) cycle: u64,
}

impl FromStr for Sensor {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = |what: &str| format!("{what}; expected NAME=VALUE@CYCLE, such as VR1=8@300");
        let (name, rest) = text.split_once('=').ok_or_else(|| wrong("no '='"))?;
        let (volts, cycle) = rest.split_once('@').ok_or_else(|| wrong("no '@'"))?;
        let name = name.trim().to_ascii_uppercase();
        let port = port(&name).ok_or_else(|| wrong(&format!("'{name}' is no input")))?;
        let volts = match volts.trim().parse::<f64>() {
            Ok(volts) if volts.is_finite() => volts,
            _ => return Err(wrong(&format!("'{volts}' is no number of volts"))),
        };
        let cycle = cycle
            .trim()
            .parse()
            .map_err(|_| wrong(&format!("'{cycle}' is no cycle")))?;
        Ok(Sensor {
            name,
            port,
            volts,
            cycle,
        })
    }
}

/// The inputs by name, as AD_IN has them.
fn port(name: &str) -> Option<Port> {
    if name == "ANTENNA" {
        return Some(Port::Antenna);
    }
    let digits = |prefix: &str| name.strip_prefix(prefix).map(str::as_bytes);
    let number = |digit: u8, last: u8| (b'1'..=last).contains(&digit).then(|| digit - b'0');
    match (digits("VR"), digits("PAW"), digits("J")) {
        (Some(&[knob]), _, _) => number(knob, b'3').map(Port::Knob),
        (_, Some(&[paw]), _) => number(paw, b'4').map(Port::Paw),
        (_, _, Some(&[leg, joint])) => Some(Port::Joint(number(leg, b'9')?, number(joint, b'9')?)),
        _ => None,
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
        let expected = |name: &str, port, volts, cycle| {
            Ok(Sensor {
                name: name.to_owned(),
                port,
                volts,
                cycle,
            })
        };
        for (text, expected) in [
            ("VR1=8@300", expected("VR1", Port::Knob(1), 8.0, 300)),
            ("paw4=-0.5@0", expected("PAW4", Port::Paw(4), -0.5, 0)),
            ("J23=1@7", expected("J23", Port::Joint(2, 3), 1.0, 7)),
            ("ANTENNA=5@1", expected("ANTENNA", Port::Antenna, 5.0, 1)),
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
}
