//! Lints about conditions, loops, jumps and calls (T.I.P. 3.1 §7-6).

use super::LintContext;
use crate::coverage_points::reached;
use crate::message::Linting;
use std::collections::{BTreeSet, HashMap, HashSet};
use tipc::analysis::access::{assigns, reads};
use tipc::analysis::flow::{Call, Entry, Flow, NodeId, always, enters};
use tipc::code::Code;
use tipc::diagnostic::{Diagnostic, Diagnostics};
use tipc::language::Keyword;
use tipc::parse::glued;
use tipc::program::{Action, Condition, End, Operand, Program, StepId};
use tipc::source::Span;
use tipc::symbols::{Access, Definition, DefinitionKind, Symbols};
use tipc::syntax::{Statement, StatementKind};

/// A step whose outcome is always the same.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constant {
    pub(super) step: StepId,
    /// The outcome.
    outcome: Outcome,
}

#[derive(Clone, Copy, Debug)]
enum Outcome {
    /// The result of a condition.
    Is(bool),
    /// The FOR never runs its body.
    Never,
    /// The increment is 0, which stops the program. Another warning reports that.
    Stops,
}

/// Returns the steps whose outcome is always the same, in order, except for intended endless loops: `WHILE 1 == 1` and
/// `UNTIL 1 == 0`.
pub(super) fn constant(context: &LintContext<'_>) -> Vec<Constant> {
    let steps = (0..).zip(context.program.steps());
    let constant = |(step, content): (StepId, &tipc::program::Step)| {
        let outcome = outcome(&content.action)?;
        Some(Constant { step, outcome })
    };
    steps.filter_map(constant).collect()
}

fn outcome(action: &Action) -> Option<Outcome> {
    if let Action::For { from, to, step, .. } = action {
        return match enters(*from, *to, *step) {
            Entry::Known(false) => Some(Outcome::Never),
            Entry::Fails => Some(Outcome::Stops),
            Entry::Known(true) | Entry::Open => None,
        };
    }
    if let Action::Next {
        step: Operand::Constant(0.0),
        ..
    } = action
    {
        return Some(Outcome::Stops);
    }
    let is = settled(*action.condition()?)?;
    let is_endless = match action {
        Action::While { .. } => is,
        Action::Until { .. } => !is,
        _ => false,
    };
    (!is_endless).then_some(Outcome::Is(is))
}

/// Returns the constant result of a condition: two constants compared, or a variable with itself.
fn settled(condition: Condition) -> Option<bool> {
    use tipc::program::Relation::{Eq, Ge, Gt, Le, Lt, Ne};
    match condition {
        Condition::Compare {
            left: left @ Operand::Scalar { .. },
            relation,
            right,
        } if left == right => Some(match relation {
            Eq | Le | Ge => true,
            Ne | Lt | Gt => false,
        }),
        _ => always(condition),
    }
}

/// Warns of conditions whose outcome never changes, and of loops that never run or never end because of that.
pub(super) fn conditions(
    context: &LintContext<'_>,
    constant: &[Constant],
    unreachable: &Unreachable,
    found: &mut Diagnostics,
) {
    let deeds = EffectCounts::of(context.program);
    for Constant { step, outcome } in constant {
        let Some(statement) = context
            .statement(*step)
            .filter(|_| unreachable.is_live(*step))
        else {
            continue;
        };
        found.extend(match outcome {
            _ if !deeds.depend_on(context.program, *step) => None,
            Outcome::Is(is) => Some(always_so(statement, *is)),
            Outcome::Never => Some(never_runs(context.program, statement, *step)),
            Outcome::Stops => None,
        });
    }
    let location = |step: &StepId| constant.binary_search_by_key(step, |one| one.step);
    let is_judged = |step: &StepId| location(step).is_err();
    let stuck = stuck(context.program, context.flow)
        .into_iter()
        .filter(is_judged);
    for step in stuck.filter(|step| unreachable.is_live(*step)) {
        found.extend(context.statement(step).map(never_ends));
    }
}

/// For each step, the number of earlier steps that act or jump.
struct EffectCounts(Vec<u32>);

impl EffectCounts {
    fn of(program: &Program) -> Self {
        let mut counts = vec![0];
        let mut count = 0;
        for step in program.steps() {
            count += u32::from(step.action.acts() || leads_on(&step.action));
            counts.push(count);
        }
        EffectCounts(counts)
    }

    /// Returns true if the outcome of a step has an effect. A block without any action is an unfinished program.
    fn depend_on(&self, program: &Program, step: StepId) -> bool {
        match &program.steps()[step as usize].action {
            Action::If { otherwise: end, .. }
            | Action::ElseIf { otherwise: end, .. }
            | Action::For { exit: end, .. } => {
                let before = |step: StepId| self.0.get(step as usize).or(self.0.last());
                before(step) < before(*end)
            }
            _ => true,
        }
    }
}

fn leads_on(action: &Action) -> bool {
    jump(action).is_some() || matches!(action, Action::Return | Action::Finish(_))
}

fn jump(action: &Action) -> Option<StepId> {
    match action {
        Action::Goto { to }
        | Action::IfGoto { to, .. }
        | Action::Gosub { to }
        | Action::IfGosub { to, .. } => Some(*to),
        _ => None,
    }
}

fn always_so(statement: &Statement, is: bool) -> Diagnostic {
    let (reason, help) = match (&statement.kind, is) {
        (StatementKind::While { .. }, _) => (Linting::AlwaysFalse, Linting::NeverTurns),
        (StatementKind::Until { .. }, _) => (Linting::AlwaysTrue, Linting::TurnsOnce),
        (_, true) => (Linting::AlwaysTrue, Linting::CompareVariable),
        (_, false) => (Linting::AlwaysFalse, Linting::CompareVariable),
    };
    Diagnostic::new(Code::ConstantCondition, condition(statement), reason).help(help)
}

fn never_runs(program: &Program, statement: &Statement, step: StepId) -> Diagnostic {
    let action = &program.steps()[step as usize].action;
    let (reason, help) = match action {
        Action::For {
            from: Operand::Constant(from),
            to: Operand::Constant(to),
            step: Operand::Constant(step),
            ..
        } => {
            let (from, to, step) = (*from, *to, -*step);
            (Linting::BeyondEnd { from, to }, Linting::CountBack { step })
        }
        _ => return always_so(statement, false),
    };
    Diagnostic::new(Code::ForNever, statement.span, reason).help(help)
}

fn never_ends(statement: &Statement) -> Diagnostic {
    let location = condition(statement);
    Diagnostic::new(Code::EndlessLoop, location, Linting::NothingChanges)
        .help(Linting::ChangeOrLoop)
}

pub(super) fn condition(statement: &Statement) -> Span {
    use tipc::syntax::Condition::{Compare, Flag};
    match &statement.kind {
        StatementKind::If { condition, .. }
        | StatementKind::ElseIf { condition, .. }
        | StatementKind::While { condition, .. }
        | StatementKind::Until { condition, .. } => match &**condition {
            Compare { left, right, .. } => left.span.to(right.span),
            Flag { name, .. } => name.span,
        },
        _ => statement.span,
    }
}

/// Returns the steps whose condition ends a loop that never changes a variable of the condition, in order. A loop with
/// another exit is left out: a jump, RETURN, END or EXIT. So is one whose condition has a flag, a special variable, or
/// a variable that native code or another thread assigns: these may change at any time. A loop that does nothing is
/// left out as well: a user may assign the variable that it waits for.
fn stuck(program: &Program, flow: &Flow) -> Vec<StepId> {
    if !program.threads().is_empty() {
        return Vec::new();
    }
    let mut walk = Walk::new(flow);
    let steps = (0..).zip(program.steps());
    let loops =
        steps.filter_map(|(step, content)| Some((step, turn(flow, step, &content.action)?)));
    loops
        .filter(|(step, turn)| is_stuck(program, flow, &mut walk, *step, *turn) == Some(true))
        .map(|(step, _)| step)
        .collect()
}

/// Returns the node at which another turn of a loop begins, if a step decides that by comparing variables.
fn turn(flow: &Flow, step: StepId, action: &Action) -> Option<NodeId> {
    let (condition, turn) = match action {
        Action::While { condition, .. } => (condition, step + 1),
        Action::Until { condition, back } => (condition, *back),
        Action::IfGoto { condition, to } if *to <= step => (condition, *to),
        _ => return None,
    };
    let is_fixed = |operand: &Operand| !matches!(operand, Operand::Reading { .. });
    let compares = match condition {
        Condition::Compare { left, right, .. } => is_fixed(left) && is_fixed(right),
        Condition::Flag { .. } => false,
    };
    compares.then(|| flow.first(turn))
}

/// Returns true if the loop cannot end; `None` if the searches have visited too many nodes to decide.
fn is_stuck(
    program: &Program,
    flow: &Flow,
    walk: &mut Walk<'_>,
    step: StepId,
    turn: NodeId,
) -> Option<bool> {
    let mut compared = BTreeSet::new();
    let action = |id: NodeId| &program.steps()[flow.nodes()[id].step as usize].action;
    let end = flow.first(step);
    reads(program, action(end), |scalar| {
        compared.insert(scalar);
    });
    let own = walk.from(&[turn], Some(end), Calls::Passed)?;
    let all = walk.from(&[turn], Some(end), Calls::Entered)?;
    let returns = own.iter().any(|id| flow.nodes()[*id].returns);
    let ends = all
        .iter()
        .any(|id| matches!(action(*id), Action::Finish(_)));
    let changes = all
        .iter()
        .any(|id| assigns(program, action(*id)).any(|scalar| compared.contains(&scalar)));
    let acts = all.iter().any(|id| action(*id).acts());
    let variable = |scalar: &usize| &program.variables()[program.variable_of(*scalar)];
    let is_shared = compared
        .iter()
        .any(|scalar| variable(scalar).special.is_some());
    let changes = changes || is_shared;
    Some(!compared.is_empty() && acts && own.contains(&end) && !returns && !ends && !changes)
}

/// The steps that no path leads to, in order, without those that only a constant condition keeps from running.
pub(super) struct Unreachable(Vec<StepId>);

impl Unreachable {
    /// Finds the steps. Both branches of the steps `open`, which have to be in order, count as taken.
    pub(super) fn of(context: &LintContext<'_>, open: &[StepId]) -> Self {
        Unreachable(dead(context.program, context.flow, open))
    }

    pub(super) fn is_live(&self, step: StepId) -> bool {
        self.0.binary_search(&step).is_err()
    }

    /// Warns once of each row of unreachable steps that has an effect. Stays silent about routines that nothing calls:
    /// a program may have some to spare.
    pub(super) fn warn(
        &self,
        context: &LintContext<'_>,
        glued: &GluedJumps<'_>,
        found: &mut Diagnostics,
    ) {
        if self.0.is_empty() {
            return;
        }
        let sources = sources(context.program);
        let is_subroutine = |step: StepId| {
            let statement = context.statement(step);
            statement.is_some_and(|it| matches!(it.kind, StatementKind::Subroutine { .. }))
        };
        let belongs = |before: &StepId, step: &StepId| before + 1 == *step && !is_subroutine(*step);
        for run in self.0.chunk_by(belongs) {
            found.extend(unreachable_warning(context, run, &sources, glued));
        }
    }
}

fn sources(program: &Program) -> HashMap<StepId, Vec<StepId>> {
    let mut sources: HashMap<StepId, Vec<StepId>> = HashMap::new();
    for (step, content) in (0..).zip(program.steps()) {
        if let Some(to) = jump(&content.action) {
            sources.entry(to).or_default().push(step);
        }
    }
    sources
}

fn unreachable_warning(
    context: &LintContext<'_>,
    run: &[StepId],
    sources: &HashMap<StepId, Vec<StepId>>,
    glued: &GluedJumps<'_>,
) -> Option<Diagnostic> {
    let actions = run
        .iter()
        .map(|step| &context.program.steps()[*step as usize].action);
    let is_routine = actions
        .clone()
        .any(|action| matches!(action, Action::Return));
    if !actions.clone().any(Action::acts) {
        return None;
    }
    let mut statements = run.iter().filter_map(|step| context.statement(*step));
    let start = statements.find(|statement| !closes(&statement.kind))?;
    if is_routine && start.kind.label().is_some() {
        return None;
    }
    let (first, last) = (*run.first()?, *run.last()?);
    // A step to which other unreachable steps jump is unreachable because of them.
    let mut jumps = sources.get(&start.step).into_iter().flatten();
    if jumps.any(|from| !(first..=last).contains(from)) {
        return None;
    }
    let (reason, help) = match start.kind.label() {
        Some((name, _)) if glued.mean(&name.node) => return None,
        Some((name, _)) => {
            let name = name.node.clone();
            (
                Linting::NothingJumps { name: name.clone() },
                Linting::JumpOrDelete { name },
            )
        }
        None => (Linting::NoPath, Linting::LabelOrDelete),
    };
    let diagnostic = Diagnostic::new(Code::Unreachable, start.keyword(), reason).help(help);
    let above = first
        .checked_sub(1)
        .and_then(|step| context.statement(step));
    Some(
        match above.filter(|above| !above.kind.goes_on() && !closes(&above.kind)) {
            Some(above) => diagnostic.label(above.span, Linting::LeadsElsewhere),
            None => diagnostic,
        },
    )
}

/// Returns true if a step only closes a block.
fn closes(kind: &StatementKind) -> bool {
    matches!(
        kind,
        StatementKind::Else
            | StatementKind::EndIf
            | StatementKind::Wend
            | StatementKind::Until { .. }
            | StatementKind::Next { .. }
            | StatementKind::SubEnd
            | StatementKind::ThreadEnd
    )
}

/// Returns the steps that no path from the start leads to, in order. Each branch of the steps `open`, which have to be
/// in order, counts as taken, even if constants decide otherwise.
fn dead(program: &Program, flow: &Flow, open: &[StepId]) -> Vec<StepId> {
    let is_live = reached(flow, flow.starts(), |node, next| {
        next.extend(node.call.iter().flat_map(|call| [call.entry, call.back]));
        if open.binary_search(&node.step).is_ok() {
            let action = &program.steps()[node.step as usize].action;
            next.extend(branches(flow, node.step, action));
        }
    });
    let steps = 0..program.steps().len() as StepId;
    let is_dead = |step: &StepId| !is_live[flow.first(*step)] && !is_live[flow.last(*step)];
    steps.filter(is_dead).collect()
}

/// Returns the targets of a step with two branches.
fn branches(flow: &Flow, step: StepId, action: &Action) -> [NodeId; 2] {
    let other = match action {
        Action::If { otherwise, .. } | Action::ElseIf { otherwise, .. } => flow.last(*otherwise),
        Action::While { exit: to, .. }
        | Action::Until { back: to, .. }
        | Action::For { exit: to, .. }
        | Action::Next { body: to, .. }
        | Action::IfGoto { to, .. }
        | Action::IfGosub { to, .. } => flow.first(*to),
        _ => flow.first(step + 1),
    };
    [flow.first(step + 1), other]
}

/// Warns of routines that GOSUB calls and that never return, and of a RETURN that is reached without a call (T.I.P. 3.1
/// §7-6-5). Stays silent about a routine that ends the program by EXIT or loops endlessly, and about a RETURN in a
/// SUBROUTINE: another warning reports a run into that.
pub(super) fn routines(
    context: &LintContext<'_>,
    unreachable: &Unreachable,
    found: &mut Diagnostics,
) {
    for (entry, call) in one_way(context.program, context.flow) {
        if unreachable.is_live(call) {
            found.extend(never_returns(context, entry, call));
        }
    }
    if let Some(lost) = lost_return(context).and_then(|step| context.statement(step)) {
        let diagnostic = Diagnostic::new(Code::LostReturn, lost.span, Linting::ReturnsNowhere);
        found.push(diagnostic.help(Linting::PutJumpAboveLabel));
    }
}

fn never_returns(context: &LintContext<'_>, entry: StepId, call: StepId) -> Option<Diagnostic> {
    let (part, caller) = (context.statement(entry)?, context.statement(call)?);
    let (name, _) = part.kind.label()?;
    let diagnostic = Diagnostic::new(Code::NoReturn, part.span, Linting::NeverReturns);
    let diagnostic = diagnostic.about(name.node.as_str());
    Some(
        diagnostic
            .label(caller.span, Linting::CalledHere)
            .help(Linting::EndWithReturn),
    )
}

/// Returns the first RETURN outside a SUBROUTINE that a path from the start reaches without a call. Every call is
/// assumed to return.
fn lost_return(context: &LintContext<'_>) -> Option<StepId> {
    let own = reached(context.flow, &[0], |node, next| {
        next.extend(node.call.map(|call| call.back));
    });
    let mut is_inside = Vec::new();
    let mut inside = false;
    for statement in context.module.steps() {
        inside |= matches!(statement.kind, StatementKind::Subroutine { .. });
        is_inside.push(inside);
        inside &= !matches!(statement.kind, StatementKind::SubEnd);
    }
    let nodes = context.flow.nodes().iter().zip(own);
    let mut returns = nodes.filter(|(node, own)| *own && node.returns);
    let lost = returns.find(|(node, _)| !is_inside[node.step as usize]);
    lost.map(|(node, _)| node.step)
}

/// Returns the first steps of routines that never return and do not end the program by EXIT, each with the first step
/// that calls it.
fn one_way(program: &Program, flow: &Flow) -> Vec<(StepId, StepId)> {
    let mut walk = Walk::new(flow);
    let mut entries = BTreeSet::new();
    let calls = flow
        .nodes()
        .iter()
        .filter_map(|node| Some((node.step, node.call?)));
    calls
        .filter(|(_, call)| entries.insert(call.entry))
        .filter(|(_, call)| is_one_way(program, flow, &mut walk, *call) == Some(true))
        .map(|(step, call)| (flow.nodes()[call.entry].step, step))
        .collect()
}

/// Returns true if a routine acts, and then runs to the end of the source or into a call of itself, but never returns;
/// `None` if the searches have visited too many nodes to decide.
fn is_one_way(program: &Program, flow: &Flow, walk: &mut Walk<'_>, call: Call) -> Option<bool> {
    let path = walk.from(&[call.entry], None, Calls::Passed)?;
    let nodes = || path.iter().map(|id| &flow.nodes()[*id]);
    let actions = || nodes().map(|node| &program.steps()[node.step as usize].action);
    if nodes().any(|node| node.returns) {
        return Some(false);
    }
    let runs_out = actions().any(|action| matches!(action, Action::Finish(End::End)));
    let calls_itself = nodes().any(|node| node.call.is_some_and(|inner| inner.entry == call.entry));
    Some((runs_out || calls_itself) && actions().any(Action::acts))
}

/// Maximum number of nodes that all searches of one lint visit, for each node of the program: the time stays in proportion to the
/// program. 32 loops over the whole program are still judged.
const VISITS: usize = 64;

/// The continuation of a path at a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Calls {
    /// The path goes on after the call.
    Passed,
    /// The path goes on after the call and in the called routine.
    Entered,
}

/// Follows paths from nodes, one search after the other.
struct Walk<'a> {
    flow: &'a Flow,
    /// The last search that came to each node.
    seen: Vec<u32>,
    search: u32,
    /// Number of nodes that may still be visited.
    visits: usize,
}

impl<'a> Walk<'a> {
    fn new(flow: &'a Flow) -> Self {
        Walk {
            flow,
            seen: vec![0; flow.nodes().len()],
            search: 0,
            visits: VISITS * flow.nodes().len(),
        }
    }

    /// Returns the nodes that paths from `starts` reach, including `starts`. Paths end at nodes for which `end` returns
    /// true; `None` if too many have been visited.
    fn from(
        &mut self,
        starts: &[NodeId],
        end: Option<NodeId>,
        calls: Calls,
    ) -> Option<Vec<NodeId>> {
        self.search += 1;
        let mut found = Vec::new();
        let mut open = starts.to_vec();
        while let Some(id) = open.pop() {
            let Some(node) = self.flow.nodes().get(id) else {
                continue;
            };
            if std::mem::replace(&mut self.seen[id], self.search) == self.search {
                continue;
            }
            self.visits = self.visits.checked_sub(1)?;
            found.push(id);
            if Some(id) == end {
                continue;
            }
            open.extend(node.next.iter());
            if let Some(call) = node.call {
                open.push(call.back);
                open.extend((calls == Calls::Entered).then_some(call.entry));
            }
        }
        Some(found)
    }
}

/// Labels like `GOTOL1:`, which look like jumps.
pub(super) struct GluedJumps<'a> {
    suspects: Vec<Suspect<'a>>,
    /// The labels that they would jump to.
    meant: HashSet<&'a str>,
}

impl<'a> GluedJumps<'a> {
    /// Finds the labels. Stays silent about a label with a jump to it, and if no label has the rest of its name.
    pub(super) fn of(context: &LintContext<'a>) -> Self {
        let suspects = suspects(context.symbols);
        let meant = suspects.iter().map(|it| it.meant).collect();
        GluedJumps { suspects, meant }
    }

    /// Returns true if one of the jumps was meant to lead to a label, which is therefore unreachable.
    fn mean(&self, label: &str) -> bool {
        self.meant.contains(label)
    }

    /// Warns of each of them.
    pub(super) fn warn(self, found: &mut Diagnostics) {
        for Suspect { label, jump, meant } in self.suspects {
            let help = Linting::JumpInTwoWords {
                written: format!("{jump} {meant}:").into(),
                word: label.name.clone(),
            };
            let reason = Linting::JumpInOneWord { jump };
            let warning = |location| Diagnostic::new(Code::GluedJump, location, reason).help(help);
            found.extend(label.span.map(warning));
        }
    }
}

/// A label that looks like a jump.
struct Suspect<'a> {
    label: &'a Definition,
    jump: Keyword,
    /// The label that it would jump to.
    meant: &'a str,
}

/// Returns the label as a suspect, if it looks like a jump.
fn suspect(label: &Definition) -> Option<Suspect<'_>> {
    let (jump, meant) = glued(&label.name)?;
    (label.kind == DefinitionKind::Label).then_some(Suspect { label, jump, meant })
}

fn suspects(symbols: &Symbols) -> Vec<Suspect<'_>> {
    let definitions = symbols.definitions();
    let kinds: HashMap<&str, DefinitionKind> = definitions
        .iter()
        .map(|it| (it.name.as_str(), it.kind))
        .collect();
    let leads_on = |jump: Keyword, meant: &str| match kinds.get(meant) {
        None | Some(DefinitionKind::Variable(_) | DefinitionKind::Constant) => false,
        Some(kind) => jump != Keyword::Call || *kind == DefinitionKind::Subroutine,
    };
    let uses = symbols.all_uses().iter();
    let jumps = uses.filter(|it| matches!(it.access, Access::Jump | Access::Call));
    let used: HashSet<usize> = jumps.map(|it| it.definition.index()).collect();
    let is_unused = |(index, _): &(usize, &Definition)| !used.contains(index);
    definitions
        .iter()
        .enumerate()
        .filter(is_unused)
        .filter_map(|(_, label)| suspect(label))
        .filter(|it| leads_on(it.jump, it.meant))
        .collect()
}
