//! Accesses to the memory of the caller. All of them check for null pointers.

#![expect(unsafe_code, reason = "pointers of the caller")]

use std::ffi::{CStr, c_char};
use std::slice;

use crate::fault::Fault;

fn null(what: &str) -> Fault {
    Fault::argument(format!("`{what}` is a null pointer"))
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
    text.to_str().map_err(|_| Fault::argument(format!("`{what}` is not a text in UTF-8")))
}

/// Writes a value.
///
/// # Safety
/// The pointer is null or points to writable memory of the type.
pub(crate) unsafe fn put<T>(pointer: *mut T, value: T, what: &str) -> Result<(), Fault> {
    if pointer.is_null() {
        return Err(null(what));
    }
    // SAFETY: not null; the rest is the condition of this function.
    unsafe { pointer.write(value) };
    Ok(())
}

/// Writes a value unless the pointer is null.
///
/// # Safety
/// As [`put`].
pub(crate) unsafe fn put_if<T>(pointer: *mut T, value: T) {
    if !pointer.is_null() {
        // SAFETY: not null; the rest is the condition of this function.
        unsafe { pointer.write(value) };
    }
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

/// Writes an array.
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
    // SAFETY: not null, and memory of the caller does not overlap values of the library.
    unsafe { to.copy_from_nonoverlapping(values.as_ptr(), values.len()) };
    Ok(())
}

/// Access to an object that the caller owns.
///
/// # Safety
/// The pointer is null or points to an object that no other access uses during the lifetime of the result.
pub(crate) unsafe fn object<'a, T>(pointer: *mut T, what: &str) -> Result<&'a mut T, Fault> {
    // SAFETY: the condition of this function.
    unsafe { pointer.as_mut() }.ok_or_else(|| null(what))
}
