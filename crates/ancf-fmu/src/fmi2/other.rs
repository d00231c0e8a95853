use std::ffi::{c_char, c_int, c_void};

use crate::calls::{self, Status, call};

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2SetDebugLogging(
    instance: *mut c_void,
    _logging: c_int,
    _count: usize,
    _categories: *const *const c_char,
) -> Status {
    // Errors and warnings are always reported, and nothing else is.
    // SAFETY: an instance of this library, or null.
    unsafe { call(instance, |_| Ok(())) }
}

/// Access to variables of types that the FMU has not.
macro_rules! no_variables {
    ($($name:ident($pointer:ty) of $of:literal),* $(,)?) => {$(
        #[unsafe(no_mangle)]
        unsafe extern "C" fn $name(
            instance: *mut c_void,
            _references: *const u32,
            count: usize,
            _values: $pointer,
        ) -> Status {
            // SAFETY: an instance of this library, or null.
            unsafe { calls::no_variables(instance, count, $of) }
        }
    )*};
}

no_variables! {
    fmi2GetInteger(*mut c_int) of "integers",
    fmi2SetInteger(*const c_int) of "integers",
    fmi2GetBoolean(*mut c_int) of "booleans",
    fmi2SetBoolean(*const c_int) of "booleans",
    fmi2GetString(*mut *const c_char) of "strings",
    fmi2SetString(*const *const c_char) of "strings",
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2GetFMUstate(instance: *mut c_void, state: *mut *mut c_void) -> Status {
    // SAFETY: an instance of this library, or null, and null or a state of this library.
    unsafe { calls::get_state(instance, state) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2SetFMUstate(instance: *mut c_void, state: *mut c_void) -> Status {
    // SAFETY: as above.
    unsafe { calls::set_state(instance, state) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2FreeFMUstate(instance: *mut c_void, state: *mut *mut c_void) -> Status {
    // SAFETY: as above.
    unsafe { calls::free_state(instance, state) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2SerializedFMUstateSize(
    instance: *mut c_void,
    state: *mut c_void,
    size: *mut usize,
) -> Status {
    // SAFETY: as above.
    unsafe { calls::state_size(instance, state, size) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2SerializeFMUstate(
    instance: *mut c_void,
    state: *mut c_void,
    bytes: *mut u8,
    size: usize,
) -> Status {
    // SAFETY: as above, and an array of the size.
    unsafe { calls::serialize_state(instance, state, bytes, size) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2DeSerializeFMUstate(
    instance: *mut c_void,
    bytes: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> Status {
    // SAFETY: as above, and an array of the size.
    unsafe { calls::deserialize_state(instance, bytes, size, state) }
}
