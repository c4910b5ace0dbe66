//! Recordings of runs and of traces.

use std::fs;
use std::path::Path;
use tip_runtime::command::{Flag, Target};
use tip_runtime::controller::Mode;
use tip_runtime::model::Part;
use tip_runtime::plant::{Scene, Simulation};
use tip_runtime::record::{JsonLines, MotionRecord};
use tip_sim::{Events, FallKind, Interpreter, Robot, Run, tipc};
use tip_view::{DurationLimit, Occurrence, Outcome, Recording};
use tipc::Loaded;

fn example(path: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    fs::read_to_string(root.join("examples").join(path)).expect("the example is there")
}

fn loaded(text: &str, robot: &Robot) -> Loaded {
    let loaded = tipc::load("test.prg", text.as_bytes(), &robot.options());
    assert!(loaded.program.is_some(), "{:?}", loaded.diagnostics);
    loaded
}

fn titan() -> Robot {
    Robot::named("titan8").expect("it has a name")
}

fn hand() -> Robot {
    let hand = Robot::named("hand").expect("it has a name");
    let scene = example("grasp/scene.toml");
    let scene = tipc::description::parse_scene("scene.toml", scene.as_bytes());
    hand.with_scene(&scene.expect("a scene"))
        .expect("it grasps")
}

fn record(text: &str, robot: &Robot, events: &str, limit: DurationLimit) -> Recording {
    let events: Events = events.parse().expect("events");
    Recording::of(&loaded(text, robot), robot, &events, limit, || true).expect("it runs")
}

/// The cycles of some occurrences, each with a value.
macro_rules! entries {
    ($recording:expr, $pattern:pat => $value:expr) => {{
        let entries = $recording.entries(|what| match what {
            $pattern => Some($value),
            _ => None,
        });
        entries.collect::<Vec<_>>()
    }};
}

const LONG: DurationLimit = DurationLimit::minutes(10.0);

/// The trace of the same run, with its motion.
fn trace(text: &str, robot: &Robot, events: &str) -> String {
    let program = loaded(text, robot).program.expect("a program");
    let run = Run::new(Interpreter::new(program), robot.clone()).expect("its robot");
    let mut run = run.events(events).expect("events");
    let mut lines = JsonLines::new(String::new(), false).with_motion();
    while run.ending().is_none() {
        run.advance(Some(&mut lines));
        let limbs = run.limbs().expect("limbs");
        lines.motion(&MotionRecord {
            pose: run.pose(),
            motion: run.motion(),
            joints_per_leg: limbs.angles[0].len(),
            angles: &limbs.angles.concat(),
            loads: &limbs.loads,
            clearance: run.clearance(),
        });
    }
    lines.end(run.ending().expect("it ended"), run.cycles());
    lines.into_inner()
}

#[test]
fn each_thing_is_kept_in_its_cycle() {
    let text = "3.1\nEverything\nDEF_VAR COUNT\nDEF_POS P\nCOUNT = 1\nMESSAGE count is %COUNT%\nLAMP_ON 2\nSLEEP 100\nCOUNT = 2\nP.Y = 0.5\n\
                MESSAGE_CLEAR\nLAMP_OFF 2\nPTP_ANGLE J11 P.Y\nEXIT\nEND\n";
    let recording = record(text, &titan(), "3:key F", LONG);
    // 100 ms are 5 cycles of SLEEP: cycles 3 to 7.
    let steps = entries!(recording, Occurrence::Step(step) => *step);
    assert_eq!(steps[..5], [(0, 0), (1, 1), (2, 2), (3, 3), (8, 4)]);
    assert_eq!(recording.script.lines[3..5], [8, 9]);
    assert_eq!(recording.cycles, 14);
    let said = entries!(recording, Occurrence::Message(text) => text.as_str());
    assert_eq!(said, [(1, "count is 1"), (10, "")]);
    let names = &recording.script.scalars;
    let sets =
        entries!(recording, Occurrence::Assigned { scalar, value } => (&*names[*scalar], *value));
    assert_eq!(
        sets,
        [(0, ("COUNT", 1.0)), (8, ("COUNT", 2.0)), (9, ("P.Y", 0.5))]
    );
    let lamps = entries!(recording, Occurrence::Lamp(device, on) => (*device, *on));
    assert_eq!(lamps, [(2, (2, true)), (11, (2, false))]);
    let commands = entries!(recording, Occurrence::Command(command) => command.op.name());
    assert_eq!(commands, [(12, "PTP_ANGLE")]);
    assert!(recording.log.is_sorted_by_key(|entry| entry.cycle));
    assert_eq!(
        recording.events,
        "3:key F".parse::<Events>().expect("events").all()
    );
    assert_eq!(recording.outcome, Outcome::Program("EXIT".to_owned()));
    assert_eq!((recording.time(1), recording.time(14)), (20.0, 280.0));
}

#[test]
fn what_events_set_is_kept_and_the_first_step_that_reads_it() {
    // A step is a cycle; that of cycle 5, in line 9, reads A for the first time after the event, besides a message. Nothing reads B.
    let text = "3.1\nReads\nDEF_VAR A, B\nA = 1\nB = 0\nREM\nREM\nMESSAGE %A%\nB = A\nB = A\nEND\n";
    let recording = record(text, &titan(), "1:set A=5, 2:set B=7", LONG);
    let names = &recording.script.scalars;
    let reads = entries!(recording, Occurrence::Read { scalar, line } => (&*names[*scalar], *line));
    assert_eq!(reads, [(5, ("A", 9))]);
    let sets =
        entries!(recording, Occurrence::Assigned { scalar, value } => (&*names[*scalar], *value));
    let expected = [
        (0, ("A", 1.0)),
        (1, ("B", 0.0)),
        (1, ("A", 5.0)),
        (2, ("B", 7.0)),
        (5, ("B", 5.0)),
    ];
    assert_eq!(sets, expected);
    assert!(recording.log.is_sorted_by_key(|entry| entry.cycle));
    // Without a change nothing is kept.
    let recording = record(text, &titan(), "", LONG);
    assert!(entries!(recording, Occurrence::Read { .. } => ()).is_empty());
}

#[test]
fn motion_is_kept_at_50_hz_and_at_the_end() {
    let grasp = example("grasp/motions/grasp.prg");
    let recording = record(&grasp, &hand(), "", DurationLimit::cycles(505));
    let cycles: Vec<_> = recording.frames.iter().map(|frame| frame.cycle).collect();
    // 2 ms a cycle: every tenth of them, and the last one.
    assert_eq!(cycles[..3], [0, 10, 20]);
    assert_eq!(cycles[cycles.len() - 2..], [500, 504]);
    assert_eq!(recording.outcome, Outcome::Limit);
    let last = recording.frames.last().expect("frames");
    assert_eq!(
        (last.objects.len(), last.pushes.len(), last.pose),
        (1, 3, None)
    );
    assert!(
        last.slider.is_some_and(|at| at[1] < -130.0),
        "{:?}",
        last.slider
    );
}

#[test]
fn time_ends_a_recording_and_so_does_an_interruption() {
    let endless = "3.1\nEndless\nAGAIN:\nGOTO AGAIN:\nEND\n";
    let recording = record(endless, &titan(), "", DurationLimit::minutes(0.1));
    assert_eq!((recording.cycles, recording.outcome), (300, Outcome::Limit));
    let mut cycles = 0;
    let seven = || {
        cycles += 1;
        cycles <= 7
    };
    let robot = titan();
    let loaded = loaded(endless, &robot);
    let recording = Recording::of(&loaded, &robot, &Events::NONE, LONG, seven).expect("it runs");
    assert_eq!(
        (recording.cycles, recording.outcome),
        (7, Outcome::Interrupted)
    );
}

#[test]
fn another_sampling_time_moves_the_clock() {
    let text = "3.1\nSlower\nREM\nSET_SAMPLING_TIME 50\nREM\nREM\nEND\n";
    let recording = record(text, &titan(), "", LONG);
    let ticks = recording
        .clock
        .iter()
        .map(|tick| (tick.cycle, tick.time, tick.period));
    let ticks: Vec<_> = ticks.collect();
    // END gives back what the program set as soon as the robot is at rest, here in its own cycle.
    assert_eq!(ticks, [(0, 0.0, 20.0), (1, 20.0, 50.0), (4, 170.0, 20.0)]);
    let ends = recording.frames.iter().map(|frame| frame.time);
    let begins = (1..=recording.cycles).map(|cycle| recording.time(cycle));
    assert!(
        ends.eq(begins),
        "each cycle begins where the one before ended"
    );
}

#[test]
fn the_cycle_of_a_fault_takes_as_long_as_others() {
    // The key is typed before the step of cycle 3, which does not run any more.
    let text = "3.1\nStops\nAGAIN:\nREM\nGOTO AGAIN:\nEND\n";
    let recording = record(text, &titan(), "3:key 0x0D", LONG);
    assert!(recording.outcome.is_emergency());
    let periods: Vec<_> = recording.clock.iter().map(|tick| tick.period).collect();
    assert_eq!(periods, [20.0]);
}

#[test]
fn falls_slips_and_contacts_are_noticed() {
    // Two feet of one side go up: the body tips over them.
    let text = "3.1\nTips\nSTAND_UP 60\nWAIT_INPOS ALL\nPTP F1 -391 201 -60\nPTP F3 -391 -201 -60\nWAIT_INPOS ALL\nEND\n";
    let recording = record(text, &titan(), "", LONG);
    let falls =
        entries!(recording, Occurrence::Fall { count, margin, kind } => (*count, *margin, *kind));
    let [(fallen, (1, margin, Some(FallKind::WouldFall)))] = falls[..] else {
        panic!("{falls:?}")
    };
    assert!(margin < 0.0);
    let contacts = entries!(recording, Occurrence::Contacts(touch) => !touch[0] && !touch[2]);
    assert!(contacts.iter().any(|(_, both)| *both) || fallen > 0);
    // One foot that stands is sent sideways: it, or the others, must give way.
    let text = "3.1\nSlips\nSTAND_UP 60\nWAIT_INPOS ALL\nREL_PTP F1 40 0 0\nWAIT_INPOS ALL\nEND\n";
    let recording = record(text, &titan(), "", LONG);
    // A slip is where the signal passes 5 mm; each cycle has a frame.
    let slips = entries!(recording, Occurrence::Slip { leg, distance } => (*leg, *distance));
    let frames = recording.frames.windows(2);
    let passing = frames.flat_map(|pair| {
        let both = pair[0].slips.iter().zip(&pair[1].slips).enumerate();
        let passing = both.filter(|(_, (before, now))| **before <= 5.0 && **now > 5.0);
        passing.map(|(leg, (_, now))| (pair[1].cycle, (leg, *now)))
    });
    assert!(!slips.is_empty());
    assert!(passing.eq(slips), "they only grow");
    // The signal and the summary have one largest slip.
    let signal = recording.frames.iter().flat_map(|frame| &frame.slips);
    let largest = recording.summary.slip.as_ref().expect("a slip").value;
    assert_eq!(signal.copied().fold(0.0, f64::max), largest);
    let walk = record(&example("walk/motions/walk.prg"), &titan(), "", LONG);
    assert!(entries!(walk, Occurrence::Fall { .. } | Occurrence::Slip { .. } => ()).is_empty());
}

#[test]
fn a_trace_gives_the_recording_of_its_run() {
    let hexapod = Robot::from_description(&example("six-legs/hexapod.toml")).expect("a robot");
    let slower = "3.1\nSlower\nSET_SAMPLING_TIME 7\nPTP_ANGLE J11 9\nSLEEP 300\nLAMP_ON 1\nEND\n";
    for (text, robot, events) in [
        (example("walk/motions/walk.prg"), titan(), "900:halt"),
        (example("six-legs/motions/tripod.prg"), hexapod, ""),
        (example("grasp/motions/grasp.prg"), hand(), ""),
        (CROSSING.to_owned(), titan(), ""),
        (slower.to_owned(), titan(), ""),
        (
            "3.1\nFails\nREM\nPTP F1 0 0 0\nEND\n".to_owned(),
            titan(),
            "",
        ),
    ] {
        let mut expected = record(&text, &robot, events, LONG);
        let trace = trace(&text, &robot, events);
        let read = Recording::from_trace(&trace, &loaded(&text, &robot), &robot).expect("a trace");
        // What a trace does not say, and the cycle of an emergency, of which it has no record.
        expected.events.clear();
        expected
            .frames
            .retain(|frame| frame.cycle < expected.cycles);
        expected.clock.retain(|tick| tick.cycle < expected.cycles);
        for frame in &mut expected.frames {
            frame.torques.clear();
            frame.objects.clear();
            frame.pushes.clear();
            frame.slider = None;
        }
        assert_eq!(read.frames.len(), expected.frames.len());
        for (read, expected) in read.frames.iter().zip(&expected.frames) {
            let late = read.time - expected.time;
            assert!(late.abs() < 1e-6, "{text}: cycle {}, {late} ms", read.cycle);
            assert_eq!(
                (read.cycle, read.pose, &read.angles),
                (expected.cycle, expected.pose, &expected.angles)
            );
            assert_eq!(
                (read.margin, read.gap, &read.loads),
                (expected.margin, expected.gap, &expected.loads)
            );
        }
        assert_eq!(read.outcome, expected.outcome);
        // Contacts go on in the cycle of an emergency. The plant has the same slips on its floor, but for rounding.
        let told = |recording: &Recording| {
            let mut told = entries!(recording, what @ (
                Occurrence::Step(_) | Occurrence::Message(_) | Occurrence::Assigned { .. } | Occurrence::Lamp(..)
                | Occurrence::Command(_) | Occurrence::Fall { .. } | Occurrence::Collision(_) | Occurrence::Slip { .. }) => what.clone());
            for (_, what) in &mut told {
                match what {
                    Occurrence::Slip { distance, .. } => *distance = distance.round(),
                    Occurrence::Fall { kind, .. } => *kind = None,
                    _ => {}
                }
            }
            told
        };
        assert_eq!(told(&read), told(&expected));
        let figures = |recording: &Recording| {
            (
                recording.summary.clearance.clone(),
                recording.summary.collisions,
            )
        };
        assert_eq!(figures(&read), figures(&expected));
        assert_eq!(
            (read.cycles, read.clock.len()),
            (expected.cycles, expected.clock.len())
        );
    }
}

/// Both legs on the left turn towards each other and back again: their thighs cross, and part.
const CROSSING: &str = "3.1\nCrosses\nPTP_ANGLE J11 -55\nPTP_ANGLE J31 55\nSLEEP 2000\nPTP_ANGLE J11 0\nPTP_ANGLE J31 0\nSLEEP 2000\nEND\n";

#[test]
fn a_collision_is_kept_from_its_first_cycle_to_its_last() {
    let recording = record(CROSSING, &titan(), "", LONG);
    let found = entries!(recording, Occurrence::Collision(parts) => *parts);
    let [(begin, Some(parts)), .., (end, None)] = found[..] else {
        panic!("{found:?}")
    };
    // Links of F1 and F3, which the program turns.
    assert!(
        matches!(parts, [Part::Link(3, _), Part::Link(1, _)]),
        "{parts:?}"
    );
    assert!(
        found[..found.len() - 1]
            .iter()
            .all(|(_, parts)| parts.is_some())
    );
    // Frames are sampled in each cycle of 20 ms: those between overlap, and no others.
    for frame in &recording.frames {
        let gap = frame.gap.expect("its links are compared");
        let is_within = (begin..end).contains(&frame.cycle);
        assert_eq!(gap.distance < 0.0, is_within, "{gap:?} in {}", frame.cycle);
    }
    let collisions = recording.summary.collisions.expect("they are counted");
    assert_eq!(u64::from(collisions.cycles), end - begin);
    assert_eq!(collisions.first.map(|first| first.cycle), Some(begin));
    let least = recording.summary.clearance.as_ref().expect("measured");
    let deepest = recording.frames.iter().filter_map(|frame| frame.gap);
    let deepest = deepest.map(|gap| gap.distance).fold(0.0, f64::min);
    assert_eq!((least.value, least.unit), (deepest, "mm"));
    let pages = recording.updates();
    let [one, other] = parts;
    assert!(
        pages.contains(&format!(r#"["{one}","{other}"]"#)),
        "the page names them"
    );
    assert!(
        pages.contains(r#""clearance""#),
        "the page plots the distance"
    );
}

#[test]
fn a_robot_that_stays_apart_has_no_collisions() {
    let recording = record("3.1\nStands\nSLEEP 200\nEND\n", &titan(), "", LONG);
    assert_eq!(
        entries!(recording, Occurrence::Collision(parts) => parts),
        []
    );
    let collisions = recording.summary.collisions.expect("they are counted");
    assert_eq!((collisions.cycles, collisions.first), (0, None));
}

#[test]
fn flags_and_modes_are_kept_where_they_change() {
    // SLEEP takes cycles 0 to 4.
    let text = "3.1\nModes\nSLEEP 100\nPTP_ANGLE J11 3\nSLEEP 100\nEND\n";
    let recording = record(text, &titan(), "2:key F", LONG);
    let flags = entries!(recording, Occurrence::Flags(flags) => flags.contains(&Flag::KbHit));
    let hit = flags.iter().find(|(_, is_hit)| *is_hit).expect("a key");
    assert_eq!((flags[0].0, hit.0), (0, 2));
    let modes = entries!(recording, Occurrence::Modes(modes) => modes);
    let [(0, before), (5, after)] = modes[..] else {
        panic!("{modes:?}")
    };
    assert_eq!((before.len(), after.len()), (12, 12));
    assert!(before.iter().all(|(_, mode)| *mode == Mode::Rest));
    assert_eq!(after[0], (Target::Joint(1, 1), Mode::Position));
    assert_eq!(after[1..], before[1..]);
}

#[test]
fn forces_are_known_of_a_robot_with_mass() {
    let text = "3.1\nPushes\nPTP_ANGLE J11 5\nSLEEP 1000\nEND\n";
    let of = |simulation| {
        let mut scene = Scene::EMPTY;
        scene.plant = Some(simulation);
        let robot = titan().with_scene(&scene).expect("it walks there");
        record(text, &robot, "", LONG).frames
    };
    assert!(
        of(Simulation::QuasiStatic)
            .iter()
            .all(|frame| frame.forces.is_empty())
    );
    let frames = of(Simulation::Dynamic);
    let feet = || {
        frames
            .iter()
            .flat_map(|frame| frame.forces.iter().zip(&frame.loads))
    };
    assert_eq!(feet().count(), 4 * frames.len());
    // On a level floor what stands up is what it carries.
    assert!(feet().all(|(force, load)| force[2] == *load));
    let mut across = feet().map(|([x, y, _], load)| (libm::hypot(*x, *y), *load));
    assert!(
        across
            .clone()
            .all(|(across, load)| across <= 0.5 * load + 1e-9)
    );
    assert!(across.any(|(across, _)| across > 1.0));
}

#[test]
fn what_is_no_trace_is_refused_with_a_reason() {
    let robot = titan();
    let loaded = loaded("3.1\nShort\nEND\n", &robot);
    let refused = |trace: &str| {
        let refused = Recording::from_trace(trace, &loaded, &robot).expect_err("it is none");
        refused.to_string()
    };
    assert!(refused("{\"cycle\":0,\"step\":0}\n").contains("--trace-motion"));
    assert!(refused("").contains("--trace-motion"));
    assert!(refused("{\"cycle\":0,\"step\":0}\nhello\n").starts_with("line 2 is not a record"));
    assert!(refused("{\"cycle\":0,\"step\":9}\n").ends_with("no step 9"));
    assert!(refused("{\"cycle\":-1}").starts_with("line 1"));
    // TITAN VIII has four legs with three joints each.
    let of = |limbs: &[&str]| {
        let angles = limbs.join(",");
        let trace = format!("{{\"cycle\":0,\"step\":0,\"angles\":[{angles}]}}\n");
        let read = Recording::from_trace(&trace, &loaded, &robot);
        read.map_err(|error| error.to_string())
    };
    let refused = |limbs: &[&str]| of(limbs).expect_err("another robot");
    let six = refused(&["[0,0,0]"; 6]);
    assert!(six.contains(
        "line 1 has the angles of 6 limbs of 3 joints, and this robot has 4 limbs of 3 joints"
    ));
    let uneven = refused(&["[0,0,0]", "[0,0,0]", "[0,0]", "[0,0,0]"]);
    assert!(uneven.contains("4 limbs of 3, 3, 2, 3 joints"));
    assert!(of(&["[0,0,0]"; 4]).is_ok());
}

#[test]
fn a_damaged_trace_is_refused_and_a_cut_one_has_no_known_end() {
    let moves = "3.1\nMoves\nPTP_ANGLE J11 3\nSLEEP 60\nEND\n";
    let fails = "3.1\nFails\nPTP_ANGLE J11 3\nSLEEP 60\nPTP F1 0 0 0\nEND\n";
    let robot = titan();
    for text in [moves, fails] {
        let loaded = loaded(text, &robot);
        let whole = trace(text, &robot, "");
        let lines: Vec<&str> = whole.split_inclusive('\n').collect();
        let end = lines.len() - 1;
        let read = |trace: &str| Recording::from_trace(trace, &loaded, &robot);
        let outcome = read(&whole).expect("a trace").outcome;
        assert_ne!(outcome, Outcome::Unknown);
        let refused = |lines: &[&[&str]], expected: &str| {
            let error = read(&lines.concat().concat())
                .expect_err(expected)
                .to_string();
            assert!(error.starts_with(expected), "{error}");
        };
        refused(&[&lines[1..]], "line 1 is of cycle 1 where cycle 0 follows");
        refused(
            &[&lines[..2], &lines[3..]],
            "line 3 is of cycle 3 where cycle 2 follows",
        );
        refused(
            &[&lines[..3], &lines[2..]],
            "line 4 is of cycle 2 where cycle 3 follows",
        );
        refused(
            &[&lines[..1], &lines[2..3], &lines[1..2], &lines[3..]],
            "line 2 is of cycle 2 where cycle 1 follows",
        );
        let short = format!(
            "line {end} ends a trace of {end} cycles, and {} are",
            end - 1
        );
        refused(&[&lines[..end - 1], &lines[end..]], &short);
        let after = format!("line {} comes after the end", end + 2);
        refused(&[&lines, &lines[end..]], &after);
        refused(&[&lines, &lines[..1]], &after);
        // Cut between two lines, and within one.
        let cut = lines[..3].concat();
        for cut in [&cut[..], &cut[..cut.len() - 9]] {
            let read = read(cut).expect("a part of a trace");
            assert_eq!(read.outcome, Outcome::Unknown);
            assert_eq!(read.cycles, cut.matches('\n').count() as u64);
        }
    }
    // In the cycle of an emergency, steps before the one that failed have records.
    let several = "3.2\nSeveral\nTIP_SPEED_UP 3\nPTP_ANGLE J11 3\nSLEEP 60\nLAMP_ON 1\nLAMP_ON 2\nPTP F1 0 0 0\nEND\n";
    let whole = trace(several, &robot, "");
    assert!(whole.contains("\"sub\":1"), "{whole}");
    let read = |trace: &str| Recording::from_trace(trace, &loaded(several, &robot), &robot);
    assert!(read(&whole).expect("a trace").outcome.is_emergency());
    let second = whole.lines().position(|line| line.contains("\"sub\":1"));
    let doubled = whole
        .lines()
        .enumerate()
        .flat_map(|(at, line)| std::iter::repeat_n(line, 1 + usize::from(Some(at) == second)));
    let doubled: Vec<&str> = doubled.collect();
    let error = read(&doubled.join("\n")).expect_err("a record twice");
    assert!(
        matches!(error, tip_view::TraceError::Cycle { .. }),
        "{error}"
    );
    // A run that was stopped from outside has its last record.
    let stopped = trace(moves, &robot, "2:halt");
    let read = Recording::from_trace(&stopped, &loaded(moves, &robot), &robot).expect("a trace");
    assert_ne!(read.outcome, Outcome::Unknown);
    let interrupted = stopped.replace("\"end\":\"END\"", "\"end\":\"INTERRUPTED\"");
    let read =
        Recording::from_trace(&interrupted, &loaded(moves, &robot), &robot).expect("a trace");
    assert_eq!(read.outcome, Outcome::Interrupted);
}

/// The main program runs lines 4 to 11 in cycles 0 to 7; its thread lines 12 to 14 in cycles 3 to 5.
const THREAD: &str = "3.2\nTwo\nDEF_VAR N\nSTART_TIMER 2\nN = 0\nSTART_THREAD SIDE:\nN = 1\nSTOP_TIMER 2\nN = 2\nUNLOCK ALL\nEXIT\n\
                      THREAD SIDE:\nLOCK J21\nTHREADEND\nEND\n";

#[test]
fn threads_timers_and_locks_are_kept_where_they_change() {
    let recording = record(THREAD, &titan(), "", LONG);
    let steps = |recording: &Recording| {
        let thread = entries!(recording, Occurrence::Thread(thread, step) => (*thread, *step));
        (thread, entries!(recording, Occurrence::Step(step) => *step))
    };
    let (threads, main) = steps(&recording);
    // THREAD, LOCK and THREADEND are steps 8 to 10.
    let (start, lock, end) = ((1, Some(8)), (1, Some(9)), (1, Some(10)));
    assert_eq!(threads, [(3, start), (4, lock), (5, end), (6, (1, None))]);
    assert_eq!(recording.script.threads, ["SIDE"]);
    let timers =
        entries!(recording, Occurrence::Timer { number, runs, time } => (*number, *runs, *time));
    // It was 0 at 0 ms; STOP_TIMER in cycle 4 leaves the growth of four cycles.
    assert_eq!(timers, [(0, (2, true, 0.0)), (4, (2, false, 80.0))]);
    let locks = entries!(recording, Occurrence::Locks(locks) => locks.clone());
    assert_eq!(locks, [(4, vec![Target::Joint(2, 1)]), (6, vec![])]);
    // A trace has threads only.
    let trace = trace(THREAD, &titan(), "");
    let read = Recording::from_trace(&trace, &loaded(THREAD, &titan()), &titan()).expect("a trace");
    assert_eq!(steps(&read), (threads, main));
    // Pages are told of them where there are any.
    let reported = recording.updates();
    for part in [
        r#""threads":["SIDE"]"#,
        r#""thread.1":[[3,1,1,1],[8,9,10,null]]"#,
        r#""timer.2":[[0,4],[[true,0.0],[false,80.0]]]"#,
        r#""locks":[[4,2],["J21",""]]"#,
    ] {
        assert!(reported.contains(part), "{part} is not in {reported}");
    }
    let old = record("3.1\nOld\nDEF_VAR N\nN = 1\nEND\n", &titan(), "", LONG).updates();
    for word in ["thread", "timer", "locks"] {
        assert!(!old.contains(&format!("\"{word}")), "{word}");
    }
}
