//! A run as a case wants it.

use tip_harness::{Settings, both, run};
use tip_sim::{Interpreter, ProgramRunner, Robot, load};

#[test]
fn what_cannot_happen_is_refused() {
    let robot = Robot::named("titan8").unwrap();
    let program = load("p.prg", "3.1\ntest\nEND\n", &robot).unwrap();
    let outcome = |option: &str, value: &str| {
        let mut settings = Settings::default();
        settings.add_input(option, value);
        run(program.clone(), &settings)
    };
    for (option, value) in [("--keys", "3"), ("--sensor", "VR1=8"), ("--cycles", "x")] {
        assert!(outcome(option, value).is_err(), "{option} {value}");
    }
    // An input may read nonsense.
    assert!(outcome("--sensor", "ANTENNA=nan@0").is_ok());
}

#[test]
fn both_engines_give_the_trace_of_one() {
    let robot = Robot::named("titan8").unwrap();
    let loaded = |text: &str| tipc::load("p.prg", text.as_bytes(), &robot.options()).program;
    let of = |text: &str| loaded(text).expect("it loads");
    let text = "3.1\ntest\nDEF_VAR A\nA = 1\nSLEEP 60\nEND\n";
    let settings = Settings::default();
    let one = run(Interpreter::new(of(text)), &settings);
    let same = |compiled: &str| {
        let compiled = ProgramRunner::new(Interpreter::new(of(compiled)));
        both(of(text), compiled, &settings)
    };
    assert_eq!(same(text), one);
    let difference = same(&text.replace("A = 1", "A = 2")).unwrap_err();
    assert!(difference.contains("cycle 0, step 0"), "{difference}");
    let unlike = same(&text.replace("A = 1", "\nA = 1")).unwrap_err();
    assert!(unlike.contains("differ"), "{unlike}");
}
