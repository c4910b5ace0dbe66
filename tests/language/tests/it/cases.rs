//! Every language case, one test each.

include!(concat!(env!("OUT_DIR"), "/case_tests.rs"));
