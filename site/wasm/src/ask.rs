//! What a page asks.

use serde::{Deserialize, Serialize};

/// A question: what is to be done with a program on a robot.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Ask {
    /// What is to be done.
    pub task: Task,
    /// The program.
    pub program: Text,
    /// `titan8`, `hand`, `generic`, or a description.
    #[serde(default = "Ask::titan8")]
    pub robot: Text,
    /// A scene by name or as a description; without one, a level floor.
    #[serde(default)]
    pub scene: Option<Text>,
    /// What happens from outside, as `--events` has it.
    #[serde(default)]
    pub events: String,
    /// After how many cycles a run ends; without it, after two minutes of the robot's time.
    #[serde(default)]
    pub cycles: Option<u64>,
    /// The language of findings: `en` or `ja`.
    #[serde(default)]
    pub lang: String,
}

/// What is to be done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Task {
    /// Find errors and warnings: `findings`, as `tipc check --format json` has them.
    Check,
    /// Run it: `findings`, and if it runs the `recording` as the page takes it, in base64.
    Run,
    /// Run it: `findings`, and if it runs the `trace` as `tipc run --trace --trace-state` writes it.
    Trace,
}

/// A file, or the name of something that needs none.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub struct Text {
    /// What the file is called; findings say it.
    pub name: String,
    /// What is in it; nothing if the name is enough.
    #[serde(default)]
    pub text: Option<String>,
}

impl Text {
    /// The name of something that needs no file.
    pub fn named(name: &str) -> Self {
        Text {
            name: name.to_owned(),
            text: None,
        }
    }
}

impl Ask {
    fn titan8() -> Text {
        Text::named("titan8")
    }
}
