//! Counts of hits, and what is said to those who ask for the impossible.

use tip_runtime::command::Port;
use tip_runtime::program::VariableError;
use tip_sim::debug::{DebugError, Hits};
use tipc::message::Lang;

#[test]
fn counts_of_hits_are_read() {
    for (text, hits) in [
        ("5", Hits::Only(5)),
        (" == 5", Hits::Only(5)),
        ("> 5", Hits::From(6)),
        (">=5 ", Hits::From(5)),
        ("% 3", Hits::Each(3)),
    ] {
        assert_eq!(text.parse(), Ok(hits), "{text}");
    }
    for text in [
        "",
        "five",
        "< 5",
        "% 0",
        "5 times",
        "-5",
        "99999999999999999999",
    ] {
        assert!(text.parse::<Hits>().is_err(), "{text}");
    }
}

#[test]
fn hits_stop_at_the_passes_that_they_name() {
    let stops = |hits: Hits| (1..=7).filter(|n| hits.has(*n)).collect::<Vec<u64>>();
    assert_eq!(stops(Hits::Only(3)), [3]);
    assert_eq!(stops(Hits::From(5)), [5, 6, 7]);
    assert_eq!(stops(Hits::Each(3)), [3, 6]);
}

#[test]
fn a_refusal_is_said_in_both_languages() {
    let name = || "HEIGHT".to_owned();
    for (refused, english, japanese) in [
        (
            DebugError::NoStep(7),
            "no step is on line 7 or after it",
            "7行目以降にステップがありません",
        ),
        (
            DebugError::NoVariable(name(), VariableError::Unknown),
            "HEIGHT: the program has no variable of that name",
            "HEIGHT: この名前の変数はプログラムにありません",
        ),
        (
            DebugError::Hits("five".parse::<Hits>().unwrap_err()),
            "'five' is not a count of hits, such as 5, >= 5 or % 5",
            "'five' は通過回数の指定ではありません。5、>= 5、% 5 のように書いてください",
        ),
        (
            DebugError::Event(tip_sim::Refused::NoInput(Port::Knob(9))),
            "the robot has no input VR9",
            "このロボットに入力 VR9 はありません",
        ),
    ] {
        assert_eq!(refused.to_string(), english);
        assert_eq!(refused.text(Lang::Japanese), japanese);
    }
}
