use std::ffi::CString;

use ancf::{Column, Model, StepError, Stepper};

use crate::fault::{Fault, c_text, guarded};
use crate::pointers::object;
use crate::status::Status;

/// Motion of a model that a program advances step by step. All values are in the units of the model.
///
/// Simulations are independent. Two threads may use two simulations at the same time, but not the same one.
#[derive(Debug)]
pub struct Simulation {
    pub(crate) stepper: Stepper,
    pub(crate) inputs: Vec<CString>,
    pub(crate) columns: Vec<CString>,
    pub(crate) units: Vec<CString>,
    pub(crate) warnings: CString,
    /// True during a call, and after a panic.
    is_busy: bool,
}

impl Simulation {
    pub(crate) fn new(model: &Model) -> Result<Self, StepError> {
        let stepper = Stepper::new(model)?;
        let columns = stepper.columns();
        let unit_of = |column: &Column| {
            let unit = model.units.as_ref().and_then(|units| column.unit(units));
            c_text(unit.unwrap_or_default())
        };
        Ok(Self {
            inputs: stepper.inputs().map(c_text).collect(),
            units: columns.iter().map(unit_of).collect(),
            columns: columns.into_iter().map(|column| c_text(column.name)).collect(),
            warnings: CString::default(),
            is_busy: false,
            stepper,
        })
    }

    pub(crate) fn input(&self, index: usize) -> Result<&str, Fault> {
        let name = self.inputs.get(index).and_then(|name| name.to_str().ok());
        name.ok_or_else(|| out_of_range("input", index, self.inputs.len()))
    }
}

/// Error of an index.
pub(crate) fn out_of_range(what: &str, index: usize, count: usize) -> Fault {
    Fault::argument(format!("{what}: found index {index}, expected one below {count}"))
}

/// Runs the body of a function of a simulation.
///
/// # Safety
/// The pointer is null, or a simulation that has not been closed and that no other thread uses.
#[expect(unsafe_code, reason = "pointers of the caller")]
pub(crate) unsafe fn with(
    simulation: *mut Simulation,
    body: impl FnOnce(&mut Simulation) -> Result<(), Fault>,
) -> Status {
    guarded(|| {
        // SAFETY: the condition of this function.
        let simulation = unsafe { object(simulation, "simulation") }?;
        if simulation.is_busy {
            let text = "the simulation is not valid after an internal error; it can only be closed";
            return Err(Fault::new(Status::Internal, text));
        }
        simulation.is_busy = true;
        let done = body(simulation);
        simulation.is_busy = false;
        done
    })
}
