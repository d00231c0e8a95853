//! Fields of shells without a meaning.

use ancf::Model;

use super::shell_fields::{CLAMP, Kind, MATERIAL, Sheet};

/// Text of a model whose shell has the given keys.
fn with(kind: Kind, keys: &str) -> String {
    let sheet = Sheet::unit(kind, [2, 2]);
    let thickness = if keys.contains("thickness") { "" } else { "thickness = 0.01\n" };
    format!(
        "analysis = {{ kind = \"statics\" }}\n{MATERIAL}{}{CLAMP}",
        sheet.body(&format!("{thickness}{keys}"))
    )
}

fn formula(text: &str) -> String {
    format!("thickness = {{ kind = \"expression\", text = \"{text}\" }}")
}

/// Asserts that keys of the shell, and of a contact after them, are rejected by a message with the given parts.
fn assert_rejected(kind: Kind, keys: &str, parts: [&str; 2]) {
    let text = match keys.split_once("\n[[contacts]]") {
        Some((own, contact)) => with(kind, own) + "[[contacts]]" + contact,
        None => with(kind, keys),
    };
    let error = Model::parse(&text).unwrap_err().to_string();
    assert!(parts.iter().all(|part| error.contains(part)), "{keys}: {error}");
}

/// A thickness without a meaning is rejected with its place.
#[test]
fn wrong_thicknesses_are_rejected() {
    for (kind, keys, parts) in [
        (
            Kind::Thin,
            formula("0.1*(0.5 - u)"),
            ["bodies[0].thickness", "found 0 at [u, v] = [0.5, 0], element 1, 1"],
        ),
        (Kind::Quads, formula("0.1*(0.5 - x)"), ["bodies[0].thickness", "found 0 at (0.5, 0, 0), element 0"]),
        (Kind::Thin, formula("1/(u - 1)^2"), ["bodies[0].thickness", "inf"]),
        (Kind::Quads, formula("0.1*u"), ["bodies[0].thickness.text", "`x`, `y`, `z`"]),
        (Kind::Thin, formula("0.1*(x"), ["bodies[0].thickness.text", "character"]),
        (Kind::Thin, formula("t"), ["bodies[0].thickness.text", "`u`, `v`"]),
        (
            Kind::Thin,
            "thickness = { kind = \"nodes\", values = [1, 1, 1] }".into(),
            ["bodies[0].thickness", "nodes"],
        ),
        (
            Kind::Quads,
            "thickness = { kind = \"nodes\", values = [1, 1, 1] }".into(),
            ["bodies[0].thickness.values", "9, one for each node"],
        ),
        (
            Kind::Quads,
            "thickness = { kind = \"nodes\", values = [1, 1, 1, 1, 1, 1, -1, 1, 1] }".into(),
            ["bodies[0].thickness", "element 2, expected a positive number"],
        ),
        (Kind::Thin, "thickness = -1".into(), ["bodies[0].thickness", "-1"]),
    ] {
        assert_rejected(kind, &keys, parts);
    }
}

/// Directions without a meaning are rejected with their place.
#[test]
fn wrong_directions_are_rejected() {
    for (kind, keys, parts) in [
        (
            Kind::Thin,
            "fibre_angle = { kind = \"expression\", text = \"ln(x - 2)\" }",
            ["bodies[0].fibre_angle", "NaN"],
        ),
        (
            Kind::Quads,
            "fibre_axis = { kind = \"expression\", text = [\"0\", \"0\", \"1\"] }",
            ["bodies[0].fibre_axis", "normal"],
        ),
        (
            Kind::Thin,
            "fibre_axis = { kind = \"expression\", text = [\"x\", \"y\", \"0\"] }",
            ["bodies[0].fibre_axis", "[u, v] = [0, 0]"],
        ),
        (
            Kind::Thin,
            "fibre_axis = { kind = \"expression\", text = [\"x\", \"q\", \"0\"] }",
            ["bodies[0].fibre_axis.text[1]", "character 1"],
        ),
    ] {
        assert_rejected(kind, keys, parts);
    }
}
