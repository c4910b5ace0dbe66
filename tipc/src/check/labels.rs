//! Labels and subroutine names (T.I.P. 3.1 §4-3), and line 2, where the title was forgotten and another statement stands.

use crate::code::Code;
use crate::diagnostic::{Diagnostic, Diagnostics, MistakeId};
use crate::language::keywords::{self, Keyword};
use crate::language::reserved::{LOOP, is_reserved};
use crate::language::{Edition, commands, names};
use crate::lex::{Kind, Token, lex};
use crate::message::{Message, Naming, Suggestion};
use crate::source::{Source, Span};
use crate::syntax::{Jump, LabelKind, Module, OperandKind, StatementKind, Word, upper_case};
use smol_str::SmolStr;
use std::collections::{HashMap, HashSet};

/// Maximum number of threads of a program.
const MAX_THREADS: usize = 7;

/// Every label.
#[derive(Clone, Debug, Default)]
pub(crate) struct Labels<'m> {
    /// The labels in order of the text: the first one of each name, and every LOOP.
    pub(crate) all: Vec<DeclaredLabel<'m>>,
    by_name: HashMap<&'m str, usize>,
    loops: Vec<usize>,
    /// Number of THREADs so far.
    threads: usize,
    /// Unknown words that are alone in their statement, with its index: they may be labels without their colon.
    bare: HashMap<&'m str, usize>,
    /// Names that are declared again. That is reported, and nothing else about them is.
    again: HashSet<&'m str>,
    /// The edition of the program, whose words are no label names.
    edition: Edition,
}

/// A label, SUBROUTINE or THREAD.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DeclaredLabel<'m> {
    /// Its name.
    pub(crate) name: &'m Word,
    /// The index of its statement.
    pub(crate) statement: usize,
    /// Kind of its declaration.
    pub(crate) kind: LabelKind,
}

impl<'m> Labels<'m> {
    /// Reads every label, SUBROUTINE and THREAD.
    pub(crate) fn collect(module: &'m Module, found: &mut Diagnostics) -> Self {
        let mut labels = Labels {
            edition: module.edition,
            ..Labels::default()
        };
        for (index, statement) in module.statements.iter().enumerate() {
            if let Some((name, kind)) = statement.kind.label() {
                labels.declare(index, name, kind, found);
            } else if let Some(name) = bare(&statement.kind, module.edition) {
                labels.bare.entry(name).or_insert(index);
            }
        }
        labels
    }

    fn declare(
        &mut self,
        statement: usize,
        name: &'m Word,
        kind: LabelKind,
        found: &mut Diagnostics,
    ) {
        let label = DeclaredLabel {
            name,
            statement,
            kind,
        };
        let id = self.all.len();
        self.threads += usize::from(kind == LabelKind::Thread);
        if kind == LabelKind::Thread && self.threads > MAX_THREADS {
            let reason = Naming::TooManyThreads { most: MAX_THREADS };
            found.push(Diagnostic::new(Code::Argument, name.span, reason).once(MistakeId::Threads));
        }
        if let Some(fault) = refusal(name, kind, self.edition) {
            found.push(fault);
        }
        if name.node == LOOP && kind == LabelKind::Plain {
            self.loops.push(id);
            self.all.push(label);
            return;
        }
        if let Some(first) = self.by_name.get(name.node.as_str()) {
            let reason = Naming::DeclaredAgain {
                name: name.node.clone(),
            };
            let first_kind = self.all[*first].kind;
            let is_call = kind == LabelKind::Subroutine && first_kind == LabelKind::Plain;
            let help: Message = match is_call {
                true => Suggestion::Call {
                    name: name.node.clone(),
                }
                .into(),
                false => Naming::OwnName.into(),
            };
            let fault = Diagnostic::new(Code::DuplicateLabel, name.span, reason)
                .help(help)
                .label(self.all[*first].name.span, Naming::FirstDeclared);
            found.push(fault);
            self.again.insert(&name.node);
            return;
        }
        self.by_name.insert(&name.node, id);
        self.all.push(label);
    }

    /// Returns the index of a label other than LOOP.
    pub(crate) fn find(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).copied()
    }

    /// Returns the first statement that may be a label of that name without its colon.
    pub(crate) fn bare(&self, name: &str) -> Option<usize> {
        self.bare.get(name).copied()
    }

    /// Returns true if a name is declared again, which is reported.
    pub(crate) fn is_again(&self, name: &str) -> bool {
        self.again.contains(name)
    }

    /// Returns the index of the nearest LOOP above a statement.
    pub(crate) fn loop_above(&self, statement: usize) -> Option<usize> {
        let is_above = |label: &usize| self.all[*label].statement < statement;
        let above = self.loops.partition_point(is_above);
        above.checked_sub(1).map(|last| self.loops[last])
    }

    /// Returns the index of the label that a jump in a statement names.
    pub(crate) fn target_of(&self, statement: usize, jump: &Jump) -> Option<usize> {
        match &jump.label {
            Some(label) if label.node != LOOP => self.find(&label.node),
            _ => self.loop_above(statement),
        }
    }

    /// Returns the names that a jump may have meant.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.all.iter().map(|label| label.name.node.as_str())
    }
}

/// Returns the word of a statement that is no command, alone or before a command: `START`, `START SLEEP 100`.
fn bare(kind: &StatementKind, edition: Edition) -> Option<&str> {
    let StatementKind::Command {
        name, arguments, ..
    } = kind
    else {
        return None;
    };
    let next = arguments.first().map(|argument| &argument.kind);
    let is_alone = match next {
        None => true,
        Some(OperandKind::Name(word)) => commands::find_in(word, edition).is_some(),
        Some(_) => false,
    };
    // `L1.`
    let word = name.node.trim_end_matches(['.', '-']);
    (is_alone && commands::find_in(&name.node, edition).is_none()).then_some(word)
}

fn refusal(name: &Word, kind: LabelKind, edition: Edition) -> Option<Diagnostic> {
    let word = name.node.as_str();
    let fault = |reason: Naming| Diagnostic::new(Code::Argument, name.span, reason);
    if !names::is_label(word) {
        let help = Naming::LabelCharacters;
        return Some(
            fault(Naming::NoLabelName {
                word: name.node.clone(),
            })
            .once(MistakeId::Word(name.node.clone()))
            .help(help),
        );
    }
    if is_reserved(word, edition) {
        let help = Naming::ChooseAnother;
        return Some(
            fault(Naming::WordOfLanguage {
                word: name.node.clone(),
            })
            .help(help),
        );
    }
    let reason = match kind {
        LabelKind::Plain => return None,
        LabelKind::Subroutine => Naming::SubroutineLoop,
        LabelKind::Thread => Naming::ThreadLoop,
    };
    (word == LOOP).then(|| {
        let fault = fault(reason).once(MistakeId::RoutineLoop);
        fault.help(Naming::ChooseAnother)
    })
}

/// The title read as a statement, for programs that lack a title.
#[derive(Debug, Default)]
pub(super) struct Title {
    /// Its first word.
    first: Option<Span>,
    keyword: Option<Keyword>,
    label: Option<SmolStr>,
    names: Vec<(SmolStr, Span)>,
}

impl Title {
    /// Reads the title as a statement. One that holds what no statement may hold is none.
    pub(super) fn of(source: &Source, module: &Module) -> Self {
        let mut tokens = Vec::new();
        if module.title.is_empty() || lex(source.text(), source.line(2).span, &mut tokens).is_some()
        {
            return Title::default();
        }
        let word = |token: &Token| upper_case(source.slice(token.span));
        let keyword = tokens.first().map(word);
        let keyword = keyword.and_then(|word| keywords::find(&word, module.edition));
        let declares = matches!(
            keyword,
            Some(Keyword::DefVar | Keyword::DefPos | Keyword::DefJoint)
        );
        let names = tokens.iter().skip(1).filter(|it| it.kind == Kind::Word);
        Title {
            first: tokens.first().map(|first| first.span),
            keyword,
            label: match tokens.as_slice() {
                [name, colon, ..] if colon.kind == Kind::Colon => Some(word(name)),
                _ => None,
            },
            names: match declares {
                true => names.map(|name| (word(name), name.span)).collect(),
                false => Vec::new(),
            },
        }
    }

    /// Explains an undeclared name by the missing title, if line 2 declares the name.
    pub(super) fn declares(&self, name: &str, fault: Diagnostic) -> Diagnostic {
        let declared = self.names.iter().find(|(one, _)| one == name);
        blame(fault, declared.map(|(_, location)| *location))
    }

    /// Explains a missing label by the missing title, if line 2 has that label.
    pub(super) fn labels(&self, name: &str, fault: Diagnostic) -> Diagnostic {
        blame(
            fault,
            self.first.filter(|_| self.label.as_deref() == Some(name)),
        )
    }

    /// Explains a block without opener by the missing title, if line 2 opens the block.
    pub(super) fn opens(&self, opener: Keyword, fault: Diagnostic) -> Diagnostic {
        blame(fault, self.first.filter(|_| self.keyword == Some(opener)))
    }
}

/// Marks a diagnostic as a consequence of a forgotten title. All of them are one mistake.
fn blame(fault: Diagnostic, location: Option<Span>) -> Diagnostic {
    match location {
        Some(location) => fault
            .once(MistakeId::Title)
            .label(location, Suggestion::TitleHere)
            .help(Suggestion::Title),
        None => fault,
    }
}
