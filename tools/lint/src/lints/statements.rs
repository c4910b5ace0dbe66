//! Lints about single statements: reads of variables without a value (T.I.P. 3.1 §5-1), commands, equations, threads
//! and timers.

use super::LintContext;
use crate::cycles::sampling_set;
use crate::message::{Lack, Linting, Stretch};
use smol_str::SmolStr;
use std::collections::BTreeSet;
use tip_runtime::command::{ABSOLUTE, Op, READING, RELATIVE, Reading, TIMERS, Target};
use tipc::analysis::assignment::{Assigned, Assignment, Gap, Paths, gaps};
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::language::commands::{self, Form};
use tipc::language::reserved::reading;
use tipc::message::list::{Pieces, Quoted};
use tipc::message::phrase::Assign;
use tipc::program::{Action, MessagePart, Operand, Program, StepId, VariableKind};
use tipc::source::Span;
use tipc::syntax::{self, Equation, Expression, OperandKind, StatementKind, upper_case};

/// Warns of every variable that is, or may be, read without a value.
pub(super) fn unassigned(context: &LintContext<'_>, found: &mut Diagnostics) {
    let program = context.program;
    let assignment = match program.edition().is_strict() {
        true => Paths::of(program).assignment,
        false => Assignment::along(program, context.flow),
    };
    let gaps = gaps(program, &assignment);
    let warnings = gaps
        .iter()
        .map(|gap| unassigned_warning(program, gap, context.operand(gap)));
    found.extend(warnings);
}

impl LintContext<'_> {
    /// Returns the operand that lacks its value, or the whole statement if that does not name it, as NEXT may.
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

fn unassigned_warning(program: &Program, gap: &Gap, location: Span) -> Diagnostic {
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
    let help = match path(program, &gap.path) {
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

/// Warns of a SLEEP shorter than a cycle, and of `R` before only one of three numbers.
pub(super) fn commands(context: &LintContext<'_>, found: &mut Diagnostics) {
    // Otherwise the robot's standard sampling time may not apply.
    let keeps_period = sampling_set(context.program).is_none();
    for (statement, step) in context.module.steps().zip(context.program.steps()) {
        let StatementKind::Command {
            name, arguments, ..
        } = &statement.kind
        else {
            continue;
        };
        let diagnostic = match &step.action {
            Action::Command { op: Op::Sleep, .. } if keeps_period => {
                short_sleep(context, arguments)
            }
            Action::Command { .. } => relative_first(&name.node, arguments),
            _ => None,
        };
        found.extend(diagnostic);
    }
}

/// Returns the warning about a SLEEP that was probably meant in seconds. `SLEEP 0` is left out: it means one cycle.
fn short_sleep(context: &LintContext<'_>, arguments: &[syntax::Operand]) -> Option<Diagnostic> {
    let operand = arguments.first()?;
    let OperandKind::Number(time) = operand.kind else {
        return None;
    };
    let period = context.robot.facts().period;
    (0.0 < time && time < period).then(|| {
        let reason = Linting::OneCycle { period };
        Diagnostic::new(Code::ShortSleep, operand.span, reason).help(Linting::Milliseconds)
    })
}

/// Returns the warning about `R` before the first number only. Stays silent about `R 0`, which keeps one coordinate,
/// unless 0 follows as well; and if `A` precedes another number, which shows that the author knows the rule.
fn relative_first(name: &str, arguments: &[syntax::Operand]) -> Option<Diagnostic> {
    let takes_marks = commands::find(name).is_some_and(|command| match command.form {
        Form::Robot(form) => form.relative && !form.from_target,
        _ => false,
    });
    let is = |operand: &&syntax::Operand, flag: &str| matches!(&operand.kind, OperandKind::Name(name) if name == flag);
    let first = arguments
        .iter()
        .position(|operand| is(&operand, RELATIVE))?;
    let (mark, numbers) = arguments[first..].split_first()?;
    let marked = |operand: &syntax::Operand| is(&operand, RELATIVE) || is(&operand, ABSOLUTE);
    let is_zero = |operand: &syntax::Operand| matches!(operand.kind, OperandKind::Number(0.0));
    let stays = is_zero(numbers.first()?) && !numbers.get(1).is_some_and(is_zero);
    let is_target = |operand: &syntax::Operand| matches!(&operand.kind, OperandKind::Name(name) if name.parse::<Target>().is_ok());
    let leads = arguments[..first].last().is_some_and(is_target);
    if !takes_marks || !leads || stays || numbers.len() < 2 || numbers.iter().any(marked) {
        return None;
    }
    let location = mark.span.to(numbers[0].span);
    let diagnostic = Diagnostic::new(Code::RelativeFirst, location, Linting::OthersAbsolute);
    Some(diagnostic.help(Linting::MarkEach))
}

/// Warns of `N =+ 1`, with a blank before `=` and none after it. `N = +1` and `N=+1` are left out: they are meant as
/// written.
pub(super) fn swapped_signs(context: &LintContext<'_>, found: &mut Diagnostics) {
    for statement in context.module.steps() {
        if let StatementKind::Equation(equation) = &statement.kind
            && let Some(sign) = swapped(context.source.text(), equation)
        {
            let name = context.source.slice(equation.target.span);
            let number = context
                .source
                .slice(Span::new(sign + 1, statement.span.end));
            let reason = Linting::AssignsSigned {
                number: number.into(),
            };
            let help = Linting::MeantUpdate {
                name: name.into(),
                number: number.into(),
            };
            let location = Span::new(equation.operator.start, sign + 1);
            found.push(Diagnostic::new(Code::SwappedSigns, location, reason).help(help));
        }
    }
}

/// Returns the location of the plus.
fn swapped(text: &str, equation: &Equation) -> Option<usize> {
    let Expression::Operand(value) = &equation.value else {
        return None;
    };
    let operator = equation.operator;
    let is_number = matches!(value.kind, OperandKind::Number(_));
    let follows = value.span.start == operator.end && text[operator.end..].starts_with('+');
    let is_apart = equation.target.span.end < operator.start;
    (equation.update.is_none() && is_number && follows && is_apart).then_some(operator.end)
}

/// Warns of threads that nothing starts or that wait for themselves, of timers that nothing starts, and of F_MESSAGEs
/// that never end a line.
pub(super) fn threads(context: &LintContext<'_>, found: &mut Diagnostics) {
    never_started(context, found);
    wait_for_themselves(context, found);
    found.extend(no_line_end(context));
    stopped_timers(context, found);
}

fn never_started(context: &LintContext<'_>, found: &mut Diagnostics) {
    let steps = context.program.steps().iter();
    let started: BTreeSet<usize> = steps
        .filter_map(|step| match step.action {
            Action::StartThread { thread } => Some(thread),
            _ => None,
        })
        .collect();
    for (index, thread) in context.program.threads().iter().enumerate() {
        if !started.contains(&index)
            && let Some(statement) = context.statement(thread.first)
        {
            let name = SmolStr::from(thread.name.as_str());
            let help = Linting::StartThread { name };
            let warning = Diagnostic::new(
                Code::NeverStarted,
                statement.keyword(),
                Linting::NothingStarts,
            );
            found.push(warning.about(thread.name.as_str()).help(help));
        }
    }
}

fn wait_for_themselves(context: &LintContext<'_>, found: &mut Diagnostics) {
    let threads = context.program.threads();
    for (step, content) in (0 as StepId..).zip(context.program.steps()) {
        let Action::WaitThread { thread } = content.action else {
            continue;
        };
        let waits = &threads[thread];
        if (waits.first..=waits.last).contains(&step)
            && let Some(statement) = context.statement(step)
        {
            let warning =
                Diagnostic::new(Code::WaitsForItself, statement.span, Linting::WaitsInItself);
            found.push(warning.help(Linting::WaitElsewhere));
        }
    }
}

/// Returns the warning about the first F_MESSAGE of a program in which none ends a line.
fn no_line_end(context: &LintContext<'_>) -> Option<Diagnostic> {
    let mut first = None;
    for (step, content) in (0..).zip(context.program.steps()) {
        let Action::FileMessage { parts } = &content.action else {
            continue;
        };
        let ends_line = |part: &MessagePart| match part {
            MessagePart::Text(text) => text.contains('\n'),
            MessagePart::Value { .. } => false,
        };
        if parts.iter().any(ends_line) {
            return None;
        }
        first.get_or_insert(step);
    }
    let statement = context.statement(first?)?;
    let warning = Diagnostic::new(Code::NoLineEnd, statement.span, Linting::OneLine);
    Some(warning.help(Linting::EndLine))
}

/// Warns of the first read of each timer that the program never starts. Stays silent if a variable chooses the timer
/// that is started.
fn stopped_timers(context: &LintContext<'_>, found: &mut Diagnostics) {
    let mut started = BTreeSet::new();
    for step in context.program.steps() {
        if let Action::Command {
            op: Op::StartTimer | Op::RestartTimer,
            arguments,
            ..
        } = &step.action
        {
            match arguments.first().map(|argument| argument.operand) {
                Some(Operand::Constant(number)) => started.insert(number.trunc() as u8),
                _ => return,
            };
        }
    }
    let mut read: Vec<(u8, Span)> = Vec::new();
    for statement in context.module.steps() {
        statement.kind.each_operand(&mut |operand| {
            if let OperandKind::Name(name) = &operand.kind {
                read.extend(timer(context, name).map(|timer| (timer, operand.span)));
            }
        });
        if let StatementKind::Message { text } | StatementKind::FileMessage { text } =
            &statement.kind
        {
            let shown = context.source.slice(text.span).split('%').skip(1);
            let names = shown.filter(|name| name.starts_with(READING));
            let names = names.filter_map(|name| name.split('.').next());
            let timers = names.filter_map(|name| timer(context, &upper_case(name)));
            read.extend(timers.map(|timer| (timer, text.span)));
        }
    }
    for timer in 0..TIMERS {
        let first = read.iter().find(|(number, _)| *number == timer);
        if let Some((_, span)) = first.filter(|_| !started.contains(&timer)) {
            let warning = Diagnostic::new(Code::StoppedTimer, *span, Linting::TimerStands);
            let warning = warning.about(Reading::Timer(timer).to_string());
            found.push(warning.help(Linting::StartTimer {
                timer: timer.into(),
            }));
        }
    }
}

/// Returns the timer that a word is the special variable of.
fn timer(context: &LintContext<'_>, word: &str) -> Option<u8> {
    match reading(word, context.module.edition)? {
        Reading::Timer(timer) => Some(timer),
        Reading::Measured(..) => None,
    }
}
