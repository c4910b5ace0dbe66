//! The README shows the output of the command.

use crate::support::Folder;
use std::fs;
use std::path::Path;

fn readme() -> String {
    page("README.md")
}

fn page(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(name);
    fs::read_to_string(path).expect("it is part of the repository")
}

/// The `<pre>` blocks: the program, what it does, and the states that it becomes.
fn shown(text: &str) -> Vec<String> {
    let blocks = text.split("<pre>").skip(1);
    let blocks = blocks.filter_map(|rest| rest.split("</pre>").next());
    blocks
        .map(|block| {
            let text = block.replace("&lt;", "<").replace("&gt;", ">");
            text.replace("&amp;", "&").trim().to_owned()
        })
        .collect()
}

#[test]
fn the_program_of_the_readme_compiles_to_the_states_it_shows() {
    let blocks = shown(&readme());
    let [program, _, states] = &blocks[..] else {
        panic!("{blocks:#?}")
    };
    let folder = Folder::new("readme").file("lift.prg", program);
    let outcome = folder.tip(&["emit", "rust", "lift.prg"]).expect(0);
    let code = without_indent(&outcome.out);
    assert!(code.contains(&without_indent(states)), "{code}");
    let run = ["run", "lift.prg", "--trace", "-"];
    let outcome = folder.tip(&run).expect(0);
    assert!(outcome.out.contains(r#"{"end":"END","#), "{outcome:#?}");
}

/// Both languages show the same program, and the error of a wrong foot in line 6.
#[test]
fn the_error_of_the_readme_is_what_check_reports() {
    for (name, lang) in [("README.md", "en"), ("README.ja.md", "ja")] {
        let text = page(name);
        let program = shown(&text).swap_remove(0);
        assert_eq!(program, shown(&readme()).swap_remove(0));
        let mut lines: Vec<&str> = program.lines().collect();
        let wrong = lines[5].replace("F1", "F5");
        lines[5] = &wrong;
        let folder = Folder::new("readme-error").file("lift.prg", lines.join("\n"));
        let outcome = folder.tip(&["check", "--lang", lang, "lift.prg"]).expect(1);
        let (_, rest) = text.split_once("```text\n").expect("the error");
        let (error, _) = rest.split_once("```").expect("its end");
        assert!(outcome.err.starts_with(error), "{outcome:#?}");
    }
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
