//! What runs came by.

use crate::analysis::spots::{Place, Spots};
use crate::program::Program;

/// The most chances that are told of a run.
const CHANCES: usize = 64;

/// Which spots of a program some run came by.
#[derive(Clone, Debug)]
pub struct Reach {
    spots: Spots,
    seen: Vec<bool>,
}

impl Reach {
    /// None yet.
    pub fn new(program: &Program) -> Self {
        let spots = Spots::of(program);
        let seen = vec![false; spots.all().len()];
        Reach { spots, seen }
    }

    /// The spots of the program.
    pub fn spots(&self) -> &Spots {
        &self.spots
    }

    /// Whether some run came by the spot at this place among all.
    pub fn has(&self, spot: usize) -> bool {
        self.seen.get(spot).copied().unwrap_or_default()
    }

    /// Some run came by this spot; whether it is the first.
    pub fn add(&mut self, spot: usize) -> bool {
        let seen = self.seen.get_mut(spot);
        seen.is_some_and(|seen| !std::mem::replace(seen, true))
    }

    /// A step ran and led on, unless it was the last; gives the spots that are new.
    pub(super) fn note(
        &mut self,
        from: Place,
        to: Option<Place>,
    ) -> impl Iterator<Item = usize> + use<> {
        let edge = to
            .filter(|to| *to != from)
            .and_then(|to| self.spots.edge(from, to));
        let spots = [self.spots.step(from.step), edge];
        let new = spots.map(|spot| spot.filter(|spot| self.add(*spot)));
        new.into_iter().flatten()
    }

    /// Keeps a cycle if its step has an edge that no run went along. Of too many every other one goes.
    pub(super) fn chance(&self, cycle: u64, at: Place, chances: &mut Vec<u64>) {
        if self.spots.edges(at).all(|edge| self.has(edge)) {
            return;
        }
        if chances.len() == CHANCES {
            let mut keep = false;
            chances.retain(|_| {
                keep = !keep;
                keep
            });
        }
        chances.push(cycle);
    }
}
