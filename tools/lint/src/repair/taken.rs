//! Which stretches of a text are to be changed already.

use std::collections::BTreeMap;
use tipc::diagnostic::Edit;

/// The starts and ends of stretches that do not touch.
#[derive(Debug, Default)]
pub(super) struct Taken(BTreeMap<usize, usize>);

impl Taken {
    /// Takes the stretches of some edits, unless one of them touches what is taken.
    pub(super) fn take(&mut self, edits: &[Edit]) -> bool {
        let is_free = edits.iter().all(|edit| self.is_free(edit));
        if is_free {
            let stretches = edits.iter().map(|edit| (edit.span.start, edit.span.end));
            self.0.extend(stretches);
        }
        is_free
    }

    fn is_free(&self, edit: &Edit) -> bool {
        let before = self.0.range(..=edit.span.end).next_back();
        before.is_none_or(|(_, end)| *end < edit.span.start)
    }
}

#[cfg(test)]
mod tests {
    use super::Taken;
    use tipc::diagnostic::Edit;
    use tipc::source::Span;

    #[test]
    fn edits_that_touch_are_not_taken_together() {
        let edit = |start, end| Edit::remove(Span::new(start, end));
        let mut taken = Taken::default();
        assert!(taken.take(&[edit(10, 12), edit(20, 20)]));
        for touches in [
            edit(10, 12),
            edit(11, 11),
            edit(8, 10),
            edit(9, 30),
            edit(12, 15),
            edit(20, 20),
            edit(19, 20),
        ] {
            assert!(!taken.take(&[edit(40, 41), touches.clone()]), "{touches:?}");
        }
        assert!(taken.take(&[edit(13, 19), edit(40, 41)]));
        assert!(!taken.take(&[edit(41, 41)]));
        assert!(taken.take(&[edit(0, 9)]));
    }
}
