//! Runs on robots that another process simulates: a few lines of shell.
#![cfg(unix)]

mod external {
    mod answers;
    mod ends;
    mod peer;
}
