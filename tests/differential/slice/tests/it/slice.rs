//! Random programs of fixed seeds on both engines in lock-step: the part of the differential campaign that every run of
//! the tests goes through.
#![allow(
    unreachable_pub,
    reason = "the programs are generated for other crates too"
)]

use ::lockstep::{Figures, Script, Subject, Verdict, compare, interpreter};
use std::thread;
use tip_sim::Plant;
use tipc::Robot;

include!(concat!(env!("OUT_DIR"), "/random.rs"));

/// Echoing joints for as long as it takes to come to an end, simulated ones for a moment, and for a shorter one those of a
/// robot with mass.
const RUNS: [(Plant, u64); 3] = [
    (Plant::Echo, 800),
    (Plant::Simulated, 100),
    (Plant::Dynamic, 20),
];

#[test]
fn both_engines_do_the_same_to_the_bit() {
    let middle = SUBJECTS.len() / 2;
    let figures = thread::scope(|scope| {
        let half = scope.spawn(|| agree(&SUBJECTS[..middle]));
        let mut figures = agree(&SUBJECTS[middle..]);
        figures.merge(&half.join().expect("the engines agree"));
        figures
    });
    // A slice that always ended the same way would prove little. Counts are of 200 programs.
    for (end, at_least) in [
        ("EXIT", 20),
        ("END", 5),
        ("LIMIT", 10),
        ("Domain error", 5),
        ("Invalid control mode", 1),
        ("Possible use of Variable before definition", 5),
    ] {
        let ends = figures.under("end ");
        let ends =
            ends.filter(|(name, _)| name.split_once('/').is_some_and(|(_, kind)| kind == end));
        let count: u64 = ends.map(|(_, count)| count).sum();
        let at_least = at_least * SUBJECTS.len() as u64 / 200;
        assert!(count >= at_least, "{end} {count} times in\n{figures}");
    }
}

fn agree(subjects: &[Subject]) -> Figures {
    let mut figures = Figures::default();
    for subject in subjects {
        let (robot, _) = interpreter(subject);
        let ((seed, _, source), _) = subject;
        // A hand has mass on the simulated joints already.
        let runs = RUNS
            .iter()
            .filter(|(plant, _)| robot != Robot::Hand || *plant != Plant::Dynamic);
        for (number, &(plant, cycles)) in (0..).zip(runs) {
            let script = Script::random(robot, *seed, number, cycles, plant);
            if let Verdict::Different(difference) = compare(subject, &script, &mut figures) {
                panic!("seed {seed}, {script:?}\n{difference:#?}\n{source}");
            }
        }
    }
    figures
}
