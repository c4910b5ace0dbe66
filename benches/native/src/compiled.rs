//! The motions, compiled by tipc.

include!(concat!(env!("OUT_DIR"), "/walk_loop.rs"));
include!(concat!(env!("OUT_DIR"), "/steps100.rs"));
include!(concat!(env!("OUT_DIR"), "/steps1000.rs"));
include!(concat!(env!("OUT_DIR"), "/steps10000.rs"));
