//! Syntax of a command, shown by an example for the robot at hand.

use super::{Arguments, Command, Form, Joints, Meaning, Targets, Values};
use crate::language::Edition;
use crate::robot::Robot;
use tip_runtime::command::{Target, Teach};

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
