#[cfg(feature = "robot-files")]
use super::Describing;

use super::list::{Alternatives, Both, Each, Faults, List, OneOf, Pieces, Quoted};
use super::phrase::{Joints, Numbers, Standing, Type};
use super::say::{Said, Say};
use super::{Cut, Decimal, Lang, Letter, Message, Parsing, Text, each};
use crate::language::keywords::KEYWORDS;
use crate::language::{Bilingual, Edition, Keyword};
use smol_str::SmolStr;
use std::ops::Range;
use tip_runtime::command::Target;

#[track_caller]
fn check(message: impl Say, expected: &str) {
    assert_eq!(english(&message), expected);
}

fn english(message: &impl Say) -> String {
    Said(message, Lang::English).to_string()
}

fn japanese(message: &impl Say) -> String {
    Said(message, Lang::Japanese).to_string()
}

#[test]
fn holes_take_the_arguments_that_bear_their_names() {
    check(
        Parsing::NameTooLong {
            limit: 32,
            length: 33,
        },
        "a name has at most 32 bytes, this one 33",
    );
    #[cfg(feature = "robot-files")]
    check(
        Describing::InitialOutside {
            angle: 90.5,
            joint: 2,
            min: -60.0,
            max: 75.0,
        },
        "the initial angle 90.5 of joint 2 is outside its limits -60 to 75",
    );
    check(Message::from(Parsing::ThenBelongsHere), "THEN belongs here");
}

#[test]
fn parts_of_a_sentence_agree_with_their_numbers() {
    check(Joints::from(1), "1 joint");
    check(Joints::from(3), "3 joints");
    check(Standing::from(0), "there is none");
    check(Standing::from(1), "there is one");
    check(Standing::from(2), "there are 2");
    check(Numbers::new(1, None), "one number");
    check(Numbers::new(3, None), "3 numbers");
    check(Numbers::new(1, Some(Type::Joint)), "one number or a JOINT");
    check(Numbers::new(3, Some(Type::Pos)), "3 numbers or a POS");
}

#[test]
fn lists_are_written_as_sentences_need_them() {
    let names = || vec!["A".to_owned(), "B".to_owned()];
    check(List(names()), "A, B");
    check(Quoted(names()), "`A`, `B`");
    check(Each(names()), "A and B");
    check(Each(vec!["A".into(), "B".into(), "C".into()]), "A, B and C");
    check(Each(vec!["A".into()]), "A");
    check(Alternatives(names()), "`A`, or `B`");
    check(Both(vec!["hand", "generic"]), "hand and generic");
    let faults = [Parsing::ThenBelongsHere, Parsing::ToBelongsHere];
    check(
        Faults(faults.map(Message::from).into()),
        "THEN belongs here; TO belongs here",
    );
}

#[test]
fn of_a_long_path_the_ends_are_shown() {
    let pieces = |count| Pieces((1..=count).map(|line| (10 * line, 10 * line + 5)).collect());
    check(Pieces(vec![(3, 3)]), "3");
    check(pieces(2), "10-15, 20-25");
    check(
        pieces(8),
        "10-15, 20-25, 30-35, 40-45, 50-55, 60-65, 70-75, 80-85",
    );
    check(
        pieces(9),
        "10-15, 20-25, 30-35, 40-45, …, 60-65, 70-75, 80-85, 90-95",
    );
}

#[test]
fn every_message_is_a_whole_text_with_plain_arguments() {
    let texts = |message: Message| {
        [
            (english(&message), message.clone()),
            (japanese(&message), message),
        ]
    };
    for (text, message) in (0..PLAIN).flat_map(each).flat_map(texts) {
        assert!(!text.trim().is_empty(), "{message:?}");
        assert_eq!(text.trim_end(), text, "{message:?}");
        assert!(!text.contains(['{', '}']), "{message:?}: {text:?}");
        assert!(!text.contains("  "), "{message:?}: {text:?}");
    }
}

#[test]
fn every_message_shows_odd_arguments_as_they_are() {
    for turn in ODD {
        let odd = String::sample(turn);
        let quoted = format!("{odd:?}");
        let odd = match odd.char_indices().nth(80) {
            Some((end, _)) => odd[..end].to_owned(),
            None => odd,
        };
        for message in each(turn) {
            let has_odd = format!("{message:?}").contains(&quoted);
            for text in [english(&message), japanese(&message)] {
                assert!(!has_odd || text.contains(&odd), "turn {turn}: {text:.200}");
            }
        }
    }
}

#[test]
fn words_are_cut_beyond_80_characters_and_texts_beyond_the_longest_path() {
    let near = |count: usize| super::Suggestion::DidYouMean {
        near: "歩".repeat(count).into(),
    };
    check(near(80), &format!("did you mean `{}`?", "歩".repeat(80)));
    check(near(81), &format!("did you mean `{}…`?", "歩".repeat(80)));
    let error = |count: usize| super::Reading::System {
        error: "x".repeat(count).into(),
    };
    check(error(4096), &"x".repeat(4096));
    check(error(1_000_000), &("x".repeat(4096) + "…"));
    let long = || vec!["B".repeat(90), "C".to_owned()];
    check(List(long()), &format!("{}…, C", "B".repeat(80)));
    check(Quoted(long()), &format!("`{}…`, `C`", "B".repeat(80)));
}

#[test]
fn a_zero_has_no_sign() {
    let from_to = |min: f64| super::Describing::StartsOutside { angle: min };
    check(
        from_to(-0.0),
        &from_to(0.0).in_lang(Lang::English).to_string(),
    );
    assert!(
        !from_to(-0.0)
            .in_lang(Lang::Japanese)
            .to_string()
            .contains('-')
    );
    assert!(
        from_to(-0.5)
            .in_lang(Lang::English)
            .to_string()
            .contains("-0.5")
    );
}

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
