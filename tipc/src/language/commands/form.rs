//! Argument forms as data.

use super::{Command, Meaning};
use crate::language::Edition;
use crate::robot::Robot;
use tip_runtime::command::{Target, Teach};
use tip_runtime::model::Family;

/// A set of robots: families, and whether a member must sense and give torque.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Robots {
    titan: bool,
    hand: bool,
    generic: bool,
    with_forces: bool,
}

impl Robots {
    /// Every robot.
    pub const ALL: Robots = Robots::new(true, true, true);
    /// The Hiroshima Hand and generic robots.
    pub const LATER: Robots = Robots::new(false, true, true);
    /// Later robots that sense and give torque.
    pub const FORCE: Robots = Robots {
        with_forces: true,
        ..Robots::LATER
    };
    /// TITAN VIII alone.
    pub const TITAN: Robots = Robots::new(true, false, false);
    /// TITAN VIII and the Hiroshima Hand.
    pub const NAMED: Robots = Robots::new(true, true, false);
    /// The Hiroshima Hand alone.
    pub const HAND: Robots = Robots::new(false, true, false);

    const fn new(titan: bool, hand: bool, generic: bool) -> Self {
        Robots {
            titan,
            hand,
            generic,
            with_forces: false,
        }
    }

    /// Returns true if the robot is in the set.
    pub const fn contains(self, robot: Robot) -> bool {
        self.has_family(robot.signature().family) && !self.misses_forces(robot)
    }

    /// Returns true if the robot would have to sense and give torque, and does not.
    pub(crate) const fn misses_forces(self, robot: Robot) -> bool {
        let facts = robot.facts();
        self.with_forces && self.has_family(facts.signature.family) && !facts.has_forces
    }

    const fn has_family(self, family: Family) -> bool {
        match family {
            Family::Titan => self.titan,
            Family::Hand => self.hand,
            Family::Generic => self.generic,
        }
    }

    /// Returns the robots' names.
    pub fn names(self) -> Vec<&'static str> {
        let robots = Robot::ALL.iter().copied();
        let robots = robots.filter(|robot| self.contains(*robot));
        robots.map(Robot::name).collect()
    }
}

/// Allowed targets of a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Targets {
    /// `F`: a foot or finger.
    pub foot: bool,
    /// `J`: which joints.
    pub joints: Joints,
    /// `ALL`
    pub all: bool,
    /// `FLOOR`, on the hand.
    pub floor: bool,
}

/// Joints that may be used as a target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joints {
    /// None.
    None,
    /// Every joint.
    Every,
    /// The second joint of each leg.
    Second,
    /// The third joint of each leg.
    Third,
    /// The third joint of each finger of the hand; none on other robots.
    ThirdOfHand,
}

impl Targets {
    /// No target at all.
    pub const NONE: Targets = Targets {
        foot: false,
        joints: Joints::None,
        all: false,
        floor: false,
    };
    /// `F`
    pub const FOOT: Targets = Targets {
        foot: true,
        ..Targets::NONE
    };
    /// `F`, and on the hand `Jn3` and `FLOOR`.
    pub const PLACE: Targets = Targets {
        joints: Joints::ThirdOfHand,
        floor: true,
        ..Targets::FOOT
    };
    /// `F` or `J`
    pub const FOOT_JOINT: Targets = Targets {
        joints: Joints::Every,
        ..Targets::FOOT
    };
    /// `F`, `J` or `ALL`
    pub const ANY: Targets = Targets {
        all: true,
        ..Targets::FOOT_JOINT
    };
    /// `F` or `ALL`
    pub const FEET: Targets = Targets {
        all: true,
        ..Targets::FOOT
    };
    /// `F`, `ALL`, and on the hand `FLOOR`.
    pub const FEET_FLOOR: Targets = Targets {
        floor: true,
        ..Targets::FEET
    };
    /// `J` or `ALL`
    pub const JOINTS: Targets = Targets {
        joints: Joints::Every,
        all: true,
        ..Targets::NONE
    };
    /// `F` or `Jn3`
    pub const TIP: Targets = Targets {
        joints: Joints::Third,
        ..Targets::FOOT
    };
    /// `F`, `Jn3` or `ALL`
    pub const TIPS: Targets = Targets {
        all: true,
        ..Targets::TIP
    };
    /// `F` or `Jn2`
    pub const CONTACT: Targets = Targets {
        joints: Joints::Second,
        ..Targets::FOOT
    };
}

/// The operands after a target.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Values {
    /// None.
    None,
    /// One constant or VAR.
    One,
    /// Three constants or VARs.
    Three,
    /// A position: three scalars, or one POS.
    Position,
    /// Angles or torques: a scalar for each joint, or one JOINT; one scalar for a single joint.
    Angles,
    /// Like `Angles`; one constant or VAR for a single joint, and perhaps for ALL.
    PerJoint,
    /// Like `Angles`; one constant or VAR for a single joint and for ALL.
    PerLeg,
    /// Three constants or VARs, or one POS.
    ThreeOrPos,
    /// The lowest and the highest angle: two scalars for a joint, two JOINTs for a leg.
    Limits,
}

/// Runtime limit on the values of a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// Anything.
    Any,
    /// Not below zero.
    NotNegative,
    /// Above zero.
    Positive,
    /// Above zero, up to 100.
    Percent,
    /// A sampling time of the robot in ms.
    Period,
    /// A sampling frequency of the robot in Hz.
    Frequency,
    /// A lamp or relay that the robot has.
    Lamp,
    /// A type of DETECT_FLOOR.
    FloorType,
    /// A type of DETECT_OBJECT.
    ObjectType,
    /// A timer of the program.
    Timer,
    /// A number of steps of one cycle.
    Steps,
    /// A lower and an upper limit inside those of the joint.
    Angles,
}

/// The arguments of a command that the robot carries out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arguments {
    /// `HS` may come first.
    pub hs: bool,
    /// The target.
    pub targets: Targets,
    /// The operands after it.
    pub values: Values,
    /// True if `R` and `A` are flags here: motion commands only.
    pub motion: bool,
    /// True if `R` and `A` may precede operands.
    pub relative: bool,
    /// True if operands without a flag count from the target.
    pub from_target: bool,
    /// Limit on the operands.
    pub limit: Limit,
}

impl Arguments {
    /// No arguments.
    pub const BARE: Arguments = Arguments {
        hs: false,
        targets: Targets::NONE,
        values: Values::None,
        motion: false,
        relative: false,
        from_target: false,
        limit: Limit::Any,
    };

    /// Creates the form of a target alone.
    pub const fn target(targets: Targets) -> Self {
        Arguments {
            targets,
            ..Self::BARE
        }
    }

    /// Creates the form of a target and values within a limit.
    pub const fn setting(targets: Targets, values: Values, limit: Limit) -> Self {
        Arguments {
            targets,
            values,
            limit,
            ..Self::BARE
        }
    }

    /// Creates the form of a motion whose operands may be relative.
    pub const fn motion(targets: Targets, values: Values) -> Self {
        Arguments {
            targets,
            values,
            motion: true,
            relative: true,
            ..Self::BARE
        }
    }

    /// Returns the arguments without `R` and `A`.
    pub const fn plain(self) -> Self {
        Arguments {
            relative: false,
            ..self
        }
    }

    /// Returns the arguments with a change: operands without a flag count from the target, as after `R`.
    pub const fn from_target(self) -> Self {
        Arguments {
            from_target: true,
            ..self
        }
    }

    /// Returns the arguments with `HS`.
    pub const fn fast(self) -> Self {
        Arguments { hs: true, ..self }
    }
}

/// Syntax of a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// `[HS] target values`
    Robot(Arguments),
    /// `number [V] [V]`
    Special,
    /// A target and the variable that receives what is measured.
    Teach(Targets),
    /// `board channel VAR` or `id VAR`
    AdIn,
    /// `[VAR]`
    KeyIn,
    /// Described by this text; the parser reads it.
    Words(&'static str),
}

impl Command {
    /// Returns every form of it for a robot in an edition, as `PTP [HS] F1 [R] x [R] y [R] z`.
    pub fn usage(&self, robot: Robot, edition: Edition) -> Vec<String> {
        let behind = match self.form_in(edition) {
            Form::Robot(arguments) => arguments.usage(robot),
            Form::Special => vec!["0…255 [number] [number]".to_owned()],
            Form::Teach(targets) => teaching(self.meaning, targets, robot),
            Form::AdIn => vec!["VR1 VAR".to_owned(), "0 13 VAR".to_owned()],
            Form::KeyIn => vec![String::new(), "VAR".to_owned()],
            Form::Words(text) => vec![text.to_owned()],
        };
        let written = |arguments: &String| format!("{} {arguments}", self.name);
        behind
            .iter()
            .map(|arguments| written(arguments).trim_end().to_owned())
            .collect()
    }
}

fn teaching(meaning: Meaning, targets: Targets, robot: Robot) -> Vec<String> {
    match meaning {
        Meaning::Teach(Teach::Angle | Teach::Torque) => {
            vec!["F1 JOINT".to_owned(), "J11 VAR".to_owned()]
        }
        _ => vec![format!("{} POS", targets.examples(robot))],
    }
}

impl Arguments {
    /// Returns the flag of a default: the one that has the meaning of no flag.
    const fn flag(self) -> &'static str {
        match (self.relative, self.from_target) {
            (false, _) => "",
            (true, false) => "[R] ",
            (true, true) => "[A] ",
        }
    }

    fn usage(self, robot: Robot) -> Vec<String> {
        let hs = if self.hs { "[HS] " } else { "" };
        let all = self.targets.examples(robot);
        let legs = Targets {
            joints: Joints::None,
            all: self.targets.all && self.values != Values::PerLeg,
            ..self.targets
        };
        let several = |targets: &str, names: &[String], whole: &str| {
            let flag = self.flag();
            let names: Vec<String> = names.iter().map(|name| format!("{flag}{name}")).collect();
            vec![
                format!("{hs}{targets} {}", names.join(" ")),
                format!("{hs}{targets} {flag}{whole}"),
            ]
        };
        let joints = usize::from(robot.signature().joints);
        let angles: Vec<String> = (1..=joints).map(|joint| format!("j{joint}")).collect();
        let mut forms = match self.values {
            Values::None => vec![format!("{hs}{all}")],
            Values::One => vec![format!("{all} number")],
            Values::Three => vec![format!("{all} x y z")],
            Values::Position => several(&all, &["x", "y", "z"].map(str::to_owned), "POS"),
            Values::Angles => several(&legs.examples(robot), &angles, "JOINT"),
            Values::PerJoint => several("F1|ALL", &angles, "JOINT"),
            Values::PerLeg => several(&legs.examples(robot), &angles, "JOINT"),
            Values::ThreeOrPos => vec![format!("{all} x y z"), format!("{all} POS")],
            Values::Limits => vec!["J11 low high".to_owned(), "F1 JOINT JOINT".to_owned()],
        };
        match self.values {
            Values::Angles if self.targets.joints != Joints::None => {
                let flag = self.flag();
                forms.push(format!("{hs}J11 {flag}number"));
            }
            Values::PerJoint | Values::PerLeg => forms.push("J11|ALL number".to_owned()),
            _ => {}
        }
        forms
            .iter()
            .map(|form| form.trim_start().to_owned())
            .collect()
    }
}

impl Targets {
    /// Returns true if a target that the robot has is one of these.
    pub fn accept(self, target: Target, robot: Robot) -> bool {
        match target {
            Target::None => false,
            Target::All => self.all,
            Target::Floor => self.floor,
            Target::Foot(_) => self.foot,
            Target::Joint(_, joint) => match self.joints {
                Joints::None => false,
                Joints::Every => true,
                Joints::Second => joint == 2,
                Joints::Third => joint == 3,
                Joints::ThirdOfHand => joint == 3 && robot.is_hand(),
            },
        }
    }

    /// Returns one target of each sort that the robot has.
    pub(crate) fn examples(self, robot: Robot) -> String {
        let (joint, named) = match self.joints {
            Joints::Every => (1, "J11"),
            Joints::Second => (2, "J12"),
            Joints::Third => (3, "J13"),
            Joints::ThirdOfHand if robot.is_hand() => (3, "J13"),
            Joints::ThirdOfHand | Joints::None => (0, ""),
        };
        let sorts = [
            (self.foot, "F1"),
            (joint > 0 && robot.has(Target::Joint(1, joint)), named),
            (self.floor && robot.has(Target::Floor), "FLOOR"),
            (self.all, "ALL"),
        ];
        let examples: Vec<&str> = sorts
            .iter()
            .filter(|(stands, _)| *stands)
            .map(|(_, example)| *example)
            .collect();
        examples.join("|")
    }
}
