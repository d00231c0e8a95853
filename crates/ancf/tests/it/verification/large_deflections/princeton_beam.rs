//! Princeton beam experiment (Dowell & Traybar 1975): strip bent about both axes and twisted.
//!
//! ```text
//!   |/|=====================  L = 0.508 m, 12.377 × 3.2024 mm, E = 71.7 GPa
//!   |/|                    \\  P at an angle from the stiff direction
//! ```
//!
//! Source of the limits: Reissner's rod with k = 1, ν = 0 and the polar moment of area in torsion, to which this element
//! converges. The strip itself is five times softer in torsion. Source of the meshes: independent implementation.

use ancf::Model;
use ancf::model::{Load, Section};

use crate::common::assertions::assert_near;
use crate::common::models::rod;
use crate::common::solutions::equilibrium;

fn strip(elements: u32, load: f64, degrees: f64) -> Model {
    let mut model = rod::cantilever(elements);
    rod::beam(&mut model).to = [0.508, 0.0, 0.0];
    rod::material(&mut model).young = 71.7e9;
    model.sections.insert("circle".into(), Section::rectangle(12.377e-3, 3.2024e-3));
    model.gravity = [0.0; 3];
    let (sin, cos) = degrees.to_radians().sin_cos();
    model.loads = vec![Load::force(rod::end(), [0.0, -load * cos, load * sin])];
    model
}

/// Displacements along the axis, the stiff and the soft direction.
#[test]
fn princeton_tips_equal_independent_meshes() {
    for (load, degrees, elements, reference) in [
        // Limit (−.0140523899, −.0076267295, .1079407501).
        (8.896, 45.0, 8, [-0.0124296889, -0.0075515011, 0.1009845921]),
        (8.896, 45.0, 16, [-0.0139219776, -0.0076160504, 0.1073866369]),
        (8.896, 45.0, 32, [-0.0140410492, -0.0076245953, 0.1078898625]),
        // Limit (−.0037222610, −.0037961771, .0558921198).
        (4.448, 45.0, 32, [-0.0037204054, -0.0037952140, 0.0558749413]),
        // Limit (−.0158577397, −.0140146701, .1139637134).
        (13.345, 30.0, 32, [-0.0158441479, -0.0140106866, 0.1139066066]),
    ] {
        let (assembly, state) = equilibrium(&strip(elements, load, degrees), 5);
        let moved = assembly.probes[0].1.displacement(&state);
        for (axis, reference) in reference.into_iter().enumerate() {
            let name = format!("{load} N at {degrees} degrees, {elements} elements, axis {axis}");
            assert_near(&name, moved[axis], reference, 1e-9);
        }
    }
}
