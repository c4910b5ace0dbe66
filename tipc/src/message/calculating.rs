//! What is said of equations.

use super::phrase::{Operands, Type};
use smol_str::SmolStr;

messages! {
    /// What is said of equations.
    Calculating;

    // The left side.
    LeftSideIs "the left side is a variable or a member";
    LeftSideSign "the left side has no sign";
    LeftSide "the left side";

    // Types.
    SidesDiffer { left: Type, right: Type } "the left side is {left}, the right side {right}";
    NotTogether { first: Type, second: Type } "{first} and {second} do not go together";
    OneType "all of an equation is numbers, or POS, or JOINT; members, as `P.X`, are numbers";
    BelongsHere { wanted: Type } "{wanted} belongs here";
    WholeVariable "a whole variable, as `P`; a member is a number";
    StructSign "a struct has no sign";
    ChangeMembers "change the sign of each member, as `P.X = -P.X`";

    // Functions.
    OtherOperands { function: SmolStr, wanted: Operands, found: usize } "{function} takes {wanted}, not {found}";
    WriteOfTwo { function: &'static str } "write `A = {function} y x`";
    WriteOfStruct { function: &'static str } "write `A = {function} P`, P a POS or JOINT";
    WriteOfPos { function: &'static str } "write `P = {function} P`";
    WriteRotation { function: &'static str } "write `P = {function} P angle`";
    WriteFunction { function: &'static str } "write `A = {function} a`, a a number";

    // Constants without a result.
    DividedByZero "nothing can be divided by 0";
    DivideByAnother "divide by another number";
    NoSquareRoot "a negative number has no square root";
    SqrtTakes "SQRT takes 0 or more";
    NoResult { function: &'static str } "{function} has no result here";
    TakesToOne { function: &'static str } "{function} takes -1 to 1";
    TakesToOneOrRatio { function: &'static str } "{function} takes -1 to 1; `ATAN2 y x` takes any ratio";
    NoDirection "the point (0, 0) has no direction";
    AnotherThanZero "one of the two has to be another number than 0";
}
