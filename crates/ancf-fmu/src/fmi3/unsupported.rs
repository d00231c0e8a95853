use std::ffi::c_void;

use crate::calls::{self, Status};

/// Functions that the description excludes. All symbols of the standard are present, since importers load them at once.
macro_rules! unsupported {
    ($($name:ident($($more:ty),*)),* $(,)?) => {$(
        #[unsafe(no_mangle)]
        unsafe extern "C" fn $name(instance: *mut c_void $(, _: $more)*) -> Status {
            // SAFETY: an instance of this library, or null.
            unsafe { calls::unsupported(instance, stringify!($name)) }
        }
    )*};
}

unsupported! {
    fmi3EnterEventMode(),
    fmi3EnterStepMode(),
    fmi3EnterConfigurationMode(),
    fmi3ExitConfigurationMode(),
    fmi3EvaluateDiscreteStates(),
    fmi3UpdateDiscreteStates(*mut bool, *mut bool, *mut bool, *mut bool, *mut bool, *mut f64),
    fmi3GetNumberOfVariableDependencies(u32, *mut usize),
    fmi3GetVariableDependencies(u32, *mut usize, *mut u32, *mut usize, *mut i32, usize),
    fmi3GetAdjointDerivative(
        *const u32, usize, *const u32, usize, *const f64, usize, *mut f64, usize
    ),
    fmi3GetOutputDerivatives(*const u32, usize, *const i32, *mut f64, usize),
    fmi3ActivateModelPartition(u32, f64),
    fmi3EnterContinuousTimeMode(),
    fmi3CompletedIntegratorStep(bool, *mut bool, *mut bool),
    fmi3SetTime(f64),
    fmi3SetContinuousStates(*const f64, usize),
    fmi3GetContinuousStateDerivatives(*mut f64, usize),
    fmi3GetEventIndicators(*mut f64, usize),
    fmi3GetContinuousStates(*mut f64, usize),
    fmi3GetNominalsOfContinuousStates(*mut f64, usize),
    fmi3GetNumberOfEventIndicators(*mut usize),
    fmi3GetNumberOfContinuousStates(*mut usize),
}
