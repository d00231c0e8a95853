//! Integration tests of the study engine.
#![cfg(test)]

mod engine;
