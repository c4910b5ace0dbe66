//! Completion scripts and manual pages.

use crate::support::Folder;

#[test]
fn each_shell_knows_the_commands() {
    let folder = Folder::new("shell-completions");
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let outcome = folder.tip(&["completions", shell]).expect(0);
        for word in ["check", "migrate", "--robot"] {
            let word = if shell == "fish" {
                word.trim_start_matches('-')
            } else {
                word
            };
            assert!(outcome.out.contains(word), "{shell}: {word}");
        }
    }
    folder.tip(&["completions", "csh"]).expect(2);
}

#[test]
#[cfg(unix)]
fn bash_completes_robots_and_their_descriptions() {
    let folder = Folder::new("shell-robots").file("mine.toml", "");
    let script = folder.tip(&["completions", "bash"]).expect(0).out;
    let complete = |word: &str| {
        let ask = format!(
            "COMP_WORDS=(tip run --robot '{word}'); COMP_CWORD=3; _tip tip '{word}' --robot; echo \"${{COMPREPLY[*]}}\""
        );
        let output = std::process::Command::new("bash")
            .args(["-c", &format!("{script}\n{ask}")])
            .current_dir(folder.path(""))
            .output()
            .expect("bash starts");
        String::from_utf8(output.stdout)
            .expect("UTF-8")
            .trim()
            .to_owned()
    };
    assert_eq!(complete("sol"), "solo12");
    assert_eq!(complete("mi"), "mine.toml");
    let fish = folder.tip(&["completions", "fish"]).expect(0).out;
    let line = fish
        .lines()
        .find(|line| line.contains("-l robot ") && line.contains("using_subcommand run"));
    let line = line.expect("run has --robot");
    assert!(line.contains(" -F -a \"titan8"), "{line}");
}

#[test]
fn each_command_has_its_page() {
    let folder = Folder::new("shell-man");
    folder.tip(&["man", "-o", "man1"]).expect(0);
    assert!(folder.read("man1/tip.1").contains("tip\\-check(1)"));
    let page = folder.read("man1/tip-run.1");
    assert!(
        page.contains("\\-\\-robot") && page.contains("Exit status"),
        "{page}"
    );
    // A line of an example stays a line.
    assert!(page.contains(".SH EXTRA\n.nf\nExamples:\n"), "{page}");
}
