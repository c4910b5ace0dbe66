//! Errors of a specification, found before the first run, and of cases.

use crate::message::{Sweeping, Texts};
use std::fmt;
use tipc::Loaded;
use tipc::message::Lang;

/// A reason why a sweep cannot run.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepError(Box<Parts>);

#[derive(Clone, Debug, PartialEq)]
struct Parts {
    reason: Sweeping,
    /// The nearest known name.
    near: Option<String>,
    axis: Option<String>,
    /// The case whose values are not allowed, and these values.
    case: Option<(u64, String)>,
}

impl SweepError {
    /// Returns the error of an axis.
    pub(crate) fn axis(axis: &str, reason: impl Into<SweepError>) -> Self {
        let mut error = reason.into();
        error.0.axis = Some(axis.to_owned());
        error
    }

    /// Returns the error that the values of a case cause.
    pub(crate) fn in_case(mut self, number: u64, values: String) -> Self {
        self.0.case = Some((number, values));
        self
    }

    /// Returns an error of another crate.
    pub(crate) fn says(error: impl fmt::Display) -> Self {
        let text = Texts::of(|_| error.to_string());
        Sweeping::Says { text }.into()
    }

    /// Returns the errors of a file.
    pub(crate) fn found(loaded: &Loaded) -> Self {
        let text = Texts::found(loaded);
        Sweeping::Says { text }.into()
    }

    /// Adds the nearest of the known names, if one is near.
    pub(crate) fn suggest<'a>(mut self, name: &str, known: impl Iterator<Item = &'a str>) -> Self {
        let wanted = name.to_ascii_lowercase();
        let distance =
            |known: &str| strsim::damerau_levenshtein(&known.to_ascii_lowercase(), &wanted);
        let near = known.map(|known| (distance(known), known));
        let near = near.filter(|(distance, _)| *distance <= 1 + name.len() / 4);
        self.0.near = near.min().map(|(_, near)| near.to_owned());
        self
    }

    /// Returns the message in a language.
    pub fn text(&self, lang: Lang) -> String {
        let say = |message: Sweeping| message.in_lang(lang).to_string();
        let mut text = say(self.0.reason.clone());
        if let Some(near) = self.0.near.clone() {
            let reason = text.into();
            text = say(Sweeping::Suggests { reason, near });
        }
        if let Some(axis) = self.0.axis.clone() {
            let reason = text.into();
            text = say(Sweeping::CannotVary { axis, reason });
        }
        if let Some((case, values)) = self.0.case.clone() {
            let (case, values, reason) = (case.to_string(), values.into(), text.into());
            text = say(Sweeping::InCase {
                case,
                values,
                reason,
            });
        }
        text
    }
}

impl From<Sweeping> for SweepError {
    fn from(reason: Sweeping) -> Self {
        SweepError(Box::new(Parts {
            reason,
            near: None,
            axis: None,
            case: None,
        }))
    }
}

impl fmt::Display for SweepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(Lang::English))
    }
}

impl std::error::Error for SweepError {}
