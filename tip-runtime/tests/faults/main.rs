//! The fault campaign: what goes wrong with sensors, hardware, keys and time, in every place and at
//! cycles throughout a program, has a defined outcome. The first half of `docs/faults.md` is generated here.
#![cfg(feature = "std")]

mod campaign;
mod defect;
mod document;
mod expected;
mod faulty;
mod place;
mod script;
mod trial;

use campaign::{Campaign, Seen};
use std::{env, fs, path};
use tip_runtime::model::{generic, hand, titan8};
use tip_runtime::plant::{SimulatedHand, SimulatedPlant};

/// What the campaign of files writes.
const OTHER_HALF: &str = "\n## Files and Ctrl-C\n";

fn titan() -> Seen {
    let plant = SimulatedPlant::new(&titan8::MODEL);
    Campaign::new(&titan8::MODEL, script::TITAN, plant).run()
}

fn generic() -> Seen {
    let plant = SimulatedPlant::new(&generic::MODEL);
    Campaign::new(&generic::MODEL, script::GENERIC, plant).run()
}

fn hand() -> Seen {
    let plant = SimulatedHand::new(&hand::MODEL);
    Campaign::new(&hand::MODEL, script::HAND, plant).run()
}

// clauses: 2.22 2.23 2.24 7.40 8.1
#[test]
fn every_fault_in_every_place_has_its_outcome_and_the_table_says_which() {
    let text = document::document(&[
        ("titan8", titan()),
        ("generic", generic()),
        ("hand", hand()),
    ]);
    let path = path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/faults.md");
    let page = fs::read_to_string(&path).expect("the page of faults");
    let (half, other) = page.split_once(OTHER_HALF).expect("its other half");
    if env::var_os("TIP_BLESS").is_some() {
        let page = format!("{text}{OTHER_HALF}{other}");
        fs::write(path, page).expect("the docs can be written");
        return;
    }
    assert!(
        half == text,
        "docs/faults.md differs; TIP_BLESS=1 writes it anew"
    );
}
