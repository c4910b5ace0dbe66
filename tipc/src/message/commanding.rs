//! What is said of commands, their arguments, and the flags of conditions.

use super::list::{Alternatives, Both, List};
use super::phrase::{Bounds, Inventory, Lacking, Numbers, Standing, Type};
use smol_str::SmolStr;
use tip_runtime::command::Target;

messages! {
    /// What is said of commands.
    Commanding;

    // Which command.
    RobotLacks { robot: &'static str, command: &'static str }
        "{robot} has no {command}",
        "{robot}に{command}はありません";
    NeedsForces { command: &'static str }
        "{command} needs a robot that senses and gives torque: its description has no `[forces]`",
        "{command}には、トルクを測れて出せるロボットが必要です。ロボットの記述に `[forces]` がありません";
    CommandOf { command: &'static str, robots: Both }
        "{command} is a command of {robots}",
        "{command}は{robots}のコマンドです";
    VariableNotCommand { name: SmolStr }
        "`{name}` is a variable, not a command",
        "`{name}` は変数で、コマンドではありません";
    OperatorBehindVariable { name: SmolStr }
        "an equation has an operator after its variable: `{name} = 0`",
        "式では変数の後に演算子を書きます: `{name} = 0`";
    NoCommand { word: SmolStr }
        "`{word}` is not a command",
        "`{word}` というコマンドはありません";
    CalledNow { command: &'static str }
        "this language calls it `{command}`",
        "この言語では `{command}` と書きます";
    LabelOrEquation
        "a label ends with a colon, an equation has `=` after its variable",
        "ラベルの後にはコロン、式の変数の後には `=` が必要です";

    // Arguments.
    Write { forms: Alternatives }
        "write {forms}",
        "{forms} のように書いてください";
    OtherType { command: SmolStr, wanted: Numbers, found: Type }
        "{command} wants {wanted} here, not {found}",
        "{command}のここには{wanted}が必要ですが、{found}があります";
    TooFew { command: SmolStr, wanted: Numbers, found: Standing }
        "{command} wants {wanted}; {found} here",
        "{command}には{wanted}が必要ですが、{found}";
    TooMany { command: SmolStr }
        "one argument too many for {command}",
        "{command}の引数が多すぎます";
    ToleranceElsewhere
        "SET_NEAR_POSITION and SET_NEAR_ANGLE set the tolerance",
        "許容範囲はSET_NEAR_POSITIONかSET_NEAR_ANGLEで設定します";
    Missing { what: Lacking }
        "{what} is missing",
        "{what}がありません";
    FlagBeforeNumber { flag: SmolStr }
        "{flag} is a flag here: it stands before a number, and once",
        "ここでは{flag}はフラグです。数値の前に一度だけ書きます";
    NoFlag { flag: SmolStr }
        "this command takes no {flag}",
        "このコマンドに{flag}は付けられません";
    StructForNumber
        "a struct stands where one number belongs",
        "数値1個のところに構造体の変数があります";
    NameMember
        "name a member, as `P.X` or `Q.J2`",
        "`P.X` や `Q.J2` のようにメンバを書いてください";
    ConstantOrVar
        "only a constant or a VAR can stand here",
        "ここに書けるのは定数かVAR型変数だけです";
    CopyIntoVar
        "copy the number into a VAR first",
        "先に数値をVAR型変数に代入してください";
    OutOfRange
        "out of range",
        "範囲外です";
    Takes { command: SmolStr, bounds: Bounds, robot: &'static str }
        "{command} takes {bounds} on {robot}",
        "{robot}の{command}に使える値は{bounds}です";

    // Targets.
    WantsTarget { command: SmolStr, targets: List }
        "{command} wants a target, as {targets}",
        "{command}には対象({targets}など)が必要です";
    TargetBelongsHere { targets: List }
        "a target belongs here, as {targets}",
        "ここには対象({targets}など)を書きます";
    RobotHasNo { robot: &'static str, target: Target }
        "{robot} has no {target}",
        "{robot}に{target}はありません";
    OtherTargets { command: SmolStr, target: Target, targets: List }
        "{command} takes no {target}; its targets are such as {targets}",
        "{command}の対象に{target}は使えません。使えるのは{targets}などです";
    RobotHas { inventory: Inventory } "{inventory}", "{inventory}";
    MovesFeet { command: SmolStr, other: &'static str }
        "{command} is for feet; for a joint write {other}",
        "{command}は足先のコマンドです。関節には{other}を使ってください";

    // Variables to fill, inputs, native commands.
    PosVariable
        "a POS variable belongs here",
        "ここにはPOS型変数を書きます";
    JointVariable
        "a JOINT variable belongs here",
        "ここにはJOINT型変数を書きます";
    VarOrJointMember
        "a VAR or a member of a JOINT belongs here",
        "ここにはVAR型変数かJOINT型変数のメンバを書きます";
    VarBelongsHere
        "a VAR belongs here",
        "ここにはVAR型変数を書きます";
    ConstantBelongsHere
        "a constant belongs here",
        "ここには定数を書きます";
    OneBoard
        "there is one A/D board: number 0",
        "A/Dボードは0番の1枚だけです";
    Channels
        "the board has the channels 0…15",
        "ボードのチャンネルは0…15です";
    NoInput { robot: &'static str, name: SmolStr }
        "{robot} has no input `{name}`",
        "{robot}に `{name}` という入力はありません";
    Inputs { inventory: Inventory }
        "inputs are VR1…VR3, joints; {inventory}",
        "入力はVR1…VR3と関節です。{inventory}";
    InputsWith { others: List, inventory: Inventory }
        "inputs are VR1…VR3, joints, {others}; {inventory}",
        "入力はVR1…VR3、関節、{others}です。{inventory}";
    NativeCommands
        "native commands have the numbers 0…255",
        "ネイティブコマンドの番号は0…255です";

    // FOR.
    NeverEnds
        "FOR never ends with a step of 0",
        "STEPが0だとFORは終わりません";
    CountOtherwise
        "count by another number, or leave STEP out to count by 1",
        "0以外の刻みにするか、STEPを省いて1ずつ数えてください";
    CountsVar
        "the variable of a FOR is a VAR",
        "FORの変数はVAR型です";
    CountVar
        "count a VAR, as `FOR I = 1 TO 10`",
        "`FOR I = 1 TO 10` のように、VAR型変数で数えてください";

    // Event flags.
    VariableNoCondition { name: SmolStr }
        "`{name}` is a variable; alone it is not a condition",
        "`{name}` は変数です。それだけでは条件式になりません";
    Compare { name: SmolStr }
        "compare it with something: `{name} <> 0`",
        "`{name} <> 0` のように何かと比較してください";
    NoEventFlag { robot: &'static str, name: SmolStr }
        "{robot} has no event flag `{name}`",
        "{robot}に `{name}` というイベントフラグはありません";
    Flags { inventory: Inventory }
        "flags are HALT_REQUEST, KB_HIT, INPOS_F1 and NEAR_F1 (or another target), SPECIAL_FLAG0…9; {inventory}",
        "フラグはHALT_REQUEST、KB_HIT、INPOS_F1とNEAR_F1(F1の代わりに他の対象も可)、SPECIAL_FLAG0…9です。{inventory}";
    FlagsWith { others: List, inventory: Inventory }
        "flags are HALT_REQUEST, KB_HIT, INPOS_F1 and NEAR_F1 (or another target), SPECIAL_FLAG0…9, {others}; {inventory}",
        "フラグはHALT_REQUEST、KB_HIT、INPOS_F1とNEAR_F1(F1の代わりに他の対象も可)、SPECIAL_FLAG0…9、{others}です。{inventory}";
}
