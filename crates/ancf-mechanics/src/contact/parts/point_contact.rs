use ancf_solver::equations::LocalMatrix;
use nalgebra::{Matrix3, Vector3};
use smallvec::SmallVec;

use super::foot::{Foot, NODE_TRANSITION};
use crate::laws::ContactLaw;

/// Weights of a vector of coordinates in d, and in the tangents r_α at constant parameters.
#[derive(Clone, Copy, Debug)]
pub struct FootWeight<const N: usize> {
    /// First coordinate.
    pub(in crate::contact) first: usize,
    pub(in crate::contact) place: f64,
    pub(in crate::contact) slopes: [f64; N],
}

/// Contact of a point with the axis or the surface of an element in a state.
#[derive(Clone, Copy, Debug)]
pub struct PointContact<'a, const N: usize> {
    pub(in crate::contact) law: &'a ContactLaw,
    /// Sum of both radii.
    pub(in crate::contact) radius: f64,
    /// Length of beam or area of shell that the point represents. It is negative for a contact that is subtracted.
    pub(in crate::contact) size: f64,
    pub(in crate::contact) foot: Foot<N>,
    /// Weights of the vectors of the point and the element. A vector may occur twice.
    pub(in crate::contact) weights: &'a [FootWeight<N>],
    /// Range of the parameters of the element.
    pub(in crate::contact) range: f64,
}

/// Bounds of the errors of d and r_α, as multiples of ε.
pub(in crate::contact) type FootErrors<const N: usize> = (f64, [f64; N]);

impl<const N: usize> PointContact<'_, N> {
    pub(in crate::contact) fn gap(&self) -> f64 {
        self.foot.d.norm() - self.radius
    }

    /// Returns the length or area that the contact represents.
    fn extent(&self) -> f64 {
        self.size * self.foot.share
    }

    /// Returns the normal force without damping, per length or area.
    pub(in crate::contact) fn pressure(&self) -> f64 {
        self.law.pressure(self.gap())
    }

    /// Returns the energy per length or area.
    pub(in crate::contact) fn unit_energy(&self) -> f64 {
        self.law.energy(self.gap())
    }

    pub(in crate::contact) fn energy(&self) -> f64 {
        self.extent() * self.unit_energy()
    }

    /// Returns the rate n·ḋ of the gap along the normal of this state, for velocities or displacements v.
    pub(in crate::contact) fn closing(&self, v: &[f64]) -> f64 {
        let n = self.foot.d.normalize();
        self.weights.iter().map(|weight| weight.place * n.dot(&vector(v, weight.first))).sum()
    }

    /// Returns ḋ and its derivatives by the parameters.
    fn rates(&self, v: &[f64]) -> (Vector3<f64>, [Vector3<f64>; N]) {
        let (mut rate, mut turning) = (Vector3::zeros(), [Vector3::zeros(); N]);
        for FootWeight { first, place, slopes } in self.weights {
            let velocity = vector(v, *first);
            rate += velocity * *place;
            turning.iter_mut().zip(slopes).for_each(|(turning, slope)| *turning -= velocity * *slope);
        }
        (rate, turning)
    }

    /// Returns the force on the point for a rate ḋ.
    fn force(&self, rate: &Vector3<f64>) -> Vector3<f64> {
        self.law.force(self.gap(), &self.foot.d.normalize(), rate) * self.extent()
    }

    /// Adds a force on the point, and its reaction at the foot, to the rows of a residual.
    fn add_force(&self, force: &Vector3<f64>, rows: &mut [f64]) {
        for FootWeight { first, place, .. } in self.weights {
            rows[*first..first + 3].iter_mut().zip(force).for_each(|(row, f)| *row -= place * f);
        }
    }

    /// Adds a normal force per length or area.
    pub(in crate::contact) fn add_normal(&self, pressure: f64, rows: &mut [f64]) {
        self.add_force(&(self.foot.d.normalize() * (self.extent() * pressure)), rows);
    }

    /// Adds the forces for velocities v.
    pub(in crate::contact) fn add_residual(&self, v: &[f64], rows: &mut [f64]) {
        let (rate, _) = self.rates(v);
        self.add_force(&self.force(&rate), rows);
    }

    /// Adds the velocity-dependent part of the forces.
    pub(in crate::contact) fn add_damping(&self, v: &[f64], rows: &mut [f64]) {
        let (rate, _) = self.rates(v);
        self.add_force(&(self.force(&rate) - self.force(&Vector3::zeros())), rows);
    }

    /// Adds a bound of the rounding errors of the forces for velocities v.
    ///
    /// Errors of d affect the gap, the direction and the foot, and at an end of the element the share.
    pub(in crate::contact) fn add_rounding(
        &self,
        v: &[f64],
        (size, of_slopes): FootErrors<N>,
        floor: &mut [f64],
    ) {
        let Foot { share, d, slopes, compliance, .. } = &self.foot;
        let gaps = size + self.radius;
        let sliding: [f64; N] = std::array::from_fn(|a| {
            (0..N).map(|b| compliance[a][b].abs() * (slopes[b].norm() * gaps + d.norm() * of_slopes[b])).sum()
        });
        let moved: f64 = slopes.iter().zip(&sliding).map(|(slope, sliding)| slope.norm() * sliding).sum();
        let tilt = (gaps + moved) / d.norm();
        let (rate, turning) = self.rates(v);
        let moving: f64 = self.weights.iter().map(|w| w.place.abs() * vector(v, w.first).norm()).sum();
        let turned: f64 =
            turning.iter().zip(&sliding).map(|(turning, sliding)| turning.norm() * sliding).sum();
        let transition = if *share < 1.0 {
            let of = |a: usize| gaps / slopes[a].norm() + sliding[a];
            (0..N).map(of).sum::<f64>() / (NODE_TRANSITION * self.range)
        } else {
            0.0
        };
        let errors = [gaps, tilt + transition, moving + turned];
        let bound = self.law.rounding(self.gap(), rate.norm(), errors) * self.size.abs();
        let force = self.force(&rate).norm();
        for FootWeight { first, place, slopes } in self.weights {
            let changed: f64 =
                slopes.iter().zip(&sliding).map(|(slope, sliding)| slope.abs() * sliding).sum();
            let error = bound * place.abs() + 4.0 * f64::EPSILON * force * changed;
            floor[*first..first + 3].iter_mut().for_each(|row| *row += error);
        }
    }

    /// Adds the symmetric part of the derivative of the forces along dq = w_q z, dv = w_v z.
    ///
    /// With the force F on d, and −F dx_α on r_α as the parameters move by dx_α = C_αβ (r_β·δd + d·δr_β).
    pub(in crate::contact) fn add_tangent(&self, v: &[f64], [w_q, w_v]: [f64; 2], k: &mut LocalMatrix<'_>) {
        let Foot { d, slopes, compliance, .. } = &self.foot;
        let ((rate, turning), distance) = (self.rates(v), d.norm());
        let n = d / distance;
        let bend = (Matrix3::identity() - n * n.transpose()) / distance;
        let law = self.law.slopes(self.gap(), &n, &bend, &rate);
        let [by_place, by_rate] = law.map(|slope| slope * self.extent());
        let force = self.force(&rate);
        let along: [Vector3<f64>; N] = std::array::from_fn(|a| by_rate * turning[a] - by_place * slopes[a]);
        let direct = by_place * w_q + by_rate * w_v;
        let direct = (direct + direct.transpose()) * -0.5;
        // For each vector and parameter: the force by dx_α, and dx_α by the vector.
        let vectors: SmallVec<[[[Vector3<f64>; 2]; N]; 32]> = self
            .weights
            .iter()
            .map(|weight| {
                std::array::from_fn(|a| {
                    let moved = (0..N).fold(Vector3::zeros(), |moved, b| {
                        moved + (slopes[b] * weight.place + d * weight.slopes[b]) * (compliance[a][b] * w_q)
                    });
                    [(along[a] * weight.place - force * weight.slopes[a]) * -0.5, moved]
                })
            })
            .collect();
        for (row, of_row) in self.weights.iter().zip(&vectors) {
            for (column, of_column) in self.weights.iter().zip(&vectors) {
                if column.first > row.first {
                    continue;
                }
                let mut block = direct * (row.place * column.place);
                for ([force, moved], [other_force, other_moved]) in of_row.iter().zip(of_column) {
                    block += force * other_moved.transpose() + moved * other_force.transpose();
                }
                for j in 0..3 {
                    let start = if row.first == column.first { j } else { 0 };
                    (start..3).for_each(|i| k.add(row.first + i, column.first + j, block[(i, j)]));
                }
            }
        }
    }
}

/// Returns the vector of three consecutive entries.
pub(in crate::contact) fn vector(x: &[f64], first: usize) -> Vector3<f64> {
    Vector3::new(x[first], x[first + 1], x[first + 2])
}
