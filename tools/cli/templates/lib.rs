//! The motions of our robot, compiled into this crate.
#![forbid(unsafe_code)]
<<lib_hardware>><<lib_description>><<lib_scene>>
// The whole program: `<<Program>>`, a type like any other. Its errors are compile errors that point into it.
tip_macros::include_tip!(pub "motions/<<motion>>.prg"<<option>>);
