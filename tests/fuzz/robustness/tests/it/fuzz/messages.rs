//! The messages of an editor, damaged and out of order.

use robustness::lsp::examine;
use tip_runtime::random::Random;

const SESSION: &str = include_str!("../../../../corpus/lsp/session");

#[test]
fn messages_that_were_damaged() {
    let mut random = Random::new(7);
    for _ in 0..300 {
        let mut bytes = SESSION.as_bytes().to_vec();
        for _ in 0..=random.index(6) {
            let at = random.index(bytes.len());
            match random.index(3) {
                0 => bytes[at] = random.index(256) as u8,
                1 => drop(bytes.remove(at)),
                _ => bytes.insert(at, b"[]{}=\",:\n-9e"[random.index(12)]),
            }
        }
        examine(&bytes);
    }
}

#[test]
fn places_out_of_the_blue() {
    let mut random = Random::new(11);
    for _ in 0..200 {
        let text = SESSION.lines().map(|line| {
            let number = random.index(12).to_string();
            let is_first = line.contains("initialize");
            let line = line
                .replace("14", &number)
                .replace(":99", &format!(":{number}"));
            if is_first {
                line
            } else {
                line.replace(":4", &format!(":{number}"))
            }
        });
        examine(text.collect::<Vec<_>>().join("\n").as_bytes());
    }
}

#[test]
fn messages_out_of_order() {
    let mut random = Random::new(13);
    let lines: Vec<&str> = SESSION.lines().collect();
    for _ in 0..100 {
        let order = (0..40).map(|_| lines[random.index(lines.len() - 1)]);
        let text = [lines[0], lines[2]].into_iter().chain(order);
        examine(text.collect::<Vec<_>>().join("\n").as_bytes());
    }
}
