use std::io;
use std::ops::ControlFlow;

use ancf_solver::newton::Interrupt;

use super::observer::Observer;
use super::summary::Summary;
use crate::assembly::Assembly;
use crate::errors::short;
use crate::failure::{EquilibriumStability, RunFailure, StabilityMonitor};
use crate::results::Rows;

/// State of a running analysis.
pub(crate) struct AnalysisRun<'a> {
    pub(crate) assembly: &'a Assembly,
    pub(crate) interrupt: &'a Interrupt,
    pub(crate) observer: &'a mut dyn Observer,
    pub(crate) summary: Summary,
    pub(crate) monitor: StabilityMonitor,
    pub(crate) stability: EquilibriumStability,
}

/// Warning if the number of turns of a joint angle is ambiguous. `variable` and `unit` are the name and the unit of the variable of
/// the steps.
pub(crate) fn turn_warning(rows: &Rows, variable: &str, unit: f64) -> Option<String> {
    let (at, joint) = rows.ambiguous_turns()?;
    Some(format!(
        "the angle of joint `{joint}` changes by about half a turn or more in the step to {variable} = {}: its number of turns is \
         ambiguous from there on; use smaller steps",
        short(at * unit)
    ))
}

/// Result of an analysis, in solver units: finished, stopped by the observer, or failed. The outer error is that of the
/// observer.
pub(crate) type RunResult = io::Result<Result<ControlFlow<()>, RunFailure>>;
