//! What people look at: the results of a run as a scene, a page around it, and a server for the page.
//!
//! ```text
//!   Recording --scene--> container --page--> one HTML file
//!                            \-----Server--> http://127.0.0.1:port, live
//! ```
//!
//! A [`Recording`] is a model with states and columns of its run. [`Geometry`] says what its bodies look like, as plain data:
//! outlines of sections that are swept along stations. [`scene`] packs geometry, fields, markers and charts into one binary
//! [`container`], which the viewer in the page unpacks.

mod body;
mod chart;
pub mod container;
mod field;
mod file;
mod frame;
mod geometry;
mod instants;
mod link;
mod marker;
mod message;
mod obstacle;
mod outline;
mod pack;
mod page;
mod place;
mod recording;
mod request;
mod response;
mod scene;
mod server;
mod shape;
mod stage;
mod thin;
mod units;

pub use body::{Drawn, Kind};
pub use chart::{Abscissa, Chart, ChartGroup, Charts, Column};
pub use field::{Quantities, Quantity};
pub use geometry::{Geometry, Placement};
pub use outline::Outline;
pub use page::{live_page, page};
pub use recording::{Ending, Frame, Recording};
pub use scene::{BUDGET, scene};
pub use server::{Server, Source, Stop};
pub use units::UnitNames;
