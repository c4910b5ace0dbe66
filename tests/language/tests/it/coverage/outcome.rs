//! Outcomes of a statement: it runs, it is refused, or it stops the program.

use tipc::code::Code;

macro_rules! outcomes {
    ($( $variant:ident $heading:literal $meaning:literal; )*) => {
        /// A column of the table.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Outcome {
            $( #[doc = $meaning] $variant, )*
        }

        impl Outcome {
            /// Every column, from left to right.
            pub const ALL: &'static [Outcome] = &[$( Outcome::$variant, )*];

            /// Its short name.
            pub const fn heading(self) -> &'static str {
                match self { $( Outcome::$variant => $heading, )* }
            }
        }
    };
}

outcomes! {
    Valid "runs" "the step runs to its end, in both engines alike";
    UnknownCommand "unknown command" "`Unknown command`: the robot lacks the command";
    Missing "missing" "`Wrong argument`: an argument is missing";
    Surplus "surplus" "`Wrong argument`: an argument too many";
    Malformed "malformed" "`Wrong argument`: an argument is not a constant, name or member";
    WrongType "type" "`Wrong argument`: an operand of another type, a member that it lacks, or a constant that cannot stand there";
    WrongFlag "flag" "`Wrong argument`: R, A or HS where it cannot stand";
    WrongTarget "target" "`Wrong argument`: no target, or one that the command does not take";
    Lacking "lacking" "`Wrong argument`: a target or input that the robot lacks";
    Argument "argument" "`Wrong argument`: words missing, too many, or others than belong there";
    Equation "equation" "`Wrong equation format`";
    Format "format" "`Format error`";
    LongString "long" "`too much long string`";
    UnknownLabel "no label" "`Label \"…\" does not exist`";
    DuplicateLabel "duplicate" "`Duplicated label name`";
    Structure "structure" "`Control structure mismatch`";
    NoEnd "no END" "`Not exist END`";
    UnknownVariable "no variable" "`unknown variable \"…\"`";
    NeverAssigned "never assigned" "`Possible use of Variable before definition`, when the program is loaded";
    OutOfRange "constant" "a warning, in 3.2 `Domain error` when the program is loaded: the constant is out of range";
    Unassigned "unassigned" "`Possible use of Variable before definition`, when the step runs";
    Domain "domain" "`Domain error`";
    OutOfReach "reach" "`Out of reach …`, when the step runs, or during the motion that it started";
    JointLimit "limit" "`Joint limit …` during the motion that the step started";
    Sensor "sensor" "`Sensor fault …`";
    Mode "mode" "`Invalid control mode`";
    Return "return" "`Invalid Return command`";
    Depth "depth" "`Too deep subroutine call`";
}

impl Outcome {
    /// Returns the meaning of a compiler diagnostic, whatever the statement; `None` if that depends on it.
    pub const fn of_code(code: Code) -> Option<Outcome> {
        Some(match code {
            Code::Format => Outcome::Format,
            Code::LongString => Outcome::LongString,
            Code::Equation => Outcome::Equation,
            Code::DuplicateLabel => Outcome::DuplicateLabel,
            Code::UnknownLabel => Outcome::UnknownLabel,
            Code::NoEnd => Outcome::NoEnd,
            Code::UnknownCommand => Outcome::UnknownCommand,
            Code::UnknownVariable => Outcome::UnknownVariable,
            Code::Structure => Outcome::Structure,
            Code::NeverAssigned => Outcome::NeverAssigned,
            Code::OutOfRange | Code::Domain => Outcome::OutOfRange,
            _ => return None,
        })
    }

    /// Returns true if it may befall any statement, and says something about those alone that the rules name: a foreign
    /// character, a locked joint, or a fault of the robot.
    pub const fn is_anywhere(self) -> bool {
        matches!(
            self,
            Outcome::Format
                | Outcome::OutOfReach
                | Outcome::JointLimit
                | Outcome::Sensor
                | Outcome::Mode
        )
    }

    /// Returns the meaning of an emergency's message; `None` for those that no statement makes.
    pub fn of_emergency(message: &str) -> Option<Outcome> {
        Some(match message {
            "Domain error" => Outcome::Domain,
            "Invalid Return command" => Outcome::Return,
            "Possible use of Variable before definition" => Outcome::Unassigned,
            "Invalid control mode" => Outcome::Mode,
            "Too deep subroutine call" => Outcome::Depth,
            _ if message.starts_with("Out of reach ") => Outcome::OutOfReach,
            _ if message.starts_with("Joint limit ") => Outcome::JointLimit,
            _ if message.starts_with("Sensor fault ") => Outcome::Sensor,
            _ => return None,
        })
    }
}
