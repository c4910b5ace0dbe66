//! Commands with places to fill, as completion offers them, for editors without the server.

use serde::Serialize;
use std::collections::BTreeMap;
use tip_ide::snippet;
use tipc::Robot;
use tipc::language::commands::COMMANDS;
use tipc::language::{Edition, Keyword};

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Snippet {
    prefix: String,
    body: Vec<String>,
    description: String,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    is_file_template: bool,
}

/// Returns the snippets of every command with placeholders, and that of a program.
pub(crate) fn snippets() -> BTreeMap<String, Snippet> {
    let commands = COMMANDS.iter().filter_map(|row| {
        let mut robots = Robot::ALL.iter().copied();
        let robot = robots.find(|robot| row.robots.contains(*robot))?;
        let text = snippet(row, robot, row.since);
        let names = row.robots.names();
        let only = match names.len() == Robot::ALL.len() {
            true => String::new(),
            false => format!(" ({})", names.join(", ")),
        };
        (text != row.name).then(|| {
            let snippet = Snippet {
                prefix: row.name.to_owned(),
                body: text.lines().map(str::to_owned).collect(),
                description: format!("{}{only}", row.description.english),
                is_file_template: false,
            };
            (row.name.to_owned(), snippet)
        })
    });
    commands
        .chain([("program".to_owned(), program())])
        .collect()
}

fn program() -> Snippet {
    let [version, end] = [Edition::V3_1.to_string(), Keyword::End.to_string()];
    Snippet {
        prefix: "program".to_owned(),
        body: vec![version, "${1:title}".to_owned(), "$0".to_owned(), end],
        description: "A program: version, title, statements.".to_owned(),
        is_file_template: true,
    }
}
