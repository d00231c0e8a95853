//! The native module `ancf._ancf` of the Python package.

use pyo3::prelude::*;

#[pymodule]
mod _ancf {}
