//! Why a build script's compilation failed.

use crate::message::Building;
use std::error::Error;
use std::fmt;

/// Why nothing could be generated. It displays every error with its place in the source.
pub struct BuildError {
    message: String,
}

impl BuildError {
    /// A setting of [`Config`](super::Config) that makes no sense.
    pub(super) fn setting(message: Building) -> Self {
        BuildError {
            message: message.to_string(),
        }
    }

    /// Programs with errors, each one rendered.
    pub(super) fn programs(errors: &[String]) -> Self {
        BuildError {
            message: errors.join("\n"),
        }
    }
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// As displayed: a build script that returns the error prints its `Debug`.
impl fmt::Debug for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl Error for BuildError {}
