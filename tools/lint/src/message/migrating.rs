//! Messages about programs of older versions.

use super::{Changes, Declared, Loads, Questions};
use tipc::language::Edition;
use tipc::message::{Message, Text};

tipc::message_table! {
    /// Messages of the migration of a program.
    Migrating;

    // Lines 1 and 2.
    WhichVersion
        "line 1 names no version: which version of the language is this program written for?",
        "1行目にバージョンがありません。どのバージョンの言語で書かれたプログラムですか?";
    UnknownVersion { version: String }
        "no version {version} of the language is known (1.0 to 3.1, and 4.0 in some programs of the time of 2.1): which one is this program written for?",
        "バージョン{version}の言語は知られていません(1.0から3.1まで。2.1の頃のプログラムには4.0もあります)。どのバージョンで書かれたプログラムですか?";
    Version { version: String }
        "version {version} becomes 3.1",
        "バージョン{version}を3.1にします";
    ToVersion { to: &'static str }
        "line 1 becomes {to}",
        "1行目を{to}にします";
    LabelIn3_2 { name: String, new: String }
        "the label {name} becomes {new}: {name} is a word of the language in 3.2",
        "ラベル{name}を{new}にします。{name}は3.2の予約語です";
    VariableIn3_2 { name: String, new: String }
        "the variable {name} becomes {new}: {name} is a word of the language in 3.2",
        "変数{name}を{new}にします。{name}は3.2の予約語です";
    ShowsMore
        "this MESSAGE shows more values in 3.2: which text is meant?",
        "3.2ではこのMESSAGEに表示される値が増えます。どの文字列にしますか?";
    RefusedIn3_2 { title: Text, reason: Box<Message> }
        "3.2 does not load this: {title}: {reason}",
        "3.2ではここを読み込めません: {title}: {reason}";
    EmptyTitle
        "put in an empty line 2: since 1.1 it holds the title",
        "2行目に空行を入れます。1.1から2行目は題名です";

    // Commands and equations.
    IsSince2_0 { old: String, new: String }
        "{old} is {new} since 2.0",
        "{old}は2.0から{new}です";
    IsSince3_1 { old: String, new: String }
        "{old} is {new} since 3.1",
        "{old}は3.1から{new}です";
    TwoSuccessors { old: String, target: String, feet: String, joints: String }
        "{old} {target} has two successors: {feet} takes feet (mm), {joints} joints (deg); which one is meant?",
        "{old} {target}の後継は2つあります。{feet}は足先(mm)、{joints}は関節(deg)です。どちらですか?";
    NotTheAngles
        "these are not the angles that COMPLIANCE_ANGLE takes, one for each joint: which of them are angles, and which is the stiffness for SET_ANGLE_STIFFNESS?",
        "COMPLIANCE_ANGLEの引数は関節ごとの角度ですが、数が合いません。どれが角度で、どれがSET_ANGLE_STIFFNESSの剛性ですか?";
    Compliance
        "COMPLIANCE is COMPLIANCE_ANGLE since 2.1",
        "COMPLIANCEは2.1からCOMPLIANCE_ANGLEです";
    AssignmentBehindFor { variable: String }
        "`=` after FOR {variable} since 3.1",
        "3.1からFOR {variable}の後に `=` を書きます";
    Sign { operand: String }
        "`- {operand}` is `-{operand}` since 2.0",
        "`- {operand}` は2.0から `-{operand}` です";
    Remark
        "REM becomes //: since 3.0 REM is a step of its own",
        "REMを//にします。3.0からREMは1ステップです";

    // WAIT_NEAR.
    OneTolerance
        "WAIT_NEAR takes one tolerance, not negative: which one is meant?",
        "WAIT_NEARの許容範囲は0以上の数値1個です。どれですか?";
    WholeLeg { target: String, leg: String }
        "{target} is moved to positions, and a tolerance in mm is set for a whole leg: may it be SET_NEAR_POSITION F{leg}?",
        "{target}は位置で動かしていますが、mmの許容範囲は脚全体に設定します。SET_NEAR_POSITION F{leg}でよいですか?";
    TwoSteps { setting: &'static str }
        "two steps, {setting} and WAIT_NEAR: since 3.1 the tolerance is set beforehand, and stays set",
        "{setting}とWAIT_NEARの2ステップにします。3.1から許容範囲は先に設定し、そのまま残ります";
    WhichMeasure { target: String }
        "the program moves {target} to positions and to angles: is this tolerance in mm (SET_NEAR_POSITION) or in deg (SET_NEAR_ANGLE)?",
        "このプログラムは{target}を位置でも角度でも動かします。許容範囲はmm(SET_NEAR_POSITION)ですか、deg(SET_NEAR_ANGLE)ですか?";

    // MESSAGE.
    Semicolon
        "`;` ends a MESSAGE since 3.0: which character should stand here instead?",
        "3.0から `;` はMESSAGEの終わりです。代わりにどの文字にしますか?";
    PlainText { name: String }
        "`%{name}%` was plain text and shows a value since 3.0: which one is meant?",
        "`%{name}%` は文字のままでしたが、3.0からは値を表示します。どちらですか?";
    Placeholder { old: String, new: String }
        "in a MESSAGE, {old} is {new} since 3.0",
        "MESSAGEの中の{old}は3.0から{new}です";

    // Names.
    Label { name: String, new: String }
        "the label {name} becomes {new}: {name} is a word of the language in 3.1",
        "ラベル{name}を{new}にします。{name}は3.1の予約語です";
    WordOfLanguage { word: String }
        "{word} is a word of the language in 3.1: what should the variable be called?",
        "{word}は3.1の予約語です。変数を何という名前にしますか?";
    Declares { line: Text, declared: Declared }
        "put in `{line}`{declared}",
        "`{line}` を入れます{declared}";
    OneVariable { old: String, name: String }
        "{old} and {name} are one variable by their number: written {name}",
        "{old}と{name}は番号から同じ変数です。{name}と書きます";
    NoNumber { name: String }
        "{name} has no number: which variable is meant?",
        "{name}に番号がありません。どの変数ですか?";
    NameTooLong { most: usize, name: String, length: usize }
        "a name has at most {most} bytes, {name} has {length}: what should the variable be called?",
        "名前は{most}バイトまでですが、{name}は{length}バイトあります。変数を何という名前にしますか?";

    // The last look.
    NoEnd
        "the program has no END: where does it end?",
        "プログラムにENDがありません。どこで終わりますか?";
    NoCommand { word: String }
        "{word} is not a command of version 3.1: what is meant?",
        "{word}は3.1のコマンドではありません。何のことですか?";
    NoStatement { title: Text, reason: Box<Message> }
        "this is not a statement of version 3.1 ({title}: {reason}): what is meant?",
        "これは3.1の文ではありません({title}: {reason})。何のことですか?";

    // The sentence at the end of the report.
    AlreadyCurrent { file: Text, version: Edition }
        "{file}: is a program of version {version} already, nothing is changed",
        "{file}: すでにバージョン{version}のプログラムです。何も変えません";
    Migrated { file: Text, changes: Changes, loads: Loads }
        "{file}: {changes}, {loads}",
        "{file}: {changes}、{loads}";
    ToAnswer { file: Text, questions: Questions }
        "{file}: {questions} to answer first, nothing is written",
        "{file}: 先に{questions}に答えてください。何も書いていません";
}
