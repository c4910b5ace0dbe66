//! Random programs on both engines, one test each.

include!(concat!(env!("OUT_DIR"), "/random_tests.rs"));
