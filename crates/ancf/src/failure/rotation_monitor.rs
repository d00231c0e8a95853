//! Rotations that the time steps do not resolve. Their instability becomes a warning.

use ancf_mechanics::kinematics::VectorKind;
use ancf_solver::equations::State;
use nalgebra::{Matrix3, Vector3};
use serde::{Deserialize, Serialize};

use crate::assembly::Assembly;
use crate::errors::short;
use crate::model::Model;
use crate::units::Scales;

/// Largest stable rotation per step of the generalized-α scheme with the spectral radius ρ, divided by 1 − ρ.
///
/// Index-3 equations are linearly unstable about a uniform rotation: the multipliers follow a recursion with the double root −ρ,
/// and the directions of the constraints rotate. Measured limits of ω h for ρ = 0.6, 0.7, 0.8, 0.9, 0.95: 0.341, 0.239, 0.152,
/// 0.072, 0.036.
const STABLE_ROTATION: f64 = 0.7;
/// Logarithm of the growth of a disturbance that is reported. The rate of growth per step is about ω h less its limit.
const GROWTH: f64 = 6.0;

/// Monitor of the rotations of rigid bodies and sections in a dynamic analysis.
#[derive(Debug)]
pub(crate) struct RotationMonitor {
    /// Largest stable rotation per step; `None` for other schemes.
    limit: Option<f64>,
    places: Vec<RotatingPlace>,
    history: RotationHistory,
}

/// Growth of disturbances so far.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct RotationHistory {
    /// Time of the last state.
    t: f64,
    /// Logarithm of the growth of a disturbance at each place.
    growth: Vec<f64>,
    /// First place with a large growth: time, rotation per step, rate of rotation, index of the place.
    found: Option<(f64, f64, f64, usize)>,
}

/// Rigid body, or section at a node: direction vectors with the same rotation.
#[derive(Debug)]
struct RotatingPlace {
    /// Index of the body.
    body: usize,
    /// First coordinates and reference values of the directions.
    directions: Vec<(usize, Vector3<f64>)>,
}

impl RotationMonitor {
    /// Monitor of a dynamic analysis from a time.
    pub(crate) fn new(model: &Model, assembly: &Assembly, start: f64) -> Self {
        let scheme = model.analysis.dynamics().map(|settings| settings.scheme.numbers());
        let limit = scheme.filter(|scheme| !scheme.is_newmark() && scheme.is_second_order()).map(|scheme| {
            let damping = -scheme.lead();
            STABLE_ROTATION * (1.0 - (1.0 - damping) / (1.0 + damping))
        });
        let (rest, mut places) = (assembly.rest(), Vec::<RotatingPlace>::new());
        for (body, (_, terms)) in assembly.bodies().enumerate().filter(|_| limit.is_some()) {
            let mut is_new = true;
            for vector in terms.vectors(&rest) {
                // The mixed derivative of a shell is no direction.
                if vector.kind == VectorKind::Twist {
                    continue;
                }
                if vector.is_position() {
                    is_new = true;
                    continue;
                }
                if is_new {
                    places.push(RotatingPlace { body, directions: Vec::new() });
                    is_new = false;
                }
                places
                    .last_mut()
                    .into_iter()
                    .for_each(|place| place.directions.push((vector.first, vector.value)));
            }
        }
        let history = RotationHistory { t: start, growth: vec![0.0; places.len()], found: None };
        Self { limit, places, history }
    }

    /// Examines the state at the end of a step.
    pub(crate) fn examine(&mut self, s: &State) {
        let Some(limit) = self.limit else { return };
        let RotationHistory { t, growth, found } = &mut self.history;
        let h = s.t - *t;
        for (i, (place, growth)) in self.places.iter().zip(growth).enumerate() {
            let rate = place.rate(s);
            *growth = (*growth + h * rate - limit).max(0.0);
            if *growth > GROWTH && found.is_none() {
                *found = Some((s.t, h * rate, rate, i));
            }
        }
        *t = s.t;
    }

    /// Warning of the first rotation that is not resolved.
    pub(crate) fn warning(&self, assembly: &Assembly, scales: Scales) -> Option<String> {
        let ((t, turned, rate, place), limit) = (self.history.found?, self.limit?);
        let (name, terms) = &assembly.bodies[self.places[place].body];
        let what = if terms.mesh().is_some() { "a section of body" } else { "body" };
        let [t, turned, largest] = [t * scales.time, turned, limit / rate * scales.time].map(short);
        Some(if limit > 0.0 {
            format!(
                "at t = {t} {what} `{name}` rotates by {turned} rad per step. With this scheme rotations above {} rad per \
                 step are unstable, and the energy may grow: use a step of at most {largest}, a smaller `spectral_radius` \
                 or `scheme = \"energy\"`",
                short(limit)
            )
        } else {
            format!(
                "at t = {t} {what} `{name}` rotates by {turned} rad per step. Without numerical damping all rotations are \
                 unstable, and the energy may grow: use `scheme = \"energy\"`, or a smaller `spectral_radius`"
            )
        })
    }

    pub(crate) fn history(&self) -> &RotationHistory {
        &self.history
    }

    /// Restores the history. Returns false if it belongs to another model.
    pub(crate) fn restore(&mut self, history: &RotationHistory) -> bool {
        let RotationHistory { t, growth, found } = history;
        let is_place = found.is_none_or(|(_, _, _, place)| place < self.places.len());
        let fits = growth.len() == self.places.len() && is_place && t.is_finite();
        let fits = fits && growth.iter().all(|x| x.is_finite());
        if fits {
            self.history.clone_from(history);
        }
        fits
    }
}

impl RotatingPlace {
    /// Rate of rotation ω: least squares of ḋ = ω × d over the directions d.
    fn rate(&self, s: &State) -> f64 {
        let (mut matrix, mut moment) = (Matrix3::zeros(), Vector3::zeros());
        for &(first, reference) in &self.directions {
            let d = reference + Vector3::from_column_slice(&s.q[first..first + 3]);
            let rate = Vector3::from_column_slice(&s.v[first..first + 3]);
            if self.directions.len() == 1 {
                return d.cross(&rate).norm() / d.norm_squared();
            }
            matrix += Matrix3::identity() * d.norm_squared() - d * d.transpose();
            moment += d.cross(&rate);
        }
        matrix.try_inverse().map_or(0.0, |inverse| (inverse * moment).norm())
    }
}
