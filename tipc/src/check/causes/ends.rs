//! A word that stands where END was meant.

use crate::code::Code;
use crate::diagnostic::{Diagnostic, Findings};
use crate::language::Keyword;
use crate::message::{Habit, Message, Suggesting};
use crate::suggest::is_near;

/// The word that was to be END at the end of the text: STOP, EDN. One mistake is one finding.
pub(super) fn last_word(found: &mut Findings) {
    let Some(missing) = found.iter().position(|it| it.code == Code::NoEnd) else {
        return;
    };
    let place = found[missing].span;
    let unknown = |it: &Diagnostic| it.span == place && it.code == Code::UnknownCommand;
    let Some(word) = found.iter().position(unknown) else {
        return;
    };
    let ends = [Habit::Stop, Habit::Exit].map(Message::from);
    let end = Keyword::End.word();
    let subject = found[word].subject.as_deref();
    if subject.is_some_and(|subject| is_near(subject, end)) {
        found[word].help = Some(Suggesting::DidYouMean { near: end.into() }.into());
        found.remove(missing);
    } else if found[word]
        .help
        .as_ref()
        .is_some_and(|help| ends.contains(help))
    {
        found.remove(word);
    }
}
