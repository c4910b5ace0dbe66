//! Threads that nothing starts or that wait for themselves, timers that nothing starts, and a log file without lines: what
//! edition 3.2 brought.

use super::LintContext;
use crate::message::Linting;
use smol_str::SmolStr;
use std::collections::BTreeSet;
use tip_runtime::command::{Op, READING, Reading, TIMERS};
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::language::reserved::reading;
use tipc::program::{Action, MessagePart, Operand, StepId};
use tipc::source::Span;
use tipc::syntax::{OperandKind, StatementKind, upper_case};

pub(super) fn warn(context: &LintContext<'_>, found: &mut Diagnostics) {
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

/// Warns of the first read of each timer that the program reads and never starts. Silent where a variable says which
/// timer is started.
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
