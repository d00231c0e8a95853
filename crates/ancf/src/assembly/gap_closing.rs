//! Closure of gaps between the ends of joints before an analysis.

use ancf_mechanics::bodies::BodyTerms;
use ancf_solver::equations::{EquationsOfMotion, State, System, Weights};
use ancf_solver::newton::{Newton, SolveError, SolveFailure, StopRule};

use super::assembled::Assembly;
use crate::errors::{ModelError, ModelErrors};
use crate::joints::{Gap, GapClosure, JointEquations};
use crate::model::{IndexedModel, Model, TimeMode};

/// Gap tolerance, relative to the length of the model.
const GAP: f64 = 1e-12;
/// Smallest reported displacement, relative to the length of the model.
const MOVED: f64 = 1e-6;
/// Convergence tolerance of the increments, relative to the length of the model.
const INCREMENT: f64 = 1e-11;
/// Largest number of Newton iterations per increment.
const ITERATIONS: u32 = 60;
/// Smallest increment, relative to the gaps.
const SMALLEST: f64 = 1e-4;
/// 1/τ² of the first solution, relative to the lowest ratio of stiffness to mass, and its factor between solutions.
const RATE: (f64, f64) = (1e-2, 1e-2);
/// Number of solutions with closed gaps.
const SETTLE: u32 = 4;

impl Model {
    /// Closes all gaps of an assembly of this model: min U(q) + |q − q₀|²_M / 2τ² subject to Φ(q) = 0.
    ///
    /// Loads and drives are zero. The gaps close in increments, each by Newton's method. Then τ increases and q₀ is updated, so
    /// that bodies move without strain where possible.
    ///
    /// Source: Rockafellar (1976), the proximal point method.
    ///
    /// # Errors
    /// If the gaps cannot be closed.
    pub(crate) fn close(&self, assembly: &Assembly) -> Result<GapClosure, ModelErrors> {
        let model = Self { gravity: [0.0; 3], loads: Vec::new(), ..self.clone() };
        let (model, length) = (IndexedModel::new(&model), self.length());
        let meshes = model.meshes();
        let draw = |gap| if gap == Gap::Closed { Gap::ClosedByLoad } else { Gap::Kept };
        let joints: Vec<JointEquations> = model
            .joint_equations(&meshes, TimeMode::Zero)
            .into_iter()
            .zip(&self.joints)
            .map(|(equations, joint)| equations.with_gap(draw(model.gap(joint))))
            .collect();
        let mut terms = meshes.iter().flat_map(|(_, mesh)| mesh.terms()).collect::<Vec<_>>();
        terms.extend(joints.iter().flat_map(JointEquations::terms));
        let rest = assembly.rest();
        // States of force laws exist in motions only.
        let [coordinates, _] = IndexedModel::numbers(&meshes, &joints);
        let system = System::new(coordinates, rest.lambda.len(), terms)
            .with_shared_multipliers(assembly.undetermined());
        let gaps: Vec<(String, f64)> = joints
            .iter()
            .filter(|joint| joint.gap().norm() > GAP * length)
            .map(|joint| (joint.name.clone(), joint.gap().norm()))
            .collect();
        if gaps.is_empty() {
            return Ok(GapClosure { state: rest, gaps, moved: Vec::new() });
        }
        let state = closed(&system, length).map_err(|error| {
            let (place, open) =
                (assembly.place_of(&error, 1.0), gaps.iter().map(|(name, _)| format!("`{name}`")));
            let found = format!("gaps that do not close: {error}; at: {place}");
            let expected = "joints whose places can be brought together";
            let hint = format!("open are {}", open.collect::<Vec<_>>().join(", "));
            ModelErrors(vec![ModelError::new("assemble", found, expected).hint(hint)])
        })?;
        let state = with_states(&state, &meshes, &joints, assembly);
        let moved = meshes.iter().map(|(name, mesh)| (name.clone(), displacement(mesh, &state)));
        let moved = moved.filter(|(_, by)| *by > MOVED * self.length()).collect();
        Ok(GapClosure { state, gaps, moved })
    }
}

/// Closed state with the coordinates of the assembly, which has those of the states of force laws in addition.
fn with_states(
    closed: &State,
    meshes: &[(String, BodyTerms)],
    joints: &[JointEquations],
    assembly: &Assembly,
) -> State {
    let [of_bodies, _] = IndexedModel::numbers(meshes, &[]);
    let mut state = State { lambda: closed.lambda.clone(), load: closed.load, ..assembly.rest() };
    state.q[..of_bodies].copy_from_slice(&closed.q[..of_bodies]);
    let from = joints.iter().flat_map(|joint| joint.coordinates.clone());
    let to = assembly.joints.iter().flat_map(JointEquations::free_coordinates);
    to.zip(from).for_each(|(to, from)| state.q[to] = closed.q[from]);
    state
}

/// Largest displacement of the nodes of a body.
fn displacement(body: &BodyTerms, s: &State) -> f64 {
    let positions = body.vectors(s).into_iter().filter(|vector| vector.is_position());
    let moved = positions.map(|vector| {
        let q = &s.q[vector.first..vector.first + 3];
        q.iter().map(|q| q * q).sum::<f64>().sqrt()
    });
    moved.fold(0.0, f64::max)
}

/// Solves for the state at rest with closed gaps, by increments of the load factor.
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

/// Solves ∂U/∂q + M (q − q₀)/τ² + Φ_qᵀ λ = 0, Φ = 0 by Newton's method. The accelerations of the state contain (q − q₀)/τ².
fn settle(system: &System, newton: &mut Newton, s: &mut State, rate: f64) -> Result<(), SolveError> {
    newton.solve(system, s, Weights { q: 1.0, v: 0.0, a: rate })?;
    match system.inadmissible(s) {
        None => Ok(()),
        Some((worst, reason)) => {
            let failure = SolveFailure::Inadmissible(reason);
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

/// Lowest ratio K_ii/M_ii of the coordinates with stiffness and mass; 1 if there are none.
fn slowest(system: &System, s: &State) -> f64 {
    let (mut stiffness, mut mass) = (system.matrix(), system.matrix());
    system.tangent(s, Weights::STIFFNESS, &mut stiffness);
    system.tangent(s, Weights::MASS, &mut mass);
    let ratios = (0..system.coordinates()).map(|i| stiffness.diagonal_of(i) / mass.diagonal_of(i));
    let lowest = ratios.filter(|ratio| ratio.is_normal() && *ratio > 0.0).fold(f64::INFINITY, f64::min);
    if lowest.is_finite() { lowest } else { 1.0 }
}
