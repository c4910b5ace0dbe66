//! Diagnostic a word's row.

/// The most bytes that a word of the language has.
const LONGEST: usize = 32;

/// The words of a table by their lengths: a lookup compares only those as long as the word sought.
pub(super) struct Index<const N: usize> {
    /// Each word and the number of its row.
    words: [(&'static str, u8); N],
    /// Start of the words of each length.
    starts: [u8; LONGEST + 2],
}

impl<const N: usize> Index<N> {
    /// Builds an index of these words.
    pub(super) const fn of(words: [(&'static str, u8); N]) -> Self {
        let mut starts = [0; LONGEST + 2];
        let mut at = 0;
        while at < N {
            starts[words[at].0.len() + 1] += 1;
            at += 1;
        }
        let mut length = 1;
        while length < starts.len() {
            starts[length] += starts[length - 1];
            length += 1;
        }
        let mut sorted = [("", 0); N];
        let mut free = starts;
        let mut at = 0;
        while at < N {
            let length = words[at].0.len();
            sorted[free[length] as usize] = words[at];
            free[length] += 1;
            at += 1;
        }
        Index {
            words: sorted,
            starts,
        }
    }

    /// Returns the row of a word, whatever its case.
    pub(super) fn find(&self, word: &str) -> Option<usize> {
        let first = word.bytes().next()?;
        let start = *self.starts.get(word.len())?;
        let end = *self.starts.get(word.len() + 1)?;
        let as_long = self.words.get(usize::from(start)..usize::from(end))?;
        as_long
            .iter()
            .find(|(known, _)| {
                let begins = known.bytes().next();
                // Nearly all words are ruled out by their first letter.
                begins.is_some_and(|known| known.eq_ignore_ascii_case(&first))
                    && known.eq_ignore_ascii_case(word)
            })
            .map(|(_, row)| usize::from(*row))
    }
}

#[cfg(test)]
mod tests {
    use super::{Index, LONGEST};

    #[test]
    fn words_are_found_whatever_their_case_and_order() {
        const INDEX: Index<5> = Index::of([("TO", 0), ("END", 1), ("A", 2), ("REM", 3), ("IF", 4)]);
        for (word, row) in [("TO", 0), ("end", 1), ("A", 2), ("Rem", 3), ("iF", 4)] {
            assert_eq!(INDEX.find(word), Some(row), "{word}");
        }
        for word in [
            "",
            "T",
            "TOO",
            "ENDE",
            "B",
            &"A".repeat(LONGEST),
            &"A".repeat(99),
        ] {
            assert_eq!(INDEX.find(word), None, "{word}");
        }
    }
}
