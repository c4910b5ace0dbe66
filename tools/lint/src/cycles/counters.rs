//! Assignments of counters in the bodies of FORs, direct or in what they call.

use super::components::components;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use tipc::analysis::access;
use tipc::analysis::flow::{Flow, NodeId};
use tipc::program::Program;

/// Number of counters in a machine word.
const BATCH: usize = u64::BITS as usize;

/// The most counters of loops with calls that are looked for in what is called. Of others a call counts as assigning them.
const FOLLOWED: usize = 16 * BATCH;

/// Assignments to the counters of some loops.
pub(super) struct Counters {
    /// The scalar of each FOR.
    scalars: BTreeMap<NodeId, usize>,
    /// The nodes that assign each scalar, in order.
    assigning: BTreeMap<usize, Vec<NodeId>>,
    /// The nodes whose calls assign it, in order.
    calling: BTreeMap<usize, Vec<NodeId>>,
    /// Counters that may be assigned by any call.
    unknown: BTreeSet<usize>,
}

impl Counters {
    /// Collects the counters of loops, whose bodies up to their NEXTs are given by the nodes of their FORs.
    pub(super) fn new(
        program: &Program,
        flow: &Flow,
        bodies: &BTreeMap<NodeId, Range<NodeId>>,
    ) -> Self {
        let assigned = |id: NodeId| {
            let step = flow.nodes()[id].step;
            access::assigns(program, &program.steps()[step as usize].action)
        };
        let scalars: BTreeMap<_, _> = bodies
            .keys()
            .map(|head| (*head, assigned(*head).start))
            .collect();
        let mut assigning: BTreeMap<usize, Vec<NodeId>> = scalars
            .values()
            .map(|scalar| (*scalar, Vec::new()))
            .collect();
        for id in 0..flow.nodes().len() {
            for scalar in assigned(id) {
                if let Some(nodes) = assigning.get_mut(&scalar) {
                    nodes.push(id);
                }
            }
        }
        let mut counters = Counters {
            scalars,
            assigning,
            calling: BTreeMap::new(),
            unknown: BTreeSet::new(),
        };
        counters.follow_calls(flow, bodies);
        counters
    }

    /// Returns true if the body, or what it calls, assigns the counter.
    pub(super) fn are_set_in(&self, head: NodeId, body: &Range<NodeId>) -> bool {
        let scalar = &self.scalars[&head];
        let holds = |nodes: Option<&Vec<NodeId>>| {
            let nodes = nodes.map(Vec::as_slice).unwrap_or_default();
            let first = nodes.partition_point(|id| *id < body.start);
            nodes.get(first).is_some_and(|id| *id < body.end)
        };
        let is_set = holds(self.assigning.get(scalar)) || holds(self.calling.get(scalar));
        is_set || self.unknown.contains(scalar)
    }

    /// Finds the calls that assign counters of loops with calls.
    fn follow_calls(&mut self, flow: &Flow, bodies: &BTreeMap<NodeId, Range<NodeId>>) {
        let nodes = flow.nodes().iter().enumerate();
        let calls: Vec<(NodeId, NodeId)> = nodes
            .filter_map(|(id, node)| Some((id, node.call?.entry)))
            .collect();
        let has_call = |body: &Range<NodeId>| {
            let first = calls.partition_point(|(id, _)| *id < body.start);
            let first = calls.get(first);
            first.is_some_and(|(id, _)| *id < body.end)
        };
        let with_calls = bodies.iter().filter(|(_, body)| has_call(body));
        let mut scalars: BTreeSet<usize> = with_calls.map(|(head, _)| self.scalars[head]).collect();
        if scalars.is_empty() {
            return;
        }
        if let Some(first) = scalars.iter().nth(FOLLOWED).copied() {
            self.unknown = scalars.split_off(&first);
        }
        let next = flow.nodes().iter().map(|node| {
            let called = node.call.iter().flat_map(|call| [call.entry, call.back]);
            node.next.iter().copied().chain(called).collect()
        });
        let next: Vec<Vec<NodeId>> = next.collect();
        let components = components(&next, &flow.before());
        let mut inner_first: Vec<NodeId> = (0..next.len()).collect();
        inner_first.sort_by_key(|id| std::cmp::Reverse(components[*id]));
        let scalars: Vec<usize> = scalars.into_iter().collect();
        for batch in scalars.chunks(BATCH) {
            let mut assigned = vec![0_u64; next.len()];
            for (bit, scalar) in batch.iter().enumerate() {
                for id in &self.assigning[scalar] {
                    assigned[components[*id]] |= 1 << bit;
                }
            }
            // Where a component leads has a higher number, and is complete.
            for id in &inner_first {
                for next in &next[*id] {
                    assigned[components[*id]] |= assigned[components[*next]];
                }
            }
            for (bit, scalar) in batch.iter().enumerate() {
                let sets = |entry: NodeId| assigned[components[entry]] & (1 << bit) != 0;
                let nodes = calls.iter().filter(|(_, entry)| sets(*entry));
                self.calling
                    .insert(*scalar, nodes.map(|(id, _)| *id).collect());
            }
        }
    }
}
