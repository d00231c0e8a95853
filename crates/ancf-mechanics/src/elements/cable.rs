use std::sync::Arc;

use ancf_solver::equations::{
    Energy, Inadmissibility, Local, LocalMatrix, LocalStep, ProductColumn, Term, Weights, velocity_forces,
};
use nalgebra::{Matrix3, Vector3};

use super::beam::add_blocks;
use super::cable_products::{AxialProduct, BendProduct, CableColumn};
use super::cable_profile::{CableDamping, CableProfile, CableStation};
use super::cable_rounding::{axial_rounding, bending_rounding};
use super::cable_step::{CableStep, vectors};
use crate::kinematics::{AxialStretch, Bend, BendBlocks, relative_rotation};

/// Value of |r′| up to which a line counts as collapsed to a point.
pub(crate) const CRUSHED: f64 = 0.01;

/// Two-node, 12-coordinate, gradient-deficient ANCF cable element, straight and stress-free in its reference
/// configuration.
///
/// The cable has axial and bending deformation, without shear or torsion. Coordinates are the vectors (r, ℓ r_x) of both nodes minus
/// their reference values. The strain energy is
///
/// U = ½∫(EA ε² + EI K²) dx,  ε = |r′| − 1,  K = |r′ × r″|/|r′|²
///
/// with the material measure of curvature and isotropic bending. Strains are computed from displacement gradients.
/// Their accuracy therefore does not depend on their size or on the distance from the origin. The mass is that of the
/// line, ρA. The rotary inertia of the section is neglected.
///
/// # Damping
///
/// Kelvin-Voigt damping with the retardation times τ: N = EA (ε + τ ε̇) and M = EI (κ + τ κ°), with κ = r′ × r″/|r′|².
/// The rate κ° refers to a frame that follows the tangent without spin about it. The dissipation function
/// ½τ∫(EA ε̇² + EI |κ°|²) dx is half the dissipated power. It is smooth and never negative. It damps small vibrations
/// about any shape as in the linear theory.
///
/// The dissipation is zero in translations, in all rotations of a straight cable, and in plane rotations of a plane
/// cable. A rigid spin Ω about the tangent of a *bent* cable dissipates τ EI K² Ω² per length. The loss equals that of
/// a rod with fixed ends whose sections do not spin. The moment about the tangent is not balanced. This is unavoidable:
/// a line without twist, bent by a small η and spinning about its tangent at the rate 1/η, has the velocities of
/// bending at a finite rate, for any η. A dissipation that vanishes in all rigid motions and is continuous at the
/// straight line thus vanishes there for bending too. The rate of the scalar K vanishes in rigid motions. But it jumps
/// at a straight line and leaves out-of-plane vibrations undamped.
///
/// The mass-proportional damping α M v also damps rigid motions, like a medium at rest.
///
/// # Tangent
///
/// The tangent is exact without damping, and always exact with respect to v. The derivative of the strain rates with
/// respect to q is omitted from the viscous forces. It is not symmetric, and its symmetric part slows Newton's method
/// down. The convergence is then linear, and fast for steps with small rotations.
///
/// Source: Gerstmayr & Shabana (2006) for the element; Gerstmayr & Irschik (2008) for its strains.
#[derive(Clone, Debug)]
pub struct Cable12 {
    coordinates: [usize; 12],
    pub(crate) direction: Vector3<f64>,
    pub(crate) profile: Arc<CableProfile>,
}

impl Cable12 {
    /// Creates an element on the given coordinates along a unit vector.
    pub fn new(coordinates: [usize; 12], direction: Vector3<f64>, profile: Arc<CableProfile>) -> Self {
        Self { coordinates, direction, profile }
    }

    /// Returns the profile, which all elements of the cable share.
    pub fn profile(&self) -> &CableProfile {
        &self.profile
    }

    /// Returns the axial strain ε = |r′| − 1 and the curvature vector κ = r′ × r″/|r′|² at ξ.
    ///
    /// `q` are the coordinates of the element.
    pub fn strains(&self, q: &[f64], xi: f64) -> (f64, Vector3<f64>) {
        let (station, q) = (self.profile.station(xi), vectors(q));
        let bend = self.bend(&station, &q);
        (self.stretch(&station, &q).strain, bend.turned(&bend.strain()))
    }

    /// Returns the axial force N = EA (ε + τ ε̇) and the bending moment M = EI (κ + τ κ°) at ξ.
    ///
    /// N acts along the tangent and is positive in tension. M has global components. Both are exerted by the part x > ξ
    /// l on the part x < ξ l. `q` and `v` are the coordinates and velocities of the element. Axial forces are most
    /// accurate at the axial points of the quadrature rule.
    pub fn resultants(&self, q: &[f64], v: &[f64], xi: f64) -> (f64, Vector3<f64>) {
        let (station, q, v) = (self.profile.station(xi), vectors(q), vectors(v));
        let (stretch, bend) = (self.stretch(&station, &q), self.bend(&station, &q));
        let rates = station.both(&v);
        let moment = bend.turned(&self.profile.moment(&bend, &rates));
        (self.profile.axial_force(&stretch, &rates[0]), moment)
    }

    /// Returns the strain energies of stretching and bending, from the coordinates of the element.
    pub fn parts(&self, q: &[f64]) -> [f64; 2] {
        let (profile, q) = (&*self.profile, vectors(q));
        let section = profile.section();
        let axial = profile.axial().iter().map(|s| s.weight * self.stretch(s, &q).strain.powi(2));
        let bending = profile.bending().iter().map(|s| s.weight * self.bend(s, &q).strain().norm_squared());
        [0.5 * section.axial * axial.sum::<f64>(), 0.5 * section.bending * bending.sum::<f64>()]
    }

    fn stretch(&self, station: &CableStation, q: &[Vector3<f64>; 4]) -> AxialStretch {
        AxialStretch::new(&self.direction, &station.first(q))
    }

    fn bend(&self, station: &CableStation, q: &[Vector3<f64>; 4]) -> Bend {
        Bend::new(self.direction + station.first(q), station.second(q))
    }

    /// Computes the forces of inertia, of the mass-proportional damping and of gravity.
    fn inertia(&self, at: &Local<'_>) -> [Vector3<f64>; 4] {
        let (profile, a, v) = (&*self.profile, vectors(at.a), vectors(at.v));
        let mut force = self.mass_times(&std::array::from_fn(|i| a[i] + v[i] * profile.damping().mass));
        for (force, first) in force.iter_mut().zip(profile.first_moments()) {
            *force -= profile.gravity() * (at.load * first);
        }
        force
    }

    /// Adds the tangent of [`inertia`](Self::inertia) to the lower blocks.
    fn add_inertia(&self, w: Weights, blocks: &mut [[Matrix3<f64>; 4]; 4]) {
        let inertia = w.a + w.v * self.profile.damping().mass;
        let mass = self.profile.mass();
        each_pair(|i, j| blocks[i][j] += Matrix3::from_diagonal_element(inertia * mass[i][j]));
    }

    /// Adds the stiffness of axial forces EA Δε, with Δε of the strain and of that predicted from the state `from`.
    fn add_axial_strains(
        &self,
        at: &Local<'_>,
        from: &Local<'_>,
        k: &mut LocalMatrix<'_>,
        difference: impl Fn(f64, f64) -> f64,
    ) {
        let (profile, now, before) = (&*self.profile, vectors(at.q), vectors(from.q));
        let mut blocks = [[Matrix3::zeros(); 4]; 4];
        for station in profile.axial() {
            let [stretch, start] = [&now, &before].map(|q| self.stretch(station, q));
            let predicted = start.strain + start.tangent.dot(&(station.first(&now) - station.first(&before)));
            let force = profile.section().axial * difference(stretch.strain, predicted);
            let h = stretch.stiffness(0.0, force) * station.weight;
            each_pair(|i, j| blocks[i][j] += h * (station.first[i] * station.first[j]));
        }
        add_blocks(&blocks, k);
    }

    /// Computes the sum of M_ab x_b over b.
    fn mass_times(&self, x: &[Vector3<f64>; 4]) -> [Vector3<f64>; 4] {
        self.profile.mass().map(|row| row.iter().zip(x).map(|(m, x)| x * *m).sum())
    }
}

impl Term for Cable12 {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    /// Adds the stiffness of each station times r′ and r″ of the columns, without the large stiffness of the vectors.
    fn stiffness_products(&self, at: &Local<'_>, columns: &mut [ProductColumn]) {
        let (q, v) = (vectors(at.q), vectors(at.v));
        let mut columns: Vec<_> = columns.iter_mut().map(CableColumn::new).collect();
        for station in self.profile.axial() {
            let h = self.axial_stiffness(station, &q, &v, Weights::STIFFNESS) * station.weight;
            let h = AxialProduct::new(h);
            columns.iter_mut().for_each(|column| column.add_axial(station, &h));
        }
        for station in self.profile.bending() {
            let h = self.bending_stiffness(station, &q, &v, Weights::STIFFNESS).scaled(station.weight);
            let h = BendProduct::new(h);
            columns.iter_mut().for_each(|column| column.add_bending(station, &h));
        }
        columns.into_iter().for_each(CableColumn::finish);
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let (profile, q, v) = (&*self.profile, vectors(at.q), vectors(at.v));
        let mut force = self.inertia(at);
        for station in profile.axial() {
            let stretch = self.stretch(station, &q);
            let n = profile.axial_force(&stretch, &station.first(&v));
            for (force, s) in force.iter_mut().zip(station.first) {
                *force += stretch.tangent * (station.weight * n * s);
            }
        }
        for station in profile.bending() {
            let bend = self.bend(station, &q);
            let [of_a, of_b] = bend.force(&(profile.moment(&bend, &station.both(&v)) * station.weight));
            for (i, force) in force.iter_mut().enumerate() {
                *force += of_a * station.first[i] + of_b * station.second[i];
            }
        }
        for (row, force) in r.iter_mut().zip(force.iter().flatten()) {
            *row += force;
        }
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (profile, q, v) = (&*self.profile, vectors(at.q), vectors(at.v));
        let a = vectors(at.a);
        let mut bound: [f64; 4] = std::array::from_fn(|i| {
            let moved = |j: usize| a[j].norm() + profile.damping().mass * v[j].norm();
            let inertia: f64 = (0..4).map(|j| profile.mass()[i][j].abs() * moved(j)).sum();
            let weight = (at.load * profile.first_moments()[i]).abs() * profile.gravity().norm();
            f64::EPSILON * (inertia + weight)
        });
        for station in profile.axial() {
            let stretch = self.stretch(station, &q);
            let force = station.weight * axial_rounding(profile, station, &stretch, [&q, &v]);
            for (bound, s) in bound.iter_mut().zip(station.first) {
                *bound += force * s.abs();
            }
        }
        for station in profile.bending() {
            let [of_a, of_b] =
                bending_rounding(profile, station, &self.direction, [&q, &v]).map(|f| station.weight * f);
            for (i, bound) in bound.iter_mut().enumerate() {
                *bound += of_a * station.first[i].abs() + of_b * station.second[i].abs();
            }
        }
        for (row, floor) in floor.iter_mut().enumerate() {
            *floor += bound[row / 3];
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let (profile, q, v) = (&*self.profile, vectors(at.q), vectors(at.v));
        let mut blocks = [[Matrix3::zeros(); 4]; 4];
        for station in profile.axial() {
            let h = self.axial_stiffness(station, &q, &v, w) * station.weight;
            each_pair(|i, j| blocks[i][j] += h * (station.first[i] * station.first[j]));
        }
        for station in profile.bending() {
            add_bending(station, &self.bending_stiffness(station, &q, &v, w), &mut blocks);
        }
        self.add_inertia(w, &mut blocks);
        add_blocks(&blocks, k);
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        let mut force = self.inertia(&step.middle);
        CableStep { profile: &self.profile, direction: &self.direction, step }.add_forces(&mut force);
        for (row, force) in r.iter_mut().zip(force.iter().flatten()) {
            *row += force;
        }
    }

    fn average_tangent(&self, step: &LocalStep<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let (q, v) = (vectors(step.middle.q), vectors(step.middle.v));
        let mut blocks = [[Matrix3::zeros(); 4]; 4];
        let cable = CableStep { profile: &self.profile, direction: &self.direction, step };
        for station in self.profile.axial() {
            let h = cable.axial_stiffness(station, w) * station.weight;
            each_pair(|i, j| blocks[i][j] += h * (station.first[i] * station.first[j]));
        }
        for station in self.profile.bending() {
            add_bending(station, &self.bending_stiffness(station, &q, &v, w), &mut blocks);
        }
        self.add_inertia(w, &mut blocks);
        add_blocks(&blocks, k);
    }

    fn has_stress_prediction(&self) -> bool {
        true
    }

    /// Axial force only: that of bending is small.
    fn stress_prediction(&self, at: &Local<'_>, from: &Local<'_>, k: &mut LocalMatrix<'_>) {
        self.add_axial_strains(at, from, k, |strain, predicted| predicted - strain);
    }

    fn is_cable(&self) -> bool {
        true
    }

    fn least_tension(&self, at: &Local<'_>, from: &Local<'_>, least: f64, k: &mut LocalMatrix<'_>) {
        self.add_axial_strains(at, from, k, |_, predicted| (least - predicted).max(0.0));
    }

    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let (profile, q, dq) = (&*self.profile, vectors(at.q), vectors(by.q));
        let (section, mut blocks) = (profile.section(), [[Matrix3::zeros(); 4]; 4]);
        for station in profile.axial() {
            let stretch = self.stretch(station, &q);
            let n = section.axial * stretch.tangent.dot(&station.first(&dq));
            let h = stretch.stiffness(0.0, n) * station.weight;
            each_pair(|i, j| blocks[i][j] += h * (station.first[i] * station.first[j]));
        }
        for station in profile.bending() {
            let bend = self.bend(station, &q);
            let m = bend.rate(&station.both(&dq)) * section.bending;
            add_bending(station, &bend.stress_stiffness(&m), &mut blocks);
        }
        add_blocks(&blocks, k);
    }

    /// Requires |r′| > 0.01 at the quadrature points. A line cannot be inverted, but its strains are singular at r′ =
    /// 0.
    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let (profile, q) = (&*self.profile, vectors(at.q));
        let mut stations = profile.axial().iter().chain(profile.bending());
        let is_admissible = stations.all(|station| (self.direction + station.first(&q)).norm() > CRUSHED);
        (!is_admissible).then_some(Inadmissibility::InvertedElement)
    }

    fn damping_forces(&self, at: &Local<'_>, r: &mut [f64]) {
        if self.profile.damping() != CableDamping::default() {
            velocity_forces(self, at, r);
        }
    }

    fn rotation(&self, from: &Local<'_>, to: &Local<'_>) -> f64 {
        let [from, to] = [from, to].map(|at| vectors(at.q));
        let tangents = |station: &CableStation| [&from, &to].map(|q| self.direction + station.first(q));
        relative_rotation(self.profile.axial().iter().chain(self.profile.bending()).map(tangents))
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let (profile, q, v) = (&*self.profile, vectors(at.q), vectors(at.v));
        let momentum = self.mass_times(&v);
        let moved: Vector3<f64> = q.iter().zip(profile.first_moments()).map(|(q, m)| q * *m).sum();
        Energy {
            kinetic: 0.5 * momentum.iter().zip(&v).map(|(p, v)| p.dot(v)).sum::<f64>(),
            strain: self.parts(at.q).iter().sum(),
            potential: -at.load * profile.gravity().dot(&moved),
        }
    }
}

/// Calls `visit` for the lower pairs of the vectors of the element.
fn each_pair(mut visit: impl FnMut(usize, usize)) {
    for i in 0..4 {
        for j in 0..=i {
            visit(i, j);
        }
    }
}

/// Adds the stiffness of a station with respect to r′ and r″, times its weight.
fn add_bending(station: &CableStation, h: &BendBlocks, blocks: &mut [[Matrix3<f64>; 4]; 4]) {
    let h = h.scaled(station.weight);
    let (s, c, ab) = (&station.first, &station.second, h.ba.transpose());
    each_pair(|i, j| {
        blocks[i][j] += (h.aa * s[j] + ab * c[j]) * s[i] + (h.ba * s[j] + h.bb * c[j]) * c[i];
    });
}

impl Cable12 {
    /// Computes the tangent of N t with respect to a: w_q (EA t tᵀ + N ∂²ε/∂a²) + w_v EA τ t tᵀ, without w_q EA τ t ȧᵀ
    /// ∂t/∂a.
    pub(super) fn axial_stiffness(
        &self,
        station: &CableStation,
        q: &[Vector3<f64>; 4],
        v: &[Vector3<f64>; 4],
        w: Weights,
    ) -> Matrix3<f64> {
        let (rigidity, tau) = (self.profile.section().axial, self.profile.damping().stretch);
        let stretch = self.stretch(station, q);
        let n = self.profile.axial_force(&stretch, &station.first(v));
        stretch.stiffness(rigidity * (w.q + w.v * tau), w.q * n)
    }

    /// Computes the tangent of EI Lᵀ(β + τβ°) with respect to (a, b), without w_q EI τ Lᵀ ∂β°/∂(a, b).
    pub(super) fn bending_stiffness(
        &self,
        station: &CableStation,
        q: &[Vector3<f64>; 4],
        v: &[Vector3<f64>; 4],
        w: Weights,
    ) -> BendBlocks {
        let (rigidity, tau) = (self.profile.section().bending, self.profile.damping().bending);
        let bend = self.bend(station, q);
        let stiffness = bend.hessian().scaled(w.q * rigidity);
        if tau == 0.0 {
            return stiffness;
        }
        stiffness
            .plus(bend.damping(), w.v * tau * rigidity)
            .plus(bend.stress_stiffness(&bend.rate(&station.both(v))), w.q * tau * rigidity)
    }
}
