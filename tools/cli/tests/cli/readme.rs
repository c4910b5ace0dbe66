//! The README shows the output of the command.

use crate::support::Folder;
use std::fs;
use std::path::Path;

fn readme() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../README.md");
    fs::read_to_string(path).expect("README.md is part of the repository")
}

#[test]
fn the_program_of_the_readme_compiles_to_the_states_beside_it() {
    let text = readme();
    let blocks: Vec<_> = text
        .split("<pre>")
        .skip(1)
        .filter_map(|rest| rest.split("</pre>").next())
        .map(|block| {
            let text = block.replace("&lt;", "<").replace("&gt;", ">");
            text.replace("&amp;", "&").trim().to_owned()
        })
        .collect();
    let [program, states] = &blocks[..] else {
        panic!("{blocks:#?}")
    };
    let folder = Folder::new("readme").file("swing.prg", program);
    let outcome = folder.tip(&["emit", "rust", "swing.prg"]).expect(0);
    let code = without_indent(&outcome.out);
    assert!(code.contains(&without_indent(states)), "{code}");
    let run = ["run", "swing.prg", "--trace", "-"];
    let outcome = folder.tip(&run).expect(0);
    assert!(outcome.out.contains(r#"{"end":"END","#), "{outcome:#?}");
}

fn without_indent(code: &str) -> String {
    code.lines().map(str::trim).collect::<Vec<_>>().join("\n")
}

/// `.ci/run` takes the two commands from there.
#[test]
fn the_first_code_block_holds_two_cargo_commands() {
    let text = readme();
    let (_, rest) = text.split_once("\n```").expect("a code block");
    let lines: Vec<_> = rest
        .lines()
        .skip(1)
        .take_while(|line| *line != "```")
        .collect();
    assert_eq!(lines.len(), 2, "{lines:?}");
    assert!(
        lines.iter().all(|line| line.starts_with("cargo ")),
        "{lines:?}"
    );
}
