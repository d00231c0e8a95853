//! Numbers in the lanes of vector registers, and rows of them.

mod lane;
mod rows;

pub(crate) use lane::{
    Lane, LaneNumber, Pass, PassJob, VectorLanes, added, cross, dot, dot_add, minus, plus, run, scaled, total,
};
pub(crate) use rows::{Row, VectorRows, add_products, add_sums, combined, load, of_lane, store};
