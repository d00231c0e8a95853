//! Critical loads of columns and strips.
//!
//! ```text
//!   |/|=========================== <- P        |/|=========================   strip, lateral
//!                                                                         | P
//! ```
//!
//! Source: Euler (1744) and, for the meshes, an independent implementation of the element on the nonlinear path; lateral
//! buckling by Reissner's rod with k = 1 and the polar moment of area, bent in its plane by shooting, perturbed out of it.

use ancf::Model;
use ancf::analysis::{Critical, EigenError, Newton, Sense, Stop, buckling};
use ancf::model::{Assembly, Joint, Load, Section};
use ancf::system::{State, Weights};

use crate::{assert_near, rod};

/// π²EI/4L².
const EULER: f64 = 3740.132124561166;

/// A force of one at the end of the rod, nothing else.
fn loaded(mut model: Model, force: [f64; 3]) -> Assembly {
    model.gravity = [0.0; 3];
    model.loads = vec![Load::Force { on: rod::end(), force }];
    model.assemble().unwrap()
}

/// The equilibrium under so many times the loads, reached in equal steps.
fn under(assembly: &Assembly, load: f64, steps: u32) -> State {
    let mut state = State { load: 0.0, ..assembly.rest() };
    let mut newton = Newton::new(assembly.system.matrix(), Stop::Energy(1e-10), 50).unwrap();
    for step in 1..=steps {
        state.load = load * f64::from(step) / f64::from(steps);
        newton.solve(&assembly.system, &mut state, Weights::STIFFNESS).unwrap();
    }
    state
}

fn critical(assembly: &Assembly, s: &State, sense: Sense) -> Result<Vec<Critical>, EigenError> {
    buckling(&assembly.system, assembly.system.matrix(), s, 2, sense)
}

fn first(assembly: &Assembly, s: &State) -> f64 {
    critical(assembly, s, Sense::Stated).unwrap()[0].factor
}

/// About the straight rod, and again about the rod under nearly all of that load, which gives the critical point of the
/// nonlinear path.
#[test]
fn column() {
    for (elements, ratio) in
        [(1, 1.21551828), (2, 1.05213113), (4, 1.01267301), (8, 1.00297393), (16, 1.00055908)]
    {
        let assembly = loaded(rod::cantilever(elements), [-1.0, 0.0, 0.0]);
        let linear = first(&assembly, &under(&assembly, 0.0, 1));
        // The strain P/EA at buckling, 6e-5, is what the linear path neglects.
        assert_near(&format!("{elements} elements, linear"), linear / EULER, ratio, 1e-4);
        let near = under(&assembly, 0.999 * linear, 1);
        let factor = near.load + first(&assembly, &near);
        assert_near(&format!("{elements} elements"), factor / EULER, ratio, 1e-8);
    }
}

/// Either plane, either sense, any size of the reference load; a rod that is pulled does not buckle.
#[test]
fn senses() {
    let column = loaded(rod::cantilever(4), [-1.0, 0.0, 0.0]);
    let rest = under(&column, 0.0, 1);
    let factors = |assembly: &Assembly, sense| -> Vec<f64> {
        critical(assembly, &rest, sense).unwrap().iter().map(|critical| critical.factor).collect()
    };
    let stated = factors(&column, Sense::Stated);
    assert_near("planes", stated[1] / stated[0], 1.0, 1e-9);
    for (force, sense, sign) in
        [(1e9, Sense::Reversed, -1.0), (1e9, Sense::Either, -1.0), (-1e-9, Sense::Stated, 1.0)]
    {
        let other = loaded(rod::cantilever(4), [force, 0.0, 0.0]);
        let factor = factors(&other, sense)[0];
        assert_near("reversed", factor * force / (-sign * sign * stated[0]), 1.0, 1e-8);
    }
    assert!(factors(&loaded(rod::cantilever(4), [1.0, 0.0, 0.0]), Sense::Stated).is_empty());
}

/// A load on the clamp moves nothing and buckles nothing.
#[test]
fn load_on_the_ground() {
    let mut model = rod::cantilever(4);
    model.gravity = [0.0; 3];
    model.loads = vec![Load::Force { on: rod::start(), force: [-1.0, 2.0, 3.0] }];
    let assembly = model.assemble().unwrap();
    assert_eq!(critical(&assembly, &under(&assembly, 0.0, 1), Sense::Either), Ok(Vec::new()));
}

/// What stands on a hinge or is beyond its critical load has no stiffness to begin with.
#[test]
fn nothing_to_lose() {
    let hinged = loaded(rod::revolute(4), [-1.0, 0.0, 0.0]);
    let rest = State { load: 0.0, ..hinged.rest() };
    assert_eq!(critical(&hinged, &rest, Sense::Stated), Err(EigenError::Singular));
    let column = loaded(rod::cantilever(4), [-1.0, 0.0, 0.0]);
    let beyond = under(&column, 1.1 * EULER, 1);
    assert_eq!(critical(&column, &beyond, Sense::Stated), Err(EigenError::Indefinite));
}

/// A strip on edge, 50 × 5 mm: 1818.744681 N for ν = 0 and the polar moment of area (the same shooting gives 1325.886533 N
/// with the shear modulus of ν = 0.31), approached from 1790 N.
#[test]
fn strip() {
    for (elements, tolerance) in [(16, 7e-3), (32, 1.4e-3), (64, 3e-4)] {
        let mut model = rod::cantilever(elements);
        rod::material(&mut model).young = 71.7e9;
        model.sections.insert("circle".into(), Section::Rectangle { height: 0.05, width: 0.005 });
        let assembly = loaded(model, [0.0, -1.0, 0.0]);
        // Bent before it buckles, the strip allows short steps only, until the critical load is near.
        let (mut load, mut factor) = (1790.0, f64::INFINITY);
        while factor > 0.1 {
            factor = first(&assembly, &under(&assembly, load, 10));
            load += if factor > 1.0 { 0.9 * factor } else { factor };
        }
        assert_near(&format!("{elements} elements"), load / 1818.744681, 1.0, tolerance);
    }
}

/// Clamped in the middle, the outer half is a column of its own.
#[test]
fn clamped_in_the_middle() {
    let mut model = rod::cantilever(16);
    let Joint::Clamp { a, .. } = &mut model.joints[0] else { panic!("a clamp") };
    a.at = ancf::model::At::Length(0.5 * rod::LENGTH);
    let assembly = loaded(model, [-1.0, 0.0, 0.0]);
    let mut half = rod::cantilever(8);
    rod::beam(&mut half).to[0] = 0.5 * rod::LENGTH;
    let half = loaded(half, [-1.0, 0.0, 0.0]);
    let [factor, short] = [&assembly, &half].map(|assembly| first(assembly, &under(assembly, 0.0, 1)));
    assert_near("half the length", factor / short, 1.0, 1e-8);
}
