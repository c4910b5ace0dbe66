//! The lines that the other process gets.
#![expect(clippy::disallowed_methods, reason = "it keeps them in a file")]

use super::peer::{ANGLES, ECHO, Outcome, PATIENCE, ready, run_on, script};
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
) -> Result<Vec<String>, Box<dyn Error>> {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("lines-{robot}"));
    let keeps = format!("tee '{}' | {}", file.display(), script(ready, each));
    let plant = ExternalPlant::new("sh", ["-c", &keeps]).with_time_limits(PATIENCE);
    let mut run = run_on(robot, statements, &plant)?;
    run.to_end(Limit::cycles(100));
    assert_eq!(run.plant_error(), None);
    drop(run);
    let text = fs::read_to_string(file)?;
    Ok(text.lines().map(str::to_owned).collect())
}

#[test]
fn hello_says_what_a_simulator_has_to_know() -> Outcome {
    let lines = lines("titan8", "END", &ready(), ECHO)?;
    let initial = ANGLES.replace("angles", "initial");
    assert_eq!(
        lines[0],
        format!("hello version=1 robot=titan8 legs=4 joints=3 period=20.0 {initial} needs=angles")
    );
    assert!(
        lines[1].starts_with("cycle n=0 period=20.0 modes=angle,"),
        "{lines:?}"
    );
    Ok(())
}

/// 8 mN m are 0.008 N m.
#[test]
fn a_cycle_has_a_command_for_each_joint_in_newton_metres() -> Outcome {
    let joints = |value: &str| [value; 9].join(",");
    let answer = format!(
        "angles={} torques={} slider=0,0,-60",
        joints("20"),
        joints("0.25")
    );
    let ready = format!("echo ready version=1 {answer}");
    let each = format!("echo state n=$n {answer}");
    let lines = lines("hand", "TORQUE J11 8\nSLEEP 60\nEND", &ready, &each)?;
    assert!(
        lines[0].ends_with(" needs=angles,torques,slider"),
        "{lines:?}"
    );
    let has_torque = |line: &&String| {
        line.contains(" modes=torque,angle,")
            && line.contains(" targets=0.008,")
            && line.contains(" rates=0.0,")
            && line.contains(" slider=")
    };
    assert!(lines.iter().find(has_torque).is_some(), "{lines:?}");
    Ok(())
}
