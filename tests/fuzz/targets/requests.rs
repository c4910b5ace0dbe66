#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| robustness::requests::examine(bytes));
