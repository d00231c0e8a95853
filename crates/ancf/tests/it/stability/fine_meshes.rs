//! Natural frequencies and critical loads of meshes with thousands of elements, against closed forms. The stiffness matrix of a
//! bending element grows with the third power of the number of elements, and its rounding error likewise.

use std::f64::consts::PI;

use ancf::Model;
use ancf::nalgebra::Vector3;

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::random::Random;
use crate::common::solutions::Run;

const YOUNG: f64 = 7e10;
const DENSITY: f64 = 2700.0;
const DIAMETER: f64 = 3e-3;
const LENGTH: f64 = 2.5;

/// Wire along x with joints, loads and an analysis.
fn wire(elements: u32, rest: &str) -> Model {
    parse(&format!(
        "{rest}
        materials.aluminium = {{ density = {DENSITY}, young = {YOUNG:e} }}
        sections.wire = {{ kind = \"circle\", diameter = {DIAMETER} }}
        [[bodies]]
        kind = \"cable\"
        name = \"line\"
        from = [0, 0, 0]
        to = [{LENGTH}, 0, 0]
        elements = {elements}
        section = \"wire\"
        material = \"aluminium\""
    ))
}

/// Natural frequency β² √(EI/ρA)/(2π L²), √(I/A) = d/4.
fn bending_frequency(beta: f64) -> f64 {
    (beta / LENGTH).powi(2) * (YOUNG / DENSITY).sqrt() * DIAMETER / 4.0 / (2.0 * PI)
}

fn modes(count: u32) -> String {
    format!("analysis = {{ kind = \"modes\", count = {count} }}\n")
}

const CLAMP: &str =
    "joints = [{ kind = \"clamp\", name = \"hook\", a = { body = \"line\", at = \"start\" } }]\n";

/// Pairs of equal frequencies in two planes, after a number of rigid modes.
fn assert_pairs(name: &str, model: &Model, rigid: usize, betas: &[f64]) {
    let run = Run::of(model);
    let frequencies = run.column("frequency");
    assert!(frequencies[..rigid].iter().all(|&frequency| frequency == 0.0), "{name}: {frequencies:?}");
    for (pair, &beta) in frequencies[rigid..].chunks(2).zip(betas) {
        for &frequency in pair {
            assert_relative(name, frequency, bending_frequency(beta), 2e-7);
        }
    }
    assert!(run.column("residual").iter().all(|&residual| residual < 1e-5), "{name}");
    let counted = run.summary.eigenvalues.expect("the eigenvalues are counted");
    assert_eq!(counted.count, frequencies.len() - 2, "{name}: {counted:?}");
}

#[test]
fn clamped_wires_have_their_frequencies() {
    for elements in [1700, 5000] {
        let model = wire(elements, &format!("{CLAMP}{}", modes(4)));
        assert_pairs(&format!("{elements} elements"), &model, 0, &[1.875_104_069, 4.694_091_133]);
    }
}

/// A cable has no rotation about its axis: five rigid motions.
#[test]
fn free_wires_have_their_frequencies() {
    let model = wire(2500, &modes(9));
    assert_pairs("free", &model, 5, &[4.730_040_745, 7.853_204_624]);
}

#[test]
fn hinged_wires_have_their_frequencies() {
    let hinges = "joints = [
        { kind = \"spherical\", name = \"a\", a = { body = \"line\", at = \"start\" } },
        { kind = \"spherical\", name = \"b\", a = { body = \"line\", at = \"end\" } }]\n";
    let model = wire(3000, &format!("{hinges}{}", modes(4)));
    assert_pairs("hinged", &model, 0, &[PI, 2.0 * PI]);
}

/// Euler's loads (2k − 1)² π² EI/4L², each in two planes, up to P/EA.
#[test]
fn fine_columns_have_their_critical_loads() {
    let analysis =
        "loads = [{ kind = \"force\", on = { body = \"line\", at = \"end\" }, force = [-1, 0, 0] }]
        analysis = { kind = \"buckling\", count = 4 }\n";
    let run = Run::of(&wire(2000, &format!("{CLAMP}{analysis}")));
    let euler = PI.powi(3) * YOUNG * DIAMETER.powi(4) / (64.0 * 4.0 * LENGTH.powi(2));
    for (factor, half_waves) in run.column("factor").iter().zip([1.0, 1.0, 3.0, 3.0_f64]) {
        assert_relative("critical load", *factor, half_waves.powi(2) * euler, 1e-4);
    }
    assert!(run.column("residual").iter().all(|&residual| residual < 1e-5));
    assert_eq!(run.summary.eigenvalues.expect("the loads are counted").count, 2);
}

/// A beam without supports has exactly six rigid modes.
#[test]
fn free_beams_have_six_rigid_modes() {
    for formulation in ["enhanced", "linked", "quadratic"] {
        let text = format!(
            "materials.steel = {{ density = 7850, young = 2.1e11, poisson = 0.3 }}
            sections.bar = {{ kind = \"circle\", diameter = 0.02 }}
            bodies = [{{ kind = \"beam\", name = \"bar\", from = [0.1, 0.2, -0.3], to = [0.7, 1, 0.4], elements = 120,
                section = \"bar\", material = \"steel\", formulation = \"{formulation}\" }}]
            analysis = {{ kind = \"modes\", count = 8 }}"
        );
        let run = Run::of(&parse(&text));
        let zeros = run.column("frequency").iter().filter(|&&frequency| frequency == 0.0).count();
        assert_eq!(zeros, 6, "{formulation}: {:?}", run.column("frequency"));
    }
}

/// Free beams of one and two elements in random directions: six modes are rigid for any number of requested modes, and the others
/// do not depend on the direction or on the number.
#[test]
fn modes_of_free_beams_do_not_depend_on_direction_and_number() {
    let mut random = Random(7);
    let mut direction = || {
        let d = Vector3::from_fn(|_, _| random.number());
        d.normalize()
    };
    for (formulation, elements) in
        [("linked", 1), ("linked", 2), ("quadratic", 1), ("enhanced", 1), ("continuum", 1)]
    {
        let mut first: Option<Vec<f64>> = None;
        for count in (1..=10).cycle().take(30) {
            let [along, up] = [direction(), direction()];
            let to = along * 0.98;
            let run = Run::of(&parse(&format!(
                "materials.m = {{ density = 5823, young = 1.9e8, poisson = 0.3 }}
                sections.s = {{ kind = \"rectangle\", height = 0.08, width = 0.07 }}
                bodies = [{{ kind = \"beam\", name = \"b\", from = [0, 0, 0], to = {to:?}, up = {up:?}, elements = {elements}, \
                formulation = \"{formulation}\", section = \"s\", material = \"m\" }}]
                analysis = {{ kind = \"modes\", count = {count} }}\n",
                to = to.as_slice(),
                up = up.as_slice()
            )));
            assert!(run.summary.outcome.is_finished(), "{formulation} {count}: {:?}", run.summary.outcome);
            let frequencies = run.column("frequency");
            let (rigid, others) = frequencies.split_at(frequencies.len().min(6));
            assert!(frequencies.len() == count && rigid.iter().all(|x| *x == 0.0), "{frequencies:?}");
            let first = first.get_or_insert_with(Vec::new);
            others.iter().zip(&*first).for_each(|(a, b)| assert_relative("frequency", *a, *b, 1e-9));
            if others.len() > first.len() {
                *first = others.to_vec();
            }
        }
    }
}
