use std::ffi::c_void;

use crate::calls::{self, Status};

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3GetFMUState(instance: *mut c_void, state: *mut *mut c_void) -> Status {
    // SAFETY: an instance of this library, or null, and null or a state of this library.
    unsafe { calls::get_state(instance, state) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3SetFMUState(instance: *mut c_void, state: *mut c_void) -> Status {
    // SAFETY: as above.
    unsafe { calls::set_state(instance, state) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3FreeFMUState(instance: *mut c_void, state: *mut *mut c_void) -> Status {
    // SAFETY: as above.
    unsafe { calls::free_state(instance, state) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3SerializedFMUStateSize(
    instance: *mut c_void,
    state: *mut c_void,
    size: *mut usize,
) -> Status {
    // SAFETY: as above.
    unsafe { calls::state_size(instance, state, size) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3SerializeFMUState(
    instance: *mut c_void,
    state: *mut c_void,
    bytes: *mut u8,
    size: usize,
) -> Status {
    // SAFETY: as above, and an array of the size.
    unsafe { calls::serialize_state(instance, state, bytes, size) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3DeserializeFMUState(
    instance: *mut c_void,
    bytes: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> Status {
    // SAFETY: as above, and an array of the size.
    unsafe { calls::deserialize_state(instance, bytes, size, state) }
}
