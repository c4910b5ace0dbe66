//! A program in an editor: its text with diagnostics, symbols and program, as other modules use them.

use std::cell::OnceCell;
use tip_lint::cycles::{self, Part, Sampling};
use tip_lint::load;
use tipc::language::Edition;
use tipc::source::{Encoding, Source, Span};
use tipc::symbols::{Definition, Use};
use tipc::syntax::Statement;
use tipc::{Loaded, Options, Robot};

/// A program in an editor. A document is one version of the text; a change makes another document.
#[derive(Clone, Debug)]
pub struct Document {
    pub(crate) loaded: Loaded,
    pub(crate) options: Options,
    /// The durations of the parts of the program, once they are needed.
    parts: OnceCell<Vec<Part>>,
    /// True if the program sets the sampling time, once it is needed.
    pub(crate) sets_sampling: OnceCell<bool>,
}

impl Document {
    /// Compiles a text. `name` is the file of its diagnostics. The encoding of the options does not matter: it is for files.
    pub fn new(name: &str, text: &str, options: &Options) -> Self {
        let options = Options {
            encoding: Encoding::Utf8,
            ..*options
        };
        Document::of(load(name, text.as_bytes(), &options), &options)
    }

    /// Returns a document of a program that was loaded with some options.
    pub fn of(loaded: Loaded, options: &Options) -> Self {
        Document {
            loaded,
            options: *options,
            parts: OnceCell::new(),
            sets_sampling: OnceCell::new(),
        }
    }

    /// Computes what hovers and inlay hints need, so that they need not wait for it.
    pub fn prepare(&self) {
        self.parts();
    }

    /// Adds diagnostics, as `tip_sim::Robot::warn` does.
    pub fn judge(&mut self, judge: impl FnOnce(&mut Loaded)) {
        judge(&mut self.loaded);
    }

    /// Returns diagnostics, statements, symbols and program.
    pub fn loaded(&self) -> &Loaded {
        &self.loaded
    }

    /// Returns the text and its lines.
    pub fn source(&self) -> &Source {
        &self.loaded.source
    }

    pub(crate) fn robot(&self) -> Robot {
        self.options.robot
    }

    pub(crate) fn edition(&self) -> Edition {
        self.loaded.module.edition
    }

    pub(crate) fn slice(&self, span: Span) -> &str {
        self.loaded.source.slice(span)
    }

    pub(crate) fn statements(&self) -> &[Statement] {
        &self.loaded.module.statements
    }

    /// Returns the line of a byte of the text, from 1.
    pub(crate) fn line_of(&self, offset: usize) -> u32 {
        self.loaded.source.line_column(offset).0
    }

    pub(crate) fn definition_of(&self, named: &Use) -> &Definition {
        self.loaded.symbols.definition(named.definition)
    }

    /// Returns the name, label or placeholder at a byte of the text, or right before it.
    pub(crate) fn name_at(&self, offset: usize) -> Option<&Use> {
        self.loaded.symbols.at(offset)
    }

    /// Returns the durations of the parts of the program; none for a program with errors.
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
