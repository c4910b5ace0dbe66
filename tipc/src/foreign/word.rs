//! Words of other languages inside statements: flags, clocks, speeds, G-code.

use crate::language::reserved::POSITION;
use tip_runtime::command::Flag;

/// Returns the flag that another language asks a function for, and true if it is negated: `!kbhit()`.
pub fn flag(text: &str) -> Option<(&'static str, bool)> {
    const KEYS: &str = "KBHIT _KBHIT KEYPRESSED KEY_PRESSED KEYHIT KEY_HIT";
    let (text, is_negated) = match text.strip_prefix('!') {
        Some(rest) => (rest.trim(), true),
        None => (text, false),
    };
    let name = text.strip_suffix("()").unwrap_or(text).trim();
    let is_key = KEYS.split(' ').any(|one| one.eq_ignore_ascii_case(name));
    is_key.then_some((Flag::KbHit.stem(), is_negated))
}

/// Returns true if a function tells the time.
pub fn tells_time(name: &str) -> bool {
    const NAMES: &str = "MILLIS MICROS TIME CLOCK TIC TOC NOW TIMER GETTICKCOUNT TICKS";
    NAMES.split(' ').any(|one| one.eq_ignore_ascii_case(name))
}

/// `G0`, `M30`
pub fn is_g_code(word: &str) -> bool {
    let rest = word.strip_prefix(['G', 'g', 'M', 'm']).unwrap_or_default();
    !rest.is_empty() && rest.bytes().all(|it| it.is_ascii_digit())
}

/// Returns true if a word names a speed; one command sets it for all the motions after it.
pub fn is_speed(word: &str) -> bool {
    const SPEEDS: &str = "V F VEL VELOCITY SPEED FEED";
    SPEEDS.split(' ').any(|one| one.eq_ignore_ascii_case(word))
}

/// `X100`: the number after the name of an axis. A shorter one is rather the end of a name, as in `X1`.
pub fn axis_value(word: &str) -> Option<&str> {
    let value = POSITION.iter().find_map(|axis| word.strip_prefix(axis))?;
    let is_number = value.bytes().all(|it| it.is_ascii_digit() || it == b'.');
    (value.len() > 1 && is_number && value.parse::<f64>().is_ok()).then_some(value)
}
