//! A run that is taken back does the same again, to the bit.

use std::error::Error;
use tip_runtime::command::Poll;
use tip_runtime::console::Transcript;
use tip_runtime::fault::Fault;
use tip_runtime::program;
use tip_runtime::record::Ending;
use tip_runtime::special::hand::HandSpecials;
use tip_runtime::special::{Call, Special};
use tip_sim::{Cycle, Limit, Robot, Run, Timeline, load};

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

/// The same of edition 3.2: threads with calls and waits, several steps in a cycle, timers, switches of joints, working
/// limits, texts for a file, variables that native code shares.
const BUSY_THREADS: &str = "3.2
busy
DEF_VAR N, V
N = 0
START_TIMER 1
TIP_SPEED_UP 2
START_THREAD ONE:
START_THREAD TWO:
DIRECT J11
LOCK J13
SET_LIMIT J22 5 40
L:
V = @TIMER1 / 200
PTP_ANGLE J11 R V
SLEEP 60
N += 1
IF N < 4 GOTO L:
N = 0
RESET_TIMER 1
GOTO L:
THREAD ONE:
GOSUB S:
PTP_ANGLE J21 R 3
SLEEP 40
AD_IN VR1 V
GOTO ONE:
THREADEND
THREAD TWO:
SPECIAL 30 7
VAR_SPECIAL_1 += 1
STOP_THREAD ONE:
WAIT_THREAD ONE:
START_THREAD ONE:
GOTO TWO:
THREADEND
SUBROUTINE S:
F_MESSAGE %N% %@TIMER1.1%\\n
KEY_IN
SUBEND
END
";

const EVENTS: &str = "20:key a, 25:VR1=4, 33:key b, 33:key c, 47:VR1=2, 60:key d";

fn busy(robot: Robot) -> Result<Run, Box<dyn Error>> {
    run(robot, BUSY)
}

fn run(robot: Robot, program: &str) -> Result<Run, Box<dyn Error>> {
    let program = load("busy.prg", program, &robot)?;
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
    let (messages, appended) = (&shown.messages, &shown.appended);
    format!(
        "{messages:?}\n{appended}\n{:?}\n{}",
        shown.variables, shown.log
    )
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
        let moved = first.iter().filter(|cycle| !cycle.commands.is_empty());
        assert!(moved.count() > 2);
    }
    Ok(())
}

// clauses: 14.1 14.2 15.2 16.1 16.2 16.3
#[test]
fn threads_timers_and_switches_are_taken_back() -> Outcome {
    for robot in robots()? {
        for at in [5, 30, 31, 47] {
            let mut run = run(robot.clone(), BUSY_THREADS)?;
            run.to_end(Limit::cycles(at));
            let mark = run.snapshot();
            let first = cycles(&mut run, 60);
            let (trace, text) = (run.trace(), shown(&run));
            assert!(run.emergency().is_none(), "{trace}");
            assert!(trace.contains(r#""thread":"TWO""#) && trace.contains(r#""out":""#));
            run.restore(&mark);
            assert_eq!(cycles(&mut run, 60), first);
            assert_eq!((run.trace(), shown(&run)), (trace, text));
        }
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

#[test]
fn another_future_has_what_is_scripted_and_what_has_happened() -> Outcome {
    let robot = Robot::named("titan8")?;
    let program = load("p.prg", "3.1\nt\nAGAIN:\nGOTO AGAIN:\nEND\n", &robot)?;
    let run = Run::new(program, robot)?.events("5:VR1=2, 8:VR1=3")?;
    let mut timeline = Timeline::new(run, ());
    let go = |timeline: &mut Timeline, cycles| {
        for _ in 0..cycles {
            timeline.advance(None);
            timeline.note(|| ());
        }
    };
    let to_come = |timeline: &Timeline| {
        let events = timeline.to_come().iter();
        events.map(ToString::to_string).collect::<Vec<_>>()
    };
    go(&mut timeline, 5);
    timeline.branch();
    timeline.add("key A".parse()?)?;
    assert_eq!(to_come(&timeline), ["5:VR1=2", "5:key A", "8:VR1=3"]);
    go(&mut timeline, 1);
    timeline.branch();
    timeline.add("key B".parse()?)?;
    assert_eq!(timeline.changes().to_string(), "5:key A, 6:key B");

    // Back before both, where nothing of cycle 5 has happened.
    assert!(timeline.rewind(5).is_some());
    assert_eq!(timeline.now(), 0);
    go(&mut timeline, 5);
    timeline.branch();
    assert_eq!(to_come(&timeline), ["5:VR1=2", "8:VR1=3"]);
    assert_eq!(timeline.changes().to_string(), "");

    // What has happened at this position stays.
    timeline.add("key C".parse()?)?;
    timeline.happen();
    timeline.branch();
    assert_eq!(to_come(&timeline), ["8:VR1=3"]);
    assert_eq!(timeline.changes().to_string(), "5:key C");
    Ok(())
}

#[test]
fn checkpoints_are_apart_and_those_before_a_position_can_be_forgotten() -> Outcome {
    let robot = Robot::named("titan8")?;
    let program = load("p.prg", "3.1\nt\nAGAIN:\nGOTO AGAIN:\nEND\n", &robot)?;
    let mut timeline = Timeline::new(Run::new(program, robot)?, 0);
    for _ in 0..1000 {
        timeline.advance(None);
        let now = timeline.now();
        assert_eq!(timeline.note(|| now), now % 200 == 0, "{now}");
    }
    assert_eq!(timeline.rewind(799), Some(&600));
    assert_eq!((timeline.now(), timeline.run().cycles()), (600, 600));
    timeline.forget_before(450);
    assert_eq!(timeline.first(), 400);
    assert_eq!(timeline.rewind(399), None);
    // A branch knows nothing of what came later.
    timeline.branch();
    assert_eq!(timeline.rewind(1000), Some(&600));
    Ok(())
}
