//! Conditions.

use super::check;

/// An `IF` that is wrong at `column` and keeps opening its block.
#[track_caller]
fn wrong(condition: &str, column: u32) {
    let place = format!("1:{column}: Wrong argument");
    check(&format!("IF {condition} THEN"), &["broken If", &place]);
}

// clauses: 5.1 1.11
#[test]
fn every_relation_reads_with_and_without_blanks() {
    check("IF A==B THEN", &["if (A == B) then"]);
    check("IF A <> -1 THEN", &["if (A <> -1.0) then"]);
    check("IF A<-1 THEN", &["if (A < -1.0) then"]);
    check("IF -A>B THEN", &["if (-A > B) then"]);
    check("IF P.X<=Q.J1 THEN", &["if (P.X <= Q.J1) then"]);
    check("if a>=b then", &["if (A >= B) then"]);
}

// clauses: 5.1
#[test]
fn flags_stand_alone_or_negated() {
    check("WHILE KB_HIT", &["while KB_HIT"]);
    check("UNTIL !INPOS_F1", &["until !INPOS_F1"]);
    check("UNTIL ! INPOS_F1", &["broken Until", "1:7: Wrong argument"]);
    check("UNTIL -KB_HIT", &["broken Until", "1:7: Wrong argument"]);
    check("UNTIL !", &["broken Until", "1:7: Wrong argument"]);
}

// clauses: 5.1
#[test]
fn relations_of_other_languages_are_read_as_what_was_meant() {
    let fault = "1:6: Wrong argument";
    check("IF A = B THEN", &["if (A == B) then", fault]);
    check("IF A != B THEN", &["if (A <> B) then", fault]);
    check("IF A => B THEN", &["if (A >= B) then", fault]);
    check("IF A < > B THEN", &["if (A <> B) then", fault]);
    check("IF A LE B THEN", &["if (A <= B) then", fault]);
    // So what is wrong after it is found as well.
    check("IF A = B", &["broken If", fault, "1:9: Wrong argument"]);
    // A flag is compared with nothing.
    check("IF KB_HIT = B THEN", &["broken If", "1:11: Wrong argument"]);
}

// clauses: 5.1
#[test]
fn malformed_conditions_are_shown_at_their_place() {
    wrong("A >< B", 7);
    wrong("A ==", 9);
    wrong("== A", 4);
    wrong("A + 1 == B", 6);
    wrong("A == B + 1", 11);
    wrong("5", 4);
    wrong("P.X", 4);
    wrong("", 5);
    check("WHILE", &["broken While", "1:6: Wrong argument"]);
    check(
        "WHILE A == B C",
        &["while (A == B)", "1:14: Wrong argument"],
    );
    check(
        "WHILE A == B == C",
        &["broken While", "1:14: Wrong argument"],
    );
}
