//! How findings are shown: the form, the language and the width; and the place of a step, as snippets show it.

use super::choices::{ColourName, Format, LangName};
use clap::Args;
use std::env;
use std::io::{self, IsTerminal};
use tip_runtime::printable::Printable;
use tipc::message::Lang;
use tipc::program::{Program, StepId};
use tipc::render::Style;
use tipc::source::Source;

/// What the command line says of it.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct Shown {
    /// How findings are shown: snippets for people, or lines for tools
    #[arg(long, value_enum, default_value = "human")]
    pub(super) message_format: Format,

    /// The language of reasons and helps, if not that of the locale
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,

    /// Whether findings for people have colours; auto: on a terminal, unless NO_COLOR says otherwise
    #[arg(long, value_enum, value_name = "WHEN", default_value = "auto")]
    color: ColourName,
}

impl Shown {
    /// The form for people, in a language.
    pub(super) fn of(lang: LangName) -> Self {
        Shown {
            message_format: Format::Human,
            lang: Some(lang),
            color: ColourName::Never,
        }
    }

    /// The language that is asked for; else that of the locale.
    pub(super) fn lang(self) -> Lang {
        lang(self.lang)
    }

    /// How people want to read on standard error.
    pub(super) fn style(self) -> Style {
        let width = terminal_size::terminal_size_of(io::stderr());
        Style::default()
            .lang(self.lang())
            .colour(self.color.wanted())
            .width(width.map(|(width, _)| width.0.into()))
    }
}

/// The language that is asked for; else that of the locale.
pub(super) fn lang(asked: Option<LangName>) -> Lang {
    asked.map_or_else(of_locale, LangName::lang)
}

/// Japanese where the first variable of POSIX that says anything begins with `ja`.
fn of_locale() -> Lang {
    let says = |name: &&str| env::var_os(name).filter(|value| !value.is_empty());
    let locale = ["LC_ALL", "LC_MESSAGES", "LANG"].iter().find_map(says);
    locale.map_or(Lang::English, |locale| Lang::of(&locale.to_string_lossy()))
}

impl ColourName {
    /// Whether to show colours on standard error.
    fn wanted(self) -> bool {
        match self {
            ColourName::Always => true,
            ColourName::Never => false,
            ColourName::Auto => wants_colour(),
        }
    }
}

/// Colour is for terminals, and for people who did not refuse it (<https://no-color.org>) or insist on it
/// (<https://bixense.com/clicolors/>).
fn wants_colour() -> bool {
    let is_set = |name: &str| env::var_os(name).is_some_and(|value| !value.is_empty());
    let insists =
        env::var_os("CLICOLOR_FORCE").is_some_and(|value| !value.is_empty() && value != "0");
    let dumb = env::var_os("TERM").is_some_and(|value| value == "dumb");
    !is_set("NO_COLOR") && (insists || io::stderr().is_terminal() && !dumb)
}

/// The line of a step under the name of its file; nothing for a step that there is none of.
pub(super) fn place(source: &Source, program: &Program, step: StepId) -> String {
    let Some(step) = program.steps().get(step as usize) else {
        return String::new();
    };
    let (line, column) = (step.line, step.column);
    let gutter = " ".repeat(line.to_string().len());
    let statement = Printable::line(source.line_text(line));
    let name = Printable::line(source.name());
    format!("{gutter}--> {name}:{line}:{column}\n{gutter} |\n{line} | {statement}\n{gutter} |\n")
}
