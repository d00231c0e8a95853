//! Accesses to the memory of the importer. All of them check for null pointers.

#![expect(unsafe_code, reason = "pointers of the importer")]

use std::ffi::{CStr, c_char, c_void};
use std::slice;

use crate::component::Fault;

fn null(what: &str) -> Fault {
    Fault::error(format!("{what}: found a null pointer"))
}

/// Reads a text that ends with a null character.
///
/// # Safety
/// The pointer is null or points to a text that ends with a null character and lives as long as the result.
pub(crate) unsafe fn text<'a>(pointer: *const c_char, what: &str) -> Result<&'a str, Fault> {
    if pointer.is_null() {
        return Err(null(what));
    }
    // SAFETY: not null; the rest is the condition of this function.
    let text = unsafe { CStr::from_ptr(pointer) };
    text.to_str().map_err(|_| Fault::error(format!("{what}: expected a text in UTF-8")))
}

/// Reads an array.
///
/// # Safety
/// The pointer is null or points to `count` values that live as long as the result.
pub(crate) unsafe fn array<'a, T>(pointer: *const T, count: usize, what: &str) -> Result<&'a [T], Fault> {
    match (pointer.is_null(), count) {
        (_, 0) => Ok(&[]),
        (true, _) => Err(null(what)),
        // SAFETY: not null; the rest is the condition of this function.
        (false, _) => Ok(unsafe { slice::from_raw_parts(pointer, count) }),
    }
}

/// Writes values into an array of the importer.
///
/// # Safety
/// The pointer is null or points to writable memory for the values.
pub(crate) unsafe fn copy<T: Copy>(values: &[T], to: *mut T, what: &str) -> Result<(), Fault> {
    if values.is_empty() {
        return Ok(());
    }
    if to.is_null() {
        return Err(null(what));
    }
    // SAFETY: not null, and memory of the importer does not overlap values of the library.
    unsafe { to.copy_from_nonoverlapping(values.as_ptr(), values.len()) };
    Ok(())
}

/// Writes a value.
///
/// # Safety
/// The pointer is null or points to writable memory of the type.
pub(crate) unsafe fn put<T>(value: T, to: *mut T, what: &str) -> Result<(), Fault> {
    if to.is_null() {
        return Err(null(what));
    }
    // SAFETY: not null; the rest is the condition of this function.
    unsafe { to.write(value) };
    Ok(())
}

/// Access to an object of the library behind a pointer of the importer.
///
/// # Safety
/// The pointer is null or from [`give`] for the same type, and no other access uses it during the lifetime of the result.
pub(crate) unsafe fn object<'a, T>(pointer: *mut c_void) -> Option<&'a mut T> {
    // SAFETY: the condition of this function.
    unsafe { pointer.cast::<T>().as_mut() }
}

/// Hands an object to the importer.
pub(crate) fn give<T>(object: T) -> *mut c_void {
    Box::into_raw(Box::new(object)).cast()
}

/// Releases an object; null has no effect.
///
/// # Safety
/// The pointer is null or from [`give`] for the same type, and was not released.
pub(crate) unsafe fn release<T>(pointer: *mut c_void) {
    if !pointer.is_null() {
        // SAFETY: the condition of this function.
        drop(unsafe { Box::from_raw(pointer.cast::<T>()) });
    }
}
