//! The units of programs, taken from the tables of the language: every statement in each of its forms, right and wrong, every
//! label, declaration, operand, condition and placeholder. A new word of the tables is a unit without further ado.

use std::collections::BTreeSet;
use tip_ide::snippet;
use tipc::Robot;
use tipc::language::commands::COMMANDS;
use tipc::language::flags::FLAGS;
use tipc::language::functions::FUNCTIONS;
use tipc::language::reserved::RESERVED;
use tipc::language::{Edition, inputs::INPUTS};

/// Declarations and labels that units name.
pub const HEAD: &str = "DEF_VAR V\nDEF_POS P\nDEF_JOINT Q\nV = 1\nP.X = V\nP.Y = V\nP.Z = V\n\
    Q.J1 = V\nQ.J2 = V\nQ.J3 = V\nL:\n";

/// Statements of every form, right and wrong, also those that no table has. `{n}` is the number of the repetition, `{m}` another number below the count, `{t}` the number of
/// the next one.
pub const FORMS: &[&str] = &[
    "PTP F1 1 V C{n}",
    "PTP F1 391 201 -150\nWAIT_INPOS ALL",
    "SET_POSITION_STIFFNESS F1 P",
    "TEACH_POS F1 P\nAD_IN 0 1 V\nKEY_IN V",
    "SPECIAL 1 V V",
    "V = SIN V\nP = UNIT_VECT P",
    "IF V > -1 GOTO L:",
    "MESSAGE text",
    "THREAD T{n}:\nTHREADEND",
    "L{n}:",
    "L{n}: REM",
    "L{n}: L{n}X: REM",
    "LOOP: IF KB_HIT GOTO",
    "L{n}: REM\nIF KB_HIT GOTO L{m}:",
    "L{n}:\nIF V > 1 GOSUB L{m}:",
    "GOTO L{n}:\nL{n}:",
    "GOTO NOWHERE{n}:",
    "GOTO L",
    "DEF_VAR V{n}",
    "DEF_POS P{n}\nP{n}.X = {n}",
    "DEF_JOINT Q{n}\nQ{n}.J1 = Q{n}.J2",
    "DEF_VAR V{n}\nV{n} = {n}\nSLEEP V{n}",
    "DEF_VAR V{n}\nIF KB_HIT THEN\nV{n} = 1\nENDIF\nSLEEP V{n}",
    "DEFINE C{n} {n}",
    "DEFINE C{n} {n}\nSLEEP C{n}",
    "DEFINE C{n} C{m}",
    "DEFINE V {n}",
    "SLEEP UNKNOWN{n}",
    "V{n} = 1",
    "FOR V = 0.5 TO 999999.7 STEP 1.1\nNEXT",
    "FOR V = 0.5 TO 999{n}.7 STEP 0.1\nNEXT",
    "FOR V = 1 TO 3",
    "IF KB_HIT THEN",
    "WHILE KB_HIT",
    "REPEAT",
    "SUBROUTINE S{n}:",
    "IF KB_HIT THEN\nELSEIF V > 1 THEN\nELSE",
    "CALL S{n}:\nSUBROUTINE S{n}:\nCALL S{t}:\nSUBEND",
    "MESSAGE %V% %V.2% %P% %P.X% %NONE% 50%",
    "MESSAGE %V{n}%",
    "MESSAGE \\t\\x %",
    "SLEEP 20 // tip: allow(W112)",
    "// a comment",
    "\u{6B69}\u{304F}",
    "\u{FF33}\u{FF2C}\u{FF25}\u{FF25}\u{FF30}",
    "PTP F1 1,5 2,5 3,5",
    "PTP(F1, 1, 2, 3)",
    "V = V + V + V",
    "V = (V + 1)",
    "V == 1",
    "V ++",
    "A B C",
];

/// Pieces that are repeated without anything between them, on one line.
pub const PIECES: &[&str] = &[
    "A_",
    "_",
    "A",
    "A.",
    ".",
    "A:",
    "A\u{FF1A}",
    ":",
    "\u{FF1A}",
    ";",
    ";;A",
    "V=",
    "=",
    "==",
    "<",
    "!",
    "-",
    "+",
    "*",
    "/",
    "//",
    "(",
    ")",
    "{",
    "}",
    "[",
    "\"",
    "'",
    "%",
    "%V%",
    "%V.",
    "\\",
    "\\a",
    "\u{A5}",
    "0",
    "1.",
    "1e",
    "9E+",
    ",",
    "\t",
    " ",
    "\u{3000}",
    "\u{6B69}",
    "\u{FF21}",
    "\u{FF21}_",
    "\u{FF11}",
    "\u{FF71}",
    "@",
    "@POS_F1",
    "#",
    "&&",
    "||",
    "~",
    "^",
    "A(",
    "A[",
    "A,",
    "A;",
    "V-",
    "-V",
    "DEF_VAR A ",
    "DEF_VAR A;",
    "DEFINE A 1 ",
    "DEFINE A ",
    "LOOP:",
    "IF ",
    "IF V ",
    "IF V THEN ",
    "ELSE ",
    "ENDIF ",
    "END_",
    "THEN ",
    "GOTO ",
    "GOTO L: ",
    "GOSUB L:",
    "MESSAGE ",
    "MESSAGE;",
    "REM ",
    "REM;",
    "FOR V = ",
    "TO ",
    "NEXT ",
    "WHILE ",
    "PTP ",
    "PTP_",
    "F1 ",
    "J11 ",
    "R ",
    "HS ",
    "STOP ",
    "SUBROUTINE S: ",
    "THREAD T: ",
    "CALL S: ",
];

/// Returns the statements of an edition: those that its tables hold in each form, and others.
pub fn statements(edition: Edition) -> Vec<String> {
    let mut all = BTreeSet::new();
    for row in COMMANDS.iter().filter(|row| row.since <= edition) {
        let robot = Robot::ALL.iter().find(|robot| row.robots.contains(**robot));
        let Some(robot) = robot.copied() else {
            continue;
        };
        let forms = row.usage(robot, edition);
        // In range, out of it, and of the wrong type.
        all.extend(forms.iter().map(|form| filled(form, "1")));
        all.extend(forms.last().map(|form| filled(form, "-1")));
        all.extend(forms.first().map(|form| filled(form, "P")));
        let block = snippet(row, robot, edition).replace("\n\t$0", "\nREM");
        let block = block.replace("${", "").replace('}', "");
        all.insert(filled(&block, "V"));
        // What it needs is missing, there is too much, and the word is another one.
        all.insert(row.name.to_owned());
        all.insert(format!("{0} {0} X Y Z", row.name));
        all.insert(format!("{}X", row.name));
    }
    for row in FUNCTIONS.iter().filter(|row| row.since <= edition) {
        all.insert(format!("V = {} V", row.word));
        all.insert(format!("P = {} P V", row.word));
    }
    for row in FLAGS.iter().filter(|row| row.since <= edition) {
        all.insert(format!("IF !{} THEN\nENDIF", row.flag));
        all.insert(format!("WHILE {} > V\nWEND", row.flag));
    }
    for row in RESERVED.iter().filter(|row| row.since <= edition) {
        all.insert(format!("DEF_VAR {}", row.word));
        all.insert(format!("V = {}", row.word));
        all.insert(format!("MESSAGE %{}%", row.word));
    }
    for row in INPUTS.iter().filter(|row| row.since <= edition) {
        all.insert(format!("AD_IN {} V", row.port));
    }
    for relation in ["==", "<>", "<", ">", "<=", ">="] {
        all.insert(format!("IF V {relation} -V GOTO L:"));
    }
    all.extend(FORMS.iter().map(|it| (*it).to_owned()));
    all.into_iter().collect()
}

/// Returns a form with its places filled: numbers by `number`, names by the number of the repetition.
fn filled(form: &str, number: &str) -> String {
    let lines = form.lines().map(|line| {
        let words = line.split(' ').map(|word| {
            let word = word.trim_start_matches('[').trim_end_matches(']');
            let word = match word.split_once(':') {
                Some((place, word)) if place.parse::<u8>().is_ok() => word,
                _ => word,
            };
            let word = word.trim_start_matches(|it: char| it.is_ascii_digit() || it == '|');
            let word = word.split(['|', ',']).next().unwrap_or_default();
            match word {
                "" | "number" | "x" | "y" | "z" | "low" | "high" | "constant" => number.to_owned(),
                "POS" => "P".to_owned(),
                "JOINT" => "Q".to_owned(),
                "VAR" => "V".to_owned(),
                "name" => "N{n}".to_owned(),
                "name:" | "NAME:" => "N{n}:".to_owned(),
                "label:" | "LABEL:" => "L:".to_owned(),
                "condition" => "KB_HIT".to_owned(),
                "\u{2026}255" => "1".to_owned(),
                word if word
                    .strip_prefix('j')
                    .is_some_and(|it| it.parse::<u8>().is_ok()) =>
                {
                    number.to_owned()
                }
                word => word.to_owned(),
            }
        });
        words.collect::<Vec<_>>().join(" ")
    });
    lines.collect::<Vec<_>>().join("\n")
}
