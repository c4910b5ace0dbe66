//! A viewer in place of the page, which keeps what it receives.

use serde_json::Value;
use std::collections::BTreeMap;
use tip_view::live::{Session, Viewer};

/// A viewer that keeps what it receives, as the page does.
#[derive(Default)]
pub(crate) struct Page {
    pub(crate) viewer: Viewer,
    pub(crate) runs: u64,
    pub(crate) cycles: u64,
    pub(crate) frames: BTreeMap<u64, Value>,
    pub(crate) now: Value,
    pub(crate) lists: BTreeMap<&'static str, Vec<Value>>,
    pub(crate) text: String,
    pub(crate) version: u64,
    pub(crate) findings: Vec<Value>,
    pub(crate) good: bool,
    pub(crate) status: Value,
    pub(crate) scalars: Vec<String>,
}

pub(crate) const LISTS: [&str; 8] = [
    "steps", "sets", "messages", "events", "contacts", "flags", "modes", "falls",
];

/// The rows of columns, of which so many hold differences.
fn rows(columns: &Value, differences: usize) -> Vec<Vec<Value>> {
    let mut rows: Vec<Vec<Value>> = Vec::new();
    for (place, column) in columns.as_array().expect("columns").iter().enumerate() {
        let mut sum = 0;
        for (row, value) in column.as_array().expect("a column").iter().enumerate() {
            if place == 0 {
                rows.push(Vec::new());
            }
            sum += value.as_i64().unwrap_or_default();
            rows[row].push(match place < differences {
                true => sum.into(),
                false => value.clone(),
            });
        }
    }
    rows
}

impl Page {
    pub(crate) fn look(&mut self, session: &Session) -> usize {
        let mut count = 0;
        while let Some(update) = session.update(&mut self.viewer) {
            self.take(&serde_json::from_str(&update).expect("JSON"));
            count += 1;
            assert!(count < 10_000, "it never ends");
        }
        count
    }

    pub(crate) fn take(&mut self, update: &Value) {
        let number = |name: &str| update[name].as_u64().expect("a number");
        match update["type"].as_str().expect("a type") {
            "run" => {
                self.runs = number("run");
                self.frames.clear();
                self.lists.clear();
                let names = update["script"]["scalars"].as_array().expect("names");
                let names = names
                    .iter()
                    .map(|name| name.as_str().expect("a name").to_owned());
                self.scalars = names.collect();
            }
            "more" => {
                let from = number("from");
                self.frames.retain(|cycle, _| *cycle < from);
                for mut frame in rows(&update["frames"], usize::MAX) {
                    let cycle = frame.remove(0).as_u64().expect("a cycle");
                    self.frames.insert(cycle, frame.into());
                }
                for name in LISTS {
                    let list = self.lists.entry(name).or_default();
                    list.retain(|entry| entry[0].as_u64() < Some(from));
                    match name {
                        "steps" => list.extend(rows(&update[name], 2).into_iter().map(Value::from)),
                        "sets" | "contacts" => {
                            list.extend(rows(&update[name], 1).into_iter().map(Value::from));
                        }
                        _ => list.extend(update[name].as_array().expect("a list").iter().cloned()),
                    }
                }
                self.now = update["now"].clone();
                self.cycles = number("cycles");
            }
            "text" => {
                self.text = update["text"].as_str().expect("a text").to_owned();
                self.version = number("version");
            }
            "findings" => {
                self.findings = update["findings"].as_array().expect("a list").clone();
                self.good = update["good"].as_bool().expect("a truth");
            }
            "status" => self.status = update.clone(),
            other => panic!("{other}"),
        }
    }

    /// All that it has seen of the run.
    pub(crate) fn seen(&self) -> String {
        format!(
            "{} {:?} {} {:?}",
            self.cycles, self.frames, self.now, self.lists
        )
    }

    pub(crate) fn value(&self, name: &str) -> f64 {
        let scalar = self.scalars.iter().position(|scalar| scalar == name);
        let sets = self.lists["sets"].iter().rev();
        let mut own = sets.filter(|set| set[1].as_u64() == scalar.map(|scalar| scalar as u64));
        own.next().expect("it is assigned")[2]
            .as_f64()
            .expect("a number")
    }
}
