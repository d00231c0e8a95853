use std::ffi::{CStr, CString, c_char, c_int, c_void};

use crate::calls::{Status, call};
use crate::component::{Fault, Instance, Level, Resources, folder_of, guarded};
use crate::memory::{give, release, text};

/// Callback for messages, with the arguments of `printf`.
type Logger = unsafe extern "C" fn(*mut c_void, *const c_char, c_int, *const c_char, *const c_char, ...);

/// Callbacks of the importer.
#[repr(C)]
struct Callbacks {
    logger: Option<Logger>,
    allocate: Option<unsafe extern "C" fn(usize, usize) -> *mut c_void>,
    free: Option<unsafe extern "C" fn(*mut c_void)>,
    step_finished: Option<unsafe extern "C" fn(*mut c_void, c_int)>,
    environment: *mut c_void,
}

const CO_SIMULATION: c_int = 1;

#[unsafe(no_mangle)]
extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    CStr::as_ptr(c"default")
}

#[unsafe(no_mangle)]
extern "C" fn fmi2GetVersion() -> *const c_char {
    CStr::as_ptr(c"2.0")
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2Instantiate(
    name: *const c_char,
    kind: c_int,
    token: *const c_char,
    location: *const c_char,
    callbacks: *const Callbacks,
    _visible: c_int,
    _logging: c_int,
) -> *mut c_void {
    // SAFETY: the callbacks are valid until the instance is released.
    let callbacks = unsafe { callbacks.as_ref() };
    let Some(logger) = callbacks.and_then(|own| own.logger) else { return std::ptr::null_mut() };
    let environment = callbacks.map_or(std::ptr::null_mut(), |own| own.environment);
    // SAFETY: a text of the importer, or null.
    let name = unsafe { text(name, "instance name") }.unwrap_or_default();
    let name = CString::new(name).unwrap_or_default();
    let log = move |level: Level, message: &str| {
        let category = match level {
            Level::Warning => c"logStatusWarning",
            Level::Discard => c"logStatusDiscard",
            Level::Error => c"logStatusError",
        };
        // The message is a format.
        let message = CString::new(message.replace('\0', "").replace('%', "%%")).unwrap_or_default();
        let status = Status::from(level) as c_int;
        // SAFETY: the callback of the importer with texts that live longer than the call.
        unsafe { logger(environment, name.as_ptr(), status, category.as_ptr(), message.as_ptr()) };
    };
    let created = guarded(|| {
        if kind != CO_SIMULATION {
            return Err(Fault::error("the FMU is one for co-simulation"));
        }
        // SAFETY: texts of the importer, or null.
        let (token, location) = unsafe { (text(token, "GUID")?, text(location, "resource location")?) };
        Resources::read(&folder_of(location)?, token)
    });
    match created {
        Ok(resources) => give(Instance::new(resources, Box::new(log))),
        Err(fault) => {
            log(fault.level, &fault.message);
            std::ptr::null_mut()
        }
    }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2FreeInstance(instance: *mut c_void) {
    let _ = guarded(|| {
        // SAFETY: an instance of this library, or null.
        unsafe { release::<Instance>(instance) };
        Ok(())
    });
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2SetupExperiment(
    instance: *mut c_void,
    _tolerance_defined: c_int,
    _tolerance: f64,
    start: f64,
    stop_defined: c_int,
    stop: f64,
) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe { call(instance, |own| own.set_up(start, (stop_defined != 0).then_some(stop))) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2EnterInitializationMode(instance: *mut c_void) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe { call(instance, Instance::enter_initialization) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2ExitInitializationMode(instance: *mut c_void) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe { call(instance, Instance::exit_initialization) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2Terminate(instance: *mut c_void) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe { call(instance, Instance::terminate) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi2Reset(instance: *mut c_void) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe {
        call(instance, |own| {
            own.reset();
            Ok(())
        })
    }
}
