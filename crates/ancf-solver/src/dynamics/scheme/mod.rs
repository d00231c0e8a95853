//! Coefficients of the schemes of time integration.

mod coefficients;

pub use coefficients::SchemeCoefficients;
