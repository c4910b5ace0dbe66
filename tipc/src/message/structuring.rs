//! What is said of blocks and jumps.

use super::phrase::Entered;
use crate::language::Keyword;
use smol_str::SmolStr;

messages! {
    /// What is said of blocks and jumps.
    Structuring;

    // Openers and closers.
    SubroutineInside { opener: Keyword }
        "this SUBROUTINE stands inside {opener}",
        "このSUBROUTINEは{opener}の中にあります";
    StillOpen { opener: Keyword }
        "this {opener} is still open",
        "この{opener}がまだ閉じていません";
    CloseBefore { opener: Keyword, closer: Keyword }
        "close {opener} with {closer} before it",
        "その前で{opener}を{closer}で閉じてください";
    BehindElse { word: Keyword }
        "{word} stands after the ELSE of its IF",
        "{word}が、そのIFのELSEより後にあります";
    Else
        "the ELSE",
        "ELSEはここです";
    ElseIsLast
        "ELSE is the last branch of an IF",
        "ELSEはIFの最後の分岐です";
    NothingOpen { opener: Keyword, word: Keyword }
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
    Open { opener: Keyword }
        "this {opener} is open",
        "この{opener}が開いています";
    StandsHere { word: Keyword }
        "its {word} stands here",
        "対応する{word}はここにあります";
    NotClosed { opener: Keyword }
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
    NextNames { name: SmolStr }
        "this NEXT names {name}",
        "このNEXTの変数は{name}です";
    NextNamesAnother
        "this NEXT names another variable",
        "このNEXTの変数が違います";
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
    PlainLabel { name: SmolStr }
        "`{name}` is a plain label, not a SUBROUTINE",
        "`{name}` は普通のラベルで、SUBROUTINEではありません";
    GosubCalls
        "GOSUB calls plain labels",
        "普通のラベルはGOSUBで呼びます";
    LoopForGoto
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
    Enters { block: Entered }
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
    LeavesSubroutine
        "GOTO leaves its SUBROUTINE",
        "GOTOでSUBROUTINEの外に出ています";
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
    PutJumpAbove
        "put GOTO, RETURN or EXIT above it",
        "その上にGOTO、RETURN、EXITのどれかを置いてください";
    ReturnOfGosub
        "RETURN ends a part that GOSUB calls, not a SUBROUTINE",
        "RETURNはGOSUBで呼ぶ部分の終わりです。SUBROUTINEは閉じません";
}
