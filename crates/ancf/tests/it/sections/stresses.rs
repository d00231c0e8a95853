//! Stresses of beams, also with a curved axis.

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

/// Clamped arc of a radius of 0.625 and a height of 0.03 under a force at its end. The stresses at both edges of the clamp are
/// N/A ± M y/I, with an error of H/(6R) of curved beams (Timoshenko, Strength of Materials II, art. 16), and that of the mesh.
///
/// The axial strain at the ends of quadratic elements, without the points of their quadrature, differed by a factor of 2.2.
#[test]
fn stresses_of_arcs_are_those_of_the_section_forces() {
    let (width, height) = (0.01_f64, 0.03_f64);
    for (formulation, elements, tolerance) in
        [("quadratic", 4, 0.05), ("quadratic", 8, 0.03), ("quadratic", 32, 0.03), ("linked", 8, 0.05)]
    {
        let run = Run::of(&parse(&format!(
            r#"
materials.m = {{ density = 1000, young = 7e9, poisson = 0 }}
sections.s = {{ kind = "rectangle", height = {height}, width = {width} }}
bodies = [{{ kind = "beam", name = "b", from = [0, 0, 0], to = [1, 0, 0], elements = {elements}, section = "s", material = "m", formulation = "{formulation}", up = [0, 1, 0], shape = {{ kind = "arc", through = [0.5, 0.25, 0] }} }}]
joints = [{{ kind = "clamp", name = "c", a = {{ body = "b", at = "start" }} }}]
loads = [{{ kind = "force", on = {{ body = "b", at = "end" }}, force = [0, 10, 0] }}]
analysis = {{ kind = "statics" }}

[[probes]]
name = "outer"
on = {{ body = "b", at = "start" }}
record = ["section_forces", "stress"]
offset = [0.015, 0]

[[probes]]
name = "inner"
on = {{ body = "b", at = "start" }}
record = ["stress"]
offset = [-0.015, 0]
"#
        )));
        let (normal, moment) = (run.last("outer.N"), run.last("outer.Mz"));
        let bending = moment * 6.0 / (width * height.powi(2));
        for (name, sign) in [("outer.sxx", -1.0), ("inner.sxx", 1.0)] {
            let expected = normal / (width * height) + sign * bending;
            let error = run.last(name) / expected - 1.0;
            assert!(error.abs() < tolerance, "{formulation}, {elements}, {name}: {error}");
        }
    }
}

/// Cantilever under a force at its end: between the nodes too, the shear stress on the axis is Q/(kA), and the stresses at both edges are
/// N/A ± M y/I.
///
/// Between the nodes of linked elements the difference of slope and director also contains the rotation of the section: the shear
/// stress differed by a factor of 20 with 4 elements.
#[test]
fn stresses_between_nodes_are_those_of_the_section_forces() {
    let (width, height) = (0.01_f64, 0.03_f64);
    for (formulation, force) in [("linked", 10.0), ("linked", 200.0), ("quadratic", 10.0)] {
        let mut text = format!(
            r#"
materials.m = {{ density = 1000, young = 7e9, poisson = 0.3 }}
sections.s = {{ kind = "rectangle", height = {height}, width = {width} }}
bodies = [{{ kind = "beam", name = "b", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = "s", material = "m", formulation = "{formulation}", up = [0, 1, 0] }}]
joints = [{{ kind = "clamp", name = "c", a = {{ body = "b", at = "start" }} }}]
loads = [{{ kind = "force", on = {{ body = "b", at = "end" }}, force = [0, {force}, 0] }}]
analysis = {{ kind = "statics" }}
"#
        );
        let places = [0.0, 0.05, 0.125, 0.3, 0.5, 0.6];
        for (k, at) in places.iter().enumerate() {
            for (name, y) in [("outer", 0.015), ("axis", 0.0), ("inner", -0.015)] {
                text += &format!(
                    "[[probes]]\nname = \"{name}{k}\"\non = {{ body = \"b\", at = {at} }}\noffset = [{y}, 0]\nrecord = [\"section_forces\", \"stress\"]\n"
                );
            }
        }
        let run = Run::of(&parse(&text));
        let area = width * height;
        for k in 0..places.len() {
            let [normal, shear, moment] = ["N", "Qy", "Mz"].map(|part| run.last(&format!("axis{k}.{part}")));
            let bending = moment * 6.0 / (width * height.powi(2));
            let expected = [
                (format!("axis{k}.sxy"), shear / (0.85 * area), 0.05),
                (format!("outer{k}.sxx"), normal / area - bending, 0.015),
                (format!("inner{k}.sxx"), normal / area + bending, 0.015),
            ];
            for (column, expected, tolerance) in expected {
                let error = run.last(&column) / expected - 1.0;
                assert!(error.abs() < tolerance, "{formulation}, {force}, {column}: {error}");
            }
        }
    }
}

/// Torsion of a rectangle of 2 : 1: the largest shear stress is in the middle of the long sides, T/(0.24588 a b²), and that of the short
/// sides is 0.7950 of it (St. Venant's series, Timoshenko & Goodier 1970, section 109).
#[test]
fn torsional_stresses_of_a_rectangle_contain_its_warping() {
    let (height, width, torque) = (0.04_f64, 0.02_f64, 2.0);
    let largest = torque / (0.24588 * height * width.powi(2));
    for formulation in ["linked", "quadratic", "enhanced"] {
        let run = Run::of(&parse(&format!(
            r#"
materials.m = {{ density = 1000, young = 7e10, poisson = 0.3 }}
sections.s = {{ kind = "rectangle", height = {height}, width = {width} }}
bodies = [{{ kind = "beam", name = "b", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = "s", material = "m", formulation = "{formulation}", up = [0, 1, 0] }}]
joints = [{{ kind = "clamp", name = "c", a = {{ body = "b", at = "start" }} }}]
loads = [{{ kind = "moment", on = {{ body = "b", at = "end" }}, moment = [{torque}, 0, 0] }}]
probes = [
  {{ name = "long", on = {{ body = "b", at = 0.3 }}, offset = [0, {0}], record = ["stress"] }},
  {{ name = "short", on = {{ body = "b", at = 0.3 }}, offset = [{1}, 0], record = ["stress"] }},
  {{ name = "corner", on = {{ body = "b", at = 0.3 }}, offset = [{1}, {0}], record = ["stress"] }},
]
analysis = {{ kind = "statics" }}
"#,
            0.5 * width,
            0.5 * height
        )));
        for (column, expected) in [("long.sxy", -largest), ("short.sxz", 0.7950 * largest)] {
            assert_relative(formulation, run.last(column), expected, 2e-3);
        }
        for column in ["long.sxz", "short.sxy", "corner.sxy", "corner.sxz"] {
            assert!(run.last(column).abs() < 0.01 * largest, "{formulation}: {column}");
        }
    }
}
