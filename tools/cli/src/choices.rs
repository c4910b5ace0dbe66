//! The words that options choose from.

use clap::ValueEnum;
use tip_runtime::plant::Simulation;
use tipc::Robot;
use tipc::message::Lang;
use tipc::source::Encoding;

/// The robots by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum RobotName {
    /// TITAN VIII, the quadruped
    Titan8,
    /// Hiroshima Hand
    Hand,
    /// Every generic command, on TITAN VIII's geometry
    Generic,
}

impl RobotName {
    pub(super) fn robot(self) -> Robot {
        match self {
            RobotName::Titan8 => Robot::Titan8,
            RobotName::Hand => Robot::Hand,
            RobotName::Generic => Robot::Generic,
        }
    }
}

/// The plants of walking robots by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum PlantName {
    QuasiStatic,
    Dynamic,
}

impl PlantName {
    /// As the option and scenes write it.
    pub(super) fn name(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }

    pub(super) fn simulation(self) -> Simulation {
        match self {
            PlantName::QuasiStatic => Simulation::QuasiStatic,
            PlantName::Dynamic => Simulation::Dynamic,
        }
    }
}

/// The encodings by name.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub(super) enum EncodingName {
    #[default]
    Auto,
    #[value(name = "utf-8", alias = "utf8")]
    Utf8,
    #[value(name = "shift_jis", aliases = ["shift-jis", "sjis"])]
    ShiftJis,
}

impl EncodingName {
    /// The name of an encoding.
    pub(super) fn of(encoding: Encoding) -> Self {
        match encoding {
            Encoding::Auto => EncodingName::Auto,
            Encoding::Utf8 => EncodingName::Utf8,
            Encoding::ShiftJis => EncodingName::ShiftJis,
        }
    }

    /// As options and `tip.toml` write it.
    pub(super) fn name(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }

    pub(super) fn encoding(self) -> Encoding {
        match self {
            EncodingName::Auto => Encoding::Auto,
            EncodingName::Utf8 => Encoding::Utf8,
            EncodingName::ShiftJis => Encoding::ShiftJis,
        }
    }
}

/// The languages of messages by name.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum LangName {
    /// English
    En,
    /// Japanese
    Ja,
}

impl LangName {
    pub(super) fn of(lang: Lang) -> Self {
        match lang {
            Lang::Japanese => LangName::Ja,
            _ => LangName::En,
        }
    }

    pub(super) fn lang(self) -> Lang {
        match self {
            LangName::En => Lang::English,
            LangName::Ja => Lang::Japanese,
        }
    }
}

/// When findings have colours.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum ColourName {
    /// On a terminal
    Auto,
    /// Everywhere
    Always,
    /// Nowhere
    Never,
}

/// How findings are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// With the source line, help and colour
    Human,
    /// One line each
    Short,
    /// One JSON object a line
    Json,
    /// One document of SARIF 2.1.0 for all files, by check alone
    Sarif,
}
