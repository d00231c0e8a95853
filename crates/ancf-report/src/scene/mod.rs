//! Scene of a run as one binary [`container`], and the HTML page around it.

mod builder;
mod clearance;
pub mod container;
mod drawn_frames;
mod entries;
mod frame_label;
mod messages;
mod mode_shape;
mod page;
mod scene_layout;

pub use builder::{BUDGET, scene};
pub(crate) use drawn_frames::fits;
pub(crate) use frame_label::frame_label;
pub(crate) use mode_shape::DisplacedStates;
pub use mode_shape::shape_factor;
#[cfg(feature = "server")]
pub(crate) use page::gzipped;
pub use page::{live_page, page};
pub(crate) use scene_layout::SceneLayout;
