//! Warnings of a program that loads, and the comments that silence them.

use super::{Loaded, Options, in_order, title};
use crate::allow::Allows;
use crate::analysis::Flow;
use crate::code::Code;
use crate::diagnostic::{Diagnostic, Findings};
use crate::message::{Habit, Reading};
use crate::parse;
use crate::source::{Encoding, Source, Span, looks_like};
use crate::syntax::Module;
use crate::warn::Judged;

/// Adds what an analysis of the program warns of, and leaves out what its comments silence.
pub(super) fn find(
    loaded: &Loaded,
    mut found: Findings,
    bytes: &[u8],
    options: &Options,
) -> Findings {
    if let Some(program) = &loaded.program {
        let judged = Judged {
            source: &loaded.source,
            module: &loaded.module,
            symbols: &loaded.symbols,
            program,
            flow: &Flow::of(program),
            robot: options.robot,
        };
        judged.warn(&mut found);
        let encoding = other_encoding(loaded, bytes, options);
        let title = title::warn(loaded, options);
        let after_end = after_end(&loaded.source, &loaded.module);
        found.extend(encoding.into_iter().chain(title).chain(after_end));
    }
    let mut allows = Allows::of(&loaded.source, &loaded.module);
    allows.silence(&loaded.source, &mut found);
    if loaded.program.is_some() {
        found.extend(allows.warnings(&loaded.source));
    }
    found
}

impl Loaded {
    /// Adds warnings that others found, but those that a comment silences.
    pub fn add(&mut self, mut found: Vec<Diagnostic>) {
        if found.is_empty() {
            return;
        }
        Allows::of(&self.source, &self.module).silence(&self.source, &mut found);
        let mut all = Findings::from(std::mem::take(&mut self.diagnostics));
        all.extend(found);
        let (diagnostics, omitted) = in_order(all, self.module.edition);
        self.diagnostics = diagnostics;
        self.omitted.append(omitted);
    }
}

/// Warns of the first statement after END.
fn after_end(source: &Source, module: &Module) -> Option<Diagnostic> {
    let place = parse::after_end(source, module)?;
    let finding = Diagnostic::new(Code::AfterEnd, place, Habit::StandsAfterEnd);
    let end = module.statements.last()?;
    Some(
        finding
            .label(end.span, Habit::EndsTheText)
            .help(Habit::MoveEndOrComment),
    )
}

/// Warns of a file that can be read, but not as what was written: in EUC-JP, say.
fn other_encoding(loaded: &Loaded, bytes: &[u8], options: &Options) -> Option<Diagnostic> {
    if options.encoding != Encoding::Auto {
        return None;
    }
    let encoding = looks_like(bytes)?;
    let text = loaded.source.text();
    let at = text.find(|c: char| !c.is_ascii() || c == '\u{1B}')?;
    let length = text[at..].find(['\n', '\r']).unwrap_or(text.len() - at);
    let place = Span::new(at, at + length);
    let finding = Diagnostic::new(Code::OtherEncoding, place, Reading::OtherCharacters);
    Some(finding.help(Habit::OtherEncoding { encoding }))
}
