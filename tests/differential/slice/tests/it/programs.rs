//! Random programs load, and all that the language has comes up in them.

use random_programs::{Edition, Specimen, program};
use std::collections::BTreeSet;
use tipc::Robot;
use tipc::language::commands::COMMANDS;

const SEEDS: u64 = 3000;

fn specimens() -> impl Iterator<Item = Specimen> {
    let of_edition = |edition: &Edition| {
        let edition = *edition;
        (0..SEEDS).map(move |seed| program(edition, seed))
    };
    Edition::ALL.iter().flat_map(of_edition)
}

#[test]
fn every_program_loads() {
    for specimen in specimens() {
        let options = tipc::Options {
            robot: specimen.robot,
            ..tipc::Options::default()
        };
        let loaded = tipc::load("random.prg", specimen.source.as_bytes(), &options);
        assert!(
            loaded.program.is_some(),
            "{:?}\n{}",
            loaded.diagnostics,
            specimen.source
        );
    }
}

#[test]
fn every_command_of_every_robot_comes_up() {
    let words: BTreeSet<(&str, String)> = specimens()
        .flat_map(|specimen| {
            let words: Vec<_> = specimen
                .source
                .split_whitespace()
                .map(str::to_owned)
                .collect();
            words
                .into_iter()
                .map(move |word| (specimen.robot.name(), word))
        })
        .collect();
    for robot in Robot::ALL {
        for command in COMMANDS
            .iter()
            .filter(|command| command.robots.contains(*robot))
        {
            for name in [Some(command.name), command.alias].into_iter().flatten() {
                assert!(
                    words.contains(&(robot.name(), name.to_owned())),
                    "{name} on {}",
                    robot.name()
                );
            }
        }
    }
}

#[test]
fn a_seed_gives_the_same_program_again() {
    let of = |seed| program(Edition::V3_2, seed);
    assert_eq!(of(7), of(7));
    assert_ne!(of(7).source, of(8).source);
}
