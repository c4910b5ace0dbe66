//! Commands whose names are put together in another order, or of other words: `PTP_REL`, `LOG_BEGIN`, `PRINT_VARIABLES`.

use crate::language::Keyword;
use crate::language::commands::COMMANDS;
use std::collections::HashMap;
use std::sync::LazyLock;
use tip_runtime::command::ABSOLUTE;

/// Parts of names that say the same, the first of each as a command has it.
#[rustfmt::skip]
const SAME: &[(&str, &str)] = &[
    ("START", "BEGIN ON RUN"),
    ("STOP", "END OFF FINISH HALT"),
    ("OUTPUT", "PRINT DUMP SHOW WRITE SAVE LIST EXPORT"),
    ("VARIABLES", "VARS VARIABLE VAR"),
    ("REL", "RELATIVE INC INCREMENTAL"),
    ("POSITION", "POS POINT COORD COORDINATES"),
    ("ANGLE", "ANGLES ANG JOINT JOINTS JNT"),
    ("TEACH", "GET READ STORE"),
    (Keyword::Message.word(), "MSG MESS TEXT"),
    ("CLEAR", "CLR CLS ERASE DELETE"),
    ("BUF", "BUFFER KEYBUF"),
    ("FLUSH", "EMPTY"),
    ("INITIAL", "INIT"),
    ("POSTURE", "POSE"),
    ("V", "VEL VELOCITY SPEED"),
    (ABSOLUTE, "ACC ACCEL ACCELERATION"),
    ("MAX", "MAXIMUM"),
    ("FREQ", "FREQUENCY HZ"),
    ("COMPLIANCE", "COMP COMPLIANT"),
    ("INPOS", "INPOSITION"),
    ("DETECT", "FIND SEARCH"),
    ("LAMP", "LED LIGHT"),
];

/// The most parts that a name may have.
const PARTS: usize = 6;

/// Returns the one command that says the same as this word.
pub fn command(word: &str) -> Option<&'static str> {
    /// The commands with the same parts.
    static NAMES: LazyLock<HashMap<Vec<&str>, Vec<&str>>> = LazyLock::new(|| {
        let mut names: HashMap<_, Vec<_>> = HashMap::new();
        for name in COMMANDS.iter().map(|command| command.name) {
            names
                .entry(parts(name).unwrap_or_default())
                .or_default()
                .push(name);
        }
        names
    });
    let parts = parts(word).filter(|parts| parts.len() > 1)?;
    match NAMES.get(&parts)?.as_slice() {
        [name] => Some(name),
        _ => None,
    }
}

/// Returns the parts of a name as commands have them, in order of the alphabet.
fn parts(word: &str) -> Option<Vec<&str>> {
    if word.matches('_').count() >= PARTS {
        return None;
    }
    let mut parts: Vec<&str> = word.split('_').map(part).collect();
    parts.sort_unstable();
    Some(parts)
}

fn part(word: &str) -> &str {
    let is_it = |row: &&(&'static str, &'static str)| row.1.split(' ').any(|one| one == word);
    SAME.iter().find(is_it).map_or(word, |row| row.0)
}

#[cfg(test)]
mod tests {
    use super::{SAME, command};
    use std::collections::HashSet;

    #[test]
    fn another_order_and_other_words_name_a_command() {
        for (word, name) in [
            ("PTP_REL", "REL_PTP"),
            ("PTP_JOINT", "PTP_ANGLE"),
            ("LOG_BEGIN", "LOG_START"),
            ("STOP_LOG", "LOG_STOP"),
            ("PRINT_VARIABLES", "OUTPUT_VARIABLES"),
            ("SET_MAX_SPEED", "SET_V_MAX"),
            ("STOP_ALL", "ALL_STOP"),
            ("CLEAR_MESSAGE", "MESSAGE_CLEAR"),
        ] {
            assert_eq!(command(word), Some(name), "{word}");
        }
        for word in ["PTP", "STOP", "LOG", "LOG_LOG", "PRINT_LOG", "A_B", "_", ""] {
            assert_eq!(command(word), None, "{word}");
        }
    }

    #[test]
    fn no_part_says_two_things() {
        let mut seen = HashSet::new();
        for part in SAME.iter().flat_map(|row| row.1.split(' ')) {
            assert!(seen.insert(part), "{part} twice");
        }
        assert!(SAME.iter().all(|row| !seen.contains(row.0)));
    }
}
