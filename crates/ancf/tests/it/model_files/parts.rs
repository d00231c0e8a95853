//! Checks of single parts of a model.

use ancf::reading::check_part;
use toml::{Table, Value};

/// Error messages of a part.
fn errors_of(definition: &str, text: &str) -> Vec<String> {
    let data = Value::Table(text.parse::<Table>().expect("the text is TOML"));
    check_part(definition, &data)
        .map_or_else(|errors| errors.iter().map(ToString::to_string).collect(), |()| vec![])
}

#[test]
fn valid_parts_are_accepted() {
    assert!(errors_of("Section", "kind = 'tube'\nouter = 2\ninner = 1").is_empty());
    assert!(
        errors_of("Place", "body = 'nobody knows'\nat = 'end'").is_empty(),
        "names are checked with the complete model"
    );
    assert!(errors_of("Material", "density = 7850\nyoung = 2e11\ndamping = { strain = 1e-4 }").is_empty());
}

#[test]
fn all_errors_of_a_part_are_reported() {
    assert_eq!(
        errors_of("Body", "kind = 'mass'\nname = ''\ncentre = [0, 0]\nmass = -1"),
        [
            "centre: found unknown key `centre`, expected `center`, `kind`, `mass`, `motion`, `name` or `surface` (did you mean \
             `center`?)",
            "centre: found an array of 2, expected an array of 3 numbers",
            "mass: found -1, expected a number > 0",
            "name: found \"\", expected a text that is not empty",
        ]
    );
    assert_eq!(
        errors_of("Section", "kind = 'circel'\ndiameter = 1"),
        [
            "kind: found \"circel\", expected \"circle\", \"tube\", \"rectangle\", \"ellipse\" or \"general\" (did you \
          mean \"circle\"?)"
        ]
    );
    assert_eq!(
        errors_of("Probe", "name = 'tip'"),
        ["on: found no key `on`, expected a table with `body` and `at` (Place on the axis)"]
    );
}

#[test]
fn complete_models_are_checked_as_parts() {
    let text = "bodies = [{ kind = 'mass', name = 'm', mass = 1, center = [0, 0, 0] }]\nanalysis = { kind = 'modes' }";
    assert!(errors_of("Model", text).is_empty());
    assert_eq!(errors_of("Model", &text.replace("modes", "mods")).len(), 1);
}

#[test]
fn strings_and_numbers_are_checked_as_parts() {
    assert!(check_part("Formulation", &"linked".into()).is_ok());
    assert!(check_part("TimeFunction", &2.0.into()).is_ok());
    assert!(check_part("TimeFunction", &"2".into()).is_err());
}

#[test]
fn unknown_definitions_are_rejected() {
    let errors = check_part("Sektion", &1.into()).expect_err("the definition does not exist");
    assert!(errors.to_string().ends_with("(did you mean \"Section\"?)"), "{errors}");
}
