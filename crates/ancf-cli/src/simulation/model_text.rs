//! Changes of the text of a model file that arguments of the command line make.

use ancf::Model;
use ancf::model::Body;
use toml_edit::{Array, DocumentMut, Item, table, value};

/// Returns the text of a model file with the numbers of elements of a model.
///
/// # Errors
/// If the text is not that of the model.
pub fn with_elements(text: &str, model: &Model) -> anyhow::Result<String> {
    let mut document: DocumentMut = text.parse()?;
    let missing = || anyhow::anyhow!("the model file has no list `bodies`");
    let bodies = document.get_mut("bodies").ok_or_else(missing)?;
    for (number, body) in model.bodies.iter().enumerate() {
        let mut elements = match body {
            Body::Shell(shell) => value(shell.elements.iter().map(|n| i64::from(*n)).collect::<Array>()),
            Body::Beam(_) | Body::Cable(_) => value(i64::from(body.elements())),
            // The mesh of a shell with shear is given by its nodes.
            Body::ShearShell(_) | Body::Rigid(_) | Body::Mass(_) => continue,
        };
        let entry = bodies.get_mut(number).and_then(|body| body.get_mut("elements")).ok_or_else(missing)?;
        if let (Item::Value(old), Item::Value(new)) = (&*entry, &mut elements) {
            *new.decor_mut() = old.decor().clone();
        }
        *entry = elements;
    }
    Ok(document.to_string())
}

/// Returns the text of a model file with `output.errors = true`.
///
/// # Errors
/// If the text is not a model file.
pub fn with_errors(text: &str) -> anyhow::Result<String> {
    let mut document: DocumentMut = text.parse()?;
    let output = document.entry("output").or_insert_with(table);
    let output = output.as_table_like_mut().ok_or_else(|| anyhow::anyhow!("`output` is not a table"))?;
    output.insert("errors", value(true));
    Ok(document.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_added_to_any_form_of_the_table() {
        for text in ["", "[output]\nevery = 2\n", "output = { every = 2 }\n", "[output]\nerrors = false\n"] {
            let changed: DocumentMut = with_errors(text).unwrap().parse().unwrap();
            assert_eq!(changed["output"]["errors"].as_bool(), Some(true), "{text}");
        }
    }
}
