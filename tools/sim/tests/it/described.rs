//! Robots of any size.

use std::error::Error;
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tip_sim::{Limit, Robot, Run, load};

/// A robot of so many legs with so many joints each.
fn description(legs: usize, joints: usize) -> String {
    let joint = "{ axis = \"y\", link = [50, 0, 0], limits = [-60, 60] }";
    let legs: Vec<String> = (0..legs)
        .map(|leg| format!("{{ base = [80, {leg}, 0] }}"))
        .collect();
    let joints = vec![joint; joints].join(", ");
    format!(
        "name = \"r\"\njoint = [{joints}]\nleg = [{}]\n",
        legs.join(", ")
    )
}

#[test]
fn every_size_moves_its_last_joint() -> Result<(), Box<dyn Error>> {
    for legs in 1..=9 {
        for joints in 1..=9 {
            let robot = Robot::from_description(&description(legs, joints))?;
            let text =
                format!("3.1\nt\nPTP_ANGLE J{legs}{joints} 5\nWAIT_INPOS J{legs}{joints}\nEND\n");
            let mut run = Run::new(load("p.prg", &text, &robot)?, robot)?;
            assert_eq!(run.to_end(Limit::cycles(2000)), Ending::Program(End::End));
            assert_eq!(run.angles().len(), legs * joints);
            let last = run.angles().last().copied().unwrap_or_default();
            assert!((last - 5.0).abs() < 1.0, "{legs} x {joints}: {last}");
        }
    }
    Ok(())
}

#[test]
fn a_faulty_description_tells_its_faults() {
    let error = Robot::from_description("name = 3\n")
        .expect_err("no legs")
        .to_string();
    assert!(error.contains("robot.toml:1:"), "{error}");
}
