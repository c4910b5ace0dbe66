//! The nearest known name for a misspelt one.

use strsim::osa_distance;

/// Maximum number of candidates: a suggestion must not cost more than the check.
const CANDIDATES: usize = 500;

/// Maximum length of a word that something is suggested for: the time grows with the square of the length.
const MAX_WORD: usize = 80;

/// Returns the candidate nearest to `word`, if it is near enough to be meant.
pub fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    nearest_of(word, candidates, 0)
}

/// Returns the label nearest to `word`. Labels are few, so that one with the same two first letters may differ more.
pub(crate) fn nearest_label<'a>(
    word: &str,
    labels: impl IntoIterator<Item = &'a str>,
) -> Option<&'a str> {
    let labels: Vec<&str> = labels.into_iter().take(CANDIDATES).collect();
    nearest(word, labels.iter().copied()).or_else(|| {
        let start = word.get(..2).filter(|_| word.len() > 3)?;
        let alike = labels.into_iter().filter(|label| label.starts_with(start));
        nearest_of(word, alike, 1)
    })
}

/// Returns the candidate nearest to `word`. It may differ in `more` letters than usual.
fn nearest_of<'a>(
    word: &str,
    candidates: impl IntoIterator<Item = &'a str>,
    more: usize,
) -> Option<&'a str> {
    let candidates: Vec<&str> = candidates.into_iter().take(CANDIDATES).collect();
    let mut alike = candidates.iter().copied().filter(|it| looks_like(word, it));
    if let Some(alike) = alike.next() {
        return Some(alike);
    }
    // Nearly every short name is near to a word of one or two letters.
    if word.len() < 3 || word.len() > MAX_WORD {
        return None;
    }
    let allowed = 1 + word.len() / 5 + more;
    candidates
        .into_iter()
        .filter(|candidate| candidate.len().abs_diff(word.len()) <= allowed)
        .map(|candidate| (osa_distance(word, candidate), candidate))
        .filter(|(distance, _)| *distance <= allowed)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate)
}

/// Returns true if a word differs from another one in one letter, or in the order of two.
pub(crate) fn is_near(word: &str, other: &str) -> bool {
    word.len().abs_diff(other.len()) <= 1 && osa_distance(word, other) == 1
}

/// Returns the digit that a letter looks like; other characters stay.
pub(crate) fn digit_like(letter: char) -> char {
    match letter {
        'O' => '0',
        'I' | 'L' => '1',
        other => other,
    }
}

/// Returns true if two names differ only in letters that look like digits: `L1` and `LI`, `NO` and `N0`.
fn looks_like(a: &str, b: &str) -> bool {
    let same = || a.chars().map(digit_like).eq(b.chars().map(digit_like));
    a != b && a.len() == b.len() && a.len() <= MAX_WORD && same()
}

#[cfg(test)]
mod tests {
    use super::{nearest, nearest_label};

    #[test]
    fn suggests_the_nearest_name() {
        let known = ["PTP", "REL_PTP", "WAIT_INPOS", "SLEEP"];
        assert_eq!(nearest("WAIT_INPSO", known), Some("WAIT_INPOS"));
        assert_eq!(nearest("SLEP", known), Some("SLEEP"));
        assert_eq!(nearest("PPT", known), Some("PTP"));
        assert_eq!(nearest("GRASP", known), None);
        assert_eq!(nearest("B", ["A", "C"]), None);
        assert_eq!(nearest("N2", ["N1"]), None);
        assert_eq!(nearest("N12", ["N11"]), Some("N11"));
        // Names that look alike are suggested at any length.
        assert_eq!(nearest("LI", ["N1", "L1"]), Some("L1"));
        assert_eq!(nearest("FL", ["F1"]), Some("F1"));
        assert_eq!(nearest("O", ["0"]), Some("0"));
        assert_eq!(nearest("LI", ["LI"]), None);
        let long = |letters: usize| "N".repeat(letters);
        assert!(nearest(&long(80), [long(79).as_str()]).is_some());
        assert_eq!(nearest(&long(81), [long(80).as_str()]), None);
    }

    #[test]
    fn a_label_with_the_same_start_may_differ_in_another_letter() {
        assert_eq!(nearest("LOPE", ["LOOP"]), None);
        assert_eq!(nearest_label("LOPE", ["LOOP"]), Some("LOOP"));
        assert_eq!(nearest_label("ROPE", ["LOOP"]), None);
        assert_eq!(nearest_label("LOST", ["LOOP"]), Some("LOOP"));
        assert_eq!(nearest_label("L12", ["L34"]), None);
    }

    #[test]
    fn longer_words_may_differ_in_more_letters() {
        let known = ["ABCDEFGHIJ"];
        assert_eq!(nearest("XYZDEFGHIJ", known), Some("ABCDEFGHIJ"));
        assert_eq!(nearest("XYZWEFGHIJ", known), None);
        let known = ["ABCDEFGHI"];
        assert_eq!(nearest("XYCDEFGHI", known), Some("ABCDEFGHI"));
        assert_eq!(nearest("XYZDEFGHI", known), None);
        let known = ["ABCDE"];
        assert_eq!(nearest("XYCDE", known), Some("ABCDE"));
        assert_eq!(nearest("XYZDE", known), None);
        let known = ["ABCD"];
        assert_eq!(nearest("XBCD", known), Some("ABCD"));
        assert_eq!(nearest("XYCD", known), None);
    }

    #[test]
    fn the_nearest_is_named_and_the_first_of_equals() {
        assert_eq!(nearest("ABCDE", ["XYCDE", "XBCDE"]), Some("XBCDE"));
        assert_eq!(nearest("ABCDE", ["XBCDE", "AXCDE"]), Some("XBCDE"));
    }
}
