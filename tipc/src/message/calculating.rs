//! What is said of equations.

use super::phrase::{Operands, Type};
use smol_str::SmolStr;

messages! {
    /// What is said of equations.
    Calculating;

    // The left side.
    LeftSideIs
        "the left side is a variable or a member",
        "左辺に書けるのは変数かメンバです";
    LeftSideSign
        "the left side has no sign",
        "左辺に符号は付けられません";
    LeftSide
        "the left side",
        "左辺はここです";

    // Types.
    SidesDiffer { left: Type, right: Type }
        "the left side is {left}, the right side {right}",
        "左辺は{left}、右辺は{right}です";
    NotTogether { first: Type, second: Type }
        "{first} and {second} do not go together",
        "{first}と{second}は一緒に計算できません";
    OneType
        "all of an equation is numbers, or POS, or JOINT; members, as `P.X`, are numbers",
        "式の全体を、数値だけ、POSだけ、JOINTだけのどれかにします。`P.X` のようなメンバは数値です";
    BelongsHere { wanted: Type }
        "{wanted} belongs here",
        "ここには{wanted}を書きます";
    WholeVariable
        "a whole variable, as `P`; a member is a number",
        "`P` のように変数全体を書きます。メンバは数値です";
    StructSign
        "a struct has no sign",
        "構造体の変数に符号は付けられません";
    ChangeMembers
        "change the sign of each member, as `P.X = -P.X`",
        "`P.X = -P.X` のように、メンバごとに符号を変えてください";

    // Functions.
    OtherOperands { function: SmolStr, wanted: Operands, found: usize }
        "{function} takes {wanted}, not {found}",
        "{function}には{wanted}が必要ですが、{found}個あります";
    WriteOfTwo { function: &'static str }
        "write `A = {function} y x`",
        "`A = {function} y x` のように書いてください";
    WriteOfStruct { function: &'static str }
        "write `A = {function} P`, P a POS or JOINT",
        "`A = {function} P` のように書いてください(PはPOS型かJOINT型)";
    WriteOfPos { function: &'static str }
        "write `P = {function} P`",
        "`P = {function} P` のように書いてください";
    WriteRotation { function: &'static str }
        "write `P = {function} P angle`",
        "`P = {function} P 角度` のように書いてください";
    WriteFunction { function: &'static str }
        "write `A = {function} a`, a a number",
        "`A = {function} a` のように書いてください(aは数値)";

    // Constants without a result.
    DividedByZero
        "nothing can be divided by 0",
        "0では割れません";
    DivideByAnother
        "divide by another number",
        "0以外の数で割ってください";
    NoSquareRoot
        "a negative number has no square root",
        "負の数の平方根は求められません";
    SqrtTakes
        "SQRT takes 0 or more",
        "SQRTに渡せるのは0以上です";
    NoResult { function: &'static str }
        "{function} has no result here",
        "ここでは{function}の値が定まりません";
    TakesToOne { function: &'static str }
        "{function} takes -1 to 1",
        "{function}に渡せるのは-1から1までです";
    TakesToOneOrRatio { function: &'static str }
        "{function} takes -1 to 1; `ATAN2 y x` takes any ratio",
        "{function}に渡せるのは-1から1までです。`ATAN2 y x` ならどんな比でも使えます";
    NoDirection
        "the point (0, 0) has no direction",
        "点(0, 0)には向きがありません";
    AnotherThanZero
        "one of the two must be another number than 0",
        "少なくとも一方を0以外にしてください";
}
