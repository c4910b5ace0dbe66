//! Taking a run back.

use crate::live::bench::{COUNTS, does, refuses, session_of};
use crate::live::page::Page;
use serde_json::json;
use tip_sim::Robot;
use tip_view::live::{Session, Setup};

#[test]
fn back_is_the_state_that_was_and_the_same_happens_again() {
    let mut session = session_of(COUNTS);
    let mut page = Page::default();
    does(&mut session, json!({"do": "step", "cycles": 700}));
    does(&mut session, json!({"do": "event", "event": "key F"}));
    does(&mut session, json!({"do": "step", "cycles": 9}));
    page.look(&session);
    let earlier = (session.cycles(), session.state_hash(), page.seen());
    does(&mut session, json!({"do": "event", "event": "VR1=4"}));
    does(&mut session, json!({"do": "step", "cycles": 900}));
    page.look(&session);
    let later = (session.cycles(), session.state_hash(), page.seen());
    does(&mut session, json!({"do": "step", "cycles": -900}));
    page.look(&session);
    let back = (session.cycles(), session.state_hash(), page.seen());
    assert_eq!(back, earlier);
    does(&mut session, json!({"do": "step", "cycles": 900}));
    page.look(&session);
    let again = (session.cycles(), session.state_hash(), page.seen());
    assert_eq!(again, later, "the knob turned again");
    let mut fresh = Page::default();
    fresh.look(&session);
    assert_eq!(fresh.seen(), page.seen());
}

#[test]
fn a_change_that_was_taken_back_is_told_when_it_happens_again() {
    // SLEEP takes cycles 0 to 299, longer than from one checkpoint to the next.
    let mut session = session_of("3.1\nMoves\nSLEEP 6000\nPTP_ANGLE J11 3\nSLEEP 2000\nEND\n");
    let mut page = Page::default();
    does(&mut session, json!({"do": "step", "cycles": 310}));
    page.look(&session);
    let modes = page.log["modes"].clone();
    let cycles: Vec<_> = modes.iter().map(|entry| &entry[0]).collect();
    assert_eq!(cycles, [&json!(0), &json!(300)]);
    does(&mut session, json!({"do": "step", "cycles": -15}));
    page.look(&session);
    assert_eq!(page.log["modes"], modes[..1]);
    does(&mut session, json!({"do": "step", "cycles": 15}));
    page.look(&session);
    assert_eq!(page.log["modes"], modes);
    let mut fresh = Page::default();
    fresh.look(&session);
    assert_eq!(fresh.seen(), page.seen(), "nothing is told twice");
}

#[test]
fn whatever_is_done_after_going_back_is_another_future() {
    let robot = Robot::named("titan8").expect("it has a name");
    let mut setup = Setup::new("counts.prg", COUNTS.as_bytes(), robot);
    setup.events = "300:VR1=2".parse().expect("an event");
    let mut session = Session::new(setup).expect("a program");
    does(&mut session, json!({"do": "step", "cycles": 100}));
    does(&mut session, json!({"do": "event", "event": "VR1=4"}));
    does(&mut session, json!({"do": "step", "cycles": 300}));
    does(&mut session, json!({"do": "go", "cycle": 50}));
    assert_eq!(session.cycles(), 51);
    does(&mut session, json!({"do": "event", "event": "VR1=6"}));
    does(&mut session, json!({"do": "step", "cycles": 200}));
    let mut page = Page::default();
    page.look(&session);
    assert_eq!(page.value("V"), 6.0, "not 4");
    does(&mut session, json!({"do": "step", "cycles": 100}));
    page.look(&session);
    assert_eq!(
        page.value("V"),
        2.0,
        "the command line's event is still to come"
    );
    assert_eq!(
        page.log["event"],
        [json!([51, "VR1=6"]), json!([300, "VR1=2"])]
    );
    refuses(
        &mut session,
        json!({"do": "go", "cycle": 9999}),
        "impossible",
    );
    does(&mut session, json!({"do": "step", "cycles": -1000}));
    assert_eq!(session.cycles(), 1, "the first cycle stays");
}

#[test]
fn a_viewer_that_missed_many_returns_begins_anew() {
    let mut session = session_of(COUNTS);
    let mut page = Page::default();
    does(&mut session, json!({"do": "step", "cycles": 100}));
    page.look(&session);
    for _ in 0..100 {
        does(&mut session, json!({"do": "step", "cycles": -1}));
        does(&mut session, json!({"do": "event", "event": "VR1=1"}));
        does(&mut session, json!({"do": "step", "cycles": 1}));
    }
    page.look(&session);
    let mut fresh = Page::default();
    fresh.look(&session);
    assert_eq!(fresh.seen(), page.seen());
}

#[test]
fn an_emergency_stops_a_run_also_at_rest_and_can_be_taken_back() {
    let mut session = session_of(COUNTS);
    let mut page = Page::default();
    does(&mut session, json!({"do": "step", "cycles": 20}));
    does(&mut session, json!({"do": "event", "event": "key 0x0D"}));
    page.look(&session);
    assert_eq!(page.status["over"], true, "{}", page.status);
    assert_eq!(page.status["outcome"]["how"], "emergency");
    refuses(&mut session, json!({"do": "play"}), "over");
    refuses(
        &mut session,
        json!({"do": "event", "event": "key F"}),
        "over",
    );
    does(&mut session, json!({"do": "step", "cycles": -5}));
    page.look(&session);
    assert_eq!(page.status["over"], false);
    does(&mut session, json!({"do": "play"}));
}

#[test]
fn a_long_run_forgets_its_beginning_and_no_more() {
    let mut session = session_of(COUNTS);
    does(&mut session, json!({"do": "play"}));
    let mut page = Page::default();
    // 20 minutes; the last 5 to 6 stay.
    for _ in 0..20 {
        session.advance(60_000.0, || true);
    }
    page.look(&session);
    let first = *page.frames.keys().next().expect("frames");
    assert!((42_000..=45_000).contains(&first), "{first}");
    assert_eq!(page.cycles, 60_001);
    let sets = page.log.iter().filter(|(key, _)| key.starts_with("set."));
    let count: usize = sets.map(|(_, entries)| entries.len()).sum();
    assert!(count < 40_000, "{count}");
    does(&mut session, json!({"do": "go", "cycle": first}));
    refuses(
        &mut session,
        json!({"do": "go", "cycle": first - 1}),
        "impossible",
    );
    page.look(&session);
    assert_eq!(page.cycles, first + 1);
}

#[test]
fn a_fall_is_counted_when_its_cycle_is_forgotten() {
    // Two feet of one side go up: the body tips over them.
    let tips = "3.1\nTips\nSTAND_UP 60\nWAIT_INPOS ALL\nPTP F1 -391 201 -60\nPTP F3 -391 -201 -60\n\
                MESSAGE up\nWAIT_INPOS ALL\nAGAIN:\nGOTO AGAIN:\nEND\n";
    let mut session = session_of(tips);
    does(&mut session, json!({"do": "play"}));
    for _ in 0..8 {
        session.advance(60_000.0, || true);
    }
    // A viewer who comes now gets the last 5 to 6 minutes.
    let mut page = Page::default();
    page.look(&session);
    assert!(
        page.frames
            .keys()
            .next()
            .is_some_and(|first| *first > 5_000)
    );
    // What has not changed since then still holds.
    for key in ["contacts", "modes", "message", "command.1", "command.3"] {
        assert_eq!(page.log[key].len(), 1, "{key}");
    }
    assert_eq!(page.log["message"][0][1], "up");
    let falls = &page.log["fall"];
    assert_eq!((falls.len(), &falls[0][1][0]), (1, &json!(1)));
}
