//! Descriptions of robots that were damaged, by the target of the fuzzer.

use robustness::description::examine;
use tip_runtime::random::Random;

const EXAMPLE: &str = include_str!("../../../../../../tipc/tests/robots/hexapod.toml");

#[test]
fn a_file_that_breaks_off_anywhere() {
    for end in 0..=EXAMPLE.len() {
        examine(&EXAMPLE.as_bytes()[..end]);
    }
}

#[test]
fn bytes_that_were_damaged() {
    let mut random = Random::new(0x9E37_79B9_7F4A_7C15);
    for _ in 0..2000 {
        let mut bytes = EXAMPLE.as_bytes().to_vec();
        for _ in 0..=random.index(4) {
            let at = random.index(bytes.len());
            match random.index(3) {
                0 => bytes[at] = random.index(256) as u8,
                1 => drop(bytes.remove(at)),
                _ => bytes.insert(at, b"[]{}=\",.#\n-9e"[random.index(13)]),
            }
        }
        examine(&bytes);
    }
}

#[test]
fn bytes_out_of_the_blue() {
    let mut random = Random::new(1);
    for length in 0..300 {
        let bytes: Vec<u8> = (0..length).map(|_| random.index(256) as u8).collect();
        examine(&bytes);
        let words = [
            "[", "]", "[[leg]]", "=", "joint", "base", "{", "}", "1e308", "nan", ",", "\n", "\"",
            "'''",
        ];
        let text: Vec<&str> = (0..length)
            .map(|_| words[random.index(words.len())])
            .collect();
        examine(text.concat().as_bytes());
    }
}

#[test]
fn numbers_at_the_edge() {
    for number in [
        "1e6",
        "-1e6",
        "1e-320",
        "-0.0",
        "0x7fffffffffffffff",
        "1e400",
        "+inf",
        "-nan",
        "1_000",
    ] {
        for key in ["turn", "base"] {
            let value = match key {
                "base" => format!("base = [{number}, {number}, {number}]"),
                _ => format!("turn = {number}, base = [0, 0, 0]"),
            };
            one_leg(&value, "{ axis = [1, 1, 1], link = [0, 0, 9] }");
        }
        let joint = format!("{{ axis = [{number}, 0, 1e-300], link = [{number}, 0, 9] }}");
        one_leg("base = [0, 0, 0]", &joint);
    }
}

/// Examines a robot of one leg with one joint.
fn one_leg(base: &str, joint: &str) {
    let text = format!("name = \"test\"\nleg = [{{ {base} }}]\njoint = [{joint}]\n");
    examine(text.as_bytes());
}
