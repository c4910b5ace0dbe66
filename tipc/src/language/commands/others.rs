//! The program itself: remarks, ends, logs, emergencies and native code (T.I.P. 3.1 §7-10).

use super::{Arguments, Command, Form, Limit, Targets, Values, outcome};
use crate::language::Keyword;
use tip_runtime::command::Op;

pub(super) const ROWS: &[Command] = &[
    Command::keyword(Keyword::Rem).words("[text]"),
    Command::keyword(Keyword::End),
    Command::keyword(Keyword::Exit),
    Command::robot(Op::LogStart).place("§7-10-5", "7.40").does(
        "Records every cycle for TITAN.LOG.",
        "TITAN.LOGに毎周期の記録を始めます。",
    ),
    Command::robot(Op::LogStop)
        .place("§7-10-6", "7.40")
        .does("Pauses the recording.", "記録を一時停止します。"),
    Command::robot(Op::LogOneShot)
        .place("§7-10-7", "7.40")
        .does(
            "Records this cycle for TITAN.LOG.",
            "この周期だけTITAN.LOGに記録します。",
        ),
    Command::robot(Op::OutputVariables)
        .place("§7-10-8", "7.41")
        .does(
            "Writes every variable to a file; the robot is held meanwhile.",
            "全変数をファイルに書き出します。その間、ロボットは姿勢を保持します。",
        ),
    Command::robot(Op::EmgOff).place("§7-10-9", "7.42").does(
        "A joint at its limit stops there.",
        "関節が限界に達しても、そこで止まるだけにします。",
    ),
    Command::robot(Op::EmgOn).place("§7-10-10", "7.42").does(
        "A joint at its limit is an emergency stop.",
        "関節が限界に達したら緊急停止します。",
    ),
    Command::robot(Op::Special)
        .place("§7-10-11", "7.43")
        .does(
            "Runs native code of the robot.",
            "ロボット固有のネイティブコードを実行します。",
        )
        .form(Form::Special)
        .until(
            "the native code says so",
            "ネイティブコードが終了を知らせる",
        )
        .fails(outcome::NATIVE),
    Command::robot(Op::SpeedUp)
        .since_3_2()
        .place("§1-2-3", "14.2")
        .does(
            "Sets how many steps a cycle runs at most, from the next cycle on.",
            "1周期に実行するステップ数の上限を、次の周期から変えます。",
        )
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Steps)),
];
