//! Processes that do not start, do not answer, or end; and their end in any case.

use super::peer::{ECHO, NOD, Outcome, PATIENCE, in_cycle_3, peer, ready, run, stopped};
use std::process::Command;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use tip_runtime::fault::{Fault, HardwareFault};
use tip_runtime::machine::Status;
use tip_runtime::record::Ending;
use tip_sim::external::{Ended, Head, PlantError, StartError, TimeLimits};
use tip_sim::{ExternalPlant, Limit, Observer, Robot, Run, load};

const TO: Head = Head::Cycle(3);

/// Much shorter than what these processes sleep.
const SHORT: TimeLimits = TimeLimits {
    first: Duration::from_secs(20),
    later: Duration::from_secs(1),
};

#[test]
fn what_is_not_there_does_not_start() -> Outcome {
    let robot = Robot::named("titan8")?;
    let program = load("p.prg", "3.1\nt\nEND\n", &robot)?;
    let none = ExternalPlant::new("/no/such/simulator", [""; 0]);
    let refused = Run::external(program, &robot, &none).expect_err("it is not there");
    assert!(matches!(refused, StartError::Process { .. }));
    assert!(
        refused
            .to_string()
            .starts_with("the external plant '/no/such/simulator' does not start: ")
    );
    Ok(())
}

#[test]
fn a_program_of_another_robot_does_not_start() -> Outcome {
    let hand = Robot::named("hand")?;
    let program = load("p.prg", "3.1\nt\nEND\n", &hand)?;
    let refused = Run::external(program, &Robot::named("titan8")?, &peer(&ready(), ECHO));
    assert!(
        matches!(refused, Err(StartError::Mismatch(_))),
        "{refused:?}"
    );
    Ok(())
}

#[test]
fn it_ends_before_it_is_ready() -> Outcome {
    let (word, cycle, trouble) = stopped(&peer("exit 7", ECHO))?;
    assert_eq!((word, cycle), ("plant: ended", 0));
    let ended = Ended::Exit(7);
    assert_eq!(
        trouble,
        PlantError::Ended {
            to: Head::Hello,
            ended
        }
    );
    assert_eq!(
        trouble.to_string(),
        "the external plant ended with exit status 7 before it answered 'hello'"
    );
    Ok(())
}

#[test]
fn it_ends_in_the_middle() -> Outcome {
    for (does, ended) in [
        ("exit 0", Ended::Exit(0)),
        ("kill -9 $$", Ended::Killed),
        ("exec >/dev/null", Ended::Closed),
        // A line that is cut off is no answer.
        (r#"printf '{"n":3'; exit 1"#, Ended::Exit(1)),
    ] {
        let (word, cycle, trouble) = stopped(&in_cycle_3(does))?;
        assert_eq!((word, cycle), ("plant: ended", 4), "{does}");
        assert_eq!(trouble, PlantError::Ended { to: TO, ended }, "{does}");
    }
    // One that has answered before it goes is missed in the next cycle.
    let (_, cycle, trouble) = stopped(&in_cycle_3(&format!("{ECHO}; exit 2")))?;
    assert_eq!(cycle, 5);
    assert_eq!(
        trouble,
        PlantError::Ended {
            to: Head::Cycle(4),
            ended: Ended::Exit(2)
        }
    );
    Ok(())
}

#[test]
fn it_takes_too_long() -> Outcome {
    let begin = Instant::now();
    let within = SHORT.later;
    let (word, cycle, trouble) = stopped(&in_cycle_3("sleep 60").with_time_limits(SHORT))?;
    assert_eq!((word, cycle), ("plant: no answer", 4));
    assert_eq!(trouble, PlantError::NoAnswer { to: TO, within });
    assert_eq!(
        trouble.to_string(),
        "the external plant has not answered 'cycle 3' within 1 s"
    );
    // The first answer has its own time.
    let first = Duration::from_millis(400);
    let impatient = TimeLimits { first, ..PATIENCE };
    let (_, cycle, trouble) = stopped(&peer("sleep 60", ECHO).with_time_limits(impatient))?;
    assert_eq!(
        (cycle, &trouble),
        (
            0,
            &PlantError::NoAnswer {
                to: Head::Hello,
                within: first
            }
        )
    );
    assert_eq!(
        trouble.to_string(),
        "the external plant has not answered 'hello' within 0.4 s; it has to read version 2 of the protocol, which has \
         JSON lines: see docs/external-plant.md"
    );
    assert!(
        begin.elapsed() < Duration::from_secs(30),
        "they were not waited for"
    );
    let patient = TimeLimits {
        later: SHORT.later,
        ..PATIENCE
    };
    let slow = peer(&format!("sleep 1.5; {}", ready()), ECHO).with_time_limits(patient);
    run(NOD, &slow)?.to_end(Limit::cycles(1));
    Ok(())
}

#[test]
fn it_does_not_read() -> Outcome {
    // Answers for ever, without looking: the first is right, the others are not.
    let answers = format!(
        "{}; while :; do echo '{{\"n\":0,\"angles\":[1]}}'; done",
        ready()
    );
    let plant = ExternalPlant::new("sh", ["-c", answers.as_str()]).with_time_limits(SHORT);
    let (word, _, _) = stopped(&plant)?;
    assert_eq!(word, "plant: wrong answer");
    // Its input is full, and it says nothing.
    let deaf = ExternalPlant::new("sh", ["-c", "exec sleep 60"]);
    let first = Duration::from_millis(300);
    let (word, _, _) = stopped(&deaf.with_time_limits(TimeLimits { first, ..PATIENCE }))?;
    assert_eq!(word, "plant: no answer");
    Ok(())
}

/// Returns true if a process is there.
fn lives(process: &str) -> bool {
    let asked = Command::new("kill").args(["-0", process]).output();
    asked.is_ok_and(|asked| asked.status.success())
}

/// Waits until a process has ended; one that nobody has waited for counts as ended.
fn ends(process: &str) {
    let begin = Instant::now();
    let lives = || {
        let shown = Command::new("ps")
            .args(["-o", "stat=", "-p", process])
            .output();
        let state = shown.expect("there is ps").stdout;
        !state.is_empty() && !state.starts_with(b"Z")
    };
    while lives() {
        assert!(begin.elapsed() < Duration::from_secs(20), "{process} lives");
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn what_it_started_is_not_left_behind() -> Outcome {
    for does in [
        // The simulator of a pipe; one in the background; one whose parent is gone.
        "sh -c 'echo $$ >&2; exec sleep 300' | cat",
        "sleep 300 & echo $! >&2; wait",
        "sleep 300 & echo $! >&2; exit 1",
    ] {
        let (plant, lines) = heard(in_cycle_3(does).with_time_limits(SHORT));
        let mut run = run(NOD, &plant)?;
        run.to_end(Limit::cycles(4));
        let process = said_first(&lines);
        drop(run);
        ends(&process);
    }
    Ok(())
}

/// Collects the output on its standard error.
fn heard(plant: ExternalPlant) -> (ExternalPlant, Arc<Mutex<Vec<String>>>) {
    let lines = Arc::new(Mutex::new(Vec::new()));
    let into = lines.clone();
    let plant = plant.with_listener(move |line| {
        into.lock().expect("no panic").push(line.to_owned());
    });
    (plant, lines)
}

/// Waits for its first line: its thread is in no hurry.
fn said_first(lines: &Mutex<Vec<String>>) -> String {
    loop {
        if let Some(line) = lines.lock().expect("no panic").first() {
            return line.clone();
        }
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn nothing_is_left_behind() -> Outcome {
    let stuck = "trap '' TERM; exec sleep 60";
    for (does, longest) in [
        (ECHO.to_owned(), 2),
        ("exit 1".to_owned(), 2),
        (stuck.to_owned(), 4),
        (format!("{ECHO}; {stuck}"), 8),
    ] {
        let each = format!("if [ $n = 3 ]; then {does}; else {ECHO}; fi");
        let plant = peer(&format!("echo $$ >&2; {}", ready()), &each).with_time_limits(SHORT);
        let (plant, lines) = heard(plant);
        let mut run = run(NOD, &plant)?;
        run.to_end(Limit::cycles(4));
        let process = said_first(&lines);
        if does == ECHO {
            assert!(lives(&process), "until the run is over");
        }
        let begin = Instant::now();
        drop(run);
        assert!(begin.elapsed() < Duration::from_secs(longest), "{does}");
        assert!(!lives(&process), "{does}");
    }
    Ok(())
}

#[test]
fn it_is_told_good_bye() -> Outcome {
    let last = "while read -r line; do echo \"$line\" >&2; done; echo closed >&2";
    let (plant, lines) = heard(in_cycle_3(&format!("{ECHO}; {last}")));
    let mut run = run(NOD, &plant)?;
    run.to_end(Limit::cycles(4));
    drop(run);
    assert_eq!(
        *lines.lock().expect("no panic"),
        [r#"{"type":"bye"}"#, "closed"]
    );
    Ok(())
}

#[test]
fn it_is_told_of_an_emergency_once() -> Outcome {
    let each =
        format!("{ECHO}; if [ $n = 1 ]; then while read -r line; do echo \"$line\" >&2; done; fi");
    let (plant, lines) = heard(peer(&ready(), &each));
    let mut run = run("DEF_VAR A\nA = 1\nA = 2\nA = 1 / 0\nEND", &plant)?;
    assert!(matches!(run.to_end(Limit::NONE), Ending::Emergency(_)));
    assert_eq!(run.advance(None), Status::Emergency);
    drop(run);
    assert_eq!(
        *lines.lock().expect("no panic"),
        [r#"{"type":"stop","n":2}"#, r#"{"type":"bye"}"#]
    );
    Ok(())
}

#[test]
fn what_it_says_is_passed_on_printable() -> Outcome {
    let says = format!("printf 'a\\033[31mb\\n\\377c\\n' >&2; printf 'no end' >&2; {ECHO}");
    let (plant, lines) = heard(in_cycle_3(&says));
    let mut run = run(NOD, &plant)?;
    run.to_end(Limit::NONE);
    drop(run);
    let lines = lines.lock().expect("no panic");
    assert_eq!(lines.len(), 3, "{lines:?}");
    assert!(
        lines[0].starts_with('a') && lines[0].ends_with("[31mb"),
        "{lines:?}"
    );
    assert!(!lines[0].contains('\u{1b}'), "{lines:?}");
    assert_eq!(lines[1..], ["\u{fffd}c", "no end"]);
    Ok(())
}

/// Someone who has enough after so many questions.
struct Impatient(u32);

impl Observer for Impatient {
    fn goes_on(&mut self) -> bool {
        self.0 = self.0.saturating_sub(1);
        self.0 > 0
    }
}

#[test]
fn an_observer_need_not_wait() -> Outcome {
    let begin = Instant::now();
    let mut run = run(NOD, &peer("sleep 60", ECHO))?;
    let ending = run.observed(Limit::NONE, &mut Impatient(5));
    assert_eq!((ending, run.cycles()), (Ending::Interrupted, 0));
    assert_eq!(run.plant_error(), None);
    drop(run);
    assert!(begin.elapsed() < Duration::from_secs(10));
    Ok(())
}

#[test]
fn a_copy_has_no_process() -> Outcome {
    let mut run = run(NOD, &peer(&ready(), ECHO))?;
    run.to_end(Limit::cycles(2));
    let mark = run.snapshot();
    let mut copy = run.clone();
    let why = |run: &Run| run.emergency().map(|emergency| emergency.fault);
    let without = Some(Fault::Hardware(HardwareFault::new(
        "plant: a copy has no process",
    )));
    assert_eq!(copy.cycle().status, Status::Emergency);
    assert_eq!(
        (why(&copy), copy.plant_error()),
        (without, Some(&PlantError::Copy))
    );
    // The run itself goes on, until it is taken back.
    assert_eq!(run.cycle().status, Status::Running);
    run.restore(&mark);
    assert_eq!(run.cycle().status, Status::Emergency);
    assert_eq!(why(&run), without);
    Ok(())
}
