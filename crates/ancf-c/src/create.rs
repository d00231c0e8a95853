#![expect(unsafe_code, reason = "interface of C")]

use std::ffi::{CStr, c_char};

use ancf::{Model, ModelError, ModelErrors};

use crate::fault::{Fault, guarded};
use crate::pointers::{put, text};
use crate::simulation::Simulation;
use crate::status::Status;

/// Version of the library, such as `0.2.0`.
#[unsafe(no_mangle)]
pub extern "C" fn ancf_version() -> *const c_char {
    CStr::as_ptr(c_version())
}

fn c_version() -> &'static CStr {
    CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()).unwrap_or_default()
}

/// Reads a model file, checks it, and computes the initial state of its motion.
///
/// @param path Path of the model file, in UTF-8.
/// @param simulation Receives the simulation, or NULL after an error. `ancf_close` releases it.
///
/// # Safety
/// `path` ends with a null character, and `simulation` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_open(path: *const c_char, simulation: *mut *mut Simulation) -> Status {
    guarded(|| {
        // SAFETY: the conditions of this function.
        let path = unsafe {
            put(simulation, std::ptr::null_mut(), "simulation")?;
            text(path, "path")?
        };
        let of_file = |errors: ModelErrors| Fault::new(Status::Model, lines(&errors, path));
        let model = Model::read(path).map_err(of_file)?;
        // SAFETY: as above.
        unsafe { put(simulation, started(&model)?, "simulation") }
    })
}

/// Reads the text of a model file, as `ancf_open`.
///
/// @param toml Text of a model file, in UTF-8.
/// @param simulation Receives the simulation, or NULL after an error. `ancf_close` releases it.
///
/// # Safety
/// `toml` ends with a null character, and `simulation` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_parse(toml: *const c_char, simulation: *mut *mut Simulation) -> Status {
    guarded(|| {
        // SAFETY: the conditions of this function.
        let toml = unsafe {
            put(simulation, std::ptr::null_mut(), "simulation")?;
            text(toml, "toml")?
        };
        let of_text = |errors: ModelErrors| Fault::new(Status::Model, lines(&errors, "model"));
        let model = Model::parse(toml).map_err(of_text)?;
        // SAFETY: as above.
        unsafe { put(simulation, started(&model)?, "simulation") }
    })
}

/// Releases a simulation. NULL has no effect.
///
/// # Safety
/// `simulation` is NULL or a simulation that has not been closed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_close(simulation: *mut Simulation) {
    if !simulation.is_null() {
        guarded(|| {
            // SAFETY: the pointer is from `Box::into_raw`.
            drop(unsafe { Box::from_raw(simulation) });
            Ok(())
        });
    }
}

fn started(model: &Model) -> Result<*mut Simulation, Fault> {
    Ok(Box::into_raw(Box::new(Simulation::new(model)?)))
}

/// Errors of a model file, one per line.
fn lines(errors: &ModelErrors, file: &str) -> String {
    let line = |error: &ModelError| format!("{file}:{}{error}", if error.at.is_some() { "" } else { " " });
    errors.iter().map(line).collect::<Vec<_>>().join("\n")
}
