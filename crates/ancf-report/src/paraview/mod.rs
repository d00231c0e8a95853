//! Files for ParaView and PyVista: XML unstructured grids (`.vtu`), one a frame, and collections (`.pvd`) with their times.
//!
//! | file | what |
//! |---|---|
//! | `sections.pvd`, `sections/00000.vtu`, … | closed surfaces: swept sections, boxes of rigid bodies, octahedra of point masses |
//! | `lines.pvd`, `lines/00000.vtu`, … | axes as polylines, centres as points |
//! | `obstacles.pvd`, `obstacles/00000.vtu`, … | what bodies touch; one file if none of them moves |
//!
//! A [`Writer`] takes frames one at a time and keeps none of them. Every file is written beside its place and renamed, the
//! collections last: whoever opens a collection finds whole files.

mod array;
mod clock;
mod collection;
mod fields;
mod grid;
mod mesh;
mod motion;
mod obstacle;
mod selection;
mod solid;
mod tags;
mod writer;

pub use selection::Selection;
pub use writer::{Writer, Written};
