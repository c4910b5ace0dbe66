//! A program in an editor: its text, and all that is known of it.

use std::cell::OnceCell;
use tip_lint::cycles::{self, Part, Sampling};
use tip_lint::load;
use tipc::source::{Encoding, Source, Span};
use tipc::symbols::{Definition, Use};
use tipc::syntax::Statement;
use tipc::{Loaded, Options, Robot};

/// A program in an editor. It answers for one text; another text is another document.
#[derive(Clone, Debug)]
pub struct Document {
    pub(crate) loaded: Loaded,
    pub(crate) options: Options,
    /// What the parts of the program take, once somebody asks.
    parts: OnceCell<Vec<Part>>,
    /// Whether the program sets a sampling time of its own, once somebody asks.
    pub(crate) sets_sampling: OnceCell<bool>,
}

impl Document {
    /// Reads a text; the encoding of the options is that of files and plays no part. `name` is how findings call it.
    pub fn new(name: &str, text: &str, options: &Options) -> Self {
        let options = Options {
            encoding: Encoding::Utf8,
            ..*options
        };
        Document::of(load(name, text.as_bytes(), &options), &options)
    }

    /// A program that has been read by these options.
    pub fn of(loaded: Loaded, options: &Options) -> Self {
        Document {
            loaded,
            options: *options,
            parts: OnceCell::new(),
            sets_sampling: OnceCell::new(),
        }
    }

    /// Finds out now what hovers and hints need, and would have to wait for.
    pub fn prepare(&self) {
        self.parts();
    }

    /// Lets someone add to what was found, as `tip_sim::reach::warn` does.
    pub fn judge(&mut self, judge: impl FnOnce(&mut Loaded)) {
        judge(&mut self.loaded);
    }

    /// The text as it was read: findings, statements, names and program.
    pub fn loaded(&self) -> &Loaded {
        &self.loaded
    }

    /// The text and its lines.
    pub fn source(&self) -> &Source {
        &self.loaded.source
    }

    pub(crate) fn robot(&self) -> Robot {
        self.options.robot
    }

    pub(crate) fn slice(&self, span: Span) -> &str {
        self.loaded.source.slice(span)
    }

    pub(crate) fn statements(&self) -> &[Statement] {
        &self.loaded.module.statements
    }

    /// The line of a byte of the text, from 1.
    pub(crate) fn line_of(&self, offset: usize) -> u32 {
        self.loaded.source.line_column(offset).0
    }

    pub(crate) fn definition_of(&self, named: &Use) -> &Definition {
        self.loaded.symbols.definition(named.definition)
    }

    /// The name, label or placeholder at a byte of the text, or right before it.
    pub(crate) fn name_at(&self, offset: usize) -> Option<&Use> {
        self.loaded.symbols.at(offset)
    }

    /// How many cycles the parts of the program take; nothing of a program with errors.
    pub(crate) fn parts(&self) -> &[Part] {
        self.parts.get_or_init(|| {
            let program = self.loaded.program.as_ref();
            program.map_or(Vec::new(), |program| {
                cycles::parts(program, self.sampling()).counted
            })
        })
    }

    pub(crate) fn sampling(&self) -> Sampling {
        Sampling::of(self.robot())
    }
}
