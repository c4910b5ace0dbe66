//! Parts of messages that vary: an argument that is more than a word or a number.

use super::list::List;
use smol_str::SmolStr;

messages! {
    /// Word that ends a statement: nothing may stand after it.
    End;

    Word { word: SmolStr } "{word}", "{word}";
    Label "the label", "ラベル";
    Condition "the condition", "条件式";
    NextAndVariable "NEXT and its variable", "NEXTとその変数";
    SubroutineAndName "SUBROUTINE and its name", "SUBROUTINEとその名前";
    ThreadAndName "THREAD and its name", "THREADとその名前";
    DefineAndValue "DEFINE, its name and its value", "DEFINEとその名前と値";
}

messages! {
    /// Statement that gives a variable its value.
    Assign;

    Var { name: String } "assign it first, as `{name} = 0`", "先に `{name} = 0` のように代入してください";
    Pos { name: String } "assign it first, as `{name}.X = 0` or `TEACH_POSITION F1 {name}`", "先に `{name}.X = 0` や `TEACH_POSITION F1 {name}` のように代入してください";
    Joint { name: String } "assign it first, as `{name}.J1 = 0` or `TEACH_ANGLE F1 {name}`", "先に `{name}.J1 = 0` や `TEACH_ANGLE F1 {name}` のように代入してください";
    KeyIn "KEY_IN without an argument assigns it", "引数のないKEY_INで代入されます";
    EveryMember { member: String } "assign every member first, as `{member} = 0`", "先に `{member} = 0` のように全てのメンバに代入してください";
}

messages! {
    /// A number of joints.
    Joints;

    One "1 joint", "1関節";
    Several { count: usize } "{count} joints", "{count}関節";
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

    Robot "the robot", "ロボット";
    Scene "the scene", "シーン";
    Project "the project", "プロジェクト";
    Named { name: &'static str } "{name}", "{name}";
}

messages! {
    /// Kind of a value in a description or scene.
    Kind;

    Text "text", "文字列";
    Number "a number", "数値";
    Truth "true or false", "真偽値";
    Date "a date", "日付";
    List "a list", "配列";
    Table "a table", "テーブル";
}

messages! {
    /// Type of an operand.
    Type;

    Number "a number", "数値";
    Pos "a POS", "POS型変数";
    Joint "a JOINT", "JOINT型変数";
    PosOrJoint "a POS or JOINT", "POS型またはJOINT型の変数";
}

messages! {
    /// A number of operands, or one variable that holds them.
    Numbers;

    One "one number", "数値1個";
    Several { count: usize } "{count} numbers", "数値{count}個";
    OneOr { whole: Type } "one number or {whole}", "数値1個または{whole}";
    SeveralOr { count: usize, whole: Type } "{count} numbers or {whole}", "数値{count}個または{whole}";
}

impl Numbers {
    /// Creates `count` of them, or a variable of the type `whole` if there is one.
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
    /// A number of things in one location.
    Standing;

    None "there is none", "一つもありません";
    One "there is one", "1個しかありません";
    Several { count: usize } "there are {count}", "{count}個しかありません";
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
    /// A number of operands of a function.
    Operands;

    One "one operand", "オペランド1個";
    Two "two operands", "オペランド2個";
}

messages! {
    /// Missing part of a command.
    Lacking;

    Measured "the variable that receives what is measured", "測定値を受け取る変数";
    Input "the input, as `0 13` or `VR1`,", "入力(`0 13`や`VR1`など)";
    Volts "the VAR that receives the volts", "電圧を受け取るVAR型変数";
    Channel "the channel", "チャンネル番号";
    NativeCommand "the number of the native command", "ネイティブコマンドの番号";
}

messages! {
    /// Numbers that a command takes.
    Bounds;

    FromTo { min: f64, max: f64 } "{min} to {max}", "{min}から{max}まで";
    NotNegative "0 or more", "0以上";
    Positive "more than 0", "0より大きい値";
    Percent "more than 0, up to 100", "0より大きく100以下";
    Above { low: f64 } "an upper limit above {low}", "{low}より大きい上限";
    Nothing "nothing", "なし";
}

messages! {
    /// A block that a jump enters.
    Entered;

    Branch "a branch of an IF", "IFの分岐";
    While "a WHILE", "WHILE文";
    Repeat "a REPEAT", "REPEAT文";
    For "a FOR", "FOR文";
    Subroutine "a SUBROUTINE", "サブルーチン";
    Thread "a THREAD", "スレッド";
}

messages! {
    /// Possible targets on a robot.
    Inventory;

    Has { robot: &'static str, targets: List } "{robot} has {targets}", "{robot}にあるのは{targets}です";
}
