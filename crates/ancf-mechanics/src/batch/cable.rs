use std::sync::Arc;

use ancf_solver::equations::{LANES, Lanes, LocalLanes, Weights};
use pulp::Simd;

use super::batched::{BatchTerm, TermBatch, consecutive, elements_of_bodies};
use super::bend::BendLanes;
use super::kernel::{BatchKernel, KernelBatch};
use super::relative::VectorLayout;
use super::stiffness::{add, times, transposed};
use super::triangle::{VectorBlocks, lower};
use crate::elements::{CRUSHED, Cable12, CableDamping, CableProfile, CableStation};
use crate::lanes::{Lane, LaneNumber, Pass, VectorLanes, added, dot, minus, plus, scaled};

/// Batch of cable elements with a common profile.
#[derive(Debug)]
struct CableBatch {
    count: usize,
    profile: Arc<CableProfile>,
    /// Reference direction of each element.
    direction: [Lanes; 3],
}

impl BatchTerm for Cable12 {
    fn batches(elements: &[&Self]) -> Vec<TermBatch> {
        let of = |(first, elements): (usize, &[&Self])| {
            let profile = &elements[0].profile;
            let shared = elements.iter().all(|element| Arc::ptr_eq(&element.profile, profile));
            let component = |axis: usize| -> Vec<f64> {
                elements.iter().map(|element| element.direction[axis]).collect()
            };
            let direction = std::array::from_fn(|axis| Lanes::of(&component(axis)));
            let batch = CableBatch { count: elements.len(), profile: Arc::clone(profile), direction };
            shared.then(|| consecutive(first, KernelBatch(batch)))
        };
        elements_of_bodies(elements).filter_map(of).collect()
    }
}

/// Vectors ℓ r_x₁, r₂ − r₁ and ℓ r_x₂ of a pass.
type Line<S> = [VectorLanes<S>; 3];

/// Vectors of a [`Line`] among the vectors of the element.
const LINE: VectorLayout<3, 0> = VectorLayout { axis: [(1, false), (2, true), (3, false)], y: [], z: [] };

#[inline(always)]
fn line<S: Simd>(pass: Pass<S>, x: &[Lanes]) -> Line<S> {
    let of = |i: usize| pass.vector(&x[3 * i..3 * i + 3]);
    [of(1), minus(of(2), of(0)), of(3)]
}

/// Computes Σ w x.
#[inline(always)]
fn mixed<S: Simd>(pass: Pass<S>, x: &Line<S>, weights: &[f64; 4]) -> VectorLanes<S> {
    let sum = plus(scaled(x[1], pass.splat(weights[2])), x[0], pass.splat(weights[1]));
    plus(sum, x[2], pass.splat(weights[3]))
}

/// Distributes a force on Σ w x to the vectors x.
#[inline(always)]
fn spread<S: Simd>(pass: Pass<S>, f: VectorLanes<S>, weights: &[f64; 4], force: &mut Line<S>) {
    for i in 0..3 {
        force[i] = plus(force[i], f, pass.splat(weights[i + 1]));
    }
}

/// Stretch as defined by [`AxialStretch`](crate::kinematics::AxialStretch).
struct StretchLanes<S: Simd> {
    strain: Lane<S>,
    /// Inverse 1/|a|.
    shortness: Lane<S>,
    tangent: VectorLanes<S>,
}

impl CableBatch {
    #[inline(always)]
    fn stretch<S: Simd>(&self, pass: Pass<S>, station: &CableStation, q: &Line<S>) -> StretchLanes<S> {
        let (a0, u, one) = (pass.vector(&self.direction), mixed(pass, q, &station.first), pass.splat(1.0));
        let a = added(a0, u);
        let length = dot(a, a).sqrt();
        let shortness = one.over(length);
        StretchLanes {
            strain: dot(added(a0, a), u).over(length + one),
            shortness,
            tangent: scaled(a, shortness),
        }
    }

    #[inline(always)]
    fn bend<S: Simd>(&self, pass: Pass<S>, station: &CableStation, q: &Line<S>) -> BendLanes<S> {
        let a = added(pass.vector(&self.direction), mixed(pass, q, &station.first));
        BendLanes::new(pass, a, mixed(pass, q, &station.second))
    }

    /// Returns ε + τ ε̇.
    #[inline(always)]
    fn retarded_strain<S: Simd>(
        &self,
        pass: Pass<S>,
        station: &CableStation,
        stretch: &StretchLanes<S>,
        v: &Line<S>,
    ) -> Lane<S> {
        let tau = self.profile.damping().stretch;
        if tau == 0.0 {
            return stretch.strain;
        }
        dot(stretch.tangent, mixed(pass, v, &station.first)).mul_add(pass.splat(tau), stretch.strain)
    }

    /// Returns β°.
    #[inline(always)]
    fn rate<S: Simd>(
        &self,
        pass: Pass<S>,
        station: &CableStation,
        bend: &BendLanes<S>,
        v: &Line<S>,
    ) -> VectorLanes<S> {
        bend.rate(pass, mixed(pass, v, &station.first), mixed(pass, v, &station.second))
    }

    /// Computes M (a + α v) minus gravity.
    #[inline(always)]
    fn inertia<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>) -> [VectorLanes<S>; 4] {
        let (profile, mass_damping) = (&*self.profile, self.profile.damping().mass);
        let (mut moved, mut rows) = ([pass.zeros(); 4], [pass.zeros(); 4]);
        for i in 0..4 {
            moved[i] = pass.vector(&at.a[3 * i..3 * i + 3]);
            if mass_damping != 0.0 {
                moved[i] = plus(moved[i], pass.vector(&at.v[3 * i..3 * i + 3]), pass.splat(mass_damping));
            }
        }
        for i in 0..4 {
            for axis in 0..3 {
                rows[i][axis] = pass.splat(-profile.gravity()[axis] * at.load * profile.first_moments()[i]);
            }
            for j in 0..4 {
                rows[i] = plus(rows[i], moved[j], pass.splat(profile.mass()[i][j]));
            }
        }
        rows
    }
}

impl BatchKernel for CableBatch {
    fn count(&self) -> usize {
        self.count
    }

    fn is_damped(&self) -> bool {
        self.profile.damping() != CableDamping::default()
    }

    #[inline(always)]
    fn add_residual<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, r: &mut [Lanes]) {
        let (profile, q, v) = (&*self.profile, line(pass, at.q), line(pass, at.v));
        let (section, tau) = (profile.section(), profile.damping().bending);
        let mut force = [pass.zeros(); 3];
        for station in profile.axial() {
            let stretch = self.stretch(pass, station, &q);
            let n = self.retarded_strain(pass, station, &stretch, &v);
            let n = n * pass.splat(station.weight * section.axial);
            spread(pass, scaled(stretch.tangent, n), &station.first, &mut force);
        }
        for station in profile.bending() {
            let bend = self.bend(pass, station, &q);
            let mut m = bend.strain();
            if tau != 0.0 {
                m = plus(m, self.rate(pass, station, &bend, &v), pass.splat(tau));
            }
            let [of_a, of_b] = bend.force(scaled(m, pass.splat(station.weight * section.bending)));
            spread(pass, of_a, &station.first, &mut force);
            spread(pass, of_b, &station.second, &mut force);
        }
        let mut rows = self.inertia(pass, at);
        rows[0] = minus(rows[0], force[1]);
        for i in 0..3 {
            rows[i + 1] = added(rows[i + 1], force[i]);
        }
        for i in 0..4 {
            for axis in 0..3 {
                let row = &mut r[3 * i + axis];
                pass.store(row, pass.load(row) + rows[i][axis]);
            }
        }
    }

    #[inline(always)]
    fn set_tangent<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, w: Weights, k: &mut [Lanes]) {
        let (profile, q, v) = (&*self.profile, line(pass, at.q), line(pass, at.v));
        let mut blocks = VectorBlocks::<S, 3, 0>::zero(pass);
        let CableDamping { stretch, bending, .. } = profile.damping();
        if w.q != 0.0 || w.v * (stretch + bending) != 0.0 {
            for station in profile.axial() {
                let stretch = self.stretch(pass, station, &q);
                let strain = self.retarded_strain(pass, station, &stretch, &v);
                self.add_axial(pass, station, (&stretch, strain), w, &mut blocks);
            }
            for station in profile.bending() {
                self.add_bending(pass, station, [&q, &v], w, &mut blocks);
            }
        }
        blocks.write::<4>(pass, &LINE, k);
        let inertia = w.a + w.v * profile.damping().mass;
        for i in 0..4 {
            for j in 0..=i {
                let mass = pass.splat(inertia * profile.mass()[i][j]);
                for axis in 0..3 {
                    let entry = &mut k[lower(12, 3 * i + axis, 3 * j + axis)];
                    pass.store(entry, pass.load(entry) + mass);
                }
            }
        }
    }

    /// The axial force alone is predicted, as by the element.
    #[inline(always)]
    fn set_predicted<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, from: &[Lanes], k: &mut [Lanes]) {
        let (q, v, before) = (line(pass, at.q), line(pass, at.v), line(pass, from));
        let mut change = q;
        change.iter_mut().zip(before).for_each(|(q, before)| *q = minus(*q, before));
        let mut blocks = VectorBlocks::<S, 3, 0>::zero(pass);
        for station in self.profile.axial() {
            let (now, start) = (self.stretch(pass, station, &q), self.stretch(pass, station, &before));
            let predicted = start.strain + dot(start.tangent, mixed(pass, &change, &station.first));
            let rate = self.retarded_strain(pass, station, &now, &v) - now.strain;
            self.add_axial(pass, station, (&now, predicted + rate), Weights::STIFFNESS, &mut blocks);
        }
        for station in self.profile.bending() {
            self.add_bending(pass, station, [&q, &v], Weights::STIFFNESS, &mut blocks);
        }
        blocks.write::<4>(pass, &LINE, k);
    }

    #[inline(always)]
    fn energies<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>) -> [Lane<S>; 3] {
        let (profile, q) = (&*self.profile, line(pass, at.q));
        let [mut kinetic, mut strain, mut potential] = [pass.zero(); 3];
        for station in profile.axial() {
            let e = self.stretch(pass, station, &q).strain;
            strain = (e * e).mul_add(pass.splat(0.5 * station.weight * profile.section().axial), strain);
        }
        for station in profile.bending() {
            let e = self.bend(pass, station, &q).strain();
            strain = dot(e, e).mul_add(pass.splat(0.5 * station.weight * profile.section().bending), strain);
        }
        let gravity = profile.gravity() * -at.load;
        let gravity = [pass.splat(gravity[0]), pass.splat(gravity[1]), pass.splat(gravity[2])];
        for i in 0..4 {
            let (q, v) = (pass.vector(&at.q[3 * i..3 * i + 3]), pass.vector(&at.v[3 * i..3 * i + 3]));
            potential = dot(gravity, q).mul_add(pass.splat(profile.first_moments()[i]), potential);
            for j in 0..4 {
                let other = pass.vector(&at.v[3 * j..3 * j + 3]);
                kinetic = dot(v, other).mul_add(pass.splat(0.5 * profile.mass()[i][j]), kinetic);
            }
        }
        [kinetic, strain, potential]
    }

    #[inline(always)]
    fn check_admissible<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, admissible: &mut [bool; LANES]) {
        let q = line(pass, at.q);
        for station in self.profile.axial().iter().chain(self.profile.bending()) {
            let a = added(pass.vector(&self.direction), mixed(pass, &q, &station.first));
            let mut length = Lanes([1.0; LANES]);
            pass.store(&mut length, dot(a, a).sqrt());
            admissible
                .iter_mut()
                .zip(length.0)
                .for_each(|(admissible, length)| *admissible &= length > CRUSHED);
        }
    }
}

impl CableBatch {
    /// Adds (c − n/|a|) t tᵀ + n/|a| I for the stiffness c and the force n of a strain.
    #[inline(always)]
    fn add_axial<S: Simd>(
        &self,
        pass: Pass<S>,
        station: &CableStation,
        (stretch, strain): (&StretchLanes<S>, Lane<S>),
        w: Weights,
        blocks: &mut VectorBlocks<S, 3, 0>,
    ) {
        let (rigidity, tau) = (self.profile.section().axial * station.weight, self.profile.damping().stretch);
        let n = strain * pass.splat(rigidity * w.q);
        let n = n * stretch.shortness;
        let c = pass.splat(rigidity * (w.q + w.v * tau)) - n;
        let t = stretch.tangent;
        let x = scaled(t, c);
        let (xy, xz, yz) = (x[0] * t[1], x[0] * t[2], x[1] * t[2]);
        let diagonal = [x[0].mul_add(t[0], n), x[1].mul_add(t[1], n), x[2].mul_add(t[2], n)];
        let h = [diagonal[0], xy, xz, xy, diagonal[1], yz, xz, yz, diagonal[2]];
        for i in 0..3 {
            for j in 0..=i {
                let weight = station.first[i + 1] * station.first[j + 1];
                add(&mut blocks.axis[i][j], &h, pass.splat(weight));
            }
        }
    }

    #[inline(always)]
    fn add_bending<S: Simd>(
        &self,
        pass: Pass<S>,
        station: &CableStation,
        [q, v]: [&Line<S>; 2],
        w: Weights,
        blocks: &mut VectorBlocks<S, 3, 0>,
    ) {
        let rigidity = self.profile.section().bending * station.weight;
        let (tau, bend) = (self.profile.damping().bending, self.bend(pass, station, q));
        let mut h = bend.hessian(pass, rigidity * w.q);
        if tau != 0.0 {
            let rate = self.rate(pass, station, &bend, v);
            bend.add_stress_stiffness(pass, scaled(rate, pass.splat(tau * rigidity * w.q)), &mut h);
            bend.add_damping(pass, tau * rigidity * w.v, &mut h);
        }
        let (s, c, ab) = (&station.first, &station.second, transposed(&h.ba));
        for j in 0..3 {
            let (s_j, c_j) = (pass.splat(s[j + 1]), pass.splat(c[j + 1]));
            let (mut of_a, mut of_b) = (times(&h.aa, s_j), times(&h.ba, s_j));
            add(&mut of_a, &ab, c_j);
            add(&mut of_b, &h.bb, c_j);
            for i in j..3 {
                add(&mut blocks.axis[i][j], &of_a, pass.splat(s[i + 1]));
                add(&mut blocks.axis[i][j], &of_b, pass.splat(c[i + 1]));
            }
        }
    }
}
