//! Properties that every term of the equations of motion has.

mod contacts;
mod kind;
mod laws;
mod links;
mod magnet;
mod tied;
mod wet;
