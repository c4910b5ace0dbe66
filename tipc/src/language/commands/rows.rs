//! The rows of the table, section by section.

use super::{Arguments, Command, Form, Limit, Meaning, Moves, Robots, Targets, Values, outcome};
use crate::language::{Edition, Keyword};
use tip_runtime::command::{Op, Teach};

/// Every command, in the order of the reference.
pub const COMMANDS: &[Command] = &[
    // Declarations (T.I.P. 3.1 §7-10-1).
    Command::keyword(Keyword::DefVar)
        .words("name, name, …")
        .no_step(),
    Command::keyword(Keyword::DefPos)
        .words("name, name, …")
        .no_step(),
    Command::keyword(Keyword::DefJoint)
        .words("name, name, …")
        .no_step(),
    Command::keyword(Keyword::Define)
        .words("name constant")
        .no_step(),

    // Motions: positions and angles, velocities, torques and springs (T.I.P. 3.1 §7-1 to §7-3).
    Command::robot(Op::Ptp)
        .place("§7-1-1", "7.2")
        .does("Moves a foot in a straight line to a position.", "足先を目標位置まで直線で動かします。")
        .takes(Arguments::motion(Targets::PLACE, Values::Position).fast())
        .moves(Moves::Target)
        .unit("mm")
        .fails(outcome::REACH),
    Command::robot(Op::RelPtp)
        .relative()
        .place("§7-1-2", "7.3")
        .does("Moves a foot relative to its target; three zeros stop it where it is.", "足先を現在の目標からの相対位置へ動かします。3つとも0なら、その場で止めます。")
        .takes(Arguments::motion(Targets::PLACE, Values::Position).plain().fast())
        .moves(Moves::Target)
        .unit("mm")
        .fails(outcome::REACH),
    Command::robot(Op::PtpAngle)
        .place("§7-1-3", "7.4")
        .does("Turns joints to angles.", "関節を目標角度まで回します。")
        .takes(Arguments::motion(Targets::FOOT_JOINT, Values::Angles).fast())
        .moves(Moves::Target)
        .unit("deg")
        .fails(outcome::TURN),
    Command::robot(Op::RelPtpAngle)
        .relative()
        .place("§7-1-4", "7.4")
        .does("Turns joints relative to their targets; zeros stop them where they are.", "関節を現在の目標からの相対角度だけ回します。0なら、その場で止めます。")
        .takes(Arguments::motion(Targets::FOOT_JOINT, Values::Angles).plain().fast())
        .moves(Moves::Target)
        .unit("deg")
        .fails(outcome::TURN),
    Command::robot(Op::AllStop)
        .place("§7-1-5", "7.5")
        .does("Holds every joint where it comes to rest; modes and targets are kept.", "全関節を減速して停止し、その場に保持します。制御モードと目標は残ります。"),
    Command::robot(Op::AllStopRelease)
        .place("§7-1-6", "7.5")
        .does("Ends ALL_STOP: every motion goes on.", "ALL_STOPを解除し、すべての動作を再開します。"),
    Command::robot(Op::InitialPosture)
        .place("§7-1-7", "7.6")
        .does("Sets off for the initial posture with standard parameters; WAIT_INPOS ALL awaits the arrival.", "標準のパラメータで初期姿勢へ動き始めます。到着はWAIT_INPOS ALLで待ちます。")
        .moves(Moves::Robot)
        .until("all joints are at rest", "全関節が静止する"),
    Command::robot(Op::VelControl)
        .place("§7-2-1", "7.7")
        .does("Moves a foot with a velocity.", "足先を指定した速度で動かします。")
        .takes(Arguments::motion(Targets::FOOT, Values::Position))
        .moves(Moves::Target)
        .unit("mm/s")
        .fails(outcome::GLIDE),
    Command::robot(Op::OmegaControl)
        .place("§7-2-2", "7.8")
        .does("Turns joints with angular velocities.", "関節を指定した角速度で回します。")
        .takes(Arguments::motion(Targets::FOOT_JOINT, Values::Angles))
        .moves(Moves::Target)
        .unit("deg/s")
        .fails(outcome::SPIN),
    Command::robot(Op::Torque)
        .place("§7-3-1", "7.9")
        .does("Gives joints a torque.", "関節に指定したトルクを出させます。")
        .takes(Arguments::motion(Targets::FOOT_JOINT, Values::Angles))
        .moves(Moves::Target)
        .unit("torque")
        .only(Robots::FORCE)
        .fails(outcome::SWING),
    Command::robot(Op::Force)
        .place("§7-3-2", "7.10")
        .does("Presses with a fingertip or third joint.", "指先または第3関節を指定した力で押し付けます。")
        .takes(Arguments::motion(Targets::TIP, Values::Position))
        .moves(Moves::Target)
        .unit("N")
        .only(Robots::FORCE)
        .fails(outcome::SWING),
    Command::robot(Op::ComplianceAngle)
        .place("§7-3-3", "7.11")
        .does("Holds joints at angles by springs.", "関節を、ばねのように目標角度に保持します。")
        .takes(Arguments::motion(Targets::ANY, Values::Angles).fast())
        .moves(Moves::Target)
        .unit("deg")
        .only(Robots::FORCE)
        .fails(outcome::SWING),
    Command::robot(Op::RelComplianceAngle)
        .relative()
        .place("§7-3-4", "7.11")
        .does("The same relative to their targets.", "同じ動作を、現在の目標からの相対値で行います。")
        .takes(Arguments::motion(Targets::ANY, Values::Angles).plain().fast())
        .moves(Moves::Target)
        .unit("deg")
        .only(Robots::FORCE)
        .fails(outcome::SWING),
    Command::robot(Op::CompliancePosition)
        .place("§7-3-5", "7.12")
        .does("Holds fingertips or third joints at a position by springs.", "指先または第3関節を、ばねのように目標位置に保持します。")
        .takes(Arguments::motion(Targets::TIPS, Values::Position).fast())
        .moves(Moves::Target)
        .unit("mm")
        .only(Robots::FORCE)
        .fails(outcome::SWING),
    Command::robot(Op::RelCompliancePosition)
        .relative()
        .place("§7-3-6", "7.12")
        .does("The same relative to their targets.", "同じ動作を、現在の目標からの相対値で行います。")
        .takes(Arguments::motion(Targets::TIPS, Values::Position).from_target().fast())
        .moves(Moves::Target)
        .unit("mm")
        .only(Robots::FORCE)
        .fails(outcome::SWING),
    Command::robot(Op::NoCompliance)
        .place("§7-3-7", "7.13")
        .does("Ends compliance: angle control at the measured angle.", "コンプライアンス制御を終え、測定した角度での角度制御に戻します。")
        .takes(Arguments::target(Targets::FOOT_JOINT))
        .moves(Moves::Target)
        .only(Robots::FORCE),
    Command::robot(Op::Direct)
        .since_3_2()
        .place("§1-2-2", "16.1")
        .does("Moves set points to their targets in one cycle, without limits of speed and acceleration.", "速度・加速度の制限なしに、設定値を1周期で目標に移します。")
        .takes(Arguments::target(Targets::ANY))
        .fails(outcome::LOCKED),
    Command::robot(Op::Trajectory)
        .since_3_2()
        .place("§1-2-2", "16.1")
        .does("Lets set points move to their targets under the limits again.", "再び制限の範囲内で、設定値を目標へ動かします。")
        .takes(Arguments::target(Targets::ANY))
        .fails(outcome::LOCKED),
    Command::robot(Op::Lock)
        .since_3_2()
        .place("§1-2-8", "16.2")
        .does("Protects the mode and target of joints against every other command.", "関節の制御モードと目標を、ほかのコマンドで変わらないようにします。")
        .takes(Arguments::target(Targets::ANY)),
    Command::robot(Op::Unlock)
        .since_3_2()
        .place("§1-2-8", "16.2")
        .does("Ends LOCK.", "LOCKを解除します。")
        .takes(Arguments::target(Targets::ANY)),

    // Waiting and measuring (T.I.P. 3.1 §7-4, §7-5).
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

    // Blocks and jumps (T.I.P. 3.1 §7-6, §7-7).
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
    Command::keyword(Keyword::Subroutine)
        .words("name:"),
    Command::keyword(Keyword::SubEnd)
        .fails(outcome::RETURNS),
    Command::keyword(Keyword::Call)
        .words("name:")
        .fails(outcome::CALLS),
    Command::keyword(Keyword::Goto)
        .words("[label:]"),
    Command::keyword(Keyword::Gosub)
        .words("label:")
        .fails(outcome::CALLS),
    Command::keyword(Keyword::Return)
        .fails(outcome::RETURNS),
    Command::keyword(Keyword::Thread)
        .words("name:"),
    Command::keyword(Keyword::ThreadEnd),
    Command::keyword(Keyword::StartThread)
        .words("name:")
        .fails(outcome::RUNNING),
    Command::keyword(Keyword::StopThread)
        .words("name:"),
    Command::keyword(Keyword::WaitThread)
        .words("name:")
        .until("the thread does not run", "スレッドが動いていない")
        .fails(outcome::ITSELF),

    // Parameters of feet, joints, springs and the control cycle (T.I.P. 3.1 §7-8).
    Command::robot(Op::SetAMax)
        .place("§7-8-1-1", "7.21")
        .does("Sets the acceleration limit of feet.", "足先の最大加速度を設定します。")
        .takes(Arguments::setting(Targets::FEET_FLOOR, Values::One, Limit::NotNegative))
        .unit("mm/s²"),
    Command::robot(Op::SetVMax)
        .place("§7-8-1-2", "7.21")
        .does("Sets the speed limit of feet.", "足先の最大速度を設定します。")
        .takes(Arguments::setting(Targets::FEET_FLOOR, Values::One, Limit::NotNegative))
        .unit("mm/s"),
    Command::robot(Op::SetAMaxRate)
        .place("§7-8-1-3", "7.23")
        .does("Sets the acceleration limit of feet to a part of the standard.", "足先の最大加速度を、標準値に対する割合で設定します。")
        .takes(Arguments::setting(Targets::FEET, Values::One, Limit::Percent))
        .unit("%"),
    Command::robot(Op::SetVMaxRate)
        .place("§7-8-1-4", "7.23")
        .does("Sets the speed limit of feet to a part of the standard.", "足先の最大速度を、標準値に対する割合で設定します。")
        .takes(Arguments::setting(Targets::FEET, Values::One, Limit::Percent))
        .unit("%"),
    Command::robot(Op::SetAMaxSlow)
        .place("§7-8-1-5", "7.24")
        .does("Sets the acceleration limit of feet to 50 % of the standard.", "足先の最大加速度を標準値の50%に設定します。")
        .takes(Arguments::target(Targets::FEET)),
    Command::robot(Op::SetAMaxFast)
        .place("§7-8-1-5", "7.24")
        .does("Sets the acceleration limit of feet to 150 % of the standard.", "足先の最大加速度を標準値の150%に設定します。")
        .takes(Arguments::target(Targets::FEET)),
    Command::robot(Op::SetAMaxNormal)
        .place("§7-8-1-5", "7.24")
        .does("Sets the acceleration limit of feet to 100 % of the standard.", "足先の最大加速度を標準値の100%に設定します。")
        .takes(Arguments::target(Targets::FEET)),
    Command::robot(Op::SetVMaxSlow)
        .place("§7-8-1-6", "7.24")
        .does("Sets the speed limit of feet to 50 % of the standard.", "足先の最大速度を標準値の50%に設定します。")
        .takes(Arguments::target(Targets::FEET)),
    Command::robot(Op::SetVMaxFast)
        .place("§7-8-1-6", "7.24")
        .does("Sets the speed limit of feet to 150 % of the standard.", "足先の最大速度を標準値の150%に設定します。")
        .takes(Arguments::target(Targets::FEET)),
    Command::robot(Op::SetVMaxNormal)
        .place("§7-8-1-6", "7.24")
        .does("Sets the speed limit of feet to 100 % of the standard.", "足先の最大速度を標準値の100%に設定します。")
        .takes(Arguments::target(Targets::FEET)),
    Command::robot(Op::SetJustPosition)
        .place("§7-8-1-7", "7.21")
        .does("Sets the INPOS tolerance of feet.", "足先の到着判定(INPOS)の許容誤差を設定します。")
        .takes(Arguments::setting(Targets::FEET, Values::One, Limit::NotNegative))
        .unit("mm"),
    Command::robot(Op::SetNearPosition)
        .place("§7-8-1-8", "7.21")
        .does("Sets the NEAR tolerance of feet.", "足先の接近判定(NEAR)の許容誤差を設定します。")
        .takes(Arguments::setting(Targets::FEET, Values::One, Limit::NotNegative))
        .unit("mm"),
    Command::robot(Op::SetOmegaMax)
        .place("§7-8-2-1", "7.22")
        .does("Sets the speed limit of joints.", "関節の最大角速度を設定します。")
        .takes(Arguments::setting(Targets::JOINTS, Values::One, Limit::NotNegative))
        .unit("deg/s"),
    Command::robot(Op::SetOmegaDotMax)
        .place("§7-8-2-2", "7.22")
        .does("Sets the acceleration limit of joints.", "関節の最大角加速度を設定します。")
        .takes(Arguments::setting(Targets::JOINTS, Values::One, Limit::NotNegative))
        .unit("deg/s²"),
    Command::robot(Op::SetOmegaMaxRate)
        .place("§7-8-2-3", "7.23")
        .does("Sets the speed limit of joints to a part of the standard.", "関節の最大角速度を、標準値に対する割合で設定します。")
        .takes(Arguments::setting(Targets::JOINTS, Values::One, Limit::Percent))
        .unit("%"),
    Command::robot(Op::SetOmegaDotMaxRate)
        .place("§7-8-2-4", "7.23")
        .does("Sets the acceleration limit of joints to a part of the standard.", "関節の最大角加速度を、標準値に対する割合で設定します。")
        .takes(Arguments::setting(Targets::JOINTS, Values::One, Limit::Percent))
        .unit("%"),
    Command::robot(Op::SetOmegaMaxSlow)
        .place("§7-8-2-5", "7.24")
        .does("Sets the speed limit of joints to 50 % of the standard.", "関節の最大角速度を標準値の50%に設定します。")
        .takes(Arguments::target(Targets::JOINTS)),
    Command::robot(Op::SetOmegaMaxFast)
        .place("§7-8-2-5", "7.24")
        .does("Sets the speed limit of joints to 150 % of the standard.", "関節の最大角速度を標準値の150%に設定します。")
        .takes(Arguments::target(Targets::JOINTS)),
    Command::robot(Op::SetOmegaMaxNormal)
        .place("§7-8-2-5", "7.24")
        .does("Sets the speed limit of joints to 100 % of the standard.", "関節の最大角速度を標準値の100%に設定します。")
        .takes(Arguments::target(Targets::JOINTS)),
    Command::robot(Op::SetOmegaDotMaxSlow)
        .place("§7-8-2-6", "7.24")
        .does("Sets the acceleration limit of joints to 50 % of the standard.", "関節の最大角加速度を標準値の50%に設定します。")
        .takes(Arguments::target(Targets::JOINTS)),
    Command::robot(Op::SetOmegaDotMaxFast)
        .place("§7-8-2-6", "7.24")
        .does("Sets the acceleration limit of joints to 150 % of the standard.", "関節の最大角加速度を標準値の150%に設定します。")
        .takes(Arguments::target(Targets::JOINTS)),
    Command::robot(Op::SetOmegaDotMaxNormal)
        .place("§7-8-2-6", "7.24")
        .does("Sets the acceleration limit of joints to 100 % of the standard.", "関節の最大角加速度を標準値の100%に設定します。")
        .takes(Arguments::target(Targets::JOINTS)),
    Command::robot(Op::SetJustAngle)
        .place("§7-8-2-7", "7.25")
        .does("Sets the INPOS tolerance of joints.", "関節の到着判定(INPOS)の許容誤差を設定します。")
        .takes(Arguments::setting(Targets::ANY, Values::PerJoint, Limit::NotNegative))
        .unit("deg"),
    Command::robot(Op::SetNearAngle)
        .place("§7-8-2-8", "7.25")
        .does("Sets the NEAR tolerance of joints.", "関節の接近判定(NEAR)の許容誤差を設定します。")
        .takes(Arguments::setting(Targets::ANY, Values::PerJoint, Limit::NotNegative))
        .unit("deg"),
    Command::robot(Op::SetTorqueMax)
        .place("§7-8-3-1", "7.26")
        .does("Sets the torque limit of joints.", "関節の最大トルクを設定します。")
        .takes(Arguments::setting(Targets::JOINTS, Values::One, Limit::NotNegative))
        .unit("torque")
        .only(Robots::FORCE),
    Command::robot(Op::SetTorqueMaxRate)
        .place("§7-8-3-2", "7.23")
        .does("Sets the torque limit of joints to a part of the standard.", "関節の最大トルクを、標準値に対する割合で設定します。")
        .takes(Arguments::setting(Targets::JOINTS, Values::One, Limit::Percent))
        .unit("%")
        .only(Robots::FORCE),
    Command::robot(Op::SetTorqueMaxSoft)
        .place("§7-8-3-3", "7.24")
        .does("Sets the torque limit of joints to 50 % of the standard.", "関節の最大トルクを標準値の50%に設定します。")
        .takes(Arguments::target(Targets::JOINTS))
        .only(Robots::FORCE),
    Command::robot(Op::SetTorqueMaxFirmly)
        .place("§7-8-3-3", "7.24")
        .does("Sets the torque limit of joints to 150 % of the standard.", "関節の最大トルクを標準値の150%に設定します。")
        .takes(Arguments::target(Targets::JOINTS))
        .only(Robots::FORCE),
    Command::robot(Op::SetTorqueMaxNormal)
        .place("§7-8-3-3", "7.24")
        .does("Sets the torque limit of joints to 100 % of the standard.", "関節の最大トルクを標準値の100%に設定します。")
        .takes(Arguments::target(Targets::JOINTS))
        .only(Robots::FORCE),
    Command::robot(Op::SetAngleStiffness)
        .place("§7-8-3-4", "7.26")
        .does("Sets the spring of compliant joints.", "コンプライアンス制御の関節のばね定数を設定します。")
        .takes(Arguments::setting(Targets::JOINTS, Values::One, Limit::NotNegative))
        .later(Edition::V3_2, Arguments::setting(Targets::ANY, Values::PerLeg, Limit::NotNegative))
        .unit("torque/deg")
        .only(Robots::FORCE),
    Command::robot(Op::SetPositionStiffness)
        .place("§7-8-3-5", "7.27")
        .does("Sets the springs of compliant positions along x, y, z.", "コンプライアンス制御の位置のばね定数をx、y、zについて設定します。")
        .takes(Arguments::setting(Targets::FEET, Values::Three, Limit::NotNegative))
        .later(Edition::V3_2, Arguments::setting(Targets::FEET, Values::ThreeOrPos, Limit::NotNegative))
        .unit("N/mm")
        .only(Robots::FORCE),
    Command::robot(Op::SetComplianceTorqueLimit)
        .place("§7-8-3-6", "7.28")
        .does("Bounds the torque of compliant joints.", "コンプライアンス制御の関節のトルクに上限を設けます。")
        .takes(Arguments::setting(Targets::ANY, Values::PerJoint, Limit::Positive))
        .unit("torque")
        .only(Robots::FORCE),
    Command::robot(Op::ResetComplianceTorqueLimit)
        .place("§7-8-3-7", "7.30")
        .does("Lifts that bound.", "その上限をなくします。")
        .takes(Arguments::target(Targets::ANY))
        .only(Robots::FORCE),
    Command::robot(Op::SetComplianceForceLimit)
        .place("§7-8-3-8", "7.29")
        .does("Bounds the force of compliant positions.", "コンプライアンス制御の位置の力に上限を設けます。")
        .takes(Arguments::setting(Targets::TIPS, Values::Position, Limit::Positive))
        .unit("N")
        .only(Robots::FORCE),
    Command::robot(Op::ResetComplianceForceLimit)
        .place("§7-8-3-9", "7.30")
        .does("Lifts that bound.", "その上限をなくします。")
        .takes(Arguments::target(Targets::TIPS))
        .only(Robots::FORCE),
    Command::robot(Op::SetLimit)
        .since_3_2()
        .place("§1-2-12", "16.3")
        .does("Sets working limits of joints inside the robot's own.", "関節の可動範囲を、ロボット本来の範囲の内側に制限します。")
        .takes(Arguments::setting(Targets::FOOT_JOINT, Values::Limits, Limit::Angles))
        .unit("deg"),
    Command::robot(Op::ResetLimit)
        .since_3_2()
        .place("§1-2-12", "16.3")
        .does("Restores the robot's own limits.", "ロボット本来の可動範囲に戻します。")
        .takes(Arguments::target(Targets::ANY)),
    Command::robot(Op::SetSamplingTime)
        .place("§7-8-4-1", "7.31")
        .does("Sets the control cycle.", "制御周期を設定します。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Period))
        .unit("ms"),
    Command::robot(Op::SetSamplingFreq)
        .place("§7-8-4-2", "7.31")
        .does("Sets the control cycle.", "制御周期を設定します。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Frequency))
        .unit("Hz"),

    // Inputs, keys, messages and lamps (T.I.P. 3.1 §7-9).
    Command::new("AD_IN", Meaning::AdIn)
        .place("§7-9-1", "7.32")
        .does("Reads an input into a VAR.", "入力をVARに読み込みます。")
        .form(Form::AdIn)
        .unit("V")
        .fails(outcome::INPUT),
    Command::new("KEY_IN", Meaning::KeyIn)
        .place("§7-9-2", "7.33")
        .does("Waits for a key and stores its upper-case code in the VAR, or in VAR_KEY; empties the buffer.", "キーが押されるまで待ち、その大文字のコードをVAR(省略するとVAR_KEY)に入れて、バッファを空にします。")
        .form(Form::KeyIn)
        .until("a key is in the buffer", "バッファにキーが入る"),
    Command::robot(Op::FlushBuf)
        .place("§7-9-3", "7.34")
        .does("Empties the keyboard buffer.", "キーボードのバッファを空にします。"),
    Command::keyword(Keyword::Message)
        .words("[text]")
        .fails(outcome::READS),
    Command::new("MESSAGE_CLEAR", Meaning::MessageClear)
        .place("§7-9-5", "7.34")
        .does("Clears the message line.", "メッセージ行を消します。"),
    Command::keyword(Keyword::FileMessage)
        .words("[text]")
        .fails(outcome::READS),
    Command::robot(Op::LampOn)
        .place("§7-9-6", "7.36")
        .does("Switches a lamp or relay on.", "ランプまたはリレーをオンにします。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Lamp)),
    Command::robot(Op::LampOff)
        .place("§7-9-7", "7.36")
        .does("Switches a lamp or relay off.", "ランプまたはリレーをオフにします。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Lamp)),
    Command::robot(Op::SilentOn)
        .place("§7-9-8", "7.37")
        .does("Shows as little as possible on the screen.", "画面の表示を最小限にします。")
        .only(Robots::LATER),
    Command::robot(Op::SilentOff)
        .place("§7-9-9", "7.37")
        .does("Shows everything again.", "画面の表示を元に戻します。")
        .only(Robots::LATER),

    // The program itself: remarks, ends, logs, emergencies and native code (T.I.P. 3.1 §7-10).
    Command::keyword(Keyword::Rem)
        .words("[text]"),
    Command::keyword(Keyword::End),
    Command::keyword(Keyword::Exit),
    Command::robot(Op::LogStart)
        .place("§7-10-5", "7.40")
        .does("Records every cycle for TITAN.LOG.", "TITAN.LOGに毎周期の記録を始めます。"),
    Command::robot(Op::LogStop)
        .place("§7-10-6", "7.40")
        .does("Pauses the recording.", "記録を一時停止します。"),
    Command::robot(Op::LogOneShot)
        .place("§7-10-7", "7.40")
        .does("Records this cycle for TITAN.LOG.", "この周期だけTITAN.LOGに記録します。"),
    Command::robot(Op::OutputVariables)
        .place("§7-10-8", "7.41")
        .does("Writes every variable to a file; the robot is held meanwhile.", "全変数をファイルに書き出します。その間、ロボットは姿勢を保持します。"),
    Command::robot(Op::EmgOff)
        .place("§7-10-9", "7.42")
        .does("A joint at its limit stops there.", "関節が限界に達しても、そこで止まるだけにします。"),
    Command::robot(Op::EmgOn)
        .place("§7-10-10", "7.42")
        .does("A joint at its limit is an emergency stop.", "関節が限界に達したら緊急停止します。"),
    Command::robot(Op::Special)
        .place("§7-10-11", "7.43")
        .does("Runs native code of the robot.", "ロボット固有のネイティブコードを実行します。")
        .form(Form::Special)
        .until("the native code says so", "ネイティブコードが終了を知らせる")
        .fails(outcome::NATIVE),
    Command::robot(Op::SpeedUp)
        .since_3_2()
        .place("§1-2-3", "14.2")
        .does("Sets how many steps a cycle runs at most, from the next cycle on.", "1周期に実行するステップ数の上限を、次の周期から変えます。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Steps)),

    // Commands of one robot alone (T.I.P. 3.1 §7-11).
    Command::robot(Op::StandUp)
        .place("§7-11-1", "7.44")
        .does("Raises the body slowly.", "胴体をゆっくり持ち上げます。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Any))
        .unit("mm")
        .moves(Moves::Robot)
        .only(Robots::TITAN)
        .until("all feet have arrived", "すべての足先が到着する")
        .fails(outcome::STAND),
    Command::robot(Op::SitDown)
        .place("§7-11-2", "7.44")
        .does("Lowers the body slowly.", "胴体をゆっくり下げます。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::Any))
        .unit("mm")
        .moves(Moves::Robot)
        .only(Robots::TITAN)
        .until("all feet have arrived", "すべての足先が到着する")
        .fails(outcome::STAND),
    Command::robot(Op::DetectFloor)
        .place("§7-11-3", "7.45")
        .does("Searches the floor with feet or fingers.", "足または指で床を探ります。")
        .takes(Arguments::setting(Targets::FEET, Values::One, Limit::FloorType))
        .moves(Moves::Robot)
        .only(Robots::NAMED)
        .until("every foot or finger feels the floor (T, type 3: no longer feels it)", "すべての足または指が床を検出する(Tがtype 3なら検出しなくなる)")
        .fails(outcome::FLOOR),
    Command::robot(Op::DetectObject)
        .place("§7-11-4", "7.46")
        .does("Closes the fingers until they touch an object.", "対象物に触れるまで指を閉じます。")
        .takes(Arguments::setting(Targets::NONE, Values::One, Limit::ObjectType))
        .moves(Moves::Robot)
        .only(Robots::HAND)
        .until("every finger feels the object", "すべての指が対象物に触れる")
        .fails(outcome::OBJECT),
];
