//! What is said of programs of older versions.

use super::Message;
use super::phrase::{Changes, Declared, Loads, Questions};

messages! {
    /// What the migration of a program says.
    Migrating;

    // Lines 1 and 2.
    WhichVersion "line 1 names no version: which version of the language is this program written for?";
    UnknownVersion { version: String } "no version {version} of the language is known (1.0 to 3.1, and 4.0 in some programs of the time of 2.1): which one is this program written for?";
    Version { version: String } "version {version} becomes 3.1";
    EmptyTitle "put in an empty line 2: since 1.1 it holds the title";

    // Commands and equations.
    IsSince2_0 { old: String, new: String } "{old} is {new} since 2.0";
    IsSince3_1 { old: String, new: String } "{old} is {new} since 3.1";
    TwoSuccessors { old: String, target: String, feet: String, joints: String } "{old} {target} has two successors: {feet} takes feet (mm), {joints} joints (deg); which one is meant?";
    NotTheAngles "these are not the angles that COMPLIANCE_ANGLE takes, one for each joint: which of them are angles, and which is the stiffness for SET_ANGLE_STIFFNESS?";
    Compliance "COMPLIANCE is COMPLIANCE_ANGLE since 2.1";
    AssignmentBehindFor { variable: String } "`=` behind FOR {variable} since 3.1";
    Sign { operand: String } "`- {operand}` is `-{operand}` since 2.0";
    Remark "REM becomes //: since 3.0 REM is a step of its own";

    // WAIT_NEAR.
    OneTolerance "WAIT_NEAR takes one tolerance, not negative: which one is meant?";
    WholeLeg { target: String, leg: String } "{target} is moved to positions, and a tolerance in mm is set for a whole leg: may it be SET_NEAR_POSITION F{leg}?";
    TwoSteps { setting: &'static str } "two steps, {setting} and WAIT_NEAR: since 3.1 the tolerance is set beforehand, and stays set";
    WhichMeasure { target: String } "the program moves {target} to positions and to angles: is this tolerance in mm (SET_NEAR_POSITION) or in deg (SET_NEAR_ANGLE)?";

    // MESSAGE.
    Semicolon "`;` ends a MESSAGE since 3.0: which character shall stand here instead?";
    PlainText { name: String } "`%{name}%` was plain text and shows a value since 3.0: which one is meant?";
    Placeholder { old: String, new: String } "{old} is {new} since 3.0";

    // Names.
    Label { name: String, new: String } "the label {name} becomes {new}: {name} is a word of the language in 3.1";
    WordOfLanguage { word: String } "{word} is a word of the language in 3.1: what shall the variable be called?";
    Declares { line: String, declared: Declared } "put in `{line}`{declared}";
    OneVariable { old: String, name: String } "{old} and {name} are one variable by their number: written {name}";
    NoNumber { name: String } "{name} has no number: which variable is meant?";
    NameTooLong { most: usize, name: String, length: usize } "a name has at most {most} bytes, {name} has {length}: what shall the variable be called?";

    // The last look.
    NoEnd "the program has no END: where does it end?";
    NoCommand { word: String } "{word} is no command of version 3.1: what is meant?";
    NoStatement { title: String, reason: Box<Message> } "this is no statement of version 3.1 ({title}: {reason}): what is meant?";

    // The sentence at the end of the report.
    AlreadyCurrent { file: String } "{file}: is a program of version 3.1 already, nothing is changed";
    Migrated { file: String, changes: Changes, loads: Loads } "{file}: {changes}, {loads}";
    ToAnswer { file: String, questions: Questions } "{file}: {questions} to answer first, nothing is written";
}
