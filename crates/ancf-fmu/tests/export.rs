//! Exports that are rejected, with their messages.

use std::path::Path;

use ancf_fmu::{ExportError, Fmi, Options, export};

const MODEL: &str = include_str!("models/cart_pole.toml");

/// Message of a rejected export, with a file that is not the shared library.
fn rejected(text: &str, parameters: &[(&str, Option<f64>)]) -> ExportError {
    let parameters: Vec<_> = parameters.iter().map(|(path, value)| ((*path).to_owned(), *value)).collect();
    let library = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml"));
    let options = Options { name: "model", version: Fmi::Three, parameters: &parameters, library };
    export(text, &options, Path::new("no/such/folder/model.fmu")).expect_err("the export is rejected")
}

#[track_caller]
fn assert_states(error: &ExportError, text: &str) {
    assert!(error.to_string().contains(text), "{error}\nwithout: {text}");
}

#[test]
fn parameters_are_real_keys_of_the_model() {
    for (path, value, text) in [
        ("bodies.card.mass", None, "parameter bodies.card.mass: bodies.card: found no `card`"),
        ("bodies.cart.name", None, "bodies[0].name is not a number"),
        ("gravity", None, "gravity is not a number"),
        ("pin.stiffness", None, "parameter pin.stiffness"),
    ] {
        assert_states(&rejected(MODEL, &[(path, value)]), text);
    }
    let integer = rejected(MODEL, &[("bodies.pole.elements", None)]);
    assert!(matches!(integer, ExportError::Model(_)), "{integer}");
    assert_states(&integer, "elements");
    let negative = rejected(MODEL, &[("bodies.cart.mass", Some(-1.0))]);
    assert!(matches!(negative, ExportError::Model(_)), "{negative}");
    let twice = [("bodies.pole.material.young", None), ("materials.steel.young", None)];
    assert_states(&rejected(MODEL, &twice), "materials.steel.young is a parameter already");
    let valid = rejected(MODEL, &[("bodies.pole.material.young", None), ("gravity[1]", Some(-1620.0))]);
    assert!(matches!(valid, ExportError::Library { .. }), "{valid}");
}

#[test]
fn models_are_motions_with_unique_names() {
    let same = MODEL.replace("\"push\"", "\"kinetic\"");
    assert_states(&rejected(&same, &[]), "two variables have the name \"kinetic\"");
    let statics = rejected(
        &MODEL.replace(
            "\"dynamics\"\nduration = 0.2\nstep = 1e-3\nscheme = { spectral_radius = 0.8 }",
            "\"statics\"",
        ),
        &[],
    );
    assert_states(&statics, "analysis");
    let other = rejected(&format!("initial = {{ from = \"other\" }}\n{MODEL}"), &[]);
    assert_states(&other, "initial.from: found the results folder \"other\"");
    assert!(matches!(rejected("bodies = 3", &[]), ExportError::Model(_)));
}

#[test]
fn the_library_is_that_of_this_version() {
    assert_states(&rejected(MODEL, &[]), "expected the shared library of the crate ancf-fmu, version");
}
