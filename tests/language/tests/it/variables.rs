//! The order of variables, which traces and memory images go by.

use tipc::program::VariableKind;

// clauses: 3.1 3.3 9.4
#[test]
fn a_variable_counts_among_those_of_its_type_in_order_of_declaration() {
    let source = "3.1\norder\nDEF_POS P\nDEF_VAR B, A\nB = 1\nA = B\nDEF_JOINT S\nDEF_POS Q\nEND\n";
    let loaded = tipc::load("order.prg", source.as_bytes(), &tipc::Options::default());
    let program = loaded.program.expect("it loads");
    let of_kind = |kind| -> Vec<&str> {
        let variables = program.variables().iter();
        let of_kind = variables.filter(|variable| variable.kind == kind);
        of_kind.map(|variable| variable.name.as_str()).collect()
    };
    assert_eq!(of_kind(VariableKind::Var), ["VAR_KEY", "B", "A"]);
    assert_eq!(of_kind(VariableKind::Pos), ["P", "Q"]);
    assert_eq!(of_kind(VariableKind::Joint), ["S"]);
}
