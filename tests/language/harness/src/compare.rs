//! An expected trace against an actual one.

/// The line of an expectation that stands for any number of records.
const ANY: &str = "...";

/// Compares `actual` with the records of `expected`, where `...` stands for any number of them, and `*`
/// in the place of a cycle, or of their number, for any.
///
/// # Errors
/// The first expected records that are not there, and what is.
pub fn matches<'a>(expected: &[&'a str], actual: &[&'a str]) -> Result<(), String> {
    let parts: Vec<&[&str]> = expected.split(|line| *line == ANY).collect();
    let (first, rest) = parts
        .split_first()
        .expect("splitting gives one part at least");
    let rest_of_actual = after_start(first, actual)?;
    let Some((last, middle)) = rest.split_last() else {
        return match rest_of_actual {
            [] => Ok(()),
            [extra, ..] => Err(format!("unexpected record:\n  {extra}")),
        };
    };
    let mut remaining = rest_of_actual;
    for part in middle {
        remaining = after_anywhere(part, remaining)?;
    }
    let end = remaining.len().saturating_sub(last.len());
    if after_prefix(last, &remaining[end..]).is_some() {
        Ok(())
    } else {
        Err(difference("at the end", last, &remaining[end..]))
    }
}

fn after_start<'a, 'b>(part: &[&'b str], actual: &'a [&'b str]) -> Result<&'a [&'b str], String> {
    after_prefix(part, actual).ok_or_else(|| {
        difference(
            "at the start",
            part,
            &actual[..part.len().min(actual.len())],
        )
    })
}

fn after_anywhere<'a, 'b>(
    part: &[&'b str],
    actual: &'a [&'b str],
) -> Result<&'a [&'b str], String> {
    (0..=actual.len())
        .find_map(|from| after_prefix(part, &actual[from..]))
        .ok_or_else(|| difference("nowhere found", part, actual))
}

/// Returns the records after `part` at the start of `actual`.
fn after_prefix<'a, 'b>(part: &[&'b str], actual: &'a [&'b str]) -> Option<&'a [&'b str]> {
    let (start, rest) = actual.split_at_checked(part.len())?;
    let same = part.iter().zip(start).all(|(a, b)| is_record(a, b));
    same.then_some(rest)
}

fn is_record(expected: &str, actual: &str) -> bool {
    let any_cycle = ["\"cycle\":", "\"cycles\":"].iter().find_map(|key| {
        let (before, after) = expected.split_once(&format!("{key}*"))?;
        let number = actual.strip_prefix(before)?.strip_prefix(key)?;
        Some(number.trim_start_matches(|c: char| c.is_ascii_digit()) == after)
    });
    any_cycle.unwrap_or(expected == actual)
}

/// Returns the expected and the actual records from the first line that differs.
fn difference(place: &str, expected: &[&str], actual: &[&str]) -> String {
    let same = expected
        .iter()
        .zip(actual)
        .take_while(|(a, b)| is_record(a, b))
        .count();
    let shown = |lines: &[&str]| {
        let lines: Vec<String> = lines
            .iter()
            .skip(same)
            .take(5)
            .map(|line| format!("  {line}"))
            .collect();
        lines.join("\n")
    };
    format!(
        "{place}, expected:\n{}\nfound:\n{}",
        shown(expected),
        shown(actual)
    )
}
