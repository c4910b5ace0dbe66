//! The SPECIAL commands of the hand.

mod bench;
mod closure;
mod friction;
mod lever;

use bench::Bench;
use tip_runtime::command::Poll;
use tip_runtime::fault::Fault;
use tip_runtime::program::Robot;
use tip_runtime::special::{Call, Special};

// clauses: 7.43 7.48
#[test]
fn every_other_number_is_unknown() {
    let known = [1, 2, 5, 6, 10, 11, 12, 13, 14, 15, 16, 20];
    for number in (0..=255).filter(|number| !known.contains(number)) {
        Bench::new().refuse(number, &[&[], &[1.0], &[1.0, 1.0]]);
    }
}

// clauses: 7.43 7.48
#[test]
fn bar_graphs_go_on_and_off() {
    let mut bench = Bench::new();
    bench.done(20, &[0.0, 1.0]);
    bench.done(20, &[1.0, 0.0]);
    assert_eq!(bench.robot.graphs, [(0, true), (1, false)]);
    let wrong: [&[f64]; 5] = [&[], &[0.0], &[2.0, 1.0], &[0.0, 2.0], &[0.5, 1.0]];
    bench.refuse(20, &wrong);
    assert_eq!(bench.robot.graphs.len(), 2);
}

/// A handler of SPECIAL 30, which sets a flag, that counts cycles.
#[derive(Default)]
struct Own {
    cycles: f64,
}

impl Special for Own {
    fn poll(&mut self, call: Call, robot: &mut dyn Robot) -> Result<Poll, Fault> {
        match (call.number, call.arguments) {
            (10 | 30, [Some(cycles), None]) => {
                assert_eq!(cycles, self.cycles);
                robot.set_special_flag(9, true);
                Ok(Poll::Done)
            }
            _ => Err(Fault::Domain),
        }
    }

    fn cycle(&mut self, _: &mut dyn Robot) -> Result<(), Fault> {
        self.cycles += 1.0;
        Ok(())
    }
}

// clauses: 7.43 7.48
#[test]
fn a_users_commands_stand_beside_those_of_the_hand() {
    let mut bench = Bench::with_user(Own::default());
    bench.idle(4);
    bench.done(14, &[30.0]);
    bench.done(30, &[5.0]);
    assert!(bench.robot.flags[9]);
    // The hand's own numbers stay the hand's.
    bench.refuse(10, &[&[6.0]]);
    bench.refuse(31, &[&[6.0]]);
}
