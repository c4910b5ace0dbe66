//! Ways through a program as edition 3.2 judges them when it loads: the reads that find no value on any way, and the
//! SUBROUTINEs and THREADs that a way runs into.
//!
//! A way goes from the start of the program or of a thread. A read that fails ends it. What another thread assigns on
//! its ways counts as assigned, which is no proof that it has a value.

use super::{Assigned, Assignment, Judged, NodeRead, Read, judged, predeclared};
use crate::analysis::access;
use crate::analysis::flow::{Flow, NodeId};
use crate::program::{LabelKind, Program, StepId};
use std::collections::{BTreeMap, BTreeSet};

/// The most times that the ways of a start are followed anew, since a read that fails has cut some of them.
const TURNS: usize = 32;

/// Ways of a program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ways {
    /// The reads that some way comes to.
    pub assignment: Assignment,
    /// The first read of each variable that finds no value on any way, by steps.
    pub no_value: Vec<NoValue>,
    /// The steps of SUBROUTINE and THREAD that a way runs into, or that the program begins with.
    pub entered: Vec<StepId>,
}

/// A read that finds no value on any way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct NoValue {
    /// The step that reads.
    pub step: StepId,
    /// The scalar.
    pub scalar: usize,
}

/// Ways from one start.
struct From {
    start: NodeId,
    /// The nodes behind which no way goes on, each with its first read that fails.
    fails: BTreeMap<NodeId, usize>,
    judged: Judged,
}

impl Ways {
    /// Follows the ways of a program.
    pub fn of(program: &Program) -> Self {
        let flow = Flow::of(program);
        let given = predeclared(program);
        let starts = flow.starts().iter();
        // At first no read fails, so that this only ever takes ways and assignments away.
        let mut all: Vec<From> = starts
            .map(|start| From {
                start: *start,
                fails: BTreeMap::new(),
                judged: judged(program, &flow, &[*start], &given),
            })
            .collect();
        for _ in 0..TURNS {
            let assigned: Vec<Vec<bool>> = all
                .iter()
                .map(|from| from.assigned(program, &flow))
                .collect();
            let next: Vec<From> = (0..all.len())
                .map(|this| {
                    let mut given = given.clone();
                    let others = assigned.iter().enumerate();
                    for (_, assigned) in others.filter(|(other, _)| *other != this) {
                        given
                            .iter_mut()
                            .zip(assigned)
                            .for_each(|(it, set)| *it |= set);
                    }
                    From::of(program, &flow, all[this].start, &given)
                })
                .collect();
            let is_same = |(one, other): (&From, &From)| {
                one.judged.reached == other.judged.reached && one.fails == other.fails
            };
            let is_done = all.iter().zip(&next).all(is_same);
            all = next;
            if is_done {
                break;
            }
        }
        Ways {
            assignment: assignment(&flow, &all),
            no_value: no_value(program, &flow, &all),
            entered: entered(program, &flow, &all),
        }
    }
}

impl From {
    fn of(program: &Program, flow: &Flow, start: NodeId, given: &[bool]) -> Self {
        let mut fails = BTreeMap::new();
        let mut judged = judged(program, flow, &[start], given);
        for _ in 0..TURNS {
            let failing = failing(program, flow, &judged.reads);
            let before = fails.len();
            fails.extend(failing);
            if fails.len() == before {
                break;
            }
            let cuts: BTreeSet<NodeId> = fails.keys().copied().collect();
            judged = super::judged(program, &flow.cut(&cuts), &[start], given);
        }
        From {
            start,
            fails,
            judged,
        }
    }

    /// Returns true for each scalar that its ways assign.
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

/// Returns the reads of all ways together.
fn assignment(flow: &Flow, all: &[From]) -> Assignment {
    let mut together: BTreeMap<(StepId, usize), Assigned> = BTreeMap::new();
    for read in all.iter().flat_map(|from| &from.judged.reads) {
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
    Assignment::new(reads.collect())
}

/// Returns the first read of each variable that fails on every way that comes to it.
fn no_value(program: &Program, flow: &Flow, all: &[From]) -> Vec<NoValue> {
    let finds = |node: NodeId, scalar: usize| {
        let mut reads = all.iter().flat_map(|from| {
            let is_before = from.fails.get(&node).is_none_or(|fails| *fails == scalar);
            from.judged.reads.iter().filter(move |_| is_before)
        });
        reads.any(|read| {
            (read.node, read.scalar) == (node, scalar) && read.assigned != Assigned::Never
        })
    };
    let mut first: BTreeMap<usize, NoValue> = BTreeMap::new();
    for from in all {
        for (node, scalar) in &from.fails {
            if !from.judged.reached[*node] || finds(*node, *scalar) {
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

/// Returns the steps of SUBROUTINE and THREAD that a way comes to from above.
fn entered(program: &Program, flow: &Flow, all: &[From]) -> Vec<StepId> {
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
    for from in all {
        for (id, node) in flow.nodes().iter().enumerate() {
            if !from.judged.reached[id] || from.fails.contains_key(&id) {
                continue;
            }
            let back = node.call.filter(|call| from.judged.comes_back[call.entry]);
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
