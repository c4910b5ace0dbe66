//! Paths that leave a node.

use tipc::analysis::flow::{Flow, NodeId};

/// Maximum number of nodes on a path that is followed: the time stays in proportion to the program.
const FARTHEST: usize = 1_000;

/// Nodes of a path that count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Into {
    /// Nodes of its own routine: a call is passed.
    Itself,
    /// Nodes of called routines too.
    Calls,
}

/// Follows paths from nodes, one search after the other.
pub(super) struct Walk<'a> {
    flow: &'a Flow,
    /// The last search that came to each node.
    seen: Vec<u32>,
    search: u32,
}

impl<'a> Walk<'a> {
    pub(super) fn new(flow: &'a Flow) -> Self {
        Walk {
            flow,
            seen: vec![0; flow.nodes().len()],
            search: 0,
        }
    }

    /// Returns the nodes that paths from `starts` come to, themselves among them, without those behind `end`, where
    /// paths end;
    /// `None` if there are very many.
    pub(super) fn from(
        &mut self,
        starts: &[NodeId],
        end: Option<NodeId>,
        into: Into,
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
            if found.len() == FARTHEST {
                return None;
            }
            found.push(id);
            if Some(id) == end {
                continue;
            }
            open.extend(node.next.iter());
            if let Some(call) = node.call {
                open.push(call.back);
                open.extend((into == Into::Calls).then_some(call.entry));
            }
        }
        Some(found)
    }
}
