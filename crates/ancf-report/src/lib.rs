//! Reports of runs: scenes, HTML pages with a viewer, a local server, and files for ParaView.
//!
//! ```text
//!   serve     paraview      HTTP server of a live page; .vtu and .pvd files
//!        \   /    |
//!        scene    |         Recording -> container -> one HTML file
//!       /  |  \   |
//!  charts  |  fields        columns of the run; section forces, stress, .. along the bodies
//!      \   |   |
//!      run  geometry        input: model, states, columns; shapes of bodies, joints, loads and obstacles
//! ```
//!
//! A [`Recording`] is a model with states and columns of its run. A [`Geometry`](geometry::Geometry) contains the shapes of its
//! bodies as plain data: outlines of sections that are swept along stations. [`scene`] packs geometry, fields, symbols and
//! charts into one binary [`container`], which the viewer in the page unpacks.
//!
//! ```
//! use ancf::record::Series;
//! use ancf::{Model, Simulation};
//! use ancf_report::{BUDGET, Ending, Recording, Snapshot, page, scene};
//! use ancf_surface::BodySurfaces;
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
//!     // The initial state. An `ancf::Observer` receives all states of a run.
//!     frames: vec![Snapshot { value: 0.0, state: simulation.assembly().initial() }],
//!     series: &series,
//!     summary: vec![("steps".into(), summary.steps.to_string())],
//!     ending: Ending::new(&summary.outcome, &model.analysis),
//!     messages: Vec::new(),
//!     surfaces: &BodySurfaces::default(),
//!     body_errors: Vec::new(),
//!     live: false,
//! };
//! let html = page(&scene(&recording, BUDGET));
//! assert!(html.contains("<title>A stone</title>"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod charts;
pub mod fields;
pub mod geometry;
pub mod paraview;
mod run;
mod scene;
#[cfg(feature = "server")]
mod serve;

pub use run::{Ending, Recording, Snapshot, summary_rows, summary_warnings};
pub use scene::{BUDGET, container, live_page, page, scene, shape_factor};
#[cfg(feature = "server")]
pub use serve::{SceneSource, Server, StopFlag};

/// Colour maps of quantities in JSON, for the browser and for other programs.
pub const COLOUR_MAPS: &str = include_str!("../assets/colour_maps.json");
