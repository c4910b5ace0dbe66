//! Whatever stands at the cursor: answers inside the text, also of wrong programs and of texts that are cut or damaged.

use robustness::editing::examine;
use std::fs;
use std::path::{Path, PathBuf};
use tip_runtime::random::Random;

fn programs(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            programs(&path, found);
        } else if path.extension().is_some_and(|end| end == "prg") {
            found.push(path);
        }
    }
}

fn examples() -> Vec<Vec<u8>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    let mut found = Vec::new();
    for folder in ["examples", "tools/lint/tests/diagnostics"] {
        programs(&root.join(folder), &mut found);
    }
    assert!(found.len() > 100, "{} programs", found.len());
    found.sort();
    let read = |path: &PathBuf| fs::read(path).expect("a readable file");
    found.iter().map(read).collect()
}

#[test]
fn programs_of_the_project_are_answered() {
    for program in examples() {
        examine(&program);
    }
}

#[test]
fn damaged_programs_are_answered() {
    let odd = "歩ｱ\u{1F916}\t\r\n;:%.,-/\u{3000}";
    let odd: Vec<char> = odd.chars().collect();
    let mut random = Random::new(5);
    for program in examples() {
        let mut text: Vec<char> = String::from_utf8_lossy(&program).chars().collect();
        for _ in 0..3 {
            let at = random.index(text.len() + 1);
            text.insert(at, odd[random.index(odd.len())]);
        }
        let kept = text.len() - random.index(text.len() / 2 + 1);
        let text: String = text[..kept].iter().collect();
        examine(text.as_bytes());
    }
}
