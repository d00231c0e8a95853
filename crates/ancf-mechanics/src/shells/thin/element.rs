use std::sync::Arc;

use ancf_solver::equations::{Energy, Inadmissibility, Local, LocalMatrix, LocalStep, Term, Weights};
use nalgebra::Vector3;
use pulp::Arch;

use super::hermite::{Shape, VECTORS, vectors};
use super::membrane_stiffness::MembraneStiffness;
use super::nonlinear_membrane::NonlinearMembrane;
use super::profile::{ShellMedium, ShellProfile};
use super::rounding::{add_rounding, add_stress_rounding};
use super::stiffness::{ShellMatrix, StiffnessJob};
use super::surface_state::{ShellStrains, SurfaceState, surface_areas};
use super::tables::{POINTS, ShellTables, sum};
use crate::kinematics::relative_rotation;
use crate::shells::laminates::SectionField;
use crate::shells::prestrain::{ReferencePoint, StrainField, StrainedElement};

/// Area of the surface, relative to the reference, below which an element counts as inverted.
const CRUSHED: f64 = 1e-2;

/// Thin shell element: bicubic Hermite surface with the nodal vectors r, r_ξ, r_η, r_ξη, and Kirchhoff-Love strains.
///
/// Coordinates are the components of the vectors minus their reference values. The membrane strains ½ (a_αβ − A_αβ) are evaluated
/// at 3 × 4, 4 × 3 and 3 × 3 Lobatto points and interpolated, which prevents membrane locking. The curvatures b_αβ = r_,αβ · n are exact, at 4 × 4
/// Gauss points. Stresses are linear in them (St. Venant-Kirchhoff law in plane stress, [`ShellSection`](crate::shells::ShellSection)) unless the section has another law
/// of the membrane forces.
/// The mass matrix is constant; rotary inertia of the sections is neglected.
///
/// Source: Bogner, Fox & Schmit (1965), shape functions; Dmitrochenko & Pogorelov (2003), coordinates; Kiendl et al. (2009), strains.
#[derive(Clone, Debug)]
pub struct Shell48 {
    coordinates: Vec<usize>,
    tables: Arc<ShellTables>,
    profile: Arc<ShellProfile>,
    /// Law of the membrane forces if it is not linear.
    pub(super) nonlinear: Option<Arc<NonlinearMembrane>>,
}

impl Shell48 {
    /// Creates elements with common shape functions. Each has 48 coordinates and its nodal vectors in the reference state.
    pub fn all(
        elements: impl IntoIterator<Item = (Vec<usize>, [Vector3<f64>; VECTORS])>,
        medium: &ShellMedium,
        sections: Option<&SectionField>,
    ) -> Vec<Self> {
        let tables = Arc::new(ShellTables::new());
        let element = |(k, (coordinates, reference)): (usize, (Vec<usize>, _))| {
            let places = || ShellProfile::section_places().into_iter().map(|(at, _)| at);
            let local = SectionField::of_element(sections, k, places);
            let profile = Arc::new(ShellProfile::new(&tables, &reference, medium, local));
            let nonlinear = NonlinearMembrane::new(&profile).map(Arc::new);
            Self { coordinates, tables: Arc::clone(&tables), profile, nonlinear }
        };
        elements.into_iter().enumerate().map(element).collect()
    }

    /// Returns the constant data.
    pub fn profile(&self) -> &ShellProfile {
        &self.profile
    }

    /// Returns the strain energy, from the coordinates of the element.
    pub fn strain_energy(&self, q: &[f64]) -> f64 {
        let strains = self.state(q).strains;
        match &self.nonlinear {
            Some(membrane) => membrane.strain_energy(self.data(), &strains),
            None => 0.5 * self.profile.stress(&self.tables, &strains).product(&strains),
        }
    }

    pub(super) fn state(&self, q: &[f64]) -> SurfaceState {
        SurfaceState::new(&self.tables, &self.profile, &vectors(q))
    }

    fn mass_times(&self, x: &[Vector3<f64>; VECTORS]) -> [Vector3<f64>; VECTORS] {
        std::array::from_fn(|a| sum(&self.profile.mass[a].0, x))
    }

    /// Returns the accelerations and, times the mass-proportional damping, the velocities.
    fn moved(&self, at: &Local<'_>) -> [Vector3<f64>; VECTORS] {
        let mass_damping = self.profile.medium.mass_damping;
        let mut moved = vectors(at.a);
        if mass_damping != 0.0 {
            moved.iter_mut().zip(vectors(at.v)).for_each(|(a, v)| *a += v * mass_damping);
        }
        moved
    }

    /// Computes the strain rates times the retardation time.
    fn retarded(&self, state: &SurfaceState, at: &Local<'_>) -> ShellStrains {
        let (mut strains, time) = (ShellStrains::ZERO, self.profile.medium.retardation);
        if time != 0.0 {
            strains.add(time, &state.rates(&self.tables, &vectors(at.v)));
        }
        strains
    }

    /// Returns the tables and the profile.
    pub(super) fn data(&self) -> (&ShellTables, &ShellProfile) {
        (&self.tables, &self.profile)
    }

    /// Computes the stresses of a state, with those of the damping.
    fn stress(&self, state: &SurfaceState, at: &Local<'_>) -> ShellStrains {
        if self.profile.medium.retardation == 0.0 {
            return match &self.nonlinear {
                Some(membrane) => membrane.stress(self.data(), &state.strains),
                None => self.profile.stress(&self.tables, &state.strains),
            };
        }
        let mut retarded = self.retarded(state, at);
        if let Some(membrane) = &self.nonlinear {
            let mut stress = membrane.stress(self.data(), &state.strains);
            stress.add(1.0, &self.profile.stress(&self.tables, &retarded));
            return stress;
        }
        retarded.add(1.0, &state.strains);
        self.profile.stress(&self.tables, &retarded)
    }

    /// Computes `material` times the material stiffness, or a given one of the membrane strains, plus the stiffness of stresses.
    fn stiffness(
        &self,
        state: &SurfaceState,
        (material, membrane): (f64, Option<&MembraneStiffness>),
        stress: &ShellStrains,
    ) -> ShellMatrix {
        let (tables, profile) = (&*self.tables, &*self.profile);
        let mut sum = ShellMatrix::ZERO;
        Arch::new().dispatch(StiffnessJob {
            state,
            tables,
            profile,
            material,
            membrane,
            stress,
            sum: &mut sum,
        });
        sum
    }

    /// Adds the tangent for a surface and its stresses.
    fn add_tangent(&self, state: &SurfaceState, stress: &ShellStrains, w: Weights, k: &mut LocalMatrix<'_>) {
        let profile = &self.profile;
        let material = w.q + w.v * profile.medium.retardation;
        let mut scaled = ShellStrains::ZERO;
        scaled.add(w.q, stress);
        let shares = [w.q, w.v * profile.medium.retardation];
        let nonlinear = self.nonlinear.as_ref().filter(|_| material != 0.0);
        let membrane = nonlinear.map(|membrane| membrane.stiffness(&self.tables, &state.strains, shares));
        let mut matrix = self.stiffness(state, (material, membrane.as_ref()), &scaled);
        let inertia = w.a + profile.medium.mass_damping * w.v;
        if inertia != 0.0 {
            matrix.add_to_diagonal(inertia, &profile.mass);
        }
        matrix.add_to(k);
    }

    /// Computes the stresses of a step, with moments that do the work of the stresses on the exact changes of curvature.
    fn step_stress(&self, middle: &SurfaceState, step: &LocalStep<'_>) -> ShellStrains {
        let [before, after] = [&step.from, &step.to].map(|at| self.state(at.q).strains);
        let (mut strains, [of_before, of_after]) = (ShellStrains::ZERO, step.shares());
        strains.add(of_before, &before);
        strains.add(of_after, &after);
        let mut stress = match &self.nonlinear {
            Some(membrane) => membrane.step_stress(self.data(), &strains, [&before, &after]),
            None => self.profile.stress(&self.tables, &strains),
        };
        self.correct_moments(&mut stress, middle, [&before, &after], step);
        stress.add(1.0, &self.profile.stress(&self.tables, &self.retarded(middle, &step.middle)));
        stress
    }

    /// Corrects the moments of stresses, so that the forces of the middle of a step do their work on the changes of the strains.
    ///
    /// The membrane strains are quadratic in q: B(q_m) Δq is their exact change. The moments m of a point get the correction
    /// D d (m·(Δκ − d))/(d·D d), d = B(q_m) Δq.
    ///
    /// Source: Gonzalez (2000), discrete derivatives in the strains: momenta are preserved.
    fn correct_moments(
        &self,
        stress: &mut ShellStrains,
        middle: &SurfaceState,
        [before, after]: [&ShellStrains; 2],
        step: &LocalStep<'_>,
    ) {
        let (from, to) = (vectors(step.from.q), vectors(step.to.q));
        let moved = middle.rates(&self.tables, &std::array::from_fn(|a| to[a] - from[a]));
        let sizes: f64 = to.iter().chain(&from).map(|x| x.norm()).sum();
        for k in 0..POINTS {
            let (m, d) = (stress.bending(k), moved.bending(k));
            let missed = after.bending(k) - before.bending(k) - d;
            let stiffness = self.profile.points.bending(k) * d;
            let (work, square) = (m.dot(&missed), d.dot(&stiffness));
            let curved = before.bending(k).norm() + after.bending(k).norm() + d.norm();
            let bound = 8.0 * f64::EPSILON * m.norm() * (curved + sizes);
            if work.abs() > bound && square > 0.0 {
                stress.set_bending(k, &(m + stiffness * (work / square)));
            }
        }
    }

    fn add_forces(&self, state: &SurfaceState, stress: &ShellStrains, at: &Local<'_>, r: &mut [f64]) {
        let force = state.forces((&self.tables, &self.profile), stress, &self.moved(at));
        let weight = self.profile.medium.gravity * at.load;
        for ((row, force), first) in r.chunks_exact_mut(3).zip(&force).zip(&self.profile.first) {
            (0..3).for_each(|i| row[i] += force[i] - weight[i] * first);
        }
    }
}

impl Term for Shell48 {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let state = self.state(at.q);
        self.add_forces(&state, &self.stress(&state, at), at, r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (profile, state) = (&*self.profile, self.state(at.q));
        let (moved, v) = (vectors(at.a).map(|a| a.norm()), vectors(at.v).map(|v| v.norm()));
        let mut bound: Shape = std::array::from_fn(|a| {
            let of = |b: usize| profile.mass[a].0[b].abs() * (moved[b] + profile.medium.mass_damping * v[b]);
            let weight = (at.load * profile.first[a]).abs() * profile.medium.gravity.norm();
            2.0 * f64::EPSILON * ((0..VECTORS).map(of).sum::<f64>() + weight)
        });
        let sizes = vectors(at.q).map(|q| q.norm());
        let stress = self.stress(&state, at);
        add_rounding(&self.tables, profile, [&sizes, &v], (&state, &stress), &mut bound);
        floor.iter_mut().enumerate().for_each(|(i, floor)| *floor += bound[i / 3]);
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let state = self.state(at.q);
        self.add_tangent(&state, &self.stress(&state, at), w, k);
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
        let (now, then) = (vectors(at.q), vectors(from.q));
        let linear = before.rates(&self.tables, &std::array::from_fn(|a| now[a] - then[a]));
        let mut strains = before.strains;
        strains.add(1.0, &linear);
        strains.add(-1.0, &state.strains);
        let mut stress = self.profile.stress(&self.tables, &strains);
        if let Some(membrane) = &self.nonlinear {
            stress.membrane =
                membrane.stiffness(&self.tables, &before.strains, [1.0, 0.0]).stress(&linear.membrane);
            let [then, now] = [&before, &state].map(|state| membrane.stress(self.data(), &state.strains));
            let changes = then.membrane.iter().zip(&now.membrane).map(|(then, now)| then - now);
            stress.membrane.iter_mut().zip(changes).for_each(|(sum, change)| *sum += change);
        }
        self.stiffness(&state, (0.0, None), &stress).add_to(k);
    }

    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let state = self.state(at.q);
        let strains = state.rates(&self.tables, &vectors(by.q));
        let mut stress = self.profile.stress(&self.tables, &strains);
        if let Some(membrane) = &self.nonlinear {
            let of_state = membrane.stiffness(&self.tables, &state.strains, [1.0, 0.0]);
            stress.membrane = of_state.stress(&strains.membrane);
        }
        self.stiffness(&state, (0.0, None), &stress).add_to(k);
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let areas = surface_areas(&self.tables, &self.profile, &vectors(at.q));
        let is_admissible =
            areas.iter().zip(self.profile.points.areas.0).all(|(area, rest)| *area > CRUSHED * rest);
        (!is_admissible).then_some(Inadmissibility::InvertedElement)
    }

    fn rotation(&self, from: &Local<'_>, to: &Local<'_>) -> f64 {
        let [from, to] = [from, to].map(|at| self.state(at.q));
        let of = |k: usize| {
            let [a, b] = [from.points.at(k), to.points.at(k)];
            relative_rotation([
                [a.tangents[0], b.tangents[0]],
                [a.tangents[1], b.tangents[1]],
                [a.normal, b.normal],
            ])
        };
        (0..POINTS).map(of).fold(0.0, f64::max)
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let v = vectors(at.v);
        let momentum = self.mass_times(&v);
        let moved = sum(&self.profile.first, &vectors(at.q));
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
        if !self.is_damped() {
            return;
        }
        let state = self.state(at.q);
        let stress = self.profile.stress(&self.tables, &self.retarded(&state, at));
        let moved = vectors(at.v).map(|v| v * self.profile.medium.mass_damping);
        let force = state.forces(self.data(), &stress, &moved);
        r.iter_mut().zip(force.iter().flatten()).for_each(|(row, force)| *row += force);
    }
}

impl StrainedElement for Shell48 {
    type Strains = ShellStrains;

    fn zero() -> ShellStrains {
        ShellStrains::ZERO
    }

    fn add(sum: &mut ShellStrains, factor: f64, other: &ShellStrains) {
        sum.add(factor, other);
    }

    fn product(stress: &ShellStrains, strains: &ShellStrains) -> f64 {
        stress.product(strains)
    }

    fn retardation(&self) -> f64 {
        self.profile.medium.retardation
    }

    fn sampled(&self, field: StrainField<'_>) -> ShellStrains {
        let (profile, mut strains) = (&self.profile, ShellStrains::ZERO);
        let at = |place: usize, point: ReferencePoint| {
            field(&profile.law(place, point.tangents.each_ref()), &point)
        };
        for (k, (tangents, sample)) in profile.samples.iter().zip(&self.tables.samples).enumerate() {
            strains.membrane[k] = at(POINTS + k, ReferencePoint::flat(*tangents))[0][sample.component];
        }
        for k in 0..POINTS {
            strains.set_bending(k, &at(k, ReferencePoint::of_surface(profile.points.at(k).reference))[1]);
        }
        strains
    }

    fn stress_of(&self, strains: &ShellStrains) -> ShellStrains {
        self.profile.stress(&self.tables, strains)
    }

    fn strains_of(&self, q: &[f64]) -> ShellStrains {
        self.state(q).strains
    }

    fn rates_of(&self, q: &[f64], v: &[f64]) -> ShellStrains {
        self.state(q).rates(&self.tables, &vectors(v))
    }

    fn add_forces_of(&self, q: &[f64], stress: &ShellStrains, r: &mut [f64]) {
        let forces =
            self.state(q).forces((&self.tables, &self.profile), stress, &[Vector3::zeros(); VECTORS]);
        for (row, force) in r.iter_mut().zip(forces.iter().flatten()) {
            *row += force;
        }
    }

    fn add_rounding_of(&self, q: &[f64], stress: &ShellStrains, floor: &mut [f64]) {
        let (sizes, mut bound): (Shape, _) = (vectors(q).map(|q| q.norm()), [0.0; VECTORS]);
        add_stress_rounding(&self.tables, &self.profile, &sizes, (&self.state(q), stress), &mut bound);
        floor.iter_mut().enumerate().for_each(|(i, floor)| *floor += bound[i / 3]);
    }

    fn add_stiffness_of(&self, q: &[f64], stress: &ShellStrains, k: &mut LocalMatrix<'_>) {
        self.stiffness(&self.state(q), (0.0, None), stress).add_to(k);
    }

    fn exact_work(&self, mut stress: ShellStrains, step: &LocalStep<'_>) -> ShellStrains {
        let [before, after] = [&step.from, &step.to].map(|at| self.state(at.q).strains);
        self.correct_moments(&mut stress, &self.state(step.middle.q), [&before, &after], step);
        stress
    }
}
