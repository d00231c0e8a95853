use ancf_solver::dynamics::StepReport;
use ancf_solver::equations::EquationsOfMotion;
use serde::{Deserialize, Serialize};

use crate::assembly::Assembly;
use crate::model::Analysis;
use crate::units::{ChosenScales, Scales};

/// How a run ended. Whatever was recorded until then stands.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Outcome {
    /// The whole duration was computed.
    Finished,
    /// A sink or an interrupt asked to stop.
    Stopped,
    /// The equations of a step could not be solved.
    Failed {
        /// Time that was to be reached; in statics, the load factor.
        time: f64,
        /// Why.
        reason: String,
        /// Where: the node and the arc length on a body, the joint, or the key of the model to which it belongs.
        at: String,
        /// What to try.
        advice: String,
    },
}

impl Outcome {
    /// Whether the whole duration was computed.
    pub const fn is_finished(&self) -> bool {
        matches!(self, Self::Finished)
    }

    /// When, why and where an analysis failed, and what to try, in a sentence, if it did.
    pub fn failure(&self, analysis: &Analysis) -> Option<String> {
        let Self::Failed { time, reason, at, advice } = self else { return None };
        let place = match analysis {
            Analysis::Dynamics(_) => format!(" at t = {}", short(*time)),
            // Modes and critical loads are about one state, which may not be reached.
            Analysis::Modes(_) | Analysis::Buckling(_) if *time == 0.0 => String::new(),
            _ => format!(" at load factor {}", short(*time)),
        };
        Some(format!("failed{place}: {reason}; at: {at}; try: {advice}"))
    }
}

/// At most six digits, without trailing zeros.
fn short(x: f64) -> String {
    format!("{x:.5e}").parse::<f64>().map_or_else(|_| x.to_string(), |x| x.to_string())
}

/// A run in a few numbers, in the user's units.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Summary {
    /// How it ended.
    pub outcome: Outcome,
    /// Time reached; in statics, the load factor.
    pub time: f64,
    /// Steps done; in statics equilibria, modes or critical loads found.
    pub steps: u64,
    /// Steps that had to be divided because Newton's method failed.
    pub divided_steps: u64,
    /// Steps that were tried but found too inaccurate.
    pub rejected_steps: u64,
    /// Steps in which the rounding error of the residual ended the iteration.
    pub floor_steps: u64,
    /// Newton iterations in all.
    pub iterations: u64,
    /// The most iterations of one step.
    pub most_iterations: u32,
    /// Number of coordinates.
    pub coordinates: usize,
    /// Number of multipliers.
    pub multipliers: usize,
    /// Units in which the equations were solved.
    pub scales: Scales,
    /// How the units were chosen.
    pub scales_reason: String,
    /// Joint equations that follow from others, in words.
    pub redundant: Vec<String>,
    /// What its user should know besides: shapes that lost their stability on the way.
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
            warnings: Vec::new(),
        }
    }

    pub(crate) fn count(&mut self, report: &StepReport) {
        self.steps += 1;
        self.divided_steps += u64::from(report.substeps > 1);
        self.rejected_steps += u64::from(report.rejected);
        self.floor_steps += u64::from(report.floor);
        self.iterations += u64::from(report.iterations);
        self.most_iterations = self.most_iterations.max(report.iterations);
    }
}
