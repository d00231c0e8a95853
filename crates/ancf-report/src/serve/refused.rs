/// Reason why no request was read.
pub(super) enum Refused {
    /// The bytes are not an HTTP request.
    Malformed,
    /// The request exceeds the limits of size or number of headers.
    Large,
    /// The connection broke, timed out, or the server was stopped.
    Lost,
}
