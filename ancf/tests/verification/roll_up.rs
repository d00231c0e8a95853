//! A cantilever rolled up by a moment at its end.
//!
//! ```text
//!   |/|==========)  M        φ = ML/EI; inextensible: θ = φ, a circle of radius EI/M
//! ```
//!
//! Source: the continuum of St. Venant and Kirchhoff with ν = 0 in pure bending, whose section forces have closed forms: the
//! limits, with ∫σ y dA = M at the true thickness; the angles of meshes by an independent implementation of the element.

use std::f64::consts::PI;

use ancf::Model;
use ancf::model::{Load, Section};

use crate::equilibrium::equilibrium;
use crate::{assert_near, rod};

/// The rod without weight under M = φ EI/L about z at its end.
fn rolled(elements: u32, section: Section, phi: f64) -> Model {
    let mut model = rod::cantilever(elements);
    model.gravity = [0.0; 3];
    model.sections.insert("circle".into(), section);
    let moment = phi * model.materials["steel"].young * section.moments().yy / rod::LENGTH;
    model.loads = vec![Load::moment(rod::end(), [0.0, 0.0, moment])];
    model
}

/// Angle and place of the tip.
fn tip(model: &Model, steps: u32) -> [f64; 3] {
    let (assembly, state) = equilibrium(model, steps);
    let [normal, ..] = assembly.mesh("rod").unwrap().section_frame(&state, rod::LENGTH);
    let place = assembly.probes[0].1.value(&state);
    let angle = normal.y.atan2(normal.x);
    [if angle < -0.5 { angle + 2.0 * PI } else { angle }, place.x, place.y]
}

const SQUARE: Section = Section::Rectangle { height: 0.05, width: 0.05 };

#[test]
fn square_by_mesh() {
    for (elements, angle) in [(8, 3.0311), (16, 3.1612), (32, 3.17550)] {
        let [theta, ..] = tip(&rolled(elements, SQUARE, PI), 10);
        println!("{elements} {theta:.9}");
        assert_near("angle", theta, angle, 5e-5);
    }
}
