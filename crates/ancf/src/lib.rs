//! Flexible multibody dynamics on the absolute nodal coordinate formulation (ANCF).
//!
//! A [`Model`] states beams, joints, loads and an analysis in the user's units. [`simulate`](fn@simulate) rewrites it in the units
//! of its [`Scales`], assembles the index-3 equations of motion
//!
//! M a + f(q) + Φ_qᵀ λ = 0,  Φ(q) = 0,
//!
//! integrates them by a generalized-α scheme with Newton's method and the exact tangent, and passes every instant, in the
//! user's units again, to a [`Sink`](record::Sink).
//!
//! Floors, arrows pointing downwards only:
//!
//! ```text
//!            simulate              model -> scaled model -> equations -> states -> rows -> sinks
//!          /    |     \
//!      model  --+    record        what the user states, analyses too; rows of numbers under names
//!        |   analysis   |          Newton, schemes: know equations of motion, no mechanics
//!    mechanics  |       |          elements, markers, constraints: know terms, no analysis
//!          \    |       |
//!  function  system    scales       functions of time; states, terms, assembly, sparse matrices; units
//! ```
//!
//! The cantilever of Kim et al. (2017), dropped under its own weight:
//!
//! ```
//! use ancf::record::Series;
//! use ancf::{Model, simulate};
//!
//! let model = Model::parse(
//!     r#"
//!     gravity = [0, -9.81, 0]
//!     materials.steel = { density = 8030, young = 193e9 }
//!     sections.rod = { kind = "circle", diameter = 0.02 }
//!
//!     [[bodies]]
//!     kind = "beam"
//!     name = "beam"
//!     from = [0, 0, 0]
//!     to = [1, 0, 0]
//!     elements = 2
//!     section = "rod"
//!     material = "steel"
//!
//!     [[joints]]
//!     kind = "clamp"
//!     name = "root"
//!     a = { body = "beam", at = "start" }
//!
//!     [[probes]]
//!     name = "tip"
//!     on = { body = "beam", at = "end" }
//!
//!     [analysis]
//!     kind = "dynamics"
//!     duration = 2.0
//!     step = 1e-3
//!     start = "zero"
//!     "#,
//! )?;
//! let mut series = Series::new();
//! let summary = simulate(&model, &mut series)?;
//! assert!(summary.outcome.is_finished());
//! let tip = series.column("tip.y").ok_or("no such column")?;
//! let mean = tip.iter().sum::<f64>() / tip.len() as f64;
//! assert!((mean - -1.870e-3).abs() < 2e-6); // Kim et al. (2017), table 5, two elements
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod assembly;
mod checking;
pub mod diagnosis;
pub mod errors;
mod failure;
pub mod joints;
pub mod model;
pub mod reading;
pub mod record;
mod results;
mod scaling;
pub mod schema;
mod simulate;
pub mod units;

pub use ancf_solver as solver;
pub use errors::{ModelError, ModelErrors};
pub use model::Model;
pub use results::{Column, Field, Fields, Rows, Station};
pub use simulate::{
    Checkpoint, Error, Extension, Mismatch, Observer, Outcome, Simulation, SimulationBuilder, Summary,
    simulate,
};
pub use units::Scales;

// TEMPORARY FACADE
/// Temporary.
pub mod analysis {
    pub use ancf_solver::dynamics::Adaptive;
    pub use ancf_solver::dynamics::AdaptiveMemory;
    pub use ancf_solver::dynamics::Control;
    pub use ancf_solver::dynamics::Dynamics;
    pub use ancf_solver::dynamics::DynamicsMemory;
    pub use ancf_solver::dynamics::Scheme;
    pub use ancf_solver::dynamics::StepReport;
    pub use ancf_solver::dynamics::Unknown;
    pub use ancf_solver::dynamics::consistent_start;
    pub use ancf_solver::dynamics::consistent_velocities;
    pub use ancf_solver::eigen::Critical;
    pub use ancf_solver::eigen::EigenError;
    pub use ancf_solver::eigen::Mode;
    pub use ancf_solver::eigen::Modes;
    pub use ancf_solver::eigen::Sense;
    pub use ancf_solver::eigen::buckling;
    pub use ancf_solver::eigen::modes;
    pub use ancf_solver::newton::EquilibriumError;
    pub use ancf_solver::newton::Failure;
    pub use ancf_solver::newton::Interrupt;
    pub use ancf_solver::newton::Newton;
    pub use ancf_solver::newton::Report;
    pub use ancf_solver::newton::SolveError;
    pub use ancf_solver::newton::Stop;
    pub use ancf_solver::statics::ArcSteps;
    pub use ancf_solver::statics::Equilibrium;
    pub use ancf_solver::statics::Increments;
    pub use ancf_solver::statics::Left;
    pub use ancf_solver::statics::Limit;
    pub use ancf_solver::statics::Path;
    pub use ancf_solver::statics::PathPoint;
    pub use ancf_solver::statics::Statics;
    pub use ancf_solver::statics::Until;
    pub use ancf_solver::statics::settle;
}
/// Temporary.
pub mod function {
    pub use ancf_mechanics::functions::Expression;
    pub use ancf_mechanics::functions::ExpressionError;
    pub use ancf_mechanics::functions::External;
    pub use ancf_mechanics::functions::ForceFunction;
    pub use ancf_mechanics::functions::Function;
    pub use ancf_mechanics::functions::Instant;
    pub use ancf_mechanics::functions::Integral;
    pub use ancf_mechanics::functions::Table;
}
/// Temporary.
pub mod scales {
    pub use crate::units::Dimension;
    pub use crate::units::Scales;
}
/// Temporary.
pub mod system {
    pub use ancf_solver::equations::Batch;
    pub use ancf_solver::equations::Dependence;
    pub use ancf_solver::equations::Encounters;
    pub use ancf_solver::equations::Energy;
    pub use ancf_solver::equations::EquationsOfMotion;
    pub use ancf_solver::equations::INDEPENDENT;
    pub use ancf_solver::equations::LANES;
    pub use ancf_solver::equations::LOCAL;
    pub use ancf_solver::equations::Lanes;
    pub use ancf_solver::equations::Level;
    pub use ancf_solver::equations::Local;
    pub use ancf_solver::equations::LocalLanes;
    pub use ancf_solver::equations::LocalMatrix;
    pub use ancf_solver::equations::Met;
    pub use ancf_solver::equations::Pair;
    pub use ancf_solver::equations::Power;
    pub use ancf_solver::equations::Scatter;
    pub use ancf_solver::equations::State;
    pub use ancf_solver::equations::System;
    pub use ancf_solver::equations::Term;
    pub use ancf_solver::equations::Weights;
    pub use ancf_solver::equations::all_constraint_rows;
    pub use ancf_solver::equations::constraint_rows;
    pub use ancf_solver::equations::dependences;
    pub use ancf_solver::equations::dissipated;
    pub use ancf_solver::equations::supplied;
    pub use ancf_solver::factor::Course;
    pub use ancf_solver::factor::Factor;
    pub use ancf_solver::factor::Kernel;
    pub use ancf_solver::factor::SingularMatrix;
    pub use ancf_solver::factor::Sparse;
    pub use ancf_solver::sparse::Pattern;
    pub use ancf_solver::sparse::SparseMatrix;
}
/// Temporary.
pub mod mechanics {
    pub use ancf_mechanics::bodies::BeamMesh;
    pub use ancf_mechanics::bodies::Blueprint;
    pub use ancf_mechanics::bodies::Body;
    pub use ancf_mechanics::bodies::Piece;
    pub use ancf_mechanics::bodies::across;
    pub use ancf_mechanics::constraints::Angle;
    pub use ancf_mechanics::constraints::Coincide;
    pub use ancf_mechanics::constraints::Drive;
    pub use ancf_mechanics::constraints::Measure;
    pub use ancf_mechanics::constraints::Part;
    pub use ancf_mechanics::constraints::Perpendicular;
    pub use ancf_mechanics::constraints::Slide;
    pub use ancf_mechanics::constraints::Target;
    pub use ancf_mechanics::constraints::Tie;
    pub use ancf_mechanics::constraints::Wrench;
    pub use ancf_mechanics::contact::BeamContact;
    pub use ancf_mechanics::contact::BeamContacts;
    pub use ancf_mechanics::contact::ContactLaw;
    pub use ancf_mechanics::contact::Form;
    pub use ancf_mechanics::contact::Obstacle;
    pub use ancf_mechanics::contact::ObstacleContact;
    pub use ancf_mechanics::contact::ObstacleContacts;
    pub use ancf_mechanics::contact::Skin;
    pub use ancf_mechanics::elements::Beam24;
    pub use ancf_mechanics::elements::Beam27;
    pub use ancf_mechanics::elements::Cable12;
    pub use ancf_mechanics::elements::CableDamping;
    pub use ancf_mechanics::elements::CableProfile;
    pub use ancf_mechanics::elements::CableRule;
    pub use ancf_mechanics::elements::CableSection;
    pub use ancf_mechanics::elements::Element;
    pub use ancf_mechanics::elements::Formulation;
    pub use ancf_mechanics::elements::Law;
    pub use ancf_mechanics::elements::Medium;
    pub use ancf_mechanics::elements::Profile;
    pub use ancf_mechanics::elements::RigidBody;
    pub use ancf_mechanics::elements::Station;
    pub use ancf_mechanics::elements::StrainEnergy;
    pub use ancf_mechanics::elements::is_inertia;
    pub use ancf_mechanics::fluid::Fluid;
    pub use ancf_mechanics::fluid::Hull;
    pub use ancf_mechanics::fluid::Morison;
    pub use ancf_mechanics::forces::ExternalForce;
    pub use ancf_mechanics::forces::FollowerForce;
    pub use ancf_mechanics::forces::Force;
    pub use ancf_mechanics::forces::Friction;
    pub use ancf_mechanics::forces::Moment;
    pub use ancf_mechanics::forces::Spring;
    pub use ancf_mechanics::forces::Strut;
    pub use ancf_mechanics::kinematics::Attachment;
    pub use ancf_mechanics::kinematics::BeamShape;
    pub use ancf_mechanics::kinematics::Curve;
    pub use ancf_mechanics::kinematics::Directions;
    pub use ancf_mechanics::kinematics::ElementAxis;
    pub use ancf_mechanics::kinematics::Interpolation;
    pub use ancf_mechanics::kinematics::Kind;
    pub use ancf_mechanics::kinematics::Marker;
    pub use ancf_mechanics::kinematics::NodalVector;
    pub use ancf_mechanics::kinematics::Node;
    pub use ancf_mechanics::kinematics::QuadraticShape;
    pub use ancf_mechanics::kinematics::Spline;
    pub use ancf_mechanics::kinematics::gauss;
    pub use ancf_mechanics::kinematics::gauss2;
    pub use ancf_mechanics::kinematics::gauss3;
    pub use ancf_mechanics::sections::CrossSection;
    pub use ancf_mechanics::sections::Directors;
    pub use ancf_mechanics::sections::Lame;
    pub use ancf_mechanics::sections::Moments;
    pub use ancf_mechanics::sections::NeoHookean;
    pub use ancf_mechanics::sections::SectionLaw;
    pub use ancf_mechanics::sections::SectionPoint;
    pub use ancf_mechanics::sections::Stiffness;
    pub use ancf_mechanics::*;
}
