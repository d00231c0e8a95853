//! Bodies of the functions that both versions of the standard have.

#![expect(unsafe_code, reason = "pointers of the importer")]

use std::ffi::{c_char, c_void};

use crate::component::{Fault, Instance, Level, SavedState, guarded};
use crate::interface::MARKER;
use crate::memory::{array, copy, give, object, put, release};

/// Text by which the export recognises the library.
#[unsafe(no_mangle)]
extern "C" fn ancf_fmu_marker() -> *const c_char {
    MARKER.as_ptr()
}

/// Status of a call, with the same numbers in both versions.
#[repr(i32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    /// Success.
    Ok = 0,
    /// Success with a message.
    Warning = 1,
    /// The step was not completed, or the information is not available.
    Discard = 2,
    /// The call had no effect.
    Error = 3,
}

impl From<Level> for Status {
    fn from(level: Level) -> Self {
        match level {
            Level::Warning => Self::Warning,
            Level::Discard => Self::Discard,
            Level::Error => Self::Error,
        }
    }
}

/// Runs a call of an instance. Errors and panics are reported by the callback of the importer.
///
/// # Safety
/// The pointer is null, or an instance that has not been released and that no other thread uses.
pub(crate) unsafe fn call(
    instance: *mut c_void,
    body: impl FnOnce(&mut Instance) -> Result<(), Fault>,
) -> Status {
    // SAFETY: the condition of this function.
    let Some(instance) = (unsafe { object::<Instance>(instance) }) else { return Status::Error };
    match guarded(|| body(instance)) {
        Ok(()) => Status::Ok,
        Err(fault) => report(instance, &fault),
    }
}

/// Reports a fault by the callback and returns its status.
pub(crate) fn report(instance: &Instance, fault: &Fault) -> Status {
    // A panic of the callback itself must not leave the function either.
    let _ = guarded(|| {
        instance.log(fault.level, &fault.message);
        Ok(())
    });
    fault.level.into()
}

/// # Safety
/// As [`call`], and the arrays have their sizes.
pub(crate) unsafe fn get(
    instance: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut f64,
    value_count: usize,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        call(instance, |own| {
            same_count(count, value_count)?;
            let references = array(references, count, "value references")?;
            let found = references.iter().map(|reference| own.get(*reference));
            copy(&found.collect::<Result<Vec<_>, _>>()?, values, "values")
        })
    }
}

/// # Safety
/// As [`call`], and the arrays have their sizes.
pub(crate) unsafe fn set(
    instance: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const f64,
    value_count: usize,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        call(instance, |own| {
            same_count(count, value_count)?;
            let references = array(references, count, "value references")?;
            let values = array(values, count, "values")?;
            references.iter().zip(values).try_for_each(|(reference, value)| own.set(*reference, *value))
        })
    }
}

fn same_count(references: usize, values: usize) -> Result<(), Fault> {
    match references == values {
        true => Ok(()),
        false => Err(Fault::error(format!("values: found {values}, expected {references}"))),
    }
}

/// Variables of a type that no FMU of this library has: only empty lists are valid.
///
/// # Safety
/// As [`call`].
pub(crate) unsafe fn no_variables(instance: *mut c_void, count: usize, of: &str) -> Status {
    // SAFETY: the condition of this function.
    unsafe {
        call(instance, |_| match count {
            0 => Ok(()),
            _ => Err(Fault::error(format!("{of}: the FMU has real variables only"))),
        })
    }
}

/// # Safety
/// As [`call`].
pub(crate) unsafe fn unsupported(instance: *mut c_void, name: &str) -> Status {
    // SAFETY: the condition of this function.
    unsafe {
        call(instance, |_| Err(Fault::error(format!("{name}: not supported, as the description states"))))
    }
}

/// # Safety
/// As [`call`], and `state` points to null or to a state of this library.
pub(crate) unsafe fn get_state(instance: *mut c_void, state: *mut *mut c_void) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        call(instance, |own| {
            if state.is_null() {
                return Err(Fault::error("state: found a null pointer"));
            }
            let saved = own.save()?;
            match object::<SavedState>(*state) {
                Some(former) => *former = saved,
                None => *state = give(saved),
            }
            Ok(())
        })
    }
}

/// # Safety
/// As [`call`], and `state` is null or a state of this library.
pub(crate) unsafe fn set_state(instance: *mut c_void, state: *mut c_void) -> Status {
    // SAFETY: the conditions of this function.
    unsafe { call(instance, |own| own.restore(saved(state)?)) }
}

/// # Safety
/// As [`call`], and `state` points to null or to a state of this library.
pub(crate) unsafe fn free_state(instance: *mut c_void, state: *mut *mut c_void) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        call(instance, |_| {
            if !state.is_null() {
                release::<SavedState>(*state);
                *state = std::ptr::null_mut();
            }
            Ok(())
        })
    }
}

/// # Safety
/// As [`call`], `state` is null or a state of this library, and `size` points to writable memory.
pub(crate) unsafe fn state_size(instance: *mut c_void, state: *mut c_void, size: *mut usize) -> Status {
    // SAFETY: the conditions of this function.
    unsafe { call(instance, |_| put(saved(state)?.to_bytes()?.len(), size, "size")) }
}

/// # Safety
/// As [`call`], `state` is null or a state of this library, and `bytes` points to `size` writable bytes.
pub(crate) unsafe fn serialize_state(
    instance: *mut c_void,
    state: *mut c_void,
    bytes: *mut u8,
    size: usize,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        call(instance, |_| {
            let own = saved(state)?.to_bytes()?;
            if own.len() > size {
                return Err(Fault::error(format!("size: found {size}, expected {} bytes", own.len())));
            }
            copy(&own, bytes, "serialized state")
        })
    }
}

/// # Safety
/// As [`call`], `bytes` points to `size` bytes, and `state` points to null or to a state of this library.
pub(crate) unsafe fn deserialize_state(
    instance: *mut c_void,
    bytes: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        call(instance, |_| {
            let read = SavedState::from_bytes(array(bytes, size, "serialized state")?)?;
            put(give(read), state, "state")
        })
    }
}

unsafe fn saved<'a>(state: *mut c_void) -> Result<&'a SavedState, Fault> {
    // SAFETY: the condition of the callers.
    let state = unsafe { object::<SavedState>(state) };
    state.map(|state| &*state).ok_or_else(|| Fault::error("state: found a null pointer"))
}

/// Arrays of a directional derivative.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Direction {
    pub(crate) unknowns: (*const u32, usize),
    pub(crate) knowns: (*const u32, usize),
    pub(crate) seed: (*const f64, usize),
    pub(crate) product: (*mut f64, usize),
}

/// # Safety
/// As [`call`], and the arrays have their sizes.
pub(crate) unsafe fn directional_derivative(instance: *mut c_void, of: Direction) -> Status {
    // SAFETY: the conditions of this function.
    unsafe {
        call(instance, |own| {
            let unknowns = array(of.unknowns.0, of.unknowns.1, "unknowns")?;
            let knowns = array(of.knowns.0, of.knowns.1, "knowns")?;
            let seed = array(of.seed.0, of.seed.1, "seed")?;
            same_count(unknowns.len(), of.product.1)?;
            copy(&own.directional_derivative(unknowns, knowns, seed)?, of.product.0, "sensitivity")
        })
    }
}
