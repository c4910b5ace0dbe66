//! Motion programs of any length: an endless loop that calls subroutines, with the mixture of statements
//! that walking programs have.

use std::fmt::Write;

/// Steps of a subroutine, its CALL included.
const SUBROUTINE: usize = 45;

/// The text of a program of `steps` steps, at least 100.
pub fn program(steps: usize) -> String {
    // The first values, LOOP:, GOTO and END.
    let frame = FIRST_VALUES.len() + 3;
    let calls = (steps - frame).div_ceil(SUBROUTINE);
    let mut left = steps - frame;
    let mut main = String::new();
    let mut subroutines = String::new();
    let mut dice = Dice(7);
    for n in 1..=calls {
        let size = left / (calls + 1 - n);
        left -= size;
        writeln!(main, "  CALL S{n}:").expect("a string");
        writeln!(subroutines, "SUBROUTINE S{n}:").expect("a string");
        // CALL, SUBROUTINE and SUBEND are steps too.
        body(&mut subroutines, &mut dice, size - 3);
        subroutines.push_str("SUBEND\n");
    }
    let first = FIRST_VALUES.join("\n");
    format!(
        "3.1\nA generated motion of {steps} steps\n{DECLARATIONS}{first}\nLOOP:\n{main}  GOTO\n{subroutines}END\n"
    )
}

const DECLARATIONS: &str = "DEF_VAR V, B, C, N\nDEF_POS P, Q\n";

const FIRST_VALUES: &[&str] = &[
    "V = 10",
    "B = -20.5",
    "C = 0",
    "P.X = -391",
    "P.Y = 201",
    "P.Z = -200",
    "Q.X = 0.25",
    "Q.Y = -0.5",
    "Q.Z = 0.125",
];

fn body(text: &mut String, dice: &mut Dice, mut steps: usize) {
    while steps > 0 {
        steps -= match dice.below(10) {
            0 if steps >= 3 => {
                let (bound, inner) = (dice.below(40), simple(dice));
                line(text, &format!("IF V > {bound} THEN"));
                line(text, &inner);
                line(text, "ENDIF");
                3
            }
            1 if steps >= 4 => {
                line(text, "FOR N = 1 TO 2");
                line(text, &simple(dice));
                line(text, &simple(dice));
                line(text, "NEXT N");
                4
            }
            _ => {
                line(text, &simple(dice));
                1
            }
        }
    }
}

/// A statement without others inside. Variables stay within bounds for a billion cycles.
fn simple(dice: &mut Dice) -> String {
    let (leg, number) = (1 + dice.below(4), dice.below(50));
    match dice.below(12) {
        0 | 1 => format!("PTP F{leg} P.X C B"),
        2 | 3 => format!("PTP F{leg} P"),
        4 => format!("REL_PTP F{leg} 0 0 {number}"),
        5 | 6 => format!("WAIT_INPOS F{leg}"),
        7 => format!("SLEEP {number}"),
        8 => format!("SET_V_MAX F{leg} V"),
        9 => format!("V = B + {number}"),
        10 => "P += Q".to_owned(),
        _ => format!("C = V - {number}"),
    }
}

fn line(text: &mut String, statement: &str) {
    writeln!(text, "  {statement}").expect("a string");
}

/// Knuth's 64-bit linear congruential generator (MMIX); its high bits.
struct Dice(u64);

impl Dice {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }
}
