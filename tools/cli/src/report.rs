//! Reports of diagnostics and errors, for people on standard error and for tools on standard output, and `--deny`.

use crate::choices::{Format, OutputOptions};
use crate::error::Error;
use crate::message::{Checking, Using, Weight};
use crate::output;
use crate::sarif::Document;
use clap::Args;
use indicatif::ProgressStyle;
use std::io::{self, Write};
use tip_lint::message::More;
use tip_runtime::printable::Printable;
use tipc::code::{Code, Level};
use tipc::diagnostic::Diagnostic;
use tipc::language::Edition;
use tipc::message::list::Each;
use tipc::message::{Lang, Message};
use tipc::program::{Program, StepId};
use tipc::source::Source;
use tipc::{Loaded, render};

/// Maximum number of diagnostics of a file that people see.
const MAX_SHOWN: usize = 50;

/// Counts of diagnostics of several files.
#[derive(Debug)]
pub(super) struct Total {
    output_options: OutputOptions,
    files: usize,
    errors: usize,
    warnings: usize,
    /// Codes of diagnostics that were reported.
    codes: Vec<&'static str>,
    /// Files without diagnostics are not mentioned.
    quiet: bool,
    /// The document, if one is written.
    document: Option<Document>,
}

impl Total {
    pub(super) fn new(output_options: OutputOptions, quiet: bool) -> Self {
        let is_document = output_options.message_format == Format::Sarif;
        Total {
            output_options,
            files: 0,
            errors: 0,
            warnings: 0,
            codes: Vec::new(),
            quiet,
            document: is_document.then(|| Document::new(output_options.lang())),
        }
    }

    pub(super) fn add(&mut self, loaded: &Loaded) {
        self.files += 1;
        self.errors += count(loaded, Level::Error);
        self.warnings += count(loaded, Level::Warning);
        self.codes.extend(shown(loaded));
        if let Some(document) = &mut self.document {
            document.add(loaded);
        }
    }

    /// Reports the diagnostics of a file.
    pub(super) fn check(&self, loaded: &Loaded) -> Result<(), Error> {
        match self.quiet && loaded.diagnostics.is_empty() {
            true => Ok(()),
            false => check(loaded, self.output_options),
        }
    }

    /// Reports the sum over several files to people, or writes the document.
    pub(super) fn report(self) -> Result<(), Error> {
        let output_options = self.output_options;
        if let Some(document) = self.document {
            return output::print(document.text());
        }
        let is_silent = self.quiet && self.errors + self.warnings == 0;
        if self.files > 1 && output_options.message_format == Format::Human && !is_silent {
            let total = Checking::Total {
                files: self.files.into(),
                errors: self.errors.into(),
                warnings: self.warnings.into(),
            };
            say(total, output_options.lang());
        }
        learn_more(self.codes.into_iter(), output_options);
        Ok(())
    }
}

/// Reports diagnostics: snippets for people to standard error, the formats of tools to standard output.
pub(super) fn check(loaded: &Loaded, output_options: OutputOptions) -> Result<(), Error> {
    let text = render(loaded, output_options);
    match output_options.message_format {
        Format::Human => {
            write_stderr(&text);
            say(summary(loaded), output_options.lang());
            Ok(())
        }
        Format::Short | Format::Json => output::print(&text),
        // They are part of one document, at the end.
        Format::Sarif => Ok(()),
    }
}

/// Reports the diagnostics of a program that a command is going to use, to standard error.
pub(super) fn diagnostics(loaded: &Loaded, output_options: OutputOptions) {
    write_stderr(&render(loaded, output_options));
    learn_more(shown(loaded), output_options);
}

/// Tells people once where the codes of diagnostics are explained.
fn learn_more(codes: impl Iterator<Item = &'static str>, output_options: OutputOptions) {
    let mut unique: Vec<&str> = Vec::new();
    for code in codes {
        // A file that is not there needs no page.
        if code != Code::FileNotFound.id() && !unique.contains(&code) {
            unique.push(code);
        }
    }
    let text = match (output_options.message_format, unique.as_slice()) {
        (Format::Human, [code]) => Using::LearnMoreOf { code },
        (Format::Human, [first, others @ ..]) => {
            let others = others.iter().map(|code| (*code).to_owned());
            let others = Each(others.collect());
            Using::LearnMore { first, others }
        }
        _ => return,
    };
    say(text, output_options.lang());
}

/// Returns the codes of the diagnostics that people see.
fn shown(loaded: &Loaded) -> impl Iterator<Item = &'static str> {
    let diagnostics = loaded.diagnostics.iter().take(MAX_SHOWN);
    diagnostics.map(Diagnostic::id)
}

/// Reports an error.
pub(super) fn error(error: &Error, lang: Lang) {
    match error {
        Error::Refused(loaded, options) => return diagnostics(loaded, *options),
        Error::Cargo { output, .. } => complain(output),
        _ => {}
    }
    let text = Printable::line(error.text(lang)).to_string();
    let weight = Weight::Error.in_lang(lang);
    complain(&match error {
        Error::Interrupted(_) => format!("{text}\n"),
        _ => format!("{weight}: {text}\n"),
    });
}

/// Writes a message to standard error, on a line of its own.
pub(super) fn say(message: impl Into<Message>, lang: Lang) {
    complain(&format!("{}\n", message.into().in_lang(lang)));
}

/// Writes to standard error, made printable; errors are ignored.
pub(super) fn complain(text: &str) {
    write_stderr(&Printable::lines(text).to_string());
}

/// Clears the terminal of standard error.
pub(super) fn clear() {
    write_stderr("\u{1b}[2J\u{1b}[H");
}

/// Writes text that may have colours to standard error.
pub(super) fn write_stderr(text: &str) {
    let _ = io::stderr().write_all(text.as_bytes());
}

/// Rate of drawing lines of progress, Hz.
pub(super) const RATE: u8 = 5;

/// Returns the style of a line of progress.
pub(super) fn progress_style(template: &str) -> ProgressStyle {
    let plain = ProgressStyle::default_bar();
    let style = ProgressStyle::with_template(template);
    style.unwrap_or(plain).progress_chars("=> ")
}

fn render(loaded: &Loaded, output_options: OutputOptions) -> String {
    let format = output_options.message_format;
    let (lang, style) = (output_options.lang(), output_options.style());
    let most = match format {
        Format::Human => MAX_SHOWN,
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
    lines.chain(render_more(loaded, output_options)).collect()
}

/// Returns the line about omitted diagnostics, if there are any.
fn render_more(loaded: &Loaded, output_options: OutputOptions) -> Option<String> {
    let (found, omitted) = (loaded.diagnostics.len(), loaded.omitted.count());
    let count = match output_options.message_format {
        Format::Human => found.saturating_sub(MAX_SHOWN) + omitted,
        Format::Short | Format::Json | Format::Sarif => omitted,
    };
    let more = More::from(count).in_lang(output_options.lang()).to_string();
    let file = loaded.source.name();
    let line = match output_options.message_format {
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

/// Renders a diagnostic of a file without text.
fn no_snippet(diagnostic: &Diagnostic, lang: Lang) -> String {
    let file = diagnostic.subject.as_deref().unwrap_or_default();
    let (code, reason) = (diagnostic.id(), diagnostic.reason.in_lang(lang));
    let (error, note) = (lang.pick("error", "エラー"), lang.pick("note", "注"));
    let text = format!("{error}[{code}]: {file}: {reason}");
    let (headline, classical) = (Printable::line(text), Printable::line(diagnostic.title()));
    format!("{headline}\n  = {note}: {classical}")
}

/// Returns the line of a step with its file and position; nothing if there is no such step.
pub(super) fn step_location(source: &Source, program: &Program, step: StepId) -> String {
    let Some(step) = program.steps().get(step as usize) else {
        return String::new();
    };
    let (line, column) = (step.line, step.column);
    let gutter = " ".repeat(line.to_string().len());
    let statement = Printable::line(source.line_text(line));
    let name = Printable::line(source.name());
    format!("{gutter}--> {name}:{line}:{column}\n{gutter} |\n{line} | {statement}\n{gutter} |\n")
}

/// Returns the result of a check.
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

/// Returns a count with a noun in English.
pub(super) fn plural(count: usize, what: &str) -> String {
    let end = if count == 1 { "" } else { "s" };
    format!("{count} {what}{end}")
}

/// Formats a number with the given number of decimals, and zero without a sign.
pub(super) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(amount) if amount.bytes().all(|byte| matches!(byte, b'0' | b'.')) => amount.to_owned(),
        _ => text,
    }
}

/// The option `--deny`.
#[derive(Clone, Debug, Args)]
pub(super) struct Deny {
    /// Fail on codes, 'falls' or 'collisions'
    ///
    /// Codes of warnings such as W112, 'warnings' for all of them, 'falls' for falls of the robot in a run, 'collisions' for links
    /// that meet each other or the body
    #[arg(long, value_name = "WHAT,...", value_delimiter = ',', value_parser = denied_value)]
    deny: Vec<Denied>,
}

/// A value of `--deny`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Denied {
    /// The robot fell, or would have: its body came down, or its support was lost.
    Falls,
    /// Two parts of the robot overlapped.
    Collisions,
    /// Every warning.
    Warnings,
    /// A warning.
    Warning(Code),
}

const FALLS: &str = "falls";
const COLLISIONS: &str = "collisions";
const WARNINGS: &str = "warnings";

fn denied_value(word: &str) -> Result<Denied, String> {
    let warnings = || {
        let codes = Code::ALL.iter().copied();
        codes.filter(|code| code.level(Edition::default()) == Level::Warning)
    };
    match word {
        FALLS => Ok(Denied::Falls),
        COLLISIONS => Ok(Denied::Collisions),
        WARNINGS => Ok(Denied::Warnings),
        _ => match warnings().find(|code| code.id().eq_ignore_ascii_case(word)) {
            Some(code) => Ok(Denied::Warning(code)),
            None => {
                let codes: Vec<&str> = warnings().map(Code::id).collect();
                let codes = codes.join(", ");
                Err(format!(
                    "the values of --deny are {FALLS}, {COLLISIONS}, {WARNINGS}, {codes}"
                ))
            }
        },
    }
}

impl Deny {
    /// Returns true if falls are denied.
    pub(super) fn falls(&self) -> bool {
        self.deny.contains(&Denied::Falls)
    }

    /// Returns true if collisions are denied.
    pub(super) fn collisions(&self) -> bool {
        self.deny.contains(&Denied::Collisions)
    }

    /// Returns true if a program has a denied warning, after reporting it.
    pub(super) fn rejects(&self, loaded: &Loaded) -> bool {
        let is_denied = |code: Code| {
            code.level(Edition::default()) == Level::Warning
                && (self.deny.contains(&Denied::Warnings)
                    || self.deny.contains(&Denied::Warning(code)))
        };
        let codes = loaded.diagnostics.iter().map(|diagnostic| diagnostic.code);
        let mut denied: Vec<Code> = codes.filter(|code| is_denied(*code)).collect();
        let omitted = loaded.omitted.codes();
        let omitted = omitted.filter(|(code, _)| is_denied(*code));
        let mut count = denied.len();
        for (code, more) in omitted {
            denied.push(code);
            count += more;
        }
        denied.sort_unstable();
        denied.dedup();
        if count > 0 {
            let codes: Vec<&str> = denied.into_iter().map(Code::id).collect();
            let (name, codes) = (loaded.source.name(), codes.join(", "));
            let warnings = plural(count, "denied warning");
            complain(&format!("error: {name}: {warnings}: {codes}\n"));
        }
        count > 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_that_is_shown_as_zero_has_no_sign() {
        let shown = [
            (-0.04, 1),
            (-0.0, 0),
            (-0.4, 0),
            (-0.005, 2),
            (-0.06, 1),
            (-100.0, 1),
        ];
        let texts = shown.map(|(value, decimals)| fixed(value, decimals));
        assert_eq!(texts, ["0.0", "0", "0", "-0.01", "-0.1", "-100.0"]);
    }
}
