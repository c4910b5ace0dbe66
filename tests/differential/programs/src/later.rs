//! Random uses of edition 3.2: named constants, readings, timers, threads, locks, limits, texts for a file.

use crate::writer::{COUNTERS, JOINTS, POSITIONS, Writer};
use tip_runtime::command::{Op, Teach};
use tip_runtime::model::{Family, Range, generic, hand, titan8};
use tipc::language::commands::{Command, Meaning, senses};

/// Values of BAD, which wild programs put where other values belong.
const BAD: &[&str] = &["-1", "0", "1E9", "-0.0", "300"];

impl Writer {
    pub(crate) fn later_declarations(&mut self) {
        self.line("DEFINE HALF 0.5");
        self.line("DEFINE LESS -HALF");
        self.line("DEFINE DIGIT CHAR_7");
        self.line("DEFINE NONE 0");
        self.line("DEF_JOINT LOW HIGH");
        for thread in 0..self.threads {
            let counters = COUNTERS.iter().map(|counter| format!("{counter}{thread}"));
            let counters: Vec<String> = counters.collect();
            self.line(&format!("DEF_VAR {}", counters.join(", ")));
        }
        if !self.is_calm() {
            self.line("DEF_VAR BAD");
        }
    }

    /// First values of what later statements read.
    pub(crate) fn later_values(&mut self) -> Vec<String> {
        let mut lines = Vec::new();
        let limits = self.joint_limits(0);
        let home = self.initial(0).unwrap_or_default();
        for ((joint, home), Range { min, max }) in (1..).zip(home).zip(limits) {
            lines.push(format!("LOW.J{joint} = {}", (home - 25.0).max(min)));
            lines.push(format!("HIGH.J{joint} = {}", (home + 25.0).min(max)));
        }
        if !self.is_calm() {
            let bad = self.pick(BAD);
            lines.insert(0, format!("BAD = {bad}"));
        }
        lines
    }

    /// Most threads run from the beginning, at some speed.
    pub(crate) fn first_threads(&mut self) {
        if self.is_later() && self.random.once_in(2) {
            let speed = self.pick(&["2", "3", "4", "10"]);
            self.line(&format!("TIP_SPEED_UP {speed}"));
        }
        for thread in 0..self.threads {
            if self.random.below(4) > 0 {
                self.line(&format!("START_THREAD THR{thread}:"));
            }
        }
    }

    /// A thread: some statements, perhaps until a halt is requested.
    pub(crate) fn thread(&mut self, n: u64) {
        self.in_thread = Some(n);
        self.line(&format!("THREAD THR{n}:"));
        match self.random.below(3) {
            0 => {
                self.line("WHILE !HALT_REQUEST");
                self.block();
                self.line("WEND");
            }
            1 => {
                let again = self.label();
                self.line(&format!("{again}:"));
                self.block();
                self.line(&format!("IF !HALT_REQUEST GOTO {again}:"));
            }
            _ => self.block(),
        }
        if self.random.once_in(4) {
            let condition = self.condition();
            let again = format!("GOTO THR{n}:");
            let leaves: &[&str] = match self.is_calm() {
                true => &["RETURN", &again],
                false => &["RETURN", &again, "EXIT"],
            };
            self.line(&format!("IF {condition} THEN"));
            let leaves = self.pick(leaves);
            self.line(leaves);
            self.line("ENDIF");
        }
        self.line("THREADEND");
        self.in_thread = None;
    }

    /// A statement that 3.2 brought.
    pub(crate) fn later_statement(&mut self) {
        match self.random.below(10) {
            0..=2 if self.threads > 0 => self.thread_command(),
            0..=4 => self.timed(),
            5 | 6 => self.later_message(),
            7 => self.locked(),
            _ => self.shared_equation(),
        }
    }

    /// Calm programs stop a thread before they start it, and only the main program does, so that it never runs then.
    fn thread_command(&mut self) {
        let thread = self.random.below(self.threads);
        if !self.is_calm() {
            let command = self.pick(&[
                "START_THREAD",
                "START_THREAD",
                "STOP_THREAD",
                "STOP_THREAD",
                "WAIT_THREAD",
            ]);
            return self.line(&format!("{command} THR{thread}:"));
        }
        self.line(&format!("STOP_THREAD THR{thread}:"));
        if self.in_thread.is_none() && !self.in_subroutine {
            if self.random.once_in(4) {
                self.line(&format!("WAIT_THREAD THR{thread}:"));
            }
            self.line(&format!("START_THREAD THR{thread}:"));
        }
    }

    fn timed(&mut self) {
        let timer = self.timer();
        let command = self.pick(&[
            "START_TIMER",
            "START_TIMER",
            "STOP_TIMER",
            "RESTART_TIMER",
            "RESET_TIMER",
        ]);
        match self.random.below(4) {
            0 => self.line(&format!("D = @TIMER{timer}")),
            1 => {
                let label = self.label();
                self.line(&format!("IF @TIMER{timer} < 100 GOTO {label}:"));
                self.line(&format!("{command} {timer}"));
                self.line(&format!("{label}:"));
            }
            _ => self.line(&format!("{command} {timer}")),
        }
    }

    /// Calm programs command no joint while it is locked, unless another thread does.
    fn locked(&mut self) {
        let (foot, joint) = (self.foot(), self.joint());
        let target = self.pick(&[foot.clone(), joint, "ALL".to_owned()]);
        self.line(&format!("LOCK {target}"));
        match self.is_calm() {
            true => self.scalar_equation(),
            false if self.random.once_in(3) => self.line(&format!("PTP_ANGLE {foot} LOW")),
            false => self.robot_command(),
        }
        if self.is_calm() || self.random.once_in(2) {
            self.line(&format!("UNLOCK {target}"));
        }
    }

    /// Variables that native code shares. Those that it writes are read only.
    fn shared_equation(&mut self) {
        let line = match self.random.below(5) {
            0 => "VAR_SPECIAL_0 = @TIMER0".to_owned(),
            1 => format!("POS_SPECIAL_3 = {}", self.pick(POSITIONS)),
            2 => format!("JNT_SPECIAL_9.J1 = {}", self.scalar()),
            3 => "D = VAR_SPECIAL_1".to_owned(),
            _ => "D = NORM JNT_SPECIAL_2".to_owned(),
        };
        self.line(&line);
    }

    /// MESSAGE or F_MESSAGE with what 3.2 shows.
    pub(crate) fn later_message(&mut self) {
        let word = self.pick(&["MESSAGE", "F_MESSAGE", "F_MESSAGE"]);
        let end = if word == "MESSAGE" { "" } else { "\\n" };
        let decimals = self.random.below(8);
        let text = match self.random.below(6) {
            0 => String::new(),
            1 => format!("a\\tb \\\\ 100% %B.X%{end}"),
            2 => format!("%{}.{decimals}% %S.J1.2%{end}", self.pick(POSITIONS)),
            3 => format!("%{}% %P.X%{end}", self.pick(JOINTS)),
            4 => format!("%@TIMER0.{decimals}% %HALF.1% %NONE%{end}"),
            _ => format!("%{}.1%{end}", self.struct_reading(None)),
        };
        self.line(format!("{word} {text}").trim_end());
    }

    /// Returns true now and then: a reading takes the place of a variable.
    pub(crate) fn reads(&mut self) -> bool {
        self.is_later() && self.random.once_in(6)
    }

    /// A scalar that the robot measures, a timer, or a variable shared with native code.
    pub(crate) fn scalar_reading(&mut self) -> String {
        let minus = self.pick(&["", "", "-"]);
        let foot = self.foot();
        match self.random.below(4) {
            0 => format!("{minus}@POS_{foot}.{}", self.pick(&["X", "Y", "Z"])),
            1 => format!("{minus}@AGL_{foot}.J1"),
            _ => self.var_reading(),
        }
    }

    /// One of these that is a VAR, not a member.
    pub(crate) fn var_reading(&mut self) -> String {
        let minus = self.pick(&["", "", "-"]);
        let joint = self.joint();
        let reading = match self.random.below(6) {
            0 | 1 => format!("@AGL_{joint}"),
            2 if senses(self.robot, Teach::Torque) => format!("@TRQ_{joint}"),
            3 => "VAR_SPECIAL_1".to_owned(),
            _ => format!("@TIMER{}", self.timer()),
        };
        format!("{minus}{reading}")
    }

    /// Any timer, and most often the first: it runs when it is read.
    fn timer(&mut self) -> u64 {
        match self.random.once_in(3) {
            true => self.random.below(8),
            false => 0,
        }
    }

    /// A struct that the robot measures or native code shares, of the type of `like`.
    pub(crate) fn struct_reading(&mut self, like: Option<&[&str]>) -> String {
        let like = match like {
            Some(names) => names == POSITIONS,
            None => self.random.once_in(2),
        };
        let foot = self.foot();
        let senses_forces = senses(self.robot, Teach::Force);
        match (like, self.random.below(4)) {
            (true, 0) => "POS_SPECIAL_3".to_owned(),
            (true, 1) if senses_forces => format!("@FORCE_{foot}"),
            (true, _) => format!("@POS_{foot}"),
            (false, 0) => "JNT_SPECIAL_2".to_owned(),
            (false, 1) if senses_forces => format!("@TRQ_{foot}"),
            (false, _) => format!("@AGL_{foot}"),
        }
    }

    /// Replaces a constant where 3.2 judges constants when it loads a program.
    pub(crate) fn unless_constant(&self, operand: String) -> String {
        let name = operand.trim_start_matches(['-', '+']);
        let is_number = name.starts_with(|first: char| first.is_ascii_digit() || first == '.');
        let is_name = ["CHAR_", "HALF", "LESS", "DIGIT", "NONE"];
        let is_constant = is_number || is_name.iter().any(|word| name.starts_with(word));
        match self.is_later() && is_constant {
            true => "D".to_owned(),
            false => operand,
        }
    }

    /// Names a number now and then, by a DEFINE before the statement that is being written.
    pub(crate) fn perhaps_named(&mut self, number: String) -> String {
        if !self.is_later() || number.parse::<f64>().is_err() || !self.random.once_in(12) {
            return number;
        }
        self.defined += 1;
        let name = format!("N{}", self.defined);
        self.line(&format!("DEFINE {name} {number}"));
        name
    }

    /// Limits around where a joint begins. Wild programs take other numbers too.
    pub(crate) fn limits(&mut self, target: &str) -> String {
        if target.starts_with('F') {
            return match self.is_calm() || self.random.below(4) > 0 {
                true => "LOW HIGH".to_owned(),
                false => "S T".to_owned(),
            };
        }
        let digit = |place: usize| target.as_bytes().get(place).map_or(0, |byte| byte - b'1');
        let (leg, joint) = (usize::from(digit(1)), usize::from(digit(2)));
        let home = self.initial(leg).unwrap_or_default();
        let own = self.joint_limits(leg);
        let (Some(home), Some(Range { min, max })) = (home.get(joint), own.get(joint)) else {
            return "D D".to_owned();
        };
        if !self.is_calm() && self.random.once_in(6) {
            return "LOW.J1 BAD".to_owned();
        }
        let width = self.pick(&[1.0, 15.0, 40.0, 1000.0]);
        format!("{} {}", (home - width).max(*min), (home + width).min(*max))
    }

    /// The limits of the joints of a leg.
    fn joint_limits(&self, leg: usize) -> Vec<Range> {
        let joints = match self.robot.signature().family {
            Family::Titan => titan8::MODEL.legs.get(leg).map(|leg| leg.joints),
            Family::Generic => generic::MODEL.legs.get(leg).map(|leg| leg.joints),
            Family::Hand => hand::MODEL.legs.get(leg).map(|leg| leg.joints),
        };
        let joints = joints.into_iter().flatten();
        joints.map(|joint| joint.limits).collect()
    }

    /// Returns true for a command that would end most calm programs soon: a second posture beside one that stands in
    /// another thread, and locks that stay.
    pub(crate) fn is_left_out(&self, command: &Command) -> bool {
        let Meaning::Robot(op) = command.meaning else {
            return false;
        };
        let is_posture = matches!(
            op,
            Op::InitialPosture
                | Op::StandUp
                | Op::SitDown
                | Op::DetectFloor
                | Op::DetectObject
                | Op::Special
        );
        let beside = self.in_thread.is_some() || (self.in_subroutine && self.threads > 0);
        self.is_calm() && (op == Op::Lock || (is_posture && beside))
    }
}
