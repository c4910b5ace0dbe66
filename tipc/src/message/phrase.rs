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
