//! Contact of bodies.

mod forces;
mod models;
mod search;
