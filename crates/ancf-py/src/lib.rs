//! The native module `ancf._ancf`: models in as Python data, results out as NumPy arrays. What a user sees is in `python/ancf`.

mod callables;
mod data;
mod follower;
mod load;
mod model;
mod part;
mod report;
mod run;
mod signals;
mod states;

use pyo3::prelude::*;

/// The engine of the package `ancf`; not to be used directly.
#[pymodule]
mod _ancf {
    #[pymodule_export]
    use super::load::load;
    #[pymodule_export]
    use super::model::{diagnose, read, scaled, schema, substitute, to_toml};
    #[pymodule_export]
    use super::part::check_part;
    #[pymodule_export]
    use super::report::report;
    #[pymodule_export]
    use super::run::Simulation;
    #[pymodule_export]
    use super::states::{States, states};

    /// Version of the engine.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
}
