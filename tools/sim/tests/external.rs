//! Runs on robots that another process simulates: a few lines of shell.
#![cfg(all(unix, feature = "std"))]

mod external {
    mod answers;
    mod ends;
    mod peer;
}
