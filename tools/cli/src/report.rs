//! Findings and errors, for people on standard error and for tools on standard output.

use super::choices::Format;
use super::error::Error;
use super::output;
use super::sarif::Document;
use super::shown::Shown;
use crate::message::Checking;
use std::io::{self, Write};
use tip_lint::message::More;
use tip_runtime::printable::Printable;
use tipc::Loaded;
use tipc::code::{Code, Level};
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;
use tipc::render;

/// The most findings of a file that people see at once.
const MOST: usize = 50;

/// What was found in several files.
#[derive(Debug)]
pub(super) struct Total {
    files: usize,
    errors: usize,
    warnings: usize,
    /// Programs in which nothing is found are not mentioned.
    quiet: bool,
    /// All of it, where one document is asked for.
    document: Option<Document>,
}

impl Total {
    /// Nothing yet.
    pub(super) fn new(shown: Shown, quiet: bool) -> Self {
        let is_document = shown.message_format == Format::Sarif;
        Total {
            files: 0,
            errors: 0,
            warnings: 0,
            quiet,
            document: is_document.then(|| Document::new(shown.lang())),
        }
    }

    /// Another file.
    pub(super) fn add(&mut self, loaded: &Loaded) {
        self.files += 1;
        self.errors += count(loaded, Level::Error);
        self.warnings += count(loaded, Level::Warning);
        if let Some(document) = &mut self.document {
            document.add(loaded);
        }
    }

    /// What is found in a file, to where findings go.
    pub(super) fn check(&self, loaded: &Loaded, shown: Shown) -> Result<(), Error> {
        match self.quiet && loaded.diagnostics.is_empty() {
            true => Ok(()),
            false => check(loaded, shown),
        }
    }

    /// The sum over all files: for people, if there are several; or the document.
    pub(super) fn report(self, shown: Shown) -> Result<(), Error> {
        if let Some(document) = self.document {
            return output::print(document.text());
        }
        let is_silent = self.quiet && self.errors + self.warnings == 0;
        if self.files > 1 && shown.message_format == Format::Human && !is_silent {
            let total = Checking::Total {
                files: self.files.into(),
                errors: self.errors.into(),
                warnings: self.warnings.into(),
            };
            complain(&format!("{}\n", total.in_lang(shown.lang())));
        }
        Ok(())
    }
}

/// Where the findings about programs go: snippets for people to standard error, the forms for tools to standard output.
pub(super) fn check(loaded: &Loaded, shown: Shown) -> Result<(), Error> {
    let text = render(loaded, shown);
    match shown.message_format {
        Format::Human => {
            shows(&text);
            complain(&format!("{}\n", summary(loaded).in_lang(shown.lang())));
            Ok(())
        }
        Format::Short | Format::Json => output::print(&text),
        // They are part of one document, at the end.
        Format::Sarif => Ok(()),
    }
}

/// The findings about a program that a command is going to use: all to standard error.
pub(super) fn findings(loaded: &Loaded, shown: Shown) {
    shows(&render(loaded, shown));
}

/// An error that is about no program.
pub(super) fn error(error: &Error) {
    if let Error::Cargo { said, .. } = error {
        complain(said);
    }
    let level = match error {
        Error::Interrupted(_) => "",
        _ => "error: ",
    };
    complain(&format!("{level}{}\n", Printable::line(error)));
}

/// Writes to standard error; if that is closed, there is no one to report it to.
pub(super) fn complain(text: &str) {
    shows(&Printable::lines(text).to_string());
}

/// Empties the terminal that standard error is.
pub(super) fn clear() {
    shows("\u{1b}[2J\u{1b}[H");
}

/// Writes to standard error what may have colours.
pub(super) fn shows(text: &str) {
    let _ = io::stderr().write_all(text.as_bytes());
}

fn render(loaded: &Loaded, shown: Shown) -> String {
    let format = shown.message_format;
    let (lang, style) = (shown.lang(), shown.style());
    let most = match format {
        Format::Human => MOST,
        Format::Short | Format::Json | Format::Sarif => usize::MAX,
    };
    let lines = loaded.diagnostics.iter().take(most).map(|diagnostic| {
        let source = &loaded.source;
        let line = match format {
            Format::Human if diagnostic.code == Code::FileNotFound => no_snippet(diagnostic, lang),
            Format::Human | Format::Sarif => render::human(source, diagnostic, style),
            Format::Short => render::short(source, diagnostic, lang),
            Format::Json => render::json(source, diagnostic, loaded.robot, lang),
        };
        let end = if line.ends_with('\n') { "" } else { "\n" };
        // A blank line keeps snippets apart.
        let gap = if format == Format::Human { "\n" } else { "" };
        format!("{line}{end}{gap}")
    });
    lines.chain(render_more(loaded, shown)).collect()
}

/// Returns the last line, about the findings that are left out, if there are any.
fn render_more(loaded: &Loaded, shown: Shown) -> Option<String> {
    let (found, omitted) = (loaded.diagnostics.len(), loaded.omitted.count());
    let count = match shown.message_format {
        Format::Human => found.saturating_sub(MOST) + omitted,
        Format::Short | Format::Json | Format::Sarif => omitted,
    };
    let more = More::from(count).in_lang(shown.lang()).to_string();
    let file = loaded.source.name();
    let line = match shown.message_format {
        Format::Human => more + "\n\n",
        Format::Short => format!("{}: note: {more}\n", Printable::line(file)),
        Format::Json => {
            let mut object = String::from("{\"level\":\"note\"");
            render::push_member(&mut object, "message", &more);
            render::push_member(&mut object, "file", file);
            format!("{object},\"omitted\":{count}}}\n")
        }
        Format::Sarif => return None,
    };
    (count > 0).then_some(line)
}

/// A finding about a file that has no text.
fn no_snippet(diagnostic: &Diagnostic, lang: Lang) -> String {
    let file = diagnostic.subject.as_deref().unwrap_or_default();
    let (code, reason) = (diagnostic.id(), diagnostic.reason.in_lang(lang));
    let (error, note) = (lang.pick("error", "エラー"), lang.pick("note", "注"));
    let text = format!("{error}[{code}]: {file}: {reason}");
    let (headline, classical) = (Printable::line(text), Printable::line(diagnostic.title()));
    format!("{headline}\n  = {note}: {classical}")
}

/// What came of a program, in a sentence.
fn summary(loaded: &Loaded) -> Checking {
    let (errors, warnings) = (count(loaded, Level::Error), count(loaded, Level::Warning));
    let file = Printable::line(loaded.source.name()).to_string().into();
    match &loaded.program {
        Some(program) => Checking::Sound {
            file,
            steps: program.steps().len().into(),
            robot: program.signature().robot.to_string(),
            warnings: warnings.into(),
        },
        None => Checking::Faulty {
            file,
            errors: errors.into(),
            warnings: warnings.into(),
        },
    }
}

fn count(loaded: &Loaded, level: Level) -> usize {
    let of_level = loaded.diagnostics.iter().filter(|one| one.level() == level);
    of_level.count() + loaded.omitted.of_level(level, loaded.module.edition)
}

/// So many of something.
pub(super) fn plural(count: usize, what: &str) -> String {
    let end = if count == 1 { "" } else { "s" };
    format!("{count} {what}{end}")
}
