//! The macros: what they make is what a build script makes, token for token.
#![expect(clippy::disallowed_methods, reason = "goldens are files")]

#[path = "../../tip-macros/src/arguments.rs"]
mod arguments;
#[path = "../../tip-macros/src/expand.rs"]
mod expand;
#[path = "../../tip-macros/src/file.rs"]
mod file;
#[path = "../../tip-macros/src/literal.rs"]
mod literal;

use proc_macro2::TokenStream;
use quote::quote;
use std::fs;
use tip_runtime::program::Program;
use tip_tests::{Settings, root, run};

tip_macros::include_tip!("../golden/counting.prg");
tip_macros::include_tip!(pub(crate) "golden/counting.prg" as FromPackage, robot = generic, tip_version = 3.1);
tip_macros::tip!(
    Inline,
    r#"3.1
inline
DEF_VAR N
N = 2
MESSAGE %N%
END"#
);

/// The tokens as a formatted file.
fn formatted(tokens: TokenStream) -> String {
    prettyplease::unparse(&syn::parse2(tokens).unwrap())
}

#[test]
fn macro_and_build_script_make_the_same_tokens() {
    for name in ["counting", "branches", "motion"] {
        let path = format!("../golden/{name}.prg");
        let invoking = root().join("tests/macros.rs");
        let tokens = expand::include_tip(quote!(pub #path), Some(&invoking));
        let generated = fs::read_to_string(root().join(format!("golden/{name}.rs"))).unwrap();
        let generated = formatted(generated.parse().unwrap());
        let formatted = formatted(tokens);
        let (items, tracking) = formatted.split_at(generated.len().min(formatted.len()));
        assert!(items == generated, "{name}:\n{formatted}");
        assert!(
            tracking.starts_with("const _: &[u8] = ::core::include_bytes!("),
            "{tracking}"
        );
    }
}

#[test]
fn invocations_name_robot_and_type() {
    assert_eq!(Counting::new().signature().robot, "titan8");
    assert_eq!(Counting::new().name(), "counting.prg");
    assert_eq!(FromPackage::new().signature().robot, "generic");
    assert_eq!(Inline::new().name(), "Inline");
    assert_eq!(Inline::new().title(), "inline");
}

// clauses: 2.12 2.13 7.35 7.47
#[test]
fn an_included_program_runs() {
    let trace = run(Counting::new(), &Settings::default()).unwrap();
    let said: Vec<&str> = trace
        .lines()
        .filter_map(|line| line.split_once("\"say\":\"")?.1.split_once('"'))
        .map(|(text, _)| text)
        .collect();
    assert_eq!(said, ["{1} makes 1.0", "{2} makes 3.0", "{3} makes 6.0"]);
    assert!(
        trace.ends_with("{\"end\":\"END\",\"cycles\":14}\n"),
        "{trace}"
    );
}
