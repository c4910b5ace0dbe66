//! Every form of every command has its record in TIP.OBJ: the forms are those of the table of commands, the records
//! follow the memory layouts of T.I.P. 3.1 §7.

use super::{BLOCKS, INPUTS_AND_OUTPUTS, JUMPS, records};
use tipc::Robot;
use tipc::language::Edition;
use tipc::language::commands::{COMMANDS, Command, Cycles, Form, Meaning, Values};

/// VAR_KEY is VAR 0, so N is VAR 1.
const DECLARATIONS: &str = "DEF_VAR N, B\nDEF_POS P\nDEF_JOINT U\n";
const GIVEN: &str = "N = 1\nP.X = 1\nU.J1 = 1\n";

/// Forms of a number.
const CONSTANTS_AND_VARS: &[&str] = &["2.5", "N", "-N"];
const SCALARS: &[&str] = &["-3", "-N", "P.X", "-U.J2"];

// clauses: 9.4 7.1
#[test]
fn every_form_of_every_command_is_written_as_it_stands() {
    for command in COMMANDS
        .iter()
        .filter(|it| it.since == Edition::V3_1 && !matches!(it.meaning, Meaning::Keyword(_)))
    {
        for robot in Robot::ALL.iter().filter(|it| command.robots.contains(**it)) {
            let lines = lines(command, *robot);
            let program = format!("{DECLARATIONS}{GIVEN}{}", lines.join("\n"));
            let records = records(*robot, &program);
            let written = records.iter().skip(GIVEN.lines().count());
            assert_eq!(written.len(), lines.len() + 1, "{}", command.name);
            for (line, record) in lines.iter().zip(written) {
                assert_eq!(*record, expected(line), "{line} on {}", robot.name());
            }
        }
    }
}

// clauses: 9.4 7.20
#[test]
fn every_word_that_is_a_step_has_a_record_of_its_own() {
    let tables = [INPUTS_AND_OUTPUTS, BLOCKS, JUMPS].concat();
    for command in COMMANDS
        .iter()
        .filter(|it| it.since == Edition::V3_1 && matches!(it.meaning, Meaning::Keyword(_)))
    {
        // END follows every program of these tests.
        let is_shown = tables.iter().any(|(line, record)| {
            line.split(' ').next() == Some(command.name) && record.starts_with(command.name)
        });
        let is_step = command.cycles != Cycles::Zero && command.name != "END";
        assert_eq!(is_shown, is_step, "{}", command.name);
    }
}

/// Returns the command in each of its forms, with each kind of operand in each place.
fn lines(command: &Command, robot: Robot) -> Vec<String> {
    let kinds = match command.form {
        Form::Robot(form) if matches!(form.values, Values::Position | Values::Angles) => SCALARS,
        _ => CONSTANTS_AND_VARS,
    };
    let usages = command.usage(robot, command.since);
    let turns = (0..kinds.len()).flat_map(|turn| usages.iter().map(move |usage| (turn, usage)));
    turns
        .flat_map(|(turn, usage)| spelt(usage, kinds, turn))
        .collect()
}

/// Returns the lines that a form such as `PTP [HS] F1|J13 [R] x [R] y [R] z` stands for.
fn spelt(usage: &str, kinds: &[&str], turn: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for (place, word) in usage.split(' ').enumerate() {
        let number = kinds[(place + turn) % kinds.len()];
        let words = match word {
            "[HS]" => vec!["", "HS"],
            "[R]" | "[A]" => vec!["", "R", "A"],
            "[number]" => vec!["", number],
            "0…255" => vec!["14"],
            "VAR" => vec!["B"],
            "POS" => vec!["P"],
            "JOINT" => vec!["U"],
            word if word
                .chars()
                .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit()) =>
            {
                vec![if word.starts_with(|c: char| c.is_ascii_digit()) {
                    word
                } else {
                    number
                }]
            }
            word => word.split('|').collect(),
        };
        lines = lines
            .iter()
            .flat_map(|line| words.iter().map(move |word| format!("{line} {word}")))
            .collect();
    }
    let in_one_blank = |line: &String| line.split_whitespace().collect::<Vec<_>>().join(" ");
    lines.iter().map(in_one_blank).collect()
}

/// Returns the record of a line, word by word.
fn expected(line: &str) -> String {
    let mut words = line.split(' ').peekable();
    let name = words.next().expect("a command");
    let fast = words.next_if_eq(&"HS").map_or("", |_| "_HS");
    let target = words.next_if(|word| is_target(word));
    let mut record = format!(
        "{name}{fast} {}",
        match target {
            Some(target) => format!("TARGET_{target}"),
            None => "NO_TARGET".to_owned(),
        }
    );
    if name == "AD_IN" && target.is_some() {
        record += " ARG_NONE=0.000000 ARG_NONE=0.000000";
    }
    while let Some(word) = words.next() {
        let (relative, word) = match word {
            "R" => ("REL_", words.next().expect("an operand")),
            "A" => ("", words.next().expect("an operand")),
            word => ("", word),
        };
        record += &format!(" {relative}{}", operand(word));
    }
    record
}

fn is_target(word: &str) -> bool {
    ["ALL", "FLOOR", "F1", "VR1"].contains(&word) || word.starts_with("J1")
}

fn operand(word: &str) -> String {
    if let Ok(number) = word.parse::<f64>() {
        return format!("CONSTANT={number:.6}");
    }
    let (sign, name) = match word.strip_prefix('-') {
        Some(name) => ("MINUS_", name),
        None => ("", word),
    };
    let slot = match name {
        "N" => "VAR=1.000000",
        "B" => "VAR=2.000000",
        "P" => "POS=0.000000",
        "P.X" => "POS_X=0.000000",
        "U" => "JNT=0.000000",
        "U.J2" => "JNT_2=0.000000",
        name => panic!("no variable {name}"),
    };
    format!("{sign}{slot}")
}
