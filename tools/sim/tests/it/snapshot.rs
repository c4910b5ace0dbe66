//! A run that is taken back does the same again, to the bit.

use std::error::Error;
use tip_runtime::command::Poll;
use tip_runtime::console::Transcript;
use tip_runtime::fault::Fault;
use tip_runtime::program;
use tip_runtime::record::Ending;
use tip_runtime::special::hand::HandSpecials;
use tip_runtime::special::{Call, Special};
use tip_sim::{Cycle, Limit, Robot, Run, load};

type Outcome = Result<(), Box<dyn Error>>;

/// Takes as many cycles as it is asked for.
#[derive(Clone, Debug, Default)]
struct Patience {
    left: f64,
}

impl Special for Patience {
    fn poll(&mut self, call: Call, robot: &mut dyn program::Robot) -> Result<Poll, Fault> {
        if call.first {
            self.left = call.arguments[0].ok_or(Fault::Domain)?;
        }
        self.left -= 1.0;
        robot.set_special_flag(1, self.left < 1.0);
        Ok(if self.left < 1.0 {
            Poll::Done
        } else {
            Poll::Pending
        })
    }
}

/// Every part of a run that has a state: variables, calls, motion, a special command, keys, messages, logs.
const BUSY: &str = "3.1
busy
DEF_VAR N, V
N = 0
LOG_START
PTP_ANGLE J11 20
L:
GOSUB S:
AD_IN VR1 V
IF KB_HIT THEN
KEY_IN
PTP_ANGLE J22 R 3
ENDIF
SPECIAL 30 7
GOTO L:
S:
N += 1
MESSAGE %N%
OUTPUT_VARIABLES
RETURN
END
";

const EVENTS: &str = "20:key a, 25:VR1=4, 33:key b, 33:key c, 47:VR1=2, 60:key d";

fn busy(robot: Robot) -> Result<Run, Box<dyn Error>> {
    let program = load("busy.prg", BUSY, &robot)?;
    let run = Run::new(program, robot)?.events(EVENTS)?;
    Ok(run.with_trace(true).with_console(Transcript::default()))
}

fn robots() -> Result<Vec<Robot>, Box<dyn Error>> {
    let beside = HandSpecials::with_user(Patience::default());
    Ok(vec![
        Robot::named("titan8")?.with_special(Patience::default()),
        Robot::named("generic")?.with_special(Patience::default()),
        Robot::named("hand")?.with_special(beside),
    ])
}

fn cycles(run: &mut Run, count: usize) -> Vec<Cycle> {
    (0..count).map(|_| run.cycle()).collect()
}

fn shown(run: &Run) -> String {
    let shown: &Transcript = run.console().expect("it was given");
    format!("{:?}\n{:?}\n{}", shown.messages, shown.variables, shown.log)
}

#[test]
fn what_follows_a_mark_follows_it_again() -> Outcome {
    for robot in robots()? {
        let mut run = busy(robot)?;
        run.to_end(Limit::cycles(30));
        let mark = run.snapshot();
        let first = cycles(&mut run, 50);
        let (trace, text) = (run.trace(), shown(&run));
        run.restore(&mark);
        // The last record names the limit.
        assert_eq!((run.cycles(), run.trace().lines().count()), (30, 31));
        assert_eq!(cycles(&mut run, 50), first);
        assert_eq!((run.trace(), shown(&run)), (trace, text));
        // The events of these cycles came again: each key moved a joint.
        let moved = first.iter().filter(|cycle| cycle.command.is_some());
        assert!(moved.count() > 2);
    }
    Ok(())
}

#[test]
fn a_copy_goes_its_own_way_and_a_mark_serves_it_too() -> Outcome {
    for robot in robots()? {
        let mut run = busy(robot.clone())?;
        run.to_end(Limit::cycles(30));
        let mark = run.snapshot();
        let mut copy = run.clone();
        let first = cycles(&mut run, 20);
        assert_eq!(cycles(&mut copy, 20), first);
        let mut other = busy(robot)?;
        other.restore(&mark);
        assert_eq!(cycles(&mut other, 20), first);
        assert_eq!(copy.trace(), run.trace());
    }
    Ok(())
}

#[test]
fn an_emergency_is_taken_back_and_comes_again() -> Outcome {
    for robot in robots()? {
        let mut run = busy(robot)?;
        run.to_end(Limit::cycles(30));
        let mark = run.snapshot();
        run.add("40:key 0x0D".parse()?)?;
        let ending = run.to_end(Limit::cycles(80));
        assert_eq!(run.emergency().map(|stop| stop.cycle), Some(40));
        run.restore(&mark);
        assert_eq!((run.emergency(), run.ending()), (None, Some(Ending::Limit)));
        let shown: &Transcript = run.console().expect("it was given");
        assert_eq!(shown.emergency, None);
        assert_eq!(run.to_end(Limit::cycles(80)), ending);
    }
    Ok(())
}
