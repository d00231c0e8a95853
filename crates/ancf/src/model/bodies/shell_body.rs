use super::body::Body;
use crate::errors::{Finding, finding, quoted};

/// Finding for a load of a shell on a body that is no shell. `body` is the body with its path.
pub(crate) fn shell_body(path: &str, body: Option<(String, &Body)>) -> Option<Finding> {
    let (owner, body) = body?;
    let found = format!("{}, which is no shell", quoted(body.name()));
    let is_shell = matches!(body, Body::Shell(_));
    (!is_shell).then(|| finding(format!("{path}.body"), found, "a shell").rests_on([owner]))
}
