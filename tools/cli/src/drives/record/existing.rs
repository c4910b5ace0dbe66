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
    /// The line before which the motion is inserted, from 1.
    line: u32,
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
        let end = program.steps().last().map_or(FIRST, |step| step.line);
        let line = match place {
            Place::End => end,
            Place::Line(line) if line <= end => line,
            Place::Line(line) => {
                let file = file();
                return Err(Error::failed(
                    Driving::RecordBeyond { file, line, end },
                    lang,
                ));
            }
        };
        let is_apart = |char: char| !char.is_ascii_alphanumeric() && char != '_';
        let words = loaded.source.text().split(is_apart);
        Ok(Existing {
            words: words.map(str::to_ascii_uppercase).collect(),
            line,
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

    /// Returns this program with the statements of another one in it, indented as the line that follows them, and the warnings and
    /// errors of both together.
    pub(super) fn with(&self, other: &str, robot: &Robot) -> (Vec<u8>, Loaded) {
        let source = &self.loaded.source;
        let lines = source.lines();
        let before = lines.clone().nth(self.line as usize - 1);
        let (start, text) = before.map_or((source.text().len(), ""), |line| {
            (line.span.start, source.slice(line.span))
        });
        let indent = &text[..text.len() - text.trim_start_matches([' ', '\t']).len()];
        let line_end = lines.map(|line| source.slice(line.end)).next();
        let line_end = line_end.filter(|end| !end.is_empty()).unwrap_or("\n");
        let mut block = String::new();
        // The last line of the other program is its END.
        let statements = other
            .trim_end()
            .rsplit_once('\n')
            .map_or("", |(all, _)| all);
        for (number, line) in (1..).zip(statements.lines()) {
            match number {
                1 => continue,
                2 => block += &format!("{indent}// {line}"),
                _ if line.is_empty() => {}
                _ => block += &format!("{indent}{line}"),
            }
            block += line_end;
        }
        block += line_end;
        let inserted = [(Span::new(start, start), block.as_str())];
        let bytes = source.changed(inserted.into_iter());
        let mut loaded = tip_lint::load(source.name(), &bytes, &robot.options());
        robot.warn(&mut loaded);
        (bytes, loaded)
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
