//! The data flow over basic blocks. A run that enters a block passes its nodes from the first to the last.

use crate::analysis::access;
use crate::analysis::flow::{Flow, NodeId};
use crate::program::Program;
use std::collections::BTreeSet;

/// The states of 64 scalars at a location, as two sets. A scalar is in neither set if a read without a value has ended
/// every run before it gets there.
#[derive(Clone, Copy, Default, PartialEq)]
struct Word {
    /// The scalars that may be unassigned.
    unassigned: u64,
    /// The scalars that may be assigned.
    assigned: u64,
}

impl Word {
    const UNASSIGNED: Word = Word {
        unassigned: u64::MAX,
        assigned: 0,
    };

    fn then(self, after: Word) -> Word {
        Word {
            unassigned: self.unassigned & after.unassigned,
            assigned: self.assigned | (self.unassigned & after.assigned),
        }
    }

    fn or(self, other: Word) -> Word {
        Word {
            unassigned: self.unassigned | other.unassigned,
            assigned: self.assigned | other.assigned,
        }
    }
}

/// The states of all judged scalars at a location.
#[derive(Clone, PartialEq)]
pub(super) struct State(Vec<Word>);

impl State {
    /// Creates the state with every one of so many scalars unassigned.
    fn unassigned(scalars: usize) -> Self {
        State(vec![Word::UNASSIGNED; scalars.div_ceil(64)])
    }

    /// Returns true if the scalar at a place may be unassigned.
    pub(super) fn may_be_unassigned(&self, place: usize) -> bool {
        self.0[place / 64].unassigned >> (place % 64) & 1 != 0
    }

    /// Returns true if the scalar at a place may be assigned.
    pub(super) fn may_be_assigned(&self, place: usize) -> bool {
        self.0[place / 64].assigned >> (place % 64) & 1 != 0
    }

    /// Applies a read or an assignment of the scalar at a place. Behind a read, only runs in which it is assigned go
    /// on.
    pub(super) fn pass(&mut self, place: usize, assigns: bool) {
        let word = &mut self.0[place / 64];
        let bit = 1 << (place % 64);
        if assigns {
            word.assigned |= word.unassigned & bit;
        }
        word.unassigned &= !bit;
    }

    /// Returns the state after a part of the program that begins in this state. `after` is its state if the part begins
    /// with every scalar unassigned.
    fn then(&self, after: &State) -> State {
        let words = self.0.iter().zip(&after.0);
        State(words.map(|(word, after)| word.then(*after)).collect())
    }

    /// Adds the runs of another state. Returns true if that changes this one.
    fn join(&mut self, other: &State) -> bool {
        let mut changes = false;
        for (word, other) in self.0.iter_mut().zip(&other.0) {
            let joined = word.or(*other);
            changes |= joined != *word;
            *word = joined;
        }
        changes
    }
}

/// Adds the runs of another state, if there are any; returns true if that changes the known one.
fn join(known: &mut Option<State>, other: State) -> bool {
    match known {
        Some(known) => known.join(&other),
        None => {
            *known = Some(other);
            true
        }
    }
}

/// A read or assignment of a scalar by a node.
#[derive(Clone, Copy)]
pub(super) struct Access {
    pub(super) node: NodeId,
    pub(super) scalar: usize,
    pub(super) assigns: bool,
}

/// Returns every read and assignment of a program, in the order of the nodes; each node reads before it assigns.
pub(super) fn accesses(program: &Program, flow: &Flow) -> Vec<Access> {
    let mut all = Vec::with_capacity(2 * flow.nodes().len());
    for (node, content) in flow.nodes().iter().enumerate() {
        let action = &program.steps()[content.step as usize].action;
        if !content.is_passed {
            access::reads(program, action, |scalar| {
                all.push(Access {
                    node,
                    scalar,
                    assigns: false,
                });
            });
        }
        all.extend(access::assigns(program, action).map(|scalar| Access {
            node,
            scalar,
            assigns: true,
        }));
    }
    all
}

/// Scalars that are judged: each has a place in a [`State`].
#[derive(Clone)]
pub(super) struct Places {
    of_scalar: Vec<Option<usize>>,
    count: usize,
}

impl Places {
    /// Gives the only place to one scalar.
    pub(super) fn only(scalar: usize, scalars: usize) -> Self {
        let mut places = Places {
            of_scalar: vec![None; scalars],
            count: 0,
        };
        places.add(scalar);
        places
    }

    /// Gives a place to each scalar that some block reads before it assigns it.
    pub(super) fn exposed(accesses: &[Access], scalars: usize, blocks: &Blocks) -> Self {
        let mut places = Places {
            of_scalar: vec![None; scalars],
            count: 0,
        };
        let mut last_block: Vec<Option<BlockId>> = vec![None; scalars];
        for access in accesses {
            let block = Some(blocks.of_node(access.node));
            let is_first = last_block[access.scalar].replace(blocks.of_node(access.node)) != block;
            if !access.assigns && is_first && places.of(access.scalar).is_none() {
                places.add(access.scalar);
            }
        }
        places
    }

    fn add(&mut self, scalar: usize) {
        self.of_scalar[scalar] = Some(self.count);
        self.count += 1;
    }

    /// Returns the place of a scalar, if it has one.
    pub(super) fn of(&self, scalar: usize) -> Option<usize> {
        self.of_scalar[scalar]
    }

    /// Removes the places from `limit` on, and returns the number of scalars that lose theirs.
    pub(super) fn keep(&mut self, limit: usize) -> usize {
        let lost = self.count.saturating_sub(limit);
        self.count -= lost;
        for place in &mut self.of_scalar {
            *place = place.filter(|place| *place < limit);
        }
        lost
    }
}

/// The index of a block. Blocks come in the order of their nodes.
pub(super) type BlockId = usize;

/// The successors of the last node of a block.
#[derive(Clone, Debug)]
struct Block {
    /// Blocks that may follow without a call or return.
    next: Vec<BlockId>,
    /// The first block of the subroutine that it may call, and the block to which that returns.
    call: Option<(BlockId, BlockId)>,
    /// True if it ends with RETURN or SUBEND.
    returns: bool,
}

/// The blocks of a flow.
#[derive(Clone, Debug)]
pub(super) struct Blocks {
    all: Vec<Block>,
    of_node: Vec<BlockId>,
    /// For each block those that name it in `next` or `call`.
    before: Vec<Vec<BlockId>>,
}

impl Blocks {
    /// Splits a flow into blocks. Takes time and memory linear in its length.
    pub(super) fn of(flow: &Flow) -> Self {
        let nodes = flow.nodes();
        let begins = beginnings(flow);
        let mut count = 0;
        let number = |begins: &bool| {
            count += usize::from(*begins);
            count - 1
        };
        let of_node: Vec<BlockId> = begins.iter().map(number).collect();
        let is_last = |node: &NodeId| begins.get(node + 1) != Some(&false);
        let lasts = (0..nodes.len()).filter(is_last).map(|node| &nodes[node]);
        let blocks = lasts.map(|last| Block {
            next: last.next.iter().map(|next| of_node[*next]).collect(),
            call: last
                .call
                .map(|call| (of_node[call.entry], of_node[call.back])),
            returns: last.returns,
        });
        let all: Vec<Block> = blocks.collect();
        let mut before = vec![Vec::new(); all.len()];
        for (id, block) in all.iter().enumerate() {
            let called = block
                .call
                .into_iter()
                .flat_map(|(entry, back)| [entry, back]);
            for next in block.next.iter().copied().chain(called) {
                before[next].push(id);
            }
        }
        Blocks {
            all,
            of_node,
            before,
        }
    }

    /// Returns the number of blocks.
    pub(super) fn count(&self) -> usize {
        self.all.len()
    }

    /// Returns the block that a node is in.
    pub(super) fn of_node(&self, node: NodeId) -> BlockId {
        self.of_node[node]
    }
}

/// Returns which nodes begin a block: all except those that only the node before them leads to.
fn beginnings(flow: &Flow) -> Vec<bool> {
    let nodes = flow.nodes();
    let mut begins = vec![false; nodes.len()];
    let mut mark = |node: NodeId| {
        if let Some(begins) = begins.get_mut(node) {
            *begins = true;
        }
    };
    flow.starts().iter().copied().for_each(&mut mark);
    for (id, node) in nodes.iter().enumerate() {
        if node.next == [id + 1] && node.call.is_none() {
            continue;
        }
        mark(id + 1);
        node.next.iter().copied().for_each(&mut mark);
        if let Some(call) = node.call {
            mark(call.entry);
            mark(call.back);
        }
    }
    begins
}

/// The data flow of the scalars that have places.
pub(super) struct Analysis<'a> {
    blocks: &'a Blocks,
    scalars: usize,
    /// The state after each block that begins with every scalar unassigned.
    effects: Vec<State>,
    /// For each block, the state at the return of the subroutine that it is in, with every scalar unassigned before the
    /// block; `None` if no path leads from it to a return.
    summaries: Vec<Option<State>>,
}

impl<'a> Analysis<'a> {
    /// Analyses the accesses of the scalars that have places.
    pub(super) fn new(blocks: &'a Blocks, accesses: &[Access], places: &Places) -> Self {
        let mut effects = vec![State::unassigned(places.count); blocks.count()];
        for access in accesses {
            if let Some(place) = places.of(access.scalar) {
                effects[blocks.of_node(access.node)].pass(place, access.assigns);
            }
        }
        let mut analysis = Analysis {
            blocks,
            scalars: places.count,
            summaries: vec![None; blocks.count()],
            effects,
        };
        analysis.summarise();
        analysis
    }

    fn summarise(&mut self) {
        let blocks = self.blocks.all.iter().enumerate();
        let returning = blocks.filter(|(_, block)| block.returns);
        let mut work: BTreeSet<BlockId> = returning.map(|(id, _)| id).collect();
        while let Some(id) = work.pop_last() {
            let Some(behind) = self.behind(&self.blocks.all[id]) else {
                continue;
            };
            let summary = self.effects[id].then(&behind);
            if join(&mut self.summaries[id], summary) {
                work.extend(&self.blocks.before[id]);
            }
        }
    }

    /// Returns the state at the return of the subroutine that a block is in, with every scalar unassigned at the end of
    /// the block; `None` if no path leads there.
    fn behind(&self, block: &Block) -> Option<State> {
        let mut paths = block.returns.then(|| State::unassigned(self.scalars));
        for next in &block.next {
            if let Some(summary) = &self.summaries[*next] {
                join(&mut paths, summary.clone());
            }
        }
        if let Some((entry, back)) = block.call
            && let (Some(inner), Some(back)) = (&self.summaries[entry], &self.summaries[back])
        {
            join(&mut paths, inner.then(back));
        }
        paths
    }

    /// Returns the state after a call of the subroutine at a node, with every scalar unassigned before the call; `None`
    /// if it never returns.
    pub(super) fn call(&self, entry: NodeId) -> Option<&State> {
        self.summaries[self.blocks.of_node(entry)].as_ref()
    }

    /// Returns the state before each block, for runs that begin at these nodes with the scalars at these places
    /// assigned; `None` for a block that no run reaches.
    pub(super) fn states(&self, starts: &[NodeId], given: &[usize]) -> Vec<Option<State>> {
        let mut states: Vec<Option<State>> = vec![None; self.blocks.count()];
        let mut work = BTreeSet::new();
        let mut start = State::unassigned(self.scalars);
        given.iter().for_each(|place| start.pass(*place, true));
        for node in starts.iter().filter(|_| self.blocks.count() > 0) {
            let first = self.blocks.of_node(*node);
            states[first] = Some(start.clone());
            work.insert(first);
        }
        while let Some(id) = work.pop_first() {
            let Some(state) = &states[id] else { continue };
            let after = state.then(&self.effects[id]);
            let block = &self.blocks.all[id];
            let mut flow_to = |to: BlockId, state: State| {
                if join(&mut states[to], state) {
                    work.insert(to);
                }
            };
            if let Some((entry, back)) = block.call {
                flow_to(entry, after.clone());
                if let Some(summary) = &self.summaries[entry] {
                    flow_to(back, after.then(summary));
                }
            }
            for next in &block.next {
                flow_to(*next, after.clone());
            }
        }
        states
    }
}
