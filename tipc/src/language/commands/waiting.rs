//! Waiting and measuring (T.I.P. 3.1 §7-4, §7-5).

use super::{Arguments, Command, Form, Limit, Meaning, Robots, Targets, Values, outcome};
use tip_runtime::command::{Op, Teach};

pub(super) const ROWS: &[Command] = &[
    Command::robot(Op::Sleep)
        .place("§7-4-1", "7.14")
        .does("Waits for a time.", "指定した時間だけ待ちます。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::NotNegative))
        .unit("ms")
        .until("the time is over: V divided by the sampling time, rounded up", "時間が経過する(V÷サンプリング時間、端数切り上げ)"),
    Command::robot(Op::WaitInpos)
        .alias("WAIT_IN_POS")
        .place("§7-4-2", "7.15")
        .does("Waits until the target has arrived within the JUST tolerance.", "目標に、JUSTの許容誤差以内で到着するまで待ちます。")
        .takes(Arguments::target(Targets::ANY))
        .until("the target has arrived within the JUST tolerance", "目標にJUSTの許容誤差以内で到着する"),
    Command::robot(Op::WaitNear)
        .place("§7-4-3", "7.16")
        .does("Waits until the target has arrived within the NEAR tolerance.", "目標に、NEARの許容誤差以内に近づくまで待ちます。")
        .takes(Arguments::target(Targets::ANY))
        .until("the target has arrived within the NEAR tolerance", "目標にNEARの許容誤差以内に近づく")
        .fails(outcome::UNCONTROLLED),
    Command::new("TEACH_POSITION", Meaning::Teach(Teach::Position))
        .alias("TEACH_POS")
        .place("§7-5-1", "7.17")
        .does("Measures the position of a foot or joint into a POS.", "足先または関節の位置を測り、POSに入れます。")
        .form(Form::Teach(Targets::FOOT_JOINT))
        .unit("mm"),
    Command::new("TEACH_ANGLE", Meaning::Teach(Teach::Angle))
        .place("§7-5-2", "7.18")
        .does("Measures a leg's angles into a JOINT, or a joint's into a scalar.", "脚の角度を測ってJOINTに、または関節の角度を測ってスカラーに入れます。")
        .form(Form::Teach(Targets::FOOT_JOINT))
        .unit("deg"),
    Command::new("TEACH_TORQUE", Meaning::Teach(Teach::Torque))
        .place("§7-5-3", "7.18")
        .does("Measures a leg's torques into a JOINT, or a joint's into a scalar.", "脚のトルクを測ってJOINTに、または関節のトルクを測ってスカラーに入れます。")
        .form(Form::Teach(Targets::FOOT_JOINT))
        .unit("torque")
        .only(Robots::FORCE),
    Command::new("TEACH_FORCE", Meaning::Teach(Teach::Force))
        .place("§7-5-4", "7.19")
        .does("Measures the contact force at a fingertip or second joint into a POS; (0, 0, -1) if it cannot be told.", "指先または第2関節の接触力を測り、POSに入れます。求められないときは(0, 0, -1)になります。")
        .form(Form::Teach(Targets::CONTACT))
        .unit("N")
        .only(Robots::FORCE),
    Command::robot(Op::StartTimer)
        .since_3_2()
        .place("§1-2-13", "14.1")
        .does("Starts a timer from zero.", "タイマを0から動かします。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Timer)),
    Command::robot(Op::StopTimer)
        .since_3_2()
        .place("§1-2-13", "14.1")
        .does("Halts a timer.", "タイマを止めます。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Timer)),
    Command::robot(Op::RestartTimer)
        .since_3_2()
        .place("§1-2-13", "14.1")
        .does("Lets a timer go on from where it stands.", "タイマを止まったところから再び動かします。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Timer)),
    Command::robot(Op::ResetTimer)
        .since_3_2()
        .place("§1-2-13", "14.1")
        .does("Sets a timer to zero; a running one goes on.", "タイマを0に戻します。動いているタイマはそのまま動き続けます。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Timer)),
];
