//! Arguments that are several things.

use super::say::{Said, Say};
use super::{Cut, Lang, Message};
use std::fmt::{self, Formatter};

/// Maximum number of pieces of a path that are shown.
const PIECES: usize = 8;

/// Things with a comma between them: `a, b, c`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct List(pub Vec<String>);

impl Say for List {
    fn say(&self, _: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&cut(&self.0).join(", "))
    }
}

/// Things to be told apart by their quotes: `` `a`, `b` ``.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quoted(pub Vec<String>);

impl Say for Quoted {
    fn say(&self, _: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "`{}`", cut(&self.0).join("`, `"))
    }
}

/// Things that there are: `a, b and c`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Each(pub Vec<String>);

impl Say for Each {
    fn say(&self, lang: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        let mut names = cut(&self.0);
        if let (Lang::English, 2..) = (lang, names.len()) {
            let last = names.pop().unwrap_or_default();
            return write!(f, "{} and {last}", names.join(", "));
        }
        f.write_str(&names.join(lang.pick(", ", "、")))
    }
}

/// Names, as much of each as is shown.
fn cut(names: &[String]) -> Vec<String> {
    names
        .iter()
        .map(|name| Cut::word(name).to_string())
        .collect()
}

/// The lines of a path through a program: runs of steps without a jump, the first and the last line of each.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pieces(pub Vec<(u32, u32)>);

impl Say for Pieces {
    fn say(&self, _: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        let pieces: Vec<String> = self.0.iter().map(piece).collect();
        if pieces.len() <= PIECES {
            return f.write_str(&pieces.join(", "));
        }
        let start = &pieces[..PIECES / 2];
        let end = &pieces[pieces.len() - PIECES / 2..];
        write!(f, "{}, …, {}", start.join(", "), end.join(", "))
    }
}

fn piece((first, last): &(u32, u32)) -> String {
    match first == last {
        true => format!("{first}"),
        false => format!("{first}-{last}"),
    }
}

/// A list of faults: `this; that`.
#[derive(Clone, Debug, PartialEq)]
pub struct Faults(pub Vec<Message>);

impl Say for Faults {
    fn say(&self, lang: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        for (index, fault) in self.0.iter().enumerate() {
            let gap = if index == 0 { "" } else { "; " };
            write!(f, "{gap}{}", Said(fault, lang))?;
        }
        Ok(())
    }
}

/// A list of possible spellings: `` `this`, or `that` ``.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Alternatives(pub Vec<String>);

impl Say for Alternatives {
    fn say(&self, lang: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        let or = lang.pick("`, or `", "` または `");
        write!(f, "`{}`", self.0.join(or))
    }
}

/// Things of which one is meant: `this or that`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OneOf(pub Vec<String>);

impl Say for OneOf {
    fn say(&self, lang: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.join(lang.pick(" or ", "か")))
    }
}

/// Things that are all meant: `this and that`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Both(pub Vec<&'static str>);

impl Say for Both {
    fn say(&self, lang: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.join(lang.pick(" and ", "と")))
    }
}
