//! Bytes that are not text, as a finding.

use super::Diagnostic;
use crate::code::Code;
use crate::message::Reading;
use crate::source::Undecodable;

impl From<Undecodable> for Diagnostic {
    fn from(bad: Undecodable) -> Diagnostic {
        let reason = Reading::NotValid {
            byte: bad.byte,
            encoding: bad.charset.name(),
        };
        let help = match bad.other {
            Some((charset, byte)) => Reading::NotTheOtherEither {
                encoding: charset.name(),
                byte,
            },
            None => Reading::SaveInThatEncoding,
        };
        Diagnostic::new(Code::Format, bad.span, reason).help(help)
    }
}
