//! Which SPECIAL commands are reported as answered by nothing, against what a run of them does.

use tip_runtime::fault::Fault;
use tip_runtime::record::Ending;
use tip_sim::{Interpreter, Limit, Robot, Run};

/// The codes of what is said of one SPECIAL.
fn codes(robot: &Robot, number: u8) -> (Vec<&'static str>, bool) {
    let text = format!("3.1\nspecial\nSPECIAL {number}\nEND\n");
    let mut loaded = tipc::load("special.prg", text.as_bytes(), &robot.options());
    robot.warn(&mut loaded);
    let codes = loaded.diagnostics.iter().map(|it| it.code.id()).collect();
    let program = loaded.program.expect("a program");
    let mut run = Run::new(Interpreter::new(program), robot.clone()).expect("its robot");
    let ending = run.to_end(Limit::cycles(10));
    let is_refused = matches!(ending, Ending::Emergency(it) if it.fault == Fault::Domain);
    (codes, is_refused)
}

// clauses: 7.43 7.48
#[test]
fn what_is_answered_by_nothing_stops_a_run() {
    let titan8 = Robot::named("titan8").expect("a robot");
    for number in [0, 1, 20, 30, 255] {
        assert_eq!(codes(&titan8, number), (vec!["W123"], true), "{number}");
    }
    let hand = Robot::named("hand").expect("a robot");
    for number in [0, 3, 4, 7, 17, 21, 255] {
        assert_eq!(codes(&hand, number), (vec!["W123"], true), "{number}");
    }
    for number in [1, 2, 5, 6, 10, 11, 12, 13, 14, 15, 16, 20] {
        assert!(codes(&hand, number).0.is_empty(), "{number}");
    }
}

#[test]
fn the_arguments_behind_the_number_do_not_matter() {
    let titan8 = Robot::named("titan8").expect("a robot");
    for arguments in ["30 V", "30 V -5"] {
        let text = format!("3.1\nspecial\nDEF_VAR V\nV = 1\nSPECIAL {arguments}\nEND\n");
        let mut loaded = tipc::load("special.prg", text.as_bytes(), &titan8.options());
        titan8.warn(&mut loaded);
        let codes: Vec<_> = loaded.diagnostics.iter().map(|it| it.code.id()).collect();
        assert_eq!(codes, ["W123"], "{arguments}");
    }
}

#[test]
fn native_code_of_an_owner_may_answer_anything() {
    let titan8 = Robot::named("titan8").expect("a robot").with_special(());
    assert!(codes(&titan8, 30).0.is_empty());
}
