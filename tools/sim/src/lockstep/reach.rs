//! What runs reached.

use super::Scout;
use tip_lint::spots::{Place, Spots};
use tipc::program::Program;

/// The most chances that are reported of a run.
const CHANCES: usize = 64;

/// Which spots of a program some run reached.
#[derive(Clone, Debug)]
pub struct Reach {
    spots: Spots,
    seen: Vec<bool>,
    /// Of the present run: what no run before reached.
    new: Vec<usize>,
    chances: Vec<u64>,
}

impl Reach {
    /// None yet.
    pub fn new(program: &Program) -> Self {
        let spots = Spots::of(program);
        let seen = vec![false; spots.all().len()];
        Reach {
            spots,
            seen,
            new: Vec::new(),
            chances: Vec::new(),
        }
    }

    /// The spots of the program.
    pub fn spots(&self) -> &Spots {
        &self.spots
    }

    /// Whether some run reached the spot at this place among all.
    pub fn has(&self, spot: usize) -> bool {
        self.seen.get(spot).copied().unwrap_or_default()
    }

    /// Some run reached this spot; whether it is the first.
    pub fn add(&mut self, spot: usize) -> bool {
        let seen = self.seen.get_mut(spot);
        seen.is_some_and(|seen| !std::mem::replace(seen, true))
    }

    /// What the runs since the last call were the first to come by, by places in [`Spots::all`]; and some cycles whose
    /// step had an edge that no run went along yet, where another input may change the path.
    pub fn take_news(&mut self) -> (Vec<usize>, Vec<u64>) {
        (
            std::mem::take(&mut self.new),
            std::mem::take(&mut self.chances),
        )
    }

    /// Keeps a cycle if its step has an edge that no run went along. Of too many every other one goes.
    fn chance(&mut self, cycle: u64, at: Place) {
        if self.spots.edges(at).all(|edge| self.has(edge)) {
            return;
        }
        if self.chances.len() == CHANCES {
            let mut keep = false;
            self.chances.retain(|_| {
                keep = !keep;
                keep
            });
        }
        self.chances.push(cycle);
    }
}

impl Scout for Reach {
    fn went(&mut self, cycle: u64, from: Place, to: Option<Place>) {
        let edge = to
            .filter(|to| *to != from)
            .and_then(|to| self.spots.edge(from, to));
        for spot in [self.spots.step(from.step), edge].into_iter().flatten() {
            if self.add(spot) {
                self.new.push(spot);
            }
        }
        self.chance(cycle, from);
    }
}
