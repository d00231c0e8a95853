//! The native module `ancf._ancf` of the Python package.

mod part;

use pyo3::prelude::*;

#[pymodule]
mod _ancf {
    #[pymodule_export]
    use super::part::{ModelError, check_part};
}
