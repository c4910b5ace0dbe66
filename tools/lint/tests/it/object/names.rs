//! The names of functions and relations in TIP.OBJ.

use super::{check, records};
use tipc::Robot;

// clauses: 9.4 4.5 4.6
#[test]
fn a_function_of_one_operand_gives_the_equation_its_name() {
    const FUNCTIONS: [&str; 11] = [
        "INT", "ABS", "SQRT", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "DEG2RAD", "RAD2DEG",
    ];
    for function in FUNCTIONS {
        let line = format!("B = {function} N");
        let record = format!("EQUAL_{function} NO_TARGET VAR=2.000000 VAR=1.000000");
        check(Robot::Titan8, &[(&line, &record)]);
    }
}

// clauses: 9.4
#[test]
fn a_relation_stands_behind_the_name_of_its_condition() {
    const RELATIONS: [(&str, &str); 6] = [
        ("==", "EQ"),
        ("<>", "NE"),
        (">", "GT"),
        ("<", "LT"),
        (">=", "GE"),
        ("<=", "LE"),
    ];
    for (sign, name) in RELATIONS {
        let program = format!("DEF_VAR N\nN = 1\nAGAIN:\nIF N {sign} 2 GOTO AGAIN:");
        let record =
            format!("IF_GOTO_{name} NO_TARGET VAR=1.000000 CONSTANT=2.000000 LABEL=1.000000");
        assert_eq!(records(Robot::Titan8, &program)[2], record, "{sign}");
    }
}
