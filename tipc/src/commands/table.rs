//! The rows, in the order of the language's reference.

use super::{Arguments, Command, Cycles, Form, Limit, Meaning, Robots, Targets, Values, outcome};
use tip_runtime::command::{Op, Teach};

/// Builds a row that nothing but its columns tells apart from the others.
macro_rules! rows {
    ($( $name:expr, $alias:expr, $section:literal, $clause:literal, $meaning:expr, $form:expr, $robots:expr, $unit:literal, $cycles:expr, $failures:expr, $description:literal; )*) => {
        &[$( Command {
            name: $name,
            alias: $alias,
            section: $section,
            clause: $clause,
            meaning: $meaning,
            form: $form,
            robots: $robots,
            unit: $unit,
            cycles: $cycles,
            failures: $failures,
            description: $description,
        }, )*]
    };
}

/// Every command.
pub const COMMANDS: &[Command] = rows! {
    "DEF_VAR", None, "§7-10-1", "3.1", Meaning::Word, Form::Words("name, name, …"), Robots::ALL, "", Cycles::Zero, outcome::NONE, "Declares scalar variables; takes no step.";
    "DEF_POS", None, "§7-10-1", "3.1", Meaning::Word, Form::Words("name, name, …"), Robots::ALL, "", Cycles::Zero, outcome::NONE, "Declares positions with members X, Y, Z in mm; takes no step.";
    "DEF_JOINT", None, "§7-10-1", "3.1", Meaning::Word, Form::Words("name, name, …"), Robots::ALL, "", Cycles::Zero, outcome::NONE, "Declares joint variables with one member J1…Jn a joint; takes no step.";
    Op::Ptp.name(), None, "§7-1-1", "7.2", Meaning::Robot(Op::Ptp), Form::Robot(Arguments::motion(Targets::PLACE, Values::Position).fast()), Robots::ALL, "mm", Cycles::One, outcome::REACH, "Moves a foot in a straight line to a position.";
    Op::RelPtp.name(), None, "§7-1-2", "7.3", Meaning::Robot(Op::RelPtp), Form::Robot(Arguments::motion(Targets::PLACE, Values::Position).plain().fast()), Robots::ALL, "mm", Cycles::One, outcome::REACH, "Moves a foot relative to its target; three zeros stop it where it is.";
    Op::PtpAngle.name(), None, "§7-1-3", "7.4", Meaning::Robot(Op::PtpAngle), Form::Robot(Arguments::motion(Targets::FOOT_JOINT, Values::Angles).fast()), Robots::ALL, "deg", Cycles::One, outcome::TURN, "Turns joints to angles.";
    Op::RelPtpAngle.name(), None, "§7-1-4", "7.4", Meaning::Robot(Op::RelPtpAngle), Form::Robot(Arguments::motion(Targets::FOOT_JOINT, Values::Angles).plain().fast()), Robots::ALL, "deg", Cycles::One, outcome::TURN, "Turns joints relative to their targets; zeros stop them where they are.";
    Op::AllStop.name(), None, "§7-1-5", "7.5", Meaning::Robot(Op::AllStop), Form::Robot(Arguments::BARE), Robots::ALL, "", Cycles::One, outcome::NONE, "Holds every joint where it comes to rest; modes and targets are kept.";
    Op::AllStopRelease.name(), None, "§7-1-6", "7.5", Meaning::Robot(Op::AllStopRelease), Form::Robot(Arguments::BARE), Robots::ALL, "", Cycles::One, outcome::NONE, "Ends ALL_STOP: every motion goes on.";
    Op::InitialPosture.name(), None, "§7-1-7", "7.6", Meaning::Robot(Op::InitialPosture), Form::Robot(Arguments::BARE), Robots::ALL, "", Cycles::Until("all joints are at rest"), outcome::NONE, "Sets off for the initial posture with standard parameters; WAIT_INPOS ALL awaits the arrival.";
    Op::VelControl.name(), None, "§7-2-1", "7.7", Meaning::Robot(Op::VelControl), Form::Robot(Arguments::motion(Targets::FOOT, Values::Position)), Robots::ALL, "mm/s", Cycles::One, outcome::GLIDE, "Moves a foot with a velocity.";
    Op::OmegaControl.name(), None, "§7-2-2", "7.8", Meaning::Robot(Op::OmegaControl), Form::Robot(Arguments::motion(Targets::FOOT_JOINT, Values::Angles)), Robots::ALL, "deg/s", Cycles::One, outcome::SPIN, "Turns joints with angular velocities.";
    Op::Torque.name(), None, "§7-3-1", "7.9", Meaning::Robot(Op::Torque), Form::Robot(Arguments::motion(Targets::FOOT_JOINT, Values::Angles)), Robots::FORCE, "torque", Cycles::One, outcome::SWING, "Gives joints a torque.";
    Op::Force.name(), None, "§7-3-2", "7.10", Meaning::Robot(Op::Force), Form::Robot(Arguments::motion(Targets::TIP, Values::Position)), Robots::FORCE, "N", Cycles::One, outcome::SWING, "Presses with a fingertip or third joint.";
    Op::ComplianceAngle.name(), None, "§7-3-3", "7.11", Meaning::Robot(Op::ComplianceAngle), Form::Robot(Arguments::motion(Targets::ANY, Values::Angles).fast()), Robots::FORCE, "deg", Cycles::One, outcome::SWING, "Holds joints at angles by springs.";
    Op::RelComplianceAngle.name(), None, "§7-3-4", "7.11", Meaning::Robot(Op::RelComplianceAngle), Form::Robot(Arguments::motion(Targets::ANY, Values::Angles).plain().fast()), Robots::FORCE, "deg", Cycles::One, outcome::SWING, "The same relative to their targets.";
    Op::CompliancePosition.name(), None, "§7-3-5", "7.12", Meaning::Robot(Op::CompliancePosition), Form::Robot(Arguments::motion(Targets::TIPS, Values::Position).fast()), Robots::FORCE, "mm", Cycles::One, outcome::SWING, "Holds fingertips or third joints at a position by springs.";
    Op::RelCompliancePosition.name(), None, "§7-3-6", "7.12", Meaning::Robot(Op::RelCompliancePosition), Form::Robot(Arguments::motion(Targets::TIPS, Values::Position).plain().fast()), Robots::FORCE, "mm", Cycles::One, outcome::SWING, "The same relative to their targets.";
    Op::NoCompliance.name(), None, "§7-3-7", "7.13", Meaning::Robot(Op::NoCompliance), Form::Robot(Arguments::target(Targets::FOOT_JOINT)), Robots::FORCE, "", Cycles::One, outcome::NONE, "Ends compliance: angle control at the measured angle.";
    Op::Sleep.name(), None, "§7-4-1", "7.14", Meaning::Robot(Op::Sleep), Form::Robot(Arguments::setting(Targets::NONE, Values::One, Limit::NotNegative)), Robots::ALL, "ms", Cycles::Until("the time is over: V by the sampling time, rounded up"), outcome::NONE, "Waits for a time.";
    Op::WaitInpos.name(), Some("WAIT_IN_POS"), "§7-4-2", "7.15", Meaning::Robot(Op::WaitInpos), Form::Robot(Arguments::target(Targets::ANY)), Robots::ALL, "", Cycles::Until("the target has arrived within the JUST tolerance"), outcome::NONE, "Waits until the target has arrived within the JUST tolerance.";
    Op::WaitNear.name(), None, "§7-4-3", "7.16", Meaning::Robot(Op::WaitNear), Form::Robot(Arguments::target(Targets::ANY)), Robots::ALL, "", Cycles::Until("the target has arrived within the NEAR tolerance"), outcome::UNCONTROLLED, "Waits until the target has arrived within the NEAR tolerance.";
    "TEACH_POSITION", Some("TEACH_POS"), "§7-5-1", "7.17", Meaning::Teach(Teach::Position), Form::Teach(Targets::FOOT_JOINT), Robots::ALL, "mm", Cycles::One, outcome::NONE, "Measures the position of a foot or joint into a POS.";
    "TEACH_ANGLE", None, "§7-5-2", "7.18", Meaning::Teach(Teach::Angle), Form::Teach(Targets::FOOT_JOINT), Robots::ALL, "deg", Cycles::One, outcome::NONE, "Measures a leg's angles into a JOINT, or a joint's into a scalar.";
    "TEACH_TORQUE", None, "§7-5-3", "7.18", Meaning::Teach(Teach::Torque), Form::Teach(Targets::FOOT_JOINT), Robots::FORCE, "torque", Cycles::One, outcome::NONE, "Measures a leg's torques into a JOINT, or a joint's into a scalar.";
    "TEACH_FORCE", None, "§7-5-4", "7.19", Meaning::Teach(Teach::Force), Form::Teach(Targets::CONTACT), Robots::FORCE, "N", Cycles::One, outcome::NONE, "Measures the contact force at a fingertip or second joint into a POS; (0, 0, -1) if it cannot be told.";
    "IF", None, "§7-6-1, §7-6-7, §7-6-8", "7.20", Meaning::Word, Form::Words("condition THEN | GOTO [label:] | GOSUB label:"), Robots::ALL, "", Cycles::One, outcome::BRANCHES, "Opens a block, or jumps, if the condition holds.";
    "ELSEIF", None, "§7-6-1", "7.20", Meaning::Word, Form::Words("condition THEN"), Robots::ALL, "", Cycles::One, outcome::READS, "Opens another branch of IF.";
    "ELSE", None, "§7-6-1", "7.20", Meaning::Word, Form::Words(""), Robots::ALL, "", Cycles::One, outcome::NONE, "Opens the last branch of IF; alone on its line.";
    "ENDIF", None, "§7-6-1", "7.20", Meaning::Word, Form::Words(""), Robots::ALL, "", Cycles::One, outcome::NONE, "Closes IF; alone on its line.";
    "WHILE", None, "§7-6-2", "7.20", Meaning::Word, Form::Words("condition"), Robots::ALL, "", Cycles::One, outcome::READS, "Repeats the block while the condition holds.";
    "WEND", None, "§7-6-2", "7.20", Meaning::Word, Form::Words(""), Robots::ALL, "", Cycles::One, outcome::NONE, "Closes WHILE; alone on its line.";
    "REPEAT", None, "§7-6-3", "7.20", Meaning::Word, Form::Words(""), Robots::ALL, "", Cycles::One, outcome::NONE, "Opens a block that runs at least once; alone on its line.";
    "UNTIL", None, "§7-6-3", "7.20", Meaning::Word, Form::Words("condition"), Robots::ALL, "", Cycles::One, outcome::READS, "Closes REPEAT, which goes on until the condition holds.";
    "FOR", None, "§7-6-4", "7.20", Meaning::Word, Form::Words("VAR = S TO S [STEP S]"), Robots::ALL, "", Cycles::One, outcome::COUNT, "Counts a variable through a block.";
    "NEXT", None, "§7-6-4", "7.20", Meaning::Word, Form::Words("[VAR]"), Robots::ALL, "", Cycles::One, outcome::COUNT, "Closes FOR.";
    "SUBROUTINE", None, "§7-6-5", "7.20", Meaning::Word, Form::Words("name:"), Robots::ALL, "", Cycles::One, outcome::NONE, "Opens a subroutine.";
    "SUBEND", None, "§7-6-5", "7.20", Meaning::Word, Form::Words(""), Robots::ALL, "", Cycles::One, outcome::RETURNS, "Closes SUBROUTINE and returns.";
    "CALL", None, "§7-6-6", "7.20", Meaning::Word, Form::Words("name:"), Robots::ALL, "", Cycles::One, outcome::CALLS, "Calls a SUBROUTINE.";
    "GOTO", None, "§7-7-1", "7.20", Meaning::Word, Form::Words("[label:]"), Robots::ALL, "", Cycles::One, outcome::NONE, "Jumps to a label; without one to the nearest LOOP above.";
    "GOSUB", None, "§7-7-2", "7.20", Meaning::Word, Form::Words("label:"), Robots::ALL, "", Cycles::One, outcome::CALLS, "Calls a label or SUBROUTINE.";
    "RETURN", None, "§7-7-3", "7.20", Meaning::Word, Form::Words(""), Robots::ALL, "", Cycles::One, outcome::RETURNS, "Returns behind the call.";
    Op::SetAMax.name(), None, "§7-8-1-1", "7.21", Meaning::Robot(Op::SetAMax), Form::Robot(Arguments::setting(Targets::FEET_FLOOR, Values::One, Limit::NotNegative)), Robots::ALL, "mm/s²", Cycles::One, outcome::NONE, "Sets the acceleration limit of feet.";
    Op::SetVMax.name(), None, "§7-8-1-2", "7.21", Meaning::Robot(Op::SetVMax), Form::Robot(Arguments::setting(Targets::FEET_FLOOR, Values::One, Limit::NotNegative)), Robots::ALL, "mm/s", Cycles::One, outcome::NONE, "Sets the speed limit of feet.";
    Op::SetAMaxRate.name(), None, "§7-8-1-3", "7.23", Meaning::Robot(Op::SetAMaxRate), Form::Robot(Arguments::setting(Targets::FEET, Values::One, Limit::Percent)), Robots::ALL, "%", Cycles::One, outcome::NONE, "Sets the acceleration limit of feet to a part of the standard.";
    Op::SetVMaxRate.name(), None, "§7-8-1-4", "7.23", Meaning::Robot(Op::SetVMaxRate), Form::Robot(Arguments::setting(Targets::FEET, Values::One, Limit::Percent)), Robots::ALL, "%", Cycles::One, outcome::NONE, "Sets the speed limit of feet to a part of the standard.";
    Op::SetAMaxSlow.name(), None, "§7-8-1-5", "7.24", Meaning::Robot(Op::SetAMaxSlow), Form::Robot(Arguments::target(Targets::FEET)), Robots::ALL, "", Cycles::One, outcome::NONE, "Sets the acceleration limit of feet to 50 % of the standard.";
    Op::SetAMaxFast.name(), None, "§7-8-1-5", "7.24", Meaning::Robot(Op::SetAMaxFast), Form::Robot(Arguments::target(Targets::FEET)), Robots::ALL, "", Cycles::One, outcome::NONE, "Sets the acceleration limit of feet to 150 % of the standard.";
    Op::SetAMaxNormal.name(), None, "§7-8-1-5", "7.24", Meaning::Robot(Op::SetAMaxNormal), Form::Robot(Arguments::target(Targets::FEET)), Robots::ALL, "", Cycles::One, outcome::NONE, "Sets the acceleration limit of feet to 100 % of the standard.";
    Op::SetVMaxSlow.name(), None, "§7-8-1-6", "7.24", Meaning::Robot(Op::SetVMaxSlow), Form::Robot(Arguments::target(Targets::FEET)), Robots::ALL, "", Cycles::One, outcome::NONE, "Sets the speed limit of feet to 50 % of the standard.";
    Op::SetVMaxFast.name(), None, "§7-8-1-6", "7.24", Meaning::Robot(Op::SetVMaxFast), Form::Robot(Arguments::target(Targets::FEET)), Robots::ALL, "", Cycles::One, outcome::NONE, "Sets the speed limit of feet to 150 % of the standard.";
    Op::SetVMaxNormal.name(), None, "§7-8-1-6", "7.24", Meaning::Robot(Op::SetVMaxNormal), Form::Robot(Arguments::target(Targets::FEET)), Robots::ALL, "", Cycles::One, outcome::NONE, "Sets the speed limit of feet to 100 % of the standard.";
    Op::SetJustPosition.name(), None, "§7-8-1-7", "7.21", Meaning::Robot(Op::SetJustPosition), Form::Robot(Arguments::setting(Targets::FEET, Values::One, Limit::NotNegative)), Robots::ALL, "mm", Cycles::One, outcome::NONE, "Sets the INPOS tolerance of feet.";
    Op::SetNearPosition.name(), None, "§7-8-1-8", "7.21", Meaning::Robot(Op::SetNearPosition), Form::Robot(Arguments::setting(Targets::FEET, Values::One, Limit::NotNegative)), Robots::ALL, "mm", Cycles::One, outcome::NONE, "Sets the NEAR tolerance of feet.";
    Op::SetOmegaMax.name(), None, "§7-8-2-1", "7.22", Meaning::Robot(Op::SetOmegaMax), Form::Robot(Arguments::setting(Targets::JOINTS, Values::One, Limit::NotNegative)), Robots::ALL, "deg/s", Cycles::One, outcome::NONE, "Sets the speed limit of joints.";
    Op::SetOmegaDotMax.name(), None, "§7-8-2-2", "7.22", Meaning::Robot(Op::SetOmegaDotMax), Form::Robot(Arguments::setting(Targets::JOINTS, Values::One, Limit::NotNegative)), Robots::ALL, "deg/s²", Cycles::One, outcome::NONE, "Sets the acceleration limit of joints.";
    Op::SetOmegaMaxRate.name(), None, "§7-8-2-3", "7.23", Meaning::Robot(Op::SetOmegaMaxRate), Form::Robot(Arguments::setting(Targets::JOINTS, Values::One, Limit::Percent)), Robots::ALL, "%", Cycles::One, outcome::NONE, "Sets the speed limit of joints to a part of the standard.";
    Op::SetOmegaDotMaxRate.name(), None, "§7-8-2-4", "7.23", Meaning::Robot(Op::SetOmegaDotMaxRate), Form::Robot(Arguments::setting(Targets::JOINTS, Values::One, Limit::Percent)), Robots::ALL, "%", Cycles::One, outcome::NONE, "Sets the acceleration limit of joints to a part of the standard.";
    Op::SetOmegaMaxSlow.name(), None, "§7-8-2-5", "7.24", Meaning::Robot(Op::SetOmegaMaxSlow), Form::Robot(Arguments::target(Targets::JOINTS)), Robots::ALL, "", Cycles::One, outcome::NONE, "Sets the speed limit of joints to 50 % of the standard.";
    Op::SetOmegaMaxFast.name(), None, "§7-8-2-5", "7.24", Meaning::Robot(Op::SetOmegaMaxFast), Form::Robot(Arguments::target(Targets::JOINTS)), Robots::ALL, "", Cycles::One, outcome::NONE, "Sets the speed limit of joints to 150 % of the standard.";
    Op::SetOmegaMaxNormal.name(), None, "§7-8-2-5", "7.24", Meaning::Robot(Op::SetOmegaMaxNormal), Form::Robot(Arguments::target(Targets::JOINTS)), Robots::ALL, "", Cycles::One, outcome::NONE, "Sets the speed limit of joints to 100 % of the standard.";
    Op::SetOmegaDotMaxSlow.name(), None, "§7-8-2-6", "7.24", Meaning::Robot(Op::SetOmegaDotMaxSlow), Form::Robot(Arguments::target(Targets::JOINTS)), Robots::ALL, "", Cycles::One, outcome::NONE, "Sets the acceleration limit of joints to 50 % of the standard.";
    Op::SetOmegaDotMaxFast.name(), None, "§7-8-2-6", "7.24", Meaning::Robot(Op::SetOmegaDotMaxFast), Form::Robot(Arguments::target(Targets::JOINTS)), Robots::ALL, "", Cycles::One, outcome::NONE, "Sets the acceleration limit of joints to 150 % of the standard.";
    Op::SetOmegaDotMaxNormal.name(), None, "§7-8-2-6", "7.24", Meaning::Robot(Op::SetOmegaDotMaxNormal), Form::Robot(Arguments::target(Targets::JOINTS)), Robots::ALL, "", Cycles::One, outcome::NONE, "Sets the acceleration limit of joints to 100 % of the standard.";
    Op::SetJustAngle.name(), None, "§7-8-2-7", "7.25", Meaning::Robot(Op::SetJustAngle), Form::Robot(Arguments::setting(Targets::ANY, Values::Tolerances, Limit::NotNegative)), Robots::ALL, "deg", Cycles::One, outcome::NONE, "Sets the INPOS tolerance of joints.";
    Op::SetNearAngle.name(), None, "§7-8-2-8", "7.25", Meaning::Robot(Op::SetNearAngle), Form::Robot(Arguments::setting(Targets::ANY, Values::Tolerances, Limit::NotNegative)), Robots::ALL, "deg", Cycles::One, outcome::NONE, "Sets the NEAR tolerance of joints.";
    Op::SetTorqueMax.name(), None, "§7-8-3-1", "7.26", Meaning::Robot(Op::SetTorqueMax), Form::Robot(Arguments::setting(Targets::JOINTS, Values::One, Limit::NotNegative)), Robots::FORCE, "torque", Cycles::One, outcome::NONE, "Sets the torque limit of joints.";
    Op::SetTorqueMaxRate.name(), None, "§7-8-3-2", "7.23", Meaning::Robot(Op::SetTorqueMaxRate), Form::Robot(Arguments::setting(Targets::JOINTS, Values::One, Limit::Percent)), Robots::FORCE, "%", Cycles::One, outcome::NONE, "Sets the torque limit of joints to a part of the standard.";
    Op::SetTorqueMaxSoft.name(), None, "§7-8-3-3", "7.24", Meaning::Robot(Op::SetTorqueMaxSoft), Form::Robot(Arguments::target(Targets::JOINTS)), Robots::FORCE, "", Cycles::One, outcome::NONE, "Sets the torque limit of joints to 50 % of the standard.";
    Op::SetTorqueMaxFirmly.name(), None, "§7-8-3-3", "7.24", Meaning::Robot(Op::SetTorqueMaxFirmly), Form::Robot(Arguments::target(Targets::JOINTS)), Robots::FORCE, "", Cycles::One, outcome::NONE, "Sets the torque limit of joints to 150 % of the standard.";
    Op::SetTorqueMaxNormal.name(), None, "§7-8-3-3", "7.24", Meaning::Robot(Op::SetTorqueMaxNormal), Form::Robot(Arguments::target(Targets::JOINTS)), Robots::FORCE, "", Cycles::One, outcome::NONE, "Sets the torque limit of joints to 100 % of the standard.";
    Op::SetAngleStiffness.name(), None, "§7-8-3-4", "7.26", Meaning::Robot(Op::SetAngleStiffness), Form::Robot(Arguments::setting(Targets::JOINTS, Values::One, Limit::NotNegative)), Robots::FORCE, "torque/deg", Cycles::One, outcome::NONE, "Sets the spring of compliant joints.";
    Op::SetPositionStiffness.name(), None, "§7-8-3-5", "7.27", Meaning::Robot(Op::SetPositionStiffness), Form::Robot(Arguments::setting(Targets::FEET, Values::Three, Limit::NotNegative)), Robots::FORCE, "N/mm", Cycles::One, outcome::NONE, "Sets the springs of compliant positions along x, y, z.";
    Op::SetComplianceTorqueLimit.name(), None, "§7-8-3-6", "7.28", Meaning::Robot(Op::SetComplianceTorqueLimit), Form::Robot(Arguments::setting(Targets::ANY, Values::TorqueLimits, Limit::Positive)), Robots::FORCE, "torque", Cycles::One, outcome::NONE, "Bounds the torque of compliant joints.";
    Op::ResetComplianceTorqueLimit.name(), None, "§7-8-3-7", "7.30", Meaning::Robot(Op::ResetComplianceTorqueLimit), Form::Robot(Arguments::target(Targets::ANY)), Robots::FORCE, "", Cycles::One, outcome::NONE, "Lifts that bound.";
    Op::SetComplianceForceLimit.name(), None, "§7-8-3-8", "7.29", Meaning::Robot(Op::SetComplianceForceLimit), Form::Robot(Arguments::setting(Targets::TIPS, Values::Position, Limit::Positive)), Robots::FORCE, "N", Cycles::One, outcome::NONE, "Bounds the force of compliant positions.";
    Op::ResetComplianceForceLimit.name(), None, "§7-8-3-9", "7.30", Meaning::Robot(Op::ResetComplianceForceLimit), Form::Robot(Arguments::target(Targets::TIPS)), Robots::FORCE, "", Cycles::One, outcome::NONE, "Lifts that bound.";
    Op::SetSamplingTime.name(), None, "§7-8-4-1", "7.31", Meaning::Robot(Op::SetSamplingTime), Form::Robot(Arguments::setting(Targets::NONE, Values::One, Limit::Period)), Robots::ALL, "ms", Cycles::One, outcome::NONE, "Sets the control cycle.";
    Op::SetSamplingFreq.name(), None, "§7-8-4-2", "7.31", Meaning::Robot(Op::SetSamplingFreq), Form::Robot(Arguments::setting(Targets::NONE, Values::One, Limit::Frequency)), Robots::ALL, "Hz", Cycles::One, outcome::NONE, "Sets the control cycle.";
    "AD_IN", None, "§7-9-1", "7.32", Meaning::AdIn, Form::AdIn, Robots::ALL, "V", Cycles::One, outcome::INPUT, "Reads an input into a VAR.";
    "KEY_IN", None, "§7-9-2", "7.33", Meaning::KeyIn, Form::KeyIn, Robots::ALL, "", Cycles::Until("a key is in the buffer"), outcome::NONE, "Waits for a key and stores its upper-case code in the VAR, or in VAR_KEY; empties the buffer.";
    Op::FlushBuf.name(), None, "§7-9-3", "7.34", Meaning::Robot(Op::FlushBuf), Form::Robot(Arguments::BARE), Robots::ALL, "", Cycles::One, outcome::NONE, "Empties the keyboard buffer.";
    "MESSAGE", None, "§7-9-4", "7.35", Meaning::Word, Form::Words("[text]"), Robots::ALL, "", Cycles::One, outcome::READS, "Shows a line of text with the values of variables.";
    "MESSAGE_CLEAR", None, "§7-9-5", "7.34", Meaning::MessageClear, Form::Robot(Arguments::BARE), Robots::ALL, "", Cycles::One, outcome::NONE, "Clears the message line.";
    Op::LampOn.name(), None, "§7-9-6", "7.36", Meaning::Robot(Op::LampOn), Form::Robot(Arguments::setting(Targets::NONE, Values::One, Limit::Lamp)), Robots::ALL, "", Cycles::One, outcome::NONE, "Switches a lamp or relay on.";
    Op::LampOff.name(), None, "§7-9-7", "7.36", Meaning::Robot(Op::LampOff), Form::Robot(Arguments::setting(Targets::NONE, Values::One, Limit::Lamp)), Robots::ALL, "", Cycles::One, outcome::NONE, "Switches a lamp or relay off.";
    Op::SilentOn.name(), None, "§7-9-8", "7.37", Meaning::Robot(Op::SilentOn), Form::Robot(Arguments::BARE), Robots::LATER, "", Cycles::One, outcome::NONE, "Shows as little as possible on the screen.";
    Op::SilentOff.name(), None, "§7-9-9", "7.37", Meaning::Robot(Op::SilentOff), Form::Robot(Arguments::BARE), Robots::LATER, "", Cycles::One, outcome::NONE, "Shows everything again.";
    "REM", None, "§7-10-2", "7.38", Meaning::Word, Form::Words("[text]"), Robots::ALL, "", Cycles::One, outcome::NONE, "Does nothing for one cycle.";
    "END", None, "§7-10-3", "7.39", Meaning::Word, Form::Words(""), Robots::ALL, "", Cycles::One, outcome::NONE, "Ends the program, and its text.";
    "EXIT", None, "§7-10-4", "7.39", Meaning::Word, Form::Words(""), Robots::ALL, "", Cycles::One, outcome::NONE, "Ends the program.";
    Op::LogStart.name(), None, "§7-10-5", "7.40", Meaning::Robot(Op::LogStart), Form::Robot(Arguments::BARE), Robots::ALL, "", Cycles::One, outcome::NONE, "Records every cycle for TITAN.LOG.";
    Op::LogStop.name(), None, "§7-10-6", "7.40", Meaning::Robot(Op::LogStop), Form::Robot(Arguments::BARE), Robots::ALL, "", Cycles::One, outcome::NONE, "Pauses the recording.";
    Op::LogOneShot.name(), None, "§7-10-7", "7.40", Meaning::Robot(Op::LogOneShot), Form::Robot(Arguments::BARE), Robots::ALL, "", Cycles::One, outcome::NONE, "Records this cycle for TITAN.LOG.";
    Op::OutputVariables.name(), None, "§7-10-8", "7.41", Meaning::Robot(Op::OutputVariables), Form::Robot(Arguments::BARE), Robots::ALL, "", Cycles::One, outcome::NONE, "Writes every variable to a file; the robot is held meanwhile.";
    Op::EmgOff.name(), None, "§7-10-9", "7.42", Meaning::Robot(Op::EmgOff), Form::Robot(Arguments::BARE), Robots::ALL, "", Cycles::One, outcome::NONE, "A joint at its limit stops there.";
    Op::EmgOn.name(), None, "§7-10-10", "7.42", Meaning::Robot(Op::EmgOn), Form::Robot(Arguments::BARE), Robots::ALL, "", Cycles::One, outcome::NONE, "A joint at its limit is an emergency stop.";
    Op::Special.name(), None, "§7-10-11", "7.43", Meaning::Robot(Op::Special), Form::Special, Robots::ALL, "", Cycles::Until("the native code says so"), outcome::NATIVE, "Runs native code of the robot.";
    Op::StandUp.name(), None, "§7-11-1", "7.44", Meaning::Robot(Op::StandUp), Form::Robot(Arguments::setting(Targets::NONE, Values::One, Limit::Any)), Robots::TITAN, "mm", Cycles::Until("all feet have arrived"), outcome::STAND, "Raises the body slowly.";
    Op::SitDown.name(), None, "§7-11-2", "7.44", Meaning::Robot(Op::SitDown), Form::Robot(Arguments::setting(Targets::NONE, Values::One, Limit::Any)), Robots::TITAN, "mm", Cycles::Until("all feet have arrived"), outcome::STAND, "Lowers the body slowly.";
    Op::DetectFloor.name(), None, "§7-11-3", "7.45", Meaning::Robot(Op::DetectFloor), Form::Robot(Arguments::setting(Targets::FEET, Values::One, Limit::FloorType)), Robots::NAMED, "", Cycles::Until("every foot or finger feels the floor (T, type 3: no longer feels it)"), outcome::FLOOR, "Searches the floor with feet or fingers.";
    Op::DetectObject.name(), None, "§7-11-4", "7.46", Meaning::Robot(Op::DetectObject), Form::Robot(Arguments::setting(Targets::NONE, Values::One, Limit::ObjectType)), Robots::HAND, "", Cycles::Until("every finger feels the object"), outcome::OBJECT, "Closes the fingers until they touch an object.";
};
