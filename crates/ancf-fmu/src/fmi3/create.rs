use std::ffi::{CStr, CString, c_char, c_int, c_void};

use crate::calls::{Status, call};
use crate::component::{Fault, Instance, Level, Resources, folder_of, guarded};
use crate::memory::{give, release, text};

/// Callback for messages.
type Logger = unsafe extern "C" fn(*mut c_void, c_int, *const c_char, *const c_char);
/// Callback that the library does not use.
type Unused = Option<unsafe extern "C" fn()>;

#[unsafe(no_mangle)]
extern "C" fn fmi3GetVersion() -> *const c_char {
    CStr::as_ptr(c"3.0")
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3InstantiateCoSimulation(
    _name: *const c_char,
    token: *const c_char,
    location: *const c_char,
    _visible: bool,
    _logging: bool,
    _event_mode: bool,
    early_return: bool,
    _intermediate: *const u32,
    intermediate_count: usize,
    environment: *mut c_void,
    logger: Option<Logger>,
    _update: Unused,
) -> *mut c_void {
    let log = move |level: Level, message: &str| {
        let category = match level {
            Level::Warning => c"logStatusWarning",
            Level::Discard => c"logStatusDiscard",
            Level::Error => c"logStatusError",
        };
        let message = CString::new(message.replace('\0', "")).unwrap_or_default();
        if let Some(logger) = logger {
            // SAFETY: the callback of the importer with texts that live longer than the call.
            unsafe { logger(environment, Status::from(level) as c_int, category.as_ptr(), message.as_ptr()) };
        }
    };
    let created = guarded(|| {
        if intermediate_count > 0 {
            return Err(Fault::error("the FMU has no intermediate values"));
        }
        // SAFETY: texts of the importer, or null.
        let (token, location) =
            unsafe { (text(token, "instantiation token")?, text(location, "resource path")?) };
        Resources::read(&folder_of(location)?, token)
    });
    match created {
        Ok(resources) => {
            let mut instance = Instance::new(resources, Box::new(log));
            instance.may_return_early = early_return;
            give(instance)
        }
        Err(fault) => {
            log(fault.level, &fault.message);
            std::ptr::null_mut()
        }
    }
}

#[unsafe(no_mangle)]
extern "C" fn fmi3InstantiateModelExchange(
    _name: *const c_char,
    _token: *const c_char,
    _location: *const c_char,
    _visible: bool,
    _logging: bool,
    _environment: *mut c_void,
    _logger: Option<Logger>,
) -> *mut c_void {
    std::ptr::null_mut()
}

#[unsafe(no_mangle)]
extern "C" fn fmi3InstantiateScheduledExecution(
    _name: *const c_char,
    _token: *const c_char,
    _location: *const c_char,
    _visible: bool,
    _logging: bool,
    _environment: *mut c_void,
    _logger: Option<Logger>,
    _update: Unused,
    _lock: Unused,
    _unlock: Unused,
) -> *mut c_void {
    std::ptr::null_mut()
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3FreeInstance(instance: *mut c_void) {
    let _ = guarded(|| {
        // SAFETY: an instance of this library, or null.
        unsafe { release::<Instance>(instance) };
        Ok(())
    });
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3SetDebugLogging(
    instance: *mut c_void,
    _logging: bool,
    _count: usize,
    _categories: *const *const c_char,
) -> Status {
    // Errors and warnings are always reported, and nothing else is.
    // SAFETY: an instance of this library, or null.
    unsafe { call(instance, |_| Ok(())) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3EnterInitializationMode(
    instance: *mut c_void,
    _tolerance_defined: bool,
    _tolerance: f64,
    start: f64,
    stop_defined: bool,
    stop: f64,
) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe {
        call(instance, |own| {
            own.set_up(start, stop_defined.then_some(stop))?;
            own.enter_initialization()
        })
    }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3ExitInitializationMode(instance: *mut c_void) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe { call(instance, Instance::exit_initialization) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3Terminate(instance: *mut c_void) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe { call(instance, Instance::terminate) }
}

#[unsafe(no_mangle)]
unsafe extern "C" fn fmi3Reset(instance: *mut c_void) -> Status {
    // SAFETY: an instance of this library, or null.
    unsafe {
        call(instance, |own| {
            own.reset();
            Ok(())
        })
    }
}
