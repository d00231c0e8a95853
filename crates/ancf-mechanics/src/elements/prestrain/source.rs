use ancf_solver::equations::Local;
use nalgebra::Vector3;
use smallvec::SmallVec;

use crate::functions::Function;

/// Stress-free change of shape of a part of a beam or cable: an axial strain ε⁰ and a curvature κ⁰.
///
/// Both vary linearly along the part, and are multiplied by the load factor and a function of time. The energy of the body is
/// that of the strains less the prescribed ones.
#[derive(Clone, Debug)]
pub struct Prestrain {
    /// Arc lengths of the start and the end of the part.
    pub ends: [f64; 2],
    /// Axial strain ε⁰ at both ends.
    pub strain: [f64; 2],
    /// Curvature κ⁰ at both ends, in the frame of the section: twist about x, bending about y and z.
    pub curvature: [Vector3<f64>; 2],
    /// Function of time.
    pub function: Function,
}

/// Factors of sources with their rates.
pub(super) type Factors = SmallVec<[[f64; 2]; 4]>;

/// Rounding of an arc length, relative to that of an element.
const ROUNDING: f64 = 1e-6;

impl Prestrain {
    /// Returns true if an element from `start` of a length is in the part.
    pub(crate) fn covers(&self, start: f64, length: f64) -> bool {
        let [from, to] = self.ends;
        from <= start + ROUNDING * length && to >= start + (1.0 - ROUNDING) * length
    }

    /// Returns the change of shape at an arc length for the value 1 of the function.
    pub(crate) fn at(&self, s: f64) -> Change {
        let [from, to] = self.ends;
        let part = ((s - from) / (to - from)).clamp(0.0, 1.0);
        let [first, last] = [1.0 - part, part];
        Change {
            strain: self.strain[0] * first + self.strain[1] * last,
            curvature: self.curvature[0] * first + self.curvature[1] * last,
        }
    }

    /// Returns the factor of the change of shape and its rate.
    pub(crate) fn factor(&self, t: f64, load: f64) -> [f64; 2] {
        let function = self.function.at(t);
        [load * function.value, load * function.rate]
    }

    /// Returns the factors of all sources, with their rates, in a state of a term.
    pub(super) fn factors(sources: &[Self], at: &Local<'_>) -> Factors {
        sources.iter().map(|source| source.factor(at.t, at.load)).collect()
    }
}

/// Stress-free change of shape at a section.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Change {
    /// Axial strain.
    pub(crate) strain: f64,
    /// Curvature in the frame of the section.
    pub(crate) curvature: Vector3<f64>,
}

impl Change {
    /// Adds a multiple of another change.
    pub(crate) fn plus(self, other: &Self, factor: f64) -> Self {
        Self {
            strain: self.strain + other.strain * factor,
            curvature: self.curvature + other.curvature * factor,
        }
    }
}

/// Arc lengths of an element.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ElementPlace {
    /// Arc length of the start.
    pub(crate) start: f64,
    /// Length.
    pub(crate) length: f64,
}
