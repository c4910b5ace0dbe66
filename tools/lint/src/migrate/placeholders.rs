//! Placeholders of MESSAGE texts before 3.0, which name a VAR by its number.

/// `%fnn%` or `%dnn%`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Placeholder {
    /// Start in the text.
    pub(super) start: usize,
    /// End in the text.
    pub(super) end: usize,
    /// With decimals.
    pub(super) real: bool,
    /// The number of the VAR.
    pub(super) digits: String,
}

/// Returns the old placeholders of a text, from left to right.
pub(super) fn old_placeholders(text: &str) -> Vec<Placeholder> {
    let mut found = Vec::new();
    let mut start = 0;
    while let Some(percent) = text[start..].find('%') {
        start += percent;
        match placeholder(&text[start..]) {
            Some((real, digits)) => {
                let end = start + "%f%".len() + digits.len();
                found.push(Placeholder {
                    start,
                    end,
                    real,
                    digits: digits.to_owned(),
                });
                start = end;
            }
            None => start += 1,
        }
    }
    found
}

fn placeholder(text: &str) -> Option<(bool, &str)> {
    let (word, _) = text.strip_prefix('%')?.split_once('%')?;
    let (real, digits) = match (word.strip_prefix('f'), word.strip_prefix('d')) {
        (Some(digits), _) => (true, digits),
        (None, Some(digits)) => (false, digits),
        (None, None) => return None,
    };
    let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    is_number.then_some((real, digits))
}
