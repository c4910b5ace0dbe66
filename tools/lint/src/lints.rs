//! Lints: valid programs that are probably not what their author meant.
//!
//! A lint must not fire on programs without a mistake: its file documents when it stays silent.

mod flow;
mod message;
mod motions;
mod statements;

use crate::allow::Allows;
use crate::message::Foreign;
use crate::{Loaded, Options};
use tipc::Robot;
use tipc::analysis::flow::Flow;
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::language::Keyword;
use tipc::language::commands::{self, Meaning};
use tipc::lex::{Kind, Token, lex};
use tipc::load::lowered;
use tipc::message::{Reading, Suggestion};
use tipc::parse;
use tipc::program::{Program, StepId};
use tipc::source::{Encoding, Source, Span, looks_like};
use tipc::symbols::Symbols;
use tipc::syntax::{Module, Statement};

/// A program, and the source of its steps.
#[derive(Clone, Copy)]
struct LintContext<'a> {
    source: &'a Source,
    module: &'a Module,
    symbols: &'a Symbols,
    program: &'a Program,
    flow: &'a Flow,
    robot: Robot,
}

/// Adds the lints of a file to its diagnostics, without the warnings that its comments silence.
pub(crate) fn find(
    loaded: &Loaded,
    mut found: Diagnostics,
    bytes: &[u8],
    options: &Options,
) -> Diagnostics {
    if let Some(program) = &loaded.program {
        let context = LintContext {
            source: &loaded.source,
            module: &loaded.module,
            symbols: &loaded.symbols,
            program,
            flow: &Flow::of(program),
            robot: options.robot,
        };
        context.warn(&mut found);
        found.extend(other_encoding(loaded, bytes, options));
        found.extend(title(loaded, options));
        found.extend(after_end(&loaded.source, &loaded.module));
    }
    let mut allows = Allows::of(&loaded.source, &loaded.module);
    allows.silence(&loaded.source, &mut found);
    if loaded.program.is_some() {
        found.extend(allows.warnings(&loaded.source));
    }
    found
}

/// Adds warnings that others found about a program, except those that a comment silences.
pub(crate) fn add(loaded: &mut Loaded, found: Vec<Diagnostic>) {
    if !found.is_empty() {
        let mut found = Diagnostics::from(found);
        Allows::of(&loaded.source, &loaded.module).silence(&loaded.source, &mut found);
        loaded.report(found);
    }
}

impl LintContext<'_> {
    /// Adds the warnings about a program.
    fn warn(&self, found: &mut Diagnostics) {
        let mut warnings = Diagnostics::default();
        let meant = self.add_warnings(&mut warnings);
        // A variable that a text was meant to show is not also reported as unread.
        let is_meant = |name: &String| meant.names.contains(name.as_str());
        found.retain(|diagnostic| match diagnostic.code {
            Code::NeverRead if meant.any => false,
            Code::Unused | Code::NeverRead => !diagnostic.subject.as_ref().is_some_and(is_meant),
            _ => true,
        });
        found.append(warnings);
    }

    /// Adds all warnings, and returns the values that texts were meant to show.
    fn add_warnings(&self, found: &mut Diagnostics) -> message::MeantValues {
        // Single statements, and the values that they read.
        statements::unassigned(self, found);
        statements::commands(self, found);
        statements::swapped_signs(self, found);
        let meant = message::warn(self, found);
        statements::threads(self, found);
        motions::overridden(self, found);
        // Conditions and jumps.
        let constant = flow::constant(self);
        let open: Vec<StepId> = constant.iter().map(|one| one.step).collect();
        let unreachable = flow::Unreachable::of(self, &open);
        flow::conditions(self, &constant, &unreachable, found);
        flow::routines(self, &unreachable, found);
        motions::waits(self, &unreachable, found);
        let glued = flow::GluedJumps::of(self);
        unreachable.warn(self, &glued, found);
        glued.warn(found);
        meant
    }

    fn statement(&self, step: StepId) -> Option<&Statement> {
        let index = self.module.statement_of(step)?;
        Some(&self.module.statements[index])
    }
}

fn after_end(source: &Source, module: &Module) -> Option<Diagnostic> {
    let location = parse::after_end(source, module)?;
    let diagnostic = Diagnostic::new(Code::AfterEnd, location, Suggestion::StandsAfterEnd);
    let end = module.statements.last()?;
    Some(
        diagnostic
            .label(end.span, Suggestion::EndsTheText)
            .help(Foreign::MoveEndOrComment),
    )
}

/// Returns the warning about a file in an encoding that is read wrongly, such as EUC-JP.
fn other_encoding(loaded: &Loaded, bytes: &[u8], options: &Options) -> Option<Diagnostic> {
    if options.encoding != Encoding::Auto {
        return None;
    }
    let encoding = looks_like(bytes)?;
    let text = loaded.source.text();
    let at = text.find(|c: char| !c.is_ascii() || c == '\u{1B}')?;
    let length = text[at..].find(['\n', '\r']).unwrap_or(text.len() - at);
    let location = Span::new(at, at + length);
    let diagnostic = Diagnostic::new(Code::OtherEncoding, location, Reading::OtherCharacters);
    Some(diagnostic.help(Suggestion::OtherEncoding { encoding }))
}

/// Returns the warning about a statement in line 2, if the program loads with a title put above it.
fn title(loaded: &Loaded, options: &Options) -> Option<Diagnostic> {
    let source = &loaded.source;
    let line = source.line(2).span;
    let mut tokens = Vec::new();
    if lex(source.text(), line, &mut tokens).is_some() || !is_statement(loaded, &tokens) {
        return None;
    }
    let (before, after) = source.text().split_at(line.start);
    let text = format!("{before}A title\n{after}");
    let options = Options {
        encoding: Encoding::Utf8,
        ..*options
    };
    let (titled, found) = lowered(source.name(), text.as_bytes(), &options);
    if found.have_error(titled.module.edition) {
        return None;
    }
    let location = tokens.first()?.span.to(tokens.last()?.span);
    let diagnostic = Diagnostic::new(Code::StatementAsTitle, location, Suggestion::TitleHere);
    Some(diagnostic.help(Suggestion::Title))
}

/// Returns true if these words begin a statement. A title of one word does not.
fn is_statement(loaded: &Loaded, tokens: &[Token]) -> bool {
    let Some(first) = tokens.first() else {
        return false;
    };
    let word = loaded.source.slice(first.span);
    if matches!(tokens.get(1), Some(next) if matches!(next.kind, Kind::Assign(_))) {
        return true;
    }
    // Any text may follow these words.
    let is_text = |meaning| {
        let words = [Keyword::Rem, Keyword::Message, Keyword::End];
        words.map(Meaning::Keyword).contains(&meaning)
    };
    let command = commands::find(word).filter(|command| !is_text(command.meaning));
    command.is_some() && (tokens.len() > 1 || word.contains('_'))
}
