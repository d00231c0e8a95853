//! Stresses of beams with a curved axis.

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
