//! Writes a robot as URDF and as MJCF, and where its links are in 1,000 random postures and how its feet move there: what
//! `tests/external/urdf/run` has judged by others.
//!
//! `cargo run -p tip-sim --example poses -- FOLDER titan8 hexapod.toml quadruped.urdf`

use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs};
use tip_runtime::kinematics::Chain;
use tip_runtime::model::Leg;
use tip_runtime::random::Random;
use tip_sim::{Limb, Robot, RobotDescription, import, mjcf, urdf};

const POSES: usize = 1000;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = env::args().skip(1);
    let folder = arguments.next().ok_or("which folder?")?;
    for robot in arguments {
        let name = Path::new(&robot).file_name().ok_or("which robot?")?;
        let to = Path::new(&folder).join(name);
        let robot = load(Path::new(&robot))?;
        fs::write(to.with_extension("urdf"), urdf::export(&robot))?;
        fs::write(to.with_extension("xml"), mjcf::export(&robot))?;
        fs::write(to.with_extension("poses"), poses(&robot.description()))?;
    }
    Ok(())
}

fn load(robot: &Path) -> Result<Robot, Box<dyn Error>> {
    let text = || fs::read_to_string(robot);
    let ending = robot.extension().and_then(|ending| ending.to_str());
    Ok(match ending {
        Some("toml") => Robot::from_description(&text()?)?,
        Some("urdf") => Robot::from_description(&import::import("robot.urdf", &text()?)?.toml)?,
        _ => Robot::named(&robot.to_string_lossy())?,
    })
}

/// A line `joint NAME DEGREES` for each joint, or `slider AXIS MM`, and a line `link NAME X Y Z` with its three axes, all of it
/// in the robot frame in mm; a line `jacobian FOOT X Y Z …` with mm/rad for each joint of a leg; a blank line after each pose.
fn poses(description: &RobotDescription) -> String {
    let mut random = Random::new(1);
    let mut text = String::new();
    for _ in 0..POSES {
        // Writing to a String cannot fail.
        let _ = pose(&mut text, description, &mut random);
        text.push('\n');
    }
    text
}

fn pose(
    text: &mut String,
    description: &RobotDescription,
    random: &mut Random,
) -> std::fmt::Result {
    for (number, leg) in (1..).zip(&description.legs) {
        let angles: Vec<f64> = leg
            .joints
            .iter()
            .map(|joint| random.within(joint.limits.min, joint.limits.max))
            .collect();
        for (joint, angle) in (1..).zip(&angles) {
            writeln!(text, "joint J{number}{joint} {angle}")?;
        }
        for (joint, frame) in (1..).zip(leg.frames(&angles)) {
            let [x, y, z] = frame.at;
            write!(text, "link link{number}{joint} {x} {y} {z}")?;
            for part in frame.axes.as_flattened() {
                write!(text, " {part}")?;
            }
            writeln!(text)?;
        }
        let [x, y, z] = leg.foot(&angles);
        writeln!(text, "link F{number} {x} {y} {z}")?;
        write!(text, "jacobian F{number}")?;
        for part in jacobian(leg, &angles).as_flattened() {
            write!(text, " {part}")?;
        }
        writeln!(text)?;
    }
    if let Some(slider) = &description.slider {
        let at = slider
            .travel
            .map(|range| random.within(range.min, range.max));
        for (axis, (at, range)) in ["x", "y", "z"].iter().zip(at.iter().zip(slider.travel)) {
            if range.min < range.max {
                writeln!(text, "slider floor_{axis} {at}")?;
            }
        }
        let [x, y, z] = at;
        writeln!(text, "link floor {x} {y} {z}")?;
    }
    Ok(())
}

/// Returns the motion of a foot with each joint, mm/rad.
fn jacobian(limb: &Limb, angles: &[f64]) -> Vec<[f64; 3]> {
    match angles.len() {
        1 => columns::<1>(limb, angles),
        2 => columns::<2>(limb, angles),
        3 => columns::<3>(limb, angles),
        4 => columns::<4>(limb, angles),
        5 => columns::<5>(limb, angles),
        6 => columns::<6>(limb, angles),
        7 => columns::<7>(limb, angles),
        8 => columns::<8>(limb, angles),
        _ => columns::<9>(limb, angles),
    }
}

fn columns<const J: usize>(limb: &Limb, angles: &[f64]) -> Vec<[f64; 3]> {
    let leg = Leg {
        base: limb.base,
        initial: std::array::from_fn(|joint| limb.initial[joint]),
        joints: std::array::from_fn(|joint| limb.joints[joint]),
    };
    let angles = std::array::from_fn(|joint| angles[joint]);
    Chain::<J>::new(&leg, &angles).foot_jacobian().to_vec()
}
