//! The fuzzer's dictionaries: the words of the compiler's tables. `TIP_BLESS=1` writes them anew.

use crate::fuzz::fuzzer;
use std::collections::BTreeSet;
use std::{env, fs};
use tipc::description::{KEYS, Part};
use tipc::language::commands::COMMANDS;
use tipc::language::keywords::KEYWORDS;
use tipc::language::reserved::motion_flags;
use tipc::language::{Keyword, flags, functions, inputs};

/// Words of the language outside its tables.
const SIGNS: &[&str] = &[
    "3.1\n",
    "2.0\n",
    "1.1\n",
    ";",
    "//",
    ":",
    "=",
    "+=",
    "-=",
    "*=",
    "/=",
    "==",
    "<>",
    "<=",
    ">=",
    "+",
    "*",
    "%",
    "\\a",
    ".X",
    ".Y",
    ".Z",
    ".J1",
    ".J3",
    "F1",
    "F4",
    "J11",
    "J43",
    "ALL",
    "FLOOR",
    "INIT",
    "-391 201 -190",
    "1E3",
    "-0.5",
    "AND",
    "OR",
    "!",
    "VAR1",
    "POS1",
    "AGL1",
    "%f01%",
    "\r\n",
    "\u{3000}",
    "END\n",
];

/// Words of TOML besides the keys.
const TOML: &[&str] = &[
    "[[",
    "]]",
    "[",
    "]",
    "{",
    "}",
    " = ",
    ",",
    "\"",
    "'''",
    "#",
    "true",
    "inf",
    "nan",
    "1e308",
    "0x7f",
    "[0, 0, 1]",
    "\"-y\"",
    "\"z\"",
    "\"N.m\"",
    "\n",
];

/// Words of URDF.
const URDF: &[&str] = &[
    "<robot name=\"r\">",
    "</robot>",
    "<link name=\"a\"/>",
    "<link name=\"",
    "</link>",
    "<joint name=\"j\" type=\"revolute\">",
    "type=\"continuous\"",
    "type=\"fixed\"",
    "type=\"prismatic\"",
    "</joint>",
    "<parent link=\"",
    "<child link=\"",
    "<origin xyz=\"0 0 0\" rpy=\"0 0 0\"/>",
    "<axis xyz=\"0 0 1\"/>",
    "<limit lower=\"-1\" upper=\"1\" effort=\"5\" velocity=\"2\"/>",
    "<inertial>",
    "<mass value=\"1\"/>",
    "</inertial>",
    "<mimic joint=\"",
    "<inertia ixx=\"1\"",
    "\"/>",
    "nan",
    "1e308",
    "<?xml version=\"1.0\"?>",
];

/// Words of requests to a live run.
const REQUESTS: &[&str] = &[
    "{\"do\":\"play\"}\n",
    "{\"do\":\"pause\"}\n",
    "{\"do\":\"step\",\"cycles\":9}\n",
    "{\"do\":\"step\",\"cycles\":-5}\n",
    "{\"do\":\"go\",\"cycle\":3}\n",
    "{\"do\":\"speed\",\"times\":50}\n",
    "{\"do\":\"event\",\"event\":\"key F\"}\n",
    "{\"do\":\"event\",\"event\":\"key 0x0D\"}\n",
    "{\"do\":\"event\",\"event\":\"halt\"}\n",
    "{\"do\":\"event\",\"event\":\"VR1=8\"}\n",
    "{\"do\":\"event\",\"event\":\"set N=1\"}\n",
    "{\"do\":\"event\",\"event\":\"touch on\"}\n",
    "{\"do\":\"event\",\"event\":\"write fails\"}\n",
    "{\"do\":\"restart\"}\n",
    "{\"do\":\"edit\",\"text\":\"3.1\\nx\\nREM\\nEND\\n\",\"base\":1,\"by\":\"a\"}\n",
    "{\"do\":\"save\"}\n",
    "{\"do\":\"reload\"}\n",
    "{\"do\":\"hover\",\"at\":[3,1]}\n",
    "{\"do\":\"complete\",\"at\":[3,2]}\n",
    "\"id\":7,",
    "1e999",
    "18446744073709551615",
    "-9223372036854775808",
    "\\ud83e\\udd16",
    "\\u6b69",
    "NaN",
];

/// A line of a dictionary of libFuzzer.
fn entry(word: &str) -> String {
    let escape = |byte: u8| match byte {
        b'"' | b'\\' => format!("\\{}", char::from(byte)),
        b' '..=b'~' => char::from(byte).to_string(),
        _ => format!("\\x{byte:02X}"),
    };
    let escaped: String = word.bytes().map(escape).collect();
    format!("\"{escaped}\"\n")
}

fn hold(name: &str, words: impl IntoIterator<Item = String>) {
    let path = fuzzer().join("dictionaries").join(format!("{name}.dict"));
    let words: BTreeSet<String> = words.into_iter().filter(|word| !word.is_empty()).collect();
    let fresh: String = words.iter().map(|word| entry(word)).collect();
    if env::var_os("TIP_BLESS").is_some() {
        fs::write(&path, &fresh).expect("the dictionary can be written");
    }
    let text = fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(text, fresh, "set TIP_BLESS=1 to rewrite {}", path.display());
}

#[test]
fn of_programs() {
    let commands = COMMANDS.iter().flat_map(|command| {
        let old = command.name.strip_prefix("SET_");
        [Some(command.name), command.alias, old]
    });
    let words = commands.flatten();
    let inputs = inputs::named().map(|port| port.to_string());
    let particles = KEYWORDS
        .iter()
        .filter(|row| matches!(row.keyword, Keyword::Then | Keyword::To | Keyword::Step));
    let rest = flags::families()
        .chain(flags::FLAGS.iter().filter_map(|row| row.flag.other_stem()))
        .chain(flags::words())
        .chain(motion_flags())
        .chain(particles.map(|row| row.word))
        .chain(functions::words())
        .chain(SIGNS.iter().copied());
    let words = words.chain(rest).map(str::to_owned).chain(inputs);
    hold("program", words);
}

/// The keys of some tables, and their headers.
fn keys(parts: &[Part]) -> impl Iterator<Item = String> {
    let names = parts.iter().map(|part| part.name().to_owned());
    let keys = KEYS.iter().filter(|key| parts.contains(&key.part));
    let keys = keys.map(|key| format!("{} = ", key.name));
    let headers = names.filter(|name| name.starts_with('['));
    let signs = TOML.iter().map(|sign| (*sign).to_owned());
    headers
        .chain(keys)
        .chain(signs)
        .collect::<Vec<_>>()
        .into_iter()
}

#[test]
fn of_descriptions() {
    hold("description", keys(Part::ALL));
}

#[test]
fn of_scenes() {
    hold("scene", keys(Part::SCENE));
}

#[test]
fn of_requests() {
    hold("requests", REQUESTS.iter().map(|word| (*word).to_owned()));
}

#[test]
fn of_urdf() {
    hold("urdf", URDF.iter().map(|word| (*word).to_owned()));
}
