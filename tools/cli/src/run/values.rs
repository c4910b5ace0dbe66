//! The values that a statement worked with when it stopped the run.

use tip_lint::load;
use tip_runtime::program::Program as _;
use tip_sim::Interpreter;
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::message::Message;
use tipc::source::{Encoding, Span};
use tipc::symbols::{Access, DefinitionKind, Use};
use tipc::{Loaded, Options};

/// What each operand of a statement held.
#[derive(Debug, Default)]
pub(super) struct Values(Vec<Operand>);

/// An operand that names a variable or a member.
#[derive(Debug)]
struct Operand {
    /// Its sign and its name.
    place: Span,
    negative: bool,
    /// It is read and not assigned, so that its value could stand in its place.
    is_read: bool,
    /// The scalars that it stands for.
    scalars: Vec<(String, f64)>,
}

impl Values {
    /// Those that a statement reads. A step that fails changes nothing, so that they are still there.
    pub(super) fn of(loaded: &Loaded, statement: Option<usize>, program: &Interpreter) -> Self {
        let uses = loaded.symbols.within(span(loaded, statement)).iter();
        Values(
            uses.filter_map(|one| operand(loaded, one, program))
                .collect(),
        )
    }

    /// Every scalar that was read, once, with its value.
    pub(super) fn scalars(&self) -> impl Iterator<Item = (&str, f64)> {
        let scalars = || self.0.iter().flat_map(|operand| &operand.scalars);
        let is_first = move |(at, (name, _)): &(usize, &(String, f64))| {
            !scalars().take(*at).any(|(other, _)| other == name)
        };
        let all = scalars().enumerate().filter(is_first);
        all.map(|(_, (name, value))| (name.as_str(), *value))
    }

    /// The first place of each operand, and what it held there.
    pub(super) fn at_places(&self) -> impl Iterator<Item = (Span, Vec<String>)> {
        self.0.iter().map(|operand| {
            let texts = operand
                .scalars
                .iter()
                .map(|(name, value)| format!("{name} = {value}"));
            (operand.place, texts.collect())
        })
    }

    /// What the checker says of the statement with these values as constants, if it refuses one: the reason and the help.
    pub(super) fn refused(
        &self,
        loaded: &Loaded,
        statement: Option<usize>,
        options: &Options,
    ) -> Option<(Message, Option<Message>)> {
        let place = span(loaded, statement);
        let text = loaded.source.text();
        let mut constant = text.get(..place.start)?.to_owned();
        let mut at = place.start;
        for operand in self.0.iter().filter(|operand| operand.is_read) {
            if let [(_, value)] = operand.scalars.as_slice() {
                let sign = if operand.negative { -1.0 } else { 1.0 };
                constant += text.get(at..operand.place.start)?;
                constant += &(sign * value).to_string();
                at = operand.place.end;
            }
        }
        constant += text.get(at..place.end)?;
        let judged = place.start..constant.len() + 1;
        constant += text.get(place.end..)?;
        let options = Options {
            encoding: Encoding::Utf8,
            ..*options
        };
        let found = load(loaded.source.name(), constant.as_bytes(), &options).diagnostics;
        let refused =
            |one: &Diagnostic| one.code == Code::OutOfRange && judged.contains(&one.span.start);
        let finding = found.into_iter().find(refused)?;
        Some((finding.reason, finding.help))
    }
}

fn span(loaded: &Loaded, statement: Option<usize>) -> Span {
    let statement = statement.and_then(|at| loaded.module.statements.get(at));
    statement
        .map(|statement| statement.span)
        .unwrap_or_default()
}

fn operand(loaded: &Loaded, one: &Use, program: &Interpreter) -> Option<Operand> {
    let definition = loaded.symbols.definition(one.definition);
    let is_value = matches!(definition.kind, DefinitionKind::Variable(_))
        && matches!(one.access, Access::Read | Access::Update | Access::Count);
    let place = is_value.then(|| one.operand(&loaded.source))?;
    let name = loaded
        .source
        .slice(place)
        .trim_matches(['-', '%'])
        .to_ascii_uppercase();
    let whole = format!("{name}.");
    let known = (0..).map_while(|at| program.scalar(at));
    let named = known.filter(|(scalar, _)| *scalar == name || scalar.starts_with(&whole));
    let scalars: Vec<_> = named
        .filter_map(|(name, value)| Some((name.to_owned(), value?)))
        .collect();
    (!scalars.is_empty()).then_some(Operand {
        place,
        negative: one.negative,
        is_read: one.access == Access::Read,
        scalars,
    })
}
