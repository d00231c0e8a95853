use std::sync::Arc;

use ancf_solver::equations::{
    Energy, Inadmissibility, Local, LocalMatrix, LocalStep, Term, Weights, velocity_forces,
};
use nalgebra::Vector3;

use super::profile::{ShearProfile, reference_point, tangents, volume};
use super::strains::{Fields, Gradients, SURFACE, ShearTables, Strains, Vectors, Weighting, interpolate};
use crate::kinematics::relative_rotation;
use crate::shells::laminates::LocalSection;
use crate::shells::prestrain::{StrainField, StrainedElement};

/// Volume (a_ξ × a_η)·d at a node, relative to the reference, below which an element counts as inverted.
const CRUSHED: f64 = 1e-2;

/// Shear-deformable shell element with the position r and the director d at each node: V nodal vectors, S strains and C = 3 V
/// coordinates.
///
/// Coordinates are the components of r and d minus their reference values. The middle surface and the directors have the same
/// shape functions, so that the mass matrix is constant. Strains are those of Green and Lagrange, linear over the thickness:
/// membrane strains and curvatures at the integration points, transverse shear strains at the middles of the edges (ANS), and
/// thickness strains at the nodes (ANS). Five enhanced membrane strains (EAS) of a quadrilateral are eliminated: the energy is
/// quadratic in them, so that they follow from the strains by a constant matrix. The energy ½ eᵀ K e has a constant K and
/// strains e quadratic in the coordinates. With a [law](crate::shells::MembraneLaw) of the membrane there are no enhanced strains,
/// and the energy of the membrane strains is that of the law at the integration points.
///
/// Membrane strains and curvatures have the stiffness of plane stress, which prevents Poisson locking. The thickness strain
/// has a stiffness of its own.
///
/// Source: Yamashita, Valkeapää, Jayakumar & Sugiyama (2015), coordinates and ANS; Dvorkin & Bathe (1984) and Lee & Bathe (2004),
/// transverse shear; Betsch & Stein (1995), thickness strain; Simo & Rifai (1990), enhanced strains.
#[derive(Clone, Debug)]
pub struct ShearElement<const V: usize, const S: usize, const C: usize> {
    coordinates: Vec<usize>,
    tables: Arc<ShearTables>,
    pub(super) profile: Arc<ShearProfile<V, S>>,
}

/// Quadrilateral element: 6 × 4 strains of the surface, 4 transverse shear strains, 4 thickness strains.
pub type Shell24 = ShearElement<8, 32, 24>;

/// Triangular element: 6 strains of the surface, 3 transverse shear strains, 3 thickness strains.
///
/// Membrane strains are constant, so that it is stiff in its plane. It fills gaps of meshes of quadrilaterals.
pub type Shell18 = ShearElement<6, 12, 18>;

/// Returns the nodal vectors of a slice of coordinates.
fn vectors<const V: usize>(x: &[f64]) -> Vectors<V> {
    std::array::from_fn(|i| Vector3::new(x[3 * i], x[3 * i + 1], x[3 * i + 2]))
}

/// State of an element: its strains and the vectors of its surface.
pub(super) struct ShearState<const S: usize> {
    strains: Strains<S>,
    fields: Fields,
}

impl<const V: usize, const S: usize, const C: usize> ShearElement<V, S, C> {
    /// Creates an element with its coordinates and its nodal vectors r₁, d₁, r₂, d₂, .. in the reference state, with positions
    /// relative to any point.
    pub(super) fn new(
        coordinates: Vec<usize>,
        reference: &Vectors<V>,
        tables: &Arc<ShearTables>,
        (medium, sections): (&super::ShearMedium, Vec<LocalSection>),
    ) -> Self {
        let profile = Arc::new(ShearProfile::new(tables, reference, medium, sections));
        Self { coordinates, tables: Arc::clone(tables), profile }
    }

    /// Returns the strain energy for displacements of the nodal vectors.
    pub(super) fn strain_energy(&self, u: &Vectors<V>) -> f64 {
        self.profile.strain_energy(&self.strains(u))
    }

    /// Computes the strains for displacements of the nodal vectors.
    pub(super) fn strains(&self, u: &Vectors<V>) -> Strains<S> {
        self.tables.strains(&self.profile.fields, &self.tables.fields(u))
    }

    /// Computes the rates of the strains for displacements and velocities of the nodal vectors.
    pub(super) fn strain_rates(&self, u: &Vectors<V>, v: &Vectors<V>) -> Strains<S> {
        let mut fields = self.tables.fields(u);
        fields.iter_mut().zip(&self.profile.fields).for_each(|(field, rest)| *field += rest);
        self.tables.rates(&fields, &self.tables.fields(v))
    }

    pub(super) fn state(&self, q: &[f64]) -> ShearState<S> {
        let (rest, mut fields) = (&self.profile.fields, self.tables.fields(&vectors::<V>(q)));
        let strains = self.tables.strains(rest, &fields);
        fields.iter_mut().zip(rest).for_each(|(field, rest)| *field += rest);
        ShearState { strains, fields }
    }

    /// Computes the gradients of the strains by the coordinates.
    pub(super) fn gradients(&self, state: &ShearState<S>) -> Gradients<S, C> {
        self.tables.gradients(&state.fields)
    }

    /// Computes the rates of the strains for rates of the coordinates.
    fn rates(&self, state: &ShearState<S>, v: &[f64]) -> Strains<S> {
        self.tables.rates(&state.fields, &self.tables.fields(&vectors::<V>(v)))
    }

    /// Computes the stresses of the damping.
    fn damping_stress(&self, state: &ShearState<S>, at: &Local<'_>) -> Strains<S> {
        let time = self.profile.medium.retardation;
        if time == 0.0 {
            return Strains::zeros();
        }
        self.profile.linear_stress(&(self.rates(state, at.v) * time))
    }

    /// Computes the stresses of a state, with those of the damping.
    fn damped_stress(&self, state: &ShearState<S>, at: &Local<'_>) -> Strains<S> {
        self.profile.stress(&state.strains) + self.damping_stress(state, at)
    }

    /// Returns the nodal vectors in a state.
    fn present(&self, at: &Local<'_>) -> Vectors<V> {
        let u = vectors::<V>(at.q);
        std::array::from_fn(|a| self.profile.reference[a] + u[a])
    }

    fn mass_times(&self, x: &Vectors<V>) -> Vectors<V> {
        std::array::from_fn(|a| {
            self.profile.mass[a].iter().zip(x).fold(Vector3::zeros(), |sum, (m, x)| sum + x * *m)
        })
    }

    /// Adds forces of stresses, inertia, mass-proportional damping and weight.
    fn add_forces(&self, state: &ShearState<S>, stress: &Strains<S>, at: &Local<'_>, r: &mut [f64]) {
        let profile = &self.profile;
        let forces: Vectors<V> = self.tables.forces(&state.fields, stress);
        let mut moved = vectors::<V>(at.a);
        let damping = profile.medium.mass_damping;
        if damping != 0.0 {
            moved.iter_mut().zip(vectors::<V>(at.v)).for_each(|(a, v)| *a += v * damping);
        }
        let inertia = self.mass_times(&moved);
        let weight = profile.medium.gravity * at.load;
        for a in 0..V {
            let own = inertia[a] - weight * profile.first[a];
            (0..3).for_each(|i| r[3 * a + i] += forces[a][i] + own[i]);
        }
    }

    /// Adds multiples of the material stiffness of the state and of the linear one, and the stiffness of stresses.
    fn add_stiffness(
        &self,
        state: &ShearState<S>,
        material: [f64; 2],
        stress: &Strains<S>,
        k: &mut LocalMatrix<'_>,
    ) {
        self.add_blocks(&self.tables.geometry(stress), k);
        if material != [0.0; 2] {
            let matrix = self.profile.material_stiffness(&self.gradients(state), &state.strains, material);
            k.add_lower(C, |i, j| matrix[i][j]);
        }
    }

    /// Adds scalar blocks w_ab I.
    fn add_blocks(&self, blocks: &[[f64; V]; V], k: &mut LocalMatrix<'_>) {
        for a in 0..V {
            for b in 0..=a {
                if blocks[a][b] != 0.0 {
                    (0..3).for_each(|i| k.add(3 * a + i, 3 * b + i, blocks[a][b]));
                }
            }
        }
    }

    fn add_tangent(&self, state: &ShearState<S>, stress: &Strains<S>, w: Weights, k: &mut LocalMatrix<'_>) {
        let medium = &self.profile.medium;
        self.add_stiffness(state, [w.q, w.v * medium.retardation], &(stress * w.q), k);
        let inertia = w.a + medium.mass_damping * w.v;
        if inertia != 0.0 {
            self.add_blocks(&self.profile.mass.map(|row| row.map(|m| inertia * m)), k);
        }
    }

    /// Computes the stresses of a step. All strains are quadratic in q: B(q_m) Δq are their exact changes, so that mean stresses do
    /// the work of the strain energy. A law of the membrane has a discrete derivative of its energy.
    ///
    /// Source: Simo & Tarnow (1992); Gonzalez (2000), laws of the membrane.
    fn step_stress(&self, middle: &ShearState<S>, step: &LocalStep<'_>) -> Strains<S> {
        let [before, after] = [&step.from, &step.to].map(|at| self.strains(&vectors(at.q)));
        let [of_before, of_after] = step.shares();
        let strains = before * of_before + after * of_after;
        self.profile.step_stress(&strains, [&before, &after]) + self.damping_stress(middle, &step.middle)
    }
}

impl<const V: usize, const S: usize, const C: usize> Term for ShearElement<V, S, C> {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let state = self.state(at.q);
        self.add_forces(&state, &self.damped_stress(&state, at), at, r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (profile, state) = (&*self.profile, self.state(at.q));
        let norms = |x: &[f64]| vectors::<V>(x).map(|x| x.norm());
        let (moved, v) = (norms(at.a), norms(at.v));
        let mut bound: Weighting<V> = std::array::from_fn(|a| {
            let of = |b: usize| profile.mass[a][b].abs() * (moved[b] + profile.medium.mass_damping * v[b]);
            let weight = (at.load * profile.first[a]).abs() * profile.medium.gravity.norm();
            2.0 * f64::EPSILON * ((0..V).map(of).sum::<f64>() + weight)
        });
        let sizes = norms(at.q);
        let stress = self.damped_stress(&state, at);
        profile.add_rounding(&self.tables, [&sizes, &v], (&state.strains, &stress), &mut bound);
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
        let stress =
            self.profile.predicted_stress((&before.strains, &self.rates(&before, &change)), &state.strains);
        self.add_stiffness(&state, [0.0; 2], &stress, k);
    }

    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let state = self.state(at.q);
        let stress = self.profile.stress_change(&state.strains, &self.rates(&state, by.q));
        self.add_stiffness(&state, [0.0; 2], &stress, k);
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let (shape, x) = (self.profile.shape, self.present(at));
        let is_admissible = (0..shape.nodes()).all(|corner| {
            volume(shape, corner, &x) > CRUSHED * volume(shape, corner, &self.profile.reference)
        });
        (!is_admissible).then_some(Inadmissibility::InvertedElement)
    }

    fn rotation(&self, from: &Local<'_>, to: &Local<'_>) -> f64 {
        let shape = self.profile.shape;
        let [before, after] = [from, to].map(|at| self.present(at));
        let frame = |at: [f64; 2], x: &Vectors<V>| {
            let ([t, s], _) = tangents(shape, at, x);
            [t, s, interpolate(&shape.values(at)[0], 1, x)]
        };
        let of = |at: [f64; 2]| {
            let [a, b] = [frame(at, &before), frame(at, &after)];
            relative_rotation([[a[0], b[0]], [a[1], b[1]], [a[2], b[2]]])
        };
        shape.points().iter().map(|(at, _)| of(*at)).fold(0.0, f64::max)
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let v = vectors::<V>(at.v);
        let momentum = self.mass_times(&v);
        let moved = self
            .profile
            .first
            .iter()
            .zip(vectors::<V>(at.q))
            .fold(Vector3::zeros(), |sum, (m, q)| sum + q * *m);
        Energy {
            kinetic: 0.5 * momentum.iter().zip(&v).map(|(p, v)| p.dot(v)).sum::<f64>(),
            strain: self.strain_energy(&vectors(at.q)),
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

impl<const V: usize, const S: usize, const C: usize> StrainedElement for ShearElement<V, S, C> {
    type Strains = Strains<S>;

    fn zero() -> Strains<S> {
        Strains::zeros()
    }

    fn add(sum: &mut Strains<S>, factor: f64, other: &Strains<S>) {
        *sum += other * factor;
    }

    fn product(stress: &Strains<S>, strains: &Strains<S>) -> f64 {
        stress.dot(strains)
    }

    fn retardation(&self) -> f64 {
        self.profile.medium.retardation
    }

    /// Samples membrane strains and curvatures at the integration points. Transverse shear and thickness strains are zero.
    fn sampled(&self, field: StrainField<'_>) -> Strains<S> {
        let (profile, mut strains) = (&self.profile, Strains::<S>::zeros());
        for (k, (at, _)) in profile.shape.surface_points().iter().enumerate() {
            let point = reference_point(profile.shape, *at, &profile.reference);
            for (kind, own) in field(&profile.law(k, point.tangents.each_ref()), &point).iter().enumerate() {
                strains.fixed_rows_mut::<3>(SURFACE * k + 3 * kind).copy_from(own);
            }
        }
        strains
    }

    fn stress_of(&self, strains: &Strains<S>) -> Strains<S> {
        self.profile.linear_stress(strains)
    }

    fn strains_of(&self, q: &[f64]) -> Strains<S> {
        self.strains(&vectors(q))
    }

    fn rates_of(&self, q: &[f64], v: &[f64]) -> Strains<S> {
        self.rates(&self.state(q), v)
    }

    fn add_forces_of(&self, q: &[f64], stress: &Strains<S>, r: &mut [f64]) {
        let forces: Vectors<V> = self.tables.forces(&self.state(q).fields, stress);
        r.iter_mut().zip(forces.iter().flatten()).for_each(|(row, force)| *row += force);
    }

    fn add_rounding_of(&self, q: &[f64], stress: &Strains<S>, floor: &mut [f64]) {
        let mut bound = [0.0; V];
        let sizes = vectors::<V>(q).map(|q| q.norm());
        self.profile.add_stress_rounding(&self.tables, &sizes, stress, &mut bound);
        floor.iter_mut().enumerate().for_each(|(i, floor)| *floor += bound[i / 3]);
    }

    fn add_stiffness_of(&self, q: &[f64], stress: &Strains<S>, k: &mut LocalMatrix<'_>) {
        self.add_stiffness(&self.state(q), [0.0; 2], stress, k);
    }
}
