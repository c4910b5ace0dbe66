//! Arguments of the macros.

use crate::literal::{self, Text};
use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};
use std::iter::Peekable;
use tipc::source::Encoding;
use tipc::{Robot, emit, published};

/// Fault of the invocation itself.
#[derive(Debug)]
pub(crate) struct Misuse {
    pub(crate) span: Span,
    pub(crate) message: String,
}

impl Misuse {
    pub(crate) fn new(span: Span, message: impl Into<String>) -> Self {
        Misuse {
            span,
            message: message.into(),
        }
    }
}

/// An invocation, understood.
#[derive(Debug)]
pub(crate) struct Arguments {
    /// The path of `include_tip!`, the program of `tip!`.
    pub(crate) text: Text,
    pub(crate) load: tipc::Options,
    /// The path of a description that takes the place of the robot in `load`.
    pub(crate) robot_file: Option<Text>,
    pub(crate) emit_options: emit::Options,
}

const INCLUDE_TIP: &str =
    "expected include_tip!([attributes] [visibility] \"path\" [as Name] [, option = value]…)";
#[cfg(feature = "robot-files")]
const INCLUDE_ROBOT: &str =
    "expected include_robot!([attributes] [visibility] \"path\" [as NAME] [, runtime = path])";
const TIP: &str =
    "expected tip!([attributes] [visibility] Name, r#\"program\"# [, option = value]…)";
const NOT_LITERAL: &str = "expected a string literal: this macro runs before constants and other macros such as `concat!` have values";
const OPTIONS: &str = "the options are `robot`, `tip_version`, `encoding` and `runtime`";
const ROBOTS: &str = "`titan8`, `hand`, `generic`, a published robot such as `phantomx`, or the path of a description, \"robot.toml\"";
/// `[attributes] [visibility] "path" [as Name] [, option = value]…`
pub(crate) fn include_tip(input: TokenStream) -> Result<Arguments, Misuse> {
    let mut input = Input::new(input, INCLUDE_TIP);
    let arguments = input.file()?;
    arguments.with(input.options()?)
}

/// `[attributes] [visibility] Name, "program" [, option = value]…`
pub(crate) fn tip(input: TokenStream) -> Result<Arguments, Misuse> {
    let mut input = Input::new(input, TIP);
    let attributes = input.attributes();
    let visibility = input.visibility();
    let name = input.name()?;
    input.comma()?;
    let text = input.string()?;
    let mut arguments = Arguments::new(text, attributes, visibility);
    arguments.emit_options.name = Some(name);
    arguments.with(input.options()?)
}

/// Returns the path of a description, and the options of its constant:
/// `[attributes] [visibility] "path" [as NAME] [, runtime = path]`
#[cfg(feature = "robot-files")]
pub(crate) fn include_robot(input: TokenStream) -> Result<(Text, emit::Options), Misuse> {
    let mut input = Input::new(input, INCLUDE_ROBOT);
    let Arguments {
        text,
        mut emit_options,
        ..
    } = input.file()?;
    for (option, value) in input.options()? {
        if option != "runtime" {
            return Err(Misuse::new(option.span(), input.expected));
        }
        emit_options.runtime = runtime(&option, value)?;
    }
    Ok((text, emit_options))
}

impl Arguments {
    fn new(text: Text, attributes: TokenStream, visibility: TokenStream) -> Self {
        Arguments {
            text,
            load: tipc::Options::default(),
            robot_file: None,
            emit_options: emit::Options {
                attributes,
                visibility,
                ..emit::Options::default()
            },
        }
    }

    fn with(mut self, options: Vec<(Ident, Vec<TokenTree>)>) -> Result<Self, Misuse> {
        for (option, value) in options {
            self.set(&option, value)?;
        }
        Ok(self)
    }

    fn set(&mut self, option: &Ident, value: Vec<TokenTree>) -> Result<(), Misuse> {
        let name = option.to_string();
        let word = literal::word(&value);
        let value_span = value.first().map_or(option.span(), TokenTree::span);
        let wrong = |expected: &str| Err(Misuse::new(value_span, format!("expected {expected}")));
        match name.as_str() {
            "robot" => match word.as_deref().and_then(Robot::from_name) {
                Some(robot) => (self.load.robot, self.robot_file) = (robot, None),
                None => match description(&value) {
                    Some(path) => self.robot_file = Some(path),
                    None => return wrong(ROBOTS),
                },
            },
            "tip_version" => match word.and_then(|word| word.parse().ok()) {
                Some(version) => self.load.tip_version = Some(version),
                None => return wrong("a version number, such as 3.1"),
            },
            "encoding" => match word.as_deref().and_then(encoding) {
                Some(encoding) => self.load.encoding = encoding,
                None => return wrong("`auto`, `utf8` or `shift_jis`"),
            },
            "runtime" => self.emit_options.runtime = runtime(option, value)?,
            _ => {
                let message = format!("unknown option `{name}`: {OPTIONS}");
                return Err(Misuse::new(option.span(), message));
            }
        }
        Ok(())
    }
}

fn runtime(option: &Ident, value: Vec<TokenTree>) -> Result<TokenStream, Misuse> {
    match value.is_empty() {
        true => {
            let expected = "expected a path, such as ::tip_runtime";
            Err(Misuse::new(option.span(), expected))
        }
        false => Ok(value.into_iter().collect()),
    }
}

/// Returns the path of a description, or the name of a robot that has one here.
fn description(value: &[TokenTree]) -> Option<Text> {
    let [token] = value else {
        return None;
    };
    let text = match token {
        TokenTree::Ident(name) => Text {
            value: name.to_string(),
            span: name.span(),
        },
        token => literal::string(token)?,
    };
    let is_known = text.value.ends_with(".toml") || published::find(&text.value).is_some();
    is_known.then_some(text)
}

fn encoding(word: &str) -> Option<Encoding> {
    match word {
        "auto" => Some(Encoding::Auto),
        "utf8" => Some(Encoding::Utf8),
        "shift_jis" => Some(Encoding::ShiftJis),
        _ => None,
    }
}

/// The tokens not yet read.
struct Input {
    tokens: Peekable<proc_macro2::token_stream::IntoIter>,
    expected: &'static str,
}

impl Input {
    fn new(input: TokenStream, expected: &'static str) -> Self {
        Input {
            tokens: ungrouped(input).into_iter().peekable(),
            expected,
        }
    }

    /// Returns the error that the invocation does not have its form, here.
    fn misuse<T>(&mut self) -> Result<T, Misuse> {
        let span = self
            .tokens
            .peek()
            .map_or(Span::call_site(), TokenTree::span);
        Err(Misuse::new(span, self.expected))
    }

    fn keyword(&mut self, word: &str) -> bool {
        let is_word = |token: &TokenTree| matches!(token, TokenTree::Ident(ident) if ident == word);
        self.tokens.next_if(is_word).is_some()
    }

    /// Any number of attributes; documentation comments are attributes as well.
    fn attributes(&mut self) -> TokenStream {
        let mut attributes = TokenStream::new();
        while let Some(hash) = self.tokens.next_if(|token| is_punct(token, '#')) {
            attributes.extend([hash]);
            attributes.extend(self.tokens.next_if(|token| {
                matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket)
            }));
        }
        attributes
    }

    /// `pub`, `pub(…)` or nothing.
    fn visibility(&mut self) -> TokenStream {
        let is_pub = |token: &TokenTree| matches!(token, TokenTree::Ident(ident) if ident == "pub");
        let Some(public) = self.tokens.next_if(is_pub) else {
            return TokenStream::new();
        };
        let scope = self.tokens.next_if(|token| {
            matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis)
        });
        [public].into_iter().chain(scope).collect()
    }

    fn name(&mut self) -> Result<Ident, Misuse> {
        match self.tokens.peek() {
            Some(TokenTree::Ident(name)) => {
                let name = name.clone();
                self.tokens.next();
                Ok(name)
            }
            _ => self.misuse(),
        }
    }

    fn string(&mut self) -> Result<Text, Misuse> {
        match self.tokens.peek().and_then(literal::string) {
            Some(text) => {
                self.tokens.next();
                Ok(text)
            }
            None => match self.tokens.peek() {
                Some(token) => Err(Misuse::new(token.span(), NOT_LITERAL)),
                None => self.misuse(),
            },
        }
    }

    fn comma(&mut self) -> Result<(), Misuse> {
        match self.tokens.next_if(|token| is_punct(token, ',')) {
            Some(_) => Ok(()),
            None => self.misuse(),
        }
    }

    /// `[visibility] "path" [as Name]`
    fn file(&mut self) -> Result<Arguments, Misuse> {
        let attributes = self.attributes();
        let visibility = self.visibility();
        let text = self.string()?;
        let mut arguments = Arguments::new(text, attributes, visibility);
        if self.keyword("as") {
            arguments.emit_options.name = Some(self.name()?);
        }
        Ok(arguments)
    }

    /// Reads everything after path or program: any number of `, option = value`, and a last comma.
    fn options(&mut self) -> Result<Vec<(Ident, Vec<TokenTree>)>, Misuse> {
        let mut options: Vec<(Ident, Vec<TokenTree>)> = Vec::new();
        while self.tokens.peek().is_some() {
            self.comma()?;
            if self.tokens.peek().is_none() {
                break;
            }
            let option = self.name()?;
            if options.iter().any(|(known, _)| *known == option) {
                let message = format!("the option `{option}` is given twice");
                return Err(Misuse::new(option.span(), message));
            }
            if self.tokens.next_if(|token| is_punct(token, '=')).is_none() {
                return self.misuse();
            }
            let mut value = Vec::new();
            while let Some(token) = self.tokens.next_if(|token| !is_punct(token, ',')) {
                value.push(token);
            }
            options.push((option, value));
        }
        Ok(options)
    }
}

fn is_punct(token: &TokenTree, c: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == c)
}

/// Returns the tokens without the invisible groups that surround what another macro passes on.
fn ungrouped(input: TokenStream) -> TokenStream {
    input
        .into_iter()
        .flat_map(|token| match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::None => {
                ungrouped(group.stream())
            }
            token => token.into(),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tokens(text: &str) -> TokenStream {
        text.parse().unwrap()
    }

    #[test]
    fn a_path_is_enough() {
        let arguments = include_tip(tokens("\"walk.prg\"")).unwrap();
        assert_eq!(arguments.text.value, "walk.prg");
        assert_eq!(arguments.load, tipc::Options::default());
        assert!(arguments.emit_options.name.is_none());
        assert!(arguments.emit_options.visibility.is_empty());
    }

    #[test]
    fn every_option_is_taken() {
        let input = "pub(crate) \"x.prg\" as Afc, robot = hand, tip_version = 2.0,
            encoding = shift_jis, runtime = crate::robot,";
        let Arguments {
            load, emit_options, ..
        } = include_tip(tokens(input)).unwrap();
        assert_eq!(load.robot, Robot::Hand);
        assert_eq!(load.tip_version, Some(2.0));
        assert_eq!(load.encoding, Encoding::ShiftJis);
        assert_eq!(emit_options.name.unwrap(), "Afc");
        assert_eq!(emit_options.visibility.to_string(), "pub (crate)");
        assert_eq!(emit_options.runtime.to_string(), "crate :: robot");
    }

    #[test]
    fn attributes_and_documentation_pass_through() {
        let arguments =
            include_tip(tokens("/// Walks.\n#[expect(dead_code)] pub \"x.prg\"")).unwrap();
        let options = arguments.emit_options;
        let attributes = options.attributes.to_string();
        assert!(attributes.contains("Walks."), "{attributes}");
        assert!(attributes.contains("dead_code"), "{attributes}");
        assert_eq!(options.visibility.to_string(), "pub");
    }

    #[test]
    fn a_program_has_a_name_first() {
        let arguments = tip(tokens(
            "pub Wave, r#\"3.1\nwave\nEND\"#, robot = \"generic\"",
        ))
        .unwrap();
        assert_eq!(arguments.text.value, "3.1\nwave\nEND");
        assert_eq!(arguments.emit_options.name.unwrap(), "Wave");
        assert_eq!(arguments.load.robot, Robot::Generic);
    }

    #[test]
    fn misuse_names_what_was_expected() {
        for (input, message) in [
            ("", "expected include_tip!"),
            ("walk", "expected a string literal"),
            ("b\"walk.prg\"", "expected a string literal"),
            ("concat!(\"a\", \".prg\")", "expected a string literal"),
            ("#[doc = \"x\"] pub", "expected include_tip!"),
            ("\"a.prg\" as", "expected include_tip!"),
            ("\"a.prg\" robot = hand", "expected include_tip!"),
            ("\"a.prg\", robot hand", "expected include_tip!"),
            ("\"a.prg\", robot = arm", "expected `titan8`"),
            ("\"a.prg\", robot = ", "expected `titan8`"),
            ("\"a.prg\", tip_version = new", "expected a version number"),
            ("\"a.prg\", encoding = ebcdic", "expected `auto`"),
            ("\"a.prg\", runtime =", "expected a path"),
            ("\"a.prg\", robots = hand", "unknown option `robots`"),
        ] {
            let misuse = include_tip(tokens(input)).unwrap_err();
            assert!(
                misuse.message.contains(message),
                "{input}: {}",
                misuse.message
            );
        }
        assert!(tip(tokens("Wave r\"\"")).is_err());
    }
}
