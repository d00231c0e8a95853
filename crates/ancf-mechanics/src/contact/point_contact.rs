use ancf_solver::equations::LocalMatrix;
use nalgebra::{Matrix3, Vector3};

use super::axis_curve::AxisCurve;
use crate::kinematics::ElementAxis;
use crate::laws::ContactLaw;

/// Foot of a point on the axis of an element: its closest point r(s), with d = p − r(s).
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot {
    /// Position ξ in the element.
    pub(super) xi: f64,
    /// Share of this element in the contact.
    pub(super) share: f64,
    pub(super) d: Vector3<f64>,
    /// r′.
    slope: Vector3<f64>,
    /// Compliance ds/d(r′·δd + d·δr′). It is 0 at an end.
    compliance: f64,
}

/// Size of the transition between elements at a node, relative to their length.
pub(super) const NODE_TRANSITION: f64 = 1e-6;

impl Foot {
    /// Finds the foot of a point on an element with a length, if the element has a share in the contact.
    ///
    /// `ends` marks the free ends of the beam.
    pub(super) fn new(point: &Vector3<f64>, curve: &AxisCurve, length: f64, ends: [bool; 2]) -> Option<Self> {
        let xi = curve.closest(point);
        let [r, slope, curvature] = curve.at(xi);
        let d = point - r;
        let bent = slope.norm_squared() - d.dot(&curvature);
        // Distance of the projection beyond the end ξ, relative to the length. It is negative within the element.
        let over = d.dot(&slope) / bent;
        let beyond = [if xi > 0.0 { -xi } else { -over }, if xi < 1.0 { xi - 1.0 } else { over }];
        let part = |beyond: f64, free: bool| {
            if free { 1.0 } else { (0.5 - 0.5 * beyond / NODE_TRANSITION).clamp(0.0, 1.0) }
        };
        let share = part(beyond[0], ends[0]) * part(beyond[1], ends[1]);
        let is_inside = xi > 0.0 && xi < 1.0;
        let compliance = if is_inside { length * length / bent } else { 0.0 };
        (share > 0.0).then(|| Self { xi, share, d, slope: slope / length, compliance })
    }
}

/// Contact of a point of a beam with the axis of an element in a state.
#[derive(Clone, Copy, Debug)]
pub(super) struct PointContact<'a> {
    pub(super) law: &'a ContactLaw,
    /// Sum of both radii, and the length of beam that the point represents.
    pub(super) radius: f64,
    pub(super) length: f64,
    pub(super) foot: Foot,
    /// First coordinates and weights of the vectors of the point.
    pub(super) point: &'a [(usize, f64)],
    pub(super) axis: &'a ElementAxis,
}

impl PointContact<'_> {
    pub(super) fn gap(&self) -> f64 {
        self.foot.d.norm() - self.radius
    }

    /// Returns the length of beam that the contact represents.
    fn extent(&self) -> f64 {
        self.length * self.foot.share
    }

    /// Returns the normal force without damping.
    pub(super) fn pressure(&self) -> f64 {
        self.extent() * self.law.pressure(self.gap())
    }

    pub(super) fn energy(&self) -> f64 {
        self.extent() * self.law.energy(self.gap())
    }

    /// Returns first coordinates of vectors with their weights in d and r′ at constant s. A vector may occur twice.
    pub(super) fn weights(&self) -> impl Iterator<Item = (usize, [f64; 2])> + Clone {
        let [values, slopes, _] = self.axis.weights_at(self.foot.xi);
        let vectors = self.axis.vectors().iter().enumerate();
        let point = self.point.iter().map(|&(first, w)| (first, [w, 0.0]));
        point.chain(vectors.map(move |(i, &first)| (first, [-values[i], slopes[i]])))
    }

    /// Returns ḋ and its derivative by s.
    fn rates(&self, v: &[f64]) -> [Vector3<f64>; 2] {
        let mut rates = [Vector3::zeros(); 2];
        for (first, [w, change]) in self.weights() {
            let velocity = vector(v, first);
            rates[0] += velocity * w;
            rates[1] -= velocity * change;
        }
        rates
    }

    /// Returns the force on the point for a rate ḋ.
    fn force(&self, rate: &Vector3<f64>) -> Vector3<f64> {
        self.law.force(self.gap(), &self.foot.d.normalize(), rate) * self.extent()
    }

    /// Adds a force on the point, and its reaction at the foot, to the rows of a residual.
    pub(super) fn add_force(&self, force: &Vector3<f64>, rows: &mut [f64]) {
        for (first, [w, _]) in self.weights() {
            rows[first..first + 3].iter_mut().zip(force).for_each(|(row, f)| *row -= w * f);
        }
    }

    /// Adds the forces for velocities v.
    pub(super) fn add_residual(&self, v: &[f64], rows: &mut [f64]) {
        let [rate, _] = self.rates(v);
        self.add_force(&self.force(&rate), rows);
    }

    /// Adds the velocity-dependent part of the forces.
    pub(super) fn add_damping(&self, v: &[f64], rows: &mut [f64]) {
        let [rate, _] = self.rates(v);
        self.add_force(&(self.force(&rate) - self.force(&Vector3::zeros())), rows);
    }

    /// Adds a bound of the rounding errors of the forces for coordinates q and velocities v.
    ///
    /// `size` bounds the error of the point. Errors of d affect the gap, the direction and the foot, and at a node the share.
    pub(super) fn add_rounding(&self, [q, v]: [&[f64]; 2], size: f64, floor: &mut [f64]) {
        let Foot { xi, share, d, slope, compliance } = self.foot;
        let [sizes, slopes] = self.axis.sizes(q, xi);
        let gaps = size + sizes + self.radius;
        let sliding = (slope.norm() * gaps + d.norm() * slopes) * compliance;
        let tilt = (gaps + slope.norm() * sliding) / d.norm();
        let [rate, turning] = self.rates(v);
        let moving = self.weights().map(|(first, [w, _])| w.abs() * vector(v, first).norm());
        let velocity_error = moving.sum::<f64>() + turning.norm() * sliding;
        let transition = if share < 1.0 {
            (gaps / slope.norm() + sliding) / (NODE_TRANSITION * self.axis.length())
        } else {
            0.0
        };
        let errors = [gaps, tilt + transition, velocity_error];
        let bound = self.law.rounding(self.gap(), rate.norm(), errors) * self.length;
        let force = self.force(&rate).norm();
        for (first, [w, change]) in self.weights() {
            let error = bound * w.abs() + 4.0 * f64::EPSILON * force * change.abs() * sliding;
            floor[first..first + 3].iter_mut().for_each(|row| *row += error);
        }
    }

    /// Adds the symmetric part of the derivative of the forces along dq = w_q z, dv = w_v z.
    ///
    /// With the forces F on d, and −F ds on r′ as s moves by ds = e·(δd, δr′), e = (r′, d) × compliance.
    pub(super) fn add_tangent(&self, v: &[f64], [w_q, w_v]: [f64; 2], k: &mut LocalMatrix<'_>) {
        let Foot { d, slope, compliance, .. } = self.foot;
        let ([rate, turning], distance) = (self.rates(v), d.norm());
        let n = d / distance;
        let bend = (Matrix3::identity() - n * n.transpose()) / distance;
        let slopes = self.law.slopes(self.gap(), &n, &bend, &rate);
        let [by_place, by_rate] = slopes.map(|slope| slope * self.extent());
        let along = by_rate * turning - by_place * slope;
        let force = self.force(&rate);
        let [of_place, of_slope] = [slope, d].map(|e| e * (w_q * compliance));
        let first = by_place * w_q + by_rate * w_v + along * of_place.transpose();
        let blocks = [
            (first + first.transpose()) * -0.5,
            (along * of_slope.transpose() - of_place * force.transpose()) * -0.5,
            (force * of_slope.transpose() + of_slope * force.transpose()) * 0.5,
        ];
        self.add_blocks(&blocks, k);
    }

    /// Adds the second derivative [H₁₁, H₁₂; H₁₂ᵀ, H₂₂] by (d, r′).
    fn add_blocks(&self, [straight, mixed, bent]: &[Matrix3<f64>; 3], k: &mut LocalMatrix<'_>) {
        let weights = self.weights();
        for (row, [a, b]) in weights.clone() {
            let of_d = straight * a + mixed.transpose() * b;
            let of_slope = mixed * a + bent * b;
            for (column, [c, d]) in weights.clone().filter(|(column, _)| *column <= row) {
                let block = of_d * c + of_slope * d;
                for j in 0..3 {
                    let start = if row == column { j } else { 0 };
                    (start..3).for_each(|i| k.add(row + i, column + j, block[(i, j)]));
                }
            }
        }
    }
}

/// Returns the vector of three consecutive entries.
pub(super) fn vector(x: &[f64], first: usize) -> Vector3<f64> {
    Vector3::new(x[first], x[first + 1], x[first + 2])
}
