//! The program as a whole: declarations, first values, the loop that it stays in, subroutines.

use crate::random::Random;
use crate::{Temper, pick};
use std::fmt::Write as _;
use tipc::Robot;

/// Variables that equations and commands fill.
pub(crate) const VARS: &[&str] = &["B", "C", "D"];
/// Loop variables, one for each depth of blocks. Nothing else reads them, so that they need no first values.
pub(crate) const COUNTERS: &[&str] = &["I", "K"];
pub(crate) const POSITIONS: &[&str] = &["P", "Q"];
pub(crate) const JOINTS: &[&str] = &["S", "T"];

/// Maximum depth of blocks.
pub(crate) const DEPTH: usize = COUNTERS.len();

pub(crate) struct Writer {
    pub(crate) random: Random,
    pub(crate) robot: Robot,
    pub(crate) temper: Temper,
    text: String,
    labels: u32,
    /// Number of open blocks.
    pub(crate) depth: usize,
    pub(crate) subroutines: u64,
    /// GOTO may not leave a SUBROUTINE, RETURN belongs in one.
    pub(crate) in_subroutine: bool,
}

impl Writer {
    pub(crate) fn new(mut random: Random, robot: Robot, temper: Temper) -> Self {
        let subroutines = pick(&mut random, &[0, 0, 1, 1, 2]);
        Writer {
            random,
            robot,
            temper,
            text: String::new(),
            labels: 0,
            depth: 0,
            subroutines,
            in_subroutine: false,
        }
    }

    /// One of several.
    pub(crate) fn pick<T: Clone>(&mut self, from: &[T]) -> T {
        pick(&mut self.random, from)
    }

    pub(crate) fn write(mut self, seed: u64) -> String {
        self.line("3.1");
        self.line(&format!("random program {seed}"));
        self.declarations();
        self.first_values();
        self.stays();
        // After REM the program runs into its first subroutine.
        let leaves = self.pick(&["EXIT", "EXIT", "GOTO LAST:", "REM"]);
        self.line(leaves);
        for n in 0..self.subroutines {
            self.subroutine(n);
        }
        self.line("LAST: END");
        self.text
    }

    pub(crate) fn line(&mut self, line: &str) {
        let indent = self.depth * 2;
        writeln!(self.text, "{:indent$}{line}", "").expect("writing to a string");
    }

    /// A label that no other statement has.
    pub(crate) fn label(&mut self) -> String {
        self.labels += 1;
        format!("L{}", self.labels)
    }

    pub(crate) fn is_calm(&self) -> bool {
        self.temper == Temper::Calm
    }

    fn declarations(&mut self) {
        self.line("DEF_VAR B C D, I, K");
        self.line("DEF_POS P, Q");
        self.line("DEF_JOINT S T");
    }

    /// Every variable gets a value, except that wild programs leave one now and then for later.
    fn first_values(&mut self) {
        let mut lines = vec![
            "TEACH_POSITION F1 P".to_owned(),
            "TEACH_POSITION F2 Q".to_owned(),
            "TEACH_ANGLE F1 S".to_owned(),
            "TEACH_ANGLE F3 T".to_owned(),
        ];
        if !self.is_calm() {
            lines.push("VAR_KEY = CHAR_A".to_owned());
        }
        for var in VARS {
            let value = self.constant();
            lines.push(format!("{var} = {value}"));
        }
        let late = match self.temper {
            Temper::Calm => lines.len(),
            Temper::Wild => self.random.below(4 * lines.len() as u64) as usize,
        };
        for (n, line) in lines.iter().enumerate() {
            if n == late {
                self.line("IF KB_HIT THEN");
                self.line(line);
                self.line("ENDIF");
            } else {
                self.line(line);
            }
        }
        if self.random.below(4) > 0 {
            self.line("EMG_OFF");
        }
    }

    /// The loop that most programs stay in until someone requests a halt.
    fn stays(&mut self) {
        match self.random.below(4) {
            0 => {
                self.line("WHILE !HALT_REQUEST");
                self.body();
                self.line("WEND");
            }
            1 => {
                self.line("REPEAT");
                self.body();
                self.line("UNTIL HALT_REQUEST");
            }
            2 => {
                let again = self.label();
                self.line(&format!("{again}:"));
                self.body();
                self.line(&format!("IF !HALT_REQUEST GOTO {again}:"));
            }
            _ => {
                let (again, done) = (self.label(), self.label());
                self.line(&format!("{again}: IF HALT_REQUEST GOTO {done}:"));
                self.body();
                self.line(&format!("GOTO {again}:"));
                self.line(&format!("{done}:"));
            }
        }
    }

    fn body(&mut self) {
        for _ in 0..1 + self.random.below(3) {
            self.statement();
        }
    }

    fn subroutine(&mut self, n: u64) {
        self.in_subroutine = true;
        self.line(&format!("SUBROUTINE SUB{n}:"));
        self.block();
        if self.random.once_in(3) {
            let condition = self.condition();
            self.line(&format!("IF {condition} THEN"));
            self.line("RETURN");
            self.line("ENDIF");
        }
        self.line("SUBEND");
        self.in_subroutine = false;
    }
}
