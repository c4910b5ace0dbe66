//! Goals and conditions by which the runs of a table are ranked, and the Pareto front of several goals.

use crate::columns::{Column, Kind, Row};
use crate::error::{SweepError, Sweeping};
use crate::spec::ArgumentError;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// A column to maximize or minimize.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Goal {
    /// More is better.
    Maximize(String),
    /// Less is better.
    Minimize(String),
}

impl Goal {
    /// Returns the name of the column.
    pub fn name(&self) -> &str {
        match self {
            Goal::Maximize(name) | Goal::Minimize(name) => name,
        }
    }
}

/// A comparison of a figure with a number, such as `falls=0`.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(try_from = "String", into = "String")]
pub struct Condition {
    /// The name of the figure.
    pub name: String,
    /// The comparison.
    pub operator: Operator,
    /// The number.
    pub value: f64,
}

/// A comparison of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `<`
    Less,
    /// `<=`
    AtMost,
    /// `>`
    Greater,
    /// `>=`
    AtLeast,
    /// `=`
    Equal,
}

impl Operator {
    /// All operators, longer ones first.
    const ALL: [(&str, Self); 5] = [
        ("<=", Self::AtMost),
        (">=", Self::AtLeast),
        ("<", Self::Less),
        (">", Self::Greater),
        ("=", Self::Equal),
    ];

    fn symbol(self) -> &'static str {
        let mut all = Self::ALL.iter();
        let found = all.find(|(_, operator)| *operator == self);
        found.map_or("", |(symbol, _)| symbol)
    }
}

impl Condition {
    /// Returns true if the condition holds for a number; false for NaN.
    pub fn holds(&self, value: f64) -> bool {
        match self.operator {
            Operator::Less => value < self.value,
            Operator::AtMost => value <= self.value,
            Operator::Greater => value > self.value,
            Operator::AtLeast => value >= self.value,
            Operator::Equal => value == self.value,
        }
    }
}

impl FromStr for Condition {
    type Err = ArgumentError;

    fn from_str(text: &str) -> Result<Self, ArgumentError> {
        let mut operators = Operator::ALL.iter();
        let parts = operators.find_map(|(symbol, operator)| {
            let (name, value) = text.split_once(symbol)?;
            let value = value
                .trim()
                .parse()
                .ok()
                .filter(|value: &f64| value.is_finite())?;
            let name = Some(name.trim()).filter(|name| !name.is_empty())?;
            Some((name.to_owned(), *operator, value))
        });
        let (name, operator, value) = parts.ok_or_else(|| {
            let text = text.to_owned();
            ArgumentError(Sweeping::NotACondition { text })
        })?;
        Ok(Condition {
            name,
            operator,
            value,
        })
    }
}

impl TryFrom<String> for Condition {
    type Error = ArgumentError;

    fn try_from(text: String) -> Result<Self, ArgumentError> {
        text.parse()
    }
}

impl From<Condition> for String {
    fn from(condition: Condition) -> String {
        condition.to_string()
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}{}", self.name, self.operator.symbol(), self.value)
    }
}

/// The goals and the conditions of a table.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
pub struct Ranking {
    /// The goals. One of them gives the best run, several give the Pareto front.
    pub goals: Vec<Goal>,
    /// The conditions that a run must meet to be ranked.
    #[serde(rename = "where")]
    pub conditions: Vec<Condition>,
}

impl Ranking {
    /// Checks the names, and adds the goal of a table without one: the speed of a walking robot, or the greatest height of the first
    /// object in a hand.
    ///
    /// # Errors
    /// The table has no such column of numbers.
    pub fn of(mut self, columns: &[Column]) -> Result<Self, SweepError> {
        let has = |name: &str| {
            let mut columns = columns.iter();
            columns.any(|column| column.name == name && column.kind != Kind::Text)
        };
        let goals = self.goals.iter().map(Goal::name);
        let conditions = self.conditions.iter().map(|condition| &*condition.name);
        if let Some(name) = goals.chain(conditions).find(|name| !has(name)) {
            let numbers = columns.iter().filter(|column| column.kind != Kind::Text);
            let names: Vec<&str> = numbers.map(|column| &*column.name).collect();
            let error = SweepError::from(Sweeping::UnknownColumn {
                name: name.to_owned(),
                known: names.join(", "),
            });
            return Err(error.suggest(name, names.into_iter()));
        }
        if self.goals.is_empty() {
            let default = ["speed", "object1_highest"]
                .into_iter()
                .find(|name| has(name));
            self.goals
                .extend(default.map(|name| Goal::Maximize(name.to_owned())));
        }
        Ok(self)
    }

    /// Returns the numbers of the goals, larger ones better; `None` if the run is not ranked: it failed, does not meet a condition, or
    /// lacks a number.
    fn scores(&self, row: &Row) -> Option<Vec<f64>> {
        let meets = |condition: &Condition| {
            let value = row.named(&condition.name);
            value.is_some_and(|value| condition.holds(value))
        };
        if row.has_failed() || !self.conditions.iter().all(meets) {
            return None;
        }
        let scores = self.goals.iter().map(|goal| {
            let value = row.named(goal.name()).filter(|value| !value.is_nan())?;
            Some(match goal {
                Goal::Maximize(_) => value,
                Goal::Minimize(_) => -value,
            })
        });
        scores.collect()
    }
}

/// The best runs of a table (Pareto front): no other run is at least as good in all goals and better in one. If runs
/// are equal, the first one counts.
#[derive(Clone, Debug, Default)]
pub struct Front {
    ranking: Ranking,
    best: Vec<(Vec<f64>, Row)>,
}

impl Front {
    /// Returns the front of a table without rows.
    pub fn new(ranking: Ranking) -> Self {
        Front {
            ranking,
            best: Vec::new(),
        }
    }

    /// Adds a row.
    pub fn add(&mut self, row: &Row) {
        let Some(scores) = self.ranking.scores(row).filter(|scores| !scores.is_empty()) else {
            return;
        };
        let reaches =
            |one: &[f64], other: &[f64]| one.iter().zip(other).all(|(one, other)| one >= other);
        if self.best.iter().any(|(best, _)| reaches(best, &scores)) {
            return;
        }
        self.best.retain(|(best, _)| !reaches(&scores, best));
        self.best.push((scores, row.clone()));
    }

    /// Returns the goals and the conditions.
    pub fn ranking(&self) -> &Ranking {
        &self.ranking
    }

    /// Returns the rows of the front, the best one of the first goal first.
    pub fn rows(&self) -> Vec<&Row> {
        let mut best: Vec<_> = self.best.iter().collect();
        best.sort_by(|(one, _), (other, _)| {
            let order = one
                .iter()
                .zip(other)
                .map(|(one, other)| other.total_cmp(one));
            order.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
        });
        best.into_iter().map(|(_, row)| row).collect()
    }
}
