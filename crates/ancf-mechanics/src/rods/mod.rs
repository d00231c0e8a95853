//! Exact rods: the ordinary differential equations of Reissner's and Simo's rod, without elements.

mod part;
mod section;
mod string;

pub use part::{Placement, PointLoad, RodLoads, RodPart};
pub use section::{AxialLaw, RodSection};
pub use string::{StringEnd, TautString};
