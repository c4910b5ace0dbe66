//! A run as its viewers see it.

use crate::live::bench::{COUNTS, does, session_of};
use crate::live::page::Page;
use serde_json::json;
use tip_runtime::plant::{Block, Scene};
use tip_sim::Robot;
use tip_view::live::{Session, Setup, Viewer};

#[test]
fn a_run_rests_until_it_is_to_play_and_keeps_time() {
    let mut session = session_of(COUNTS);
    session.advance(1000.0, || true);
    assert_eq!(session.cycles(), 1);
    does(&mut session, json!({"do": "play"}));
    session.advance(1000.0, || true);
    assert_eq!(session.cycles(), 51, "50 cycles of 20 ms a second");
    does(&mut session, json!({"do": "speed", "times": 2.5}));
    session.advance(1000.0, || true);
    assert_eq!(session.cycles(), 51 + 125);
    does(&mut session, json!({"do": "pause"}));
    session.advance(1000.0, || true);
    assert_eq!(session.cycles(), 176);
}

#[test]
fn a_page_is_told_of_the_blocks_that_stand_on_the_floor() {
    let block = Block {
        x: [-100.0, 100.0],
        y: [300.0, 900.0],
        height: 40.0,
    };
    let scene = Scene::EMPTY.with_block(block).expect("there is room");
    let robot = Robot::named("titan8").expect("it has a name");
    let robot = robot.with_scene(&scene).expect("it walks there");
    let setup = Setup::new("counts.prg", COUNTS.as_bytes(), robot);
    let session = Session::new(setup).expect("a program");
    let first = session.update(&mut Viewer::default()).expect("a run");
    let run: serde_json::Value = serde_json::from_str(&first).expect("JSON");
    let expected = json!([{"x": [-100.0, 100.0], "y": [300.0, 900.0], "height": 40.0}]);
    assert_eq!(run["scene"]["blocks"], expected);
}

#[test]
fn a_run_from_the_start_plays_even_if_the_one_before_rests() {
    let mut session = session_of("3.1\nshort\nSLEEP 100\nEND\n");
    let mut page = Page::default();
    let playing = |session: &mut Session, page: &mut Page| {
        does(session, json!({"do": "restart"}));
        page.look(session);
        page.status["playing"].clone()
    };
    assert_eq!(playing(&mut session, &mut page), true, "it rested");
    assert_eq!(playing(&mut session, &mut page), true, "it played");
    session.advance(1000.0, || true);
    page.look(&session);
    assert_eq!(
        (&page.status["over"], &page.status["playing"]),
        (&json!(true), &json!(false))
    );
    assert_eq!(playing(&mut session, &mut page), true, "it was over");
}

#[test]
fn a_run_that_is_too_slow_says_so_and_does_not_catch_up_for_ever() {
    let mut session = session_of(COUNTS);
    let mut page = Page::default();
    does(&mut session, json!({"do": "play"}));
    let mut left = 10;
    session.advance(60_000.0, || {
        left -= 1;
        left >= 0
    });
    page.look(&session);
    assert_eq!((session.cycles(), &page.status["late"]), (11, &json!(true)));
    session.advance(0.0, || true);
    page.look(&session);
    assert_eq!(
        (session.cycles(), &page.status["late"]),
        (16, &json!(false)),
        "100 ms"
    );
}

#[test]
fn updates_add_up_however_often_a_viewer_looks() {
    let mut session = session_of(COUNTS);
    let (mut often, mut once) = (Page::default(), Page::default());
    does(&mut session, json!({"do": "play"}));
    for _ in 0..500 {
        session.advance(20.0, || true);
        often.look(&session);
    }
    once.look(&session);
    assert_eq!(often.seen(), once.seen());
    assert_eq!((once.cycles, once.frames.len()), (501, 501));
    assert_eq!(once.look(&session), 0, "it knows all");
    // N is assigned in one of at most six cycles.
    assert!(once.value("N") > 80.0, "{}", once.value("N"));
}

#[test]
fn who_has_seen_nothing_gets_a_long_run_in_pieces() {
    let mut session = session_of(COUNTS);
    does(&mut session, json!({"do": "play"}));
    session.advance(100_000.0, || true);
    let mut page = Page::default();
    // The run in six updates of 1000 frames each, beginning, text, findings, status.
    assert_eq!(page.look(&session), 10);
    assert_eq!((page.cycles, page.frames.len()), (5001, 5001));
}

#[test]
fn a_key_and_a_knob_reach_the_program() {
    let mut session = session_of(COUNTS);
    let mut page = Page::default();
    does(&mut session, json!({"do": "step", "cycles": 9}));
    does(&mut session, json!({"do": "event", "event": "key F"}));
    does(&mut session, json!({"do": "event", "event": "VR1=3.5"}));
    does(&mut session, json!({"do": "event", "event": "VR1=8"}));
    does(&mut session, json!({"do": "step", "cycles": 12}));
    page.look(&session);
    assert_eq!(page.value("V"), 8.0);
    assert_eq!(page.value("K"), 70.0);
    let texts: Vec<_> = page.log["message"].iter().map(|it| it[1].clone()).collect();
    assert_eq!(texts, [json!("key")]);
    // The first value of the knob was never read.
    assert_eq!(
        page.log["event"],
        [json!([10, "key F"]), json!([10, "VR1=8"])]
    );
}

#[test]
fn a_halt_is_requested() {
    let text =
        "3.1\nhalts\nLOOP:\nIF HALT_REQUEST THEN\nMESSAGE halted\nEXIT\nENDIF\nGOTO LOOP:\nEND\n";
    let mut session = session_of(text);
    let mut page = Page::default();
    does(&mut session, json!({"do": "play"}));
    session.advance(500.0, || true);
    does(&mut session, json!({"do": "event", "event": "halt"}));
    session.advance(500.0, || true);
    page.look(&session);
    assert_eq!(page.status["outcome"]["how"], "EXIT");
    assert_eq!(page.status["playing"], false);
}

#[test]
fn a_run_rests_where_it_is_asked_to_and_then_goes_on() {
    let robot = Robot::named("titan8").expect("it has a name");
    let mut setup = Setup::new("counts.prg", COUNTS.as_bytes(), robot);
    setup.rest = Some(30);
    let mut session = Session::new(setup).expect("a program");
    does(&mut session, json!({"do": "play"}));
    session.advance(10_000.0, || true);
    assert_eq!(session.cycles(), 30);
    does(&mut session, json!({"do": "play"}));
    session.advance(200.0, || true);
    assert_eq!(session.cycles(), 40);
}
