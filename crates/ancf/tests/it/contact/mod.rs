//! Contact of bodies with obstacles and with each other.

mod bounces;
mod cables;
mod crossing;
mod face_sums;
mod faceted_shells;
mod forces;
mod models;
mod mutual_shells;
mod overlaps;
mod rolling;
mod search;
mod shells;
mod surfaces;
