//! Bytes as a formula in t: read, and evaluated at some times.
#![no_main]

#[path = "../../crates/ancf/tests/it/common/anything.rs"]
mod anything;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| anything::expression(bytes));
