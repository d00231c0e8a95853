use std::sync::Arc;

use ancf_solver::equations::{
    Energy, Inadmissibility, Local, LocalMatrix, LocalStep, Term, Weights, velocity_forces,
};
use nalgebra::{SMatrix, Vector3};

use super::forms::{
    COORDINATES, QUAD_VECTORS, STRAINS, Strains, Vectors, Weighting, bilinear, gradient, interpolate, points,
};
use super::profile::{ShearMedium, ShearProfile, ShearTables, tangents, volumes};
use super::rounding::add_rounding;
use crate::kinematics::relative_rotation;

/// Volume (a_ξ × a_η)·d at a node, relative to the reference, below which an element counts as inverted.
const CRUSHED: f64 = 1e-2;

/// Derivatives of the strains by the coordinates.
type Gradients = SMatrix<f64, STRAINS, COORDINATES>;

/// Shear-deformable shell element of four nodes with the position r and the director d at each.
///
/// Coordinates are the components of r and d minus their reference values. The middle surface and the directors are bilinear, so
/// that the mass matrix is constant. Strains are those of Green and Lagrange, linear over the thickness: membrane strains and
/// curvatures at 2 × 2 points, transverse shear strains at the middles of the edges (ANS), and thickness strains at the nodes
/// (ANS). Five enhanced membrane strains (EAS) are eliminated: the energy is quadratic in them, so that they follow from the
/// strains by a constant matrix. The energy ½ eᵀ K e has a constant K and strains e quadratic in the coordinates.
///
/// Membrane strains and curvatures have the stiffness of plane stress, which prevents Poisson locking. The thickness strain
/// has a stiffness of its own.
///
/// Source: Yamashita, Valkeapää, Jayakumar & Sugiyama (2015), coordinates and ANS; Dvorkin & Bathe (1984), transverse shear;
/// Betsch & Stein (1995), thickness strain; Simo & Rifai (1990), enhanced strains.
#[derive(Clone, Debug)]
pub struct Shell24 {
    coordinates: Vec<usize>,
    tables: Arc<ShearTables>,
    profile: Arc<ShearProfile>,
}

/// Returns the nodal vectors of a slice of coordinates.
pub(crate) fn vectors(x: &[f64]) -> Vectors {
    std::array::from_fn(|i| Vector3::new(x[3 * i], x[3 * i + 1], x[3 * i + 2]))
}

/// State of an element: its strains and their gradients by the nodal vectors.
#[derive(Clone, Debug)]
struct ShearState {
    strains: Strains,
    gradients: Box<Gradients>,
}

impl Shell24 {
    /// Creates elements with common strain forms. Each has 24 coordinates and its nodal vectors r₁, d₁, r₂, d₂, .. in the reference
    /// state, with positions relative to any point. Nodes are in the order of ξ, η = (0, 0), (1, 0), (1, 1), (0, 1).
    pub fn all(
        elements: impl IntoIterator<Item = (Vec<usize>, [Vector3<f64>; QUAD_VECTORS])>,
        medium: &ShearMedium,
    ) -> Vec<Self> {
        let tables = Arc::new(ShearTables::new());
        let element = |(coordinates, reference): (Vec<usize>, _)| {
            let profile = Arc::new(ShearProfile::new(&tables, &reference, medium));
            Self { coordinates, tables: Arc::clone(&tables), profile }
        };
        elements.into_iter().map(element).collect()
    }

    /// Returns the constant data.
    pub fn profile(&self) -> &ShearProfile {
        &self.profile
    }

    /// Returns the strain energy, from the coordinates of the element.
    pub fn strain_energy(&self, q: &[f64]) -> f64 {
        let strains = self.strains(&vectors(q));
        0.5 * strains.dot(&self.stress(&strains))
    }

    /// Computes the strains for displacements of the nodal vectors.
    pub(crate) fn strains(&self, u: &Vectors) -> Strains {
        let profile = &self.profile;
        Strains::from_fn(|k, _| {
            let moved = gradient(&self.tables.forms[k], u);
            (0..QUAD_VECTORS).map(|a| u[a].dot(&(profile.gradients[k][a] + moved[a] * 0.5))).sum()
        })
    }

    fn stress(&self, strains: &Strains) -> Strains {
        *self.profile.stiffness * strains
    }

    fn state(&self, q: &[f64]) -> ShearState {
        let u = vectors(q);
        let (mut strains, mut gradients) = (Strains::zeros(), Box::new(Gradients::zeros()));
        for k in 0..STRAINS {
            let moved = gradient(&self.tables.forms[k], &u);
            for a in 0..QUAD_VECTORS {
                let rest = self.profile.gradients[k][a];
                strains[k] += u[a].dot(&(rest + moved[a] * 0.5));
                (0..3).for_each(|i| gradients[(k, 3 * a + i)] = rest[i] + moved[a][i]);
            }
        }
        ShearState { strains, gradients }
    }

    /// Computes the stresses of a state, with those of the damping.
    fn damped_stress(&self, state: &ShearState, at: &Local<'_>) -> Strains {
        let time = self.profile.medium.retardation;
        let mut strains = state.strains;
        if time != 0.0 {
            strains += rates(state, at.v) * time;
        }
        self.stress(&strains)
    }

    fn mass_times(&self, x: &Vectors) -> Vectors {
        std::array::from_fn(|a| {
            self.profile.mass[a].iter().zip(x).fold(Vector3::zeros(), |sum, (m, x)| sum + x * *m)
        })
    }

    /// Adds forces of stresses, inertia, mass-proportional damping and weight.
    fn add_forces(&self, state: &ShearState, stress: &Strains, at: &Local<'_>, r: &mut [f64]) {
        let profile = &self.profile;
        let forces = state.gradients.transpose() * stress;
        let mut moved = vectors(at.a);
        let damping = profile.medium.mass_damping;
        if damping != 0.0 {
            moved.iter_mut().zip(vectors(at.v)).for_each(|(a, v)| *a += v * damping);
        }
        let inertia = self.mass_times(&moved);
        let weight = profile.medium.gravity * at.load;
        for a in 0..QUAD_VECTORS {
            let own = inertia[a] - weight * profile.first[a];
            (0..3).for_each(|i| r[3 * a + i] += forces[3 * a + i] + own[i]);
        }
    }

    /// Adds `material` times the material stiffness and the stiffness of stresses.
    fn add_stiffness(&self, state: &ShearState, material: f64, stress: &Strains, k: &mut LocalMatrix<'_>) {
        let mut geometric = [[0.0; QUAD_VECTORS]; QUAD_VECTORS];
        for (form, stress) in self.tables.forms.iter().zip(stress) {
            for a in 0..QUAD_VECTORS {
                for b in 0..=a {
                    geometric[a][b] += stress * form[a][b];
                }
            }
        }
        self.add_blocks(&geometric, k);
        if material != 0.0 {
            let product = *self.profile.stiffness * *state.gradients;
            let matrix = state.gradients.transpose() * product;
            for j in 0..COORDINATES {
                let column = k.column_mut(j);
                (j..COORDINATES).for_each(|i| column[i - j] += material * matrix[(i, j)]);
            }
        }
    }

    /// Adds scalar blocks w_ab I.
    fn add_blocks(&self, blocks: &[[f64; QUAD_VECTORS]; QUAD_VECTORS], k: &mut LocalMatrix<'_>) {
        for a in 0..QUAD_VECTORS {
            for b in 0..=a {
                if blocks[a][b] != 0.0 {
                    (0..3).for_each(|i| k.add(3 * a + i, 3 * b + i, blocks[a][b]));
                }
            }
        }
    }

    fn add_tangent(&self, state: &ShearState, stress: &Strains, w: Weights, k: &mut LocalMatrix<'_>) {
        let medium = &self.profile.medium;
        self.add_stiffness(state, w.q + w.v * medium.retardation, &(stress * w.q), k);
        let inertia = w.a + medium.mass_damping * w.v;
        if inertia != 0.0 {
            self.add_blocks(&self.profile.mass.map(|row| row.map(|m| inertia * m)), k);
        }
    }

    /// Computes the stresses of a step. All strains are quadratic in q: B(q_m) Δq are their exact changes, so that mean stresses do
    /// the work of the strain energy.
    ///
    /// Source: Simo & Tarnow (1992).
    fn step_stress(&self, middle: &ShearState, step: &LocalStep<'_>) -> Strains {
        let [before, after] = [&step.from, &step.to].map(|at| self.strains(&vectors(at.q)));
        let [of_before, of_after] = step.shares();
        let time = self.profile.medium.retardation;
        let mut strains = before * of_before + after * of_after;
        if time != 0.0 {
            strains += rates(middle, step.middle.v) * time;
        }
        self.stress(&strains)
    }
}

/// Computes the rates of the strains for rates of the coordinates.
fn rates(state: &ShearState, v: &[f64]) -> Strains {
    *state.gradients * SMatrix::<f64, COORDINATES, 1>::from_column_slice(v)
}

impl Term for Shell24 {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let state = self.state(at.q);
        self.add_forces(&state, &self.damped_stress(&state, at), at, r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (profile, state) = (&*self.profile, self.state(at.q));
        let (moved, v) = (vectors(at.a).map(|a| a.norm()), vectors(at.v).map(|v| v.norm()));
        let mut bound: Weighting = std::array::from_fn(|a| {
            let of = |b: usize| profile.mass[a][b].abs() * (moved[b] + profile.medium.mass_damping * v[b]);
            let weight = (at.load * profile.first[a]).abs() * profile.medium.gravity.norm();
            2.0 * f64::EPSILON * ((0..QUAD_VECTORS).map(of).sum::<f64>() + weight)
        });
        let sizes = vectors(at.q).map(|q| q.norm());
        let stress = self.damped_stress(&state, at);
        add_rounding(&self.tables, profile, [&sizes, &v], (&state.strains, &stress), &mut bound);
        floor.iter_mut().enumerate().for_each(|(i, floor)| *floor += bound[i / 3]);
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let state = self.state(at.q);
        self.add_tangent(&state, &self.damped_stress(&state, at), w, k);
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        let middle = self.state(step.middle.q);
        self.add_forces(&middle, &self.step_stress(&middle, step), &step.middle, r);
    }

    fn average_tangent(&self, step: &LocalStep<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let middle = self.state(step.middle.q);
        self.add_tangent(&middle, &self.step_stress(&middle, step), w, k);
    }

    fn has_stress_prediction(&self) -> bool {
        true
    }

    fn stress_prediction(&self, at: &Local<'_>, from: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let (state, before) = (self.state(at.q), self.state(from.q));
        let change: Vec<f64> = at.q.iter().zip(from.q).map(|(now, then)| now - then).collect();
        let strains = before.strains + rates(&before, &change) - state.strains;
        self.add_stiffness(&state, 0.0, &self.stress(&strains), k);
    }

    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let state = self.state(at.q);
        let stress = self.stress(&rates(&state, by.q));
        self.add_stiffness(&state, 0.0, &stress, k);
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let u = vectors(at.q);
        let x = std::array::from_fn(|a| self.profile.reference[a] + u[a]);
        let is_admissible =
            volumes(&x).iter().zip(&self.profile.volumes).all(|(volume, rest)| *volume > CRUSHED * rest);
        (!is_admissible).then_some(Inadmissibility::InvertedElement)
    }

    fn rotation(&self, from: &Local<'_>, to: &Local<'_>) -> f64 {
        let states = [from, to].map(|at| {
            let u = vectors(at.q);
            let x: Vectors = std::array::from_fn(|a| self.profile.reference[a] + u[a]);
            points().map(|(at, _)| {
                let ([t, s], _) = tangents(at, &x);
                [t, s, interpolate(&bilinear(at)[0], 1, &x)]
            })
        });
        let [before, after] = &states;
        let of = |(a, b): (&[Vector3<f64>; 3], &[Vector3<f64>; 3])| {
            relative_rotation([[a[0], b[0]], [a[1], b[1]], [a[2], b[2]]])
        };
        before.iter().zip(after).map(of).fold(0.0, f64::max)
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let v = vectors(at.v);
        let momentum = self.mass_times(&v);
        let moved =
            self.profile.first.iter().zip(vectors(at.q)).fold(Vector3::zeros(), |sum, (m, q)| sum + q * *m);
        Energy {
            kinetic: 0.5 * momentum.iter().zip(&v).map(|(p, v)| p.dot(v)).sum::<f64>(),
            strain: self.strain_energy(at.q),
            potential: -at.load * self.profile.medium.gravity.dot(&moved),
        }
    }

    fn is_damped(&self) -> bool {
        self.profile.medium.retardation != 0.0 || self.profile.medium.mass_damping != 0.0
    }

    fn damping_forces(&self, at: &Local<'_>, r: &mut [f64]) {
        if self.is_damped() {
            velocity_forces(self, at, r);
        }
    }
}
