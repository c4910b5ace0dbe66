//! A comparison of engines proves something only if a wrong step shows. Here each kind of step is made
//! wrong, and the traces must differ.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use tip_runtime::fault::Fault;
use tip_runtime::program::{Context, Flow, Program, Signature};
use tip_sim::Interpreter;
use tip_tests::{Settings, run};

const ORIGINAL: &str = "3.1
original
DEF_VAR A, B
DEF_POS P
A = 1
FOR B = 1 TO 2
A += B
NEXT
IF A == 4 THEN
A = A * 2
ELSEIF A == 3 THEN
A = 7
ELSE
A = 9
ENDIF
TEACH_POSITION F1 P
P = P + P
WHILE A < 10
A = A + 0.5
WEND
REPEAT
A -= 1
UNTIL A < 8
GOSUB L1:
IF A > 0 GOTO L2:
A = 5
L2: PTP F1 -391 201 -190
SLEEP 60
LAMP_ON 1
MESSAGE A is %A.1%
GOTO L3:
L1: A = SQRT 49
RETURN
L3: EXIT
END
";

/// Each a change of one step.
const MUTATIONS: &[(&str, &str)] = &[
    ("A = 1\n", "A = 2\n"),
    ("TO 2", "TO 3"),
    ("B = 1 TO 2", "B = 1 TO 2 STEP 2"),
    ("A += B", "A -= B"),
    ("A == 4", "A <> 4"),
    ("A = A * 2", "A = A * 2.0000000000000004"),
    ("TEACH_POSITION F1", "TEACH_POSITION F2"),
    ("P = P + P", "P = P * P"),
    ("A < 10", "A <= 10"),
    ("A < 8", "A < 7"),
    ("GOSUB L1:", "REM"),
    ("A > 0", "A < 0"),
    ("PTP F1", "PTP F3"),
    ("PTP F1", "PTP HS F1"),
    ("-391 201 -190", "-391 201 -190.00000000000003"),
    ("SLEEP 60", "SLEEP 80"),
    ("LAMP_ON", "LAMP_OFF"),
    ("LAMP_ON 1", "LAMP_ON 2"),
    ("A is %A.1%", "A is %A.2%"),
    ("GOTO L3:", "REM"),
    ("SQRT 49", "SQRT 50"),
    ("RETURN", "REM"),
    ("EXIT", "REM"),
];

fn interpreter(source: &str) -> Interpreter {
    let loaded = tipc::load("mutant.prg", source.as_bytes(), &tipc::Options::default());
    Interpreter::new(loaded.program.expect("it loads"))
}

fn trace(program: impl Program + Clone + Send + 'static) -> String {
    run(program, &Settings::default()).unwrap()
}

#[test]
fn a_wrong_step_shows_in_the_trace() {
    let original = trace(interpreter(ORIGINAL));
    assert_eq!(trace(interpreter(ORIGINAL)), original);
    for (from, to) in MUTATIONS {
        assert_eq!(ORIGINAL.matches(from).count(), 1, "{from} stands once");
        let mutant = trace(interpreter(&ORIGINAL.replace(from, to)));
        assert_ne!(mutant, original, "{from} → {to}");
    }
}

/// An engine that runs one step twice.
#[derive(Clone)]
struct Stutter {
    engine: Interpreter,
    steps_left: u32,
    stuttered: Arc<AtomicBool>,
}

impl fmt::Debug for Stutter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "stutters in {} steps", self.steps_left)
    }
}

impl Program for Stutter {
    fn signature(&self) -> Signature {
        self.engine.signature()
    }

    fn name(&self) -> &str {
        self.engine.name()
    }

    fn title(&self) -> &str {
        self.engine.title()
    }

    fn at(&self) -> u32 {
        self.engine.at()
    }

    fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {
        let flow = self.engine.step(cx)?;
        self.steps_left = self.steps_left.wrapping_sub(1);
        match flow {
            Flow::Next if self.steps_left == 0 => {
                self.stuttered.store(true, Ordering::Relaxed);
                self.engine.step(cx)
            }
            flow => Ok(flow),
        }
    }

    fn scalar(&self, i: usize) -> Option<(&str, Option<f64>)> {
        self.engine.scalar(i)
    }

    fn set_scalar(&mut self, i: usize, value: f64) {
        self.engine.set_scalar(i, value);
    }

    fn line(&self, step: u32) -> u32 {
        self.engine.line(step)
    }

    fn reset(&mut self) {
        self.engine.reset();
    }
}

#[test]
fn a_step_too_many_shows_wherever_it_happens() {
    let original = trace(interpreter(ORIGINAL));
    let records: Vec<&str> = original.lines().collect();
    let goes_on = |record: &&str| !record.contains("\"end\"") && record.contains("\"next\"");
    let mut stutters = 0;
    for (cycle, _) in records
        .iter()
        .enumerate()
        .filter(|(_, record)| goes_on(record))
    {
        let engine = Stutter {
            engine: interpreter(ORIGINAL),
            steps_left: cycle as u32 + 1,
            stuttered: Arc::default(),
        };
        let stuttered = Arc::clone(&engine.stuttered);
        let flawed = trace(engine);
        let stuttered = stuttered.load(Ordering::Relaxed);
        // A step that waits does not go on, so it cannot stutter.
        assert_eq!(flawed != original, stuttered, "twice in cycle {cycle}");
        stutters += usize::from(stuttered);
    }
    assert!(stutters > 30, "only {stutters} cycles could stutter");
}
