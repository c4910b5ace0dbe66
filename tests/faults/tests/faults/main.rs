//! The fault campaign: faults of sensors, hardware, keys and timing, in every place and at
//! cycles throughout a program, have a defined outcome. The first half of `docs/faults.md` is generated here.

mod campaign;
mod defect;
mod document;
mod expected;
mod faulty;
mod place;
mod script;
mod trial;

use campaign::{Campaign, Seen};
use script::Script;
use std::{env, fs, path, thread};
use tip_runtime::model::{generic, hand, titan8};
use tip_runtime::plant::{DynamicPlant, Scene, SimulatedHand, SimulatedPlant};
use tip_runtime::special::hand::HandSpecials;

tip_macros::include_tip!("motions/titan.prg");
tip_macros::include_tip!("motions/hand.prg", robot = hand);

/// Cycles between the moments at which faults break into a compiled program, which is longer than a script; a
/// prime as well.
const PACE: usize = 11;

/// The campaign for robots with mass.
const HEAVY_PACE: usize = 3;

/// Output of the campaign of files.
const OTHER_HALF: &str = "\n## Files and Ctrl-C\n";

/// A robot with its program, and the campaign on it.
type Column = (&'static str, fn() -> Seen);

fn titan() -> Seen {
    let plant = SimulatedPlant::new(&titan8::MODEL);
    let script = Script::new(&titan8::MODEL, script::TITAN);
    Campaign::new(&titan8::MODEL, script, plant, (), 1).run()
}

fn compiled_titan() -> Seen {
    let plant = SimulatedPlant::new(&titan8::MODEL);
    Campaign::new(&titan8::MODEL, Titan::new(), plant, (), PACE).run()
}

/// Robots with mass, which take longer to compute.
fn heavy_titan() -> Seen {
    let plant = DynamicPlant::new(&titan8::MODEL);
    let script = Script::new(&titan8::MODEL, script::TITAN);
    Campaign::new(&titan8::MODEL, script, plant, (), HEAVY_PACE).run()
}

fn generic() -> Seen {
    let plant = SimulatedPlant::new(&generic::MODEL);
    let script = Script::new(&generic::MODEL, script::GENERIC);
    Campaign::new(&generic::MODEL, script, plant, (), 1).run()
}

fn heavy_generic() -> Seen {
    let plant = DynamicPlant::new(&generic::MODEL);
    let script = Script::new(&generic::MODEL, script::GENERIC);
    Campaign::new(&generic::MODEL, script, plant, (), HEAVY_PACE).run()
}

fn hand() -> Seen {
    let plant = SimulatedHand::new(&hand::MODEL);
    let script = Script::new(&hand::MODEL, script::HAND);
    Campaign::new(&hand::MODEL, script, plant, (), 1).run()
}

fn compiled_hand() -> Seen {
    let scene = Scene::by_name("cylinder").expect("it has one");
    let plant = SimulatedHand::new(&hand::MODEL).with_scene(&scene);
    let special = HandSpecials::new();
    Campaign::new(&hand::MODEL, Hand::new(), plant, special, PACE).run()
}

// clauses: 2.22 2.23 2.24 7.40 8.1
#[test]
fn every_fault_in_every_place_has_its_outcome_and_the_table_says_which() {
    let columns: [Column; 7] = [
        ("titan8", titan),
        ("titan8, dynamic", heavy_titan),
        ("generic", generic),
        ("generic, dynamic", heavy_generic),
        ("hand", hand),
        ("titan8, compiled", compiled_titan),
        ("hand, compiled", compiled_hand),
    ];
    let columns = thread::scope(|scope| {
        let running = columns.map(|(name, run)| (name, scope.spawn(run)));
        running.map(|(name, run)| (name, run.join().expect("every outcome is defined")))
    });
    let text = document::document(&columns);
    let path = path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/faults.md");
    let page = fs::read_to_string(&path).expect("the page of faults");
    let (half, other) = page.split_once(OTHER_HALF).expect("its other half");
    if env::var_os("TIP_BLESS").is_some() {
        let page = format!("{text}{OTHER_HALF}{other}");
        fs::write(path, page).expect("the docs can be written");
        return;
    }
    assert!(
        half == text,
        "docs/faults.md differs; TIP_BLESS=1 rewrites it"
    );
}
