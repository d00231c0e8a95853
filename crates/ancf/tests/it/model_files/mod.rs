//! Model files, their schema and the documentation.

mod corpus;
mod docs;
mod models;
mod parts;
mod plausibility;
mod substitution;
