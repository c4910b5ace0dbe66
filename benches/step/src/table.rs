//! A table with a row for each entrant and a column for each motion; after each number, how it compares
//! with that of the compiled program.

use native::motion::Motion;

const ENTRANTS: [&str; 9] = [
    "compiled",
    "by_hand",
    "c_switch",
    "statig",
    "interpreter",
    "luajit",
    "lua54",
    "rune",
    "rhai",
];

/// Prints it; rows without a number are left out.
pub(crate) fn print(motions: &[Motion], number: impl Fn(&str, Motion) -> Option<f64>) {
    let names: Vec<_> = motions.iter().map(|motion| motion.name()).collect();
    println!("| | {} |", names.join(" | "));
    println!("|---|{}", "---:|".repeat(names.len()));
    let compiled: Vec<_> = motions
        .iter()
        .map(|motion| number("compiled", *motion))
        .collect();
    for entrant in ENTRANTS {
        let numbers: Vec<_> = motions
            .iter()
            .map(|motion| number(entrant, *motion))
            .collect();
        if numbers.iter().all(Option::is_none) {
            continue;
        }
        let cells: Vec<_> = numbers
            .iter()
            .zip(&compiled)
            .map(|cell| match cell {
                (Some(number), Some(compiled)) => {
                    format!("{number:.1} ({:.2})", number / compiled)
                }
                _ => "–".to_owned(),
            })
            .collect();
        println!("| {entrant} | {} |", cells.join(" | "));
    }
}
