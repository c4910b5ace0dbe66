//! Names: their declarations and references, and renaming, which is refused unless the program keeps its meaning.

use crate::Document;
use crate::message::Editing;
use tip_lint::load;
use tipc::Loaded;
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Edit};
use tipc::language::names;
use tipc::language::reserved::{LOOP, is_reserved};
use tipc::message::{Message, Naming, Parsing};
use tipc::source::Span;
use tipc::symbols::{Access, Definition, DefinitionKind, Symbols, Use};

/// A use or declaration of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reference {
    /// The name alone, without sign, member and colon.
    pub span: Span,
    /// Its kind.
    pub kind: ReferenceKind,
}

/// The kind of a reference.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ReferenceKind {
    /// It declares the name.
    Declares,
    /// It assigns the variable.
    Assigns,
    /// It reads the variable, or jumps to the label.
    Uses,
}

/// A name that can be changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RenameTarget {
    /// The name in the text.
    pub span: Span,
    /// Its spelling there.
    pub name: String,
}

impl Document {
    /// Returns the declaration of the name at a byte of the text; for a jump without a label, that of LOOP.
    pub fn definition(&self, offset: usize) -> Option<Span> {
        let named = self.written_or_implied(offset)?;
        self.definition_of(named).span
    }

    /// Returns all references to the name at a byte of the text in order, the declaration only if `with_declaration`.
    pub fn references(&self, offset: usize, with_declaration: bool) -> Vec<Reference> {
        let Some(named) = self.written_or_implied(offset) else {
            return Vec::new();
        };
        let uses = self.loaded.symbols.uses(named.definition);
        let written = uses.filter(|it| it.span.start < it.span.end);
        let references = written.map(|it| Reference {
            span: it.span,
            kind: self.reference_kind(it),
        });
        references
            .filter(|it| with_declaration || it.kind != ReferenceKind::Declares)
            .collect()
    }

    fn reference_kind(&self, named: &Use) -> ReferenceKind {
        if self.definition_of(named).span == Some(named.span) {
            return ReferenceKind::Declares;
        }
        match named.access {
            Access::Define => ReferenceKind::Declares,
            Access::Assign | Access::Update | Access::Count => ReferenceKind::Assigns,
            _ => ReferenceKind::Uses,
        }
    }

    /// Returns the name there, or the implied one of a GOTO, NEXT or KEY_IN without arguments.
    fn written_or_implied(&self, offset: usize) -> Option<&Use> {
        if let Some(named) = self.name_at(offset) {
            return Some(named);
        }
        let statement = &self.statements()[self.loaded.module.statement_at(offset)?];
        let mut uses = self.loaded.symbols.within(statement.span).iter();
        uses.find(|it| it.span.start == it.span.end)
    }
}

impl Document {
    /// Returns the name at a byte of the text.
    ///
    /// # Errors
    ///
    /// There is no name that can be changed.
    pub fn prepare_rename(&self, offset: usize) -> Result<RenameTarget, Message> {
        let named = self.renameable(offset)?;
        Ok(RenameTarget {
            span: named.span,
            name: self.slice(named.span).to_owned(),
        })
    }

    /// Returns the edits that rename what the text names at a byte.
    ///
    /// # Errors
    ///
    /// There is no name that can be changed, the new name is not allowed, or it would change the meaning of the program.
    pub fn rename(&self, offset: usize, name: &str) -> Result<Vec<Edit>, Message> {
        let named = *self.renameable(offset)?;
        let definition = self.definition_of(&named);
        let upper = name.to_ascii_uppercase();
        self.check_name(definition, &upper)?;
        let uses = self.loaded.symbols.uses(named.definition);
        let written = uses.filter(|it| it.span.start < it.span.end);
        let edits: Vec<Edit> = written.map(|it| Edit::replace(it.span, name)).collect();
        match self.keeps_meaning(&edits, definition, &upper) {
            true => Ok(edits),
            false => Err(Editing::OtherMeaning { name: upper.into() }.into()),
        }
    }

    fn renameable(&self, offset: usize) -> Result<&Use, Message> {
        let Some(named) = self.name_at(offset) else {
            let word = self
                .word_at(offset)
                .map(|word| self.slice(word.span).to_ascii_uppercase());
            let edition = self.loaded.module.edition;
            return Err(match word.filter(|word| is_reserved(word, edition)) {
                Some(word) => Editing::KeepsName { word: word.into() }.into(),
                None => Editing::NoName.into(),
            });
        };
        let definition = self.definition_of(named);
        if definition.span.is_none() {
            let word = definition.name.clone();
            return Err(Editing::KeepsName { word }.into());
        }
        if definition.name == LOOP && definition.kind == DefinitionKind::Label {
            return Err(Editing::LoopLabel.into());
        }
        Ok(named)
    }

    /// Returns an error if the language or the program does not allow a name.
    fn check_name(&self, definition: &Definition, name: &str) -> Result<(), Message> {
        let is_value =
            |kind| matches!(kind, DefinitionKind::Variable(_) | DefinitionKind::Constant);
        let is_variable = is_value(definition.kind);
        let word = || name.into();
        if is_variable && !names::is_variable(name) {
            return Err(Naming::NoVariableName { word: word() }.into());
        }
        if !names::is_label(name) {
            return Err(Naming::NoLabelName { word: word() }.into());
        }
        if name.len() > names::LIMIT {
            return Err(Parsing::NameTooLong {
                limit: names::LIMIT,
                length: name.len(),
            }
            .into());
        }
        if is_reserved(name, self.loaded.module.edition) {
            return Err(Naming::WordOfLanguage { word: word() }.into());
        }
        if !is_variable && name == LOOP {
            return Err(Editing::LoopLabel.into());
        }
        let others = self.loaded.symbols.definitions().iter();
        let mut others = others.filter(|it| *it != definition && is_value(it.kind) == is_variable);
        match others.find(|it| it.name == name).and_then(|it| it.span) {
            Some(place) => Err(Editing::Taken {
                name: name.into(),
                line: self.line_of(place.start),
            }
            .into()),
            None => Ok(()),
        }
    }

    /// Returns true if all names mean the same after edits, and no diagnostic is new.
    fn keeps_meaning(&self, edits: &[Edit], renamed: &Definition, name: &str) -> bool {
        let source = &self.loaded.source;
        let bytes = source.changed(edits.iter().map(|edit| (edit.span, edit.text.as_str())));
        let after = load(source.name(), &bytes, &self.options);
        !has_new_diagnostics(&self.loaded, &after)
            && same_symbols(&self.loaded.symbols, &after.symbols, renamed, name)
    }
}

/// Returns true if there are new diagnostics. Warnings about the reach of the robot are not computed again.
fn has_new_diagnostics(before: &Loaded, after: &Loaded) -> bool {
    let mut known: Vec<Code> = before.diagnostics.iter().map(|it| it.code).collect();
    let is_new = |one: &Diagnostic| match known.iter().position(|code| *code == one.code) {
        Some(at) => {
            known.swap_remove(at);
            false
        }
        None => true,
    };
    after.omitted.count() > before.omitted.count() || after.diagnostics.iter().any(is_new)
}

/// Returns true if two programs have the same symbols in the same order, except for one name.
fn same_symbols(before: &Symbols, after: &Symbols, renamed: &Definition, name: &str) -> bool {
    let definitions = before.definitions().iter().zip(after.definitions());
    let same_count = before.definitions().len() == after.definitions().len()
        && before.all_uses().len() == after.all_uses().len();
    let is_same = |(old, new): (&Definition, &Definition)| {
        let expected = if old == renamed {
            name
        } else {
            old.name.as_str()
        };
        old.kind == new.kind && new.name == expected
    };
    let mut uses = before.all_uses().iter().zip(after.all_uses());
    let does_same = |(old, new): (&Use, &Use)| {
        old.definition == new.definition && old.access == new.access && old.member == new.member
    };
    same_count && definitions.into_iter().all(is_same) && uses.all(does_same)
}
