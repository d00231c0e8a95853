use nalgebra::Vector3;

use crate::kinematics::{BeamShape, Bend, Stretch, gauss, gauss2, gauss3, gauss4, lobatto3};

/// Where the strains of a cable element are integrated: points for ε and for K.
///
/// A cubic cannot be bent without axial strain between its points: the more axial points, the stiffer a coarse mesh
/// in bending (membrane locking). None of the rules gives the element a spurious motion without energy.
/// Source: Gerstmayr & Irschik (2008); the rules are those of `useReducedOrderIntegration` = 0, 1, 2 of EXUDYN's cables.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CableRule {
    /// Five and three Gauss points: degrees 9 and 5.
    #[default]
    Full,
    /// Four and two Gauss points: degrees 7 and 3.
    Reduced,
    /// Three Lobatto points (both nodes and the middle) and two Gauss points: degrees 3 and 3. Locks least; axial
    /// forces are best at the three points.
    Lobatto,
}

impl CableRule {
    fn axial(self) -> Vec<(f64, f64)> {
        match self {
            Self::Full => gauss().to_vec(),
            Self::Reduced => gauss4().to_vec(),
            Self::Lobatto => lobatto3().to_vec(),
        }
    }

    fn bending(self) -> Vec<(f64, f64)> {
        match self {
            Self::Full => gauss3().to_vec(),
            Self::Reduced | Self::Lobatto => gauss2().to_vec(),
        }
    }
}

/// What of a cable's section matters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CableSection {
    /// Axial rigidity EA > 0, a force.
    pub axial: f64,
    /// Bending rigidity EI ≥ 0, a force times length², the same about all axes.
    pub bending: f64,
    /// Mass per length ρA.
    pub line_density: f64,
}

/// Damping of a cable.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CableDamping {
    /// Retardation time τ of Kelvin and Voigt's material: stress E (strain + τ its rate).
    pub retardation: f64,
    /// Factor α of the force α M v, one over time: drag of the medium, not invariant under a moving frame.
    pub mass: f64,
}

/// Weights of the vectors (r₁, ℓ r_x₁, r₂, ℓ r_x₂) at one point of the line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CableStation {
    /// Quadrature weight times the element's length.
    pub weight: f64,
    /// In r′.
    pub first: [f64; 4],
    /// In r″.
    pub second: [f64; 4],
}

impl CableStation {
    fn new(shape: BeamShape, xi: f64, w: f64) -> Self {
        Self { weight: w * shape.length, first: shape.axis_gradient(xi), second: shape.axis_curvature(xi) }
    }

    /// r′ of the field x; positions enter by their difference only.
    pub fn first(&self, x: &[Vector3<f64>; 4]) -> Vector3<f64> {
        combine(&self.first, x)
    }

    /// r″ of the field x, likewise.
    pub fn second(&self, x: &[Vector3<f64>; 4]) -> Vector3<f64> {
        combine(&self.second, x)
    }

    /// (r′, r″) of the field x.
    pub fn both(&self, x: &[Vector3<f64>; 4]) -> [Vector3<f64>; 2] {
        [self.first(x), self.second(x)]
    }

    /// Bounds of the rounding errors of [`both`](Self::both).
    pub fn rounding(&self, x: &[Vector3<f64>; 4]) -> [f64; 2] {
        let sum = |weights: &[f64; 4]| weights.iter().zip(x).map(|(w, x)| w.abs() * x.norm()).sum::<f64>();
        [f64::EPSILON * sum(&self.first), f64::EPSILON * sum(&self.second)]
    }
}

fn combine(weights: &[f64; 4], x: &[Vector3<f64>; 4]) -> Vector3<f64> {
    (x[2] - x[0]) * weights[2] + x[1] * weights[1] + x[3] * weights[3]
}

/// What all elements of a straight uniform cable share: shape, rigidities, inertia, damping and body force.
#[derive(Clone, Debug)]
pub struct CableProfile {
    shape: BeamShape,
    section: CableSection,
    damping: CableDamping,
    gravity: Vector3<f64>,
    axial: Vec<CableStation>,
    bending: Vec<CableStation>,
    mass: [[f64; 4]; 4],
    first: [f64; 4],
}

impl CableProfile {
    /// Elements of the given shape, section and acceleration of gravity, without damping, integrated by
    /// [`CableRule::Full`].
    pub fn new(shape: BeamShape, section: CableSection, gravity: Vector3<f64>) -> Self {
        let (mut mass, mut first) = ([[0.0; 4]; 4], [0.0; 4]);
        for (xi, w) in gauss() {
            let (values, line) = (shape.axis(xi), w * shape.length * section.line_density);
            for i in 0..4 {
                first[i] += line * values[i];
                for j in 0..4 {
                    mass[i][j] += line * values[i] * values[j];
                }
            }
        }
        let (damping, axial, bending) = (CableDamping::default(), Vec::new(), Vec::new());
        Self { shape, section, damping, gravity, axial, bending, mass, first }.integrated(CableRule::Full)
    }

    /// The same with damping.
    #[must_use]
    pub fn damped(self, damping: CableDamping) -> Self {
        Self { damping, ..self }
    }

    /// The same integrated by another rule.
    #[must_use]
    pub fn integrated(self, rule: CableRule) -> Self {
        let stations = |points: Vec<(f64, f64)>| {
            points.into_iter().map(|(xi, w)| CableStation::new(self.shape, xi, w)).collect()
        };
        Self { axial: stations(rule.axial()), bending: stations(rule.bending()), ..self }
    }

    /// The shape functions.
    pub fn shape(&self) -> BeamShape {
        self.shape
    }

    /// Rigidities and mass per length.
    pub fn section(&self) -> CableSection {
        self.section
    }

    /// Damping.
    pub fn damping(&self) -> CableDamping {
        self.damping
    }

    /// Acceleration of gravity.
    pub fn gravity(&self) -> Vector3<f64> {
        self.gravity
    }

    /// The compact consistent mass matrix M_ab = ∫ ρA S_a S_b dx of one element, over (r₁, ℓ r_x₁, r₂, ℓ r_x₂).
    pub fn mass(&self) -> &[[f64; 4]; 4] {
        &self.mass
    }

    /// ∫ ρA S_a dx: the force of gravity on vector a is this times g.
    pub fn first_moments(&self) -> &[f64; 4] {
        &self.first
    }

    /// Points where the axial strain counts.
    pub(crate) fn axial(&self) -> &[CableStation] {
        &self.axial
    }

    /// Points where the curvature counts.
    pub(crate) fn bending(&self) -> &[CableStation] {
        &self.bending
    }

    /// Any point.
    pub(crate) fn station(&self, xi: f64) -> CableStation {
        CableStation::new(self.shape, xi, 0.0)
    }

    /// N = EA (ε + τ ε̇) for the rate of a.
    pub(crate) fn axial_force(&self, stretch: &Stretch, rate: &Vector3<f64>) -> f64 {
        let retarded = self.damping.retardation * stretch.tangent.dot(rate);
        self.section.axial * (stretch.strain + retarded)
    }

    /// EI (β + τβ°) for the rates of a and b.
    pub(crate) fn moment(&self, bend: &Bend, rates: &[Vector3<f64>; 2]) -> Vector3<f64> {
        (bend.strain() + bend.rate(rates) * self.damping.retardation) * self.section.bending
    }
}
