//! What the debugger's parts answer by themselves.

use super::hits::Hits;

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
