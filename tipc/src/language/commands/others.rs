//! The program itself: remarks, ends, logs, emergencies and native code (T.I.P. 3.1 §7-10).

use super::{Command, Form, outcome};
use crate::language::Keyword;
use tip_runtime::command::Op;

pub(super) const ROWS: &[Command] = &[
    Command::keyword(Keyword::Rem).words("[text]"),
    Command::keyword(Keyword::End),
    Command::keyword(Keyword::Exit),
    Command::robot(Op::LogStart)
        .place("§7-10-5", "7.40")
        .does("Records every cycle for TITAN.LOG."),
    Command::robot(Op::LogStop)
        .place("§7-10-6", "7.40")
        .does("Pauses the recording."),
    Command::robot(Op::LogOneShot)
        .place("§7-10-7", "7.40")
        .does("Records this cycle for TITAN.LOG."),
    Command::robot(Op::OutputVariables)
        .place("§7-10-8", "7.41")
        .does("Writes every variable to a file; the robot is held meanwhile."),
    Command::robot(Op::EmgOff)
        .place("§7-10-9", "7.42")
        .does("A joint at its limit stops there."),
    Command::robot(Op::EmgOn)
        .place("§7-10-10", "7.42")
        .does("A joint at its limit is an emergency stop."),
    Command::robot(Op::Special)
        .place("§7-10-11", "7.43")
        .does("Runs native code of the robot.")
        .form(Form::Special)
        .until("the native code says so")
        .fails(outcome::NATIVE),
];
