//! Statements, and those of them that sequence others.

use crate::writer::{DEPTH, Writer};

impl Writer {
    /// Some statements.
    pub(crate) fn block(&mut self) {
        for _ in 0..1 + self.random.below(2) {
            self.statement();
        }
    }

    fn nested(&mut self) {
        self.depth += 1;
        self.block();
        self.depth -= 1;
    }

    pub(crate) fn statement(&mut self) {
        if self.is_later() && self.random.once_in(3) {
            return self.later_statement();
        }
        let kinds = if self.depth < DEPTH { 34 } else { 24 };
        match self.random.below(kinds) {
            0..=3 => self.scalar_equation(),
            4 => self.struct_equation(),
            5..=20 => self.robot_command(),
            21 => self.message(),
            22 => self.jump_ahead(),
            23 => self.call(),
            24..=26 => self.branches(),
            27..=28 => self.counted_while(),
            29 => self.repeat(),
            30..=31 => self.counted_for(),
            32 => self.jump_back(),
            _ => self.rare_or_gosub(),
        }
    }

    fn rare_or_gosub(&mut self) {
        match self.random.once_in(2) {
            true => self.gosub_label(),
            false => self.rarity(),
        }
    }

    fn branches(&mut self) {
        let first = self.condition();
        self.line(&format!("IF {first} THEN"));
        self.nested();
        for _ in 0..self.random.below(2) {
            let other = self.condition();
            self.line(&format!("ELSEIF {other} THEN"));
            self.nested();
        }
        if self.random.once_in(2) {
            self.line("ELSE");
            self.nested();
        }
        self.line("ENDIF");
    }

    fn counted_while(&mut self) {
        let (counter, rounds) = (self.counter(), self.random.below(4));
        self.line(&format!("{counter} = 0"));
        self.line(&format!("WHILE {counter} < {rounds}"));
        self.nested();
        self.line(&format!("{counter} += 1"));
        self.line("WEND");
    }

    /// Left by chance: every flag and comparison may hold.
    fn repeat(&mut self) {
        let (counter, rounds) = (self.counter(), 1 + self.random.below(3));
        self.line(&format!("{counter} = 0"));
        self.line("REPEAT");
        self.nested();
        self.line(&format!("{counter} += 1"));
        if self.is_calm() {
            self.line(&format!("UNTIL {counter} >= {rounds}"));
        } else {
            let leaves = self.condition();
            self.line(&format!("UNTIL {leaves}"));
        }
    }

    fn counted_for(&mut self) {
        let counter = self.counter();
        let last = 1 + self.random.below(3);
        let range = match self.random.below(5) {
            0 => format!("{last} TO 1 STEP -1"),
            1 => format!("-0.5 TO {last} STEP .75"),
            2 if !self.is_calm() => {
                let (from, to, by) = (self.scalar(), self.scalar(), self.scalar());
                let by = self.unless_constant(by);
                format!("{from} TO {to} STEP {by}")
            }
            3 => "D TO D".to_owned(),
            _ => format!("1 TO {last}"),
        };
        self.line(&format!("FOR {counter} = {range}"));
        self.nested();
        let named = if self.random.once_in(2) { &counter } else { "" };
        self.line(format!("NEXT {named}").trim_end());
    }

    /// A jump over some statements.
    fn jump_ahead(&mut self) {
        let label = self.label();
        if self.random.once_in(3) {
            self.line(&format!("GOTO {label}:"));
        } else {
            let condition = self.condition();
            self.line(&format!("IF {condition} GOTO {label}:"));
        }
        self.scalar_equation();
        self.line(&format!("{label}:"));
    }

    /// A loop over LOOP, entered by whatever is above it.
    fn jump_back(&mut self) {
        let (counter, rounds) = (self.counter(), 1 + self.random.below(3));
        self.line(&format!("{counter} = 0"));
        self.line("LOOP:");
        self.line(&format!("{counter} += 1"));
        self.scalar_equation();
        let jump = self.pick(&["GOTO", "GOTO LOOP:"]);
        self.line(&format!("IF {counter} < {rounds} {jump}"));
    }

    /// A subroutine by label, in the middle of what it is called from.
    fn gosub_label(&mut self) {
        let (label, behind) = (self.label(), self.label());
        self.line(&format!("GOSUB {label}:"));
        self.line(&format!("GOTO {behind}:"));
        self.line(&format!("{label}:"));
        self.scalar_equation();
        self.line("RETURN");
        self.line(&format!("{behind}:"));
    }

    /// A call of a subroutine below; in wild programs also one that calls itself.
    fn call(&mut self) {
        if self.subroutines == 0 || (self.in_subroutine && self.is_calm()) {
            return self.robot_command();
        }
        let name = format!("SUB{}:", self.random.below(self.subroutines));
        match self.random.below(3) {
            0 => self.line(&format!("CALL {name}")),
            1 => self.line(&format!("GOSUB {name}")),
            _ => {
                let condition = self.condition();
                self.line(&format!("IF {condition} GOSUB {name}"));
            }
        }
    }

    /// Writes a statement that ends a program early, and is therefore rare.
    fn rarity(&mut self) {
        let condition = self.condition();
        let wild: &[&str] = match self.is_later() {
            false => &["RETURN", "EXIT", "D = SQRT -1", "B = ASIN 2", "C = 1 / 0"],
            true => &[
                "RETURN",
                "EXIT",
                "D = SQRT BAD",
                "B = ASIN BAD",
                "C = 1 / BAD",
            ],
        };
        let line = match self.is_calm() {
            true => "REM nothing happens",
            false => self.pick(wild),
        };
        self.line(&format!("IF {condition} THEN"));
        self.line(line);
        self.line("ENDIF");
    }
}
