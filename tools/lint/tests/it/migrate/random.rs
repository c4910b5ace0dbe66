//! Whatever a file holds: no panic, a result that needs no second migration, and a kept order of lines.

use std::thread;
use tip_lint::migrate::migrate;
use tip_runtime::random::Random;
use tipc::source::Encoding;

/// Words that rules look at, and some that join or break them.
const WORDS: &[&str] = &[
    "VAR1",
    "VAR01",
    "var2",
    "POS1.X",
    "AGL02",
    "TRQ1.J1",
    "AGL",
    "=",
    "-",
    "- ",
    "+=",
    ",",
    " ",
    "  ",
    ";",
    ":",
    "//",
    "%",
    "%f01%",
    "%d1%",
    "%VAR1%",
    "REM",
    "MESSAGE",
    "message ",
    "WAIT_NEAR",
    "FOR",
    "TO",
    "NEXT",
    "STEP:",
    "GOTO ",
    "WEND :",
    "A_MAX",
    "T_MAX_SOFT",
    "SET_NEAR",
    "SET_INPOS ",
    "COMPLIANCE ",
    "PTP ",
    "PTP_ANGLE ",
    "F1 ",
    "J11 ",
    "ALL ",
    "5",
    "-2.5",
    "\u{3000}",
    "表",
    "ｱ",
    "DEF_VAR ",
    "IF KB_HIT GOTO ",
    "END",
    "\t",
];
const HEADERS: &[&str] = &["1.0", "1.1", "2.0", "2.1", "3.0", "4.0"];
const LINE_ENDS: &[&str] = &["\n", "\r\n", "\r"];

/// A generator of programs.
struct Programs(Random);

impl Programs {
    fn below(&mut self, limit: usize) -> usize {
        self.0.index(limit)
    }

    fn of<'a>(&mut self, words: &[&'a str]) -> &'a str {
        words[self.below(words.len())]
    }

    fn program(&mut self) -> String {
        let end = self.of(LINE_ENDS);
        let mut text = self.of(HEADERS).to_owned();
        for _ in 0..2 + self.below(6) {
            text += end;
            for _ in 0..self.below(7) {
                text += self.of(WORDS);
                text += ["", " "][self.below(2)];
            }
        }
        text + end + "END" + end
    }
}

// clauses: 10.1
#[test]
fn random_programs() {
    let decided: usize = thread::scope(|scope| {
        let running = [1, 2].map(|seed| scope.spawn(move || migrate_from(seed)));
        let each = running.into_iter();
        each.map(|one| one.join().expect("nothing is lost")).sum()
    });
    assert!(decided > 1000, "only {decided} programs were decided");
}

/// Migrates half of the programs; how many of them leave no question.
fn migrate_from(seed: u64) -> usize {
    let mut random = Programs(Random::new(seed));
    let mut decided = 0;
    for _ in 0..10_000 {
        let text = random.program();
        let (old, _, _) = encoding_rs::SHIFT_JIS.encode(&text);
        let utf8 = migrate("r.prg", text.as_bytes(), Encoding::Utf8).expect("this is text");
        let shift_jis = migrate("r.prg", &old, Encoding::ShiftJis).expect("this is text");
        assert_eq!(utf8.notes(), shift_jis.notes(), "{text:?}");
        assert_eq!(
            utf8.bytes().is_none(),
            utf8.questions().next().is_some(),
            "{text:?}"
        );
        let (Some(new), Some(other)) = (utf8.bytes(), shift_jis.bytes()) else {
            continue;
        };
        decided += 1;
        let new = std::str::from_utf8(new).expect("UTF-8 stays UTF-8");
        assert_eq!(encoding_rs::SHIFT_JIS.encode(new).0, other, "{text:?}");
        let again = migrate("r.prg", new.as_bytes(), Encoding::Utf8).expect("this is text");
        assert_eq!(again.notes(), [], "{text:?} became {new:?}");
        let added = new.lines().count() - text.lines().count();
        let kept = new.lines().skip(2 + added).count();
        assert_eq!(
            kept,
            text.lines().skip(2).count(),
            "{text:?} became {new:?}"
        );
    }
    decided
}
