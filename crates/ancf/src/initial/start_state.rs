use ancf_solver::dynamics::consistent_positions;
use ancf_solver::equations::{Inadmissibility, State};
use ancf_solver::newton::{SolveError, SolveFailure};

use super::initial_state::InitialState;
use super::report::InitialReport;
use crate::assembly::Assembly;
use crate::diagnosis::projection_warning;
use crate::errors::{quoted, short};
use crate::failure::{FailureCause, FailurePlace, RunFailure, find_cause};
use crate::model::Model;
use crate::units::Scales;

/// Given state of a simulation, from which [`Simulation::run_from`](crate::Simulation::run_from) starts.
#[derive(Clone, Debug, PartialEq)]
pub struct StartState {
    pub(crate) state: State,
    pub(crate) source: String,
    /// Angles with their full turns, by their columns.
    pub(crate) angles: Vec<(String, f64)>,
}

/// Displacement by the projection of positions, relative to the length of the model, that is reported as a warning.
const MOVED: f64 = 1e-6;
/// Rotation by the projection of positions that is reported as a warning, in rad.
const TURNED: f64 = 1e-6;
/// Relative kinetic energy of the correction of velocities that is reported as a warning. Stored velocities violate constraints
/// by the errors of their time steps.
const CORRECTED: f64 = 1e-6;

impl StartState {
    /// Initial state with consistent positions, and with the velocities of the model added.
    ///
    /// # Errors
    /// If the positions cannot be projected onto the constraints.
    pub(crate) fn initial_state(
        &self,
        (model, scales): (&Model, Scales),
        assembly: &Assembly,
    ) -> Result<InitialState, RunFailure> {
        let mut state = State { t: model.initial.start_time, ..self.state.clone() };
        let length = model.length();
        consistent_positions(&assembly.system, &mut assembly.system.matrix(), &mut state, length)
            .map_err(|error| self.failure(error))?;
        require_alignment(assembly, &state)?;
        let moved = assembly.displacement(&self.state, &state);
        let turned = assembly.turn(&self.state, &state);
        let state = assembly.with_motions(state, model);
        let corrected = assembly.projection(&state).unwrap_or(0.0);
        let source = self.source.clone();
        let mut warnings = Vec::new();
        if moved > MOVED * length {
            warnings.push(format!(
                "the positions of {source} violate constraints of joints and drives at t = {}: their correction moves a point by {}",
                short(state.t * scales.time),
                short(moved * scales.length)
            ));
        } else if turned > TURNED {
            warnings.push(format!(
                "the rotations of {source} violate constraints of joints and drives at t = {}: their correction turns a section or a body by \
                 about {} rad",
                short(state.t * scales.time),
                short(turned)
            ));
        }
        if corrected > CORRECTED {
            warnings.extend(projection_warning(corrected));
        }
        let report = InitialReport::Given { source, moved: moved * scales.length, corrected };
        Ok(InitialState { state, report: Some(report), warnings })
    }
}

impl StartState {
    /// Positions of the state without velocities, at the load factor 0.
    pub(crate) fn at_rest(&self) -> State {
        let mut state = State { load: 0.0, ..self.state.clone() };
        state.v.fill(0.0);
        state.a.fill(0.0);
        state.lambda.fill(0.0);
        state
    }

    /// Report of an analysis that releases the state to an equilibrium.
    pub(crate) fn released(&self) -> InitialReport {
        InitialReport::Released { source: self.source.clone() }
    }

    /// Failure of the projection of the positions.
    fn failure(&self, error: SolveError) -> RunFailure {
        let reason = format!(
            "the positions of {} are not near positions that joints and drives permit at the start",
            self.source
        );
        let at = FailurePlace::Text("`initial.from`".into());
        RunFailure::Solve(error, Some(FailureCause { reason, at, advice: FOR_POSITIONS }))
    }
}

/// Checks that the joints of rigid bodies have the orientation of the reference state, and that all terms admit the state.
///
/// # Errors
/// If a joint has another orientation: the bodies of a joint that begins later have turned by more than about a right angle.
pub(crate) fn require_alignment(assembly: &Assembly, s: &State) -> Result<(), RunFailure> {
    let Some(joint) = assembly.misaligned(s) else {
        let Some(error) = assembly.inadmissible(s) else { return Ok(()) };
        let cause = find_cause(assembly, s, s.load, &error);
        return Err(RunFailure::Solve(error, cause));
    };
    let error = SolveError::at(s.t, SolveFailure::Inadmissible(Inadmissibility::HalfTurn));
    let reason = format!(
        "joint {} relates its bodies as in the undeformed state, but they have turned too far from this orientation: the equations of the \
         joint also hold half a turn away",
        quoted(joint)
    );
    let at = FailurePlace::Text(format!("joint {}", quoted(joint)));
    Err(RunFailure::Solve(error, Some(FailureCause { reason, at, advice: FOR_ORIENTATION })))
}

/// Advice for a joint with another orientation.
const FOR_ORIENTATION: &str = "a start in which the bodies are turned by less than a right angle; a joint with a driven angle that turns them back before";
/// Advice after a failed projection of positions.
const FOR_POSITIONS: &str =
    "a state of a run with the same joints, and drives with the same values at the start";
