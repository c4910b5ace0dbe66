//! The campaign finds faults that are planted in generated code, and shrinks them.

use campaign::batch::Effort;
use campaign::build::{Flavour, Workshop};
use campaign::hunt::{differing, shrink};
use random_programs::{Edition, Specimen, Tamper, program};

const EFFORT: Effort = Effort {
    runs: 1,
    cycles: 2000,
    simulated_one_in: 10,
    simulated_cycles: 100,
    heavy_cycles: 10,
};

/// A planted fault, a word that the shrunk program must keep, and its maximum number of lines.
const FAULTS: &[(Tamper, &str, usize)] = &[
    (|code| code.replace("ops :: sub (", "ops :: add ("), "-", 8),
    (
        |code| code.replace("Target :: Foot (2)", "Target :: Foot (1)"),
        "F2",
        6,
    ),
];

#[test]
fn planted_faults_are_found_and_shrunk() {
    let specimens: Vec<Specimen> = (0..60).map(|seed| program(Edition::V3_1, seed)).collect();
    for (tamper, word, lines) in FAULTS {
        let workshop = Workshop {
            tamper: *tamper,
            ..Workshop::new()
        };
        let printed = workshop
            .run(&specimens, Flavour::Quick, &EFFORT)
            .expect("a batch");
        let found = differing(&specimens, &printed);
        let (place, told) = found
            .first()
            .unwrap_or_else(|| panic!("{word} is found:\n{printed}"));
        let (shrunk, told) =
            shrink(&workshop, Flavour::Quick, &EFFORT, &specimens[*place], told).expect("batches");
        let source = &shrunk.source;
        assert!(source.contains(word), "{source}\n{told}");
        assert!(source.lines().count() <= *lines, "{source}\n{told}");
        assert!(
            told.contains("interpreter:") && told.contains("generated code:"),
            "{told}"
        );
    }
}
