//! The cells of the table: what can happen to a form on a robot.

use super::observe::Seen;
use super::outcome::Outcome;
use super::row::Row;
use tipc::Robot;

/// Cells that are not as they should be, in words.
#[derive(Clone, Debug, Default)]
pub struct Wrong {
    /// They can occur, and no case shows them.
    pub empty: Vec<String>,
    /// Cases show what the rules call impossible.
    pub contradictions: Vec<String>,
}

/// Returns the cells that are not as they should be.
pub fn wrong(rows: &[Row], seen: &Seen) -> Wrong {
    let mut wrong = Wrong::default();
    for (at, row) in rows.iter().enumerate() {
        for robot in Robot::ALL {
            for outcome in Outcome::ALL {
                let (name, text, heading) = (row.name(), row.text(), outcome.heading());
                let cell = format!("{}: {name} {text}: {heading}", robot.name());
                let cases = seen.cases(at, *robot, *outcome);
                match (row.possible(*robot, *outcome), cases) {
                    (Ok(()), None) => wrong.empty.push(cell),
                    (Err(why), Some(cases)) => {
                        wrong
                            .contradictions
                            .push(format!("{cell} ({why}) {cases:?}"));
                    }
                    (Ok(()), Some(_)) | (Err(_), None) => {}
                }
            }
        }
    }
    wrong
}
