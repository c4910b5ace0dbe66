//! The control flow between steps (T.I.P. 3.1 §7-6).
//!
//! A node is a step; ELSEIF and ELSE are two, since what they do depends on how they are reached.
//! Conditions and loops over constants follow only the branch that they really take.

use crate::program::{Action, Condition, Operand, Program, Relation, StepId};
use std::collections::BTreeSet;

/// The index of a node in its flow. Nodes come in the order of their steps.
pub type NodeId = usize;

/// A step, with the way in which it is reached.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Node {
    /// The step.
    pub step: StepId,
    /// True for an ELSEIF or ELSE that is reached at the end of the branch above it: the step passes on, and does not
    /// read its condition.
    pub is_passed: bool,
    /// The nodes that may follow without a call or return: two at most.
    pub next: Vec<NodeId>,
    /// The call that it may make.
    pub call: Option<Call>,
    /// True for RETURN or SUBEND.
    pub returns: bool,
}

/// A call of a subroutine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Call {
    /// First node of the subroutine.
    pub entry: NodeId,
    /// Node to which it returns.
    pub back: NodeId,
}

/// The flow of a program. Its run begins at node 0, and each thread at the node of its THREAD.
#[derive(Clone, Debug)]
pub struct Flow {
    nodes: Vec<Node>,
    starts: Vec<NodeId>,
}

impl Flow {
    /// Computes the flow of a program. Takes time and memory linear in its length.
    pub fn of(program: &Program) -> Self {
        let targets = StepTargets::new(program);
        let mut nodes = Vec::new();
        for (step, content) in (0..).zip(program.steps()) {
            let action = &content.action;
            if let Some(to) = action.passed_to() {
                nodes.push(Node {
                    step,
                    is_passed: true,
                    next: targets.to(to).into_iter().collect(),
                    ..Node::default()
                });
            }
            nodes.push(targets.node(step, action));
        }
        let threads = program.threads().iter();
        let threads = threads.filter_map(|thread| targets.to(thread.first));
        let starts = [0].into_iter().chain(threads).collect();
        Flow { nodes, starts }
    }

    /// Returns the flow in which every run ends at these nodes.
    pub fn cut(&self, at: &BTreeSet<NodeId>) -> Flow {
        let mut flow = self.clone();
        for node in at {
            flow.nodes[*node].next.clear();
            flow.nodes[*node].call = None;
            flow.nodes[*node].returns = false;
        }
        flow
    }

    /// Returns the first nodes of the program and of each thread.
    pub fn starts(&self) -> &[NodeId] {
        &self.starts
    }

    /// Returns the nodes in the order of their steps.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Returns the first node of a step; the number of nodes for one past the last.
    pub fn first(&self, step: StepId) -> NodeId {
        self.nodes.partition_point(|node| node.step < step)
    }

    /// Returns the last node of a step, to which a false IF or ELSEIF leads.
    pub fn last(&self, step: StepId) -> NodeId {
        self.first(step + 1).saturating_sub(1)
    }

    /// Returns every call.
    pub fn calls(&self) -> impl Iterator<Item = Call> {
        self.nodes.iter().filter_map(|node| node.call)
    }

    /// Returns for each node those whose `next` or `call` name it.
    pub fn before(&self) -> Vec<Vec<NodeId>> {
        let mut before = vec![Vec::new(); self.nodes.len()];
        for (id, node) in self.nodes.iter().enumerate() {
            let called = node.call.iter().flat_map(|call| [call.entry, call.back]);
            for next in node.next.iter().copied().chain(called) {
                before[next].push(id);
            }
        }
        before
    }
}

/// Targets of steps: the first and the last node of each.
struct StepTargets(Vec<(NodeId, NodeId)>);

impl StepTargets {
    fn new(program: &Program) -> Self {
        let mut nodes = 0;
        let ends = program.steps().iter().map(|step| {
            let first = nodes;
            let last = first + usize::from(step.action.passed_to().is_some());
            nodes = last + 1;
            (first, last)
        });
        StepTargets(ends.collect())
    }

    /// Returns the node of a step reached "taken"; none past the last.
    fn to(&self, step: StepId) -> Option<NodeId> {
        self.0.get(step as usize).map(|(first, _)| *first)
    }

    /// Returns the node of a step reached "not taken".
    fn otherwise(&self, step: StepId) -> Option<NodeId> {
        self.0.get(step as usize).map(|(_, last)| *last)
    }

    /// Returns the node of a step, ELSEIF and ELSE as reached "not taken".
    fn node(&self, step: StepId, action: &Action) -> Node {
        let on = self.to(step + 1);
        let mut call = None;
        let next = match action {
            Action::Nothing
            | Action::SetScalar { .. }
            | Action::SetStruct { .. }
            | Action::Else { .. }
            | Action::Command { .. }
            | Action::TeachStruct { .. }
            | Action::TeachScalar { .. }
            | Action::AdIn { .. }
            | Action::KeyIn { .. }
            | Action::StartThread { .. }
            | Action::StopThread { .. }
            | Action::WaitThread { .. }
            | Action::FileMessage { .. }
            | Action::Message { .. } => [on, None],
            Action::If {
                condition,
                otherwise,
            }
            | Action::ElseIf {
                condition,
                otherwise,
            } => chosen(always(*condition), on, self.otherwise(*otherwise)),
            Action::While { condition, exit } => chosen(always(*condition), on, self.to(*exit)),
            Action::Until { condition, back } => chosen(always(*condition), on, self.to(*back)),
            Action::IfGoto { condition, to } => chosen(always(*condition), self.to(*to), on),
            Action::Goto { to } => [self.to(*to), None],
            Action::For {
                from,
                to,
                step,
                exit,
                ..
            } => match enters(*from, *to, *step) {
                Entry::Fails => [None, None],
                Entry::Known(enters) => chosen(Some(enters), on, self.to(*exit)),
                Entry::Open => [on, self.to(*exit)],
            },
            Action::Next { step, body, .. } => match step {
                Operand::Constant(0.0) => [None, None],
                _ => [self.to(*body), on],
            },
            Action::Gosub { to } => {
                call = self.call(*to, step);
                [None, None]
            }
            Action::IfGosub { condition, to } => {
                let always = always(*condition);
                if always != Some(false) {
                    call = self.call(*to, step);
                }
                chosen(always, None, on)
            }
            Action::Return | Action::ThreadEnd | Action::Finish(_) => [None, None],
        };
        Node {
            step,
            is_passed: false,
            next: distinct(next),
            call,
            returns: matches!(action, Action::Return),
        }
    }

    fn call(&self, to: StepId, step: StepId) -> Option<Call> {
        Some(Call {
            entry: self.to(to)?,
            back: self.to(step + 1)?,
        })
    }
}

fn distinct([a, b]: [Option<NodeId>; 2]) -> Vec<NodeId> {
    let b = b.filter(|_| a != b);
    a.into_iter().chain(b).collect()
}

fn chosen(always: Option<bool>, yes: Option<NodeId>, no: Option<NodeId>) -> [Option<NodeId>; 2] {
    match always {
        Some(true) => [yes, None],
        Some(false) => [no, None],
        None => [yes, no],
    }
}

/// Returns the constant result of a condition, if it is known: two constants compared.
pub fn always(condition: Condition) -> Option<bool> {
    match condition {
        Condition::Compare {
            left: Operand::Constant(left),
            relation,
            right: Operand::Constant(right),
        } => Some(match relation {
            Relation::Eq => left == right,
            Relation::Ne => left != right,
            Relation::Lt => left < right,
            Relation::Gt => left > right,
            Relation::Le => left <= right,
            Relation::Ge => left >= right,
        }),
        Condition::Compare { .. } | Condition::Flag { .. } => None,
    }
}

/// Result of FOR's first test, as far as constants decide it.
pub enum Entry {
    /// A step of zero: the program stops.
    Fails,
    /// Its outcome.
    Known(bool),
    /// Not known.
    Open,
}

/// Evaluates FOR's first test, as far as constants decide it.
pub fn enters(from: Operand, to: Operand, step: Operand) -> Entry {
    match (from, to, step) {
        (_, _, Operand::Constant(0.0)) => Entry::Fails,
        (Operand::Constant(from), Operand::Constant(to), Operand::Constant(step)) => {
            Entry::Known(if step > 0.0 { from <= to } else { from >= to })
        }
        _ => Entry::Open,
    }
}
