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
fn each_command_has_its_page() {
    let folder = Folder::new("shell-man");
    folder.tip(&["man", "-o", "man1"]).expect(0);
    assert!(folder.read("man1/tip.1").contains("tip\\-check(1)"));
    let page = folder.read("man1/tip-run.1");
    assert!(
        page.contains("\\-\\-robot") && page.contains("Exit status"),
        "{page}"
    );
}
