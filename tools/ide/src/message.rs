//! The messages of this crate: facts about words and durations, titles of code actions, reasons why a name cannot be changed, and
//! the texts of the debug adapter.

use smol_str::SmolStr;
use tipc::language::Bilingual;
use tipc::message::list::{Each, List};
use tipc::message::{Message, Text};

tipc::message_table! {
    /// Messages of editor features.
    Editing;

    // At a word of the language.
    Unit { unit: &'static str }
        "unit: {unit}",
        "単位: {unit}";
    NoStep
        "takes no step",
        "ステップになりません";
    OneCycle
        "takes 1 control cycle",
        "1制御周期かかります";
    Waits { what: Bilingual }
        "takes at least 1 control cycle, until {what}",
        "少なくとも1制御周期かかり、次の条件まで待ちます: {what}";
    OnlyFor { robots: Each }
        "only for {robots}",
        "使えるロボット: {robots}";
    Stops { fault: String, when: Bilingual }
        "emergency stop, {fault}: {when}",
        "緊急停止({fault}): {when}";
    Reference { section: &'static str, clause: &'static str }
        "T.I.P. 3.1 {section}, clause {clause} of the language reference",
        "T.I.P. 3.1 {section}、言語リファレンス {clause}";
    Value { value: f64 }
        "value: {value}",
        "値は{value}です";

    // At a name.
    DeclaredOn { line: u32 }
        "declared on line {line}",
        "{line}行目で宣言されています";
    Predeclared
        "predeclared in every program",
        "すべてのプログラムにあります";
    Touched { assigned: usize, read: usize }
        "assignments: {assigned}, reads: {read}",
        "代入: {assigned}か所、参照: {read}か所";
    Given { values: List }
        "assigned values: {values}",
        "代入される値: {values}";
    Counted { from: f64, to: f64 }
        "FOR counts it from {from} to {to}",
        "FORが{from}から{to}まで数えます";
    Jumped { jumps: usize, calls: usize }
        "jumps: {jumps}, calls: {calls}",
        "ジャンプ: {jumps}か所、呼び出し: {calls}か所";
    Returns { duration: Box<Message> }
        "until it returns: {duration}",
        "戻るまで: {duration}";
    Step { step: u32 }
        "step {step}",
        "ステップ{step}";

    // Durations.
    Lasts { cycles: String }
        "{cycles} cycles",
        "{cycles}周期";
    LastsTimed { cycles: String, ms: String }
        "{cycles} cycles, {ms} ms",
        "{cycles}周期、{ms} ms";
    AndWaits { duration: Box<Message> }
        "{duration}, plus waits",
        "{duration}と待ち時間";
    OneTurn { duration: Box<Message> }
        "each turn: {duration}",
        "1回あたり{duration}";
    Turns { turns: String, duration: Box<Message> }
        "{turns} turns, {duration}",
        "{turns}回繰り返し、{duration}";
    NeverRuns
        "never runs",
        "実行されません";

    // Titles of code actions.
    FixAll
        "Apply all certain fixes",
        "確実な修正をすべて適用する";

    // Names that cannot be changed.
    NoName
        "there is no name to rename here",
        "ここには変更できる名前がありません";
    KeepsName { word: SmolStr }
        "`{word}` is a word of the language and cannot be renamed",
        "`{word}` はこの言語の語なので、名前は変えられません";
    LoopLabel
        "GOTO without a label leads to LOOP: another name would change what the program does",
        "ラベルのないGOTOはLOOPへ飛びます。名前を変えるとプログラムの動作が変わります";
    Taken { name: SmolStr, line: u32 }
        "`{name}` is declared on line {line}; choose another name",
        "`{name}` は{line}行目で宣言されています。別の名前にしてください";
    OtherMeaning { name: SmolStr }
        "the name `{name}` would change the meaning of the program",
        "名前を `{name}` にすると別のプログラムになってしまいます";
}

tipc::message_table! {
    /// Messages of the debug adapter; those that every debugger shows are in `tip-sim`.
    DebugAdapter;

    // Titles.
    Robot
        "Robot",
        "ロボット";
    Searches
        "Searching",
        "検索中";
    FallsStop
        "Falls of the robot",
        "ロボットの転倒";

    // The state of the robot.
    Cycle
        "cycle",
        "サイクル";
    Time
        "time",
        "時刻";
    Pose
        "position of the body",
        "胴体の位置";
    Lean
        "roll, pitch, yaw",
        "ロール、ピッチ、ヨー";
    Falls
        "falls",
        "転倒回数";
    Locked
        "locked joints",
        "ロック中の関節";
    Angles { leg: usize }
        "angles of leg {leg}",
        "脚{leg}の関節角度";
    Loads
        "loads",
        "荷重";

    // Reasons for a stop.
    FellIn { cycle: usize }
        "the robot falls in cycle {cycle}",
        "サイクル{cycle}でロボットが転倒しました";
    FellBy { cycle: usize, outside: Text }
        "the robot falls in cycle {cycle}, {outside} mm outside its feet",
        "サイクル{cycle}でロボットが転倒しました(支持多角形の外{outside} mm)";
    EndedBy { word: &'static str }
        "the program is over ({word})",
        "プログラムは終了しました({word})";

    // Errors.
    NothingDebugged
        "no program is being debugged",
        "デバッグ中のプログラムがありません";
    AlreadyDebugged
        "a program is being debugged already",
        "すでに別のプログラムをデバッグしています";
    NothingToAttach
        "there is no program to attach to: use launch",
        "プログラムは launch で起動します。attach はできません";
    IsRunning
        "the program is running",
        "プログラムは実行中です";
    NothingHappened
        "neither a fall nor an emergency stopped the program here",
        "ここで転倒や非常停止は起きていません";
    OtherFile
        "this file is not the program being debugged",
        "このファイルはデバッグ中のプログラムではありません";
    OnlyVariables
        "only variables of the program can be watched",
        "監視できるのはプログラムの変数だけです";
    WatchHasNoCondition
        "a watch cannot have a condition; a breakpoint on a line can",
        "変数の監視に条件は付けられません。行のブレークポイントに付けてください";
    NoSuchList
        "there is no such list of variables",
        "その変数一覧はありません";
    Truth { text: Text }
        "`{text}` is a condition, not a number",
        "`{text}` は数ではなく条件です";
    AgainConfirms { refused: Text }
        "{refused}; repeat it to confirm",
        "{refused}。よければもう一度実行してください";
}
