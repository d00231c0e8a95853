//! Contact of bodies with obstacles and with each other.

mod forces;
mod models;
mod search;
