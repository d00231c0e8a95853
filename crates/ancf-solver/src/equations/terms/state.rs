use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::vectors::{copy, for_each_chunk, for_each_chunk_of};

/// State of a system at one time.
///
/// The coordinates q are *measured from the reference configuration*, e = e₀ + q. Strains are computed from
/// displacement gradients, so their accuracy does not depend on the distance of the model from the origin.
///
/// Velocities and accelerations of a state at rest occupy no memory before they are written.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Time t.
    pub t: f64,
    /// Coordinates q = e − e₀.
    pub q: Vec<f64>,
    /// Velocities v = dq/dt.
    pub v: Vec<f64>,
    /// Accelerations a = d²q/dt².
    pub a: Vec<f64>,
    /// Lagrange multipliers λ.
    pub lambda: Vec<f64>,
    /// Load factor s, which multiplies all loads including gravity. It differs from 1 in statics only.
    pub load: f64,
}

impl State {
    /// Creates the reference configuration at rest.
    pub fn rest(coordinates: usize, multipliers: usize) -> Self {
        let zeros = || vec![0.0; coordinates];
        Self { t: 0.0, q: zeros(), v: zeros(), a: zeros(), lambda: vec![0.0; multipliers], load: 1.0 }
    }

    /// Sets velocities and accelerations to zero.
    pub fn stop(&mut self) {
        for x in [&mut self.v, &mut self.a].into_iter().filter(|x| !is_zero(x)) {
            *x = vec![0.0; x.len()];
        }
    }

    /// Adds an increment z = (dz, dλ): q += w_q dz, v += w_v dz, a += w_a dz, λ += dλ.
    pub fn add(&mut self, z: &[f64], w: Weights) {
        let (dz, dlambda) = z.split_at(self.q.len());
        if w.is_static() {
            // In statics the zero velocities and accelerations are not written.
            for_each_chunk(&mut self.q, |range, q| q.iter_mut().zip(&dz[range]).for_each(|(q, dz)| *q += dz));
        } else {
            for_each_chunk_of([&mut self.q, &mut self.v, &mut self.a], |range, [q, v, a]| {
                for ((q, dz), (v, a)) in q.iter_mut().zip(&dz[range]).zip(v.iter_mut().zip(a)) {
                    *q += w.q * dz;
                    *v += w.v * dz;
                    *a += w.a * dz;
                }
            });
        }
        for (lambda, d) in self.lambda.iter_mut().zip(dlambda) {
            *lambda += d;
        }
    }

    /// Adds a multiple of a difference of states to q, v, a and λ.
    pub fn add_multiple(&mut self, difference: &Self, factor: f64) {
        let add = |x: &mut [f64], by: &[f64]| x.iter_mut().zip(by).for_each(|(x, by)| *x += factor * by);
        add(&mut self.q, &difference.q);
        add(&mut self.v, &difference.v);
        add(&mut self.a, &difference.a);
        add(&mut self.lambda, &difference.lambda);
    }

    /// Returns true if the state has the given sizes and all its numbers are finite.
    pub fn is_valid(&self, coordinates: usize, multipliers: usize) -> bool {
        let Self { t, q, v, a, lambda, load } = self;
        let of_coordinates = [q, v, a].iter().all(|x| x.len() == coordinates);
        let numbers = [q, v, a, lambda].into_iter().flatten().chain([t, load]);
        of_coordinates && lambda.len() == multipliers && numbers.into_iter().all(|x| x.is_finite())
    }

    /// Copies a state of the same size without allocation.
    pub fn copy_from(&mut self, other: &Self) {
        self.t = other.t;
        copy(&other.q, &mut self.q);
        self.lambda.copy_from_slice(&other.lambda);
        self.load = other.load;
        for (x, other) in [(&mut self.v, &other.v), (&mut self.a, &other.a)] {
            if !(is_zero(other) && is_zero(x)) {
                copy(other, x);
            }
        }
    }
}

impl Clone for State {
    fn clone(&self) -> Self {
        let copy = |x: &Vec<f64>| if is_zero(x) { vec![0.0; x.len()] } else { x.clone() };
        Self {
            t: self.t,
            q: self.q.clone(),
            v: copy(&self.v),
            a: copy(&self.a),
            lambda: self.lambda.clone(),
            load: self.load,
        }
    }
}

/// Returns true if all numbers are +0, as in a new allocation. In motions the first one ends the comparison.
fn is_zero(x: &[f64]) -> bool {
    x.iter().all(|x| x.to_bits() == 0)
}

/// Step of the energy-momentum scheme: its ends, its middle and its numerical damping
/// ([`LocalStep`](super::local::LocalStep)).
#[derive(Clone, Copy, Debug)]
pub struct StepStates<'a> {
    /// Start of the step.
    pub from: &'a State,
    /// Middle of the step.
    pub middle: &'a State,
    /// End of the step.
    pub to: &'a State,
    /// Numerical damping χ.
    pub damping: f64,
}

impl State {
    /// Returns the start of the step h of the energy-momentum scheme that ends in this state, with the accelerations a = (v₁ − v₀)/h and
    /// the multipliers of the step: v₀ = v₁ − h a and q₀ = q₁ − ½ h (v₀ + v₁).
    #[must_use]
    pub fn start_of_step(&self, h: f64) -> Self {
        let mut start = self.clone();
        for i in 0..self.q.len() {
            start.v[i] -= h * self.a[i];
            start.q[i] -= 0.5 * h * (start.v[i] + self.v[i]);
        }
        start.t -= h;
        start
    }

    /// Sets the middle of a step: means of the ends, with the accelerations and multipliers of the end.
    pub fn set_middle(&mut self, from: &Self, to: &Self) {
        let mean = |x: &mut [f64], from: &[f64], to: &[f64]| {
            x.iter_mut().zip(from.iter().zip(to)).for_each(|(x, (a, b))| *x = 0.5 * (a + b));
        };
        mean(&mut self.q, &from.q, &to.q);
        mean(&mut self.v, &from.v, &to.v);
        self.t = 0.5 * (from.t + to.t);
        self.a.copy_from_slice(&to.a);
        self.lambda.copy_from_slice(&to.lambda);
        self.load = to.load;
    }

    /// Returns the middle of a step on cubic polynomials through positions and velocities of both ends.
    pub(crate) fn middle_of_step(from: &Self, to: &Self) -> Self {
        let (mut s, h) = (to.clone(), to.t - from.t);
        s.set_middle(from, to);
        for i in 0..s.q.len() {
            s.q[i] += 0.125 * h * (from.v[i] - to.v[i]);
            s.v[i] = 1.5 * (to.q[i] - from.q[i]) / h - 0.25 * (from.v[i] + to.v[i]);
        }
        s
    }
}

/// Weights dq : dv : da of an increment dz, which are also the weights of stiffness, damping and mass in the tangent.
///
/// Every one-step scheme for second-order equations is such an affine map; (1, 0, 0) gives statics.
/// Source: follows the integrators of Drake, `multibody/fem`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Weights {
    /// dq/dz, weight of the stiffness.
    pub q: f64,
    /// dv/dz, weight of the damping.
    pub v: f64,
    /// da/dz, weight of the mass.
    pub a: f64,
}

impl Weights {
    /// Weights for unknown coordinates: the tangent is the stiffness matrix.
    pub const STIFFNESS: Self = Self { q: 1.0, v: 0.0, a: 0.0 };
    /// Weights for unknown velocities at fixed q: the tangent is the damping matrix.
    pub const DAMPING: Self = Self { q: 0.0, v: 1.0, a: 0.0 };
    /// Weights for unknown accelerations at fixed q and v: the tangent is the mass matrix.
    pub const MASS: Self = Self { q: 0.0, v: 0.0, a: 1.0 };

    /// Returns true for the weights of statics, where velocities and accelerations do not change.
    #[must_use]
    pub const fn is_static(self) -> bool {
        self.v == 0.0 && self.a == 0.0
    }

    /// Returns the weights of the middle of a step, whose start is fixed.
    #[must_use]
    pub const fn of_middle(self) -> Self {
        Self { q: 0.5 * self.q, v: 0.5 * self.v, a: self.a }
    }
}

/// Reason why a state is inadmissible. The equations of motion also have inadmissible solutions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum Inadmissibility {
    /// det J is not positive, or the axis of a cable is crushed.
    #[error("an element is inverted")]
    InvertedElement,
    /// The directors of a rigid body are a left-handed system.
    #[error("a rigid body is inverted")]
    InvertedBody,
    /// The distance of two ends has no direction.
    #[error("the ends of a spring coincide")]
    CoincidentEnds,
    /// A slider is beyond an end of its beam.
    #[error("a slider leaves its beam")]
    SliderEnd,
    /// The equations of a joint also hold half a turn away.
    #[error("a joint is half a turn from its place")]
    HalfTurn,
    /// The axes of bodies in contact intersect.
    #[error("bodies in contact are pressed through each other")]
    PressedThrough,
    /// The volume of a gas is not positive.
    #[error("the volume of a gas vanishes")]
    EmptyVolume,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Copies of states at rest and in motion over each other are bit-identical.
    #[test]
    fn copies_are_equal() {
        let rest = State::rest(3, 1);
        let mut moving = State { t: 0.5, lambda: vec![2.0], load: 0.25, ..rest.clone() };
        moving.v.copy_from_slice(&[0.0, -0.0, 1.0]);
        moving.a.copy_from_slice(&[-0.0; 3]);
        let bits = |s: &State| {
            [&s.q, &s.v, &s.a, &s.lambda].map(|x| x.iter().map(|x| x.to_bits()).collect::<Vec<_>>())
        };
        for (from, to) in [(&rest, &moving), (&moving, &rest), (&moving, &moving), (&rest, &rest)] {
            let mut copy = to.clone();
            assert_eq!(bits(&copy), bits(to));
            copy.copy_from(from);
            assert_eq!((bits(&copy), copy.t, copy.load), (bits(from), from.t, from.load));
            copy.stop();
            assert_eq!(bits(&copy)[1..3], bits(&rest)[1..3]);
        }
    }
}
