//! The data flow over basic blocks, runs of nodes that a run passes from the first to the last, for as many scalars as
//! one machine word can hold.

use crate::analysis::access;
use crate::analysis::flow::{Flow, NodeId};
use crate::program::Program;
use std::collections::BTreeSet;

/// Effect of the path through something on unassigned scalars.
#[derive(Clone, Copy, PartialEq)]
struct Effect {
    /// The scalars that it neither reads nor assigns.
    untouched: Scalars,
    /// The scalars that it assigns before it reads them.
    set: Scalars,
}

impl Effect {
    const NONE: Effect = Effect {
        untouched: Scalars::MAX,
        set: 0,
    };

    fn of(touch: Touch) -> Self {
        Effect {
            untouched: !(touch.read | touch.set),
            set: touch.set & !touch.read,
        }
    }

    /// Returns the effect of this, and then something after it.
    fn then(self, behind: Effect) -> Effect {
        Effect {
            untouched: self.untouched & behind.untouched,
            set: self.set | (self.untouched & behind.set),
        }
    }
}

/// Effect of the paths from a block to the return of the call that it is in on unassigned scalars:
/// a scalar is in a set if some path belongs there. `None` if there is no path.
type Passage = Option<Effect>;

fn either(a: Passage, b: Passage) -> Passage {
    match (a, b) {
        (Some(a), Some(b)) => Some(Effect {
            untouched: a.untouched | b.untouched,
            set: a.set | b.set,
        }),
        (a, b) => a.or(b),
    }
}

/// Possible ways to reach a location. A scalar that may be neither is one with which no run gets there.
#[derive(Clone, Copy, Default, PartialEq)]
struct State {
    /// The scalars that may be unassigned.
    unassigned: Scalars,
    /// The scalars that may be assigned.
    assigned: Scalars,
}

impl State {
    /// Returns the state after something with an effect. If that first reads an unassigned scalar, the run is over.
    fn behind(self, effect: Effect) -> State {
        State {
            unassigned: self.unassigned & effect.untouched,
            assigned: self.assigned | (self.unassigned & effect.set),
        }
    }

    fn or(self, other: State) -> State {
        State {
            unassigned: self.unassigned | other.unassigned,
            assigned: self.assigned | other.assigned,
        }
    }
}

/// The scalars that a node reads, and how runs can come to it.
#[derive(Clone, Copy)]
pub(super) struct Found {
    /// The node.
    pub(super) node: NodeId,
    /// The scalars that it reads and that may be unassigned there.
    pub(super) unassigned: Scalars,
    /// The scalars that it reads and that may be assigned there.
    pub(super) assigned: Scalars,
}

/// Beginning of runs.
#[derive(Clone, Copy)]
pub(super) struct Start<'a> {
    /// The nodes where a run may begin.
    pub(super) nodes: &'a [NodeId],
    /// The scalars that have a value there.
    pub(super) given: Scalars,
}

/// Some scalars in the blocks of a flow.
pub(super) struct Batch<'a> {
    blocks: &'a Blocks,
    start: Start<'a>,
    touches: &'a [Touch],
    effects: Vec<Effect>,
}

impl<'a> Batch<'a> {
    /// Prepares the scalars that are touched so, in the order of the nodes, for runs that begin so.
    pub(super) fn new(blocks: &'a Blocks, touches: &'a [Touch], start: Start<'a>) -> Self {
        let mut effects = vec![Effect::NONE; blocks.all().len()];
        for touch in touches {
            let effect = &mut effects[blocks.of_node(touch.node)];
            *effect = effect.then(Effect::of(*touch));
        }
        Batch {
            blocks,
            start,
            touches,
            effects,
        }
    }

    /// Returns what each node that reads finds, and for each block whether a run can come to it.
    pub(super) fn found(&self) -> (Vec<Found>, Vec<bool>) {
        let states = self.states();
        let mut found = Vec::new();
        let mut block = None;
        let mut state = State::default();
        for touch in self.touches {
            let its_block = self.blocks.of_node(touch.node);
            if block.replace(its_block) != Some(its_block) {
                state = states[its_block];
            }
            if touch.read != 0 {
                found.push(Found {
                    node: touch.node,
                    unassigned: state.unassigned & touch.read,
                    assigned: state.assigned & touch.read,
                });
            }
            state = state.behind(Effect::of(*touch));
        }
        let is_reached = |state: &State| state.unassigned & UNTOUCHED != 0;
        (found, states.iter().map(is_reached).collect())
    }

    /// Returns for each block how runs come to it.
    fn states(&self) -> Vec<State> {
        let blocks = self.blocks.all();
        let passages = self.passages();
        let mut states = vec![State::default(); blocks.len()];
        let mut work = BTreeSet::new();
        for node in self.start.nodes.iter().filter(|_| !blocks.is_empty()) {
            let first = self.blocks.of_node(*node);
            states[first].unassigned = !self.start.given;
            states[first].assigned = self.start.given;
            work.insert(first);
        }
        while let Some(id) = work.pop_first() {
            let after = states[id].behind(self.effects[id]);
            let mut flow_to = |to: BlockId, state: State| {
                let joined = states[to].or(state);
                if joined != states[to] {
                    states[to] = joined;
                    work.insert(to);
                }
            };
            for next in blocks[id].next.iter() {
                flow_to(*next, after);
            }
            if let Some((entry, back)) = blocks[id].call {
                flow_to(entry, after);
                if let Some(passage) = passages[entry] {
                    flow_to(back, after.behind(passage));
                }
            }
        }
        states
    }

    /// Returns true if a node neither reads nor assigns any of the scalars.
    pub(super) fn is_untouched(&self, node: NodeId) -> bool {
        self.touches
            .binary_search_by_key(&node, |touch| touch.node)
            .is_err()
    }

    /// Returns a test: true if some path through the subroutine at a node leaves the scalar at bit 0 alone.
    pub(super) fn passes(&self) -> impl Fn(NodeId) -> bool {
        let passages = self.passages();
        move |entry| {
            let passage = passages[self.blocks.of_node(entry)];
            passage.is_some_and(|passage| passage.untouched & 1 != 0)
        }
    }

    /// Returns a test: true if some path through the subroutine at a node comes back.
    pub(super) fn comes_back(&self) -> impl Fn(NodeId) -> bool {
        let passages = self.passages();
        move |entry| passages[self.blocks.of_node(entry)].is_some()
    }

    /// Returns for each block the paths to the return of the call that it is in.
    fn passages(&self) -> Vec<Passage> {
        let blocks = self.blocks.all();
        let mut passages = vec![None; blocks.len()];
        let returning = blocks.iter().enumerate().filter(|(_, block)| block.returns);
        let mut work: BTreeSet<BlockId> = returning.map(|(id, _)| id).collect();
        while let Some(id) = work.pop_last() {
            let behind = behind(&blocks[id], &passages);
            let passage = behind.map(|behind| self.effects[id].then(behind));
            if passage != passages[id] {
                passages[id] = passage;
                work.extend(self.blocks.before(id));
            }
        }
        passages
    }
}

/// Returns the paths from the end of a block.
fn behind(block: &Block, passages: &[Passage]) -> Passage {
    let mut ways = block.returns.then_some(Effect::NONE);
    for next in block.next.iter() {
        ways = either(ways, passages[*next]);
    }
    if let Some((entry, back)) = block.call
        && let (Some(inner), Some(back)) = (passages[entry], passages[back])
    {
        ways = either(ways, Some(inner.then(back)));
    }
    ways
}

/// A set of the scalars of a batch, one bit each.
pub(super) type Scalars = u64;

/// The bit of a scalar that nothing touches: wherever a run comes, it comes there unassigned.
const UNTOUCHED: Scalars = 1 << 63;
/// Number of others that a batch can hold.
const CAPACITY: usize = 63;

/// Accesses of a node to the scalars of a batch.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Touch {
    /// The node.
    pub(super) node: NodeId,
    /// The scalars that it reads, before it assigns any.
    pub(super) read: Scalars,
    /// The scalars that it assigns.
    pub(super) set: Scalars,
}

/// A scalar at a node.
#[derive(Clone, Copy)]
struct Access {
    node: NodeId,
    scalar: usize,
    assigns: bool,
}

/// Every read and assignment of a program, in the order of a run through each node.
pub(super) struct Touches {
    all: Vec<Access>,
}

/// Some scalars, and what the nodes do with them.
#[derive(Default)]
pub(super) struct Sorted {
    /// The scalars, by their bits.
    pub(super) scalars: Vec<usize>,
    /// In the order of the nodes.
    pub(super) touches: Vec<Touch>,
}

impl Touches {
    /// Collects what the nodes of a program's flow read and assign.
    pub(super) fn of(program: &Program, flow: &Flow) -> Self {
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
        Touches { all }
    }

    /// Returns the touches of one scalar, at bit 0.
    pub(super) fn of_scalar(&self, scalar: usize) -> Vec<Touch> {
        let mut sorted = Sorted::default();
        for access in self.all.iter().filter(|access| access.scalar == scalar) {
            sorted.add(*access, 1);
        }
        sorted.touches
    }

    /// Returns the scalars that a block reads before it assigns them, in batches of 63, with all their touches; one
    /// batch at least. And the reads of all others, which find a value wherever a run comes.
    pub(super) fn sorted(
        &self,
        scalars: usize,
        blocks: &Blocks,
    ) -> (Vec<Sorted>, Vec<(NodeId, usize)>) {
        let places = self.exposed(scalars, blocks);
        let mut batches = vec![Sorted::default()];
        let mut certain = Vec::new();
        for access in &self.all {
            match places[access.scalar] {
                Some(place) => {
                    batches.resize_with(batches.len().max(place / CAPACITY + 1), Sorted::default);
                    batches[place / CAPACITY].add(*access, 1 << (place % CAPACITY));
                }
                None if access.assigns => {}
                None => certain.push((access.node, access.scalar)),
            }
        }
        for (scalar, place) in places.iter().enumerate() {
            if let Some(place) = place {
                let names = &mut batches[place / CAPACITY].scalars;
                names.resize(names.len().max(place % CAPACITY + 1), 0);
                names[place % CAPACITY] = scalar;
            }
        }
        (batches, certain)
    }

    /// Numbers those scalars that some block reads before it assigns them.
    fn exposed(&self, scalars: usize, blocks: &Blocks) -> Vec<Option<usize>> {
        let mut places: Vec<Option<usize>> = vec![None; scalars];
        let mut touched_in: Vec<Option<BlockId>> = vec![None; scalars];
        let mut count = 0;
        for access in &self.all {
            let block = Some(blocks.of_node(access.node));
            let was_touched = std::mem::replace(&mut touched_in[access.scalar], block) == block;
            if !access.assigns && !was_touched && places[access.scalar].is_none() {
                places[access.scalar] = Some(count);
                count += 1;
            }
        }
        places
    }
}

impl Sorted {
    fn add(&mut self, access: Access, bit: Scalars) {
        if self
            .touches
            .last()
            .is_none_or(|last| last.node != access.node)
        {
            self.touches.push(Touch {
                node: access.node,
                ..Touch::default()
            });
        }
        if let Some(touch) = self.touches.last_mut() {
            match access.assigns {
                true => touch.set |= bit,
                false => touch.read |= bit,
            }
        }
    }
}

/// The index of a block. Blocks come in the order of their nodes.
pub(super) type BlockId = usize;

/// Ways out of the last node of a block.
#[derive(Clone, Debug)]
pub(super) struct Block {
    /// Blocks that may follow without a call or return.
    pub(super) next: Vec<BlockId>,
    /// The block of a subroutine that it may call, and the one where that comes back.
    pub(super) call: Option<(BlockId, BlockId)>,
    /// It ends with RETURN or SUBEND.
    pub(super) returns: bool,
}

/// The blocks of a flow.
#[derive(Clone, Debug)]
pub(super) struct Blocks {
    all: Vec<Block>,
    of_node: Vec<BlockId>,
    /// The blocks that name a block in `next` or `call`: those of block `b` are
    /// `before[before_ends[b - 1]..before_ends[b]]`.
    before: Vec<BlockId>,
    before_ends: Vec<usize>,
}

impl Blocks {
    /// Splits a flow into blocks. Takes time and memory linear in its length.
    pub(super) fn of(flow: &Flow) -> Self {
        let nodes = flow.nodes();
        let begins = beginnings(flow);
        let mut of_node = Vec::with_capacity(nodes.len());
        let mut count: BlockId = 0;
        for begins in &begins {
            count += usize::from(*begins);
            of_node.push(count - 1);
        }
        let mut all: Vec<Block> = Vec::with_capacity(count);
        for end in 1..=nodes.len() {
            if begins.get(end) == Some(&false) {
                continue;
            }
            let last = &nodes[end - 1];
            all.push(Block {
                next: last.next.iter().map(|next| of_node[*next]).collect(),
                call: last
                    .call
                    .map(|call| (of_node[call.entry], of_node[call.back])),
                returns: last.returns,
            });
        }
        let (before, before_ends) = before(&all);
        Blocks {
            all,
            of_node,
            before,
            before_ends,
        }
    }

    /// Returns the blocks in order.
    pub(super) fn all(&self) -> &[Block] {
        &self.all
    }

    /// Returns the block that a node is in.
    pub(super) fn of_node(&self, node: NodeId) -> BlockId {
        self.of_node[node]
    }

    /// Returns the blocks that lead or call to a block, or whose calls come back to it.
    pub(super) fn before(&self, block: BlockId) -> &[BlockId] {
        let start = match block.checked_sub(1) {
            Some(earlier) => self.before_ends[earlier],
            None => 0,
        };
        &self.before[start..self.before_ends[block]]
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

/// Returns the blocks that a block names in `next` or `call`.
fn after(block: &Block) -> impl Iterator<Item = BlockId> {
    let called = block.call.into_iter();
    let called = called.flat_map(|(entry, back)| [entry, back]);
    block.next.iter().copied().chain(called)
}

fn before(all: &[Block]) -> (Vec<BlockId>, Vec<usize>) {
    let mut ends = vec![0; all.len()];
    for next in all.iter().flat_map(after) {
        ends[next] += 1;
    }
    let mut total = 0;
    for end in &mut ends {
        // Where the block's part begins; filling it moves this to its end.
        total += std::mem::replace(end, total);
    }
    let mut before = vec![0; total];
    for (id, block) in all.iter().enumerate() {
        for next in after(block) {
            before[ends[next]] = id;
            ends[next] += 1;
        }
    }
    (before, ends)
}
