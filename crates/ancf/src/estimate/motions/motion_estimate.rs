use ancf_solver::dynamics::TimeStepper;
use ancf_solver::equations::{State, System};
use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::super::finer::FinerMesh;
use super::super::gap_field::GapField;
use super::super::movement::coordinate_sizes;
use super::super::value_errors::{ValueError, ValueErrors};
use super::motion_errors::{MotionErrors, ProbeErrors};
use crate::assembly::Assembly;
use crate::model::{Model, Quantity};
use crate::units::{Dimension, Scales};

/// Estimate of the errors of a motion. The forces of the gaps cause those of the mesh, or they follow from a motion on a finer mesh.
pub(crate) struct MotionEstimate<'a> {
    model: &'a Model,
    assembly: &'a Assembly,
    scales: Scales,
    /// Size of each coordinate.
    sizes: Vec<f64>,
    history: EstimateHistory,
}

/// Values of earlier states on which the estimate depends.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct EstimateHistory {
    /// Times and inner moments of the last states since the start or the last jump, the latest first.
    moments: Vec<(f64, Vec<f64>)>,
    /// Number of steps between the last and the next forces of the gaps, and the number of those that are left.
    stride: u32,
    wait: u32,
    errors: MotionErrors,
}

/// Largest number of steps between forces of the gaps.
const LONGEST_STRIDE: u32 = 4;
/// Relative differences of forces from their extrapolation below which the number of steps is doubled, and above which it is halved.
const SMOOTH: f64 = 0.02;
const ROUGH: f64 = 0.1;

impl EstimateHistory {
    /// Plans the step of the next forces by the relative difference of the last ones from their extrapolation.
    fn plan(&mut self, difference: Option<f64>) {
        match difference {
            Some(difference) if difference < SMOOTH => self.stride = (2 * self.stride).min(LONGEST_STRIDE),
            Some(difference) if difference > ROUGH => self.stride = (self.stride / 2).max(1),
            _ => {}
        }
        self.wait = self.stride - 1;
    }
}

/// Number of inner moments of a second derivative.
const MOMENTS: usize = 3;

impl<'a> MotionEstimate<'a> {
    /// Creates the estimate of a motion at its start.
    pub(crate) fn new(model: &'a Model, assembly: &'a Assembly, scales: Scales) -> Self {
        let motions = assembly.recorded_quantities.iter().filter(|probe| probe.quantity == Quantity::Motion);
        let of_probe = |name: &str| ProbeErrors { probe: name.to_owned(), ..ProbeErrors::default() };
        let errors = MotionErrors {
            probes: motions.map(|probe| of_probe(&probe.name)).collect(),
            are_steps_known: true,
            is_mesh_known: true,
            is_rough: false,
            kinked_steps: 0,
            law: 0.0,
            finer: None,
            values: Vec::new(),
        };
        let sizes = coordinate_sizes(model, assembly);
        Self {
            model,
            assembly,
            scales,
            sizes,
            history: EstimateHistory { moments: Vec::new(), stride: 1, wait: 0, errors },
        }
    }

    /// Evaluates the errors of the current state, if it is to be recorded, and sets the forces of the gaps.
    ///
    /// Returns the errors of the columns.
    pub(crate) fn advance(
        &mut self,
        dynamics: &mut TimeStepper<'_, System>,
        is_recorded: bool,
    ) -> Option<&[ValueError]> {
        let state = dynamics.state();
        let has_forces = dynamics.errors().is_some_and(|errors| errors.has_forces());
        if !has_forces {
            self.history.moments.clear();
            (self.history.stride, self.history.wait) = (1, 0);
        }
        if self.history.wait > 0 || !self.history.errors.is_mesh_known {
            self.history.wait = self.history.wait.saturating_sub(1);
            if is_recorded {
                let field = GapField::at_probes(self.model, self.assembly, state);
                self.evaluate(dynamics, &field);
            }
        } else {
            let field = GapField::in_motion(self.model, self.assembly, state);
            self.history.errors.is_mesh_known &= !field.is_unknown();
            self.history.errors.is_rough |= field.is_rough();
            self.history.errors.law = self.history.errors.law.max(field.law());
            if is_recorded {
                self.evaluate(dynamics, &field);
            }
            if self.history.errors.is_mesh_known {
                let forces = self.forces(state, &field);
                let difference = dynamics.set_mesh_forces(&forces);
                self.history.plan(difference);
            }
        }
        is_recorded.then_some(&self.history.errors.values)
    }

    /// Forces of the gaps g − B̈, with the inertia forces B̈ of the displacements within the elements.
    fn forces(&mut self, state: &State, field: &GapField<'_>) -> Vec<f64> {
        let mut forces = field.forces().total;
        forces.truncate(state.q.len());
        let moments = &mut self.history.moments;
        moments.insert(0, (state.t, field.inner_moments()));
        moments.truncate(MOMENTS);
        if let [(t, now), (t_before, before), (t_first, first)] = moments.as_slice() {
            let [mut later, mut change] = [0.0; 2];
            let rate = |now: f64, before: f64, h: f64| (now - before) / h;
            let [h, earlier] = [t - t_before, t_before - t_first];
            let seconds: Vec<f64> = (0..forces.len())
                .map(|i| {
                    let now = rate(now[i], before[i], h);
                    let difference = now - rate(before[i], first[i], earlier);
                    later += (self.sizes[i] * now).powi(2);
                    change += (self.sizes[i] * difference).powi(2);
                    difference / (0.5 * (h + earlier))
                })
                .collect();
            // Vibrations that the steps do not resolve have no second derivative.
            if change <= later {
                forces.iter_mut().zip(seconds).for_each(|(force, second)| *force -= second);
            }
        }
        forces
    }

    /// Evaluates the errors of all columns and the largest errors of the probes.
    fn evaluate(&mut self, dynamics: &TimeStepper<'_, System>, field: &GapField<'_>) {
        let place = (self.assembly, dynamics.state(), field.contacts.as_slice());
        let found = dynamics.errors().and_then(|found| found.of_mesh());
        let of_mesh = found.filter(|_| self.history.errors.is_mesh_known);
        let of_mesh =
            of_mesh.map(|error| ValueErrors::in_motion(place, Some(field), error, self.scales).evaluate().0);
        self.record(dynamics, of_mesh);
    }

    /// Evaluates the errors of the current state, with those of the mesh by a motion on a finer one, or a reason for which they are
    /// not known.
    ///
    /// Returns the errors of the columns.
    pub(crate) fn compare(
        &mut self,
        dynamics: &TimeStepper<'_, System>,
        of_mesh: Result<(Vec<ValueError>, FinerMesh), String>,
    ) -> &[ValueError] {
        let unknown = |reason| (None, FinerMesh { elements: None, order: None, reason: Some(reason) });
        let (values, finer) = of_mesh.map_or_else(unknown, |(values, finer)| (Some(values), finer));
        self.history.errors.is_rough |= values.is_some() && finer.reason.is_some();
        self.history.errors.finer = Some(finer);
        self.record(dynamics, values);
        &self.history.errors.values
    }

    /// Records the errors of all columns and the largest errors of the probes.
    fn record(&mut self, dynamics: &TimeStepper<'_, System>, of_mesh: Option<Vec<ValueError>>) {
        let errors = &mut self.history.errors;
        let state = dynamics.state();
        let contacts = self.assembly.contact_terms(state);
        let place = (self.assembly, state, contacts.as_slice());
        let of_steps = dynamics.errors().and_then(|found| found.of_steps());
        let of_steps =
            of_steps.map(|error| ValueErrors::in_motion(place, None, error, self.scales).evaluate().0);
        errors.are_steps_known &= of_steps.is_some();
        errors.kinked_steps = dynamics.errors().map_or(0, |found| found.kinked_steps());
        errors.is_mesh_known &= of_mesh.is_some() || !has_mesh(self.assembly);
        let length = self.scales.unit(Dimension::LENGTH);
        let motions =
            self.assembly.recorded_quantities.iter().filter(|probe| probe.quantity == Quantity::Motion);
        for (probe, largest) in motions.zip(&mut errors.probes) {
            let moved = probe.place.point.displacement(state).norm() * length;
            largest.displacement = largest.displacement.max(moved);
            let of =
                |values: &Option<Vec<ValueError>>| values.as_deref().map_or(0.0, |v| size(v, &probe.name));
            largest.steps = largest.steps.max(of(&of_steps));
            largest.mesh = largest.mesh.max(of(&of_mesh));
        }
        errors.values = match (of_steps, of_mesh) {
            (Some(steps), Some(mesh)) => {
                let sum = |(value, mesh): (ValueError, ValueError)| ValueError {
                    error: value.error + mesh.error,
                    ..value
                };
                steps.into_iter().zip(mesh).map(sum).collect()
            }
            (Some(steps), None) if !has_mesh(self.assembly) => steps,
            _ => Vec::new(),
        };
    }

    /// Errors so far.
    pub(crate) fn errors(&self) -> &MotionErrors {
        &self.history.errors
    }

    /// Values of earlier states on which the estimate depends.
    pub(crate) fn history(&self) -> &EstimateHistory {
        &self.history
    }

    /// Restores the values of earlier states. Returns false if they belong to another model.
    pub(crate) fn restore(&mut self, history: &EstimateHistory) -> bool {
        let size = self.assembly.rest().q.len();
        let is_valid = |(t, moments): &(f64, Vec<f64>)| {
            t.is_finite() && moments.len() == size && moments.iter().all(|x| x.is_finite())
        };
        let names = |errors: &MotionErrors| -> Vec<String> {
            errors.probes.iter().map(|probe| probe.probe.clone()).collect()
        };
        let is_planned = (1..=LONGEST_STRIDE).contains(&history.stride) && history.wait < history.stride;
        if !is_planned
            || names(&history.errors) != names(&self.history.errors)
            || !history.moments.iter().all(is_valid)
        {
            return false;
        }
        self.history.clone_from(history);
        true
    }
}

/// True if a body has a mesh.
pub(crate) fn has_mesh(assembly: &Assembly) -> bool {
    assembly.bodies().any(|(_, body)| body.mesh().is_some() || body.is_shell())
}

/// Size of the error of the position of a probe.
fn size(values: &[ValueError], probe: &str) -> f64 {
    let of = |axis: &str| {
        let found = values.iter().find(|value| value.column.strip_prefix(probe) == Some(axis));
        found.map_or(0.0, |value| value.error)
    };
    Vector3::new(of(".x"), of(".y"), of(".z")).norm()
}
