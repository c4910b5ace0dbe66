//! Control structure, jumps and declarations.

use super::check;

// clauses: 7.20 6.6
#[test]
fn if_leads_to_a_block_or_a_label() {
    check("IF A<>B GOTO L1:", &["if (A <> B) goto L1"]);
    check("IF KB_HIT GOTO", &["if KB_HIT goto -"]);
    check("IF KB_HIT GOSUB L1:", &["if KB_HIT gosub L1"]);
    check(
        "IF KB_HIT THEN A = 1",
        &["broken OneLineIf", "1:16: Wrong argument"],
    );
    check("IF KB_HIT THEN ; A = 1", &["if KB_HIT then", "set A = 1.0"]);
    check("IF KB_HIT", &["broken If", "1:10: Wrong argument"]);
    check("IF KB_HIT L1:", &["broken Plain", "1:11: Wrong argument"]);
    check(
        "IF KB_HIT CALL L1:",
        &["broken Plain", "1:11: Wrong argument"],
    );
    check("IF KB_HIT GOSUB", &["broken Plain", "1:16: Wrong argument"]);
    check(
        "IF KB_HIT GOTO L1: A = 1",
        &["if KB_HIT goto L1", "1:20: Wrong argument"],
    );
}

// clauses: 7.20
#[test]
fn elseif_needs_its_then() {
    check("ELSEIF A == 1 THEN", &["elseif (A == 1.0)"]);
    check(
        "ELSEIF A == 1",
        &["elseif (A == 1.0)", "1:14: Wrong argument"],
    );
    check("ELSEIF THEN", &["broken ElseIf", "1:8: Wrong argument"]);
}

// clauses: 6.1
#[test]
fn a_jump_names_its_label_with_the_colon() {
    check("GOTO L1:", &["goto L1"]);
    check("GOTO 10:", &["goto 10"]);
    check("goto", &["goto -"]);
    check("GOSUB l1:", &["gosub L1"]);
    check("CALL SUB1:", &["call SUB1"]);
    check("GOTO L1", &["broken Plain", "1:6: Wrong argument"]);
    check("CALL SUB1 X = 1", &["broken Plain", "1:6: Wrong argument"]);
    check("GOTO L1 :", &["broken Plain", "1:8: Wrong argument"]);
    check("GOSUB", &["broken Plain", "1:6: Wrong argument"]);
    check("CALL -5", &["broken Plain", "1:6: Wrong argument"]);
}

// clauses: 6.3
#[test]
fn nothing_stands_behind_a_label() {
    check("GOTO L1: A = 1", &["goto L1", "1:10: Wrong argument"]);
    check("CALL S1: FOO", &["call S1", "1:10: Wrong argument"]);
    check("GOSUB L1: L2:", &["gosub L1", "1:11: Wrong argument"]);
    check("GOTO L1: ; A = 1", &["goto L1", "set A = 1.0"]);
}

// clauses: 7.20
#[test]
fn for_has_two_or_three_operands() {
    check("FOR I=1 TO 3", &["for I 1.0 3.0 -"]);
    check("FOR I = N TO -P.X STEP -1", &["for I N -P.X -1.0"]);
    check("FOR I 1 TO 3", &["broken For", "1:7: Wrong argument"]);
    check("FOR I = 1 3", &["broken For", "1:11: Wrong argument"]);
    check("FOR I = TO 3", &["broken For", "1:9: Wrong argument"]);
    check("FOR I = 1 TO", &["broken For", "1:13: Wrong argument"]);
    check(
        "FOR I = 1 TO 3 STEP",
        &["broken For", "1:20: Wrong argument"],
    );
    check(
        "FOR I = 1 TO 3 4",
        &["for I 1.0 3.0 -", "1:16: Wrong argument"],
    );
    check("FOR 5 = 1 TO 3", &["broken For", "1:5: Wrong argument"]);
    check(
        "FOR I = 1 + 2 TO 3",
        &["broken For", "1:11: Wrong argument"],
    );
    check("FOR I += 1 TO 3", &["broken For", "1:7: Wrong argument"]);
}

// clauses: 7.20
#[test]
fn next_may_name_its_variable() {
    check("NEXT", &["next -"]);
    check("NEXT I", &["next I"]);
    check(
        "NEXT I J",
        &["broken Next", "broken Next", "1:8: Wrong argument"],
    );
    check("NEXT I 5", &["next I", "1:8: Wrong argument"]);
    check("NEXT -I", &["broken Next", "1:6: Wrong argument"]);
    check("NEXT 5", &["broken Next", "1:6: Wrong argument"]);
}

// clauses: 2.1 7.20
#[test]
fn subroutine_declares_one_label() {
    check("SUBROUTINE S1:", &["subroutine S1"]);
    check("SUBROUTINE S1 :", &["subroutine S1"]);
    check("SUBROUTINE S1", &["subroutine S1", "1:12: Wrong argument"]);
    check(
        "SUBROUTINE S1: A = 1",
        &["subroutine S1", "1:16: Wrong argument"],
    );
    check("SUBROUTINE", &["broken Subroutine", "1:11: Wrong argument"]);
}

// clauses: 7.20 7.39
#[test]
fn words_without_arguments_take_none() {
    check("SUBEND", &["subend"]);
    check("RETURN", &["return"]);
    check("EXIT", &["exit"]);
    check("SUBEND S1:", &["subend", "1:8: Wrong argument"]);
    check("RETURN 5", &["return", "1:8: Wrong argument"]);
    check("EXIT 0", &["exit", "1:6: Wrong argument"]);
}

// clauses: 3.1
#[test]
fn declarations_keep_the_names_as_written() {
    check("DEF_VAR A, b  C_1", &["define Var A B C_1"]);
    check("DEF_POS P", &["define Pos P"]);
    check("DEF_JOINT 5Q P.X", &["define Joint 5Q P.X"]);
    check("DEF_VAR", &["define Var ", "1:1: Wrong argument"]);
    check("DEF_VAR A = 5", &["define Var A", "1:11: Wrong argument"]);
}
