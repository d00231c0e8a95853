use std::ffi::{c_char, c_int, c_void};

use crate::calls::{self, Direction, Status, call, report};
use crate::component::{Fault, Instance};
use crate::memory::{object, put};

/// Kind of the time of the last state in `fmi2GetRealStatus`.
const LAST_SUCCESSFUL_TIME: c_int = 2;
/// Kind of the end of the simulation in `fmi2GetBooleanStatus`.
const TERMINATED: c_int = 3;

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2DoStep(instance: *mut c_void, t: f64, h: f64, _no_set_state: c_int) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe { call(instance, |own| own.do_step(t, h)?.failure.map_or(Ok(()), Err)) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2GetReal(
    instance: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut f64,
) -> Status {
    // SAFETY: an instance of this library, or null, and arrays of their sizes.
    unsafe { calls::get(instance, references, count, values, count) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2SetReal(
    instance: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const f64,
) -> Status {
    // SAFETY: an instance of this library, or null, and arrays of their sizes.
    unsafe { calls::set(instance, references, count, values, count) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2GetDirectionalDerivative(
    instance: *mut c_void,
    unknowns: *const u32,
    unknown_count: usize,
    knowns: *const u32,
    known_count: usize,
    seed: *const f64,
    product: *mut f64,
) -> Status {
    let of = Direction {
        unknowns: (unknowns, unknown_count),
        knowns: (knowns, known_count),
        seed: (seed, known_count),
        product: (product, unknown_count),
    };
    // SAFETY: an instance of this library, or null, and arrays of their sizes.
    unsafe { calls::directional_derivative(instance, of) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2GetRealStatus(instance: *mut c_void, kind: c_int, value: *mut f64) -> Status {
    // SAFETY: an instance of this library, or null, and writable memory.
    unsafe {
        call(instance, |own| match kind {
            LAST_SUCCESSFUL_TIME => put(own.time(), value, "value"),
            _ => Err(Fault::discard("the status is not available")),
        })
    }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2GetBooleanStatus(instance: *mut c_void, kind: c_int, value: *mut c_int) -> Status {
    // SAFETY: an instance of this library, or null, and writable memory.
    unsafe {
        call(instance, |_| match kind {
            TERMINATED => put(0, value, "value"),
            _ => Err(Fault::discard("the status is not available")),
        })
    }
}

/// Functions for steps that run in the background, which the FMU has not.
macro_rules! unavailable {
    ($($name:ident($type:ty)),* $(,)?) => {$(
        #[unsafe(no_mangle)]
        unsafe extern "C" fn $name(instance: *mut c_void, _kind: c_int, _value: *mut $type) -> Status {
            // SAFETY: an instance of this library, or null.
            match unsafe { object::<Instance>(instance) } {
                Some(own) => report(own, &Fault::discard("the status is not available")),
                None => Status::Error,
            }
        }
    )*};
}

unavailable!(fmi2GetStatus(c_int), fmi2GetIntegerStatus(c_int), fmi2GetStringStatus(*const c_char));

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2CancelStep(instance: *mut c_void) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe { calls::unsupported(instance, "fmi2CancelStep") }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2SetRealInputDerivatives(
    instance: *mut c_void,
    _references: *const u32,
    _count: usize,
    _orders: *const c_int,
    _values: *const f64,
) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe { calls::unsupported(instance, "fmi2SetRealInputDerivatives") }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2GetRealOutputDerivatives(
    instance: *mut c_void,
    _references: *const u32,
    _count: usize,
    _orders: *const c_int,
    _values: *mut f64,
) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe { calls::unsupported(instance, "fmi2GetRealOutputDerivatives") }
}
