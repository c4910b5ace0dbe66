//! An expected trace against an actual one.

/// The line of an expectation that stands for any number of records.
const ANY: &str = "...";

/// Whether `actual` has the records of `expected`, where `...` stands for any number of them.
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
    if remaining.ends_with(last) {
        Ok(())
    } else {
        let shown = remaining.len().saturating_sub(last.len());
        Err(difference("at the end", last, &remaining[shown..]))
    }
}

fn after_start<'a, 'b>(part: &[&'b str], actual: &'a [&'b str]) -> Result<&'a [&'b str], String> {
    actual.strip_prefix(part).ok_or_else(|| {
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
        .find_map(|from| actual[from..].strip_prefix(part))
        .ok_or_else(|| difference("nowhere found", part, actual))
}

/// What was expected and what is there, from the first line that differs.
fn difference(place: &str, expected: &[&str], actual: &[&str]) -> String {
    let same = expected
        .iter()
        .zip(actual)
        .take_while(|(a, b)| a == b)
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

#[cfg(test)]
mod tests {
    use super::matches;

    #[test]
    fn dots_stand_for_any_records() {
        for (expected, fits) in [
            (&["a", "b", "c", "d"][..], true),
            (&["a", "...", "d"], true),
            (&["...", "d"], true),
            (&["a", "..."], true),
            (&["...", "b", "...", "d"], true),
            (&["...", "b", "c", "...", "d", "..."], true),
            (&["a", "b", "c", "d", "..."], true),
            (&["a", "b", "c"], false),
            (&["a", "b", "c", "d", "e"], false),
            (&["...", "c"], false),
            (&["b", "..."], false),
            (&["...", "c", "...", "b", "..."], false),
            (&["a", "b", "...", "b", "c", "d"], false),
        ] {
            let actual = ["a", "b", "c", "d"];
            assert_eq!(matches(expected, &actual).is_ok(), fits, "{expected:?}");
        }
    }
}
