//! Variables that are read without a value (T.I.P. 3.1 §5-1).

use super::LintContext;
use crate::message::{Lack, Linting, Stretch};
use tipc::analysis::assignment::{Assigned, Assignment, Gap, Ways, gaps};
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::message::list::{Pieces, Quoted};
use tipc::message::phrase::Assign;
use tipc::program::{Program, StepId, VariableKind};
use tipc::source::Span;

/// Warns of every variable that is, or may be, read without a value.
pub(super) fn warn(context: &LintContext<'_>, found: &mut Diagnostics) {
    let program = context.program;
    let assignment = match program.edition().is_strict() {
        true => Ways::of(program).assignment,
        false => Assignment::along(program, context.flow),
    };
    let gaps = gaps(program, &assignment);
    let warnings = gaps
        .iter()
        .map(|gap| warning(program, gap, context.operand(gap)));
    found.extend(warnings);
}

impl LintContext<'_> {
    /// Returns the operand that lacks its value, else the whole statement: NEXT need not name its variable.
    fn operand(&self, gap: &Gap) -> Span {
        let Some(statement) = self.statement(gap.step) else {
            return Span::default();
        };
        let scalar = scalar_name(self.program, gap.scalars[0]);
        let symbols = self.symbols;
        symbols.read_in(self.source, statement.span, gap.variable, &scalar)
    }
}

fn scalar_name(program: &Program, scalar: usize) -> String {
    let variable = &program.variables()[program.variable_of(scalar)];
    let mut names = variable.scalar_names();
    names.nth(scalar - variable.first).unwrap_or_default()
}

fn warning(program: &Program, gap: &Gap, location: Span) -> Diagnostic {
    let variable = &program.variables()[gap.variable];
    let names: Vec<String> = gap
        .scalars
        .iter()
        .map(|scalar| scalar_name(program, *scalar))
        .collect();
    let is_whole = gap.scalars.len() == variable.size();
    let subject = if is_whole { &variable.name } else { &names[0] };
    let (code, lack) = match gap.assigned {
        Assigned::Never => (Code::Unassigned, Lack::Value),
        _ => (Code::PerhapsUnassigned, Lack::ValueOnSomePaths),
    };
    let reason = match names.as_slice() {
        [_] => Linting::Has {
            name: names[0].clone(),
            lack,
        },
        _ if is_whole => Linting::Has {
            name: subject.clone(),
            lack,
        },
        names => Linting::Have {
            names: Quoted(names.to_vec()),
            lack,
        },
    };
    let assign = match variable.kind {
        VariableKind::Var => Assign::Var {
            name: variable.name.clone(),
        },
        VariableKind::Pos | VariableKind::Joint => Assign::EveryMember {
            member: names[0].clone(),
        },
    };
    let help = match path(program, &gap.way) {
        Some(path) => Linting::NoValueOnPath { path, assign },
        None => Linting::Assign { assign },
    };
    Diagnostic::new(code, location, reason)
        .about(subject)
        .help(help)
}

/// Returns the lines of a path: runs of steps without a jump, the last one up to the step that reads.
fn path(program: &Program, steps: &[StepId]) -> Option<Stretch> {
    let line = |step: StepId| program.steps()[step as usize].line;
    let pieces: Vec<(u32, u32)> = steps
        .chunk_by(|a, b| a + 1 == *b)
        .filter_map(|piece| Some((line(*piece.first()?), line(*piece.last()?))))
        .collect();
    match pieces.as_slice() {
        [] => None,
        [(first, last)] if first == last => Some(Stretch::Line { line: *first }),
        _ => Some(Stretch::Lines {
            lines: Pieces(pieces),
        }),
    }
}
