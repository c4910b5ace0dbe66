//! Parameters of feet, joints, springs and the control cycle (T.I.P. 3.1 §7-8).

use super::{Arguments, Command, Limit, Robots, Targets, Values};
use crate::language::Edition;
use tip_runtime::command::Op;

pub(super) const ROWS: &[Command] = &[
    Command::robot(Op::SetAMax)
        .place("§7-8-1-1", "7.21")
        .does(
            "Sets the acceleration limit of feet.",
            "足先の最大加速度を設定します。",
        )
        .takes(Arguments::setting(
            Targets::FEET_FLOOR,
            Values::One,
            Limit::NotNegative,
        ))
        .unit("mm/s²"),
    Command::robot(Op::SetVMax)
        .place("§7-8-1-2", "7.21")
        .does(
            "Sets the speed limit of feet.",
            "足先の最大速度を設定します。",
        )
        .takes(Arguments::setting(
            Targets::FEET_FLOOR,
            Values::One,
            Limit::NotNegative,
        ))
        .unit("mm/s"),
    Command::robot(Op::SetAMaxRate)
        .place("§7-8-1-3", "7.23")
        .does(
            "Sets the acceleration limit of feet to a part of the standard.",
            "足先の最大加速度を、標準値に対する割合で設定します。",
        )
        .takes(Arguments::setting(
            Targets::FEET,
            Values::One,
            Limit::Percent,
        ))
        .unit("%"),
    Command::robot(Op::SetVMaxRate)
        .place("§7-8-1-4", "7.23")
        .does(
            "Sets the speed limit of feet to a part of the standard.",
            "足先の最大速度を、標準値に対する割合で設定します。",
        )
        .takes(Arguments::setting(
            Targets::FEET,
            Values::One,
            Limit::Percent,
        ))
        .unit("%"),
    Command::robot(Op::SetAMaxSlow)
        .place("§7-8-1-5", "7.24")
        .does(
            "Sets the acceleration limit of feet to 50 % of the standard.",
            "足先の最大加速度を標準値の50%に設定します。",
        )
        .takes(Arguments::target(Targets::FEET)),
    Command::robot(Op::SetAMaxFast)
        .place("§7-8-1-5", "7.24")
        .does(
            "Sets the acceleration limit of feet to 150 % of the standard.",
            "足先の最大加速度を標準値の150%に設定します。",
        )
        .takes(Arguments::target(Targets::FEET)),
    Command::robot(Op::SetAMaxNormal)
        .place("§7-8-1-5", "7.24")
        .does(
            "Sets the acceleration limit of feet to 100 % of the standard.",
            "足先の最大加速度を標準値の100%に設定します。",
        )
        .takes(Arguments::target(Targets::FEET)),
    Command::robot(Op::SetVMaxSlow)
        .place("§7-8-1-6", "7.24")
        .does(
            "Sets the speed limit of feet to 50 % of the standard.",
            "足先の最大速度を標準値の50%に設定します。",
        )
        .takes(Arguments::target(Targets::FEET)),
    Command::robot(Op::SetVMaxFast)
        .place("§7-8-1-6", "7.24")
        .does(
            "Sets the speed limit of feet to 150 % of the standard.",
            "足先の最大速度を標準値の150%に設定します。",
        )
        .takes(Arguments::target(Targets::FEET)),
    Command::robot(Op::SetVMaxNormal)
        .place("§7-8-1-6", "7.24")
        .does(
            "Sets the speed limit of feet to 100 % of the standard.",
            "足先の最大速度を標準値の100%に設定します。",
        )
        .takes(Arguments::target(Targets::FEET)),
    Command::robot(Op::SetJustPosition)
        .place("§7-8-1-7", "7.21")
        .does(
            "Sets the INPOS tolerance of feet.",
            "足先の到着判定(INPOS)の許容誤差を設定します。",
        )
        .takes(Arguments::setting(
            Targets::FEET,
            Values::One,
            Limit::NotNegative,
        ))
        .unit("mm"),
    Command::robot(Op::SetNearPosition)
        .place("§7-8-1-8", "7.21")
        .does(
            "Sets the NEAR tolerance of feet.",
            "足先の接近判定(NEAR)の許容誤差を設定します。",
        )
        .takes(Arguments::setting(
            Targets::FEET,
            Values::One,
            Limit::NotNegative,
        ))
        .unit("mm"),
    Command::robot(Op::SetOmegaMax)
        .place("§7-8-2-1", "7.22")
        .does(
            "Sets the speed limit of joints.",
            "関節の最大角速度を設定します。",
        )
        .takes(Arguments::setting(
            Targets::JOINTS,
            Values::One,
            Limit::NotNegative,
        ))
        .unit("deg/s"),
    Command::robot(Op::SetOmegaDotMax)
        .place("§7-8-2-2", "7.22")
        .does(
            "Sets the acceleration limit of joints.",
            "関節の最大角加速度を設定します。",
        )
        .takes(Arguments::setting(
            Targets::JOINTS,
            Values::One,
            Limit::NotNegative,
        ))
        .unit("deg/s²"),
    Command::robot(Op::SetOmegaMaxRate)
        .place("§7-8-2-3", "7.23")
        .does(
            "Sets the speed limit of joints to a part of the standard.",
            "関節の最大角速度を、標準値に対する割合で設定します。",
        )
        .takes(Arguments::setting(
            Targets::JOINTS,
            Values::One,
            Limit::Percent,
        ))
        .unit("%"),
    Command::robot(Op::SetOmegaDotMaxRate)
        .place("§7-8-2-4", "7.23")
        .does(
            "Sets the acceleration limit of joints to a part of the standard.",
            "関節の最大角加速度を、標準値に対する割合で設定します。",
        )
        .takes(Arguments::setting(
            Targets::JOINTS,
            Values::One,
            Limit::Percent,
        ))
        .unit("%"),
    Command::robot(Op::SetOmegaMaxSlow)
        .place("§7-8-2-5", "7.24")
        .does(
            "Sets the speed limit of joints to 50 % of the standard.",
            "関節の最大角速度を標準値の50%に設定します。",
        )
        .takes(Arguments::target(Targets::JOINTS)),
    Command::robot(Op::SetOmegaMaxFast)
        .place("§7-8-2-5", "7.24")
        .does(
            "Sets the speed limit of joints to 150 % of the standard.",
            "関節の最大角速度を標準値の150%に設定します。",
        )
        .takes(Arguments::target(Targets::JOINTS)),
    Command::robot(Op::SetOmegaMaxNormal)
        .place("§7-8-2-5", "7.24")
        .does(
            "Sets the speed limit of joints to 100 % of the standard.",
            "関節の最大角速度を標準値の100%に設定します。",
        )
        .takes(Arguments::target(Targets::JOINTS)),
    Command::robot(Op::SetOmegaDotMaxSlow)
        .place("§7-8-2-6", "7.24")
        .does(
            "Sets the acceleration limit of joints to 50 % of the standard.",
            "関節の最大角加速度を標準値の50%に設定します。",
        )
        .takes(Arguments::target(Targets::JOINTS)),
    Command::robot(Op::SetOmegaDotMaxFast)
        .place("§7-8-2-6", "7.24")
        .does(
            "Sets the acceleration limit of joints to 150 % of the standard.",
            "関節の最大角加速度を標準値の150%に設定します。",
        )
        .takes(Arguments::target(Targets::JOINTS)),
    Command::robot(Op::SetOmegaDotMaxNormal)
        .place("§7-8-2-6", "7.24")
        .does(
            "Sets the acceleration limit of joints to 100 % of the standard.",
            "関節の最大角加速度を標準値の100%に設定します。",
        )
        .takes(Arguments::target(Targets::JOINTS)),
    Command::robot(Op::SetJustAngle)
        .place("§7-8-2-7", "7.25")
        .does(
            "Sets the INPOS tolerance of joints.",
            "関節の到着判定(INPOS)の許容誤差を設定します。",
        )
        .takes(Arguments::setting(
            Targets::ANY,
            Values::PerJoint,
            Limit::NotNegative,
        ))
        .unit("deg"),
    Command::robot(Op::SetNearAngle)
        .place("§7-8-2-8", "7.25")
        .does(
            "Sets the NEAR tolerance of joints.",
            "関節の接近判定(NEAR)の許容誤差を設定します。",
        )
        .takes(Arguments::setting(
            Targets::ANY,
            Values::PerJoint,
            Limit::NotNegative,
        ))
        .unit("deg"),
    Command::robot(Op::SetTorqueMax)
        .place("§7-8-3-1", "7.26")
        .does(
            "Sets the torque limit of joints.",
            "関節の最大トルクを設定します。",
        )
        .takes(Arguments::setting(
            Targets::JOINTS,
            Values::One,
            Limit::NotNegative,
        ))
        .unit("torque")
        .only(Robots::FORCE),
    Command::robot(Op::SetTorqueMaxRate)
        .place("§7-8-3-2", "7.23")
        .does(
            "Sets the torque limit of joints to a part of the standard.",
            "関節の最大トルクを、標準値に対する割合で設定します。",
        )
        .takes(Arguments::setting(
            Targets::JOINTS,
            Values::One,
            Limit::Percent,
        ))
        .unit("%")
        .only(Robots::FORCE),
    Command::robot(Op::SetTorqueMaxSoft)
        .place("§7-8-3-3", "7.24")
        .does(
            "Sets the torque limit of joints to 50 % of the standard.",
            "関節の最大トルクを標準値の50%に設定します。",
        )
        .takes(Arguments::target(Targets::JOINTS))
        .only(Robots::FORCE),
    Command::robot(Op::SetTorqueMaxFirmly)
        .place("§7-8-3-3", "7.24")
        .does(
            "Sets the torque limit of joints to 150 % of the standard.",
            "関節の最大トルクを標準値の150%に設定します。",
        )
        .takes(Arguments::target(Targets::JOINTS))
        .only(Robots::FORCE),
    Command::robot(Op::SetTorqueMaxNormal)
        .place("§7-8-3-3", "7.24")
        .does(
            "Sets the torque limit of joints to 100 % of the standard.",
            "関節の最大トルクを標準値の100%に設定します。",
        )
        .takes(Arguments::target(Targets::JOINTS))
        .only(Robots::FORCE),
    Command::robot(Op::SetAngleStiffness)
        .place("§7-8-3-4", "7.26")
        .does(
            "Sets the spring of compliant joints.",
            "コンプライアンス制御の関節のばね定数を設定します。",
        )
        .takes(Arguments::setting(
            Targets::JOINTS,
            Values::One,
            Limit::NotNegative,
        ))
        .later(
            Edition::V3_2,
            Arguments::setting(Targets::ANY, Values::PerLeg, Limit::NotNegative),
        )
        .unit("torque/deg")
        .only(Robots::FORCE),
    Command::robot(Op::SetPositionStiffness)
        .place("§7-8-3-5", "7.27")
        .does(
            "Sets the springs of compliant positions along x, y, z.",
            "コンプライアンス制御の位置のばね定数をx、y、zについて設定します。",
        )
        .takes(Arguments::setting(
            Targets::FEET,
            Values::Three,
            Limit::NotNegative,
        ))
        .later(
            Edition::V3_2,
            Arguments::setting(Targets::FEET, Values::ThreeOrPos, Limit::NotNegative),
        )
        .unit("N/mm")
        .only(Robots::FORCE),
    Command::robot(Op::SetComplianceTorqueLimit)
        .place("§7-8-3-6", "7.28")
        .does(
            "Bounds the torque of compliant joints.",
            "コンプライアンス制御の関節のトルクに上限を設けます。",
        )
        .takes(Arguments::setting(
            Targets::ANY,
            Values::PerJoint,
            Limit::Positive,
        ))
        .unit("torque")
        .only(Robots::FORCE),
    Command::robot(Op::ResetComplianceTorqueLimit)
        .place("§7-8-3-7", "7.30")
        .does("Lifts that bound.", "その上限をなくします。")
        .takes(Arguments::target(Targets::ANY))
        .only(Robots::FORCE),
    Command::robot(Op::SetComplianceForceLimit)
        .place("§7-8-3-8", "7.29")
        .does(
            "Bounds the force of compliant positions.",
            "コンプライアンス制御の位置の力に上限を設けます。",
        )
        .takes(Arguments::setting(
            Targets::TIPS,
            Values::Position,
            Limit::Positive,
        ))
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
        .does(
            "Sets working limits of joints inside the robot's own.",
            "関節の可動範囲を、ロボット本来の範囲の内側に制限します。",
        )
        .takes(Arguments::setting(
            Targets::FOOT_JOINT,
            Values::Limits,
            Limit::Angles,
        ))
        .unit("deg"),
    Command::robot(Op::ResetLimit)
        .since_3_2()
        .place("§1-2-12", "16.3")
        .does(
            "Restores the robot's own limits.",
            "ロボット本来の可動範囲に戻します。",
        )
        .takes(Arguments::target(Targets::ANY)),
    Command::robot(Op::SetSamplingTime)
        .place("§7-8-4-1", "7.31")
        .does("Sets the control cycle.", "制御周期を設定します。")
        .takes(Arguments::setting(
            Targets::NONE,
            Values::One,
            Limit::Period,
        ))
        .unit("ms"),
    Command::robot(Op::SetSamplingFreq)
        .place("§7-8-4-2", "7.31")
        .does("Sets the control cycle.", "制御周期を設定します。")
        .takes(Arguments::setting(
            Targets::NONE,
            Values::One,
            Limit::Frequency,
        ))
        .unit("Hz"),
];
