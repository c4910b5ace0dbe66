//! Motions: positions and angles, velocities, torques and springs (T.I.P. 3.1 §7-1 to §7-3).

use super::{Arguments, Command, Moves, Robots, Targets, Values, outcome};
use tip_runtime::command::Op;

pub(super) const ROWS: &[Command] = &[
    Command::robot(Op::Ptp)
        .place("§7-1-1", "7.2")
        .does("Moves a foot in a straight line to a position.", "足先を目標位置まで直線で動かします。")
        .takes(Arguments::motion(Targets::PLACE, Values::Position).fast())
        .moves(Moves::Target)
        .unit("mm")
        .fails(outcome::REACH),
    Command::robot(Op::RelPtp)
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
];
