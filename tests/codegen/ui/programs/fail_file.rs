//! A program with two errors; its use gives no third one.
use tip_runtime::program::Program;

tip_macros::include_tip!("broken.prg");

fn main() {
    let broken = Broken::new();
    let _ = (broken.at(), broken.title());
}
