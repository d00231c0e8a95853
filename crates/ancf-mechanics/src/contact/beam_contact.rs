use ancf_solver::equations::{
    Energy, Inadmissibility, LOCAL, Local, LocalMatrix, LocalStep, State, Term, Weights,
};
use nalgebra::{SMatrix, SVector, Vector3, Vector6};
use num_dual::DualSVec64;

use super::contact_law::ContactLaw;
use super::crossing::SMALLEST_DISTANCE;
use crate::kinematics::{ElementAxis, Marker, Real, constant};

/// Contact between a point of a beam axis and the axis of an element of another beam or the same beam.
///
/// With the closest point r(s) of the element and d = p − r(s), the gap is |d| minus both radii. The forces N d/|d| +
/// friction act on p and, reversed, on r(s). Since |d| is minimal at s, ∂|d|/∂s = 0. The forces are thus exact
/// derivatives at constant s. Only the tangent contains ds = (r′·δd + d·δr′)/(r′·r′ − d·r″). The relative velocity is
/// that of the axes, w = ṗ − Ṡᵢrᵢ. Friction treats beams as lines. It conserves momentum, and angular momentum except
/// for the couple of the friction forces over the distance of the axes.
///
/// A point belongs to the element that contains its projection. At a node it belongs to both elements by halves, so a
/// chain of elements with a smooth axis has a single contact. Beyond a free end it belongs to the end, which is round.
#[derive(Clone, Debug)]
pub struct BeamContact {
    point: Marker,
    axis: ElementAxis,
    coordinates: Vec<usize>,
    radius: f64,
    length: f64,
    ends: [bool; 2],
    law: ContactLaw,
}

/// Closest point of an element.
#[derive(Clone, Copy, Debug)]
struct ClosestPoint {
    s: f64,
    /// Share of this element in the contact.
    share: f64,
    /// Compliance ds/d(r′·δd + d·δr′). It is 0 at an end.
    compliance: f64,
}

/// Size of the transition between elements at a node, relative to their length.
const NODE_TRANSITION: f64 = 1e-6;
/// Number of start points in the search for the closest point of an element.
const START_POINTS: usize = 5;
const ITERATIONS: usize = 30;

impl BeamContact {
    /// Creates the contact of a point that represents a length of its beam.
    ///
    /// `radius` is the sum of both radii. `ends` marks the ends of the element that are free ends of its beam.
    pub fn new(
        point: &Marker,
        axis: &ElementAxis,
        ends: [bool; 2],
        radius: f64,
        length: f64,
        law: ContactLaw,
    ) -> Self {
        let mut coordinates: Vec<usize> = point.coordinates().chain(axis.coordinates()).collect();
        coordinates.sort_unstable();
        coordinates.dedup();
        let (point, axis) = (point.within(&coordinates), axis.within(&coordinates));
        Self { point, axis, coordinates, radius, length, ends, law }
    }

    /// Returns d, r′ and r″ at an arc length.
    fn distance_vector(&self, q: &[f64], s: f64) -> [Vector3<f64>; 3] {
        let [r, slope, curvature] = self.axis.at(q, s);
        [self.point.reference() + self.point.sum(q) - r, slope, curvature]
    }

    /// Returns the arc length of the closest point of the element.
    fn closest(&self, q: &[f64]) -> f64 {
        let span = self.axis.span();
        let length = span.end - span.start;
        let at = |k: usize| span.start + length * k as f64 / (START_POINTS - 1) as f64;
        let distance = |s: f64| self.distance_vector(q, s)[0].norm_squared();
        let mut best = (distance(span.start), span.start);
        for s in (1..START_POINTS).map(at) {
            let here = distance(s);
            if here < best.0 {
                best = (here, s);
            }
        }
        let mut s = best.1;
        for _ in 0..ITERATIONS {
            let [d, slope, curvature] = self.distance_vector(q, s);
            let square = slope.norm_squared();
            let bent = square - d.dot(&curvature);
            let step = d.dot(&slope) / if bent > 0.1 * square { bent } else { square };
            let next = (s + step).clamp(span.start, span.end);
            let moved = (next - s).abs();
            s = next;
            if moved <= f64::EPSILON * length {
                break;
            }
        }
        s
    }

    fn closest_point(&self, q: &[f64]) -> Option<ClosestPoint> {
        let (s, span) = (self.closest(q), self.axis.span());
        let [d, slope, curvature] = self.distance_vector(q, s);
        let length = span.end - span.start;
        let bent = slope.norm_squared() - d.dot(&curvature);
        // Distance of the projection beyond the end s, relative to the length. It is negative within the element.
        let over = d.dot(&slope) / (bent * length);
        let beyond_start = if s > span.start { (span.start - s) / length } else { -over };
        let beyond_end = if s < span.end { (s - span.end) / length } else { over };
        let part = |beyond: f64, free: bool| {
            if free { 1.0 } else { (0.5 - 0.5 * beyond / NODE_TRANSITION).clamp(0.0, 1.0) }
        };
        let share = part(beyond_start, self.ends[0]) * part(beyond_end, self.ends[1]);
        let inside = s > span.start && s < span.end;
        (share > 0.0).then(|| ClosestPoint { s, share, compliance: if inside { bent.recip() } else { 0.0 } })
    }

    /// Returns the foot with d, r′ and r″ there, if there is contact.
    fn contact_point(&self, q: &[f64]) -> Option<(ClosestPoint, [Vector3<f64>; 3])> {
        let foot = self.closest_point(q)?;
        let distance_vector = self.distance_vector(q, foot.s);
        (distance_vector[0].norm() < self.radius).then_some((foot, distance_vector))
    }

    /// Returns true if the bodies overlap in a state by more than a fraction of their radii.
    pub(crate) fn overlaps(&self, s: &State, part: f64) -> bool {
        let mut q = [0.0; LOCAL];
        self.coordinates.iter().zip(&mut q).for_each(|(&c, q)| *q = s.q[c]);
        self.distance_vector(&q, self.closest(&q))[0].norm() < (1.0 - part) * self.radius
    }

    /// Returns the force on p at d and ḋ.
    fn force<D: Real>(&self, share: f64, d: &Vector3<D>, rate: &Vector3<D>) -> Vector3<D> {
        let distance = d.dot(d).sqrt();
        let n = d.map(|x| x / distance);
        let normal = self.law.smooth_normal(distance - self.radius, n.dot(rate)) * (self.length * share);
        n.map(|x| x * normal) + self.law.smooth_tangential(D::from(normal.re()), &n, rate)
    }

    /// Returns ḋ and its derivative by s.
    fn rates(&self, at: &Local<'_>, s: f64) -> [Vector3<f64>; 2] {
        let [r, slope, _] = self.axis.sum(at.v, s);
        [self.point.sum(at.v) - r, -slope]
    }

    /// Returns first coordinates of vectors with their weights in d and r′ at constant s. A vector may occur twice.
    fn weights(&self, s: f64) -> impl Iterator<Item = (usize, [f64; 2])> + Clone {
        let [values, slopes, _] = self.axis.weights(s);
        let vectors = self.axis.vectors().iter().enumerate();
        let point = self.point.parts().iter().map(|&(first, w)| (first, [w, 0.0]));
        point.chain(vectors.map(move |(i, &first)| (first, [-values[i], slopes[i]])))
    }

    /// Computes ∂(forces on d and r′)/∂z along d(d, r′) = w_q z, d(ḋ, ṙ′) = w_v z.
    fn slope(&self, at: &Local<'_>, w: Weights) -> Option<(ClosestPoint, SMatrix<f64, 6, 6>)> {
        type Dual = DualSVec64<6>;
        let (foot, [d, along, _]) = self.contact_point(at.q)?;
        let [rate, turning] = self.rates(at, foot.s);
        let forces = |z: SVector<Dual, 6>| {
            let (first, second) = (z.fixed_rows::<3>(0), z.fixed_rows::<3>(3));
            let moved = constant::<Dual>(&along).dot(&first) + constant::<Dual>(&d).dot(&second);
            let ds = moved * (w.q * foot.compliance);
            let place = constant::<Dual>(&d) + first.map(|x| x * w.q) - along.map(|x| ds * x);
            let speed = constant::<Dual>(&rate) + first.map(|x| x * w.v) + turning.map(|x| ds * x);
            let force = self.force(foot.share, &place, &speed);
            let couple = force.map(|x| -x * ds);
            SVector::<Dual, 6>::from_fn(|i, _| if i < 3 { force[i] } else { couple[i - 3] })
        };
        Some((foot, num_dual::jacobian(forces, &Vector6::zeros()).1))
    }
}

impl Term for BeamContact {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let Some((foot, [d, ..])) = self.contact_point(at.q) else { return };
        let [rate, _] = self.rates(at, foot.s);
        let force = self.force(foot.share, &d, &rate);
        let [values, ..] = self.axis.weights(foot.s);
        self.point.add(-force, r);
        for (&first, weight) in self.axis.vectors().iter().zip(values) {
            r[first..first + 3].iter_mut().zip(&force).for_each(|(row, f)| *row += weight * f);
        }
    }

    /// Errors of d affect the gap, the direction and the foot, and at a node the share.
    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let Some((foot, [d, slope, _])) = self.contact_point(at.q) else { return };
        let [sizes, slopes] = self.axis.sizes(at.q, foot.s);
        let gaps = self.point.size(at.q) + sizes + self.radius;
        let sliding = (slope.norm() * gaps + d.norm() * slopes) * foot.compliance;
        let tilt = (gaps + slope.norm() * sliding) / d.norm();
        let [rate, turning] = self.rates(at, foot.s);
        let moving = self.weights(foot.s).map(|(first, [w, _])| w.abs() * vector(at.v, first).norm());
        let velocity_error = moving.sum::<f64>() + turning.norm() * sliding;
        let span = self.axis.span();
        let transition = if foot.share < 1.0 {
            (gaps / slope.norm() + sliding) / (NODE_TRANSITION * (span.end - span.start))
        } else {
            0.0
        };
        let gap = d.norm() - self.radius;
        let bound =
            self.law.rounding(gap, rate.norm(), [gaps, tilt + transition, velocity_error]) * self.length;
        let force = self.force(foot.share, &d, &rate).norm();
        for (first, [w, change]) in self.weights(foot.s) {
            let error = bound * w.abs() + 4.0 * f64::EPSILON * force * change.abs() * sliding;
            floor[first..first + 3].iter_mut().for_each(|row| *row += error);
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let Some((foot, h)) = self.slope(at, w) else { return };
        let h = (h + h.transpose()) * -0.5;
        let weights = self.weights(foot.s);
        for (row, a) in weights.clone() {
            for (column, b) in weights.clone().filter(|(column, _)| *column <= row) {
                for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                    if row + i >= column + j {
                        let mixed = a[0] * b[1] * h[(i, 3 + j)] + a[1] * b[0] * h[(3 + i, j)];
                        let straight = a[0] * b[0] * h[(i, j)] + a[1] * b[1] * h[(3 + i, 3 + j)];
                        k.add(row + i, column + j, straight + mixed);
                    }
                }
            }
        }
    }

    /// Requires a distance of more than half the sum of the radii. At smaller distances the force is close to its
    /// reversal.
    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let contact_point = self.contact_point(at.q);
        let is_admissible =
            contact_point.is_none_or(|(_, [d, ..])| d.norm() > SMALLEST_DISTANCE * self.radius);
        (!is_admissible).then_some(Inadmissibility::PressedThrough)
    }

    /// The normal force does the work of the potential between both ends. Damping and friction are those of the middle.
    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        self.residual(&step.middle, r);
        let energies = [step.from, step.to].map(|at| self.energy(&at).strain);
        let Some(foot) = self.closest_point(step.middle.q).filter(|_| energies != [0.0; 2]) else { return };
        let [d, ..] = self.distance_vector(step.middle.q, foot.s);
        let force = |q: &[f64]| {
            self.contact_point(q).map_or(0.0, |(foot, [d, ..])| {
                self.length * foot.share * self.law.pressure(d.norm() - self.radius)
            })
        };
        let forces = [step.from, step.middle, step.to].map(|at| force(at.q));
        let (mut moved, n) = ([0.0; LOCAL], d.normalize());
        (0..step.to.q.len()).for_each(|i| moved[i] = step.to.q[i] - step.from.q[i]);
        let weights = self.weights(foot.s);
        let apart: f64 = weights.clone().map(|(first, [w, _])| w * n.dot(&vector(&moved, first))).sum();
        let excess = ContactLaw::discrete_force(energies, apart, forces) - forces[1];
        for (first, [w, _]) in weights {
            (0..3).for_each(|k| r[first + k] -= excess * w * n[k]);
        }
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let contact_point = self.contact_point(at.q);
        let strain = contact_point.map_or(0.0, |(foot, [d, ..])| {
            self.length * foot.share * self.law.energy(d.norm() - self.radius)
        });
        Energy { strain, ..Energy::default() }
    }
}

fn vector(x: &[f64], first: usize) -> Vector3<f64> {
    Vector3::new(x[first], x[first + 1], x[first + 2])
}
