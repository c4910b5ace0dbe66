//! docs/robots.md holds the keys of descriptions, and an example that is a file of the tests.

use crate::reference::tables::replace;
use crate::reference::{hold, read};
use std::fmt::Write as _;
use tipc::description::Part;

#[test]
fn keys_and_example_are_those_of_the_compiler_and_its_tests() {
    let text = read("docs/robots.md");
    let example = read("tipc/tests/robots/hexapod.toml");
    let fresh = replace(&text, "example", &format!("\n```toml\n{example}```\n\n"));
    let fresh = replace(&fresh, "keys", &keys(Part::ALL));
    let fresh = replace(&fresh, "scenes", &keys(Part::SCENE));
    hold("docs/robots.md", &text, &fresh);
}

fn keys(parts: &[Part]) -> String {
    let mut table = String::from(
        "\n| where | key | value | without it | what it says |\n|---|---|---|---|---|\n",
    );
    for part in parts {
        let place = match part {
            Part::Robot | Part::Scene => "top".to_owned(),
            part => format!("`{}`", part.name()),
        };
        for key in part.keys() {
            let default = key.default.unwrap_or("must be there");
            let (name, form, meaning) = (key.name, key.form.english, key.meaning.english);
            let _ = writeln!(
                table,
                "| {place} | `{name}` | {form} | {default} | {meaning} |"
            );
        }
    }
    table + "\n"
}
