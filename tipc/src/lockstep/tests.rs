use super::*;
use std::io::Cursor;
use tip_runtime::model::titan8;
use tip_runtime::plant::SimulatedPlant;

const COUNT: &str = "DEF_VAR N\nN = 0\nLOOP: KEY_IN\nN += 1\nIF N < 3 GOTO LOOP:\nMESSAGE %N%\nEND";

fn program(statements: &str) -> program::Program {
    let source = format!("3.1\ntest\n{statements}\n");
    let loaded = crate::load("p.prg", source.as_bytes(), &crate::Options::default());
    loaded.program.expect("it loads")
}

/// An interpreter of `other` in the place of compiled code.
fn rig(statements: &str, other: &str) -> Rig<'static, Interpreter, SimulatedPlant<4, 3>, (), 4, 3> {
    Rig {
        program: program(statements),
        compiled: Interpreter::new(program(other)),
        model: &titan8::MODEL,
        plant: SimulatedPlant::new(&titan8::MODEL),
        special: (),
    }
}

fn answers(
    rig: &Rig<'static, Interpreter, SimulatedPlant<4, 3>, (), 4, 3>,
    requests: &str,
) -> Vec<Answer> {
    let mut out = Vec::new();
    serve(rig, Cursor::new(requests), &mut out).expect("a Vec takes everything");
    let text = String::from_utf8(out).expect("answers are text");
    text.lines()
        .map(|line| line.parse().expect("an answer"))
        .collect()
}

// Steps: 0 N = 0, 1 LOOP, 2 KEY_IN, 3 N += 1, 4 IF, 5 MESSAGE, 6 END. The spots behind them are the edges of 4.
#[test]
fn runs_agree_and_tell_what_is_new() {
    let rig = rig(COUNT, COUNT);
    let answers = answers(
        &rig,
        "--keys 0:A --cycles 9\n--keys 0:A,4:B,8:C\n--keys 1:A --cycles 4\n",
    );
    let agreed = |cycles, end, new: &[usize], chances: &[u64]| Answer::Agreed {
        cycles,
        end,
        new: new.to_vec(),
        chances: chances.to_vec(),
    };
    // The second run reads keys in cycles 2, 6 and 10, and 14 is its last one. Before the end, the false edge is open.
    let expected = [
        agreed(9, RunEnd::Limit, &[0, 1, 2, 3, 4, 7], &[4]),
        agreed(15, RunEnd::Finished, &[8, 5, 6], &[4, 8]),
        agreed(4, RunEnd::Limit, &[], &[]),
    ];
    let [Answer::Agreed { new, .. }, ..] = &answers[..] else {
        panic!("{answers:?}");
    };
    let ways: Vec<_> = new
        .iter()
        .map(|spot| Reach::new(&rig.program).spots().all()[*spot].way)
        .collect();
    assert_eq!(ways.last(), Some(&Some("true")));
    assert_eq!(answers, expected);
}

#[test]
fn the_first_record_that_differs_is_told() {
    let other = COUNT.replace("N < 3", "N < 2");
    let keys = "--keys 0:A,4:B,8:C";
    let [Answer::Diverged(divergence)] = &answers(&rig(COUNT, &other), keys)[..] else {
        panic!("they agree");
    };
    assert_eq!((divergence.cycle, divergence.step), (8, 4));
    assert!(
        divergence.interpreted.contains(r#""next":1"#),
        "{divergence:?}"
    );
    assert!(
        divergence.compiled.contains(r#""next":5"#),
        "{divergence:?}"
    );
    let short = answers(&rig(COUNT, &other), "--keys 0:A,4:B,8:C --cycles 8");
    assert!(
        matches!(short[..], [Answer::Agreed { cycles: 8, .. }]),
        "{short:?}"
    );
}

#[test]
fn a_different_end_is_a_divergence() {
    let faulty = "DEF_VAR N\nN = 0\nN = 1 / N\nEND";
    let ends = "DEF_VAR N\nN = 0\nREM\nEND";
    let [Answer::Diverged(divergence)] = &answers(&rig(faulty, ends), "\n")[..] else {
        panic!("they agree");
    };
    assert_eq!(divergence.cycle, 1);
    assert!(
        divergence.interpreted.contains("Domain error"),
        "{divergence:?}"
    );
    let both = answers(&rig(faulty, faulty), "\n");
    assert!(
        matches!(
            both[..],
            [Answer::Agreed {
                cycles: 1,
                end: RunEnd::Emergency,
                ..
            }]
        ),
        "{both:?}"
    );
}

#[test]
fn what_the_robot_lacks_is_refused() {
    let rig = rig("END", "END");
    for wrong in ["--sensor J99=1@0", "--keys"] {
        let answers = answers(&rig, wrong);
        assert!(matches!(&answers[..], [Answer::Refused(_)]), "{answers:?}");
    }
    assert!("agreed\t1\tnever\t\t".parse::<Answer>().is_err());
}
