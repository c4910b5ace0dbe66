//! Runs of programs on simulated robots.

use std::error::Error;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use tip_runtime::command::{Op, Port, Target, Value};
use tip_runtime::console::Transcript;
use tip_runtime::fault::{Fault, HardwareFault};
use tip_runtime::hardware::{Hardware, Outputs, Sensors};
use tip_runtime::machine::Status;
use tip_runtime::model::titan8;
use tip_runtime::plant::{self, SimulatedPlant};
use tip_runtime::program::End;
use tip_runtime::record::{Cycle, Ending, Sink};
use tip_sim::{
    Event, IssuedCommand, Limit, Observer, Plant, ProgramRunner, Refused, Replacement, Robot, Run,
    WaitCircle, WaitDetector, load, message::Awaited,
};

type Outcome = Result<(), Box<dyn Error>>;

fn run_on(robot: &str, statements: &str) -> Result<Run, Box<dyn Error>> {
    let robot = Robot::named(robot)?;
    let program = load("p.prg", &format!("3.1\nt\n{statements}\n"), &robot)?;
    Ok(Run::new(program, robot)?)
}

/// A run of edition 3.2 on TITAN VIII.
fn later(statements: &str) -> Result<Run, Box<dyn Error>> {
    let robot = Robot::named("titan8")?;
    let program = load("p.prg", &format!("3.2\nt\n{statements}\n"), &robot)?;
    Ok(Run::new(program, robot)?)
}

fn fault(run: &Run) -> Option<Fault> {
    run.emergency().map(|emergency| emergency.fault)
}

#[test]
fn a_program_runs_to_its_end_and_leaves_a_trace() -> Outcome {
    let mut run =
        run_on("generic", "DEF_VAR A\nA = 2\nMESSAGE a is %A%\nEXIT\nEND")?.with_trace(false);
    assert_eq!(run.to_end(Limit::NONE), Ending::Program(End::Exit));
    assert_eq!(
        run.trace(),
        "{\"cycle\":0,\"step\":0,\"next\":1,\"set\":{\"A\":2.0}}\n\
         {\"cycle\":1,\"step\":1,\"next\":2,\"say\":\"a is 2\"}\n\
         {\"cycle\":2,\"step\":2}\n\
         {\"end\":\"EXIT\",\"cycles\":3}\n"
    );
    // Its end is its end.
    assert_eq!(run.to_end(Limit::NONE), Ending::Program(End::Exit));
    assert_eq!(run.cycles(), 3);
    Ok(())
}

#[test]
fn a_limit_ends_a_run_until_it_is_let_go_on() -> Outcome {
    let mut run = run_on("titan8", "L:\nGOTO L:\nEND")?.with_trace(false);
    assert_eq!(run.to_end(Limit::cycles(1)), Ending::Limit);
    assert!(run.trace().ends_with("{\"end\":\"LIMIT\",\"cycles\":1}\n"));
    assert_eq!(run.to_end(Limit::cycles(2)), Ending::Limit);
    assert_eq!(run.trace().lines().count(), 3);
    Ok(())
}

#[test]
fn a_cycle_tells_what_its_step_did() -> Outcome {
    let mut run = run_on(
        "titan8",
        "DEF_VAR A\nA = -1\nPTP_ANGLE F1 R 0 R 1 R 0\nLAMP_ON 3\nMESSAGE hi\nEND",
    )?;
    let set = run.cycle();
    assert_eq!((set.number, set.step, set.next), (0, Some(0), Some(1)));
    assert_eq!((set.time, set.set), (0.0, vec![("A".to_owned(), -1.0)]));
    let asked = run.cycle();
    let expected = IssuedCommand {
        op: Op::PtpAngle,
        hs: false,
        target: Target::Foot(1),
        values: [0.0, 1.0, 0.0].map(Value::Relative).to_vec(),
    };
    assert_eq!(asked.commands, [expected]);
    // The sampling time is 20 ms.
    assert_eq!((asked.time, asked.set), (20.0, vec![]));
    assert_eq!(run.cycle().lamps, [(3, true)]);
    assert!(run.lamp(3) && !run.lamp(2));
    let said = run.cycle();
    assert_eq!(said.messages, ["hi"]);
    assert_eq!(said.state, run.state_hash());
    assert_eq!(said.pose, run.motion().map(|motion| motion.pose));
    let last = run.cycle();
    assert_eq!((last.next, last.status), (None, Status::Finished(End::End)));
    let held = run.cycle();
    assert_eq!((held.number, held.step), (5, None));
    Ok(())
}

#[test]
fn a_failing_cycle_has_no_step() -> Outcome {
    let mut run = run_on("titan8", "DEF_VAR A\nA = 0\nA = 1 / A\nEND")?;
    run.cycle();
    let failed = run.cycle();
    assert_eq!((failed.step, failed.status), (None, Status::Emergency));
    assert_eq!(fault(&run), Some(Fault::Domain));
    assert_eq!(run.cycles(), 1);
    Ok(())
}

const LISTEN: &str =
    "DEF_VAR V\nL:\nAD_IN VR1 V\nIF HALT_REQUEST GOTO M:\nGOTO L:\nM:\nKEY_IN\nEND";

#[test]
fn events_come_before_the_step_of_their_cycle() -> Outcome {
    let mut run = run_on("titan8", LISTEN)?.events("1:VR1=8, 9:key f, 5:VR1=3, 9:key g, 6:halt")?;
    let read = |run: &mut Run| run.cycle().set;
    assert_eq!(read(&mut run), []);
    assert_eq!(read(&mut run), [("V".to_owned(), 8.0)]);
    run.to_end(Limit::cycles(5));
    assert_eq!(read(&mut run), [("V".to_owned(), 3.0)]);
    // In cycle 6 IF finds the halt request, the label M is step 4, and KEY_IN waits in cycle 8.
    assert_eq!(run.cycle().next, Some(4));
    assert_eq!(run.cycle().next, Some(5));
    assert_eq!(run.cycle().next, Some(5));
    assert_eq!(run.cycle().set, [("VAR_KEY".to_owned(), f64::from(b'F'))]);
    assert_eq!(run.to_end(Limit::NONE), Ending::Program(End::End));
    Ok(())
}

const DOUBLE: &str = "DEF_VAR STRIDE, TWICE\nSTRIDE = 1\nL:\nTWICE = STRIDE * 2\nGOTO L:\nEND";

#[test]
fn a_host_sets_variables_between_cycles() -> Outcome {
    // Step 2 runs in the cycles 2, 5, 8 …
    let mut run = run_on("titan8", DOUBLE)?
        .events("4:set STRIDE=10")?
        .with_trace(false);
    run.to_end(Limit::cycles(4));
    // The write itself is none of the step's.
    assert_eq!(run.cycle().set, []);
    assert_eq!(run.cycle().set, [("TWICE".to_owned(), 20.0)]);
    let mark = run.snapshot();
    run.set("STRIDE", -3.0)?;
    run.to_end(Limit::cycles(8));
    assert_eq!(run.cycle().set, [("TWICE".to_owned(), -6.0)]);
    run.restore(&mark);
    run.to_end(Limit::cycles(8));
    assert_eq!(run.cycle().set, [("TWICE".to_owned(), -6.0)]);
    assert_eq!(run.trace().matches("STRIDE").count(), 1);
    for (name, value) in [("SPEED", 1.0), ("CHAR_A", 1.0), ("STRIDE", f64::NAN)] {
        let refused = run.set(name, value);
        assert!(matches!(refused, Err(Refused::Variable(..))), "{name}");
    }
    Ok(())
}

#[test]
fn a_replaced_constant_is_in_the_trace_and_in_copies_of_the_run() -> Outcome {
    let robot = Robot::named("generic")?;
    let program = load("p.prg", "3.1\nt\nDEF_VAR A B\nA = 2\nB = A\nEND\n", &robot)?;
    let replacement = Replacement {
        scalar: 1,
        value: 7.0,
        steps: vec![0],
    };
    let program = ProgramRunner::new(program).with_replacements([replacement]);
    let mut run = Run::of(program, &robot)?.with_trace(false);
    let start = run.snapshot();
    let expected = "{\"cycle\":0,\"step\":0,\"next\":1,\"set\":{\"A\":7.0}}\n\
                    {\"cycle\":1,\"step\":1,\"next\":2,\"set\":{\"B\":7.0}}\n\
                    {\"cycle\":2,\"step\":2}\n\
                    {\"end\":\"END\",\"cycles\":3}\n";
    run.to_end(Limit::NONE);
    assert_eq!(run.trace(), expected);
    run.restore(&start);
    let mut copy = run.clone();
    copy.to_end(Limit::NONE);
    assert_eq!(copy.trace(), expected);
    Ok(())
}

#[test]
fn an_event_that_comes_too_late_comes_at_once() -> Outcome {
    let mut run = run_on("titan8", LISTEN)?.events("50:VR1=1")?;
    run.to_end(Limit::cycles(4));
    run.add("0:VR1=9".parse()?)?;
    run.to_end(Limit::cycles(5));
    assert_eq!(run.cycle().set, [("V".to_owned(), 9.0)]);
    Ok(())
}

#[test]
fn failing_hardware_and_the_return_key_stop_the_robot() -> Outcome {
    for (event, expected) in [
        ("3:read fails", Fault::Hardware(HardwareFault::new("read"))),
        (
            "2:write fails",
            Fault::Hardware(HardwareFault::new("write")),
        ),
        ("3:key 0x0D", Fault::EmergencyKey),
    ] {
        let mut run = run_on("titan8", LISTEN)?.events(event)?;
        run.to_end(Limit::cycles(9));
        assert_eq!((fault(&run), run.cycles()), (Some(expected), 3), "{event}");
    }
    Ok(())
}

#[test]
fn soles_feel_a_touch() -> Outcome {
    let text = "DEF_VAR V\nAD_IN PAW2 V\nAD_IN PAW2 V\nAD_IN PAW2 V\nEND";
    for plant in [Plant::Echo, Plant::Simulated] {
        let robot = Robot::named("titan8")?.with_plant(plant);
        let program = load("p.prg", &format!("3.1\nt\n{text}\n"), &robot)?;
        let mut run = Run::new(program, robot)?.events("1:touch on, 2:touch off")?;
        run.cycle();
        assert_eq!(run.cycle().set, [("V".to_owned(), 2.0)]);
        assert_eq!(run.cycle().set, [("V".to_owned(), 0.0)]);
    }
    Ok(())
}

#[test]
fn what_does_not_fit_is_refused() -> Outcome {
    let refused = |text: &str| run_on("generic", "END").map(|run| run.events(text).err());
    let reported = |text: &str| refused(text).map(|error| error.map(|error| error.to_string()));
    assert_eq!(
        reported("3:J99=1")?.as_deref(),
        Some("the robot has no input J99")
    );
    assert!(matches!(refused("nonsense")?, Some(Refused::Text(_))));
    let hand = Robot::named("hand")?;
    let for_hand = load("p.prg", "3.1\nt\nEND\n", &hand)?;
    assert!(Run::new(for_hand, Robot::named("titan8")?).is_err());
    let error = Robot::named("arm").expect_err("no robot").to_string();
    assert!(error.starts_with("'arm' is not a robot"), "{error}");
    let error = load("p.prg", "3.1\nt\nPTP F9 0 0 0\nEND\n", &hand).expect_err("three fingers");
    assert!(error.to_string().contains("p.prg:3:"), "{error}");
    Ok(())
}

/// A walker that counts its copies.
struct Copied {
    plant: SimulatedPlant<4, 3>,
    copies: Arc<AtomicU32>,
}

impl Clone for Copied {
    fn clone(&self) -> Self {
        self.copies.fetch_add(1, Ordering::Relaxed);
        Copied {
            plant: self.plant.clone(),
            copies: Arc::clone(&self.copies),
        }
    }
}

impl Hardware<4, 3> for Copied {
    fn read(&mut self, into: &mut Sensors<4, 3>) -> Result<(), HardwareFault> {
        self.plant.read(into)
    }

    fn write(&mut self, outputs: &Outputs<4, 3>) -> Result<(), HardwareFault> {
        self.plant.write(outputs)
    }

    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault> {
        self.plant.stop(why)
    }
}

impl plant::Plant<4, 3> for Copied {
    fn has_input(&self, port: Port) -> bool {
        self.plant.has_input(port)
    }

    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        self.plant.set_sensor(port, volts)
    }
}

#[test]
fn an_event_is_judged_without_a_copy_and_changes_nothing() -> Outcome {
    let copies = Arc::new(AtomicU32::new(0));
    let plant = Copied {
        plant: SimulatedPlant::new(&titan8::MODEL),
        copies: Arc::clone(&copies),
    };
    let robot = Robot::on(&titan8::MODEL, plant);
    let program = load("p.prg", "3.1\nt\nDEF_VAR N\nN = 1\nEND\n", &robot)?;
    let mut run = Run::new(program, robot)?;
    run.cycle();
    copies.store(0, Ordering::Relaxed);
    let judge = |text: &str| -> Result<_, Box<dyn Error>> {
        let event = text.parse::<Event>()?;
        Ok(run.accepts(&event).err().map(|refused| refused.to_string()))
    };
    // It has four soles, and a step that follows would read any of these.
    for text in [
        "PAW4=1",
        "J43=0",
        "VR3=nan",
        "ANTENNA=5",
        "set n=2",
        "touch on",
        "read fails",
    ] {
        assert_eq!(judge(text)?, None, "{text}");
    }
    for (text, refused) in [
        ("J51=1", "the robot has no input J51"),
        ("J44=0", "the robot has no input J44"),
        ("set M=2", "M: the program has no variable of that name"),
        ("set N=inf", "N: a variable holds finite numbers only"),
        (
            "push 1 0 0 for 2",
            "'push 1 0 0 for 2' is for walking robots with mass: --plant dynamic",
        ),
        (
            "noise 1 0 seed 3",
            "'noise 1 0 seed 3' is for walking robots with mass: --plant dynamic",
        ),
    ] {
        assert_eq!(judge(text)?.as_deref(), Some(refused), "{text}");
    }
    assert_eq!(copies.load(Ordering::Relaxed), 0);
    assert_eq!(run.program().get("N"), Ok(Some(1.0)));
    Ok(())
}

/// Counts what is reported to it, and interrupts.
#[derive(Default)]
struct Counter {
    left: u64,
    reported: Vec<u64>,
    after: u64,
}

impl Sink for Counter {
    fn cycle(&mut self, cycle: &Cycle<'_>) {
        self.reported.push(cycle.sample.cycle);
    }
}

impl Observer for Counter {
    fn goes_on(&mut self) -> bool {
        self.left -= 1;
        self.left > 0
    }

    fn sink(&mut self) -> Option<&mut dyn Sink> {
        Some(self)
    }

    fn after(&mut self, _run: &mut Run) {
        self.after += 1;
    }
}

#[test]
fn an_observer_is_told_each_cycle_once_and_may_interrupt() -> Outcome {
    let mut run = run_on("titan8", "L:\nGOTO L:\nEND")?.with_trace(false);
    let mut counter = Counter {
        left: 4,
        ..Counter::default()
    };
    assert_eq!(run.observed(Limit::NONE, &mut counter), Ending::Interrupted);
    assert_eq!((counter.reported, counter.after), (vec![0, 1, 2], 3));
    assert!(
        run.trace()
            .ends_with("{\"end\":\"INTERRUPTED\",\"cycles\":3}\n")
    );
    Ok(())
}

#[test]
fn a_console_is_shown_what_the_program_shows() -> Outcome {
    let mut run =
        run_on("titan8", "MESSAGE one\nMESSAGE two\nEND")?.with_console(Transcript::default());
    run.to_end(Limit::NONE);
    let shown: &Transcript = run.console().expect("it was given");
    assert_eq!(
        (&shown.messages[..], shown.ended),
        (&["one".to_owned(), "two".to_owned()][..], 1)
    );
    Ok(())
}

#[test]
fn a_run_goes_on_in_another_thread() -> Outcome {
    let mut run = run_on("titan8", "MESSAGE one\nMESSAGE two\nEND")?;
    assert_eq!(run.cycle().messages, ["one"]);
    let there = std::thread::spawn(move || (run.to_end(Limit::NONE), run.cycles())).join();
    assert_eq!(there.ok(), Some((Ending::Program(End::End), 3)));
    Ok(())
}

// clauses: 14.2 14.3
#[test]
fn a_cycle_tells_what_each_of_its_steps_did() -> Outcome {
    let mut run =
        later("TIP_SPEED_UP 4\nPTP_ANGLE J11 5\nPTP_ANGLE J21 5\nLAMP_ON 1\nLAMP_OFF 2\nEND")?
            .followed();
    run.cycle();
    let cycle = run.cycle();
    let targets = cycle.commands.iter().map(|command| command.target);
    assert!(targets.eq([Target::Joint(1, 1), Target::Joint(2, 1)]));
    assert_eq!(cycle.lamps, [(1, true), (2, false)]);
    assert!(run.steps().iter().map(|step| step.from.step).eq(1..=4));
    run.cycle();
    let ended: Vec<_> = (run.steps().iter())
        .map(|step| (step.from.step, step.to))
        .collect();
    assert_eq!(ended, [(5, None)]);
    Ok(())
}

/// Runs for some cycles, and returns what the run waits for then: lines, and the end of the wait.
fn waits(mut run: Run, cycles: u64) -> Option<([u32; 2], Option<Awaited>)> {
    run = run.followed();
    let mut waits = WaitDetector::default();
    for _ in 0..cycles {
        run.cycle();
        waits.after(&run);
    }
    waits.now(&run).map(|wait| (wait.lines, wait.on))
}

// clauses: 14.2 15.1
#[test]
fn a_wait_is_told_whatever_the_number_of_steps_in_a_cycle() -> Outcome {
    let asks = "L:\nIF KB_HIT GOTO M:\nGOTO L:\nM: END";
    let key = Awaited::Flags {
        names: "KB_HIT".to_owned().into(),
    };
    // At three steps a cycle each one begins with the same step.
    for speed in [1, 2, 3] {
        let run = later(&format!("TIP_SPEED_UP {speed}\n{asks}"))?;
        let expected = ([4, 6], Some(key.clone()));
        assert_eq!(waits(run, 100), Some(expected), "{speed}");
    }
    let thread = "THREAD SIDE:\nKEY_IN\nTHREADEND\nEND";
    let run = later(&format!(
        "START_THREAD SIDE:\nWAIT_THREAD SIDE:\nEXIT\n{thread}"
    ))?;
    let name = "SIDE".to_owned().into();
    let expected = ([4, 4], Some(Awaited::Thread { name }));
    assert_eq!(waits(run, 9), Some(expected));
    Ok(())
}

// clauses: 15.1
#[test]
fn threads_that_wait_for_each_other_are_told() -> Outcome {
    let threads = |waits: &str| {
        format!(
            "START_THREAD A:\nSTART_THREAD B:\nWAIT_THREAD A:\nEXIT\n\
             THREAD A:\nWAIT_THREAD B:\nTHREADEND\nTHREAD B:\nSLEEP 200\n{waits}\nTHREADEND\nEND"
        )
    };
    let waiting = |name: &str| Awaited::Thread {
        name: name.to_owned().into(),
    };
    let names = "A, B".to_owned().into();
    for (of_b, cycles, expected) in [
        // B sleeps for ten cycles, and then waits for A, which waits for B.
        ("WAIT_THREAD A:", 9, waiting("A")),
        ("WAIT_THREAD A:", 30, Awaited::EachOther { names }),
        // It waits for a key: the others go on after that.
        ("KEY_IN", 30, waiting("A")),
    ] {
        let run = later(&threads(of_b))?;
        let expected = ([5, 5], Some(expected));
        assert_eq!(waits(run, cycles), Some(expected), "{of_b} {cycles}");
    }
    Ok(())
}

// clauses: 15.1
#[test]
fn circles_of_threads_are_found_where_the_main_program_does_not_wait() -> Outcome {
    let circles = |threads: &[(&str, &str)], main: &str| {
        let starts = threads
            .iter()
            .map(|(name, _)| format!("START_THREAD {name}:\n"));
        let bodies = threads
            .iter()
            .map(|(name, body)| format!("THREAD {name}:\n{body}\nTHREADEND\n"));
        let (starts, bodies) = (starts.collect::<String>(), bodies.collect::<String>());
        let mut run = later(&format!("{starts}{main}\nEXIT\n{bodies}END"))?.followed();
        for _ in 0..20 {
            run.cycle();
        }
        let names = |circle: WaitCircle| {
            let threads = circle.threads.into_iter().map(|(name, _)| name);
            threads.collect::<Vec<_>>().join(" ")
        };
        let found: Vec<String> = WaitCircle::all(&run).into_iter().map(names).collect();
        Ok::<_, Box<dyn std::error::Error>>(found.join(", "))
    };
    let on = |name: &str| format!("WAIT_THREAD {name}:");
    let (a, b, c, d) = (&*on("A"), &*on("B"), &*on("C"), &*on("D"));
    let (sleep, key) = ("SLEEP 9999", "KEY_IN");
    for (threads, main, expected) in [
        (&[("A", b), ("B", a)][..], sleep, "A B"),
        // In the order of waiting.
        (&[("A", c), ("B", a), ("C", b)], sleep, "A C B"),
        (&[("A", b), ("B", a), ("C", d), ("D", c)], sleep, "A B, C D"),
        // One that waits for the others belongs to no circle.
        (&[("A", b), ("B", c), ("C", b)], sleep, "B C"),
        (&[("A", b), ("B", a)], a, "A B"),
        // The end of the last one ends all.
        (&[("A", b), ("B", c), ("C", key)], sleep, ""),
        (&[("A", b), ("B", "")], sleep, ""),
        (
            &[("A", b), ("B", a)],
            "SLEEP 100\nSTOP_THREAD B:\nSLEEP 9999",
            "",
        ),
        (&[("A", b), ("B", a)], "SLEEP 9999\nSTOP_THREAD B:", "A B"),
    ] {
        assert_eq!(circles(threads, main)?, expected, "{threads:?} {main}");
    }
    Ok(())
}

/// A robot that is bolted down cannot be pushed in any plant, so that the error does not recommend another one.
#[test]
fn nothing_pushes_a_robot_that_is_bolted_down() -> Outcome {
    for plant in [Plant::Simulated, Plant::Dynamic, Plant::Echo] {
        for name in ["trifinger", "hand"] {
            let robot = Robot::named(name)?.with_plant(plant);
            let run = Run::new(load("p.prg", "3.1\nt\nEND\n", &robot)?, robot)?;
            let refused = run
                .events("3:push 1 0 0 for 2")
                .expect_err("it is bolted down");
            let said = "'push 1 0 0 for 2' is for walking robots: this one is bolted down";
            assert_eq!(refused.to_string(), said, "{name} {plant:?}");
        }
    }
    Ok(())
}
