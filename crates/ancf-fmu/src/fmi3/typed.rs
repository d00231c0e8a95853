use std::ffi::{c_char, c_void};

use crate::calls::{self, Status};

/// Access to variables of types that the FMU has not.
macro_rules! no_variables {
    ($($name:ident($($more:ty),*) of $of:literal),* $(,)?) => {$(
        #[unsafe(no_mangle)]
        unsafe extern "C" fn $name(
            instance: *mut c_void,
            _references: *const u32,
            count: usize,
            $(_: $more),*
        ) -> Status {
            // SAFETY: an instance of this library, or null.
            unsafe { calls::no_variables(instance, count, $of) }
        }
    )*};
}

no_variables! {
    fmi3GetFloat32(*mut f32, usize) of "32-bit numbers",
    fmi3SetFloat32(*const f32, usize) of "32-bit numbers",
    fmi3GetInt8(*mut i8, usize) of "integers",
    fmi3SetInt8(*const i8, usize) of "integers",
    fmi3GetUInt8(*mut u8, usize) of "integers",
    fmi3SetUInt8(*const u8, usize) of "integers",
    fmi3GetInt16(*mut i16, usize) of "integers",
    fmi3SetInt16(*const i16, usize) of "integers",
    fmi3GetUInt16(*mut u16, usize) of "integers",
    fmi3SetUInt16(*const u16, usize) of "integers",
    fmi3GetInt32(*mut i32, usize) of "integers",
    fmi3SetInt32(*const i32, usize) of "integers",
    fmi3GetUInt32(*mut u32, usize) of "integers",
    fmi3SetUInt32(*const u32, usize) of "integers",
    fmi3GetInt64(*mut i64, usize) of "integers",
    fmi3SetInt64(*const i64, usize) of "integers",
    fmi3GetUInt64(*mut u64, usize) of "integers",
    fmi3SetUInt64(*const u64, usize) of "integers",
    fmi3GetBoolean(*mut bool, usize) of "booleans",
    fmi3SetBoolean(*const bool, usize) of "booleans",
    fmi3GetString(*mut *const c_char, usize) of "strings",
    fmi3SetString(*const *const c_char, usize) of "strings",
    fmi3GetBinary(*mut usize, *mut *const u8, usize) of "binary values",
    fmi3SetBinary(*const usize, *const *const u8, usize) of "binary values",
    fmi3GetClock(*mut bool) of "clocks",
    fmi3SetClock(*const bool) of "clocks",
    fmi3GetIntervalDecimal(*mut f64, *mut i32) of "clocks",
    fmi3SetIntervalDecimal(*const f64) of "clocks",
    fmi3GetIntervalFraction(*mut u64, *mut u64, *mut i32) of "clocks",
    fmi3SetIntervalFraction(*const u64, *const u64) of "clocks",
    fmi3GetShiftDecimal(*mut f64) of "clocks",
    fmi3SetShiftDecimal(*const f64) of "clocks",
    fmi3GetShiftFraction(*mut u64, *mut u64) of "clocks",
    fmi3SetShiftFraction(*const u64, *const u64) of "clocks",
}
