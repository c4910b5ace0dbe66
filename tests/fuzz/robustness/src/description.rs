//! Descriptions of robots: a sound model and its Rust, or findings at places inside the text.

use tip_runtime::model::{Model, ModelError};
use tipc::description::{WithModel, parse};
use tipc::{Options, emit, load};

/// Reads the bytes as a description.
///
/// # Panics
/// It is taken and the runtime refuses the robot, its Rust is none, or it is refused without a reason.
pub fn examine(bytes: &[u8]) {
    let seen = String::from_utf8_lossy(bytes);
    match parse("random.toml", bytes) {
        Ok(description) => {
            assert_eq!(description.with_model(Check), Ok(()), "{seen}");
            if let Err(error) = description.pretty(&emit::Options::default()) {
                panic!("{error}: {seen}");
            }
            let options = Options {
                robot: description.robot(),
                ..Options::default()
            };
            let program = b"3.1\nstand\nPTP_ANGLE F1 INIT\nEND\n";
            load("stand.prg", program, &options);
        }
        Err(loaded) => {
            assert!(!loaded.diagnostics.is_empty(), "{seen}");
            for one in &loaded.diagnostics {
                let place = loaded.source.text().get(one.span.start..one.span.end);
                assert!(place.is_some(), "{:?}: {seen}", one.span);
            }
        }
    }
}

/// Check that the runtime accepts the robot.
struct Check;

impl WithModel for Check {
    type Output = Result<(), ModelError>;

    fn with<const L: usize, const J: usize>(self, model: &Model<L, J>) -> Self::Output {
        model.check()
    }
}
