//! Files for ParaView and PyVista: one XML unstructured grid (`.vtu`) per frame, and collections (`.pvd`) with their times.
//!
//! | file | content |
//! |---|---|
//! | `sections.pvd`, `sections/00000.vtu`, … | closed surfaces: swept sections, shells with their thickness, boxes of rigid bodies, octahedra of point masses |
//! | `lines.pvd`, `lines/00000.vtu`, … | axes as polylines, centres as points |
//! | `shells.pvd`, `shells/00000.vtu`, … | middle surfaces of shells as quads; only if there are shells |
//! | `obstacles.pvd`, `obstacles/00000.vtu`, … | obstacles of contacts; one file if no obstacle moves |
//!
//! Flexible bodies have four stations per element (in each direction of shells), or eight if a body has few elements. Large models have fewer.
//!
//! A [`Writer`] takes frames one at a time and keeps none of them. Every file is written under another name and renamed, the
//! collections last, so that a collection refers to complete files only.

mod array;
mod collection;
mod frame_times;
mod grid;
mod mesh;
mod obstacle;
mod point_data;
mod provenance;
mod rates;
mod station_values;
mod surfaces;
mod writer;

pub use crate::run::FrameSelection;
pub use writer::{Writer, Written};
