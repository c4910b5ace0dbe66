//! Where Rust sources compile programs, read from their tokens alone.

use proc_macro2::{Delimiter, Literal, TokenStream, TokenTree};

/// The robot where nothing is said.
const DEFAULT: &str = "titan8";

/// A place that compiles a program.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Site {
    /// The path of the program as it is written.
    pub(super) program: String,
    pub(super) robot: Said,
    /// From 1.
    pub(super) line: usize,
}

/// What a site says of its robot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Said {
    Named(String),
    /// The path of a description.
    File(String),
    /// Nothing that can be read for certain.
    Unclear,
}

/// Each `include_tip!` of a source.
pub(super) fn of_macros(text: &str) -> Vec<Site> {
    let mut found = Vec::new();
    walk(text, &mut |tokens| {
        for three in tokens.windows(3) {
            if let [
                TokenTree::Ident(name),
                TokenTree::Punct(mark),
                TokenTree::Group(group),
            ] = three
                && name == "include_tip"
                && mark.as_char() == '!'
            {
                found.extend(included(group.stream(), text));
            }
        }
    });
    found
}

/// Each program that a build script compiles.
pub(super) fn of_script(text: &str) -> Vec<Site> {
    let mut found = Vec::new();
    walk(text, &mut |tokens| {
        let is_end =
            |token: &TokenTree| matches!(token, TokenTree::Punct(it) if it.as_char() == ';');
        for statement in tokens.split(is_end) {
            found.extend(compiled(statement, text));
        }
    });
    found
}

/// Shows every list of tokens, the outermost first; nothing of what is not Rust.
fn walk(text: &str, see: &mut impl FnMut(&[TokenTree])) {
    if let Ok(tokens) = text.parse::<TokenStream>() {
        walk_into(tokens, see);
    }
}

fn walk_into(tokens: TokenStream, see: &mut impl FnMut(&[TokenTree])) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    see(&tokens);
    for token in tokens {
        if let TokenTree::Group(group) = token {
            walk_into(group.stream(), see);
        }
    }
}

/// `[visibility] "path" [as Name] [, option = value]…`
fn included(arguments: TokenStream, text: &str) -> Option<Site> {
    let tokens: Vec<TokenTree> = arguments.into_iter().collect();
    let mut parts = tokens.split(|token| is(token, ','));
    let literals = parts.next()?.iter().filter_map(literal);
    let [(literal, program)] = literals.collect::<Vec<_>>().try_into().ok()?;
    let mut robot = Said::Named(DEFAULT.to_owned());
    for part in parts {
        match part {
            [TokenTree::Ident(option), equals, value @ ..] if is(equals, '=') => {
                if option == "robot" {
                    robot = said(value);
                }
            }
            [] => {}
            _ => robot = Said::Unclear,
        }
    }
    let line = line(text, &literal);
    Some(Site {
        program,
        robot,
        line,
    })
}

/// The programs of a statement that compiles some, with settings that it makes itself.
fn compiled(statement: &[TokenTree], text: &str) -> Vec<Site> {
    let call = |wanted: &str| {
        let is_it = |pair: &&[TokenTree]| match pair {
            [TokenTree::Ident(name), TokenTree::Group(group)] => {
                name == wanted && group.delimiter() == Delimiter::Parenthesis
            }
            _ => false,
        };
        let found = statement.windows(2).position(|pair| is_it(&pair))?;
        let is_method = found > 0 && is(&statement[found - 1], '.');
        let TokenTree::Group(group) = &statement[found + 1] else {
            return None;
        };
        Some((is_method, group.stream()))
    };
    let Some((is_method, programs)) = call("compile") else {
        return Vec::new();
    };
    let makes_them = ["new", "default"].map(call).iter().any(Option::is_some);
    let robot = match (call("robot"), call("robot_file")) {
        _ if is_method && !makes_them => Said::Unclear,
        (Some(_), Some(_)) => Said::Unclear,
        (Some((_, value)), None) => variant(value),
        (None, Some((_, path))) => said(&path.into_iter().collect::<Vec<_>>()),
        (None, None) => Said::Named(DEFAULT.to_owned()),
    };
    let mut sites = Vec::new();
    walk_into(programs, &mut |tokens| {
        let found = tokens.iter().filter_map(literal);
        sites.extend(found.map(|(literal, program)| Site {
            program,
            robot: robot.clone(),
            line: line(text, &literal),
        }));
    });
    sites
}

/// `robot = …`: a word, or a string.
fn said(value: &[TokenTree]) -> Said {
    match value {
        [TokenTree::Ident(name)] => Said::Named(name.to_string()),
        [token] => match literal(token) {
            Some((_, path)) if path.ends_with(".toml") => Said::File(path),
            Some((_, name)) => Said::Named(name),
            None => Said::Unclear,
        },
        _ => Said::Unclear,
    }
}

/// `tipc::Robot::Hand`: the last word names the robot.
fn variant(value: TokenStream) -> Said {
    match value.into_iter().last() {
        Some(TokenTree::Ident(name)) => Said::Named(name.to_string()),
        _ => Said::Unclear,
    }
}

fn is(token: &TokenTree, mark: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == mark)
}

/// A string without escapes, as it is spelled and what it says.
fn literal(token: &TokenTree) -> Option<(Literal, String)> {
    let TokenTree::Literal(literal) = token else {
        return None;
    };
    let spelled = literal.to_string();
    let raw = spelled.strip_prefix('r').map(|raw| raw.trim_matches('#'));
    let said = raw
        .unwrap_or(&spelled)
        .strip_prefix('"')?
        .strip_suffix('"')?;
    let is_plain = raw.is_some() || !said.contains('\\');
    is_plain.then(|| (literal.clone(), said.to_owned()))
}

/// The first line of code in which a literal stands.
fn line(text: &str, literal: &Literal) -> usize {
    let spelled = literal.to_string();
    let is_there = |line: &str| line.contains(&spelled) && !line.trim_start().starts_with("//");
    text.lines().position(is_there).map_or(1, |index| index + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn robots(sites: &[Site]) -> Vec<(&str, &str, usize)> {
        sites
            .iter()
            .map(|site| {
                let robot = match &site.robot {
                    Said::Named(name) => name.as_str(),
                    Said::File(path) => path.as_str(),
                    Said::Unclear => "?",
                };
                (site.program.as_str(), robot, site.line)
            })
            .collect()
    }

    #[test]
    fn macros_name_their_robot_in_every_way_that_they_take() {
        let text = r##"
// include_tip!("a.prg", robot = hand);
/// include_tip!("a.prg");
tip_macros::include_tip!(pub "a.prg");
mod inner {
    include_tip!(pub(crate) "b.prg" as Bee, encoding = utf8, robot = hand,);
    include_tip! { "c.prg", robot = "generic" }
}
include_tip!(r#"d.prg"#, robot = "ours.toml", runtime = crate::robot);
fn f() { let text = "include_tip!(\"e.prg\")"; }
macro_rules! g { ($p:literal) => { include_tip!($p, robot = hand); include_tip!("f.prg", robot = $r); } }
other_tip!("h.prg");
"##;
        let sites = of_macros(text);
        assert_eq!(
            robots(&sites),
            [
                ("a.prg", "titan8", 4),
                ("d.prg", "ours.toml", 9),
                ("b.prg", "hand", 6),
                ("c.prg", "generic", 7),
                ("f.prg", "?", 11),
            ]
        );
    }

    #[test]
    fn what_is_not_rust_says_nothing() {
        assert!(of_macros("include_tip!(\"a.prg\"").is_empty());
        assert!(of_macros("include_tip!(\"a.prg\" \"b.prg\")").is_empty());
        assert!(of_macros("include_tip!(\"a\\x2eprg\")").is_empty());
        assert!(of_script("fn main() { compile(").is_empty());
    }

    #[test]
    fn scripts_name_their_robot_where_they_make_their_settings() {
        let text = r#"
fn main() -> Result<(), tipc::BuildError> {
    tipc::compile("a.prg")?;
    tipc::Config::new().robot(tipc::Robot::Hand).compile(&["b.prg", "c.prg"])?;
    Config::default().robot_file("ours.toml").compile(&["d.prg"])?;
    Config::new().visibility("pub(crate)").compile(&["e.prg"])?;
    settings.compile(&["f.prg"])?;
    Config::new().robot(chosen()).compile(&["g.prg"])
}"#;
        let sites = of_script(text);
        assert_eq!(
            robots(&sites),
            [
                ("a.prg", "titan8", 3),
                ("b.prg", "Hand", 4),
                ("c.prg", "Hand", 4),
                ("d.prg", "ours.toml", 5),
                ("e.prg", "titan8", 6),
                ("f.prg", "?", 7),
                ("g.prg", "?", 8),
            ]
        );
    }
}
