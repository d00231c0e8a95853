//! Checks of the thickness and the fibres of shells that vary.

use crate::errors::{Finding, finding, formula_error, number};
use crate::model::{FieldDefect, FieldShell, ShearShell, Shell, ShellThickness, ThicknessField};

/// Largest number of elements of a shell whose section varies: each point is checked.
const LARGEST: usize = 1_000_000;

/// Checks the fields of a thin shell. `is_valid` states that the surface is.
pub(super) fn of_patch(path: &str, shell: &Shell, is_valid: bool) -> Option<Finding> {
    if let ShellThickness::Varying(ThicknessField::Nodes { .. }) = shell.thickness {
        let expected =
            "a number or \"expression\": only meshes of shear-deformable shells have values at nodes";
        return Some(finding(format!("{path}.thickness.kind"), "\"nodes\" for a thin shell", expected));
    }
    let elements = shell.elements.iter().map(|count| *count as usize).product();
    rule_of_fields(path, shell, elements, is_valid, "surface")
}

/// Checks the fields of a shear-deformable shell with a valid mesh.
pub(super) fn of_mesh(path: &str, shell: &ShearShell) -> Option<Finding> {
    if let ShellThickness::Varying(ThicknessField::Nodes { values }) = &shell.thickness {
        let (key, count) = (format!("{path}.thickness.values"), shell.mesh.nodes.len());
        if values.len() != count {
            let expected = format!("{count}, one for each node");
            let error = finding(key, format!("{} values", values.len()), expected);
            return Some(error.rests_on([format!("{path}.mesh.nodes")]));
        }
    }
    rule_of_fields(path, shell, shell.mesh.elements.len(), true, "mesh")
}

/// Checks formulas, and the values at all points of a valid surface.
fn rule_of_fields(
    path: &str,
    shell: &dyn FieldShell,
    elements: usize,
    is_valid: bool,
    surface: &str,
) -> Option<Finding> {
    if shell.is_uniform() {
        return None;
    }
    if let Err(field) = shell.fields() {
        return Some(formula_error(format!("{path}.{}", field.key), &field.text, field.error));
    }
    if elements > LARGEST {
        let expected = format!("at most {LARGEST} elements of a shell whose thickness or fibres vary");
        return Some(finding(format!("{path}.elements"), elements.to_string(), expected));
    }
    let (defect, place) = shell.field_defect().filter(|_| is_valid)?;
    let vector = |axis: [f64; 3]| {
        let [x, y, z] = axis.map(number);
        format!("({x}, {y}, {z})")
    };
    let (key, value, expected) = match defect {
        FieldDefect::Thickness(h) => ("thickness", number(h), "a positive number at all points of the shell"),
        FieldDefect::Angle(angle) => ("fibre_angle", number(angle), "a number at all points of the shell"),
        FieldDefect::Axis(axis) => ("fibre_axis", vector(axis), "a vector with a direction at all points"),
        FieldDefect::Normal(axis) => {
            let found = format!("{}, the normal of the surface,", vector(axis));
            ("fibre_axis", found, "an axis that is nowhere normal to the surface")
        }
    };
    let error = finding(format!("{path}.{key}"), format!("{value} at {place}"), expected);
    Some(error.rests_on([format!("{path}.{surface}")]))
}
