//! The native module `ancf._ancf`: models come in as Python data, results go out as NumPy arrays.
//!
//! The Python package in `python/ancf` is the public interface.

mod input;
mod results;
mod run;
mod study;

use pyo3::prelude::*;

/// Engine of the package `ancf`; not a public interface.
#[pymodule]
mod _ancf {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::input::{
        Stage, check_part, diagnose, nearest, read, scaled, schema, stages, stages_of_file, substitute,
        to_toml,
    };
    #[pymodule_export]
    use super::results::report::report;
    #[pymodule_export]
    use super::results::scalars::scalar_fields;
    #[pymodule_export]
    use super::results::{ModelGeometry, inertia_box, outline};
    #[pymodule_export]
    use super::run::load::load;
    #[pymodule_export]
    use super::run::pickle::states;
    #[pymodule_export]
    use super::run::{Simulation, States, Stepper};
    #[pymodule_export]
    use super::study::{
        case_layout, check_places, linear_fit, observed_orders, parameter_type, reduce_column,
        sample_probabilities, sobol_points, zip_errors,
    };

    /// Records the process: its forks have other threads.
    #[pymodule_init]
    fn record_process(_module: &Bound<'_, PyModule>) -> PyResult<()> {
        super::input::record_process();
        Ok(())
    }

    /// Version of the engine.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");

    /// Maximum edge of the box of a rigid body, relative to the size of the model.
    #[pymodule_export]
    const BOX_EDGE: f64 = ancf_report::geometry::BOX_EDGE;

    /// Radius of the sphere of a point mass, relative to the size of the model.
    #[pymodule_export]
    const POINT_MASS_RADIUS: f64 = ancf_report::geometry::POINT_MASS_RADIUS;

    /// Colour maps of quantities in JSON.
    #[pymodule_export]
    const COLOUR_MAPS: &str = ancf_report::COLOUR_MAPS;

    /// Fixed columns of the table of a study.
    #[pymodule_export]
    const STUDY_COLUMNS: [&str; 7] = ancf_study::TABLE_COLUMNS;

    /// Maximum number of cases of a study.
    #[pymodule_export]
    const MAX_CASES: usize = ancf_study::MAX_CASES;

    /// Maximum number of dimensions of a Sobol sequence.
    #[pymodule_export]
    const MAX_SOBOL_DIMENSION: usize = ancf_study::MAX_SOBOL_DIMENSION;
}
