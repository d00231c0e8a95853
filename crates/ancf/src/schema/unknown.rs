use super::schema_check::did_you_mean;
use crate::errors::{Finding, ModelError, listed, nearest, quoted};

/// Finding for an unknown name.
pub(crate) fn unknown(path: String, noun: &str, name: &str, names: Vec<&str>) -> Finding {
    let article = if noun.starts_with('i') { "an" } else { "a" };
    let expected = match names.len() {
        0 => format!("the name of {article} {noun}, but there is none"),
        1..=8 => {
            format!("the name of {article} {noun}: {}", listed(names.iter().map(|name| quoted(name)), "or"))
        }
        n => format!("the name of one of the {n} {noun}s"),
    };
    let error = ModelError::new(path, quoted(name), expected);
    Finding { absence: true, ..did_you_mean(error, nearest(name, names).map(quoted)).into() }
}
