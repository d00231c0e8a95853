//! Gaps between the places that joints connect, and how they are closed before an analysis begins.

use ancf_mechanics::bodies::BodyTerms;
use ancf_solver::equations::{EquationsOfMotion, State, System, Weights};
use ancf_solver::newton::{Newton, SolveError, SolveFailure, StopRule};

use super::assembled::Assembly;
use crate::errors::{ModelError, ModelErrors};
use crate::joints::{Gap, GapClosure, JointEquations};
use crate::model::{Model, TimeMode};

/// Gaps that are none, relative to the length of the model.
const GAP: f64 = 1e-12;
/// Displacements that are none to speak of, relative to the length of the model.
const MOVED: f64 = 1e-6;
/// An increment of the coordinates that ends an iteration, relative to the length of the model.
const INCREMENT: f64 = 1e-11;
/// Newton iterations of an increment.
const ITERATIONS: u32 = 60;
/// The smallest part of the gaps that is closed at once.
const SMALLEST: f64 = 1e-4;
/// 1/τ² of the first solution, relative to the lowest ratio of stiffness to mass, and by how much it falls from one to the next.
const RATE: (f64, f64) = (1e-2, 1e-2);
/// Solutions after all gaps are closed.
const SETTLE: u32 = 4;

impl Model {
    /// Closes all gaps of an assembly of this model: min U(q) + |q − q₀|²_M / 2τ² subject to Φ(q) = 0.
    ///
    /// Without loads and with all drives at zero. The gaps close in increments, each by Newton's method; then τ grows and q₀
    /// follows, so that bodies that can be moved into place without strain are (the proximal point method; Rockafellar 1976).
    ///
    /// # Errors
    /// If the gaps cannot be closed.
    pub(crate) fn close(&self, assembly: &Assembly) -> Result<GapClosure, ModelErrors> {
        let model = Self { gravity: [0.0; 3], loads: Vec::new(), ..self.clone() };
        let meshes = model.meshes();
        let draw = |gap| if gap == Gap::Closed { Gap::ClosedByLoad } else { Gap::Kept };
        let joints: Vec<JointEquations> = model
            .joint_equations(&meshes, TimeMode::Zero)
            .into_iter()
            .zip(&self.joints)
            .map(|(equations, joint)| equations.with_gap(draw(self.gap(joint))))
            .collect();
        let mut terms = meshes.iter().flat_map(|(_, mesh)| mesh.terms()).collect::<Vec<_>>();
        terms.extend(joints.iter().flat_map(JointEquations::terms));
        let rest = assembly.rest();
        let system = System::new(rest.q.len(), rest.lambda.len(), terms)
            .with_shared_multipliers(assembly.undetermined());
        let gaps: Vec<(String, f64)> = joints
            .iter()
            .filter(|joint| joint.gap().norm() > GAP * self.length())
            .map(|joint| (joint.name.clone(), joint.gap().norm()))
            .collect();
        if gaps.is_empty() {
            return Ok(GapClosure { state: rest, gaps, moved: Vec::new() });
        }
        let state = closed(&system, self.length()).map_err(|error| {
            let (place, open) =
                (assembly.place_of(&error, 1.0), gaps.iter().map(|(name, _)| format!("`{name}`")));
            let found = format!("gaps that do not close: {error}; at: {place}");
            let wanted = "joints whose places can be brought together";
            let hint = format!("open are {}", open.collect::<Vec<_>>().join(", "));
            ModelErrors(vec![ModelError::new("assemble", found, wanted).hint(hint)])
        })?;
        let moved = meshes.iter().map(|(name, mesh)| (name.clone(), displacement(mesh, &state)));
        let moved = moved.filter(|(_, by)| *by > MOVED * self.length()).collect();
        Ok(GapClosure { state, gaps, moved })
    }
}

/// The largest displacement of the nodes of a body.
fn displacement(body: &BodyTerms, s: &State) -> f64 {
    let positions = body.vectors(s).into_iter().filter(|vector| vector.is_position());
    let moved = positions.map(|vector| {
        let q = &s.q[vector.first..vector.first + 3];
        q.iter().map(|q| q * q).sum::<f64>().sqrt()
    });
    moved.fold(0.0, f64::max)
}

/// The state in which gaps are closed, by increments of the load factor; at rest.
fn closed(system: &System, length: f64) -> Result<State, SolveError> {
    let mut s = State { load: 0.0, ..State::rest(system.coordinates(), system.multipliers()) };
    let mut rate = RATE.0 * slowest(system, &s);
    let stop = StopRule::Increment(INCREMENT * length);
    let mut newton = Newton::new(system.matrix(), stop, ITERATIONS)?;
    let mut part = 1.0;
    while s.load < 1.0 {
        let mut trial = State { load: (s.load + part).min(1.0), ..s.clone() };
        match settle(system, &mut newton, &mut trial, rate) {
            Ok(()) => (s, part) = (trial, 2.0 * part),
            Err(error) if part <= SMALLEST => return Err(error),
            Err(_) => part *= 0.5,
        }
    }
    for _ in 0..SETTLE {
        let mut trial = s.clone();
        trial.a.fill(0.0);
        rate *= RATE.1;
        // Rounding sets the end: what is there already is closed.
        if settle(system, &mut newton, &mut trial, rate).is_err() {
            break;
        }
        s = trial;
    }
    s.a.fill(0.0);
    Ok(s)
}

/// Newton's method for ∂U/∂q + M (q − q₀)/τ² + Φ_qᵀ λ = 0, Φ = 0; a state has (q − q₀)/τ² in the place of its accelerations.
fn settle(system: &System, newton: &mut Newton, s: &mut State, rate: f64) -> Result<(), SolveError> {
    newton.solve(system, s, Weights { q: 1.0, v: 0.0, a: rate })?;
    match system.inadmissible(s) {
        None => Ok(()),
        Some(worst) => {
            let failure = SolveFailure::Inverted;
            Err(SolveError {
                failure,
                t: s.t,
                iterations: 0,
                residual: 0.0,
                increment: 0.0,
                worst: Some(worst),
            })
        }
    }
}

/// The lowest ratio K_ii/M_ii of a coordinate that has both; one if there is none.
fn slowest(system: &System, s: &State) -> f64 {
    let (mut stiffness, mut mass) = (system.matrix(), system.matrix());
    system.tangent(s, Weights::STIFFNESS, &mut stiffness);
    system.tangent(s, Weights::MASS, &mut mass);
    let ratios = (0..system.coordinates()).map(|i| stiffness.diagonal_of(i) / mass.diagonal_of(i));
    let lowest = ratios.filter(|ratio| ratio.is_normal() && *ratio > 0.0).fold(f64::INFINITY, f64::min);
    if lowest.is_finite() { lowest } else { 1.0 }
}
