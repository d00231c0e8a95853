/// Result of a function. The message of an error is that of `ancf_last_error`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Success.
    Ok = 0,
    /// An argument is not valid: a null pointer, an unknown name, an index or a value out of range. Nothing has changed.
    Argument = 1,
    /// The model cannot be read or is not valid, or it has no motion that can be advanced step by step. The message has all errors.
    Model = 2,
    /// The computation failed: time, cause, place and remedy. The state is that of the last accepted substep.
    Failed = 3,
    /// The snapshot does not belong to the model, or is damaged. Nothing has changed.
    Snapshot = 4,
    /// The buffer is too small. The size that is required has been written.
    Buffer = 5,
    /// Internal error. The simulation can only be closed.
    Internal = 6,
}
