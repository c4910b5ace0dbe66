//! MESSAGE.

use crate::writer::Writer;

impl Writer {
    pub(crate) fn message(&mut self) {
        let (a, b) = (self.variable(), self.variable());
        if self.is_later() && self.random.once_in(2) {
            return self.later_message();
        }
        let line = match self.random.below(5) {
            0 => "MESSAGE".to_owned(),
            1 => "MESSAGE {braces} 100% \"quoted\" \\a".to_owned(),
            2 => format!("MESSAGE {} is %{a}%", self.random.below(10)),
            3 => "MESSAGE_CLEAR".to_owned(),
            _ => format!("MESSAGE %{a}.{}% and %{b}.0%", self.random.below(8)),
        };
        self.line(&line);
    }
}
