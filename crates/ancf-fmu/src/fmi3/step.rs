use std::ffi::c_void;

use crate::calls::{self, Direction, Status, call, report};
use crate::component::{Fault, Instance, Level};
use crate::memory::{object, put};

/// A step whose computation fails ends early, at the time of its last state. It is valid if the importer allows this. Otherwise the
/// status is `Discard`, and `Error` without any progress.
#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3DoStep(
    instance: *mut c_void,
    t: f64,
    h: f64,
    _no_set_state: bool,
    event_needed: *mut bool,
    terminate: *mut bool,
    early_return: *mut bool,
    last_time: *mut f64,
) -> Status {
    let mut failure = None;
    // SAFETY: an instance of this library, or null, and writable memory.
    let status = unsafe {
        call(instance, |own| {
            let end = own.do_step(t, h)?;
            put(false, event_needed, "event handling needed")?;
            put(false, terminate, "terminate simulation")?;
            put(end.failure.is_some(), early_return, "early return")?;
            put(end.time, last_time, "last successful time")?;
            failure = end.failure;
            Ok(())
        })
    };
    match (failure, status) {
        // SAFETY: as above.
        (Some(fault), Status::Ok) => match unsafe { object::<Instance>(instance) } {
            Some(own) if own.may_return_early && fault.level == Level::Discard => {
                let _ = report(own, &Fault { level: Level::Warning, ..fault });
                Status::Ok
            }
            Some(own) => report(own, &fault),
            None => Status::Error,
        },
        _ => status,
    }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3GetFloat64(
    instance: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut f64,
    value_count: usize,
) -> Status {
    // SAFETY: an instance of this library, or null, and arrays of their sizes.
    unsafe { calls::get(instance, references, count, values, value_count) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3SetFloat64(
    instance: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const f64,
    value_count: usize,
) -> Status {
    // SAFETY: an instance of this library, or null, and arrays of their sizes.
    unsafe { calls::set(instance, references, count, values, value_count) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3GetDirectionalDerivative(
    instance: *mut c_void,
    unknowns: *const u32,
    unknown_count: usize,
    knowns: *const u32,
    known_count: usize,
    seed: *const f64,
    seed_count: usize,
    product: *mut f64,
    product_count: usize,
) -> Status {
    let of = Direction {
        unknowns: (unknowns, unknown_count),
        knowns: (knowns, known_count),
        seed: (seed, seed_count),
        product: (product, product_count),
    };
    // SAFETY: an instance of this library, or null, and arrays of their sizes.
    unsafe { calls::directional_derivative(instance, of) }
}
