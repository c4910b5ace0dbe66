//! What is said of blocks and jumps.

use super::phrase::Entered;
use crate::language::Keyword;
use smol_str::SmolStr;

messages! {
    /// What is said of blocks and jumps.
    Structuring;

    // Openers and closers.
    SubroutineInside { opener: Keyword } "this SUBROUTINE stands inside {opener}";
    StillOpen { opener: Keyword } "this {opener} is still open";
    CloseBefore { opener: Keyword, closer: Keyword } "close {opener} with {closer} before it";
    BehindElse { word: Keyword } "{word} stands behind the ELSE of its IF";
    Else "the ELSE";
    ElseIsLast "ELSE is the last branch of an IF";
    NothingOpen { opener: Keyword, word: Keyword } "no {opener} is open for this {word}";
    Opens { opener: Keyword, closer: Keyword } "{opener} opens what {closer} closes";
    Open { opener: Keyword } "this {opener} is open";
    StandsHere { word: Keyword } "its {word} stands here";
    NotClosed { opener: Keyword } "this {opener} is not closed";
    CloseWith { closer: Keyword } "close it with {closer}";
    SubroutineBefore { closer: Keyword } "this SUBROUTINE comes before {closer}";
    WordBefore { word: Keyword, closer: Keyword } "{word} comes before {closer}";
    EndsBefore { closer: Keyword } "the program ends before {closer}";
    NextNames { name: SmolStr } "this NEXT names {name}";
    NextNamesAnother "this NEXT names another variable";
    VariableOfFor "the variable of its FOR";

    // Jumps.
    NoSuchLabel "no such label";
    DidYouMean { near: SmolStr } "did you mean `{near}:`?";
    DeclareLabel { name: SmolStr } "declare it: `{name}:`";
    PlainLabel { name: SmolStr } "`{name}` is a plain label, not a SUBROUTINE";
    GosubCalls "GOSUB calls plain labels";
    LoopForGoto "LOOP is a label for GOTO only";
    OwnLabel "give the routine a label of its own";
    NoLoopAbove "no LOOP label stands above this jump";
    PutLoop "put `LOOP:` where the repetition starts";
    Enters { block: Entered } "this jump enters {block} from outside";
    MoveOut "move the label out of the branch";
    JumpBefore { opener: Keyword } "jump to a label before the {opener}";
    CallIt "CALL the SUBROUTINE";
    BlockStarts "the block starts here";
    Label "the label";
    LeavesSubroutine "GOTO leaves its SUBROUTINE";
    SubroutineStarts "the SUBROUTINE starts here";
    LeaveWith "leave a SUBROUTINE with RETURN or SUBEND";
    NextCounts "NEXT counts a variable that FOR may not have set";
    For "the FOR";
    RunsInto "its SUBEND stops a program that comes this way";
    PutJumpAbove "put GOTO, RETURN or EXIT above it";
}
