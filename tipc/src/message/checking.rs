//! The texts of the checker: commands and their arguments, equations, names, and control structure.

use super::list::{Alternatives, Both, List};
use super::phrase::{
    Assign, Bounds, Entered, Inventory, Lacking, Numbers, Operands, Standing, Type,
};
use crate::language::Keyword;
use smol_str::SmolStr;
use tip_runtime::command::Target;

messages! {
    /// Messages about commands.
    Commanding;

    // Unknown commands, and commands of other robots.
    RobotLacks { robot: &'static str, command: &'static str } ["E204-02"]
        "{robot} has no {command}",
        "{robot}に{command}はありません";
    NeedsForces { command: &'static str }
        "{command} needs a robot that senses and gives torque: its description has no `[forces]`",
        "{command}には、トルクを測れて出せるロボットが必要です。ロボットの記述に `[forces]` がありません";
    CommandOf { command: &'static str, robots: Both }
        "{command} is a command of {robots}, which `--robot` or tip.toml chooses",
        "{command}は{robots}のコマンドです。ロボットは `--robot` か tip.toml で指定します";
    VariableNotCommand { name: SmolStr } ["E204-03"]
        "`{name}` is a variable, not a command",
        "`{name}` は変数で、コマンドではありません";
    OperatorBehindVariable { name: SmolStr }
        "an equation has an operator after its variable: `{name} = 0`",
        "式では変数の後に演算子を書きます: `{name} = 0`";
    NoCommand { word: SmolStr } ["E204-01"]
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
    OtherType { command: SmolStr, wanted: Numbers, found: Type } ["E205-08"]
        "{command} wants {wanted} here, not {found}",
        "{command}のここには{wanted}が必要ですが、{found}があります";
    TooFew { command: SmolStr, wanted: Numbers, found: Standing } ["E205-01"]
        "{command} wants {wanted}; {found} here",
        "{command}には{wanted}が必要ですが、{found}";
    WantsTwoJoints { command: SmolStr } ["E205-08"]
        "{command} wants two JOINTs for a leg: the lowest and the highest angles",
        "脚を指定した{command}には、下限と上限のJOINT型変数が2個必要です";
    TooMany { command: SmolStr } ["E205-02"]
        "one argument too many for {command}",
        "{command}の引数が多すぎます";
    ToleranceElsewhere ["E205-02"]
        "SET_NEAR_POSITION and SET_NEAR_ANGLE set the tolerance",
        "許容範囲はSET_NEAR_POSITIONかSET_NEAR_ANGLEで設定します";
    Missing { what: Lacking } ["E205-01"]
        "{what} is missing",
        "{what}がありません";
    FlagBeforeNumber { flag: SmolStr } ["E205-07"]
        "{flag} is a flag here: it stands before a number, and once",
        "ここでは{flag}はフラグです。数値の前に一度だけ書きます";
    NoFlag { flag: SmolStr } ["E205-07"]
        "this command takes no {flag}",
        "このコマンドに{flag}は付けられません";
    StructForNumber ["E107-06" "E205-08"]
        "a struct stands where one number belongs",
        "数値1個のところに構造体の変数があります";
    NameMember
        "name a member, as `P.X` or `Q.J2`",
        "`P.X` や `Q.J2` のようにメンバを書いてください";
    ConstantOrVar ["E107-06" "E205-08"]
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
    WantsTarget { command: SmolStr, targets: List } ["E205-03"]
        "{command} wants a target, as {targets}",
        "{command}には対象({targets}など)が必要です";
    TargetBelongsHere { targets: List } ["E205-03"]
        "a target belongs here, as {targets}",
        "ここには対象({targets}など)を書きます";
    RobotHasNo { robot: &'static str, target: Target } ["E205-04"]
        "{robot} has no {target}",
        "{robot}に{target}はありません";
    OtherTargets { command: SmolStr, target: Target, targets: List } ["E205-06"]
        "{command} takes no {target}; its targets are such as {targets}",
        "{command}の対象に{target}は使えません。使えるのは{targets}などです";
    RobotHas { inventory: Inventory } "{inventory}", "{inventory}";
    MovesFeet { command: SmolStr, other: &'static str } ["E205-05"]
        "{command} is for feet; for a joint write {other}",
        "{command}は足先のコマンドです。関節には{other}を使ってください";

    // Variables to fill, inputs, native commands.
    PosVariable ["E205-09"]
        "a POS variable belongs here",
        "ここにはPOS型変数を書きます";
    JointVariable ["E205-09"]
        "a JOINT variable belongs here",
        "ここにはJOINT型変数を書きます";
    VarOrJointMember ["E205-09"]
        "a VAR or a member of a JOINT belongs here",
        "ここにはVAR型変数かJOINT型変数のメンバを書きます";
    VarBelongsHere ["E205-09"]
        "a VAR belongs here",
        "ここにはVAR型変数を書きます";
    ConstantBelongsHere ["E205-11"]
        "a constant belongs here",
        "ここには定数を書きます";
    OneBoard ["E205-10"]
        "there is one A/D board: number 0",
        "A/Dボードは0番の1枚だけです";
    Channels ["E205-10"]
        "the board has the channels 0…15",
        "ボードのチャンネルは0…15です";
    NoInput { robot: &'static str, name: SmolStr } ["E205-12"]
        "{robot} has no input `{name}`",
        "{robot}に `{name}` という入力はありません";
    Inputs { inventory: Inventory }
        "inputs are VR1…VR3, joints; {inventory}",
        "入力はVR1…VR3と関節です。{inventory}";
    InputsWith { others: List, inventory: Inventory }
        "inputs are VR1…VR3, joints, {others}; {inventory}",
        "入力はVR1…VR3、関節、{others}です。{inventory}";
    NativeCommands ["E205-10"]
        "native commands have the numbers 0…255",
        "ネイティブコマンドの番号は0…255です";

    // FOR.
    NeverEnds
        "FOR never ends with a step of 0",
        "STEPが0だとFORは終わりません";
    CountOtherwise
        "count by another number, or leave STEP out to count by 1",
        "0以外の刻みにするか、STEPを省いて1ずつ数えてください";
    CountsVar ["E205-18"]
        "the variable of a FOR is a VAR",
        "FORの変数はVAR型です";
    CountVar
        "count a VAR, as `FOR I = 1 TO 10`",
        "`FOR I = 1 TO 10` のように、VAR型変数で数えてください";

    // Event flags.
    VariableNoCondition { name: SmolStr } ["E205-14"]
        "`{name}` is a variable; alone it is not a condition",
        "`{name}` は変数です。それだけでは条件式になりません";
    Compare { name: SmolStr }
        "compare it with something: `{name} <> 0`",
        "`{name} <> 0` のように何かと比較してください";
    NoEventFlag { robot: &'static str, name: SmolStr } ["E205-13"]
        "{robot} has no event flag `{name}`",
        "{robot}に `{name}` というイベントフラグはありません";
    Flags { inventory: Inventory }
        "flags are HALT_REQUEST, KB_HIT, INPOS_F1 and NEAR_F1 (or another target), SPECIAL_FLAG0…9; {inventory}",
        "フラグはHALT_REQUEST、KB_HIT、INPOS_F1とNEAR_F1(F1の代わりに他の対象も可)、SPECIAL_FLAG0…9です。{inventory}";
    FlagsWith { others: List, inventory: Inventory }
        "flags are HALT_REQUEST, KB_HIT, INPOS_F1 and NEAR_F1 (or another target), SPECIAL_FLAG0…9, {others}; {inventory}",
        "フラグはHALT_REQUEST、KB_HIT、INPOS_F1とNEAR_F1(F1の代わりに他の対象も可)、SPECIAL_FLAG0…9、{others}です。{inventory}";
}

messages! {
    /// Messages about equations.
    Calculating;

    // The left side.
    LeftSideIs
        "the left side is a variable or a member",
        "左辺に書けるのは変数かメンバです";
    LeftSideSign ["E107-01"]
        "the left side has no sign",
        "左辺に符号は付けられません";
    LeftSide
        "the left side",
        "左辺はここです";

    // Types.
    SidesDiffer { left: Type, right: Type } ["E107-06"]
        "the left side is {left}, the right side {right}",
        "左辺は{left}、右辺は{right}です";
    NotTogether { first: Type, second: Type } ["E107-06"]
        "{first} and {second} do not go together",
        "{first}と{second}は一緒に計算できません";
    OneType
        "an equation is all numbers, all POS or all JOINT; members, as `P.X`, are numbers",
        "式の全体を、数値だけ、POSだけ、JOINTだけのどれかにします。`P.X` のようなメンバは数値です";
    BelongsHere { wanted: Type } ["E107-06"]
        "{wanted} belongs here",
        "ここには{wanted}を書きます";
    WholeVariable
        "a whole variable, as `P`; a member is a number",
        "`P` のように変数全体を書きます。メンバは数値です";
    StructSign ["E107-06"]
        "a struct has no sign",
        "構造体の変数に符号は付けられません";
    ChangeMembers
        "change the sign of each member, as `P.X = -P.X`",
        "`P.X = -P.X` のように、メンバごとに符号を変えてください";

    // Functions.
    OtherOperands { function: SmolStr, wanted: Operands, found: usize } ["E107-07"]
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

messages! {
    /// Messages about names.
    Naming;

    // Labels and variables.
    WordOfLanguage { word: SmolStr } ["E205-21"]
        "`{word}` is a word of the language",
        "`{word}` はこの言語の予約語です";
    ChooseAnother
        "choose another name",
        "別の名前にしてください";
    DeclaredAgain { name: SmolStr } ["E205-22"]
        "`{name}` is declared again",
        "`{name}` が二重に宣言されています";
    FirstDeclared
        "first declared here",
        "最初の宣言はここです";
    DeclaredHere
        "declared here",
        "宣言はここです";

    // Labels.
    NoLabelName { word: SmolStr } ["E205-21"]
        "`{word}` cannot name a label",
        "`{word}` はラベル名に使えません";
    LabelCharacters
        "a label is made of letters, digits and `_`",
        "ラベル名に使えるのは英字、数字、`_` です";
    OwnName
        "give each label a name of its own; only LOOP may stand more than once",
        "ラベルには別々の名前を付けてください。何度も使えるのはLOOPだけです";
    SubroutineLoop ["E205-21"]
        "a SUBROUTINE cannot be named LOOP",
        "SUBROUTINEにLOOPという名前は付けられません";
    ThreadLoop ["E205-21"]
        "a THREAD cannot be named LOOP",
        "THREADにLOOPという名前は付けられません";
    TooManyThreads { most: usize } ["E205-28"]
        "a program has at most {most} threads",
        "1つのプログラムのスレッドは{most}本までです";

    // Constants.
    NotConstant { name: SmolStr } ["E205-11"]
        "`{name}` is not a constant",
        "`{name}` は定数ではありません";
    ConstantIs
        "DEFINE wants a number, a CHAR_ constant or a constant defined above",
        "DEFINEの値は、数値、CHAR_定数、または上で定義した定数です";
    DefinedBelow { name: SmolStr }
        "`{name}` is not defined above this line",
        "`{name}` はこの行より上で定義されていません";
    DefineAbove
        "put its DEFINE above this one",
        "そのDEFINEをこれより上に書いてください";
    ConstantMembers { name: SmolStr }
        "`{name}` is a constant: it has no members",
        "`{name}` は定数で、メンバはありません";
    NothingUsesConstant
        "nothing uses this constant",
        "この定数はどこでも使われていません";

    // Special variables.
    NoReading { word: SmolStr }
        "there is no special variable `{word}`",
        "`{word}` という特殊変数はありません";
    Readings
        "the special variables are @AGL_Jnm, @TRQ_Jnm, @AGL_Fn, @TRQ_Fn, @POS_Fn, @FORCE_Fn and @TIMER0…@TIMER7",
        "特殊変数は@AGL_Jnm、@TRQ_Jnm、@AGL_Fn、@TRQ_Fn、@POS_Fn、@FORCE_Fn、@TIMER0…@TIMER7です";
    NotSensed { robot: &'static str, word: SmolStr } ["E205-12"]
        "{robot} cannot measure `{word}`",
        "{robot}は `{word}` を測れません";
    ReadingAssigned { word: SmolStr } ["E107-01"]
        "`{word}` can only be read",
        "`{word}` は読み出し専用です";
    ReadingMembers { word: SmolStr }
        "the members of a position are X, Y, Z, those of joint values J1, J2 and so on; a number has none: look at `{word}`",
        "位置のメンバはX、Y、Z、関節の値のメンバはJ1、J2…です。数値にメンバはありません。`{word}` を確かめてください";

    // Variables.
    NoNames ["E205-23"]
        "this declaration names no variable",
        "宣言に変数名がありません";
    WriteNames
        "write the names after it, separated by blanks or commas",
        "後に変数名を、空白かコンマで区切って書いてください";
    ReadAsFlag
        "motion commands read this word as their flag",
        "移動系コマンドはこの語をフラグとして読みます";
    FlagHere
        "the flag, not the variable",
        "変数ではなくフラグです";
    NoVariableName { word: SmolStr } ["E205-21"]
        "`{word}` cannot name a variable",
        "`{word}` は変数名に使えません";
    VariableCharacters
        "a name is made of letters, digits and `_`, and does not start with a digit",
        "名前に使えるのは英字、数字、`_` で、先頭に数字は使えません";
    DeclareOnce
        "declare it once",
        "宣言は一度だけにしてください";
    NotDeclared { name: SmolStr }
        "`{name}` is not declared",
        "`{name}` は宣言されていません";
    NoNumber { word: SmolStr }
        "`{word}` is a word of the language and does not stand for a number",
        "`{word}` はこの言語の予約語で、数値にはなりません";
    NumberBelongsHere
        "a number or a variable belongs here",
        "ここには数値か変数を書きます";
    Declare { name: SmolStr }
        "declare it: `DEF_VAR {name}`, `DEF_POS {name}` or `DEF_JOINT {name}`",
        "`DEF_VAR {name}`、`DEF_POS {name}`、`DEF_JOINT {name}` のどれかで宣言してください";
    DeclareAs { declaration: SmolStr }
        "declare it: `{declaration}`",
        "`{declaration}` と宣言してください";
    AlsoHere
        "used here too",
        "ここでも使われています";
    NoMember { name: SmolStr, member: SmolStr } ["E107-05" "E205-25"]
        "`{name}` has no member `{member}`",
        "`{name}` に `{member}` というメンバはありません";
    VarMembers { name: SmolStr }
        "`{name}` is a VAR: it has no members",
        "`{name}` はVAR型で、メンバはありません";
    PosMembers { name: SmolStr }
        "`{name}` is a POS: it has the members X, Y, Z",
        "`{name}` はPOS型で、メンバはX、Y、Zです";
    JointMembers { name: SmolStr, last: usize }
        "`{name}` is a JOINT: on this robot it has the members J1…J{last}",
        "`{name}` はJOINT型で、このロボットではメンバはJ1…J{last}です";

    // Use.
    NoValueOnAnyWay { name: SmolStr }
        "`{name}` has no value here, on whatever way the program comes",
        "どの経路を通っても、ここで `{name}` に値がありません";
    NothingUses
        "nothing uses this name",
        "この名前はどこでも使われていません";
    NothingReads
        "nothing reads this variable",
        "この変数はどこでも読まれていません";
    AssignedNowhere { name: SmolStr }
        "`{name}` is read here and never assigned",
        "`{name}` はここで読まれますが、どこでも代入されていません";
    AssignBefore { assign: Assign } "{assign}", "{assign}";
}

messages! {
    /// Messages about blocks and jumps.
    Structuring;

    // Openers and closers.
    SubroutineInside { opener: Keyword } ["E207-03"]
        "this SUBROUTINE stands inside {opener}",
        "このSUBROUTINEは{opener}の中にあります";
    ThreadInside { opener: Keyword } ["E207-03"]
        "this THREAD stands inside {opener}",
        "このTHREADは{opener}の中にあります";
    StillOpen { opener: Keyword }
        "this {opener} is still open",
        "この{opener}がまだ閉じていません";
    CloseBefore { opener: Keyword, closer: Keyword }
        "close {opener} with {closer} before it",
        "その前で{opener}を{closer}で閉じてください";
    BehindElse { word: Keyword } ["E207-04"]
        "{word} stands after the ELSE of its IF",
        "{word}が、そのIFのELSEより後にあります";
    Else
        "the ELSE",
        "ELSEはここです";
    ElseIsLast
        "ELSE is the last branch of an IF",
        "ELSEはIFの最後の分岐です";
    NothingOpen { opener: Keyword, word: Keyword } ["E207-02"]
        "no {opener} is open for this {word}",
        "この{word}に対応する{opener}がありません";
    Opens { opener: Keyword, closer: Keyword }
        "{opener} opens what {closer} closes",
        "{opener}で始めて{closer}で閉じます";
    IfFirst { word: Keyword }
        "{word} stands between `IF condition THEN` and its ENDIF",
        "{word}は `IF 条件式 THEN` とそのENDIFの間に書きます";
    SubEndCloses
        "SUBEND closes a SUBROUTINE; a part that GOSUB calls ends with RETURN",
        "SUBENDはSUBROUTINEを閉じます。GOSUBで呼ぶ部分の終わりはRETURNです";
    ThreadEndCloses
        "THREADEND closes a THREAD",
        "THREADENDはTHREADを閉じます";
    Open { opener: Keyword }
        "this {opener} is open",
        "この{opener}が開いています";
    StandsHere { word: Keyword }
        "its {word} stands here",
        "対応する{word}はここにあります";
    NotClosed { opener: Keyword } ["E207-01"]
        "this {opener} is not closed",
        "この{opener}が閉じていません";
    CloseWith { closer: Keyword }
        "close it with {closer}",
        "{closer}で閉じてください";
    SubroutineBefore { closer: Keyword }
        "this SUBROUTINE comes before {closer}",
        "{closer}より先にSUBROUTINEがあります";
    WordBefore { word: Keyword, closer: Keyword }
        "{word} comes before {closer}",
        "{closer}より先に{word}があります";
    ClosesOuter { word: Keyword }
        "this {word} is that of a loop around it",
        "この{word}は外側のループのものです";
    EndsBefore { closer: Keyword }
        "the program ends before {closer}",
        "{closer}がないままプログラムが終わっています";
    NextNames { name: SmolStr } ["E207-05"]
        "this NEXT names {name}",
        "このNEXTの変数は{name}です";
    VariableOfFor
        "the variable of its FOR",
        "対応するFORの変数はこれです";

    // Jumps.
    JumpsHere
        "this jump goes there",
        "このジャンプの飛び先です";
    NoSuchLabel { name: SmolStr }
        "no label is called `{name}:`",
        "`{name}:` というラベルはありません";
    DidYouMean { near: SmolStr }
        "did you mean `{near}:`?",
        "`{near}:` の間違いではありませんか?";
    DeclareLabel { name: SmolStr }
        "put `{name}:` before the statement that is meant",
        "飛び先の文の前に `{name}:` を書いてください";
    WriteThread { name: SmolStr }
        "write the thread: `THREAD {name}:` … `THREADEND`",
        "スレッドを `THREAD {name}:` … `THREADEND` と書いてください";
    PlainLabel { name: SmolStr } ["E205-20"]
        "`{name}` is a plain label, not a SUBROUTINE",
        "`{name}` は普通のラベルで、SUBROUTINEではありません";
    NoThread { name: SmolStr } ["E205-20"]
        "`{name}` is not a THREAD",
        "`{name}` はTHREADではありません";
    OnlyThreads
        "START_THREAD, STOP_THREAD and WAIT_THREAD name a THREAD",
        "START_THREAD、STOP_THREAD、WAIT_THREADにはTHREADの名前を書きます";
    CalledThread { name: SmolStr } ["E205-20"]
        "`{name}` is a THREAD, which cannot be called",
        "`{name}` はTHREADなので、呼び出せません";
    StartIt
        "START_THREAD starts it",
        "START_THREADで動かしてください";
    GosubCalls
        "GOSUB calls plain labels",
        "普通のラベルはGOSUBで呼びます";
    LoopForGoto ["E205-20"]
        "LOOP is a label for GOTO only",
        "LOOPはGOTO専用のラベルです";
    OwnLabel
        "give the routine a label of its own",
        "呼び出す先には別のラベルを付けてください";
    NoLoopAbove
        "no LOOP label stands above this jump",
        "このジャンプより上にLOOPラベルがありません";
    PutLoop
        "put `LOOP:` where the repetition starts",
        "繰り返しの始まりに `LOOP:` を置いてください";
    Enters { block: Entered } ["E207-06"]
        "this jump enters {block} from outside",
        "このジャンプは外から{block}の中に入ります";
    MoveOut
        "move the label out of the branch",
        "ラベルを分岐の外に移してください";
    JumpBefore { opener: Keyword }
        "jump to a label before the {opener}",
        "{opener}より前のラベルにジャンプしてください";
    CallIt
        "CALL the SUBROUTINE",
        "SUBROUTINEはCALLで呼んでください";
    BlockStarts
        "the block starts here",
        "ブロックはここで始まります";
    Label
        "the label",
        "ラベルはここです";
    LeavesSubroutine ["E207-07"]
        "GOTO leaves its SUBROUTINE",
        "GOTOでSUBROUTINEの外に出ています";
    LeavesThread ["E207-07"]
        "GOTO leaves its THREAD",
        "GOTOでTHREADの外に出ています";
    ThreadStarts
        "the THREAD starts here",
        "THREADはここで始まります";
    ThreadEndsAt
        "a thread ends with THREADEND, or with RETURN outside of a call",
        "スレッドはTHREADENDか、呼び出し中でないRETURNで終わります";
    SubroutineStarts
        "the SUBROUTINE starts here",
        "SUBROUTINEはここで始まります";
    LeaveWith
        "leave a SUBROUTINE with RETURN or SUBEND",
        "SUBROUTINEからはRETURNかSUBENDで戻ります";
    NextCounts
        "NEXT counts a variable that FOR may not have set",
        "FORで初期化されていない変数をNEXTが数えるおそれがあります";
    For
        "the FOR",
        "FORはここです";
    RunsInto
        "its SUBEND stops a program that comes this way",
        "ここを通って入ると、SUBENDで緊急停止します";
    RunsIntoSubroutine ["E207-09"]
        "only a call leads into a SUBROUTINE, and a way comes here without one",
        "SUBROUTINEには呼び出しで入りますが、呼び出しなしでここに来る経路があります";
    RunsIntoThread ["E207-09"]
        "a thread begins only where START_THREAD starts it",
        "スレッドはSTART_THREADで動かしたときだけ始まります";
    PutJumpAbove
        "put GOTO, RETURN or EXIT above it",
        "その上にGOTO、RETURN、EXITのどれかを置いてください";
    ReturnOfGosub
        "RETURN ends a part that GOSUB calls, not a SUBROUTINE",
        "RETURNはGOSUBで呼ぶ部分の終わりです。SUBROUTINEは閉じません";
}
