//! Bytes that are not text, as a finding.

use super::Diagnostic;
use crate::code::Code;
use crate::source::Undecodable;

impl From<Undecodable> for Diagnostic {
    fn from(bad: Undecodable) -> Diagnostic {
        let reason = format!(
            "byte {} of the file is not valid {}",
            bad.byte,
            bad.charset.name()
        );
        let help = match bad.other {
            Some((charset, byte)) => format!(
                "the file is no {} either (byte {byte}); save it in one of the two encodings",
                charset.name()
            ),
            None => "save the file in that encoding, or name the right one".to_owned(),
        };
        Diagnostic::new(Code::Format, bad.span, reason).help(help)
    }
}
