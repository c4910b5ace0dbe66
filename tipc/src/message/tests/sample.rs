//! Arguments to try messages with.

use crate::language::keywords::KEYWORDS;
use crate::language::{Bilingual, Edition, Keyword};
use crate::message::list::{Alternatives, Both, Each, Faults, List, OneOf, Pieces, Quoted};
use crate::message::{Cut, Decimal, Letter, Message, Parsing, Text};
use smol_str::SmolStr;
use std::ops::Range;
use tip_runtime::command::Target;

/// Turns with arguments as programs have them. As many as the largest table of phrases has rows, for each turn takes
/// another row of it.
pub(crate) const PLAIN: usize = 8;

/// Turns with arguments that hardly any program has: nothing, very much, and signs that mean something to a formatter.
pub(crate) const ODD: Range<usize> = PLAIN..PLAIN + 3;

/// Possible argument of a message. A type without it cannot be one, since its table does not compile.
pub(crate) trait Sample: Sized {
    /// Returns the argument of a turn.
    fn sample(turn: usize) -> Self;
}

/// The plain one, or the odd one of a turn.
fn pick<T>(turn: usize, plain: T, odd: [T; ODD.end - ODD.start]) -> T {
    match turn.checked_sub(ODD.start) {
        Some(turn) => odd.into_iter().nth(turn).expect("an odd turn"),
        None => plain,
    }
}

impl Sample for String {
    fn sample(turn: usize) -> Self {
        let odd = [
            "".into(),
            "\u{6b69} ".repeat(1_000),
            "{}{0}{x:?}\n\0`\"".into(),
        ];
        pick(turn, "WORD".into(), odd)
    }
}

/// A word like the others in every turn: what it holds is cut elsewhere.
impl Sample for Text {
    fn sample(turn: usize) -> Self {
        Text(Cut::word(&String::sample(turn)).to_string())
    }
}

impl Sample for &'static str {
    fn sample(turn: usize) -> Self {
        String::sample(turn).leak()
    }
}

impl Sample for Bilingual {
    fn sample(turn: usize) -> Self {
        let text = Sample::sample(turn);
        Bilingual {
            english: text,
            japanese: text,
        }
    }
}

impl Sample for SmolStr {
    fn sample(turn: usize) -> Self {
        String::sample(turn).into()
    }
}

impl Sample for Edition {
    fn sample(turn: usize) -> Self {
        Edition::ALL[turn % Edition::ALL.len()]
    }
}

impl Sample for char {
    fn sample(turn: usize) -> Self {
        pick(turn, 'x', ['\0', '\u{10ffff}', '{'])
    }
}

impl Sample for u32 {
    fn sample(turn: usize) -> Self {
        pick(turn, 7, [0, u32::MAX, 1])
    }
}

impl Sample for usize {
    fn sample(turn: usize) -> Self {
        pick(turn, 7, [0, usize::MAX, 1])
    }
}

impl Sample for f64 {
    fn sample(turn: usize) -> Self {
        pick(turn, -7.5, [f64::NAN, f64::MIN, f64::INFINITY])
    }
}

impl Sample for Decimal {
    fn sample(turn: usize) -> Self {
        Decimal(f64::sample(turn))
    }
}

impl Sample for Letter {
    fn sample(turn: usize) -> Self {
        Letter(char::sample(turn))
    }
}

impl Sample for Keyword {
    fn sample(turn: usize) -> Self {
        KEYWORDS[turn % KEYWORDS.len()].keyword
    }
}

impl Sample for Target {
    fn sample(turn: usize) -> Self {
        pick(
            turn,
            Target::Foot(1),
            [Target::Foot(0), Target::Foot(u8::MAX), Target::All],
        )
    }
}

/// No thing, very many, or a few.
fn several<T>(turn: usize, thing: impl Fn(usize) -> T) -> Vec<T> {
    let count = pick(turn, 2, [0, 20, 1]);
    (0..count).map(|_| thing(turn)).collect()
}

impl Sample for List {
    fn sample(turn: usize) -> Self {
        List(several(turn, String::sample))
    }
}

impl Sample for Each {
    fn sample(turn: usize) -> Self {
        Each(several(turn, String::sample))
    }
}

impl Sample for Quoted {
    fn sample(turn: usize) -> Self {
        Quoted(several(turn, String::sample))
    }
}

impl Sample for Alternatives {
    fn sample(turn: usize) -> Self {
        Alternatives(several(turn, String::sample))
    }
}

impl Sample for OneOf {
    fn sample(turn: usize) -> Self {
        OneOf(several(turn, String::sample))
    }
}

impl Sample for Both {
    fn sample(turn: usize) -> Self {
        Both(several(turn, |_| "hand"))
    }
}

impl Sample for Pieces {
    fn sample(turn: usize) -> Self {
        Pieces(several(turn, |turn| (u32::sample(turn), 9)))
    }
}

impl Sample for Faults {
    fn sample(turn: usize) -> Self {
        Faults(several(turn, |turn| Parsing::sample(turn).into()))
    }
}

impl Sample for Box<Message> {
    fn sample(turn: usize) -> Self {
        Box::new(Parsing::sample(turn).into())
    }
}
