//! Parts of messages that vary: an argument that is more than a word or a number.

use super::list::{List, Pieces};
use smol_str::SmolStr;

messages! {
    /// What ends a statement: nothing may stand after it.
    End;

    Word { word: SmolStr } "{word}";
    Label "the label";
    Condition "the condition";
    NextAndVariable "NEXT and its variable";
    SubroutineAndName "SUBROUTINE and its name";
}

messages! {
    /// What a variable lacks.
    Lack;

    Value "no value here";
    ValueOnSomeWays "a value here on some ways only";
}

messages! {
    /// How a variable gets its value.
    Assign;

    Var { name: String } "assign it before, as `{name} = 0`";
    Pos { name: String } "assign it before, as `{name}.X = 0` or `TEACH_POSITION F1 {name}`";
    Joint { name: String } "assign it before, as `{name}.J1 = 0` or `TEACH_ANGLE F1 {name}`";
    KeyIn "KEY_IN without argument assigns it";
    EveryMember { member: String } "assign every member before, as `{member} = 0`";
}

messages! {
    /// A path through a program.
    Stretch;

    Line { line: u32 } "line {line}";
    Lines { lines: Pieces } "lines {lines}";
}

messages! {
    /// So many joints.
    Joints;

    One "1 joint";
    Several { count: usize } "{count} joints";
}

impl From<usize> for Joints {
    fn from(count: usize) -> Self {
        match count {
            1 => Joints::One,
            count => Joints::Several { count },
        }
    }
}

messages! {
    /// A table of a description or scene.
    Table;

    Robot "the robot";
    Scene "the scene";
    Named { name: &'static str } "{name}";
}

messages! {
    /// What stands for a value in a description or scene.
    Kind;

    Text "text";
    Number "a number";
    Truth "true or false";
    Date "a date";
    List "a list";
    Table "a table";
}

messages! {
    /// A place in a file: line and column, from 1.
    Place;

    At { line: u32, column: u32 } "line {line}, column {column}";
}

messages! {
    /// A kind of joint that URDF knows and no leg has.
    JointKind;

    Fixed "fixed";
    Prismatic "prismatic";
    Floating "floating";
    Planar "planar";
    Spherical "spherical";
}

messages! {
    /// So many changes of a program.
    Changes;

    One "1 change";
    Several { count: usize } "{count} changes";
}

impl From<usize> for Changes {
    fn from(count: usize) -> Self {
        match count {
            1 => Changes::One,
            count => Changes::Several { count },
        }
    }
}

messages! {
    /// So many questions about a program.
    Questions;

    One "1 question";
    Several { count: usize } "{count} questions";
}

impl From<usize> for Questions {
    fn from(count: usize) -> Self {
        match count {
            1 => Questions::One,
            count => Questions::Several { count },
        }
    }
}

messages! {
    /// The robots that a migrated program loads for.
    Loads;

    ForNone "loads for no robot yet; `tipc check` on the new program says why";
    For { robots: List } "loads for {robots}";
}

messages! {
    /// Why a declaration is put in.
    Declared;

    OneType ": variables are declared since 3.0, AGL and TRQ as one type";
    Plainly ": variables are declared since 3.0";
}

messages! {
    /// What an operand is.
    Type;

    Number "a number";
    Pos "a POS";
    Joint "a JOINT";
    PosOrJoint "a POS or JOINT";
}

messages! {
    /// So many numbers, or one variable that holds them.
    Numbers;

    One "one number";
    Several { count: usize } "{count} numbers";
    OneOr { whole: Type } "one number or {whole}";
    SeveralOr { count: usize, whole: Type } "{count} numbers or {whole}";
}

impl Numbers {
    /// So many, or a variable of the type `whole` if there is one.
    pub fn new(count: usize, whole: Option<Type>) -> Self {
        match (count, whole) {
            (1, None) => Numbers::One,
            (count, None) => Numbers::Several { count },
            (1, Some(whole)) => Numbers::OneOr { whole },
            (count, Some(whole)) => Numbers::SeveralOr { count, whole },
        }
    }
}

messages! {
    /// So many stand somewhere.
    Standing;

    None "none stands";
    One "one stands";
    Several { count: usize } "{count} stand";
}

impl From<usize> for Standing {
    fn from(count: usize) -> Self {
        match count {
            0 => Standing::None,
            1 => Standing::One,
            count => Standing::Several { count },
        }
    }
}

messages! {
    /// So many operands of a function.
    Operands;

    One "one operand";
    Two "two operands";
}

messages! {
    /// What a command lacks.
    Lacking;

    Measured "the variable that receives what is measured";
    Input "the input, as `0 13` or `VR1`,";
    Volts "the VAR that receives the volts";
    Channel "the channel";
    NativeCommand "the number of the native command";
}

messages! {
    /// Which numbers a command takes.
    Bounds;

    FromTo { min: f64, max: f64 } "{min} to {max}";
    NotNegative "0 or more";
    Positive "more than 0";
    Percent "more than 0, up to 100";
    Nothing "nothing";
}

messages! {
    /// A block that a jump enters.
    Entered;

    Branch "a branch of an IF";
    While "a WHILE";
    Repeat "a REPEAT";
    For "a FOR";
    Subroutine "a SUBROUTINE";
}

messages! {
    /// What can be a target on a robot.
    Inventory;

    Has { robot: &'static str, targets: List } "{robot} has {targets}";
}
