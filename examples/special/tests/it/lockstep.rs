//! `tip verify` with native commands: both engines in lockstep until every step of the dance was reached.

use special::native::Native;
use special::{Dance, SOURCE};
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tip_sim::lockstep::{Lockstep, ReachedPoints};
use tip_sim::{Robot, load};

#[test]
fn both_engines_dance_alike_whether_all_feet_carry_or_not() {
    let robot = Robot::named("titan8").expect("it has that name");
    let robot = robot.with_special(Native::default());
    let program = load("dance.prg", SOURCE, &robot).expect("it loads");
    let lockstep = Lockstep::new(program.program().clone(), Dance::new(), &robot);
    let lockstep = lockstep.expect("both are for TITAN VIII");
    let mut reach = ReachedPoints::new(lockstep.program());
    for inputs in ["", "--sensor PAW2=0@0"] {
        let inputs = inputs.parse().expect("inputs");
        let run = lockstep.run(&inputs, &mut reach).expect("TITAN VIII");
        assert_eq!(run.divergence, None);
        assert_eq!(run.ending, Some(Ending::Program(End::End)));
    }
    let points = reach.points().all();
    let missed: Vec<_> = (0..)
        .zip(points)
        .filter(|(point, _)| !reach.has(*point))
        .collect();
    assert_eq!(missed, []);
}
