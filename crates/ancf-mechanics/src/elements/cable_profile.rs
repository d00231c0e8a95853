use nalgebra::Vector3;

use crate::kinematics::{AxialStretch, BeamShape, Bend, gauss, gauss2, gauss3, gauss4, lobatto3};

/// Quadrature rule of a cable element for the strains ε and K.
///
/// A bent cubic has axial strain between its points. More axial points therefore make a coarse mesh stiffer in bending
/// (membrane locking). None of the rules causes spurious zero-energy modes.
/// Source: Gerstmayr & Irschik (2008); the rules are those of `useReducedOrderIntegration` = 0, 1, 2 of EXUDYN's
/// cables.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CableRule {
    /// Five and three Gauss points: degrees 9 and 5.
    #[default]
    Full,
    /// Four and two Gauss points: degrees 7 and 3.
    Reduced,
    /// Three Lobatto points (both nodes and the middle) and two Gauss points: degrees 3 and 3.
    ///
    /// This rule has the least locking. Axial forces are most accurate at the three points.
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

/// Rigidities and mass of a cable section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CableSection {
    /// Axial rigidity EA > 0, force.
    pub axial: f64,
    /// Bending rigidity EI ≥ 0, force × length², equal about all axes.
    pub bending: f64,
    /// Mass per length ρA.
    pub line_density: f64,
}

/// Damping of a cable.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CableDamping {
    /// Retardation time τ of the axial force EA (ε + τ ε̇).
    pub stretch: f64,
    /// Retardation time τ of the moment EI (κ + τ κ°).
    pub bending: f64,
    /// Factor α of the force α M v, 1/time: drag of the medium, not invariant under a moving frame.
    pub mass: f64,
}

/// Weights of the vectors (r₁, ℓ r_x₁, r₂, ℓ r_x₂) at one point of the line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CableStation {
    /// Quadrature weight times the length of the element.
    pub weight: f64,
    /// Weights in r′.
    pub first: [f64; 4],
    /// Weights in r″.
    pub second: [f64; 4],
}

impl CableStation {
    fn new(shape: BeamShape, xi: f64, w: f64) -> Self {
        Self { weight: w * shape.length, first: shape.axis_gradient(xi), second: shape.axis_curvature(xi) }
    }

    /// Returns r′ of the field x. Positions enter as a difference.
    pub fn first(&self, x: &[Vector3<f64>; 4]) -> Vector3<f64> {
        combine(&self.first, x)
    }

    /// Returns r″ of the field x. Positions enter as a difference.
    pub fn second(&self, x: &[Vector3<f64>; 4]) -> Vector3<f64> {
        combine(&self.second, x)
    }

    /// Returns (r′, r″) of the field x.
    pub fn both(&self, x: &[Vector3<f64>; 4]) -> [Vector3<f64>; 2] {
        [self.first(x), self.second(x)]
    }

    /// Bounds the rounding errors of [`both`](Self::both).
    pub fn rounding(&self, x: &[Vector3<f64>; 4]) -> [f64; 2] {
        let sum = |weights: &[f64; 4]| weights.iter().zip(x).map(|(w, x)| w.abs() * x.norm()).sum::<f64>();
        [f64::EPSILON * sum(&self.first), f64::EPSILON * sum(&self.second)]
    }
}

fn combine(weights: &[f64; 4], x: &[Vector3<f64>; 4]) -> Vector3<f64> {
    (x[2] - x[0]) * weights[2] + x[1] * weights[1] + x[3] * weights[3]
}

/// Common data of all elements of a straight uniform cable: shape, rigidities, inertia, damping and body force.
#[derive(Clone, Debug)]
pub struct CableProfile {
    shape: BeamShape,
    section: CableSection,
    damping: CableDamping,
    gravity: Vector3<f64>,
    axial: Vec<CableStation>,
    /// Places ξ of the axial stations.
    axial_places: Vec<f64>,
    bending: Vec<CableStation>,
    mass: [[f64; 4]; 4],
    first: [f64; 4],
}

impl CableProfile {
    /// Creates the profile of the given shape, section and acceleration of gravity.
    ///
    /// The profile has no damping and is integrated by [`CableRule::Full`].
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
        let (damping, axial, axial_places, bending) =
            (CableDamping::default(), Vec::new(), Vec::new(), Vec::new());
        Self { shape, section, damping, gravity, axial, axial_places, bending, mass, first }
            .with_rule(CableRule::Full)
    }

    /// Sets the damping.
    #[must_use]
    pub fn with_damping(self, damping: CableDamping) -> Self {
        Self { damping, ..self }
    }

    /// Sets the quadrature rule.
    #[must_use]
    pub fn with_rule(self, rule: CableRule) -> Self {
        let stations = |points: Vec<(f64, f64)>| {
            points.into_iter().map(|(xi, w)| CableStation::new(self.shape, xi, w)).collect()
        };
        let axial_places = rule.axial().into_iter().map(|(xi, _)| xi).collect();
        Self { axial: stations(rule.axial()), axial_places, bending: stations(rule.bending()), ..self }
    }

    /// Returns the shape functions.
    pub fn shape(&self) -> BeamShape {
        self.shape
    }

    /// Returns the rigidities and the mass per length.
    pub fn section(&self) -> CableSection {
        self.section
    }

    /// Returns the damping.
    pub fn damping(&self) -> CableDamping {
        self.damping
    }

    /// Returns the acceleration of gravity.
    pub fn gravity(&self) -> Vector3<f64> {
        self.gravity
    }

    /// Returns the compact consistent mass matrix M_ab = ∫ ρA S_a S_b dx of one element, over (r₁, ℓ r_x₁, r₂, ℓ r_x₂).
    pub fn mass(&self) -> &[[f64; 4]; 4] {
        &self.mass
    }

    /// Returns the first moments ∫ ρA S_a dx. The force of gravity on vector a is this times g.
    pub fn first_moments(&self) -> &[f64; 4] {
        &self.first
    }

    /// Returns the quadrature points of the axial strain.
    pub(crate) fn axial(&self) -> &[CableStation] {
        &self.axial
    }

    /// Returns the places ξ of the quadrature points of the axial strain.
    pub(crate) fn axial_places(&self) -> &[f64] {
        &self.axial_places
    }

    /// Returns the quadrature points of the curvature.
    pub(crate) fn bending(&self) -> &[CableStation] {
        &self.bending
    }

    /// Returns the station at any ξ.
    pub(crate) fn station(&self, xi: f64) -> CableStation {
        CableStation::new(self.shape, xi, 0.0)
    }

    /// Returns N = EA (ε + τ ε̇) for the rate of a.
    pub(crate) fn axial_force(&self, stretch: &AxialStretch, rate: &Vector3<f64>) -> f64 {
        let retarded = self.damping.stretch * stretch.tangent.dot(rate);
        self.section.axial * (stretch.strain + retarded)
    }

    /// Returns EI (β + τβ°) for the rates of a and b.
    pub(crate) fn moment(&self, bend: &Bend, rates: &[Vector3<f64>; 2]) -> Vector3<f64> {
        (bend.strain() + bend.rate(rates) * self.damping.bending) * self.section.bending
    }
}
