//! Writes what a run of a walking robot commands its joints, and what its body and feet did, a line for each cycle: the
//! angles of all joints (deg), x, y, z (mm), roll, pitch, yaw (deg), a load for each foot (N) and the slip so far (mm).
//!
//! `joints PROGRAM.prg SCENE.toml [ROBOT.toml]`: TITAN VIII without a description. Lines of the program that begin with
//! `// events:` say what happens to the robot that the scene gives mass.

use std::error::Error;
use std::fs;
use tip_runtime::hardware::JointCommand;
use tip_runtime::plant::Simulation;
use tip_sim::{Robot, Run, load};
use tipc::description::parse_scene;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [path, scene, robot @ ..] = &words[..] else {
        return Err("joints PROGRAM.prg SCENE.toml [ROBOT.toml]".into());
    };
    let scene = parse_scene(scene, &fs::read(scene)?).map_err(|_| "not a scene")?;
    let robot = match robot {
        [description] => Robot::from_description(&fs::read_to_string(description)?)?,
        _ => Robot::named("titan8")?,
    };
    let text = fs::read_to_string(path)?;
    let program = load(path, &text, &robot)?;
    let mut run = Run::new(program, robot.with_scene(&scene)?)?;
    if scene.plant == Some(Simulation::Dynamic) {
        let events = text
            .lines()
            .filter_map(|line| line.strip_prefix("// events:"));
        run = run.events(events.collect::<Vec<_>>().join(",").trim())?;
    }
    while run.ending().is_none() {
        run.advance(None);
        let (motion, limbs) = (
            run.motion().ok_or("no motion")?,
            run.limbs().ok_or("no limbs")?,
        );
        let pose = motion.pose;
        let [x, y, z] = pose.position;
        let commands = run.commands().iter().copied().map(JointCommand::value);
        let loads = limbs.loads;
        let numbers = commands
            .chain([x, y, z, pose.roll, pose.pitch, pose.yaw])
            .chain(loads)
            .chain([motion.slip]);
        let line: Vec<String> = numbers.map(|number| number.to_string()).collect();
        println!("{}", line.join(","));
    }
    Ok(())
}
