//! The call graph of subroutines.

use super::components::components;
use super::distance::Work;
use std::collections::{BTreeMap, BTreeSet};
use tipc::analysis::flow::{Flow, NodeId};

/// The subroutines of a program, each after those that it calls, as far as they do not call each other.
pub(super) struct Calls {
    entries: Vec<NodeId>,
    /// For each index in that order those of the subroutines that call it.
    callers: Vec<Vec<usize>>,
    is_recursive: Vec<bool>,
}

impl Calls {
    /// Finds the routines of a flow; `None` if they share more steps than there is work left for.
    pub(super) fn new(flow: &Flow, work: &Work) -> Option<Self> {
        let entries: BTreeSet<NodeId> = flow.calls().map(|call| call.entry).collect();
        let numbers: BTreeMap<NodeId, usize> = entries.iter().copied().zip(0..).collect();
        let mut seen = vec![NodeId::MAX; flow.nodes().len()];
        let called = entries.iter().map(|entry| {
            let called = called(flow, *entry, &mut seen, work)?;
            Some(called.into_iter().map(|entry| numbers[&entry]).collect())
        });
        let called: Vec<Vec<usize>> = called.collect::<Option<_>>()?;
        let mut callers = vec![Vec::new(); called.len()];
        for (caller, called) in called.iter().enumerate() {
            called
                .iter()
                .for_each(|called| callers[*called].push(caller));
        }
        let components = components(&called, &callers);
        let mut alike = vec![0; called.len()];
        components
            .iter()
            .for_each(|component| alike[*component] += 1);
        // A component has a lower number than those that it leads to.
        let mut order: Vec<usize> = (0..called.len()).collect();
        order.sort_by_key(|number| std::cmp::Reverse(components[*number]));
        let mut places = vec![0; called.len()];
        order
            .iter()
            .zip(0..)
            .for_each(|(number, place)| places[*number] = place);
        let entries: Vec<NodeId> = entries.into_iter().collect();
        let recursive =
            |number: &usize| alike[components[*number]] > 1 || called[*number].contains(number);
        let placed = |number: &usize| {
            callers[*number]
                .iter()
                .map(|caller| places[*caller])
                .collect()
        };
        Some(Calls {
            entries: order.iter().map(|number| entries[*number]).collect(),
            callers: order.iter().map(placed).collect(),
            is_recursive: order.iter().map(recursive).collect(),
        })
    }

    /// Returns the number of routines.
    pub(super) fn count(&self) -> usize {
        self.entries.len()
    }

    /// Returns the entry of the routine with this index.
    pub(super) fn entry(&self, place: usize) -> NodeId {
        self.entries[place]
    }

    /// Returns true if the routine calls itself, at any depth.
    pub(super) fn is_recursive(&self, place: usize) -> bool {
        self.is_recursive[place]
    }

    /// Returns the indices of those that call it themselves.
    pub(super) fn callers(&self, place: usize) -> impl Iterator<Item = usize> {
        self.callers[place].iter().copied()
    }
}

/// Returns the entries that a subroutine calls itself.
fn called(
    flow: &Flow,
    entry: NodeId,
    seen: &mut [NodeId],
    work: &Work,
) -> Option<BTreeSet<NodeId>> {
    let mut called = BTreeSet::new();
    let mut open = vec![entry];
    while let Some(id) = open.pop() {
        if std::mem::replace(&mut seen[id], entry) == entry {
            continue;
        }
        work.take(1)?;
        let node = &flow.nodes()[id];
        open.extend(node.next.iter());
        open.extend(node.call.map(|call| call.back));
        called.extend(node.call.map(|call| call.entry));
    }
    Some(called)
}
