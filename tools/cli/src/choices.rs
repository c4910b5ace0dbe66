//! Values of options that have names, and the options of the output: format, language and colours.

use crate::message::Using;
use clap::{Args, ValueEnum};
use std::env;
use std::io::{self, IsTerminal};
use tipc::Robot;
use tipc::message::Lang;
use tipc::published;
use tipc::render::Style;
use tipc::source::Encoding;

/// Returns the names of robots, after those of a command.
pub(super) fn robot_names(others: &[&'static str]) -> Vec<&'static str> {
    let built_in = Robot::ALL.iter().map(|robot| robot.name());
    let published = published::ALL.iter().map(|robot| robot.name);
    let others = others.iter().copied();
    others.chain(built_in).chain(published).collect()
}

/// The names of encodings.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum EncodingName {
    Auto,
    #[value(name = "utf-8", alias = "utf8")]
    Utf8,
    #[value(name = "shift_jis", aliases = ["shift-jis", "sjis"])]
    ShiftJis,
}

impl EncodingName {
    /// Returns the name of an encoding.
    pub(super) fn of(encoding: Encoding) -> Self {
        match encoding {
            Encoding::Auto => EncodingName::Auto,
            Encoding::Utf8 => EncodingName::Utf8,
            Encoding::ShiftJis => EncodingName::ShiftJis,
        }
    }

    /// Returns the name in options and `tip.toml`.
    pub(super) fn name(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }

    pub(super) fn encoding(self) -> Encoding {
        match self {
            EncodingName::Auto => Encoding::Auto,
            EncodingName::Utf8 => Encoding::Utf8,
            EncodingName::ShiftJis => Encoding::ShiftJis,
        }
    }
}

/// The names of languages of messages.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum LangName {
    /// English
    En,
    /// Japanese
    Ja,
}

impl LangName {
    pub(super) fn of(lang: Lang) -> Self {
        match lang {
            Lang::Japanese => LangName::Ja,
            _ => LangName::En,
        }
    }

    pub(super) fn lang(self) -> Lang {
        match self {
            LangName::En => Lang::English,
            LangName::Ja => Lang::Japanese,
        }
    }
}

/// The values of `--color`.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum ColourName {
    /// On a terminal
    Auto,
    /// Everywhere
    Always,
    /// Nowhere
    Never,
}

/// The values of `--message-format`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// With the source line, help and colour
    Human,
    /// One line each
    Short,
    /// One JSON object per line
    Json,
    /// One document of SARIF 2.1.0 for all files (check only)
    Sarif,
}

/// The place in help of options that many commands share: after those of the command.
pub(super) const LAST: usize = 900;

/// The options of the output.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct OutputOptions {
    /// Diagnostics: human, short, json or sarif
    ///
    /// Snippets for people, or lines for tools
    #[arg(long, value_name = "FORMAT", value_enum, default_value = "human", display_order = LAST)]
    pub(super) message_format: Format,

    /// The language of messages; else the locale's
    #[arg(long, value_enum, value_name = "en|ja", display_order = LAST)]
    lang: Option<LangName>,

    /// Colours: auto, always or never
    ///
    /// For people; auto: on a terminal, unless NO_COLOR is set
    #[arg(long, value_enum, value_name = "WHEN", default_value = "auto", display_order = LAST)]
    color: ColourName,
}

impl OutputOptions {
    /// Returns the form for people, in a language and without colours.
    pub(super) fn of(lang: LangName) -> Self {
        OutputOptions {
            message_format: Format::Human,
            lang: Some(lang),
            color: ColourName::Never,
        }
    }

    /// Returns the chosen language, or that of the locale.
    pub(super) fn lang(self) -> Lang {
        lang(self.lang)
    }

    /// Returns the style of diagnostics on standard error.
    pub(super) fn style(self) -> Style {
        let width = terminal_size::terminal_size_of(io::stderr());
        Style::default()
            .lang(self.lang())
            .colour(self.color.wanted())
            .width(width.map(|(width, _)| width.0.into()))
    }
}

/// Returns the chosen language, or that of the locale.
pub(super) fn lang(asked: Option<LangName>) -> Lang {
    asked.map_or_else(of_locale, LangName::lang)
}

/// Returns Japanese if the first of the variables of POSIX that is set begins with `ja`.
fn of_locale() -> Lang {
    let says = |name: &&str| env::var_os(name).filter(|value| !value.is_empty());
    let locale = ["LC_ALL", "LC_MESSAGES", "LANG"].iter().find_map(says);
    locale.map_or(Lang::English, |locale| Lang::of(&locale.to_string_lossy()))
}

impl ColourName {
    /// Returns true if standard error gets colours.
    fn wanted(self) -> bool {
        match self {
            ColourName::Always => true,
            ColourName::Never => false,
            ColourName::Auto => wants_colour(),
        }
    }
}

/// Returns true for a terminal, unless the environment refuses colours (<https://no-color.org>) or forces them
/// (<https://bixense.com/clicolors/>).
fn wants_colour() -> bool {
    let is_set = |name: &str| env::var_os(name).is_some_and(|value| !value.is_empty());
    let insists =
        env::var_os("CLICOLOR_FORCE").is_some_and(|value| !value.is_empty() && value != "0");
    let dumb = env::var_os("TERM").is_some_and(|value| value == "dumb");
    !is_set("NO_COLOR") && (insists || io::stderr().is_terminal() && !dumb)
}

/// Parses a whole number.
pub(super) fn count(text: &str) -> Result<u64, Using> {
    let wrong = |_| Using::NotACount {
        text: text.to_owned(),
    };
    text.parse().map_err(wrong)
}

/// Parses a whole number above 0.
pub(super) fn positive(text: &str) -> Result<u64, Using> {
    match count(text)? {
        0 => Err(Using::NotPositive {
            text: text.to_owned(),
        }),
        count => Ok(count),
    }
}

/// Quotes a word for a shell.
pub(super) fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "/._-=".contains(c);
    if word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}
