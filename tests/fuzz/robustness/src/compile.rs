//! The whole path to generated code and listings: what the emitter writes is a Rust file, the same each time.

use tip_lint::cycles::{Sampling, json, parts};
use tip_lint::listing;
use tipc::emit::pretty;
use tipc::{Options, Robot, emit, load};

/// Compiles the bytes for each robot.
///
/// # Panics
/// A program that loads has no code, or code that is not Rust.
pub fn examine(bytes: &[u8]) {
    for robot in Robot::ALL {
        let options = Options {
            robot: *robot,
            ..Options::default()
        };
        let loaded = load("random.prg", bytes, &options);
        let Some(program) = loaded.program else {
            continue;
        };
        let sampling = Sampling::of(*robot);
        json(&program, &parts(&program, sampling), sampling);
        listing::label(&program);
        listing::object(&loaded.source, &loaded.module, &program);
        if let Err(error) = pretty(&program, &emit::Options::default()) {
            panic!("{error}: {}", String::from_utf8_lossy(bytes));
        }
    }
}
