//! The faults of a description are shown at its path; neither program nor model causes others.
use tip_runtime::program::Program;

tip_macros::tip!(Rest, "3.1\nrest\nEND", robot = "bad_robot.toml");
tip_macros::include_robot!("bad_robot.toml" as BAD);

fn main() {
    let _ = (Rest::new().at(), BAD.signature());
}
