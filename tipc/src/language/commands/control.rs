//! Blocks and jumps (T.I.P. 3.1 §7-6, §7-7).

use super::{Command, outcome};
use crate::language::Keyword;

pub(super) const ROWS: &[Command] = &[
    Command::keyword(Keyword::If)
        .words("condition THEN | GOTO [label:] | GOSUB label:")
        .fails(outcome::BRANCHES),
    Command::keyword(Keyword::ElseIf)
        .words("condition THEN")
        .fails(outcome::READS),
    Command::keyword(Keyword::Else),
    Command::keyword(Keyword::EndIf),
    Command::keyword(Keyword::While)
        .words("condition")
        .fails(outcome::READS),
    Command::keyword(Keyword::Wend),
    Command::keyword(Keyword::Repeat),
    Command::keyword(Keyword::Until)
        .words("condition")
        .fails(outcome::READS),
    Command::keyword(Keyword::For)
        .words("VAR = S TO S [STEP S]")
        .fails(outcome::COUNT),
    Command::keyword(Keyword::Next)
        .words("[VAR]")
        .fails(outcome::COUNT),
    Command::keyword(Keyword::Subroutine).words("name:"),
    Command::keyword(Keyword::SubEnd).fails(outcome::RETURNS),
    Command::keyword(Keyword::Call)
        .words("name:")
        .fails(outcome::CALLS),
    Command::keyword(Keyword::Goto).words("[label:]"),
    Command::keyword(Keyword::Gosub)
        .words("label:")
        .fails(outcome::CALLS),
    Command::keyword(Keyword::Return).fails(outcome::RETURNS),
    Command::keyword(Keyword::Thread).words("name:"),
    Command::keyword(Keyword::ThreadEnd),
    Command::keyword(Keyword::StartThread)
        .words("name:")
        .fails(outcome::RUNNING),
    Command::keyword(Keyword::StopThread).words("name:"),
    Command::keyword(Keyword::WaitThread)
        .words("name:")
        .until("the thread does not run", "スレッドが動いていない")
        .fails(outcome::ITSELF),
];
