//! Comments that silence warnings: `// tip: allow(W112)`.
//!
//! At the end of a line, such a comment applies to that line; on a line of its own, to the next statement; above the
//! first statement, to the whole program.

use crate::message::Allowing;
use std::collections::HashMap;
use tipc::code::{Code, Level};
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::language::Edition;
use tipc::lex::split_comment;
use tipc::source::{Source, Span, Unit};
use tipc::syntax::Module;

/// Comments of a program that silence warnings.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Allows {
    allows: Vec<Allow>,
    /// The comments for each code on each line, or on every line, by their indices among all.
    by_line: HashMap<(Code, Option<u32>), Vec<usize>>,
    /// Faults of the comments themselves.
    faults: Vec<Diagnostic>,
}

#[derive(Clone, Debug, PartialEq)]
struct Allow {
    code: Code,
    /// The code in the comment.
    location: Span,
    silences: bool,
}

/// The start of such a comment, after its slashes.
const START: &str = "tip:";
const WORD: &str = "allow";

impl Allows {
    pub(crate) fn of(source: &Source, module: &Module) -> Self {
        let mut allows = Allows::default();
        let text = source.text();
        let (Some(first), Some(last)) = (module.statements.first(), module.statements.last())
        else {
            return allows;
        };
        if !text.contains(START) && !text.contains("TIP:") {
            return allows;
        }
        let is_blank = |code: Span| source.slice(code).trim().is_empty();
        // The next line with text after END, where there are no statements.
        let mut below = 0;
        for line in source.lines().filter(|line| line.number != 2) {
            let (code, comment) = split_comment(text, line.span);
            let Some(list) = comment.and_then(|comment| list(text, comment)) else {
                continue;
            };
            let is_after_end = line.number > last.line;
            let line = if line.number < first.line {
                None
            } else if is_after_end && is_blank(code) {
                if below <= line.number {
                    let mut lines = source.lines_from(line.number + 1);
                    let next = lines.find(|it| !is_blank(split_comment(text, it.span).0));
                    below = next.map_or(u32::MAX, |it| it.number);
                }
                Some(below)
            } else if is_blank(code) {
                let next = module
                    .statements
                    .partition_point(|it| it.line <= line.number);
                module.statements.get(next).map(|it| it.line)
            } else {
                Some(line.number)
            };
            let known = allows.allows.len();
            let faults = allows.faults.len();
            allows.read(source, list, line);
            if is_after_end {
                // Comments in the notes after END are not part of the program.
                allows.faults.truncate(faults);
                let kept = allows.allows.split_off(known);
                let kept = kept.into_iter().filter(|it| it.code == Code::AfterEnd);
                allows.allows.extend(kept);
            }
        }
        allows
    }

    /// Reads the codes of a list: what is between the parentheses.
    fn read(&mut self, source: &Source, list: Result<Span, Span>, line: Option<u32>) {
        let list = match list {
            Ok(list) => list,
            Err(location) => {
                let fault = Diagnostic::new(Code::Allow, location, Allowing::NoList);
                return self.faults.push(fault.help(Allowing::WriteList));
            }
        };
        let mut start = list.start;
        for part in source.slice(list).split(',') {
            let name = part.trim();
            let at = start + (part.len() - part.trim_start().len());
            let location = Span::new(at, at + name.len());
            start += part.len() + 1;
            match code(name) {
                Ok(code) => {
                    let alike = self.by_line.entry((code, line)).or_default();
                    alike.push(self.allows.len());
                    self.allows.push(Allow {
                        code,
                        location,
                        silences: false,
                    });
                }
                Err(reason) => {
                    let fault = Diagnostic::new(Code::Allow, location, reason);
                    self.faults.push(fault.help(Allowing::WriteList));
                }
            }
        }
    }

    /// Takes out the warnings that a comment silences.
    pub(crate) fn silence(&mut self, source: &Source, diagnostics: &mut Diagnostics) {
        if !self.allows.is_empty() {
            diagnostics.retain(|one| !self.silences(source, one));
        }
    }

    fn silences(&mut self, source: &Source, diagnostic: &Diagnostic) -> bool {
        let line = source.position(diagnostic.span.start, Unit::Character).line;
        let mut silences = false;
        for of in [None, Some(line)] {
            let Some(alike) = self.by_line.get_mut(&(diagnostic.code, of)) else {
                continue;
            };
            silences = true;
            // All of these comments are used once one diagnostic matches.
            for allow in alike.drain(..) {
                self.allows[allow].silences = true;
            }
        }
        silences
    }

    /// Returns the warnings about comments that are wrong or silence nothing.
    pub(crate) fn warnings(&mut self, source: &Source) -> Diagnostics {
        let is_judged = |code: Code| code != Code::Allow && !is_found_later(code);
        let idle = |allow: &&Allow| !allow.silences && is_judged(allow.code);
        let idle = self.allows.iter().filter(idle).map(|allow| {
            let diagnostic =
                Diagnostic::new(Code::Allow, allow.location, Allowing::SilencesNothing);
            diagnostic.help(Allowing::TakeOut)
        });
        let mut found = Diagnostics::default();
        found.extend(self.faults.iter().cloned().chain(idle));
        self.silence(source, &mut found);
        found
    }
}

/// Returns the text between the parentheses of such a comment, or the comment as the error if it has none; `None` for
/// any other comment.
fn list(text: &str, comment: Span) -> Option<Result<Span, Span>> {
    let after = |from: usize, word: &str| {
        let rest = text.get(from..comment.end)?;
        let at = from + (rest.len() - rest.trim_start().len());
        let found = text
            .get(at..at + word.len())
            .filter(|_| at + word.len() <= comment.end)?;
        found.eq_ignore_ascii_case(word).then_some(at + word.len())
    };
    let end = after(after(comment.start + "//".len(), START)?, WORD)?;
    let open = after(end, "(");
    let close = open.and_then(|open| Some(open + text[open..comment.end].find(')')?));
    Some(match open.zip(close) {
        Some((open, close)) => Ok(Span::new(open, close)),
        None => Err(comment),
    })
}

/// Returns true if it is found after a program is loaded, where the robot's geometry or the crate is known.
const fn is_found_later(code: Code) -> bool {
    matches!(
        code,
        Code::OutOfReach
            | Code::PathLeavesReach
            | Code::HitsItself
            | Code::Unanswered
            | Code::OtherRobot
    )
}

/// Returns the warning of that name.
fn code(name: &str) -> Result<Code, Allowing> {
    let is_it = |code: &&Code| code.id().eq_ignore_ascii_case(name);
    match Code::ALL.iter().copied().find(|code| is_it(&code)) {
        None => Err(Allowing::NoCode { name: name.into() }),
        Some(code) if code.level(Edition::default()) == Level::Error => {
            Err(Allowing::Error { code: code.id() })
        }
        Some(code) => Ok(code),
    }
}
