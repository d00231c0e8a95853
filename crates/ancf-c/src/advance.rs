#![expect(unsafe_code, reason = "interface of C")]

use std::ffi::c_char;

use crate::fault::c_text;
use crate::pointers::{put, put_if};
use crate::simulation::{Simulation, with};
use crate::status::Status;

/// Counts of a step.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StepReport {
    /// Number of substeps: 1 unless the step was divided at events, by failed iterations or by error control.
    pub substeps: u32,
    /// Number of Newton iterations, including failed attempts.
    pub iterations: u32,
    /// Number of attempts that error control rejected.
    pub rejected: u32,
}

impl From<ancf::solver::dynamics::StepReport> for StepReport {
    fn from(report: ancf::solver::dynamics::StepReport) -> Self {
        Self { substeps: report.substeps, iterations: report.iterations, rejected: report.rejected }
    }
}

/// Performs one step of the size h > 0.
///
/// The step is divided where a load or a drive jumps, and halved if the iteration fails. After `ANCF_STATUS_FAILED` the state is
/// that of the last accepted substep, at `ancf_time`; a smaller step may succeed.
///
/// @param report Receives the counts; may be NULL.
///
/// # Safety
/// `simulation` is open, and `report` is NULL or points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_step(simulation: *mut Simulation, h: f64, report: *mut StepReport) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        with(simulation, |own| {
            let done = own.stepper.step(h)?;
            put_if(report, done.into());
            Ok(())
        })
    }
}

/// Advances to a time in steps of the model. The last one ends exactly at that time.
///
/// @param report Receives the sums of the counts; may be NULL.
///
/// # Safety
/// `simulation` is open, and `report` is NULL or points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_advance(
    simulation: *mut Simulation,
    until: f64,
    report: *mut StepReport,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        with(simulation, |own| {
            let done = own.stepper.advance(until)?;
            put_if(report, done.into());
            Ok(())
        })
    }
}

/// Present time.
///
/// # Safety
/// `simulation` is open, and `time` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_time(simulation: *mut Simulation, time: *mut f64) -> Status {
    // SAFETY: the conditions of this function.
    unsafe { with(simulation, |own| put(time, own.stepper.time(), "time")) }
}

/// Warnings of all steps so far, one per line; empty if there are none.
///
/// The text is valid until the next call of this function for the simulation.
///
/// # Safety
/// `simulation` is open, and `warnings` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_warnings(simulation: *mut Simulation, warnings: *mut *const c_char) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        with(simulation, |own| {
            own.warnings = c_text(own.stepper.summary().warnings.join("\n"));
            put(warnings, own.warnings.as_ptr(), "warnings")
        })
    }
}
