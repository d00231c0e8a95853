//! Integration tests of the library, one program: its modules share the helpers of [`common`] and are linked once.
//!
//! Tests that need a process of their own are files beside this folder.
// For Clippy, which permits `unwrap` in the helper functions of test code only.
#![cfg(test)]

mod common;

mod contact;
mod dynamics;
mod elements;
mod errors;
mod examples;
mod gradients;
mod invariance;
mod joints;
mod loads;
mod model_files;
mod numerics;
mod runs;
mod sections;
mod stability;
mod statics;
mod stepping;
mod terms;
mod verification;
