//! What stands below the options in Japanese: examples, and what a command does and answers.

macro_rules! endings {
    ($($command:literal),* $(,)?) => {
        &[$(($command, include_str!(concat!("../../help/", $command, ".txt")))),*]
    };
}

/// A command, its words joined by `_`, and its text.
pub(super) const ENDINGS: &[(&str, &str)] = endings![
    "tipc",
    "new",
    "check",
    "run",
    "fmt",
    "log",
    "plot",
    "emit",
    "cycles",
    "verify",
    "view",
    "serve",
    "debug",
    "dap",
    "migrate",
    "explain",
    "lsp",
    "completions",
    "man",
    "robot_list",
    "robot_show",
    "robot_check",
    "robot_import",
    "robot_export",
];
