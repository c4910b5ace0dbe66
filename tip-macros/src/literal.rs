//! The values of literals, without a parser for all of Rust.

use proc_macro2::{Span, TokenTree};
use std::path::PathBuf;

/// A string with its location.
#[derive(Debug)]
pub(crate) struct Text {
    pub(crate) value: String,
    pub(crate) span: Span,
}

impl Text {
    /// Returns the file that it is written in, if the compiler knows one: that of the crate that wrote it, whichever
    /// macros passed it on.
    pub(crate) fn file(&self) -> Option<PathBuf> {
        extern crate proc_macro;
        let is_in_macro = proc_macro::is_available();
        is_in_macro.then(|| self.span.unwrap().local_file())?
    }
}

/// Returns the value of a string literal, raw or not; `None` for any other token.
pub(crate) fn string(token: &TokenTree) -> Option<Text> {
    let TokenTree::Literal(literal) = token else {
        return None;
    };
    let literal_text = literal.to_string();
    let value = match literal_text.strip_prefix('r') {
        Some(raw) => raw_content(raw)?.to_owned(),
        None => unescaped(literal_text.strip_prefix('"')?.strip_suffix('"')?)?,
    };
    Some(Text {
        value: value.replace("\r\n", "\n"),
        span: literal.span(),
    })
}

/// Returns a value that is one word: an identifier, a number or a string.
pub(crate) fn word(value: &[TokenTree]) -> Option<String> {
    match value {
        [TokenTree::Ident(ident)] => Some(ident.to_string()),
        [token @ TokenTree::Literal(literal)] => {
            Some(string(token).map_or_else(|| literal.to_string(), |text| text.value))
        }
        _ => None,
    }
}

/// Returns the text between the quotes of `#"…"#`.
fn raw_content(raw: &str) -> Option<&str> {
    let hashes = raw.find('"')?;
    let (open, rest) = raw.split_at(hashes);
    rest.strip_prefix('"')?
        .strip_suffix(open)?
        .strip_suffix('"')
}

/// Returns the characters that a string's content stands for.
fn unescaped(content: &str) -> Option<String> {
    let mut value = String::new();
    let mut rest = content.chars();
    while let Some(c) = rest.next() {
        if c != '\\' {
            value.push(c);
            continue;
        }
        value.push(match rest.next()? {
            'n' => '\n',
            'r' => '\r',
            't' => '\t',
            '0' => '\0',
            'x' => hexadecimal(&rest.by_ref().take(2).collect::<String>())?,
            'u' => {
                let digits: String = rest.by_ref().take_while(|c| *c != '}').collect();
                hexadecimal(&digits.strip_prefix('{')?.replace('_', ""))?
            }
            '\n' => {
                rest = rest.as_str().trim_start().chars();
                continue;
            }
            same => same,
        });
    }
    Some(value)
}

fn hexadecimal(digits: &str) -> Option<char> {
    char::from_u32(u32::from_str_radix(digits, 16).ok()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(source: &str) -> Option<String> {
        let token = source.parse::<proc_macro2::TokenStream>().unwrap();
        string(&token.into_iter().next().unwrap()).map(|text| text.value)
    }

    #[test]
    fn strings_have_the_value_that_rust_gives_them() {
        for (source, expected) in [
            (r#""walk.prg""#, "walk.prg"),
            (r#""a\n\t\r\0\\\"\'""#, "a\n\t\r\0\\\"'"),
            (r#""\x41\u{3042}\u{1_F600}""#, "A\u{3042}\u{1F600}"),
            ("\"one \\\n    two\"", "one two"),
            (r##"r"a\n""##, "a\\n"),
            (r###"r#"say "hi""#"###, "say \"hi\""),
            ("r\"\"", ""),
            ("\"\"", ""),
        ] {
            assert_eq!(value(source).as_deref(), Some(expected), "{source}");
        }
    }

    #[test]
    fn other_literals_are_no_strings() {
        for source in ["1", "1.0", "'a'", "b\"a\"", "c\"a\"", "br\"a\"", "word"] {
            assert_eq!(value(source), None, "{source}");
        }
    }
}
