//! Parts of a model, checked by themselves.

use ancf::model::check_part;
use toml::{Table, Value};

/// What is wrong with a part, in words.
fn wrong(definition: &str, text: &str) -> Vec<String> {
    let data = Value::Table(text.parse::<Table>().expect("TOML"));
    check_part(definition, &data)
        .map_or_else(|errors| errors.iter().map(ToString::to_string).collect(), |()| vec![])
}

#[test]
fn a_part_of_the_schemas_form_is_accepted() {
    assert!(wrong("Section", "kind = 'tube'\nouter = 2\ninner = 1").is_empty());
    assert!(
        wrong("Place", "body = 'nobody knows'\nat = 'end'").is_empty(),
        "names are checked with the whole"
    );
    assert!(wrong("Material", "density = 7850\nyoung = 2e11\ndamping = { strain = 1e-4 }").is_empty());
}

#[test]
fn all_that_is_wrong_with_a_part_is_said() {
    assert_eq!(
        wrong("Body", "kind = 'mass'\nname = ''\ncentre = [0, 0]\nmass = -1"),
        [
            "centre: found unknown key `centre`, wanted `center`, `kind`, `mass`, `motion` or `name` (did you mean \
             `center`?)",
            "centre: found an array of 2, wanted an array of 3 numbers",
            "mass: found -1, wanted a number > 0",
            "name: found \"\", wanted a text that is not empty",
        ]
    );
    assert_eq!(
        wrong("Section", "kind = 'circel'\ndiameter = 1"),
        [
            "kind: found \"circel\", wanted \"circle\", \"tube\", \"rectangle\", \"ellipse\" or \"general\" (did you \
          mean \"circle\"?)"
        ]
    );
    assert_eq!(
        wrong("Probe", "name = 'tip'"),
        ["on: found no key `on`, wanted a table with `body` and `at` (The place on the axis)"]
    );
}

#[test]
fn the_whole_is_a_part_of_itself() {
    let text = "bodies = [{ kind = 'mass', name = 'm', mass = 1, center = [0, 0, 0] }]\nanalysis = { kind = 'modes' }";
    assert!(wrong("Model", text).is_empty());
    assert_eq!(wrong("Model", &text.replace("modes", "mods")).len(), 1);
}

#[test]
fn words_and_numbers_are_parts_too() {
    assert!(check_part("Formulation", &"linked".into()).is_ok());
    assert!(check_part("TimeFunction", &2.0.into()).is_ok());
    assert!(check_part("TimeFunction", &"2".into()).is_err());
}

#[test]
fn a_definition_that_is_not_in_the_schema_is_refused() {
    let errors = check_part("Sektion", &1.into()).expect_err("no such definition");
    assert!(errors.to_string().ends_with("(did you mean \"Section\"?)"), "{errors}");
}
