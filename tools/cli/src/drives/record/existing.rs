//! Inserts a taught motion into a program that exists. Every other byte of the program stays.

use crate::choices::OutputOptions;
use crate::error::Error;
use crate::input;
use crate::message::{Driving, Using};
use std::collections::HashSet;
use std::path::Path;
use tip_sim::Robot;
use tipc::Loaded;
use tipc::language::Edition;
use tipc::source::Span;

/// A place in a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// Before its END.
    End,
    /// Before this line, from 1.
    Line(u32),
}

impl Place {
    /// Parses the place on the command line.
    pub(super) fn parse(text: &str) -> Result<Self, Using> {
        if text.eq_ignore_ascii_case("end") {
            return Ok(Place::End);
        }
        let line = text.parse().ok().filter(|line| *line >= FIRST);
        line.map(Place::Line).ok_or_else(|| Using::RecordPlace {
            text: text.to_owned(),
        })
    }
}

/// The first line of statements.
const FIRST: u32 = 3;

/// A program that exists.
#[derive(Debug)]
pub(super) struct Existing {
    loaded: Loaded,
    /// The byte before which the motion is inserted.
    at: usize,
    /// True if the statements before it are on its line.
    is_inside: bool,
    words: HashSet<String>,
}

impl Existing {
    /// Reads and checks a program.
    ///
    /// # Errors
    /// It cannot be read, is no program for the robot, has an edition without the words of a taught motion, or has no such line.
    pub(super) fn read(
        path: &Path,
        place: Place,
        robot: &Robot,
        options: OutputOptions,
    ) -> Result<Self, Error> {
        let loaded = input::load_file(path, &robot.options());
        let Some(program) = &loaded.program else {
            return Err(Error::Refused(Box::new(loaded), options));
        };
        let (name, lang) = (loaded.source.name().to_owned(), options.lang());
        let file = || name.clone().into();
        if program.edition() == Edition::V3_1 {
            return Err(Error::failed(Driving::RecordEdition { file: file() }, lang));
        }
        let source = &loaded.source;
        let end = loaded.module.statements.last();
        let (line, span) = end.map_or((FIRST, Span::new(0, 0)), |end| (end.line, end.span));
        let begin = |line: u32| {
            let line = source.lines().nth(line as usize - 1);
            line.map_or(source.text().len(), |line| line.span.start)
        };
        let at = match place {
            Place::End => {
                let is_first = source
                    .slice(Span::new(begin(line), span.start))
                    .trim()
                    .is_empty();
                if is_first { begin(line) } else { span.start }
            }
            Place::Line(place) if place <= line => begin(place),
            Place::Line(place) => {
                let beyond = Driving::RecordBeyond {
                    file: file(),
                    line: place,
                    end: line,
                };
                return Err(Error::failed(beyond, lang));
            }
        };
        let is_apart = |char: char| !char.is_ascii_alphanumeric() && char != '_';
        let words = source.text().split(is_apart);
        Ok(Existing {
            words: words.map(str::to_ascii_uppercase).collect(),
            is_inside: source.lines().all(|line| line.span.start != at),
            at,
            loaded,
        })
    }

    /// Returns the bytes that were read from its file.
    pub(super) fn bytes(&self) -> Vec<u8> {
        self.loaded.source.bytes()
    }

    /// Returns true if a word, in capital letters, occurs in the program.
    pub(super) fn has(&self, word: &str) -> bool {
        self.words.contains(word)
    }

    /// Returns the name of the program in messages.
    pub(super) fn name(&self) -> &str {
        self.loaded.source.name()
    }

    /// Returns the statements of another program as lines of this one, indented as the line before which they will stand.
    pub(super) fn lines(&self, other: &str) -> String {
        let (line_end, indent) = (self.line_end(), self.indent());
        let mut lines = String::new();
        // The last line of the other program is its END.
        let statements = other.trim_end().rsplit_once('\n');
        let statements = statements.map_or("", |(all, _)| all);
        for (number, line) in (1..).zip(statements.lines()) {
            match number {
                1 => continue,
                2 => lines += &format!("{indent}// {line}"),
                _ if line.is_empty() => {}
                _ => lines += &format!("{indent}{line}"),
            }
            lines += line_end;
        }
        lines + line_end
    }

    /// Returns the end of the lines of this program.
    fn line_end(&self) -> &str {
        let source = &self.loaded.source;
        let mut ends = source.lines().map(|line| source.slice(line.end));
        ends.next().filter(|end| !end.is_empty()).unwrap_or("\n")
    }

    /// Returns the blanks at the beginning of the line before which, or inside of which, lines are inserted.
    fn indent(&self) -> &str {
        let source = &self.loaded.source;
        let mut lines = source.lines().map(|line| line.span);
        let line = lines.find(|span| (span.start..=span.end).contains(&self.at));
        let text = line.map_or("", |span| source.slice(span));
        &text[..text.len() - text.trim_start_matches([' ', '\t']).len()]
    }

    /// Returns the bytes of this program with lines inserted. A line that has statements before END is parted there.
    pub(super) fn with(&self, lines: &str) -> Vec<u8> {
        let at = Span::new(self.at, self.at);
        let text = match self.is_inside {
            true => format!("{}{lines}{}", self.line_end(), self.indent()),
            false => lines.to_owned(),
        };
        let inserted = [(at, text.as_str())];
        self.loaded.source.changed(inserted.into_iter())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_a_line_of_statements_or_the_end() {
        assert_eq!(Place::parse("END"), Ok(Place::End));
        assert_eq!(Place::parse("3"), Ok(Place::Line(3)));
        for text in ["2", "0", "-3", "", "3.5", "last"] {
            assert!(Place::parse(text).is_err(), "{text}");
        }
    }
}
