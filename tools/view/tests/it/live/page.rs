//! A viewer in place of the page, which keeps what it receives.

use serde_json::{Value, json};
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
    /// Under each key of the log `[cycle, value]`.
    pub(crate) log: BTreeMap<String, Vec<Value>>,
    pub(crate) text: String,
    pub(crate) version: u64,
    pub(crate) findings: Vec<Value>,
    pub(crate) good: bool,
    pub(crate) status: Value,
    pub(crate) scalars: Vec<String>,
}

/// The numbers of a column of differences.
fn sums(column: &Value) -> Vec<i64> {
    let mut sum = 0;
    let differences = column.as_array().expect("a column").iter();
    differences
        .map(|difference| {
            sum += difference.as_i64().expect("a whole number");
            sum
        })
        .collect()
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
                self.log.clear();
                let names = update["script"]["scalars"].as_array().expect("names");
                let names = names
                    .iter()
                    .map(|name| name.as_str().expect("a name").to_owned());
                self.scalars = names.collect();
            }
            "more" => {
                let from = number("from");
                self.frames.retain(|cycle, _| *cycle < from);
                let columns = update["frames"].as_array().expect("columns");
                let columns: Vec<_> = columns.iter().map(sums).collect();
                let (cycles, motion) = columns.split_first().expect("cycles");
                for (row, cycle) in cycles.iter().enumerate() {
                    let motion = motion.iter().map(|column| column[row]);
                    self.frames.insert(*cycle as u64, motion.collect());
                }
                for entries in self.log.values_mut() {
                    entries.retain(|entry| entry[0].as_u64() < Some(from));
                }
                for (key, columns) in update["log"].as_object().expect("keys") {
                    let values = columns[1].as_array().expect("values");
                    let cycles = sums(&columns[0]);
                    assert_eq!(cycles.len(), values.len(), "{key}");
                    let entries = cycles.iter().zip(values);
                    let entries = entries.map(|(cycle, value)| json!([cycle, value]));
                    self.log.entry(key.clone()).or_default().extend(entries);
                }
                self.log.retain(|_, entries| !entries.is_empty());
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
            self.cycles, self.frames, self.now, self.log
        )
    }

    pub(crate) fn value(&self, name: &str) -> f64 {
        let scalar = self.scalars.iter().position(|scalar| scalar == name);
        let key = format!("set.{}", scalar.expect("a variable"));
        let last = self.log[&key].last().expect("it is assigned");
        last[1].as_f64().expect("a number")
    }
}
