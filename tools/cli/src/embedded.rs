//! The crate around a program: warns if its macros and its build script compile the program for another robot than `tip.toml` names.

use crate::input::display_path;
use crate::message::Linting;
use crate::setup::RobotChoice;
use proc_macro2::{Delimiter, Literal, TokenStream, TokenTree};
use std::fs;
use std::path::{Path, PathBuf};
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::embed::{LIMIT, read_file};
use tipc::source::Span;

/// Maximum number of sources of a crate that are read.
const MOST_SOURCES: usize = 1_000;
/// Maximum size of a source, MiB.
const MAX_SOURCE_MIB: usize = 1;
/// Maximum depth of folders below `src`.
const DEPTH: usize = 16;

/// Returns the warning that the crate compiles the program for another robot than the `tip.toml` at `project` gives it, and nowhere
/// for that one. Sources that cannot be read for certain cause no warning.
pub(super) fn warning(program: &Path, project: &Path, robot: &RobotChoice) -> Option<Diagnostic> {
    let found = differing(program, robot)?;
    let project = project.display().to_string();
    let place = Span::new(0, 0);
    let reason = Linting::CompiledForAnother {
        project: project.clone().into(),
        given: robot.to_string(),
        source: found.source.into(),
        other: found.robot,
    };
    let help = Linting::SayOneRobot {
        project: project.into(),
    };
    Some(Diagnostic::new(Code::OtherRobot, place, reason).help(help))
}

/// A place that compiles the program for another robot.
struct OtherRobot {
    /// File and line.
    source: String,
    robot: String,
}

fn differing(program: &Path, robot: &RobotChoice) -> Option<OtherRobot> {
    let program = fs::canonicalize(program).ok()?;
    let mut folders = program.ancestors().skip(1);
    let package = folders.find(|folder| folder.join("Cargo.toml").is_file())?;
    let mut first = None;
    for source in sources(package) {
        let Some(text) = text(&source) else { continue };
        let is_script = source.parent() == Some(package);
        let sites = if is_script {
            of_script(&text)
        } else {
            of_macros(&text)
        };
        let beside = source.parent().unwrap_or(package);
        for site in sites
            .iter()
            .filter(|site| names(site, &program, &[beside, package]))
        {
            let compiled = choice(&site.robot, &[beside, package])?;
            if is_same(&compiled, robot) {
                return None;
            }
            first.get_or_insert_with(|| OtherRobot {
                source: format!("{}:{}", display_path(&source).display(), site.line),
                robot: compiled.to_string(),
            });
        }
    }
    first
}

/// Returns the build script and the sources below `src`.
fn sources(package: &Path) -> Vec<PathBuf> {
    let mut found = vec![package.join("build.rs")];
    collect(&package.join("src"), DEPTH, &mut found);
    found
}

fn collect(folder: &Path, depth: usize, found: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else {
        return;
    };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths {
        let is_folder = path.symlink_metadata().is_ok_and(|it| it.is_dir());
        if found.len() >= MOST_SOURCES {
            return;
        } else if is_folder && depth > 0 {
            collect(&path, depth - 1, found);
        } else if path.extension().is_some_and(|end| end == "rs") {
            found.push(path);
        }
    }
}

fn text(source: &Path) -> Option<String> {
    String::from_utf8(read_file(source, MAX_SOURCE_MIB).ok()?).ok()
}

/// Returns true if a site names the program: the first folder that has its file counts, as for the macro.
fn names(site: &Site, program: &Path, folders: &[&Path]) -> bool {
    let candidates = folders.iter().map(|folder| folder.join(&site.program));
    let mut files = candidates.filter_map(|file| fs::canonicalize(file).ok());
    files.next().is_some_and(|file| file == program)
}

/// Returns the robot of a site.
fn choice(value: &SiteRobot, folders: &[&Path]) -> Option<RobotChoice> {
    match value {
        SiteRobot::Named(name) => name.parse().ok(),
        SiteRobot::File(path) => {
            let candidates = folders.iter().map(|folder| folder.join(path));
            let mut files = candidates.filter(|file| file.is_file());
            files
                .next()
                .map(|file| RobotChoice::File(display_path(&file)))
        }
        SiteRobot::Unclear => None,
    }
}

fn is_same(one: &RobotChoice, other: &RobotChoice) -> bool {
    match (one.file(), other.file()) {
        (Some(one), Some(other)) => {
            let text = |path| read_file(path, LIMIT).ok();
            text(one) == text(other)
        }
        _ => one == other,
    }
}

/// The robot of a site that names none.
const DEFAULT: &str = "titan8";

/// A place that compiles a program.
#[derive(Debug, PartialEq, Eq)]
struct Site {
    /// The path of the program in the source.
    program: String,
    robot: SiteRobot,
    /// The line, from 1.
    line: usize,
}

/// The robot that a site names.
#[derive(Clone, Debug, PartialEq, Eq)]
enum SiteRobot {
    Named(String),
    /// The path of a description.
    File(String),
    /// An expression that cannot be evaluated here.
    Unclear,
}

/// Returns each `include_tip!` of a source.
fn of_macros(text: &str) -> Vec<Site> {
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

/// Returns each program that a build script compiles.
fn of_script(text: &str) -> Vec<Site> {
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

/// Visits every list of tokens, the outermost first; nothing if the text is not Rust.
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

/// Parses `[visibility] "path" [as Name] [, option = value]…`.
fn included(arguments: TokenStream, text: &str) -> Option<Site> {
    let tokens: Vec<TokenTree> = arguments.into_iter().collect();
    let mut parts = tokens.split(|token| is(token, ','));
    let literals = parts.next()?.iter().filter_map(literal);
    let [(literal, program)] = literals.collect::<Vec<_>>().try_into().ok()?;
    let mut robot = SiteRobot::Named(DEFAULT.to_owned());
    for part in parts {
        match part {
            [TokenTree::Ident(option), equals, value @ ..] if is(equals, '=') => {
                if option == "robot" {
                    robot = robot_value(value);
                }
            }
            [] => {}
            _ => robot = SiteRobot::Unclear,
        }
    }
    let line = line(text, &literal);
    Some(Site {
        program,
        robot,
        line,
    })
}

/// Returns the programs that a statement compiles with settings of its own.
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
        _ if is_method && !makes_them => SiteRobot::Unclear,
        (Some(_), Some(_)) => SiteRobot::Unclear,
        (Some((_, value)), None) => variant(value),
        (None, Some((_, path))) => robot_value(&path.into_iter().collect::<Vec<_>>()),
        (None, None) => SiteRobot::Named(DEFAULT.to_owned()),
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

/// Parses the value of `robot = …`: a word, or a string.
fn robot_value(value: &[TokenTree]) -> SiteRobot {
    match value {
        [TokenTree::Ident(name)] => SiteRobot::Named(name.to_string()),
        [token] => match literal(token) {
            Some((_, path)) if path.ends_with(".toml") => SiteRobot::File(path),
            Some((_, name)) => SiteRobot::Named(name),
            None => SiteRobot::Unclear,
        },
        _ => SiteRobot::Unclear,
    }
}

/// Parses `tipc::Robot::Hand`: the last word names the robot.
fn variant(value: TokenStream) -> SiteRobot {
    match value.into_iter().last() {
        Some(TokenTree::Ident(name)) => SiteRobot::Named(name.to_string()),
        _ => SiteRobot::Unclear,
    }
}

fn is(token: &TokenTree, mark: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == mark)
}

/// Returns a string literal without escapes, and its text.
fn literal(token: &TokenTree) -> Option<(Literal, String)> {
    let TokenTree::Literal(literal) = token else {
        return None;
    };
    let written = literal.to_string();
    let raw = written.strip_prefix('r').map(|raw| raw.trim_matches('#'));
    let value = raw
        .unwrap_or(&written)
        .strip_prefix('"')?
        .strip_suffix('"')?;
    let is_plain = raw.is_some() || !value.contains('\\');
    is_plain.then(|| (literal.clone(), value.to_owned()))
}

/// Returns the first line of code with a literal.
fn line(text: &str, literal: &Literal) -> usize {
    let written = literal.to_string();
    let is_there = |line: &str| line.contains(&written) && !line.trim_start().starts_with("//");
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
                    SiteRobot::Named(name) => name.as_str(),
                    SiteRobot::File(path) => path.as_str(),
                    SiteRobot::Unclear => "?",
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
