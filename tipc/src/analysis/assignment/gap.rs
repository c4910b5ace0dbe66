//! Locations where a variable lacks a value, and a path that leads there.

use super::batch::{Batch, Start, Touches};
use super::blocks::Blocks;
use super::{Assigned, Assignment};
use crate::analysis::flow::{Flow, NodeId};
use crate::program::{Program, StepId, VariableId};
use std::collections::{BTreeMap, VecDeque};

/// For how many gaps a path is searched. Each search takes time linear in the length of the program.
const WAYS: usize = 100;

/// A variable that is read without a value: the first step in the source that does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gap {
    /// The variable.
    pub variable: VariableId,
    /// The scalars of it that the step reads and that may lack a value.
    pub scalars: Vec<usize>,
    /// `Sometimes` or `Never`.
    pub assigned: Assigned,
    /// The step that reads it.
    pub step: StepId,
    /// The steps of a shortest run from step 0, or from the start of a thread, to `step` on which the first of `scalars` gets no value;
    /// of a subroutine that is left again, its call alone. Empty after the first hundred gaps.
    pub way: Vec<StepId>,
}

/// Returns the gaps of a program, by variable: one for the reads that some run finds no value at, and one for
/// those that every run does.
pub fn gaps(program: &Program, assignment: &Assignment) -> Vec<Gap> {
    let lacking = assignment
        .reads()
        .iter()
        .filter(|read| read.assigned != Assigned::Always);
    let mut gaps: BTreeMap<(VariableId, Assigned), Gap> = BTreeMap::new();
    for read in lacking {
        let variable = program.variable_of(read.scalar);
        let gap = gaps.entry((variable, read.assigned)).or_insert(Gap {
            variable,
            scalars: Vec::new(),
            assigned: read.assigned,
            step: read.step,
            way: Vec::new(),
        });
        if gap.step == read.step {
            gap.scalars.push(read.scalar);
        }
    }
    let mut gaps: Vec<Gap> = gaps.into_values().collect();
    if gaps.is_empty() {
        return gaps;
    }
    let flow = Flow::of(program);
    let (blocks, touches) = (Blocks::of(&flow), Touches::of(program, &flow));
    for gap in gaps.iter_mut().take(WAYS) {
        let touches = touches.of_scalar(gap.scalars[0]);
        let start = Start {
            nodes: flow.starts(),
            given: 0,
        };
        gap.way = way(&flow, &Batch::new(&blocks, &touches, start), gap.step);
    }
    gaps
}

/// Returns the steps of a shortest run to `step` on which nothing before it reads or assigns the scalar of a batch.
fn way(flow: &Flow, batch: &Batch<'_>, step: StepId) -> Vec<StepId> {
    let is_untouched = |id: NodeId| batch.is_untouched(id);
    let passes = batch.passes();
    let mut from: Vec<Option<NodeId>> = vec![None; flow.nodes().len()];
    let mut queue: VecDeque<NodeId> = flow.starts().iter().copied().collect();
    while let Some(id) = queue.pop_front() {
        let node = &flow.nodes()[id];
        if node.step == step && !is_untouched(id) {
            return walked(flow, &from, id);
        }
        if !is_untouched(id) {
            continue;
        }
        let call = node
            .call
            .iter()
            .flat_map(|call| [Some(call.entry), passes(call.entry).then_some(call.back)]);
        for next in node.next.iter().copied().chain(call.flatten()) {
            if !flow.starts().contains(&next) && from[next].is_none() {
                from[next] = Some(id);
                queue.push_back(next);
            }
        }
    }
    Vec::new()
}

/// Returns the steps on the path from a start to `id`.
fn walked(flow: &Flow, from: &[Option<NodeId>], id: NodeId) -> Vec<StepId> {
    let nodes = std::iter::successors(Some(id), |id| from[*id]);
    let mut steps: Vec<StepId> = nodes.map(|id| flow.nodes()[id].step).collect();
    steps.reverse();
    steps
}
