//! Loading: from the bytes of a file to a [`Program`] or to its errors. Nothing else makes a [`Program`].
//!
//! Lints belong in the crate `tip-lint`.

use crate::analysis::assignment::Paths;
use crate::check::{Checked, DeclaredLabel, ResolvedModule, check};
use crate::code::{Code, Level};
pub use crate::diagnostic::MAX_DIAGNOSTICS;
use crate::diagnostic::{Diagnostic, Diagnostics, Omitted, by_location};
use crate::language::Edition;
use crate::message::phrase::Assign;
use crate::message::{Message, Naming, Parsing, Structuring, Suggestion};
use crate::parse::parse;
use crate::program::{Action, Label, LabelKind, Program, Step, StepId, Thread};
use crate::robot::Robot;
use crate::source::{Encoding, Source, looks_like};
use crate::symbols::Symbols;
use crate::syntax::{Module, StatementKind, VariableKind};

/// Options for reading and checking a program.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// The robot.
    pub robot: Robot,
    /// The version that line 1 must name; `None` for any edition.
    pub tip_version: Option<f64>,
    /// The encoding of the file.
    pub encoding: Encoding,
}

/// Result of loading a file.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Loaded {
    /// The decoded text.
    pub source: Source,
    /// The statements, as far as the text could be read.
    pub module: Module,
    /// The names of the program and their locations, as far as they could be resolved.
    pub symbols: Symbols,
    /// The program, unless there is an error among the diagnostics.
    pub program: Option<Program>,
    /// The robot that the program was checked for; `None` if the file was not read as a program.
    pub robot: Option<Robot>,
    /// The diagnostics, in order of their locations: at most [`MAX_DIAGNOSTICS`], the first errors before any warning.
    pub diagnostics: Vec<Diagnostic>,
    /// The numbers of further diagnostics.
    pub omitted: Omitted,
}

impl Loaded {
    /// Creates the result for a file that was not read as a program.
    pub fn refused(source: Source, diagnostics: Vec<Diagnostic>) -> Self {
        Loaded {
            source,
            module: Module::default(),
            symbols: Symbols::default(),
            program: None,
            robot: None,
            diagnostics,
            omitted: Omitted::default(),
        }
    }

    /// Returns the errors among the diagnostics.
    pub fn errors(&self) -> impl Iterator<Item = &Diagnostic> {
        let diagnostics = self.diagnostics.iter();
        diagnostics.filter(|one| one.level() == Level::Error)
    }

    /// Adds diagnostics, and keeps all in the order of their locations.
    pub fn report(&mut self, found: Diagnostics) {
        let mut all = Diagnostics::from(std::mem::take(&mut self.diagnostics));
        all.append(found);
        let (diagnostics, omitted) = in_order(all, self.module.edition);
        self.diagnostics = diagnostics;
        self.omitted.append(omitted);
    }
}

/// Reads, checks and lowers a program. `name` is the file's name in diagnostics.
pub fn load(name: &str, bytes: &[u8], options: &Options) -> Loaded {
    let (mut loaded, found) = lowered(name, bytes, options);
    loaded.report(found);
    loaded
}

/// Reads, checks and lowers a program without analysing it. The diagnostics are separate, and in no particular order.
pub fn lowered(name: &str, bytes: &[u8], options: &Options) -> (Loaded, Diagnostics) {
    let Parsed {
        source,
        module,
        is_program,
        mut diagnostics,
    } = parsed(name, bytes, options);
    let (symbols, program) = if is_program {
        let mut checked = check(&source, &module, options.robot, diagnostics);
        let resolved = sound(&mut checked, module.edition);
        let program = resolved.map(|resolved| lower(&source, &module, resolved, options.robot));
        diagnostics = checked.found;
        let symbols = checked.symbols;
        if module.edition.is_strict()
            && let Some(program) = &program
        {
            refuse_paths(&source, &module, &symbols, program, &mut diagnostics);
        }
        (
            symbols,
            program.filter(|_| !diagnostics.have_error(module.edition)),
        )
    } else {
        (Symbols::default(), None)
    };
    let loaded = Loaded {
        source,
        module,
        symbols,
        program,
        robot: Some(options.robot),
        diagnostics: Vec::new(),
        omitted: Omitted::default(),
    };
    (loaded, diagnostics)
}

/// A file that was parsed, before anything is looked up or judged.
#[derive(Debug)]
#[non_exhaustive]
pub struct Parsed {
    /// The decoded text.
    pub source: Source,
    /// The statements, as far as the text could be read.
    pub module: Module,
    /// True if the file is text and line 1 names an accepted version.
    pub is_program: bool,
    /// The diagnostics of the parser.
    pub diagnostics: Diagnostics,
}

impl Parsed {
    /// Returns the number of errors of the program on a robot.
    pub fn errors(&self, options: &Options) -> usize {
        let mut found = self.diagnostics.clone();
        if self.is_program {
            found = check(&self.source, &self.module, options.robot, found).found;
        }
        found.errors(self.module.edition)
    }
}

/// Reports reads that find no value on any path, and SUBROUTINEs and THREADs that a path runs into.
fn refuse_paths(
    source: &Source,
    module: &Module,
    symbols: &Symbols,
    program: &Program,
    found: &mut Diagnostics,
) {
    let paths = Paths::of(program);
    let statement = |step| Some(&module.statements[module.statement_of(step)?]);
    for lack in &paths.no_value {
        let variable = &program.variables()[program.variable_of(lack.scalar)];
        let Some(statement) = statement(lack.step) else {
            continue;
        };
        let mut names = variable.scalar_names();
        let name = names.nth(lack.scalar - variable.first).unwrap_or_default();
        let id = program.variable_of(lack.scalar);
        let location = symbols.read_in(source, statement.span, id, &name);
        let assign = match variable.kind {
            VariableKind::Var => Assign::Var { name: name.clone() },
            VariableKind::Pos | VariableKind::Joint => Assign::EveryMember {
                member: name.clone(),
            },
        };
        let reason = Naming::NoValueOnAnyWay { name: name.into() };
        let fault = Diagnostic::new(Code::NeverAssigned, location, reason);
        found.push(fault.help(Naming::AssignBefore { assign }));
    }
    for step in paths.entered {
        if let Some(statement) = statement(step) {
            let reason = match statement.kind {
                StatementKind::Thread { .. } => Structuring::RunsIntoThread,
                _ => Structuring::RunsIntoSubroutine,
            };
            let fault = Diagnostic::new(Code::Structure, statement.keyword(), reason);
            found.push(fault.help(Structuring::PutJumpAbove));
        }
    }
}

/// Decodes and parses a file.
pub fn parsed(name: &str, bytes: &[u8], options: &Options) -> Parsed {
    let (source, undecodable) = Source::decode(name, bytes, options.encoding);
    let is_text = undecodable.is_none();
    let (module, mut diagnostics) = match undecodable {
        None => parse(&source, options.tip_version),
        Some(fault) => (Module::default(), vec![fault.into()].into()),
    };
    name_encoding(&mut diagnostics, bytes);
    judge(diagnostics.iter_mut(), module.edition);
    let wrong_version = diagnostics.iter().any(|one| one.code == Code::Version);
    Parsed {
        source,
        module,
        is_program: is_text && !wrong_version,
        diagnostics,
    }
}

/// Checks a module for a robot and returns the diagnostics, in no order.
pub fn check_module(source: &Source, module: &Module, robot: Robot) -> Vec<Diagnostic> {
    check(source, module, robot, Diagnostics::default())
        .found
        .into_parts()
        .0
}

/// Makes the program of a module without errors. Nothing else makes one.
fn lower(source: &Source, module: &Module, resolved: ResolvedModule<'_>, robot: Robot) -> Program {
    let ResolvedModule {
        variables,
        constants,
        labels,
        actions,
    } = resolved;
    let mut steps = Vec::with_capacity(actions.len());
    for (statement, action) in module.statements.iter().zip(actions) {
        steps.extend(action.map(|action| Step {
            action,
            line: statement.line,
            column: source.column(statement.span.start),
            text: source.slice(statement.span).into(),
        }));
    }
    let step_of = |label: &DeclaredLabel<'_>| module.statements[label.statement].step;
    let threads = labels.iter().filter(|it| it.kind == LabelKind::Thread);
    let threads = threads.filter_map(|label| {
        let first = step_of(label);
        let ends = |step: &Step| step.action == Action::ThreadEnd;
        let length = steps[first as usize..].iter().position(ends)?;
        Some(Thread {
            name: label.name.node.to_string(),
            first,
            last: first + length as StepId,
        })
    });
    let threads = threads.collect();
    let labels = labels.iter().map(|label| Label {
        name: label.name.node.to_string(),
        step: step_of(label),
        kind: label.kind,
    });
    let constants = constants.into_iter();
    let constants = constants.filter_map(|constant| Some((constant.name, constant.value?)));
    let path = source.name();
    Program {
        source_name: path.rsplit(['/', '\\']).next().unwrap_or(path).to_owned(),
        source_hash: source.hash(),
        edition: module.edition,
        title: module.title.clone(),
        signature: robot.signature(),
        variables,
        constants: constants.collect(),
        labels: labels.collect(),
        threads,
        steps,
    }
}

/// Takes the resolved module, unless it has an error.
fn sound<'m>(checked: &mut Checked<'m>, edition: Edition) -> Option<ResolvedModule<'m>> {
    judge(checked.found.iter_mut(), edition);
    // A constant without a result does not change the flow, so the paths can still be judged.
    let of_domain = checked.found.iter().filter(|one| one.code == Code::Domain);
    match checked.found.errors(edition) > of_domain.count() {
        true => None,
        false => checked.resolved.take(),
    }
}

/// Sorts diagnostics by their locations, with the severities of an edition. If there are too many, the last ones are
/// omitted, warnings before errors.
fn in_order(found: Diagnostics, edition: Edition) -> (Vec<Diagnostic>, Omitted) {
    let (mut diagnostics, mut omitted) = found.into_parts();
    judge(&mut diagnostics, edition);
    by_location(&mut diagnostics);
    // One mistake is reported once, however many passes find it.
    diagnostics.dedup_by(|later, first| {
        let is_mistake = |one: &Diagnostic| one.level() == Level::Error && one.code != Code::NoEnd;
        later.span == first.span && is_mistake(later) && is_mistake(first)
    });
    if diagnostics.len() > MAX_DIAGNOSTICS {
        diagnostics.sort_by_key(|one| one.level() != Level::Error);
        diagnostics
            .drain(MAX_DIAGNOSTICS..)
            .for_each(|one| omitted.add(one.code));
        by_location(&mut diagnostics);
    }
    (diagnostics, omitted)
}

/// Replaces the help about bytes that cannot be read, if the file seems to be in an encoding that the language lacks.
fn name_encoding(diagnostics: &mut Diagnostics, bytes: &[u8]) {
    let mut unreadable = diagnostics.iter_mut().filter(|one| {
        matches!(
            one.reason,
            Message::Reading(_)
                | Message::Parsing(Parsing::ForeignCharacters | Parsing::ControlCharacter)
        )
    });
    if let Some(first) = unreadable.next()
        && let Some(encoding) = looks_like(bytes)
    {
        first.help = Some(Suggestion::OtherEncoding { encoding }.into());
    }
}

/// Sets the edition of diagnostics, and the codes that it has for them.
pub fn judge<'d>(diagnostics: impl IntoIterator<Item = &'d mut Diagnostic>, edition: Edition) {
    for diagnostic in diagnostics {
        diagnostic.edition = edition;
        diagnostic.code = diagnostic.code.in_edition(edition);
    }
}
