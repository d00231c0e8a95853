use serde::Serialize;

use super::verdict::Verdict;
use crate::report::Machine;

/// The contents of `results.json`; what is not a number is null.
#[derive(Debug, Serialize)]
pub struct Record {
    /// Where it was run, by which version.
    pub machine: Machine,
    /// Time of all together.
    pub seconds: f64,
    /// Whether all hold.
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
    /// Why there is nothing to compare.
    reason: Option<String>,
    seconds: f64,
    comparisons: Vec<ComparisonRecord>,
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

impl Record {
    /// The verdicts, which took so many seconds in all.
    pub fn new(verdicts: &[Verdict], seconds: f64) -> Self {
        let holds = verdicts.iter().all(Verdict::holds);
        let problems = verdicts.iter().map(ProblemRecord::new).collect();
        Self { machine: Machine::this(), seconds, holds, problems }
    }
}

impl ProblemRecord {
    fn new(verdict: &Verdict) -> Self {
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
        Self {
            name: problem.name,
            title: problem.title,
            source: problem.source,
            goal: problem.goal,
            holds: verdict.holds(),
            reason: verdict.reason().map(str::to_owned),
            seconds: verdict.seconds,
            comparisons: comparisons.collect(),
        }
    }
}
