//! Kinds of terms by the differentiation of their residual.

use nalgebra::DVector;

use crate::common::sample::{derivative, extrapolated_derivative};

/// Residual as a function of the state, and the part of its derivative that the tangent contains.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum TermKind {
    /// Polynomial of degree three at most.
    Polynomial,
    /// Smooth in moderate deformation.
    Smooth,
    /// Smooth; the tangent is the symmetric part of the derivative.
    Damped,
    /// Smooth, with the forces B(q)ᵀ D B(q) v of retarded strains, B linear in q.
    ///
    /// The tangent omits the change of the strain rates with the displacements, B(q)ᵀ D B(v) dq.
    Retarded,
    /// Smooth forces without potential; the tangent is the symmetric part of the derivative. Only the energy balance holds.
    NonConservative,
    /// Smooth; the tangent is exact for the velocities and incomplete for the coordinates.
    IncompleteStiffness,
}

impl TermKind {
    /// Largest magnitude of the coordinates.
    pub(super) fn amplitude(self) -> f64 {
        if self == Self::Polynomial { 1.0 } else { 0.1 }
    }

    /// Relative error of a numerical derivative.
    pub(super) fn tolerance(self) -> f64 {
        if self == Self::Polynomial { 1e-12 } else { 1e-11 }
    }

    /// Differentiates a function of this kind at zero.
    pub(super) fn derivative(self, f: impl Fn(f64) -> DVector<f64>) -> DVector<f64> {
        if self == Self::Polynomial { derivative(f) } else { extrapolated_derivative(f) }
    }
}
