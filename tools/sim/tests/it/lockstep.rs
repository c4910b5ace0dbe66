//! Two engines cycle by cycle, and what a process that compares them answers.

use std::io::Cursor;
use tip_sim::lockstep::{Answer, Evidence, Lockstep, ReachedPoints, RunEnd, serve};
use tip_sim::{Inputs, Robot, load};

const COUNT: &str = "DEF_VAR N\nN = 0\nLOOP: KEY_IN\nN += 1\nIF N < 3 GOTO LOOP:\nMESSAGE %N%\nEND";

/// An interpreter of `other` in the place of compiled code.
fn lockstep(evidence: Evidence, statements: &str, other: &str) -> Lockstep {
    let robot = Robot::named("generic").expect("a robot");
    let interpreter = |statements| {
        let text = format!("3.1\ntest\n{statements}\n");
        load("p.prg", &text, &robot).expect("it loads")
    };
    let program = interpreter(statements).program().clone();
    Lockstep::comparing(evidence, program, interpreter(other), &robot).expect("one robot")
}

fn answers(lockstep: Lockstep, requests: &str) -> Vec<Answer> {
    let mut out = Vec::new();
    serve(lockstep, Cursor::new(requests), &mut out).expect("a Vec takes everything");
    let text = String::from_utf8(out).expect("answers are text");
    text.lines()
        .map(|line| serde_json::from_str(line).expect("an answer"))
        .collect()
}

// Steps: 0 N = 0, 1 LOOP, 2 KEY_IN, 3 N += 1, 4 IF, 5 MESSAGE, 6 END. The coverage points after them are the edges of 4.
#[test]
fn runs_agree_and_tell_what_is_new() {
    let lockstep = lockstep(Evidence::Records, COUNT, COUNT);
    let reach = ReachedPoints::new(lockstep.program());
    let answers = answers(
        lockstep,
        "--keys 0:A --cycles 9\n--keys 0:A,4:B,8:C\n--keys 1:A --cycles 4\n",
    );
    let agreed = |cycles, end, new: &[usize], chances: &[u64]| Answer::Agreed {
        cycles,
        end,
        new: new.to_vec(),
        chances: chances.to_vec(),
    };
    // The second run reads keys in cycles 2, 6 and 10, and 14 is its last one. Before the end, the false edge is open.
    let expected = [
        agreed(9, RunEnd::Limit, &[0, 1, 2, 3, 4, 7], &[4]),
        agreed(15, RunEnd::Finished, &[8, 5, 6], &[4, 8]),
        agreed(4, RunEnd::Limit, &[], &[]),
    ];
    let [Answer::Agreed { new, .. }, ..] = &answers[..] else {
        panic!("{answers:?}");
    };
    let ways: Vec<_> = new
        .iter()
        .map(|point| reach.points().all()[*point].way)
        .collect();
    assert_eq!(ways.last(), Some(&Some("true")));
    assert_eq!(answers, expected);
}

#[test]
fn the_first_record_that_differs_is_told() {
    let other = COUNT.replace("N < 3", "N < 2");
    let keys = "--keys 0:A,4:B,8:C";
    let [Answer::Diverged(divergence)] =
        &answers(lockstep(Evidence::Records, COUNT, &other), keys)[..]
    else {
        panic!("they agree");
    };
    assert_eq!((divergence.cycle, divergence.step), (8, 4));
    assert!(
        divergence.interpreted.contains(r#""next":1"#),
        "{divergence:?}"
    );
    assert!(
        divergence.compiled.contains(r#""next":5"#),
        "{divergence:?}"
    );
    let short = answers(
        lockstep(Evidence::Records, COUNT, &other),
        "--keys 0:A,4:B,8:C --cycles 8",
    );
    assert!(
        matches!(short[..], [Answer::Agreed { cycles: 8, .. }]),
        "{short:?}"
    );
}

#[test]
fn a_different_end_is_a_divergence() {
    let faulty = "DEF_VAR N\nN = 0\nN = 1 / N\nEND";
    let ends = "DEF_VAR N\nN = 0\nREM\nEND";
    let [Answer::Diverged(divergence)] =
        &answers(lockstep(Evidence::Records, faulty, ends), "\n")[..]
    else {
        panic!("they agree");
    };
    assert_eq!(divergence.cycle, 1);
    assert!(
        divergence.interpreted.contains("Domain error"),
        "{divergence:?}"
    );
    let both = answers(lockstep(Evidence::Records, faulty, faulty), "\n");
    assert!(
        matches!(
            both[..],
            [Answer::Agreed {
                cycles: 1,
                end: RunEnd::Emergency,
                ..
            }]
        ),
        "{both:?}"
    );
}

#[test]
fn what_the_robot_lacks_is_refused() {
    let lockstep = lockstep(Evidence::Records, "END", "END");
    for wrong in ["--sensor J99=1@0", "--keys"] {
        let answers = answers(lockstep.clone(), wrong);
        assert!(matches!(&answers[..], [Answer::Refused(_)]), "{answers:?}");
    }
}

/// Only a key makes it differ.
const WRONG: &str = "DEF_VAR N\nN = 0\nLOOP: KEY_IN\nN -= 1\nIF N < 3 GOTO LOOP:\nMESSAGE %N%\nEND";

#[test]
fn hashes_find_the_same_difference_and_tell_it_in_words() {
    let inputs = |text: &str| text.parse::<Inputs>().expect("inputs");
    let run = |evidence, other, text: &str| {
        let compared = lockstep(evidence, COUNT, other).run(&inputs(text), &mut ());
        compared.expect("no input that is missing")
    };
    let keys = "--keys 5:A --cycles 90";
    let reported = run(Evidence::Hashes, WRONG, keys)
        .divergence
        .expect("N is 1 or -1");
    let record = run(Evidence::Records, WRONG, keys)
        .divergence
        .expect("the same");
    // KEY_IN waits from cycle 2 to 5, and the next step counts.
    assert_eq!((reported.cycle, reported.step), (6, 3));
    assert_eq!((record.cycle, record.step), (6, 3));
    assert!(
        reported.interpreted.contains("N is Some(1.0)"),
        "{reported:?}"
    );
    assert!(
        reported.compiled.contains("N is Some(-1.0)"),
        "{reported:?}"
    );
    let same = run(Evidence::Hashes, COUNT, keys);
    assert_eq!((same.divergence, same.cycles), (None, 90));
    assert_ne!(same.hash, run(Evidence::Hashes, COUNT, "--cycles 90").hash);
}

#[test]
fn what_the_console_alone_is_shown_is_compared_too() {
    let (silent, loud) = ("SILENT_ON\nEND", "SILENT_OFF\nEND");
    let compared = lockstep(Evidence::Hashes, silent, loud).run(&Inputs::default(), &mut ());
    let divergence = compared.expect("no inputs").divergence;
    assert_eq!(divergence.map(|divergence| divergence.cycle), Some(0));
}

#[test]
fn programs_of_other_steps_are_unlike_before_they_run() {
    assert_eq!(lockstep(Evidence::Hashes, COUNT, COUNT).unlike(), None);
    let longer = COUNT.replace("N = 0", "N = 0\nREM");
    assert!(
        lockstep(Evidence::Hashes, COUNT, &longer)
            .unlike()
            .is_some()
    );
}

/// A thread, several steps in a cycle, and in each part an IF whose one edge no run takes.
const THREADS: &str = "TIP_SPEED_UP 9\nSTART_THREAD SIDE:\nN = 0\nIF KB_HIT THEN\nN = 1\nENDIF\n\
    WAIT_THREAD SIDE:\nEXIT\nTHREAD SIDE:\nIF N == 0 THEN\nN = 2\nENDIF\nTHREADEND\nEND";

fn later(other: &str) -> Lockstep {
    let robot = Robot::named("generic").expect("a robot");
    let interpreter = |statements: &str| {
        let text = format!("3.2\ntest\nDEF_VAR N\n{statements}\n");
        load("p.prg", &text, &robot).expect("it loads")
    };
    let program = interpreter(THREADS).program().clone();
    Lockstep::new(program, interpreter(other), &robot).expect("one robot")
}

// clauses: 14.2 15.2
// Cycle 0 runs step 0, cycle 1 the steps 1, 2, 3, 5 and 6, cycle 2 step 6 and all of the thread, cycle 3 step 6 again,
// which ends the turn, and cycle 4 the EXIT.
#[test]
fn each_step_of_a_cycle_counts_as_reached() {
    let lockstep = later(THREADS);
    let mut reach = ReachedPoints::new(lockstep.program());
    let compared = lockstep
        .run(&Inputs::default(), &mut reach)
        .expect("no inputs");
    assert_eq!((compared.cycles, compared.divergence), (5, None));
    let points = reach.points().all().iter();
    let missed = (0..).zip(points).filter(|(point, _)| !reach.has(*point));
    let missed: Vec<_> = missed.map(|(_, point)| (point.step, point.way)).collect();
    // No way leads to END.
    assert_eq!(missed, [(4, None), (3, Some("true")), (9, Some("false"))]);
}

// clauses: 15.2
#[test]
fn the_step_that_differs_may_be_a_threads() {
    let other = THREADS.replace("N = 2", "N = 3");
    let compared = later(&other).run(&Inputs::default(), &mut ());
    let divergence = compared.expect("no inputs").divergence.expect("N differs");
    assert_eq!((divergence.cycle, divergence.step), (2, 10));
    assert!(
        divergence
            .interpreted
            .contains(r#""thread":"SIDE","step":10"#)
    );
}
