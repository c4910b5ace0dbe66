//! The lines that the other process gets.
#![expect(clippy::disallowed_methods, reason = "it keeps them in a file")]

use super::peer::{ANGLES, ECHO, Outcome, PATIENCE, ready, run_on, says, script};
use serde_json::{Value, json};
use std::error::Error;
use std::fs;
use std::path::Path;
use tip_sim::{ExternalPlant, Limit};

/// All lines that a process gets in a run that its answers let come to its end.
fn lines(
    robot: &str,
    statements: &str,
    ready: &str,
    each: &str,
) -> Result<Vec<Value>, Box<dyn Error>> {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("lines-{robot}"));
    let keeps = format!("tee '{}' | {}", file.display(), script(ready, each));
    let plant = ExternalPlant::new("sh", ["-c", &keeps]).with_time_limits(PATIENCE);
    let mut run = run_on(robot, statements, &plant)?;
    run.to_end(Limit::cycles(100));
    assert_eq!(run.plant_error(), None);
    drop(run);
    let text = fs::read_to_string(file)?;
    let lines = text.lines().map(serde_json::from_str);
    Ok(lines.collect::<Result<_, _>>()?)
}

#[test]
fn hello_says_what_a_simulator_has_to_know() -> Outcome {
    let lines = lines("titan8", "END", &ready(), ECHO)?;
    let initial: Value = serde_json::from_str(ANGLES)?;
    assert_eq!(
        lines[0],
        json!({
            "type": "hello", "version": 2, "robot": "titan8", "legs": 4, "joints": 3,
            "period": 20.0, "initial": initial, "needs": ["angles"],
        })
    );
    // The joints stay where they are.
    assert_eq!(
        lines[1],
        json!({
            "type": "cycle", "n": 0, "period": 20.0, "modes": vec!["angle"; 12],
            "targets": initial, "rates": vec![0.0; 12],
        })
    );
    assert_eq!(lines.last(), Some(&json!({"type": "bye"})));
    Ok(())
}

/// 8 mN m are 0.008 N m.
#[test]
fn a_cycle_has_a_command_for_each_joint_in_newton_metres() -> Outcome {
    let answer = r#""angles":[20,20,20,20,20,20,20,20,20],
        "torques":[0.25,0.25,0.25,0.25,0.25,0.25,0.25,0.25,0.25],"slider":[0,0,-60]"#
        .replace("\n        ", "");
    let ready = says(&format!(r#""version":2,{answer}"#));
    let each = says(&format!(r#""n":$n,{answer}"#));
    let lines = lines("hand", "TORQUE J11 8\nSLEEP 60\nEND", &ready, &each)?;
    assert_eq!(lines[0]["needs"], json!(["angles", "torques", "slider"]));
    let has_torque = |line: &&Value| {
        line["modes"][0] == "torque"
            && line["modes"][1] == "angle"
            && line["targets"][0] == 0.008
            && line["rates"][0] == 0.0
            && line["slider"]
                .as_array()
                .is_some_and(|axes| axes.len() == 3)
    };
    assert!(lines.iter().find(has_torque).is_some(), "{lines:?}");
    Ok(())
}
