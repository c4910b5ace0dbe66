//! Other names, if the program stays the same.

use crate::Document;
use crate::message::Editing;
use tipc::Loaded;
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Edit};
use tipc::language::names;
use tipc::language::reserved::{LOOP, is_reserved};
use tipc::message::{Message, Naming, Parsing};
use tipc::source::Span;
use tipc::symbols::{Definition, DefinitionKind, Symbols, Use};

/// A name that can be changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Nameable {
    /// Where it stands.
    pub span: Span,
    /// As it is written there.
    pub name: String,
}

impl Document {
    /// The name at a byte of the text.
    ///
    /// # Errors
    ///
    /// There is none that can be changed.
    pub fn nameable(&self, offset: usize) -> Result<Nameable, Message> {
        let named = self.changeable(offset)?;
        Ok(Nameable {
            span: named.place,
            name: self.slice(named.place).to_owned(),
        })
    }

    /// Another name for what a byte of the text names: a change of every place that names it.
    ///
    /// # Errors
    ///
    /// There is nothing that can be renamed; this cannot be its name; or the program would become another one.
    pub fn rename(&self, offset: usize, name: &str) -> Result<Vec<Edit>, Message> {
        let named = *self.changeable(offset)?;
        let definition = self.definition_of(&named);
        let upper = name.to_ascii_uppercase();
        self.accepts(definition, &upper)?;
        let uses = self.loaded.symbols.uses(named.definition);
        let written = uses.filter(|it| it.place.start < it.place.end);
        let edits: Vec<Edit> = written.map(|it| Edit::replace(it.place, name)).collect();
        match self.stays_the_same(&edits, definition, &upper) {
            true => Ok(edits),
            false => Err(Editing::OtherMeaning { name: upper.into() }.into()),
        }
    }

    fn changeable(&self, offset: usize) -> Result<&Use, Message> {
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
        if definition.place.is_none() {
            let word = definition.name.clone();
            return Err(Editing::KeepsName { word }.into());
        }
        if definition.name == LOOP && definition.kind == DefinitionKind::Label {
            return Err(Editing::LoopLabel.into());
        }
        Ok(named)
    }

    /// Whether the language and the program leave a name to something.
    fn accepts(&self, definition: &Definition, name: &str) -> Result<(), Message> {
        let is_variable = matches!(definition.kind, DefinitionKind::Variable(_));
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
        let mut others = others.filter(|it| {
            *it != definition && matches!(it.kind, DefinitionKind::Variable(_)) == is_variable
        });
        match others.find(|it| it.name == name).and_then(|it| it.place) {
            Some(place) => Err(Editing::Taken {
                name: name.into(),
                line: self.line_of(place.start),
            }
            .into()),
            None => Ok(()),
        }
    }

    /// Whether all names mean the same after a change, and nothing new is found.
    fn stays_the_same(&self, edits: &[Edit], renamed: &Definition, name: &str) -> bool {
        let mut text = String::with_capacity(self.loaded.source.text().len());
        let mut at = 0;
        for edit in edits {
            text += self.slice(Span::new(at, edit.span.start));
            text += &edit.text;
            at = edit.span.end;
        }
        text += &self.loaded.source.text()[at..];
        let after = Document::new(self.loaded.source.name(), &text, &self.options);
        !finds_more(&self.loaded, &after.loaded)
            && same_symbols(&self.loaded.symbols, &after.loaded.symbols, renamed, name)
    }
}

/// Whether something is found that was not before. What only the robot's geometry tells is not looked for again.
fn finds_more(before: &Loaded, after: &Loaded) -> bool {
    let mut known: Vec<Code> = before.diagnostics.iter().map(|it| it.code).collect();
    let is_new = |finding: &Diagnostic| match known.iter().position(|it| *it == finding.code) {
        Some(at) => {
            known.swap_remove(at);
            false
        }
        None => true,
    };
    after.omitted.count() > before.omitted.count() || after.diagnostics.iter().any(is_new)
}

/// Whether two programs name the same things in the same order, but for the name of one.
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
