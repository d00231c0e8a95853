use ancf_solver::dynamics::StepReport;
use ancf_solver::eigen::SturmCount;
use ancf_solver::equations::EquationsOfMotion;
use serde::{Deserialize, Serialize};

use crate::assembly::Assembly;
use crate::errors::short;
use crate::estimate::{BodyError, DiscretisationErrors, MeshStep, MotionErrors};
use crate::initial::InitialReport;
use crate::model::Analysis;
use crate::units::{ChosenScales, Scales};

/// End of a run. Rows recorded before the end remain valid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Outcome {
    /// The analysis is complete.
    Finished,
    /// The observer or the interrupt flag stopped the analysis.
    Stopped,
    /// The computation failed.
    Failed {
        /// Time at the end of the failed step; in statics, the load factor.
        time: f64,
        /// Cause.
        reason: String,
        /// Place: node and arc length on a body, joint, or key of the model.
        at: String,
        /// Remedy.
        advice: String,
    },
}

impl Outcome {
    /// True if the analysis is complete.
    pub const fn is_finished(&self) -> bool {
        matches!(self, Self::Finished)
    }

    /// Message of a failed analysis with load factor or time, cause, place and remedy; `None` otherwise.
    pub fn failure(&self, analysis: &Analysis) -> Option<String> {
        let Self::Failed { time, reason, at, advice } = self else { return None };
        let place = match analysis {
            Analysis::Dynamics(_) => format!(" at t = {}", short(*time)),
            // Modes and critical loads belong to one state, whose load factor is stated if it was not reached.
            Analysis::Modes(_) | Analysis::Buckling(_) if *time == 0.0 => String::new(),
            _ => format!(" at load factor {}", short(*time)),
        };
        Some(format!("failed{place}: {reason}; at: {at}; try: {advice}"))
    }
}

/// Number of eigenvalues below a limit by the inertia of the shifted stiffness matrix (Sylvester's law), equal to the number
/// of computed eigenvalues below it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct EigenvalueCount {
    /// Limit: ω² in the user's unit of 1/time², or a load factor.
    pub below: f64,
    /// Number of eigenvalues.
    pub count: usize,
}

impl EigenvalueCount {
    /// Converts the unit of the limit.
    pub(crate) fn new(sturm: SturmCount, unit: f64) -> Self {
        Self { below: sturm.below * unit, count: sturm.count }
    }
}

/// Summary of a run, in the user's units.
#[must_use = "a run that failed or was stopped returns a summary with that outcome"]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// End of the run.
    pub outcome: Outcome,
    /// Time reached; in statics, the load factor.
    pub time: f64,
    /// Number of steps; in other analyses, of equilibria, modes or critical loads.
    pub steps: u64,
    /// Number of steps that were divided because Newton's method failed.
    pub divided_steps: u64,
    /// Number of attempts that error control rejected.
    pub rejected_steps: u64,
    /// Number of steps in which the iteration ended at the rounding error of the residual.
    pub floor_steps: u64,
    /// Total number of Newton iterations.
    pub iterations: u64,
    /// Maximum number of iterations per step.
    pub most_iterations: u32,
    /// Number of coordinates.
    pub coordinates: usize,
    /// Number of multipliers.
    pub multipliers: usize,
    /// Units in which the equations were solved.
    pub scales: Scales,
    /// Reason for the choice of the units.
    pub scales_reason: String,
    /// Descriptions of redundant joint equations.
    pub redundant: Vec<String>,
    /// Modes and buckling: verified number of eigenvalues.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub eigenvalues: Option<EigenvalueCount>,
    /// Dynamics: state from which the motion starts, if it is not the undeformed state.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub initial: Option<InitialReport>,
    /// Dynamics: condition of `analysis.until` that ended the motion, such as "`tip.z` is above 0.5".
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ended_by: Option<String>,
    /// Statics: estimated errors of the mesh in the last state. Modes and buckling: those of the frequencies and load factors.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub errors: Option<DiscretisationErrors>,
    /// Dynamics: estimated errors of the time steps and of the mesh, on request.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion_errors: Option<MotionErrors>,
    /// Meshes of a refinement to a requested error, the last one that of these results.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub meshes: Vec<MeshStep>,
    /// Names and declared values of the inputs, which are constant in a run.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub inputs: Vec<(String, f64)>,
    /// Warnings, such as loss of stability during the run.
    pub warnings: Vec<String>,
}

impl Summary {
    pub(crate) fn new(assembly: &Assembly, chosen: ChosenScales) -> Self {
        Self {
            outcome: Outcome::Finished,
            time: 0.0,
            steps: 0,
            divided_steps: 0,
            rejected_steps: 0,
            floor_steps: 0,
            iterations: 0,
            most_iterations: 0,
            coordinates: assembly.system.coordinates(),
            multipliers: assembly.system.multipliers(),
            scales: chosen.scales,
            scales_reason: chosen.reason,
            redundant: assembly.redundant().iter().map(ToString::to_string).collect(),
            eigenvalues: None,
            initial: None,
            ended_by: None,
            errors: None,
            motion_errors: None,
            meshes: Vec::new(),
            inputs: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// Contributions of the flexible bodies to the error of the mesh. Empty without an estimate.
    pub fn body_errors(&self) -> &[BodyError] {
        self.errors.as_ref().map_or(&[], |errors| &errors.bodies)
    }

    /// Adds a step.
    pub(crate) fn count(&mut self, report: &StepReport) {
        self.steps += 1;
        self.divided_steps += u64::from(report.substeps > 1);
        self.rejected_steps += u64::from(report.rejected);
        self.floor_steps += u64::from(report.floor);
        self.iterations += u64::from(report.iterations);
        self.most_iterations = self.most_iterations.max(report.iterations);
    }
}
