//! The paths of a program that edition 3.2 judges at load time: reads that find no value on any path, and SUBROUTINEs
//! and THREADs that a path runs into.
//!
//! A path begins at the start of the program or of a thread, and ends at a read that fails. A scalar that another
//! thread assigns on one of its paths counts as assigned, although that does not prove that it has a value.

use super::{Assigned, Assignment, Judged, NodeRead, Read, judged, predeclared};
use crate::analysis::access;
use crate::analysis::flow::{Flow, NodeId};
use crate::program::{LabelKind, Program, StepId};
use std::collections::{BTreeMap, BTreeSet};

/// Maximum number of rounds. A read that is found to fail ends paths, so the next round follows shorter ones, in which
/// more reads may fail. If the limit ends the search, the failures that were found are right, and others are missing.
const MAX_ROUNDS: usize = 64;

/// The results of following the paths of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Paths {
    /// The reads that some path reaches.
    pub assignment: Assignment,
    /// The first read of each variable that finds no value on any path, in the order of steps.
    pub no_value: Vec<NoValue>,
    /// The steps of SUBROUTINE and THREAD that a path reaches from the step above, or that the program begins with.
    pub entered: Vec<StepId>,
}

/// A read that finds no value on any path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct NoValue {
    /// The step that reads.
    pub step: StepId,
    /// The scalar.
    pub scalar: usize,
}

/// The paths from one start.
struct Start {
    node: NodeId,
    /// The nodes at which paths end because a read fails, each with the scalar of its first such read.
    fails: BTreeMap<NodeId, usize>,
    judged: Judged,
}

impl Paths {
    /// Follows the paths of a program.
    pub fn of(program: &Program) -> Self {
        let flow = Flow::of(program);
        let given = predeclared(program);
        // At first no read is known to fail. Each round then only removes paths and assignments, so the search ends.
        let starts = flow.starts().iter().map(|node| Start {
            node: *node,
            fails: BTreeMap::new(),
            judged: judged(program, &flow, &[*node], &given),
        });
        let mut all: Vec<Start> = starts.collect();
        for _ in 0..MAX_ROUNDS {
            let assigned = all.iter().map(|start| start.assigned(program, &flow));
            let assigned: Vec<Vec<bool>> = assigned.collect();
            let mut changes = false;
            for (this, start) in all.iter_mut().enumerate() {
                let mut given = given.clone();
                let others = assigned.iter().enumerate();
                for (_, assigned) in others.filter(|(other, _)| *other != this) {
                    let both = given.iter_mut().zip(assigned);
                    both.for_each(|(it, set)| *it |= set);
                }
                changes |= start.follow(program, &flow, &given);
            }
            if !changes {
                break;
            }
        }
        Paths {
            assignment: assignment(&flow, &all),
            no_value: no_value(program, &flow, &all),
            entered: entered(program, &flow, &all),
        }
    }
}

impl Start {
    /// Follows the paths up to the reads that fail. Returns true if further reads fail, or fewer nodes are reached.
    fn follow(&mut self, program: &Program, flow: &Flow, given: &[bool]) -> bool {
        let cuts: BTreeSet<NodeId> = self.fails.keys().copied().collect();
        let judged = judged(program, &flow.cut(&cuts), &[self.node], given);
        self.fails.extend(failing(program, flow, &judged.reads));
        let changes = self.fails.len() > cuts.len() || judged.reached != self.judged.reached;
        self.judged = judged;
        changes
    }

    /// Returns true for each scalar that its paths assign.
    fn assigned(&self, program: &Program, flow: &Flow) -> Vec<bool> {
        let mut assigned = vec![false; program.scalar_count()];
        for (id, node) in flow.nodes().iter().enumerate() {
            if self.judged.reached[id] && !self.fails.contains_key(&id) {
                let action = &program.steps()[node.step as usize].action;
                assigned[access::assigns(program, action)].fill(true);
            }
        }
        assigned
    }
}

/// Returns the nodes at which a read never finds a value, each with the first such read.
fn failing(program: &Program, flow: &Flow, reads: &[NodeRead]) -> BTreeMap<NodeId, usize> {
    let mut never: BTreeMap<NodeId, BTreeSet<usize>> = BTreeMap::new();
    for read in reads.iter().filter(|read| read.assigned == Assigned::Never) {
        never.entry(read.node).or_default().insert(read.scalar);
    }
    let first = |(node, scalars): (NodeId, BTreeSet<usize>)| {
        let step = flow.nodes()[node].step;
        let mut first = None;
        access::reads(program, &program.steps()[step as usize].action, |scalar| {
            if scalars.contains(&scalar) {
                first.get_or_insert(scalar);
            }
        });
        Some((node, first?))
    };
    never.into_iter().filter_map(first).collect()
}

/// Returns the reads on the paths from all starts.
fn assignment(flow: &Flow, all: &[Start]) -> Assignment {
    let mut together: BTreeMap<(StepId, usize), Assigned> = BTreeMap::new();
    for read in all.iter().flat_map(|start| &start.judged.reads) {
        let key = (flow.nodes()[read.node].step, read.scalar);
        let known = together.entry(key).or_insert(read.assigned);
        if *known != read.assigned {
            *known = Assigned::Sometimes;
        }
    }
    let reads = together.into_iter().map(|((step, scalar), assigned)| Read {
        step,
        scalar,
        assigned,
    });
    let is_complete = all.iter().all(|start| start.judged.is_complete);
    Assignment::new(reads.collect(), is_complete)
}

/// Returns the first read of each variable that fails on every path to it.
fn no_value(program: &Program, flow: &Flow, all: &[Start]) -> Vec<NoValue> {
    let finds = |node: NodeId, scalar: usize| {
        let mut reads = all.iter().flat_map(|start| {
            let is_before = start.fails.get(&node).is_none_or(|fails| *fails == scalar);
            start.judged.reads.iter().filter(move |_| is_before)
        });
        reads.any(|read| {
            (read.node, read.scalar) == (node, scalar) && read.assigned != Assigned::Never
        })
    };
    let mut first: BTreeMap<usize, NoValue> = BTreeMap::new();
    for start in all {
        for (node, scalar) in &start.fails {
            if !start.judged.reached[*node] || finds(*node, *scalar) {
                continue;
            }
            let found = NoValue {
                step: flow.nodes()[*node].step,
                scalar: *scalar,
            };
            let known = first.entry(program.variable_of(*scalar)).or_insert(found);
            *known = found.min(*known);
        }
    }
    let mut all: Vec<NoValue> = first.into_values().collect();
    all.sort();
    all
}

/// Returns the steps of SUBROUTINE and THREAD that a path reaches from an earlier step.
fn entered(program: &Program, flow: &Flow, all: &[Start]) -> Vec<StepId> {
    let labels = program.labels().iter();
    let routines: BTreeSet<StepId> = labels
        .filter(|label| label.kind != LabelKind::Plain)
        .map(|label| label.step)
        .collect();
    let is_routine = |node: NodeId| routines.contains(&flow.nodes()[node].step);
    let mut found = BTreeSet::new();
    if is_routine(0) {
        found.insert(0);
    }
    for start in all {
        for (id, node) in flow.nodes().iter().enumerate() {
            if !start.judged.reached[id] || start.fails.contains_key(&id) {
                continue;
            }
            let back = node.call.filter(|call| start.judged.comes_back[call.entry]);
            let next = node.next.iter().copied().chain(back.map(|call| call.back));
            let from_above = next
                .filter(|next| is_routine(*next))
                .map(|next| flow.nodes()[next].step)
                .filter(|step| node.step < *step);
            found.extend(from_above);
        }
    }
    found.into_iter().collect()
}
