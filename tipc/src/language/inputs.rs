//! The inputs that AD_IN reads by name (T.I.P. 3.1 §7-9-1).

use super::commands::Robots;
use super::{Bilingual, Edition};
use crate::robot::Robot;
use std::mem::discriminant;
use tip_runtime::command::Port;

/// A row of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The input; of several of a kind, one of them. `Display` gives its word.
    pub port: Port,
    /// The first edition that has it.
    pub since: Edition,
    /// The robots that have it.
    pub robots: Robots,
    /// The section of T.I.P. that describes it.
    pub section: &'static str,
    /// The clause of the language reference.
    pub clause: &'static str,
    /// One line for the reference.
    pub description: Bilingual,
}

/// Every kind of input that has a name.
pub const INPUTS: &[Row] = &[
    Row::new(
        Port::Knob(1),
        Robots::ALL,
        "A potentiometer of the control box.",
        "操作箱のポテンショメータ。",
    ),
    Row::new(
        Port::Paw(1),
        Robots::TITAN,
        "The pressure sensor under a sole.",
        "足裏の圧力センサ。",
    ),
    Row::new(
        Port::Antenna,
        Robots::NAMED,
        "The feeler of TITAN VIII, or the palm's touch of the Hiroshima Hand.",
        "TITAN VIIIの触角、またはHiroshima Handの手のひらの接触センサ。",
    ),
    Row::new(
        Port::Joint(1, 1),
        Robots::ALL,
        "A joint's potentiometer.",
        "関節のポテンショメータ。",
    ),
];

impl Row {
    /// Creates an input of 3.1.
    const fn new(
        port: Port,
        robots: Robots,
        english: &'static str,
        japanese: &'static str,
    ) -> Self {
        Row {
            port,
            since: Edition::V3_1,
            robots,
            section: "§7-9-1",
            clause: "7.32",
            description: Bilingual { english, japanese },
        }
    }
}

/// Returns the input that an edition writes so, in capital letters, and its row.
pub fn find(word: &str, edition: Edition) -> Option<(Port, &'static Row)> {
    let port: Port = word.parse().ok()?;
    let mut rows = INPUTS.iter();
    let row = rows.find(|row| discriminant(&row.port) == discriminant(&port))?;
    (row.since <= edition).then_some((port, row))
}

/// Returns the inputs besides joints.
pub fn named() -> impl Iterator<Item = Port> {
    INPUTS.iter().flat_map(|row| row.port.named())
}

/// Returns the kinds that a robot has besides knobs and joints, each as its inputs are named.
pub(crate) fn others(robot: Robot) -> impl Iterator<Item = String> {
    let rows = INPUTS.iter().filter(move |row| row.robots.contains(robot));
    let rows = rows.filter(|row| !matches!(row.port, Port::Knob(_)));
    rows.filter_map(
        |row| match (row.port.named().next()?, row.port.named().last()?) {
            (only, last) if only == last => Some(only.to_string()),
            (first, last) => Some(format!("{first}…{last}")),
        },
    )
}

#[cfg(test)]
mod tests {
    use super::{find, named};
    use crate::language::Edition;
    use tip_runtime::command::Port;

    // clauses: 7.32
    #[test]
    fn inputs_are_found_by_their_names() {
        for port in named().chain([Port::Joint(4, 3)]) {
            let (found, _) = find(&port.to_string(), Edition::V3_1).expect("an input");
            assert_eq!(found, port);
        }
        let words: Vec<String> = named().map(|port| port.to_string()).collect();
        let expected = [
            "VR1", "VR2", "VR3", "PAW1", "PAW2", "PAW3", "PAW4", "ANTENNA",
        ];
        assert_eq!(words, expected);
        assert!(find("13", Edition::V3_1).is_none());
    }
}
