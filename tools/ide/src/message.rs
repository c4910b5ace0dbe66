//! Texts for editors: about a word, beside a line, and why a name cannot be changed.

use smol_str::SmolStr;
use tipc::language::Bilingual;
use tipc::message::Message;
use tipc::message::list::{Each, List};

tipc::message_table! {
    /// What an editor shows.
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
        "stands for {value}",
        "値は{value}です";

    // At a name.
    DeclaredOn { line: u32 }
        "declared on line {line}",
        "{line}行目で宣言されています";
    Predeclared
        "every program has it",
        "すべてのプログラムにあります";
    Touched { assigned: usize, read: usize }
        "places that assign it: {assigned}; that read it: {read}",
        "代入: {assigned}か所、参照: {read}か所";
    Given { values: List }
        "all that is assigned to it: {values}",
        "代入される値: {values}";
    Counted { from: f64, to: f64 }
        "FOR counts it from {from} to {to}",
        "FORが{from}から{to}まで数えます";
    Jumped { jumps: usize, calls: usize }
        "places that jump to it: {jumps}; that call it: {calls}",
        "ジャンプ: {jumps}か所、呼び出し: {calls}か所";
    Returns { length: Box<Message> }
        "until it returns: {length}",
        "戻るまで: {length}";
    Step { step: u32 }
        "step {step}",
        "ステップ{step}";

    // How long something takes.
    Lasts { cycles: String }
        "{cycles} cycles",
        "{cycles}周期";
    LastsTimed { cycles: String, ms: String }
        "{cycles} cycles, {ms} ms",
        "{cycles}周期、{ms} ms";
    AndWaits { length: Box<Message> }
        "{length}, plus waits",
        "{length}と待ち時間";
    OneTurn { length: Box<Message> }
        "each turn: {length}",
        "1回あたり{length}";
    Turns { turns: String, length: Box<Message> }
        "{turns} turns, {length}",
        "{turns}回繰り返し、{length}";
    NeverRuns
        "never runs",
        "実行されません";

    // What is offered.
    FixAll
        "Put right everything that is certain",
        "確実な修正をすべて適用する";

    // Names that cannot be changed.
    NoName
        "there is no name here that can be changed",
        "ここには変更できる名前がありません";
    KeepsName { word: SmolStr }
        "`{word}` is a word of the language and keeps its name",
        "`{word}` はこの言語の語なので、名前は変えられません";
    LoopLabel
        "GOTO without a label leads to LOOP: another name would change what the program does",
        "ラベルのないGOTOはLOOPへ飛びます。名前を変えるとプログラムの動作が変わります";
    Taken { name: SmolStr, line: u32 }
        "`{name}` is declared on line {line}; choose another name",
        "`{name}` は{line}行目で宣言されています。別の名前にしてください";
    OtherMeaning { name: SmolStr }
        "with the name `{name}` this would be another program",
        "名前を `{name}` にすると別のプログラムになってしまいます";
}
