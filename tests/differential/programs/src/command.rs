//! Commands of the robot, each by its row in the compiler's table.

use crate::writer::{JOINTS, POSITIONS, VARS, Writer};
use tipc::language::commands::{Arguments, COMMANDS, Command, Form, Joints, Targets, Values};

impl Writer {
    /// Any command that the robot has, control words aside.
    pub(crate) fn robot_command(&mut self) {
        let robot = self.robot;
        let known: Vec<&Command> = COMMANDS
            .iter()
            .filter(|command| {
                command.robots.contains(robot)
                    && command.since <= self.edition
                    && !matches!(command.form, Form::Words(_))
                    && !self.is_left_out(command)
            })
            .collect();
        let command = self.pick(&known);
        let name = match command.alias {
            Some(alias) if self.random.once_in(4) => alias,
            _ => command.name,
        };
        let arguments = match command.form_in(self.edition) {
            Form::Robot(form) => self.arguments(command, form),
            Form::Special => self.special(),
            Form::Teach(targets) => self.teach(command, targets),
            Form::AdIn => self.ad_in(),
            Form::KeyIn => self.pick(&["", "B"]).to_owned(),
            Form::Words(_) => String::new(),
        };
        let statement = format!("{name} {arguments}");
        let words: Vec<&str> = statement
            .split(' ')
            .filter(|word| !word.is_empty())
            .collect();
        self.line(&words.join(" "));
    }

    fn arguments(&mut self, command: &Command, form: Arguments) -> String {
        let hs = if form.hs && self.random.once_in(4) {
            "HS "
        } else {
            ""
        };
        let target = self.target(form.targets);
        let values = self.values(command, form, &target);
        format!("{hs}{target} {values}")
    }

    /// A target of the kinds that a command takes; empty if it takes none.
    pub(crate) fn target(&mut self, targets: Targets) -> String {
        let mut kinds = Vec::new();
        if targets.foot {
            kinds.extend([self.foot(), self.foot()]);
        }
        match targets.joints {
            Joints::Every => kinds.extend([self.joint(), self.joint()]),
            Joints::Second => kinds.push(self.joint_numbered(2)),
            Joints::Third => kinds.push(self.joint_numbered(3)),
            Joints::ThirdOfHand if self.is_hand() => kinds.push(self.joint_numbered(3)),
            Joints::None | Joints::ThirdOfHand => {}
        }
        if targets.all {
            kinds.push("ALL".to_owned());
        }
        if targets.floor && self.robot.facts().has_slider {
            kinds.push("FLOOR".to_owned());
        }
        match kinds.is_empty() {
            true => String::new(),
            false => self.pick(&kinds),
        }
    }

    fn values(&mut self, command: &Command, form: Arguments, target: &str) -> String {
        let joints = usize::from(self.robot.signature().joints);
        let single = target.starts_with('J');
        match form.values {
            Values::None => String::new(),
            Values::One => self.plain(command, form, 1),
            Values::Three => self.plain(command, form, 3),
            Values::Position => self.several(command, form, target, POSITIONS, 3),
            Values::Angles if single => self.scalars(command, form, target, 1),
            Values::PerJoint | Values::PerLeg if single => self.plain(command, form, 1),
            Values::PerLeg if target == "ALL" => self.plain(command, form, 1),
            Values::ThreeOrPos if self.is_calm() || self.random.once_in(2) => {
                self.plain(command, form, 3)
            }
            Values::ThreeOrPos => self.struct_reading(Some(POSITIONS)),
            Values::Limits => self.limits(target),
            Values::PerJoint if target == "ALL" && self.random.once_in(2) => {
                self.plain(command, form, 1)
            }
            Values::Angles | Values::PerJoint | Values::PerLeg => {
                self.several(command, form, target, JOINTS, joints)
            }
        }
    }

    /// Writes this many constants or VARs.
    fn plain(&mut self, command: &Command, form: Arguments, count: usize) -> String {
        let values: Vec<String> = (0..count)
            .map(|_| match self.takes_variable() {
                true if self.reads() => self.var_reading(),
                true => self.pick(VARS).to_owned(),
                false => {
                    let number = self.number(command, form.limit);
                    self.perhaps_named(number)
                }
            })
            .collect();
        values.join(" ")
    }

    /// A struct, or so many scalars.
    fn several(
        &mut self,
        command: &Command,
        form: Arguments,
        target: &str,
        structs: &[&str],
        count: usize,
    ) -> String {
        if self.takes_variable() {
            let flag = if form.relative {
                self.pick(&["", "R ", "A "])
            } else {
                ""
            };
            if self.reads() {
                return format!("{flag}{}", self.struct_reading(Some(structs)));
            }
            return format!("{flag}{}", self.pick(structs));
        }
        self.scalars(command, form, target, count)
    }

    fn scalars(
        &mut self,
        command: &Command,
        form: Arguments,
        target: &str,
        count: usize,
    ) -> String {
        let home = self.home(command.unit, target).filter(|_| form.relative);
        let values: Vec<String> = (0..count)
            .map(|n| self.one(command, form, home.as_ref().map(|home| home[n])))
            .collect();
        values.join(self.pick(&[" ", ", "]))
    }

    /// A scalar with its flag, near where the target begins if that is known.
    fn one(&mut self, command: &Command, form: Arguments, home: Option<f64>) -> String {
        if self.takes_variable() {
            let flag = if form.relative {
                self.pick(&["", "R "])
            } else {
                ""
            };
            let scalar = self.scalar();
            return format!("{flag}{}", self.unless_constant(scalar));
        }
        let number = self.number(command, form.limit);
        match home {
            _ if form.relative && self.random.once_in(3) => {
                format!("R {}", self.perhaps_named(number))
            }
            Some(home) => {
                let flag = match form.from_target {
                    true => "A ",
                    false => self.pick(&["", "", "A "]),
                };
                match number.parse::<f64>() {
                    Ok(delta) => format!("{flag}{}", home + delta),
                    Err(_) => format!("{flag}{number}"),
                }
            }
            None => self.perhaps_named(number),
        }
    }

    /// Returns true if variables replace numbers. Their values may be out of range.
    fn takes_variable(&mut self) -> bool {
        self.random.once_in(if self.is_calm() { 24 } else { 5 })
    }
}
