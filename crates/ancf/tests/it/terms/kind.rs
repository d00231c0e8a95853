//! Kinds of terms, for the laws that they obey.

use nalgebra::DVector;

use crate::common::sample::{derivative, extrapolated_derivative};

/// What kind of function of the state a residual is, and so how its derivative is to be had.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    /// A polynomial of degree three at most.
    Polynomial,
    /// Smooth in moderate deformation.
    Smooth,
    /// Smooth, and its tangent is the symmetric part of the derivative.
    Damped,
    /// Smooth, and of the forces B(q)ᵀ D B(q) v of retarded strains, B linear in q, the tangent leaves out how displacements
    /// change the rates of strain, B(q)ᵀ D B(v) dq.
    Retarded,
    /// Smooth, its tangent the symmetric part of the derivative, of forces that have no potential: only their books hold.
    Supplied,
    /// Smooth, and its tangent is the derivative by the velocities, and one of the coordinates that leaves something out.
    Rubbed,
}

impl Kind {
    /// Coordinates are at most so large.
    pub(crate) fn reach(self) -> f64 {
        if self == Self::Polynomial { 1.0 } else { 0.1 }
    }

    /// Relative error of a derivative.
    pub(crate) fn tolerance(self) -> f64 {
        if self == Self::Polynomial { 1e-12 } else { 1e-11 }
    }

    pub(crate) fn derivative(self, f: impl Fn(f64) -> DVector<f64>) -> DVector<f64> {
        if self == Self::Polynomial { derivative(f) } else { extrapolated_derivative(f) }
    }
}
