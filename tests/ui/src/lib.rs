//! A crate of its own, so that its test programs build the bare vocabulary and no robot.
#![no_std]
