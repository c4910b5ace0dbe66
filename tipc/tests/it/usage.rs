//! The usage that help texts show is the language that loads.

use tipc::code::Level;
use tipc::language::Edition;
use tipc::language::commands::{COMMANDS, Form};
use tipc::{Options, Robot, load};

/// Returns the statements that a usage stands for: optional parts left out and kept, each alternative, words filled
/// in.
fn statements(usage: &str) -> Vec<String> {
    let mut written = vec![String::new()];
    for word in usage.split(' ') {
        let optional = word.starts_with('[');
        let word = word.trim_matches(['[', ']']);
        let mut choices: Vec<&str> = word.split('|').map(filled).collect();
        if optional {
            choices.push("");
        }
        written = written
            .iter()
            .flat_map(|before| choices.iter().map(move |word| format!("{before} {word}")))
            .collect();
    }
    written
}

fn filled(word: &str) -> &str {
    match word {
        "number" | "x" | "y" | "z" | "j1" | "j2" | "j3" => "1",
        "low" => "0",
        "high" => "1",
        "0…255" => "7",
        "VAR" => "V",
        "POS" => "P",
        "JOINT" => "Q",
        other => other,
    }
}

fn mistakes(statement: &str, edition: Edition, robot: Robot) -> Vec<String> {
    let text = format!(
        "{edition}\nusage\nDEF_VAR V\nDEF_POS P\nDEF_JOINT Q\nV = 1\nP.X = V\nP.Y = V\nP.Z = V\n\
         Q.J1 = P.X\nQ.J2 = V\nQ.J3 = V\n{statement}\n\
         SLEEP V\nPTP F1 P\nPTP_ANGLE F1 Q\nEND\n"
    );
    let options = Options {
        robot,
        ..Options::default()
    };
    let found = load("usage.prg", text.as_bytes(), &options).diagnostics;
    found
        .iter()
        .filter(|one| one.level() == Level::Error)
        .map(|one| format!("{statement}: {}", one.reason))
        .collect()
}

// clauses: 7.1 8.1
#[test]
fn every_usage_loads_on_its_robots() {
    let mut tried = 0;
    for command in COMMANDS {
        if matches!(command.form, Form::Words(_)) {
            continue;
        }
        for robot in Robot::ALL
            .iter()
            .filter(|robot| command.robots.contains(**robot))
        {
            for statement in command
                .usage(*robot, command.since)
                .iter()
                .flat_map(|usage| statements(usage))
            {
                assert_eq!(
                    mistakes(&statement, command.since, *robot),
                    [""; 0],
                    "{}",
                    robot.name()
                );
                tried += 1;
            }
        }
    }
    assert!(tried > 500, "{tried} statements");
}

// clauses: 7.1 8.1
#[test]
fn a_robot_without_the_command_refuses_every_usage() {
    for command in COMMANDS {
        for robot in Robot::ALL
            .iter()
            .filter(|robot| !command.robots.contains(**robot))
        {
            for usage in command.usage(*robot, command.since) {
                for statement in statements(&usage) {
                    assert!(
                        !mistakes(&statement, command.since, *robot).is_empty(),
                        "{statement} on {}",
                        robot.name()
                    );
                }
            }
        }
    }
}
