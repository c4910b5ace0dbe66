//! Runs on robots that another process simulates: a few lines of shell.

mod answers;
mod ends;
mod lines;
mod peer;
