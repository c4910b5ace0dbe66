//! Programs of fixed seeds, of everything that decides what is assigned.

use std::fmt::Write as _;

/// Returns a program whose every branch is open.
pub(super) fn program(seed: u64) -> String {
    let mut writer = Writer {
        dice: seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1,
        text: "3.1\nrandom\nDEF_VAR A B I N\nDEF_POS P\n".to_owned(),
        labels: 0,
        depth: 0,
    };
    writer.block();
    writer.block();
    writer.line("LAST: EXIT");
    for routine in ["R1:", "R2:"] {
        writer.line(routine);
        writer.block();
        writer.line("RETURN");
    }
    // No run comes here; it makes the program load.
    writer.line("A = 1; B = 2; I = 3; N = 4; P.X = 5; KEY_IN");
    writer.line("END");
    writer.text
}

struct Writer {
    dice: u64,
    text: String,
    labels: u32,
    depth: u32,
}

impl Writer {
    fn below(&mut self, bound: u64) -> u64 {
        self.dice ^= self.dice << 13;
        self.dice ^= self.dice >> 7;
        self.dice ^= self.dice << 17;
        (self.dice >> 20) % bound
    }

    fn line(&mut self, line: &str) {
        writeln!(self.text, "{line}").expect("writing to a string");
    }

    fn block(&mut self) {
        for _ in 0..1 + self.below(3) {
            self.statement();
        }
    }

    fn nested(&mut self) {
        self.depth += 1;
        self.block();
        self.depth -= 1;
    }

    fn statement(&mut self) {
        let kinds = if self.depth < 3 { 22 } else { 14 };
        match self.below(kinds) {
            0 => self.line("A = B"),
            1 => self.line("B = 1"),
            2 => self.line("A += 1"),
            3 => self.line("A = N"),
            4 => self.line("N = 2"),
            5 => self.line("P.Y = P.X"),
            6 => self.line("TEACH_POSITION F1 P"),
            7 => self.line("P = P + P"),
            8 => self.line("KEY_IN"),
            9 => self.line("MESSAGE %VAR_KEY%"),
            10 => self.line("IF KB_HIT GOSUB R1:"),
            11 => self.line("GOSUB R2:"),
            12 => self.line("IF A > 1 GOSUB R2:"),
            13 => {
                self.labels += 1;
                let label = self.labels;
                self.line(&format!("IF KB_HIT GOTO L{label}:"));
                self.line("P.X = 2");
                self.line(&format!("L{label}:"));
            }
            14..=16 => {
                self.line("IF KB_HIT THEN");
                self.nested();
                if self.below(2) == 0 {
                    self.line("ELSEIF B > 1 THEN");
                    self.nested();
                }
                if self.below(2) == 0 {
                    self.line("ELSE");
                    self.nested();
                }
                self.line("ENDIF");
            }
            17 => {
                self.line("WHILE N > 3");
                self.nested();
                self.line("WEND");
            }
            18 => {
                self.line("REPEAT");
                self.nested();
                self.line("UNTIL KB_HIT");
            }
            19 => {
                self.line("FOR I = A TO N");
                self.nested();
                self.line("NEXT");
            }
            20 => {
                self.labels += 1;
                let label = self.labels;
                self.line(&format!("L{label}:"));
                self.nested();
                self.line(&format!("IF HALT_REQUEST GOTO L{label}:"));
            }
            _ => self.line("IF KB_HIT GOTO LAST:"),
        }
    }
}
