//! Whatever the bytes: no panic, places inside the text, a program exactly when nothing is wrong, however long.
//! `TIP_DAMAGED=100000` before a run in release mode damages so many programs.

use robustness::fix;
use robustness::load::examine;
use std::path::{Path, PathBuf};
use std::{env, fs, thread};
use tip_runtime::random::Random;
use tipc::Options;

const WORDS: &[&str] = &[
    "A",
    "B",
    "P",
    "Q",
    "R",
    "HS",
    "P.X",
    "Q.J2",
    "-A",
    "-P",
    "1",
    "-2.5",
    "1E3",
    "F1",
    "F4",
    "J11",
    "J43",
    "ALL",
    "FLOOR",
    "PTP",
    "REL_PTP",
    "PTP_ANGLE",
    "FORCE",
    "SLEEP",
    "WAIT_INPOS",
    "TEACH_ANGLE",
    "SET_JUST_ANGLE",
    "SET_POSITION_STIFFNESS",
    "AD_IN",
    "VR1",
    "KEY_IN",
    "SPECIAL",
    "MESSAGE %A.2% \\a",
    "REM x",
    "DEF_VAR",
    "DEF_POS",
    "DEF_JOINT",
    "IF",
    "THEN",
    "ELSEIF",
    "ELSE",
    "ENDIF",
    "WHILE",
    "WEND",
    "REPEAT",
    "UNTIL",
    "FOR",
    "TO",
    "STEP",
    "NEXT",
    "GOTO",
    "GOSUB",
    "CALL",
    "RETURN",
    "SUBROUTINE",
    "SUBEND",
    "L1:",
    "L2:",
    "LOOP:",
    "S1:",
    "KB_HIT",
    "!KB_HIT",
    "INPOS_F1",
    "=",
    "+=",
    "==",
    "<",
    ">=",
    "+",
    "*",
    "SIN",
    "ATAN2",
    "NORM",
    "UNIT_VECT",
    "ROT_X",
    "END",
    "EXIT",
    ";",
    ",",
    "//",
    "\u{3000}",
    "Ａ",
    "ｱ",
    "\u{A5}",
    ":",
    "!",
    "CHAR_A",
    "VAR_KEY",
    "OUTPUT_VARIABLES",
];

// clauses: 8.1
#[test]
fn random_words() {
    let mut random = Random::new(0x5EED_0001);
    for _ in 0..600 {
        let mut text = String::from("3.1\nrandom\nDEF_VAR A B\nDEF_POS P\nDEF_JOINT Q\n");
        for _ in 0..random.index(30) {
            for _ in 0..=random.index(6) {
                text.push_str(pick(&mut random, WORDS));
                text.push_str(pick(&mut random, &[" ", " ", " ", "", "\t"]));
            }
            text.push_str(pick(&mut random, &["\n", "\n", "\n", "\r\n", " ; "]));
        }
        text.push_str("END\n");
        examine(text.as_bytes());
    }
}

/// Statements that are right alone, in an order that is not.
const STATEMENTS: &[&str] = &[
    "A = B + 1",
    "P = P - P",
    "Q.J1 += A",
    "IF A > 1 THEN",
    "ELSEIF KB_HIT THEN",
    "ELSE",
    "ENDIF",
    "WHILE A < B",
    "WEND",
    "REPEAT",
    "UNTIL INPOS_ALL",
    "FOR A = 1 TO B",
    "NEXT A",
    "NEXT",
    "SUBROUTINE S1:",
    "SUBROUTINE S2:",
    "SUBEND",
    "CALL S1:",
    "GOSUB S2:",
    "GOTO L1:",
    "IF KB_HIT GOTO L2:",
    "IF KB_HIT GOTO",
    "GOSUB L1:",
    "L1:",
    "L2:",
    "LOOP:",
    "GOTO",
    "RETURN",
    "EXIT",
    "PTP F1 P",
    "MESSAGE %A%",
    "SLEEP A",
];

// clauses: 6.5
#[test]
fn random_order() {
    let mut random = Random::new(0x5EED_0002);
    for _ in 0..1500 {
        let mut text = String::from("3.1\norder\nDEF_VAR A B\nDEF_POS P\nDEF_JOINT Q\nB = 1\n");
        for _ in 0..random.index(25) {
            text.push_str(pick(&mut random, STATEMENTS));
            text.push('\n');
        }
        text.push_str("END\n");
        examine(text.as_bytes());
    }
}

fn cases(folder: &Path, found: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else {
        return; // The package alone has no cases.
    };
    for entry in entries {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            cases(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "prg") {
            found.push(path);
        }
    }
}

// clauses: 1.1 8.1
#[test]
fn mutated_programs() {
    try_each(&damaged("../../language/cases", 3, 0x5EED_0003), examine);
}

// clauses: 8.1
#[test]
fn mutated_programs_are_put_right() {
    try_each(
        &damaged("../../../tools/lint/tests/diagnostics", 1, 0x5EED_0004),
        fix::examine,
    );
}

/// The programs in a folder, and so many damaged ones of each, or as many in all as are asked for.
fn damaged(folder: &str, each: usize, seed: u64) -> Vec<Vec<u8>> {
    let mut random = Random::new(seed);
    let mut paths = Vec::new();
    cases(
        &PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(folder),
        &mut paths,
    );
    paths.sort();
    let asked = env::var("TIP_DAMAGED").ok();
    let asked = asked.map(|count| count.parse::<usize>().expect("a number"));
    let each = asked.map_or(each, |count| count.div_ceil(paths.len().max(1)));
    let mut texts = Vec::new();
    for path in paths {
        let bytes = fs::read(&path).expect("a readable case");
        if bytes.len() > 4000 {
            continue;
        }
        texts.extend((0..each).map(|_| mutated(&bytes, &mut random)));
        texts.push(bytes);
    }
    texts
}

fn try_each(texts: &[Vec<u8>], examine: fn(&[u8])) {
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let share = texts.len().div_ceil(threads).max(1);
    thread::scope(|scope| {
        for texts in texts.chunks(share) {
            scope.spawn(|| texts.iter().for_each(|text| examine(text)));
        }
    });
}

fn pick<'a>(random: &mut Random, words: &[&'a str]) -> &'a str {
    words[random.index(words.len())]
}

/// The text after its version line with some bytes lost, doubled or replaced.
fn mutated(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    let mut changed = bytes.to_vec();
    for _ in 0..=random.index(4) {
        if changed.len() < 6 {
            return changed;
        }
        let at = 4 + random.index(changed.len() - 4);
        match random.index(4) {
            0 => {
                changed.remove(at);
            }
            1 => changed.insert(at, changed[at]),
            2 => changed[at] = b"A1.-+=:;, \n\t%\\/<!\x81\xE3\x00"[random.index(20)],
            _ => {
                let word = pick(random, WORDS).as_bytes();
                changed.splice(at..at, word.iter().copied());
            }
        }
    }
    changed
}

/// Lines of a long program. `benches/compiler` measures growth with the length.
const LONG: usize = 20_000;

fn lines(count: usize, line: impl Fn(usize) -> String) -> String {
    let body: String = (0..count).map(|n| line(n) + "\n").collect();
    format!("3.1\nlong\nDEF_VAR A\nA = 1\n{body}END\n")
}

fn nested(open: &str, close: &str, times: usize) -> String {
    let (open, close) = (open.repeat(times), close.repeat(times));
    format!("3.1\nlong\n{open}{close}END\n")
}

// clauses: 8.1
#[test]
fn long_programs_load() {
    let label_pairs = |n| format!("L{n}:\nGOTO L{}:", LONG / 2 - 1 - n);
    for (what, text) in [
        ("commands", lines(LONG, |_| "PTP F1 1 R 2 3".to_owned())),
        (
            "variables",
            lines(LONG / 2, |n| format!("DEF_VAR V{n}\nV{n} = A")),
        ),
        ("labels", lines(LONG / 2, label_pairs)),
        (
            "nested blocks",
            nested(
                "LOOP:\nIF KB_HIT THEN\nGOTO\nWHILE KB_HIT\n",
                "WEND\nENDIF\n",
                LONG / 8,
            ),
        ),
    ] {
        let loaded = tipc::load("long.prg", text.as_bytes(), &Options::default());
        assert!(loaded.program.is_some(), "{what}");
    }
}

// clauses: 8.1
#[test]
fn long_wrong_programs_are_refused() {
    for (what, text) in [
        ("unknown commands", lines(LONG, |n| format!("PTPX{n} 1"))),
        (
            "unknown variables",
            lines(LONG / 2, |n| format!("DEF_VAR V{n}\nA = W{n}")),
        ),
        (
            "unknown labels",
            lines(LONG / 2, |n| format!("L{n}:\nGOTO M{n}:")),
        ),
        ("one long line", nested("LOOP: ;", "\n", LONG)),
        ("stray closers", lines(LONG, |_| "ENDIF\nWEND".to_owned())),
        ("unclosed", lines(LONG, |_| "WHILE KB_HIT".to_owned())),
        (
            "crossing",
            nested("IF KB_HIT THEN\nWHILE KB_HIT\n", "ENDIF\nWEND\n", LONG / 4),
        ),
    ] {
        let loaded = tipc::load("long.prg", text.as_bytes(), &Options::default());
        assert!(loaded.program.is_none(), "{what}");
        assert!(!loaded.diagnostics.is_empty(), "{what}");
    }
}
