//! The figures as tables of Markdown.

use lockstep::Figures;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use tipc::Robot;

/// Totals, ends and what ran, robot by robot.
pub fn report(figures: &Figures) -> String {
    let mut text = String::from("| what | count |\n|---|---|\n");
    for name in ["programs", "runs", "cycles", "steps", "differences"] {
        row(&mut text, name, &[figures.get(name)]);
    }
    for robot in Robot::ALL {
        let name = format!("programs on {}", robot.name());
        row(&mut text, &name, &[figures.get(&name)]);
        let name = format!("cycles on {}", robot.name());
        row(&mut text, &name, &[figures.get(&name)]);
    }
    text + &table(figures, "end") + &table(figures, "ran")
}

/// A column for each robot.
fn table(figures: &Figures, kind: &str) -> String {
    let names: Vec<&str> = Robot::ALL.iter().map(|robot| robot.name()).collect();
    let mut rows: BTreeMap<&str, Vec<u64>> = BTreeMap::new();
    let prefixes: Vec<String> = names
        .iter()
        .map(|robot| format!("{kind} {robot}/"))
        .collect();
    for (column, prefix) in prefixes.iter().enumerate() {
        for (name, count) in figures.under(prefix) {
            rows.entry(name).or_insert_with(|| vec![0; names.len()])[column] = count;
        }
    }
    let mut text = format!(
        "\n| {kind} | {} |\n|---|{}\n",
        names.join(" | "),
        "---|".repeat(names.len())
    );
    for (name, counts) in rows {
        row(&mut text, name, &counts);
    }
    text
}

fn row(text: &mut String, name: &str, counts: &[u64]) {
    let counts: Vec<String> = counts.iter().map(|count| grouped(*count)).collect();
    writeln!(text, "| {name} | {} |", counts.join(" | ")).expect("writing to a string");
}

/// Digits in groups of three.
fn grouped(count: u64) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (n, digit) in digits.chars().enumerate() {
        if n > 0 && (digits.len() - n).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}
