//! The steps of a part of a program.

use tipc::program::StepId;

/// Some steps, in order: runs of neighbours, so that a loop takes no more than what cuts it into pieces.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Steps(Vec<(StepId, StepId)>);

impl Steps {
    /// Creates one step.
    pub(super) fn one(step: StepId) -> Self {
        Steps(vec![(step, step)])
    }

    /// Creates all of those.
    pub(super) fn all<'a>(of: impl IntoIterator<Item = &'a Steps>) -> Self {
        let mut runs: Vec<_> = of.into_iter().flat_map(|steps| &steps.0).copied().collect();
        runs.sort_unstable();
        runs.dedup_by(|next, run| {
            let touches = next.0 <= run.1.saturating_add(1);
            if touches {
                run.1 = run.1.max(next.1);
            }
            touches
        });
        Steps(runs)
    }

    /// Returns the number of runs of neighbours.
    pub(super) fn pieces(&self) -> usize {
        self.0.len()
    }

    /// Returns true if a step is one of them.
    pub fn contains(&self, step: StepId) -> bool {
        let behind = self.0.partition_point(|(first, _)| *first <= step);
        let run = behind.checked_sub(1).map(|place| self.0[place]);
        run.is_some_and(|(_, last)| step <= last)
    }

    /// Returns the last step.
    pub fn last(&self) -> Option<StepId> {
        self.0.last().map(|(_, last)| *last)
    }
}

#[cfg(test)]
mod tests {
    use super::Steps;

    #[test]
    fn neighbours_are_one_run_and_gaps_stay() {
        let some = [7, 1, 2, 3, 9, 2].map(Steps::one);
        let all = Steps::all(&some);
        assert_eq!(all.0, [(1, 3), (7, 7), (9, 9)]);
        let held: Vec<u32> = (0..12).filter(|step| all.contains(*step)).collect();
        assert_eq!(held, [1, 2, 3, 7, 9]);
        assert_eq!((all.last(), Steps::default().last()), (Some(9), None));
        let whole = Steps::all([&all, &Steps(vec![(0, 20)])]);
        assert_eq!(whole.0, [(0, 20)]);
    }
}
