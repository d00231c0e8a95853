//! Bytes as a model file: read, checked and, if it is small, assembled and run for some steps.
#![no_main]

#[path = "../../crates/ancf/tests/it/common/anything.rs"]
mod anything;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| anything::model(bytes));
