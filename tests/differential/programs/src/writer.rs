//! The program as a whole: declarations, first values, the loop that it stays in, subroutines.

use crate::{Temper, pick};
use std::fmt::Write as _;
use tip_runtime::random::Random;
use tipc::Robot;
use tipc::language::Edition;

/// Variables that equations and commands fill.
pub(crate) const VARS: &[&str] = &["B", "C", "D"];
/// Loop variables, one for each depth of blocks; those of a thread have its number behind them. Nothing else reads them,
/// so that they need no first values.
pub(crate) const COUNTERS: &[&str] = &["I", "K"];
pub(crate) const POSITIONS: &[&str] = &["P", "Q"];
pub(crate) const JOINTS: &[&str] = &["S", "T"];

/// Maximum depth of blocks.
pub(crate) const DEPTH: usize = COUNTERS.len();

pub(crate) struct Writer {
    pub(crate) random: Random,
    pub(crate) edition: Edition,
    pub(crate) robot: Robot,
    pub(crate) temper: Temper,
    text: String,
    labels: u32,
    /// Number of open blocks.
    pub(crate) depth: usize,
    pub(crate) subroutines: u64,
    /// GOTO may not leave a SUBROUTINE, RETURN belongs in one.
    pub(crate) in_subroutine: bool,
    pub(crate) threads: u64,
    /// The thread that statements are written for.
    pub(crate) in_thread: Option<u64>,
    /// Number of DEFINEs so far.
    pub(crate) defined: u32,
}

impl Writer {
    pub(crate) fn new(mut random: Random, edition: Edition, robot: Robot, temper: Temper) -> Self {
        let subroutines = pick(&mut random, &[0, 0, 1, 1, 2]);
        let threads = match edition {
            Edition::V3_1 => 0,
            _ => pick(&mut random, &[0, 1, 1, 2, 3]),
        };
        Writer {
            random,
            edition,
            robot,
            temper,
            text: String::new(),
            labels: 0,
            depth: 0,
            subroutines,
            in_subroutine: false,
            threads,
            in_thread: None,
            defined: 0,
        }
    }

    /// One of several.
    pub(crate) fn pick<T: Clone>(&mut self, from: &[T]) -> T {
        pick(&mut self.random, from)
    }

    pub(crate) fn write(mut self, seed: u64) -> String {
        self.line(&self.edition.to_string());
        self.line(&format!("random program {seed}"));
        self.declarations();
        self.first_values();
        self.first_threads();
        self.stays();
        // After REM the program runs into its first subroutine, which later editions refuse.
        let leaves: &[&str] = match self.edition {
            Edition::V3_1 => &["EXIT", "EXIT", "GOTO LAST:", "REM"],
            _ => &["EXIT", "EXIT", "GOTO LAST:"],
        };
        let leaves = self.pick(leaves);
        self.line(leaves);
        for n in 0..self.subroutines {
            self.subroutine(n);
        }
        for n in 0..self.threads {
            self.thread(n);
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

    /// Returns true for the words that 3.2 brought.
    pub(crate) fn is_later(&self) -> bool {
        self.edition > Edition::V3_1
    }

    /// The loop variable of the present depth.
    pub(crate) fn counter(&self) -> String {
        let counter = COUNTERS[self.depth];
        match self.in_thread {
            Some(thread) => format!("{counter}{thread}"),
            None => counter.to_owned(),
        }
    }

    fn declarations(&mut self) {
        self.line("DEF_VAR B C D, I, K");
        self.line("DEF_POS P, Q");
        self.line("DEF_JOINT S T");
        if self.is_later() {
            self.later_declarations();
        }
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
        if self.is_later() {
            lines.extend(self.later_values());
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
