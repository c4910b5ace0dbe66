//! Equations between structs, and functions.

use super::script::Script;
use super::{path, value_of};

// clauses: 4.2 4.3 4.7 4.8
#[test]
fn structs_are_set_member_by_member() {
    for (value, expected) in [
        ("P", [3.0, 0.0, 4.0]),
        ("UNIT_VECT P", [0.6, 0.0, 0.8]),
        ("P - P", [0.0, 0.0, 0.0]),
        ("ROT_Y P 0", [3.0, 0.0, 4.0]),
    ] {
        let statements = format!("P.X = 3\nP.Y = 0\nP.Z = 4\nQ = {value}");
        let (interpreter, _) = path(&statements, &mut Script::default());
        let members = ["Q.X", "Q.Y", "Q.Z"].map(|name| value_of(&interpreter, name));
        assert_eq!(members, expected.map(Some), "{value}");
    }
}

// clauses: 4.4 4.5 4.6
#[test]
fn functions_read_one_operand_and_keep_its_sign() {
    let statements = "A = 2.5\nB = INT -A\nA *= ATAN2 0 -1";
    let (interpreter, _) = path(statements, &mut Script::default());
    assert_eq!(value_of(&interpreter, "B"), Some(-3.0));
    assert_eq!(value_of(&interpreter, "A"), Some(450.0));
}
