//! Every clause of the language reference is proved by a test that names it, and no test names another.

use tip_tests::clauses::{named_by_tests, of_reference};

#[test]
fn every_clause_is_named_by_a_test() {
    let named = named_by_tests();
    let missing: Vec<String> = of_reference().difference(&named).cloned().collect();
    assert!(missing.is_empty(), "no test names {missing:?}");
}

#[test]
fn every_clause_that_a_test_names_exists() {
    let reference = of_reference();
    let unknown: Vec<String> = named_by_tests().difference(reference).cloned().collect();
    assert!(unknown.is_empty(), "the reference has no {unknown:?}");
}
