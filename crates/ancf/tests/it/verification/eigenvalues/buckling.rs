//! Buckling loads of columns and strips.
//!
//! ```text
//!   |/|=========================== <- P        |/|=========================   strip, lateral
//!                                                                         | P
//! ```
//!
//! Source: Euler (1744), with shear Engesser (1889), under own weight Greenhill (1881); lateral buckling Prandtl (1899),
//! Michell (1899), with constants from Bessel functions. On the nonlinear path: independent implementation of the element,
//! and Reissner's rod with k = 1 and the polar moment of area, bent in its plane by shooting and perturbed out of it.

use ancf::Model;
use ancf::assembly::Assembly;
use ancf::model::{
    At, Body, Cable, Clamp, ClampedGradients, Formulation, GeneralSection, Joint, Load, MaterialLaw, Section,
    Slopes,
};
use ancf::solver::eigen::{CriticalLoad, EigenError, LoadDirection, buckling};
use ancf::solver::equations::{State, Weights};
use ancf::solver::newton::{Interrupt, Newton, StopRule};

use crate::common::assertions::assert_near;
use crate::common::models::rod;

/// π²EI/4L².
const EULER: f64 = 3740.132124561166;

/// Model with a force at the end of the rod and without gravity.
fn loaded(mut model: Model, force: [f64; 3]) -> Assembly {
    model.gravity = [0.0; 3];
    model.loads = vec![Load::force(rod::end(), force)];
    model.assemble().unwrap()
}

/// Equilibrium at a load factor, by equal load steps.
fn under(assembly: &Assembly, load: f64, steps: u32) -> State {
    let mut state = State { load: 0.0, ..assembly.rest() };
    let mut newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-10), 50).unwrap();
    for step in 1..=steps {
        state.load = load * f64::from(step) / f64::from(steps);
        newton.solve(&assembly.system, &mut state, Weights::STIFFNESS).unwrap();
    }
    state
}

fn critical(assembly: &Assembly, s: &State, sense: LoadDirection) -> Result<Vec<CriticalLoad>, EigenError> {
    let found = buckling(&assembly.system, assembly.system.matrix(), s, 2, sense, &Interrupt::default())?;
    assert!(found.loads.first().is_none_or(|load| load.residual < 1e-5));
    Ok(found.loads)
}

/// Lowest critical load factor.
fn first(assembly: &Assembly, s: &State) -> f64 {
    critical(assembly, s, LoadDirection::Stated).unwrap()[0].factor
}

/// Critical load of the nonlinear path: repeated load increments by a fraction of the critical increment.
fn approach(assembly: &Assembly, mut load: f64, fraction: f64, times: u32, steps: u32) -> f64 {
    for _ in 0..times {
        load += fraction * first(assembly, &under(assembly, load, steps));
    }
    load + first(assembly, &under(assembly, load, steps))
}

/// Linear buckling, and critical point of the nonlinear path from the equilibrium near it.
#[test]
fn column_buckles_at_eulers_load() {
    for (elements, ratio) in
        [(1, 1.21551828), (2, 1.05213113), (4, 1.01267301), (8, 1.00297393), (16, 1.00055908)]
    {
        let assembly = loaded(rod::cantilever(elements), [-1.0, 0.0, 0.0]);
        let linear = first(&assembly, &under(&assembly, 0.0, 1));
        // The strain P/EA at buckling, 6e-5, is what linear buckling neglects.
        assert_near(&format!("{elements} elements, linear"), linear / EULER, ratio, 1e-4);
        let critical = approach(&assembly, 0.0, 0.999, 2, 1);
        assert_near(&format!("{elements} elements"), critical / EULER, ratio, 1e-8);
    }
}

/// Rod in another formulation with a clamped section.
fn formulated(elements: u32, formulation: Formulation) -> Model {
    let mut model = rod::clamped(elements, ClampedGradients::Section);
    rod::beam(&mut model).formulation = formulation;
    model
}

/// Shear reduces Euler's load to 1/(1/P + 1/kGA), k = 6/7 for ν = 0. The fibre stress reduces it by the factor
/// 1/(1 + P/EA), with the bending stiffness −P I/A.
#[test]
fn shear_reduces_the_load_to_engessers() {
    let assembly = loaded(formulated(16, Formulation::Linked), [-1.0, 0.0, 0.0]);
    let strain = EULER / 60632738.21428301;
    let engesser = 1.0 / (1.0 + strain * (1.0 + 2.0 * 7.0 / 6.0));
    assert_near("Engesser", first(&assembly, &under(&assembly, 0.0, 1)) / EULER, engesser, 1e-6);
}

/// Slender rod with all kinds of elements.
#[test]
fn slender_columns_of_all_elements_buckle_at_eulers_load() {
    let slender = |mut model: Model| {
        model.sections.insert("circle".into(), Section::circle(0.002));
        let assembly = loaded(model, [-1.0, 0.0, 0.0]);
        1e4 * first(&assembly, &under(&assembly, 0.0, 1)) / EULER
    };
    assert_near("linked", slender(formulated(4, Formulation::Linked)), 1.0, 2e-5);
    assert_near("three nodes", slender(formulated(4, Formulation::Quadratic)), 1.0, 2e-4);
    let continuum = slender(formulated(16, Formulation::Continuum));
    assert_near("continuum", continuum, 1.0, 1e-3);
    let mut hyperelastic = formulated(16, Formulation::Continuum);
    rod::material(&mut hyperelastic).law = MaterialLaw::NeoHookean;
    assert_near("neo-Hookean", slender(hyperelastic), continuum, 1e-6);
    let mut line = formulated(8, Formulation::Linked);
    let beam = rod::beam(&mut line).clone();
    let [name, section, material] = [beam.name, beam.section, beam.material];
    let (from, to, up, elements, slopes) = (beam.from, beam.to, beam.up, beam.elements, Slopes::Gradient);
    line.bodies = vec![Body::Cable(Cable {
        name,
        from,
        to,
        up,
        elements,
        section,
        material,
        slopes,
        motion: beam.motion,
    })];
    assert_near("cable", slender(line), 1.0, 1e-5);
}

/// qL³/EI = (9/4) j², J₋₁/₃(j) = 0, of a slender column under its own weight.
#[test]
fn own_weight_buckles_at_greenhills_load() {
    let mut model = formulated(16, Formulation::Linked);
    model.gravity = [-1.0, 0.0, 0.0];
    model.sections.insert("circle".into(), Section::circle(0.002));
    let area = model.sections["circle"].moments().area;
    let assembly = model.assemble().unwrap();
    let weight = 8030.0 * area * first(&assembly, &under(&assembly, 0.0, 1));
    assert_near("Greenhill", weight / (1515.818455357075 * 1e-4), 7.83734743894348, 7.8e-5);
}

/// Both planes, both senses, any magnitude of the reference load. A rod in tension does not buckle.
#[test]
fn sense_and_magnitude_of_the_reference_load_are_respected() {
    let column = loaded(rod::cantilever(4), [-1.0, 0.0, 0.0]);
    let rest = under(&column, 0.0, 1);
    let factors = |assembly: &Assembly, sense| -> Vec<f64> {
        critical(assembly, &rest, sense).unwrap().iter().map(|critical| critical.factor).collect()
    };
    let stated = factors(&column, LoadDirection::Stated);
    assert_near("planes", stated[1] / stated[0], 1.0, 1e-9);
    for (force, sense, sign) in [
        (1e9, LoadDirection::Reversed, -1.0),
        (1e9, LoadDirection::Either, -1.0),
        (-1e-9, LoadDirection::Stated, 1.0),
    ] {
        let other = loaded(rod::cantilever(4), [force, 0.0, 0.0]);
        let factor = factors(&other, sense)[0];
        assert_near("reversed", factor * force / (-sign * sign * stated[0]), 1.0, 1e-8);
    }
    assert!(factors(&loaded(rod::cantilever(4), [1.0, 0.0, 0.0]), LoadDirection::Stated).is_empty());
}

/// A load on the clamp causes no buckling.
#[test]
fn load_on_the_clamp_causes_no_buckling() {
    let mut model = rod::cantilever(4);
    model.gravity = [0.0; 3];
    model.loads = vec![Load::force(rod::start(), [-1.0, 2.0, 3.0])];
    let assembly = model.assemble().unwrap();
    assert_eq!(critical(&assembly, &under(&assembly, 0.0, 1), LoadDirection::Either), Ok(Vec::new()));
}

/// Hinged columns have a singular stiffness; columns above the critical load an indefinite one.
#[test]
fn unstable_initial_states_are_errors() {
    let hinged = loaded(rod::revolute(4), [-1.0, 0.0, 0.0]);
    let rest = State { load: 0.0, ..hinged.rest() };
    assert_eq!(critical(&hinged, &rest, LoadDirection::Stated), Err(EigenError::Singular));
    let column = loaded(rod::cantilever(4), [-1.0, 0.0, 0.0]);
    let beyond = under(&column, 1.1 * EULER, 1);
    assert_eq!(critical(&column, &beyond, LoadDirection::Stated), Err(EigenError::Indefinite));
}

/// Strip on edge with E = 71.7 GPa.
fn strip(elements: u32, poisson: f64, formulation: Formulation, section: Section) -> Model {
    let mut model = formulated(elements, formulation);
    (rod::material(&mut model).young, rod::material(&mut model).poisson) = (71.7e9, poisson);
    model.sections.insert("circle".into(), section);
    model
}

const STRIP: Section = Section::rectangle(0.05, 0.005);

/// Tip load PL² = 4.012599343578901 √(EI GJ) on the axis; uniform load qL³ = 12.85376332138332 √(EI GJ).
///
/// Prebuckling bending is neglected, as in linear buckling. St. Venant's J, and the polar moment with five times the load.
#[test]
fn lateral_buckling_has_prandtls_load() {
    let m = STRIP.moments();
    let polar = |j| {
        Section::General(GeneralSection {
            area: m.area,
            iy: m.zz,
            iz: m.yy,
            j,
            ky: 1.0,
            kz: 1.0,
            mass_iy: None,
            mass_iz: None,
        })
    };
    for (name, poisson, section, reference) in [
        ("St. Venant", 0.31, STRIP, 179.22025978431),
        ("St. Venant by number", 0.31, polar(Some(STRIP.torsion_constant())), 179.22025978431),
        ("polar", 0.31, polar(None), 930.36586),
    ] {
        for (formulation, elements, tolerance) in [
            (Formulation::Linked, 48, 1e-3),
            (Formulation::Linked, 96, 3e-4),
            (Formulation::Enhanced, 64, 3e-4),
        ] {
            let assembly = loaded(strip(elements, poisson, formulation, section.clone()), [0.0, -1.0, 0.0]);
            let factors = critical(&assembly, &under(&assembly, 0.0, 1), LoadDirection::Either).unwrap();
            let name = format!("{name}, {formulation:?}");
            assert_near(&name, factors[0].factor.abs() / reference, 1.0, tolerance);
            // Equal loads upwards and downwards.
            assert_near(&name, factors[1].factor / -factors[0].factor, 1.0, 1e-8);
        }
    }
    let continuum = loaded(strip(64, 0.0, Formulation::Continuum, STRIP), [0.0, -1.0, 0.0]);
    let reference = 4.012599343578901 * (71.7e9 * m.zz * 0.5 * 71.7e9 * (m.yy + m.zz)).sqrt();
    assert_near("continuum", first(&continuum, &under(&continuum, 0.0, 1)) / reference, 1.0, 3e-4);

    let mut heavy = strip(64, 0.31, Formulation::Linked, STRIP);
    heavy.gravity = [0.0, -1.0, 0.0];
    let assembly = heavy.assemble().unwrap();
    let weight = 8030.0 * m.area * first(&assembly, &under(&assembly, 0.0, 1));
    let root = (71.7e9 * m.zz * 71.7e9 / 2.62 * STRIP.torsion_constant()).sqrt();
    assert_near("uniform", weight / (12.85376332138332 * root), 1.0, 1e-3);
}

/// Strip of Bauchau's example of lateral buckling: 100 × 10 mm, E = 73 GPa, ν = 0.3.
#[test]
fn lateral_buckling_equals_bauchaus_example() {
    let section = Section::rectangle(0.1, 0.01);
    let mut model = strip(64, 0.3, Formulation::Linked, section);
    rod::material(&mut model).young = 73e9;
    let assembly = loaded(model, [0.0, -1.0, 0.0]);
    let factor = first(&assembly, &under(&assembly, 0.0, 1));
    assert_near("Bauchau", factor / 2931.1228258, 1.0, 1e-3);
}

/// Nonlinear path: 1818.744681 N for ν = 0 and the polar moment of area, approached from 1790 N.
///
/// Shooting gives 1325.886533 N with the shear modulus of ν = 0.31. The critical load is far above that of linear buckling,
/// 1064.85 N, so that the predicted increment is too large by a factor of 1.8.
#[test]
fn prebuckling_bending_raises_the_lateral_load() {
    for (elements, tolerance) in [(16, 7e-3), (32, 1.4e-3), (64, 3e-4)] {
        let mut model = strip(elements, 0.0, Formulation::Continuum, STRIP);
        model.joints = rod::cantilever(elements).joints;
        let assembly = loaded(model, [0.0, -1.0, 0.0]);
        let load = approach(&assembly, 1790.0, 0.5, 4, 10);
        assert_near(&format!("{elements} elements"), load / 1818.744681, 1.0, tolerance);
    }
}

/// The outer half of a rod clamped in the middle is a column of half the length.
#[test]
fn rod_clamped_in_the_middle_buckles_as_its_half() {
    let mut model = rod::cantilever(16);
    let Joint::Clamp(Clamp { a, .. }) = &mut model.joints[0] else { panic!("the root is a clamp") };
    a.at = At::Length(0.5 * rod::LENGTH);
    let assembly = loaded(model, [-1.0, 0.0, 0.0]);
    let mut half = rod::cantilever(8);
    rod::beam(&mut half).to[0] = 0.5 * rod::LENGTH;
    let half = loaded(half, [-1.0, 0.0, 0.0]);
    let [factor, short] = [&assembly, &half].map(|assembly| first(assembly, &under(assembly, 0.0, 1)));
    assert_near("half the length", factor / short, 1.0, 1e-8);
}
