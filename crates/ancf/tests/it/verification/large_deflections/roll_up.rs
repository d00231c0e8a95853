//! Cantilever rolled up by a moment at its end.
//!
//! ```text
//!   |/|==========)  M        φ = ML/EI; inextensible: θ = φ, a circle of radius EI/M
//! ```
//!
//! Source: St. Venant-Kirchhoff continuum with ν = 0 in pure bending, with constant strains along the axis. Stretch,
//! thickness and curvature of least energy are solved to ten digits. Source of the angles of meshes: independent
//! implementation of the element.

use std::f64::consts::PI;

use ancf::Model;
use ancf::model::{ClampedGradients, Formulation, Load, Section};

use crate::common::assertions::assert_near;
use crate::common::models::rod;
use crate::common::solutions::equilibrium;

/// Rod without gravity under the end moment M = φ EI about z, per unit length.
fn rolled(elements: u32, section: Section, phi: f64, fix: ClampedGradients) -> Model {
    let mut model = rod::clamped(elements, fix);
    model.gravity = [0.0; 3];
    model.sections.insert("circle".into(), section.clone());
    let moment = phi * model.materials["steel"].young * section.moments().yy;
    model.loads = vec![Load::moment(rod::end(), [0.0, 0.0, moment])];
    model
}

const SQUARE: Section = Section::rectangle(0.05, 0.05);
const CIRCLE: Section = Section::circle(0.02);

#[test]
fn end_angles_equal_independent_meshes() {
    for (elements, angle) in [(8, 3.0311), (16, 3.1612), (32, 3.17550)] {
        let (assembly, state) = equilibrium(&rolled(elements, SQUARE, PI, ClampedGradients::All), 10);
        let [normal, ..] = assembly.mesh("rod").unwrap().section_frame(&state, rod::LENGTH);
        let theta = normal.y.atan2(normal.x).rem_euclid(2.0 * PI);
        assert_near("angle", theta, angle, 5e-5);
    }
}

/// Angle and position of the end relative to the section at half the length.
///
/// The clamp at the start suppresses the change of thickness there and reduces the angle of the square by 1.4e-4.
fn far_from_the_clamp(elements: u32, section: Section, phi: f64, formulation: Formulation) -> [f64; 3] {
    let mut model = rolled(2 * elements, section, phi, ClampedGradients::Section);
    let beam = rod::beam(&mut model);
    (beam.formulation, beam.to) = (formulation, [2.0, 0.0, 0.0]);
    let (assembly, state) = equilibrium(&model, 40);
    let mesh = assembly.mesh("rod").unwrap();
    let [[x, y, _], [normal, ..]] = [1.0, 2.0].map(|s| mesh.section_frame(&state, s));
    let place = mesh.point(2.0).value(&state) - mesh.point(1.0).value(&state);
    [normal.dot(&y).atan2(normal.dot(&x)).rem_euclid(2.0 * PI), place.dot(&x), place.dot(&y)]
}

/// Angle θ and position x, y of the continuum.
const LIMITS: [(Section, f64, [f64; 3]); 4] = [
    (SQUARE, PI, [3.1787640322, -0.0116541451, 0.6269771869]),
    (CIRCLE, 0.5 * PI, [1.57132966449, 0.636344681286, 0.636684158429]),
    (CIRCLE, PI, [3.14586941168, -0.00135897515, 0.635515524864]),
    (CIRCLE, 2.0 * PI, [6.31772618396 - 2.0 * PI, 0.0054580371, 9.4272e-5]),
];

/// Errors are of fourth order; two meshes are extrapolated.
#[test]
fn roll_up_converges_at_order_four() {
    for (section, phi, limit) in LIMITS {
        let [coarse, fine] =
            [32, 64].map(|n| far_from_the_clamp(n, section.clone(), phi, Formulation::Quadratic));
        for i in 0..3 {
            assert_near("limit", fine[i] + (fine[i] - coarse[i]) / 15.0, limit[i], 2e-8);
        }
    }
}

/// Element of Kim et al. (2017), with errors of second order.
#[test]
fn roll_up_of_two_node_elements_converges_at_order_two() {
    for (section, phi, limit) in LIMITS {
        let errors = [32, 64].map(|n| {
            let found = far_from_the_clamp(n, section.clone(), phi, Formulation::Continuum);
            (0..3).map(|i| (found[i] - limit[i]).abs()).fold(0.0, f64::max)
        });
        assert!(errors[1] < 8e-3 && errors[1] < 0.27 * errors[0], "{section:?} {phi}: {errors:?}");
    }
}

/// A follower moment about the bending axis equals a moment of fixed direction.
#[test]
fn follower_moment_equals_fixed_moment_in_the_plane() {
    let model = rolled(8, SQUARE, PI, ClampedGradients::All);
    let mut other = model.clone();
    let Load::Moment(moment) = &mut other.loads[0] else { panic!("a moment") };
    moment.follower = true;
    let [a, b] = [model, other].map(|model| equilibrium(&model, 10).1);
    let error = a.q.iter().zip(&b.q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(error < 1e-9, "{error:e}");
}
