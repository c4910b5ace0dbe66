//! Loops of imports are found.

use conventions::{Circle, Module, circles};

/// A crate of modules by their paths and code.
fn found(modules: &[(&str, &str)]) -> Vec<String> {
    let module = |(path, code): &(&str, &str)| {
        let path: Vec<String> = path.split("::").map(str::to_owned).collect();
        let tokens = code.parse().expect("it is Rust");
        (path.clone(), Module { path, tokens })
    };
    let modules = modules.iter().map(module).collect();
    circles(&modules).iter().map(Circle::to_string).collect()
}

#[test]
fn a_loop_of_two_is_found_however_the_names_are_spelled() {
    let a = "use crate::{c::C, b::{B, self}}; fn f() {}";
    let b = "fn f() { crate::a::f(); }";
    let expected = "  a -> b: B\n  a -> b: self\n  b -> a: f\n";
    assert_eq!(found(&[("a", a), ("b", b), ("c", "")]), [expected]);
    let expected = "  a -> a::b: B\n  a::b -> d: D\n  d -> a: A\n";
    let modules = [
        ("a", "fn f(_: b::B) {}"),
        ("a::b", "use super::A; use super::super::d::D;"),
        ("d", "m!(crate::a::A)"),
    ];
    assert_eq!(found(&modules), [expected]);
}

#[test]
fn a_module_that_is_imported_whole_is_an_edge() {
    let modules = [
        ("a", "use super::b; fn f() { b::g() }"),
        ("b", "use crate::a::A;"),
    ];
    assert_eq!(found(&modules), ["  a -> b: self\n  b -> a: A\n"]);
}

#[test]
fn parents_methods_and_foreign_paths_make_no_loop() {
    let modules = [
        ("a", "use b::B; fn f(x: X) { x.c::<T>(); core::d::f(); }"),
        ("a::b", "use super::A;"),
        ("c", "use crate::a::f;"),
        ("d", "use crate::a::f;"),
    ];
    assert_eq!(found(&modules), [""; 0]);
}
