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
//!
//! ```
//! use ancf::record::Series;
//! use ancf::{Model, Simulation};
//! use ancf_report::{BUDGET, Ending, Frame, Recording, page, scene};
//!
//! let text = r#"
//!     bodies = [{ kind = "mass", name = "stone", center = [0, 0, 10], mass = 1 }]
//!     gravity = [0, 0, -9.81]
//!     analysis = { kind = "dynamics", duration = 1, step = 0.1 }
//! "#;
//! let model = Model::parse(text)?;
//! let simulation = Simulation::new(&model)?;
//! let mut series = Series::new();
//! let summary = simulation.run(&mut series)?;
//! let recording = Recording {
//!     simulation: &simulation,
//!     model: &model,
//!     text,
//!     title: "A stone",
//!     // An `ancf::Observer` receives the states of a run; here there is that of its start.
//!     frames: vec![Frame { value: 0.0, state: simulation.assembly().initial() }],
//!     series: &series,
//!     summary: vec![("steps".into(), summary.steps.to_string())],
//!     ending: Ending::new(&summary.outcome, &model.analysis),
//!     messages: Vec::new(),
//!     live: false,
//! };
//! let html = page(&scene(&recording, BUDGET));
//! assert!(html.contains("<title>A stone</title>"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod body;
mod chart;
pub mod container;
mod fibre;
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
pub mod paraview;
mod place;
mod recording;
mod request;
mod response;
mod scene;
mod server;
mod shape;
mod stage;
mod thin;
mod told;

pub use body::{Drawn, Kind};
pub use chart::{Abscissa, Chart, ChartGroup, Charts, Column};
pub use field::{Quantities, Quantity};
pub use geometry::{Geometry, Placement};
pub use outline::Outline;
pub use page::{live_page, page};
pub use recording::{Ending, Frame, Recording};
pub use scene::{BUDGET, scene};
pub use server::{Server, Source, Stop};
pub use told::{numbers, warnings};
