//! A choice of the cases that run which covers the language.

use super::observe::Seen;
use super::outcome::Outcome;
use super::row::Row;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use tip_tests::{cases, clauses, root};

/// Each form, robot, error of a command, and clause that a run shows, with the cases that show it.
pub type Shown = BTreeMap<String, BTreeSet<String>>;

/// Returns what the cases that run show.
///
/// # Panics
/// The cases cannot be read.
pub fn shown(rows: &[Row], seen: &Seen) -> Shown {
    let folder = root().join("cases");
    let mut runs = BTreeSet::new();
    let mut shown = Shown::new();
    for case in cases(&folder) {
        let expectation = ["trace", "stops"]
            .into_iter()
            .find_map(|kind| fs::read_to_string(folder.join(format!("{case}.{kind}"))).ok());
        let Some(expectation) = expectation else {
            continue;
        };
        for clause in clauses::of_header(&expectation) {
            shown
                .entry(format!("clause {clause}"))
                .or_default()
                .insert(case.clone());
        }
        runs.insert(case);
    }
    for ((row, robot, outcome), cases) in seen.all() {
        let row = &rows[row];
        let what = match outcome {
            Outcome::Valid => format!("form {} {}", row.name(), row.text()),
            error => format!("error {} {}", row.name(), error.heading()),
        };
        for what in [what, format!("robot {robot}")] {
            let running = cases.intersection(&runs).cloned();
            shown.entry(what).or_default().extend(running);
        }
    }
    // What only the compiler reports is not run.
    shown.retain(|_, cases| !cases.is_empty());
    shown
}

/// Chooses cases that show everything: each time the one that shows most of what is left.
pub fn covering(shown: &Shown) -> Vec<String> {
    let mut of_case: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (what, cases) in shown {
        for case in cases {
            of_case.entry(case).or_default().insert(what);
        }
    }
    let mut left: BTreeSet<&str> = shown.keys().map(String::as_str).collect();
    let mut chosen = Vec::new();
    while !left.is_empty() {
        let gain = |case: &&str| of_case[*case].intersection(&left).count();
        // Of several the first by name.
        let best = of_case.keys().rev().copied().max_by_key(gain);
        let best = best.expect("everything is shown by a case");
        left.retain(|what| !of_case[best].contains(what));
        chosen.push(best.to_owned());
    }
    chosen.sort();
    chosen
}

/// Returns what none of the listed cases shows.
pub fn missing(shown: &Shown, listed: &str) -> Vec<String> {
    let is_missing = |cases: &BTreeSet<String>| !listed.lines().any(|case| cases.contains(case));
    let missing = shown.iter().filter(|(_, cases)| is_missing(cases));
    missing.map(|(what, _)| what.clone()).collect()
}

/// Returns the listed names that are not of cases that run.
pub fn unknown(shown: &Shown, listed: &str) -> Vec<String> {
    let is_known = |name: &&str| shown.values().any(|cases| cases.contains(*name));
    let unknown = listed.lines().filter(|name| !is_known(name));
    unknown.map(str::to_owned).collect()
}
