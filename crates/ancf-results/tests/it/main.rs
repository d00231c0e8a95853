//! Tests of the folder of a run: recording, reading, and damaged files.
#![cfg(test)]

mod common;
mod corpus;
mod damage;
mod recording;
