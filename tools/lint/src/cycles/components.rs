//! Strongly connected components of a flow graph.

use tipc::analysis::flow::NodeId;

/// Returns for each node the number of its component: two nodes with paths to each other share it, no others do
/// (Kosaraju and Sharir). `next` and `before` are each other's reverse. Takes linear time.
pub(super) fn components(next: &[Vec<NodeId>], before: &[Vec<NodeId>]) -> Vec<usize> {
    let mut components = vec![usize::MAX; next.len()];
    for (component, id) in last_first(next).into_iter().enumerate() {
        let mut open = vec![id];
        while let Some(id) = open.pop() {
            if components[id] == usize::MAX {
                components[id] = component;
                open.extend(&before[id]);
            }
        }
    }
    components
}

/// Returns the nodes, each before those that a depth-first search leaves earlier.
fn last_first(next: &[Vec<NodeId>]) -> Vec<NodeId> {
    let mut order = Vec::new();
    let mut seen = vec![false; next.len()];
    for id in 0..next.len() {
        let mut open = vec![(id, false)];
        while let Some((id, is_done)) = open.pop() {
            if is_done {
                order.push(id);
            } else if !std::mem::replace(&mut seen[id], true) {
                open.push((id, true));
                open.extend(next[id].iter().map(|next| (*next, false)));
            }
        }
    }
    order.reverse();
    order
}
