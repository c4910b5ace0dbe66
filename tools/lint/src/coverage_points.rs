//! Coverage points of programs: the steps, and the edges that leave steps with several of them.

use std::collections::{BTreeSet, HashMap};
use tipc::analysis::flow::{Flow, Node, NodeId};
use tipc::program::{Action, Program, StepId};

/// A step, or an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CoveragePoint {
    /// The step, or the one that the edge leaves.
    pub step: StepId,
    /// Name of the edge, such as `true` or `passed`; none for a step.
    pub way: Option<&'static str>,
}

/// A state of a run between two steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ProgramPoint {
    /// The step that runs next.
    pub step: StepId,
    /// True if it is reached from an IF or ELSEIF that was false.
    pub not_taken: bool,
}

/// The coverage points that the flow of control can reach. An IF has two edges. An ELSEIF has three, since a run that
/// comes from the branch above passes it. A call has one edge for its return, from whichever RETURN. A step with a
/// single successor has no edges.
#[derive(Clone, Debug)]
pub struct CoveragePoints {
    flow: Flow,
    points: Vec<CoveragePoint>,
    /// The coverage points of the steps that can be reached.
    steps: HashMap<StepId, usize>,
    /// Edges of a node, and their points.
    edges: HashMap<NodeId, Vec<(NodeId, usize)>>,
    /// The coverage points of the returns, by the nodes that they come back to.
    returns: HashMap<NodeId, usize>,
}

impl CoveragePoints {
    /// Collects the points of a program: the steps in their order, then the edges in the order of theirs.
    pub fn of(program: &Program) -> Self {
        let mut points = CoveragePoints {
            flow: Flow::of(program),
            points: Vec::new(),
            steps: HashMap::new(),
            edges: HashMap::new(),
            returns: HashMap::new(),
        };
        let live = reached(&points.flow, points.flow.starts(), |node, next| {
            next.extend(node.call.iter().flat_map(|call| [call.entry, call.back]));
        });
        let live = || (0..live.len()).filter(|id| live[*id]);
        for id in live() {
            let step = points.flow.nodes()[id].step;
            if !points.steps.contains_key(&step) {
                let point = points.add(step, None);
                points.steps.insert(step, point);
            }
        }
        for id in live() {
            let node = points.flow.nodes()[id].clone();
            let action = &program.steps()[node.step as usize].action;
            points.add_edges(action, id, &node);
        }
        points
    }

    fn add_edges(&mut self, action: &Action, id: NodeId, node: &Node) {
        let called = node.call.map(|call| call.entry);
        let ways: BTreeSet<NodeId> = node.next.iter().copied().chain(called).collect();
        // Each node of an ELSEIF or ELSE may have only one edge; together they have several.
        let has_two_nodes = action.passed_to().is_some();
        if ways.len() > 1 || has_two_nodes {
            let edges = ways.into_iter().map(|to| {
                let way = self.way(action, node, to);
                (to, self.add(node.step, Some(way)))
            });
            let edges = edges.collect();
            self.edges.insert(id, edges);
        }
        if let Some(call) = node.call {
            let point = self.add(node.step, Some("returned from"));
            self.returns.insert(call.back, point);
        }
    }

    fn add(&mut self, step: StepId, way: Option<&'static str>) -> usize {
        self.points.push(CoveragePoint { step, way });
        self.points.len() - 1
    }

    /// Returns the name of the edge from a node to another one.
    fn way(&self, action: &Action, node: &Node, to: NodeId) -> &'static str {
        let goes_on = to == self.flow.first(node.step + 1);
        match (action, goes_on) {
            _ if node.is_passed => "passed",
            (Action::Else { .. } | Action::For { .. }, true) => "entered",
            (Action::For { .. }, false) => "skipped",
            (Action::Next { .. }, true) => "over",
            (Action::Next { .. }, false) => "repeated",
            (Action::IfGoto { .. } | Action::IfGosub { .. }, goes_on) => truth(!goes_on),
            (_, goes_on) => truth(goes_on),
        }
    }

    /// Returns all of them.
    pub fn all(&self) -> &[CoveragePoint] {
        &self.points
    }

    /// Returns true if some path leads to a step.
    pub fn can_reach(&self, step: StepId) -> bool {
        self.steps.contains_key(&step)
    }

    /// Returns the step that ran, by its index in [`all`](Self::all).
    pub fn step(&self, step: StepId) -> Option<usize> {
        self.steps.get(&step).copied()
    }

    /// Returns the edge that a run went along, by its index in [`all`](Self::all).
    pub fn edge(&self, from: ProgramPoint, to: ProgramPoint) -> Option<usize> {
        let (from, to) = (self.node(from), self.node(to));
        if self.flow.nodes().get(from).is_some_and(|node| node.returns) {
            return self.returns.get(&to).copied();
        }
        let mut edges = self.edges.get(&from)?.iter();
        edges.find(|(end, _)| *end == to).map(|(_, point)| *point)
    }

    /// Returns the edges on from a program point, by their indices in [`all`](Self::all).
    pub fn edges(&self, from: ProgramPoint) -> impl Iterator<Item = usize> {
        let edges = self.edges.get(&self.node(from)).into_iter().flatten();
        edges.map(|(_, point)| *point)
    }

    fn node(&self, ProgramPoint { step, not_taken }: ProgramPoint) -> NodeId {
        let first = self.flow.first(step);
        let has_two = self
            .flow
            .nodes()
            .get(first)
            .is_some_and(|node| node.is_passed);
        first + usize::from(has_two && not_taken)
    }
}

const fn truth(is_true: bool) -> &'static str {
    if is_true { "true" } else { "false" }
}

/// Returns true for each node that a path from `starts` reaches. `more` returns further successors of a node besides
/// its `next`.
pub(crate) fn reached(
    flow: &Flow,
    starts: &[NodeId],
    more: impl Fn(&Node, &mut Vec<NodeId>),
) -> Vec<bool> {
    let mut reached = vec![false; flow.nodes().len()];
    let mut open = starts.to_vec();
    while let Some(id) = open.pop() {
        if let Some(node) = flow.nodes().get(id)
            && !std::mem::replace(&mut reached[id], true)
        {
            open.extend(node.next.iter());
            more(node, &mut open);
        }
    }
    reached
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(statements: &str) -> CoveragePoints {
        let source = format!("3.1\nspots\n{statements}\n");
        let loaded = crate::load("points.prg", source.as_bytes(), &crate::Options::default());
        CoveragePoints::of(&loaded.program.expect("it loads"))
    }

    /// Returns the edges, as step and name.
    fn edges(statements: &str) -> Vec<(StepId, &'static str)> {
        let points = points(statements);
        let edges = points.all().iter();
        edges
            .filter_map(|point| Some((point.step, point.way?)))
            .collect()
    }

    #[test]
    fn each_way_on_from_a_step_with_several_is_an_edge() {
        let branches = "IF KB_HIT THEN\nREM\nELSEIF HALT_REQUEST THEN\nELSE\nREM\nENDIF\nEND";
        assert_eq!(
            edges(branches),
            [
                (0, "true"),
                (0, "false"),
                (2, "passed"),
                (2, "true"),
                (2, "false"),
                (3, "passed"),
                (3, "entered"),
            ]
        );
        let loops = "WHILE KB_HIT\nWEND\nREPEAT\nUNTIL KB_HIT\nL1:\nIF KB_HIT GOTO L1:\nEND";
        let both = |step| [(step, "true"), (step, "false")];
        let found: BTreeSet<_> = edges(loops).into_iter().collect();
        assert_eq!(
            found,
            [both(0), both(3), both(5)].concat().into_iter().collect()
        );
        let counted = "DEF_VAR N, M\nM = 3\nFOR N = 1 TO M\nNEXT\nEND";
        let found: BTreeSet<_> = edges(counted).into_iter().collect();
        let ways = [(1, "entered"), (1, "skipped"), (2, "over"), (2, "repeated")];
        assert_eq!(found, ways.into());
    }

    #[test]
    fn what_constants_decide_is_no_edge() {
        assert_eq!(edges("DEF_VAR N\nFOR N = 1 TO 3\nREM\nNEXT\nEND").len(), 2);
        assert_eq!(edges("IF 1 > 2 THEN\nREM\nENDIF\nEND"), []);
        assert_eq!(edges("IF KB_HIT GOTO L1:\nL1:\nEND"), []);
    }

    #[test]
    fn a_call_has_a_return_edge_and_unreachable_steps_are_no_coverage_points() {
        let program = "GOSUB L1:\nIF KB_HIT GOSUB L1:\nEXIT\nL1:\nRETURN\nEND";
        let points = points(program);
        let returned = |step| CoveragePoint {
            step,
            way: Some("returned from"),
        };
        assert!(points.all().contains(&returned(0)) && points.all().contains(&returned(1)));
        assert!(points.can_reach(4) && !points.can_reach(5));
        assert_eq!(points.step(5), None);
        // A RETURN after the second call returns to the EXIT.
        let at = |step| ProgramPoint {
            step,
            not_taken: false,
        };
        let edge = points.edge(at(4), at(2)).expect("an edge");
        assert_eq!(points.all()[edge], returned(1));
        assert_eq!(points.edge(at(3), at(4)), None);
    }

    #[test]
    fn an_else_is_told_by_how_it_is_reached() {
        let points = points("IF KB_HIT THEN\nELSE\nREM\nENDIF\nEND");
        let place = |step, not_taken| ProgramPoint { step, not_taken };
        let way = |from, to| points.all()[points.edge(from, to).expect("an edge")].way;
        let start = place(0, false);
        assert_eq!(way(start, place(1, false)), Some("true"));
        assert_eq!(way(start, place(1, true)), Some("false"));
        assert_eq!(way(place(1, true), place(2, false)), Some("entered"));
        assert_eq!(way(place(1, false), place(3, false)), Some("passed"));
        assert_eq!(points.edges(start).count(), 2);
    }
}
