//! The campaign finds faults that are planted in generated code, and shrinks them.

use campaign::batch::Effort;
use campaign::build::{Flavour, Workshop};
use campaign::hunt::{differing, shrink};
use random_programs::{Edition, Specimen, Tamper, program};

const EFFORT: Effort = Effort {
    runs: 1,
    cycles: 2000,
    simulated_one_in: 10,
    simulated_cycles: 100,
    heavy_cycles: 10,
};

/// A fault, how it is planted, a word that the shrunk program must keep, and its maximum number of lines.
struct Fault {
    edition: Edition,
    tamper: Tamper,
    word: &'static str,
    lines: usize,
}

const FAULTS: &[Fault] = &[
    Fault {
        edition: Edition::V3_1,
        tamper: |code| code.replace("ops :: sub (", "ops :: add ("),
        word: "-",
        lines: 8,
    },
    Fault {
        edition: Edition::V3_1,
        tamper: |code| code.replace("Target :: Foot (2)", "Target :: Foot (1)"),
        word: "F2",
        lines: 6,
    },
    Fault {
        edition: Edition::V3_2,
        tamper: in_wrong_order,
        word: "START_THREAD THR1:",
        lines: 16,
    },
    Fault {
        edition: Edition::V3_2,
        tamper: |code| code.replace("self . not_taken = place . not_taken ;", ""),
        word: "ELSE",
        lines: 24,
    },
    Fault {
        edition: Edition::V3_2,
        tamper: with_another_addition,
        word: "@TIMER",
        lines: 24,
    },
    Fault {
        edition: Edition::V3_2,
        tamper: without_lock_checks,
        word: "LOCK",
        lines: 24,
    },
];

/// Exchanges the numbers of the first two threads, by which the runtime orders their turns.
fn in_wrong_order(code: String) -> String {
    let exchanged = |text: &str, form: &str| {
        let [first, second] = ["1", "2"].map(|n| form.replace('n', n));
        let marked = text.replace(&first, "\0").replace(&second, &first);
        marked.replace('\0', &second)
    };
    match code.split_once("fn thread (") {
        Some((steps, methods)) if methods.contains("2 => ") => {
            let steps = exchanged(steps, "_thread (n)");
            format!("{steps}fn thread ({}", exchanged(methods, "n => "))
        }
        _ => code,
    }
}

/// Lets timers that have grown show one addition more. They grow in the runtime, which both engines share.
fn with_another_addition(mut code: String) -> String {
    for timer in 0..8 {
        let reading = format!("cx . reading (Reading :: Timer ({timer})) ? [0]");
        let time = "if time > 0.0 { time + cx.period() } else { time }";
        code = code.replace(&reading, &format!("({{ let time = {reading}; {time} }})"));
    }
    code
}

/// Passes over commands that are refused because a joint is locked. The runtime checks locks, for both engines; what it
/// answers goes through generated code if an operand is no constant.
fn without_lock_checks(code: String) -> String {
    let code = code.replace("cx . ask (command ,", "past_locks (cx , command ,");
    format!(
        "{code}
        #[allow(dead_code)]
        fn past_locks(
            cx: &mut dyn ::tip_runtime::program::Context,
            command: &::tip_runtime::command::Command<'_>,
            at: &mut u32,
            next: u32,
        ) -> Result<::tip_runtime::program::Flow, ::tip_runtime::fault::Fault> {{
            use ::tip_runtime::command::Op;
            let moves = matches!(command.op, Op::Ptp | Op::PtpAngle | Op::VelControl | Op::OmegaControl);
            match cx.ask(command, at, next) {{
                Err(::tip_runtime::fault::Fault::InvalidMode) if moves => {{
                    *at = next;
                    Ok(::tip_runtime::program::Flow::Next)
                }}
                answer => answer,
            }}
        }}"
    )
}

#[test]
fn planted_faults_are_found_and_shrunk() {
    for Fault {
        edition,
        tamper,
        word,
        lines,
    } in FAULTS
    {
        let specimens: Vec<Specimen> = (0..60).map(|seed| program(*edition, seed)).collect();
        let workshop = Workshop {
            tamper: *tamper,
            ..Workshop::new()
        };
        let printed = workshop
            .run(&specimens, Flavour::Quick, &EFFORT)
            .expect("a batch");
        let found = differing(&specimens, &printed);
        let (place, told) = found
            .first()
            .unwrap_or_else(|| panic!("{word} is found:\n{printed}"));
        let (shrunk, told) =
            shrink(&workshop, Flavour::Quick, &EFFORT, &specimens[*place], told).expect("batches");
        let source = &shrunk.source;
        assert!(source.contains(word), "{source}\n{told}");
        assert!(source.lines().count() <= *lines, "{source}\n{told}");
        assert!(
            told.contains("interpreter:") && told.contains("generated code:"),
            "{told}"
        );
    }
}
