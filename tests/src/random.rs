//! Random motion programs of fixed seeds: valid by construction, with everything that sequences steps.

use std::fmt::Write as _;

/// How many programs are compiled and run.
pub const PROGRAMS: u64 = 200;

/// The keys typed during the run of a program: enough of them, at uneven times.
pub fn keys(seed: u64) -> Vec<(u64, u8)> {
    let mut dice = Dice(seed ^ 0x6b65_7973);
    (0..40)
        .map(|n| (n * 25 + dice.below(25), b'a' + dice.below(26) as u8))
        .collect()
}

/// A motion program for TITAN VIII.
pub fn program(seed: u64) -> String {
    let mut writer = Writer {
        dice: Dice(seed),
        text: format!("3.1\nrandom program {seed}\n"),
        labels: 0,
        depth: 0,
        subroutines: 1 + seed % 3,
        in_subroutine: false,
    };
    writer.declarations();
    for _ in 0..4 {
        writer.block();
    }
    writer.line("EXIT");
    writer.in_subroutine = true;
    for n in 0..writer.subroutines {
        writer.subroutine(n);
    }
    writer.line("END");
    writer.text
}

const VARS: &[&str] = &["A", "B", "C", "D", "VAR_KEY"];
const SCALARS: &[&str] = &["A", "B", "C", "D", "P.X", "P.Y", "Q.Z", "S.J1", "T.J3"];
const CONSTANTS: &[&str] = &[
    "0",
    "1",
    "2.5",
    "-3",
    ".5",
    "7.",
    "90",
    "-0.125",
    "1E2",
    "0.3333333333333333",
];
const FUNCTIONS: &[&str] = &[
    "INT", "ABS", "SIN", "COS", "TAN", "DEG2RAD", "RAD2DEG", "INT", "ABS", "SQRT", "ASIN", "ACOS",
    "ATAN",
];
const FLAGS: &[&str] = &[
    "HALT_REQUEST",
    "KB_HIT",
    "INPOS_ALL",
    "INPOS_F2",
    "NEAR_J11",
    "SPECIAL_FLAG3",
];
/// Feet with places near their initial ones.
const FEET: &[(&str, &str)] = &[
    ("F1", "-391 201"),
    ("F2", "391 201"),
    ("F3", "-391 -201"),
    ("F4", "391 -201"),
];

struct Writer {
    dice: Dice,
    text: String,
    labels: u32,
    depth: u32,
    subroutines: u64,
    in_subroutine: bool,
}

impl Writer {
    fn line(&mut self, line: &str) {
        let indent = self.depth as usize * 2;
        writeln!(self.text, "{:indent$}{line}", "").expect("writing to a string");
    }

    /// Variables and their first values; one is now and then left for later.
    fn declarations(&mut self) {
        self.line("DEF_VAR A B C D");
        self.line("DEF_POS P, Q");
        self.line("DEF_JOINT S T");
        let members = [
            "P.X", "P.Y", "P.Z", "Q.X", "Q.Y", "Q.Z", "S.J1", "S.J2", "S.J3", "T.J1", "T.J2",
            "T.J3",
        ];
        let late = self.dice.below(40) as usize;
        for (n, name) in ["VAR_KEY", "A", "B", "C", "D"]
            .iter()
            .chain(&members)
            .enumerate()
        {
            let value = self.constant();
            if n == late {
                self.line("IF KB_HIT THEN");
                self.line(&format!("{name} = {value}"));
                self.line("ENDIF");
            } else {
                self.line(&format!("{name} = {value}"));
            }
        }
    }

    /// Some statements.
    fn block(&mut self) {
        for _ in 0..1 + self.dice.below(4) {
            self.statement();
        }
    }

    fn nested(&mut self) {
        self.depth += 1;
        self.block();
        self.depth -= 1;
    }

    fn statement(&mut self) {
        let kinds = if self.depth < 2 { 20 } else { 12 };
        match self.dice.below(kinds) {
            0..=4 => self.scalar_equation(),
            5..=6 => self.struct_equation(),
            7..=9 => self.command(),
            10 => self.message(),
            11 => self.jump_ahead(),
            12..=14 => self.branches(),
            15 => self.bounded_while(),
            16 => self.bounded_repeat(),
            17 => self.counted_for(),
            18 => self.call(),
            _ => self.jump_back(),
        }
    }

    fn scalar_equation(&mut self) {
        let target = self.dice.pick(SCALARS);
        let update = self.dice.pick(&["=", "=", "=", "+=", "-=", "*="]);
        let (a, b) = (self.operand(), self.operand());
        let value = match self.dice.below(12) {
            0..=2 => a,
            3..=7 => format!("{a} {} {b}", self.dice.pick(&["+", "-", "*", "-", "+"])),
            8 => format!("{a} / {}", self.dice.pick(&["2", "-4", "B", "0.1"])),
            9 => format!("{} {a}", self.dice.pick(FUNCTIONS)),
            10 => format!("ATAN2 {a} {b}"),
            _ => format!("NORM {}", self.dice.pick(&["P", "Q", "S", "T"])),
        };
        self.line(&format!("{target} {update} {value}"));
    }

    fn struct_equation(&mut self) {
        let [a, b, c] = self.dice.pick(&[
            ["P", "Q", "P"],
            ["Q", "P", "P"],
            ["S", "T", "S"],
            ["T", "S", "T"],
        ]);
        let update = self.dice.pick(&["=", "=", "+=", "-="]);
        let value = match self.dice.below(5) {
            0 => b.to_owned(),
            1 | 2 => format!("{b} {} {c}", self.dice.pick(&["+", "-", "*"])),
            3 if a == "P" => format!("UNIT_VECT {b}"),
            _ if a == "P" || a == "Q" => {
                let axis = self.dice.pick(&["ROT_X", "ROT_Y", "ROT_Z"]);
                format!("{axis} {b} {}", self.dice.pick(&["A", "30", "-45", "C"]))
            }
            _ => format!("{b} - {c}"),
        };
        self.line(&format!("{a} {update} {value}"));
    }

    fn command(&mut self) {
        let (foot, place) = self.dice.pick(FEET);
        let var = self.dice.pick(VARS);
        let line = match self.dice.below(16) {
            0..=2 => format!(
                "PTP {foot} {place} {}",
                self.dice.pick(&["-200", "-195", "-190"])
            ),
            3 => format!("PTP HS {foot} R 0 R 2 A -200"),
            4 => format!("REL_PTP {foot} 0 {} 0", self.dice.pick(&["1", "-1", "0"])),
            5 => format!("WAIT_INPOS {}", self.dice.pick(&[foot, "ALL", "J11"])),
            6 => format!("SLEEP {}", self.dice.pick(&["20", "50", "0"])),
            7 => format!("TEACH_POSITION {foot} {}", self.dice.pick(&["P", "Q"])),
            8 => format!("TEACH_ANGLE {foot} {}", self.dice.pick(&["S", "T"])),
            9 => format!("TEACH_ANGLE J32 {var}"),
            10 => format!("AD_IN VR1 {var}"),
            11 => format!("KEY_IN {var}"),
            12 => format!(
                "{} {}",
                self.dice.pick(&["LAMP_ON", "LAMP_OFF"]),
                self.dice.pick(&["0", "3", "7"])
            ),
            13 => format!(
                "SET_V_MAX {} {}",
                self.dice.pick(&[foot, "ALL"]),
                self.dice.pick(&["200", "400"])
            ),
            14 => self
                .dice
                .pick(&[
                    "ALL_STOP",
                    "ALL_STOP_RELEASE",
                    "FLUSH_BUF",
                    "REM a remark",
                    "KEY_IN",
                    "EMG_ON",
                ])
                .to_owned(),
            _ => format!(
                "PTP_ANGLE J{} {}",
                self.dice.pick(&["11", "31"]),
                self.dice.pick(&["0", "R 1", "R -1"])
            ),
        };
        self.line(&line);
    }

    fn message(&mut self) {
        let line = match self.dice.below(4) {
            0 => "MESSAGE".to_owned(),
            1 => "MESSAGE {braces} 100% \"quoted\" \\a".to_owned(),
            2 => format!(
                "MESSAGE {} is %{}%",
                self.dice.below(10),
                self.dice.pick(VARS)
            ),
            _ => format!("MESSAGE %a.3% and %{}.0%", self.dice.pick(VARS)),
        };
        self.line(&line);
    }

    /// A jump over some statements.
    fn jump_ahead(&mut self) {
        let label = self.label();
        let jump = if self.dice.below(3) == 0 {
            format!("GOTO {label}:")
        } else {
            format!("IF {} GOTO {label}:", self.condition())
        };
        self.line(&jump);
        self.scalar_equation();
        self.line(&format!("{label}:"));
    }

    /// A loop over LOOP that a key or a growing variable ends.
    fn jump_back(&mut self) {
        self.line("D = 0");
        self.line("LOOP:");
        self.line("D += 1");
        self.scalar_equation();
        let rounds = 1 + self.dice.below(3);
        self.line(&format!("IF D < {rounds} GOTO"));
    }

    fn branches(&mut self) {
        let first = self.condition();
        self.line(&format!("IF {first} THEN"));
        self.nested();
        for _ in 0..self.dice.below(3) {
            let other = self.condition();
            self.line(&format!("ELSEIF {other} THEN"));
            self.nested();
        }
        if self.dice.below(2) == 0 {
            self.line("ELSE");
            self.nested();
        }
        self.line("ENDIF");
    }

    fn bounded_while(&mut self) {
        self.line("C = 0");
        let rounds = self.dice.below(4);
        self.line(&format!("WHILE C < {rounds}"));
        self.line("C += 1");
        self.nested();
        self.line("WEND");
    }

    fn bounded_repeat(&mut self) {
        self.line("REPEAT");
        self.nested();
        let leaves = self.condition();
        self.line(&format!("UNTIL {leaves}"));
    }

    fn counted_for(&mut self) {
        let var = self.dice.pick(&["A", "B", "C"]);
        let head = match self.dice.below(4) {
            0 => format!("FOR {var} = 1 TO {}", 1 + self.dice.below(4)),
            1 => format!(
                "FOR {var} = 3 TO {} STEP -1.5",
                self.dice.pick(&["0", "-1", "4"])
            ),
            2 => format!("FOR {var} = {} TO D", self.operand()),
            _ => format!(
                "FOR {var} = P.X TO Q.Z STEP {}",
                self.dice.pick(&["10", "T.J3", "-7"])
            ),
        };
        self.line(&head);
        self.nested();
        let next = if self.dice.below(2) == 0 {
            format!("NEXT {var}")
        } else {
            "NEXT".to_owned()
        };
        self.line(&next);
    }

    fn call(&mut self) {
        let n = self.dice.below(self.subroutines);
        let condition = self.condition();
        let line = match self.dice.below(5) {
            // Calls among subroutines may recurse: too deep is one of the ends worth testing.
            _ if self.in_subroutine && self.dice.below(3) > 0 => "REM no call".to_owned(),
            0 => format!("IF {condition} GOSUB SUB{n}:"),
            1 => format!("GOSUB SUB{n}:"),
            _ => format!("CALL SUB{n}:"),
        };
        self.line(&line);
    }

    fn subroutine(&mut self, n: u64) {
        self.line(&format!("SUBROUTINE SUB{n}:"));
        self.nested();
        if self.dice.below(2) == 0 {
            let condition = self.condition();
            self.line(&format!("IF {condition} THEN"));
            self.line("RETURN");
            self.line("ENDIF");
        }
        self.scalar_equation();
        self.line("SUBEND");
    }

    fn condition(&mut self) -> String {
        if self.dice.below(3) == 0 {
            let not = self.dice.pick(&["", "!"]);
            format!("{not}{}", self.dice.pick(FLAGS))
        } else {
            let (a, b) = (self.operand(), self.operand());
            format!(
                "{a} {} {b}",
                self.dice.pick(&["==", "<>", "<", ">", "<=", ">="])
            )
        }
    }

    fn operand(&mut self) -> String {
        match self.dice.below(5) {
            0 | 1 => self.constant().to_owned(),
            2 => format!("-{}", self.dice.pick(SCALARS)),
            _ => self.dice.pick(SCALARS).to_owned(),
        }
    }

    fn constant(&mut self) -> &'static str {
        self.dice.pick(CONSTANTS)
    }

    fn label(&mut self) -> String {
        self.labels += 1;
        format!("L{}", self.labels)
    }
}

/// SplitMix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, 2014).
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: u64) -> u64 {
        self.roll() % n
    }

    fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len() as u64) as usize]
    }
}
