//! Equations and their operands.

use super::check;

/// An equation that is wrong at `column`.
#[track_caller]
fn wrong(equation: &str, column: u32) {
    let place = format!("1:{column}: Wrong equation format");
    check(equation, &["broken Plain", &place]);
}

// clauses: 4.1 1.11
#[test]
fn every_assignment_and_operation_reads_with_and_without_blanks() {
    check("A=B", &["set A = B"]);
    check("A = B + C", &["set A = (B + C)"]);
    check("A=B-C", &["set A = (B - C)"]);
    check("a,=,b\t*\tc", &["set A = (B * C)"]);
    check("A=B/C", &["set A = (B / C)"]);
    check(
        "A+=1;A-=1;A*=2;A/=2",
        &[
            "set A += 1.0",
            "set A -= 1.0",
            "set A *= 2.0",
            "set A /= 2.0",
        ],
    );
    check("P.X += Q.J2 / -R.Y", &["set P.X += (Q.J2 / -R.Y)"]);
}

// clauses: 4.1
#[test]
fn the_left_side_is_a_name_without_sign() {
    wrong("-A = 5", 1);
    wrong("5 = A", 1);
    wrong("= 5", 1);
    wrong("* A = 5", 1);
    check("FOO = 5", &["set FOO = 5.0"]);
    check("PTP = 5", &["set PTP = 5.0"]);
}

// clauses: 3.6
#[test]
fn behind_an_operand_minus_is_the_operator() {
    check("A = 5 -3", &["set A = (5.0 - 3.0)"]);
    check("A = B - -C", &["set A = (B - -C)"]);
    check("A = B--C", &["set A = (B - -C)"]);
    check("A = B*-C", &["set A = (B * -C)"]);
    check("A=-B", &["set A = -B"]);
    check("A-=-1", &["set A -= -1.0"]);
    wrong("A = - B", 5);
    wrong("A = B - - C", 9);
}

// clauses: 3.6 4.5
#[test]
fn behind_an_operand_of_a_function_minus_is_a_sign() {
    check("A = ATAN2 B -C", &["set A = ATAN2(B, -C)"]);
    check("A = ATAN2 -B, -2", &["set A = ATAN2(-B, -2.0)"]);
    check("P = ROT_X P -90", &["set P = ROT_X(P, -90.0)"]);
    wrong("A = ATAN2 B-C", 12);
    wrong("A = ATAN2 B - C", 13);
}

// clauses: 3.6
#[test]
fn constants_are_decimal_and_finite() {
    check("A = 5.", &["set A = 5.0"]);
    check("A = .5", &["set A = 0.5"]);
    check("A = 1E3", &["set A = 1000.0"]);
    check("A = 1.5e-3", &["set A = 0.0015"]);
    check("A = 2E+1*3", &["set A = (20.0 * 3.0)"]);
    check("A = 5-3", &["set A = (5.0 - 3.0)"]);
    check("A = +5", &["set A = 5.0"]);
    check("A = 1E308", &["set A = 1e308"]);
    wrong("A = 1E309", 5);
    wrong("A = .", 5);
    wrong("A = 1.2.3", 5);
    wrong("A = 0x10", 5);
    wrong("A = 12AB", 5);
    wrong("A = 1E", 5);
}

// clauses: 3.5
#[test]
fn plus_stands_before_constants_only() {
    check("A = B + +2", &["set A = (B + 2.0)"]);
    wrong("A = +B", 5);
}

// clauses: 3.5
#[test]
fn members_have_one_point() {
    check("A = -p.x", &["set A = -P.X"]);
    wrong("A = P.", 5);
    wrong("A = P.X.Y", 5);
}

// clauses: 4.9
#[test]
fn there_is_one_operation() {
    wrong("A = B + C + D", 11);
    wrong("A = B C", 7);
    wrong("A = B +", 8);
    wrong("A =", 4);
    wrong("A = = B", 5);
    wrong("A = B == C", 7);
    wrong("A = SIN B + 1", 11);
    wrong("A = B + SIN C", 9);
    wrong("A = -SIN C", 5);
    wrong("A = SIN COS C", 9);
    wrong("A = (B + C)", 5);
    wrong("A = SIN(B)", 8);
    wrong("A = B: C = 2", 6);
}

// clauses: 4.4 4.9
#[test]
fn functions_take_the_operands_that_stand_there() {
    check("A = SQRT B", &["set A = SQRT(B)"]);
    check("A += sin -30", &["set A += SIN(-30.0)"]);
    check("A = NORM P Q", &["set A = NORM(P, Q)"]);
    check("A = NORM", &["set A = NORM()"]);
}

// clauses: 8.1
#[test]
fn faulty_arguments_wait_for_the_command_to_be_known() {
    check("PTP F1 10, -20 .5", &["command PTP F1 10.0 -20.0 0.5"]);
    check("FOO A + B", &["command FOO A ?7"]);
    check("GOTOO L1:", &["command GOTOO L1 ?9"]);
    check("PTP F1 10-5", &["command PTP F1 10.0 ?10"]);
    check("PTP F1 - 5", &["command PTP F1 ?8"]);
    check("SLEEP 1E999", &["command SLEEP ?7"]);
    check("PTP HS F1 R 10 0 0", &["command PTP HS F1 R 10.0 0.0 0.0"]);
    check("* 5", &["command * 5.0"]);
    check("5 6", &["command 5 6.0"]);
}
