#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| tip_fuzz::urdf::examine(bytes));
