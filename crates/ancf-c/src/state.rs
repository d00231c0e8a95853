#![expect(unsafe_code, reason = "interface of C")]

use ancf::CompleteState;

use crate::fault::Fault;
use crate::pointers::{array, copy, put, put_if};
use crate::simulation::{Simulation, with};
use crate::status::Status;

/// Snapshot of everything on which later steps depend. Steps after `ancf_restore` are bit-identical, also in another process.
///
/// If the buffer is too small or NULL, the result is `ANCF_STATUS_BUFFER`, and `size` is the size that is required. The size may
/// change with each step.
///
/// @param bytes Buffer of `capacity` bytes, or NULL.
/// @param size Receives the size of the snapshot.
///
/// # Safety
/// `simulation` is open, `bytes` is NULL or points to `capacity` writable bytes, and `size` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_save(
    simulation: *mut Simulation,
    bytes: *mut u8,
    capacity: usize,
    size: *mut usize,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        with(simulation, |own| {
            let snapshot = own.stepper.save()?;
            put(size, snapshot.len(), "size")?;
            if bytes.is_null() || capacity < snapshot.len() {
                let text = format!("capacity: found {capacity}, expected {} bytes", snapshot.len());
                return Err(Fault::new(Status::Buffer, text));
            }
            copy(&snapshot, bytes, "bytes")
        })
    }
}

/// Continues from a snapshot of the same model and the same version.
///
/// # Safety
/// `simulation` is open, and `bytes` points to `size` bytes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_restore(simulation: *mut Simulation, bytes: *const u8, size: usize) -> Status {
    // SAFETY: the conditions of this function.
    unsafe { with(simulation, |own| Ok(own.stepper.restore(array(bytes, size, "bytes")?)?)) }
}

/// Number of coordinates of the complete state.
///
/// # Safety
/// `simulation` is open, and `count` points to writable memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_count_coordinates(simulation: *mut Simulation, count: *mut usize) -> Status {
    // SAFETY: the conditions of this function.
    unsafe { with(simulation, |own| put(count, own.stepper.solver_state().q.len(), "count")) }
}

/// Complete state: coordinates as changes from the reference configuration, and velocities.
///
/// @param coordinates Receives `count` coordinates.
/// @param velocities Receives `count` velocities.
///
/// # Safety
/// `simulation` is open, and the pointers point to writable memory for `count` numbers.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_get_state(
    simulation: *mut Simulation,
    coordinates: *mut f64,
    velocities: *mut f64,
    count: usize,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        with(simulation, |own| {
            let state = own.stepper.state();
            let expected = state.coordinates.len();
            if count != expected {
                return Err(Fault::argument(format!("count: found {count}, expected {expected}")));
            }
            copy(&state.coordinates, coordinates, "coordinates")?;
            copy(&state.velocities, velocities, "velocities")
        })
    }
}

/// Continues from another state. Positions and velocities are projected onto the constraints. Angles of hinges and sensors that the
/// coordinates determine up to whole turns are then between −π and π. Inputs keep their values.
///
/// @param moved Receives the largest displacement of a node or centre by the projection; may be NULL.
/// @param corrected Receives the kinetic energy of the correction of the velocities, relative to that of the given ones; may be NULL.
///
/// # Safety
/// `simulation` is open, `coordinates` and `velocities` point to `count` numbers, the other pointers are NULL or point to writable
/// memory.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn ancf_set_state(
    simulation: *mut Simulation,
    time: f64,
    coordinates: *const f64,
    velocities: *const f64,
    count: usize,
    moved: *mut f64,
    corrected: *mut f64,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        with(simulation, |own| {
            let coordinates = array(coordinates, count, "coordinates")?.to_vec();
            let velocities = array(velocities, count, "velocities")?.to_vec();
            let projection = own.stepper.set_state(&CompleteState {
                time,
                coordinates,
                velocities,
                angles: Vec::new(),
            })?;
            put_if(moved, projection.moved);
            put_if(corrected, projection.corrected);
            Ok(())
        })
    }
}
