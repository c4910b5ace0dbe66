//! Motions: positions and angles, velocities, torques and springs (T.I.P. 3.1 §7-1 to §7-3).

use super::{Arguments, Command, Robots, Targets, Values, outcome};
use tip_runtime::command::Op;

pub(super) const ROWS: &[Command] = &[
    Command::robot(Op::Ptp)
        .place("§7-1-1", "7.2")
        .does("Moves a foot in a straight line to a position.")
        .takes(Arguments::motion(Targets::PLACE, Values::Position).fast())
        .unit("mm")
        .fails(outcome::REACH),
    Command::robot(Op::RelPtp)
        .place("§7-1-2", "7.3")
        .does("Moves a foot relative to its target; three zeros stop it where it is.")
        .takes(Arguments::motion(Targets::PLACE, Values::Position).plain().fast())
        .unit("mm")
        .fails(outcome::REACH),
    Command::robot(Op::PtpAngle)
        .place("§7-1-3", "7.4")
        .does("Turns joints to angles.")
        .takes(Arguments::motion(Targets::FOOT_JOINT, Values::Angles).fast())
        .unit("deg")
        .fails(outcome::TURN),
    Command::robot(Op::RelPtpAngle)
        .place("§7-1-4", "7.4")
        .does("Turns joints relative to their targets; zeros stop them where they are.")
        .takes(Arguments::motion(Targets::FOOT_JOINT, Values::Angles).plain().fast())
        .unit("deg")
        .fails(outcome::TURN),
    Command::robot(Op::AllStop)
        .place("§7-1-5", "7.5")
        .does("Holds every joint where it comes to rest; modes and targets are kept."),
    Command::robot(Op::AllStopRelease)
        .place("§7-1-6", "7.5")
        .does("Ends ALL_STOP: every motion goes on."),
    Command::robot(Op::InitialPosture)
        .place("§7-1-7", "7.6")
        .does("Sets off for the initial posture with standard parameters; WAIT_INPOS ALL awaits the arrival.")
        .until("all joints are at rest"),
    Command::robot(Op::VelControl)
        .place("§7-2-1", "7.7")
        .does("Moves a foot with a velocity.")
        .takes(Arguments::motion(Targets::FOOT, Values::Position))
        .unit("mm/s")
        .fails(outcome::GLIDE),
    Command::robot(Op::OmegaControl)
        .place("§7-2-2", "7.8")
        .does("Turns joints with angular velocities.")
        .takes(Arguments::motion(Targets::FOOT_JOINT, Values::Angles))
        .unit("deg/s")
        .fails(outcome::SPIN),
    Command::robot(Op::Torque)
        .place("§7-3-1", "7.9")
        .does("Gives joints a torque.")
        .takes(Arguments::motion(Targets::FOOT_JOINT, Values::Angles))
        .unit("torque")
        .only(Robots::FORCE)
        .fails(outcome::SWING),
    Command::robot(Op::Force)
        .place("§7-3-2", "7.10")
        .does("Presses with a fingertip or third joint.")
        .takes(Arguments::motion(Targets::TIP, Values::Position))
        .unit("N")
        .only(Robots::FORCE)
        .fails(outcome::SWING),
    Command::robot(Op::ComplianceAngle)
        .place("§7-3-3", "7.11")
        .does("Holds joints at angles by springs.")
        .takes(Arguments::motion(Targets::ANY, Values::Angles).fast())
        .unit("deg")
        .only(Robots::FORCE)
        .fails(outcome::SWING),
    Command::robot(Op::RelComplianceAngle)
        .place("§7-3-4", "7.11")
        .does("The same relative to their targets.")
        .takes(Arguments::motion(Targets::ANY, Values::Angles).plain().fast())
        .unit("deg")
        .only(Robots::FORCE)
        .fails(outcome::SWING),
    Command::robot(Op::CompliancePosition)
        .place("§7-3-5", "7.12")
        .does("Holds fingertips or third joints at a position by springs.")
        .takes(Arguments::motion(Targets::TIPS, Values::Position).fast())
        .unit("mm")
        .only(Robots::FORCE)
        .fails(outcome::SWING),
    Command::robot(Op::RelCompliancePosition)
        .place("§7-3-6", "7.12")
        .does("The same relative to their targets.")
        .takes(Arguments::motion(Targets::TIPS, Values::Position).from_target().fast())
        .unit("mm")
        .only(Robots::FORCE)
        .fails(outcome::SWING),
    Command::robot(Op::NoCompliance)
        .place("§7-3-7", "7.13")
        .does("Ends compliance: angle control at the measured angle.")
        .takes(Arguments::target(Targets::FOOT_JOINT))
        .only(Robots::FORCE),
];
