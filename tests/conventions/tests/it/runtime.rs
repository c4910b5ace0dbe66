//! Rules of ARCHITECTURE.md for the runtime's sources.

use conventions::{Module, modules, root};
use proc_macro2::{TokenStream, TokenTree};
use std::collections::BTreeMap;

fn runtime() -> BTreeMap<Vec<String>, Module> {
    let all = modules(&root().join("tip-runtime/src"));
    assert!(all.len() > 50, "the modules are found");
    all
}

/// Returns true if the code holds a word that `is_meant` accepts; it sees the token before as well.
fn holds(code: TokenStream, is_meant: &dyn Fn(Option<&TokenTree>, &str) -> bool) -> bool {
    let mut before = None;
    code.into_iter().any(|token| {
        let found = match &token {
            TokenTree::Ident(word) => is_meant(before.as_ref(), &word.to_string()),
            TokenTree::Group(group) => holds(group.stream(), is_meant),
            _ => false,
        };
        before = Some(token);
        found
    })
}

/// `'static` is a lifetime, not an item.
fn is_static_item(before: Option<&TokenTree>, word: &str) -> bool {
    let follows_a_quote = matches!(before, Some(TokenTree::Punct(sign)) if sign.as_char() == '\'');
    word == "static" && !follows_a_quote
}

#[test]
fn there_is_no_global_state() {
    let code = |text: &str| text.parse::<TokenStream>().expect("it is Rust");
    assert!(holds(code("fn f() { static N: u8 = 0; }"), &is_static_item));
    assert!(!holds(code("fn f(_: &'static str) {}"), &is_static_item));
    for module in runtime().into_values() {
        assert!(
            !holds(module.tokens, &is_static_item),
            "{}",
            module.path.join("::")
        );
    }
}

/// Modules that use radians: geometry, physics, and the functions DEG2RAD and RAD2DEG.
const IN_RADIANS: [&str; 3] = ["kinematics", "plant", "ops"];

#[test]
fn radians_stay_where_geometry_and_physics_are() {
    let is_radian = |_: Option<&TokenTree>, word: &str| {
        let word = word.to_ascii_lowercase();
        word == "pi" || word.contains("radian") || word == "to_degrees"
    };
    let mut found = 0;
    for module in runtime().into_values() {
        let name = module.path.first().map_or("", String::as_str);
        let has_them = holds(module.tokens, &is_radian);
        assert!(
            !has_them || IN_RADIANS.contains(&name),
            "{}",
            module.path.join("::")
        );
        found += usize::from(has_them);
    }
    assert!(found > 3, "the words are found");
}

/// Modules that read the clock: those that pace a robot.
const WITH_A_CLOCK: &str = "realtime";

#[test]
fn no_wall_clock_is_read_but_to_pace() {
    let is_clock = |_: Option<&TokenTree>, word: &str| word == "Instant" || word == "SystemTime";
    let mut found = 0;
    for module in runtime().into_values() {
        let name = module.path.first().map_or("", String::as_str);
        let has_one = holds(module.tokens, &is_clock);
        assert!(
            !has_one || name == WITH_A_CLOCK,
            "{}",
            module.path.join("::")
        );
        found += usize::from(has_one);
    }
    assert_eq!(found, 1, "the clock is found");
}

#[test]
fn the_interpreter_takes_no_sequencing_from_the_emitter() {
    let sim = modules(&root().join("tools/sim/src"));
    let interpreter = sim
        .into_values()
        .filter(|module| module.path.first().is_some_and(|name| name == "interp"));
    let mut found = 0;
    for module in interpreter {
        let names = |_: Option<&TokenTree>, word: &str| word == "emit" || word == "generated";
        assert!(!holds(module.tokens, &names), "{}", module.path.join("::"));
        found += 1;
    }
    assert!(found > 2, "the interpreter is found");
}

/// Checks that the paths in ARCHITECTURE.md's table of invariants exist.
#[test]
fn the_tests_that_hold_the_invariants_exist() {
    let text = std::fs::read_to_string(root().join("ARCHITECTURE.md")).expect("the page");
    let (_, table) = text
        .split_once("## Invariants and their tests")
        .expect("the table");
    let table = table.split("\n## ").next().unwrap_or_default();
    let named = table.split('`').skip(1).step_by(2);
    let paths: Vec<&str> = named
        .filter(|word| word.contains('/') && !word.contains('*'))
        .collect();
    assert!(paths.len() > 15, "{paths:?}");
    for path in paths {
        assert!(root().join(path).exists(), "{path}");
    }
}
