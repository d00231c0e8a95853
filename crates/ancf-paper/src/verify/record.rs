//! Content of `results.json` of the verification.

use serde::Serialize;

use super::verdict::ProblemVerdict;
use crate::page::MachineInfo;

/// Content of `results.json`. A value that is not finite is null.
#[derive(Debug, Serialize)]
pub struct VerificationRecord {
    /// Machine and version of the program.
    pub machine: MachineInfo,
    /// Total time, s.
    pub seconds: f64,
    /// True if all problems hold.
    pub holds: bool,
    problems: Vec<ProblemRecord>,
}

#[derive(Debug, Serialize)]
struct ProblemRecord {
    name: &'static str,
    title: &'static str,
    source: &'static str,
    goal: &'static str,
    holds: bool,
    /// Reason of a problem without comparisons.
    reason: Option<String>,
    seconds: f64,
    comparisons: Vec<ComparisonRecord>,
    /// Estimated errors of the mesh.
    effectivities: Vec<EffectivityRecord>,
}

#[derive(Debug, Serialize)]
struct EffectivityRecord {
    what: String,
    level: u32,
    estimate: f64,
    error: f64,
    ratio: f64,
    holds: bool,
}

#[derive(Debug, Serialize)]
struct ComparisonRecord {
    what: String,
    ours: f64,
    reference: f64,
    scale: f64,
    error: f64,
    tolerance: f64,
    holds: bool,
}

impl VerificationRecord {
    /// Creates the record of verdicts that took `seconds` in total.
    pub fn new(verdicts: &[ProblemVerdict], seconds: f64) -> Self {
        let holds = verdicts.iter().all(ProblemVerdict::holds);
        let problems = verdicts.iter().map(ProblemRecord::new).collect();
        Self { machine: MachineInfo::current(), seconds, holds, problems }
    }
}

impl ProblemRecord {
    fn new(verdict: &ProblemVerdict) -> Self {
        let problem = verdict.problem;
        let comparisons = verdict.comparisons().iter().map(|c| ComparisonRecord {
            what: c.what.clone(),
            ours: c.ours,
            reference: c.reference,
            scale: c.scale,
            error: c.error(),
            tolerance: c.tolerance,
            holds: c.holds(),
        });
        let effectivities = verdict.effectivities().iter().map(|e| EffectivityRecord {
            what: e.what.clone(),
            level: e.level,
            estimate: e.estimate,
            error: e.error,
            ratio: e.ratio(),
            holds: e.holds(),
        });
        Self {
            name: problem.name,
            title: problem.title,
            source: problem.source,
            goal: problem.goal,
            holds: verdict.holds(),
            reason: verdict.reason().map(str::to_owned),
            seconds: verdict.seconds,
            comparisons: comparisons.collect(),
            effectivities: effectivities.collect(),
        }
    }
}
