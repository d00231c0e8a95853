#![expect(unsafe_code, reason = "interface of C")]

use std::ffi::{CStr, CString, c_char};

use crate::fault::Fault;
use crate::pointers::{copy, put, text};
use crate::simulation::{Simulation, out_of_range, with};
use crate::status::Status;

/// Number of inputs.
///
/// # Safety
/// `simulation` is open, and `count` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_count_inputs(simulation: *mut Simulation, count: *mut usize) -> Status {
    // SAFETY: the conditions of this function.
    unsafe { with(simulation, |own| put(count, own.inputs.len(), "count")) }
}

/// Number of columns.
///
/// # Safety
/// `simulation` is open, and `count` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_count_columns(simulation: *mut Simulation, count: *mut usize) -> Status {
    // SAFETY: the conditions of this function.
    unsafe { with(simulation, |own| put(count, own.columns.len(), "count")) }
}

/// Name of an input. The text is valid until the simulation is closed.
///
/// # Safety
/// `simulation` is open, and `name` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_input_name(
    simulation: *mut Simulation,
    input: usize,
    name: *mut *const c_char,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe { with(simulation, |own| put(name, entry(&own.inputs, input, "input")?, "name")) }
}

/// Name of a column, such as `tip.y`. The text is valid until the simulation is closed.
///
/// # Safety
/// `simulation` is open, and `name` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_column_name(
    simulation: *mut Simulation,
    column: usize,
    name: *mut *const c_char,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe { with(simulation, |own| put(name, entry(&own.columns, column, "column")?, "name")) }
}

/// Unit of a column, such as `mm`; empty if the model names no units. The text is valid until the simulation is closed.
///
/// # Safety
/// `simulation` is open, and `unit` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_column_unit(
    simulation: *mut Simulation,
    column: usize,
    unit: *mut *const c_char,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe { with(simulation, |own| put(unit, entry(&own.units, column, "column")?, "unit")) }
}

/// Finds an input by its name.
///
/// # Safety
/// `simulation` is open, `name` ends with a null character, and `input` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_find_input(
    simulation: *mut Simulation,
    name: *const c_char,
    input: *mut usize,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        with(simulation, |own| {
            let name = text(name, "name")?;
            // The message of an unknown name lists the known ones.
            own.stepper.input(name)?;
            put(input, index(&own.inputs, name)?, "input")
        })
    }
}

/// Finds a column by its name.
///
/// # Safety
/// `simulation` is open, `name` ends with a null character, and `column` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_find_column(
    simulation: *mut Simulation,
    name: *const c_char,
    column: *mut usize,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        with(simulation, |own| {
            let name = text(name, "name")?;
            own.stepper.read(name)?;
            put(column, index(&own.columns, name)?, "column")
        })
    }
}

/// Value of an input: the one last set, or the present value during a ramp.
///
/// # Safety
/// `simulation` is open, and `value` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_get_input(
    simulation: *mut Simulation,
    input: usize,
    value: *mut f64,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe { with(simulation, |own| put(value, own.stepper.input(own.input(input)?)?, "value")) }
}

/// Sets an input from the present time on.
///
/// The next step starts with the value. Until then, values that are read are those before the jump.
///
/// @param ramp Duration of a linear transition from the present value; 0 is a jump. An input that prescribes a position must not jump.
///
/// # Safety
/// `simulation` is open.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_set_input(
    simulation: *mut Simulation,
    input: usize,
    value: f64,
    ramp: f64,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        with(simulation, |own| {
            let name = own.inputs.get(input).ok_or_else(|| out_of_range("input", input, own.inputs.len()))?;
            Ok(own.stepper.set_within(name.to_str().unwrap_or_default(), value, ramp)?)
        })
    }
}

/// Value of a column in the present state.
///
/// # Safety
/// `simulation` is open, and `value` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_read(simulation: *mut Simulation, column: usize, value: *mut f64) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        with(simulation, |own| {
            let row = own.stepper.row();
            let found = row.get(column).copied().ok_or_else(|| out_of_range("column", column, row.len()))?;
            put(value, found, "value")
        })
    }
}

/// Values of all columns in the present state.
///
/// @param values Receives `count` values.
/// @param count Number of columns.
///
/// # Safety
/// `simulation` is open, and `values` points to writable memory for `count` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_read_row(
    simulation: *mut Simulation,
    values: *mut f64,
    count: usize,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        with(simulation, |own| {
            let row = own.stepper.row();
            if count != row.len() {
                return Err(Fault::argument(format!("count: found {count}, expected {}", row.len())));
            }
            copy(row, values, "values")
        })
    }
}

fn entry(texts: &[CString], index: usize, what: &str) -> Result<*const c_char, Fault> {
    texts.get(index).map(|text| text.as_ptr()).ok_or_else(|| out_of_range(what, index, texts.len()))
}

fn index(names: &[CString], name: &str) -> Result<usize, Fault> {
    let found = names.iter().position(|own| CStr::to_bytes(own) == name.as_bytes());
    found.ok_or_else(|| Fault::argument(format!("no {name:?}")))
}
