//! Errors of a specification, found before the first run.

use std::fmt;

/// A reason why a sweep cannot run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SweepError {
    axis: Option<String>,
    reason: String,
    help: Option<String>,
}

impl SweepError {
    pub(crate) fn new(reason: impl Into<String>) -> Self {
        SweepError {
            axis: None,
            reason: reason.into(),
            help: None,
        }
    }

    pub(crate) fn axis(axis: &str, reason: impl Into<String>) -> Self {
        SweepError {
            axis: Some(axis.to_owned()),
            ..Self::new(reason)
        }
    }

    pub(crate) fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Makes the error of an unknown name, with the nearest known one if one is near.
    pub(crate) fn unknown<'a>(
        name: &str,
        what: &str,
        known: impl Iterator<Item = &'a str>,
    ) -> Self {
        let wanted = name.to_ascii_lowercase();
        let near = known
            .map(|known| {
                (
                    strsim::damerau_levenshtein(&known.to_ascii_lowercase(), &wanted),
                    known,
                )
            })
            .filter(|(distance, _)| *distance <= 1 + name.len() / 4)
            .min();
        let error = Self::axis(name, format!("this is {what}"));
        match near {
            Some((_, near)) => error.with_help(format!("did you mean {near}?")),
            None => error,
        }
    }
}

impl fmt::Display for SweepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(axis) = &self.axis {
            write!(f, "cannot vary '{axis}': ")?;
        }
        f.write_str(&self.reason)?;
        match &self.help {
            Some(help) => write!(f, "; {help}"),
            None => Ok(()),
        }
    }
}

impl std::error::Error for SweepError {}
