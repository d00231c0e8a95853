//! Thick beams bent by end moments on fine meshes: the law of the element on any mesh, without waves of single elements.

use std::f64::consts::PI;

use ancf::model::Section;

use crate::common::models::parse;
use crate::common::solutions::Run;

/// Thickness of the square section and length of the beam.
const HEIGHT: f64 = 0.25;
const LENGTH: f64 = 2.0;

/// Moment M/E that bends the law of the fibres, E₁₁ = ½((λ − yk)² − 1), to an axis of curvature κ, for ν = 0 and no axial force.
///
/// k = sκ, where s is the thickness ratio. λ and s follow from vanishing derivatives of the energy
/// W = ½E∫E₁₁² dA + ½EA (½(s² − 1))². Returns M/E and κ.
fn fibre_law(k: f64) -> [f64; 2] {
    let (area, i, fourth) = (HEIGHT.powi(2), HEIGHT.powi(4) / 12.0, HEIGHT.powi(6) / 80.0);
    let axial = -1.5 * k * k * i / area;
    let slope = k * i * (axial + 1.0 + 2.0 * axial) + 0.5 * k.powi(3) * fourth;
    let s = (0.5 * (1.0 + (1.0 - 8.0 * k * slope / area).sqrt())).sqrt();
    [s * slope, k / s]
}

/// Rotation of the tip, and the number of negative eigenvalues of the tangent.
fn bent(formulation: &str, elements: u32, axis: char, moment: f64) -> [f64; 2] {
    let run = Run::of(&parse(&format!(
        r#"
materials.s = {{ density = 1000, young = 1e9 }}
sections.c = {{ kind = "rectangle", height = {HEIGHT}, width = {HEIGHT} }}
bodies = [{{ kind = "beam", name = "arm", from = [0, 0, 0], to = [{LENGTH}, 0, 0], elements = {elements}, formulation = "{formulation}", section = "c", material = "s" }}]
joints = [{{ kind = "clamp", name = "root", a = {{ body = "arm", at = "start" }}, fix = "section" }}]
loads = [{{ kind = "moment", on = {{ body = "arm", at = "end" }}, moment = {} }}]
probes = [{{ name = "tip", on = {{ body = "arm", at = "end" }}, record = ["motion", "rotation"] }}]
[analysis]
kind = "statics"
"#,
        if axis == 'z' { format!("[0, 0, {moment}]") } else { format!("[0, {moment}, 0]") },
    )));
    let last = |name: &str| *run.column(name).last().unwrap();
    let sine = last(if axis == 'z' { "tip.e3" } else { "tip.e2" });
    [2.0 * sine.atan2(last("tip.e0")), last("unstable")]
}

/// The turn of the tip is κL by the law of the fibres, about both axes, on meshes down to a tenth of the thickness.
///
/// Without the energy of a thickness that changes along the axis, waves of single elements grow on the finer mesh. Linked
/// elements have 0.2 κ²I/A less stiffness (`SectionLaw::axial_variation`).
#[test]
fn thick_beams_follow_the_law_of_the_fibres_on_fine_meshes() {
    let [moment, curvature] = fibre_law(1.15);
    let exact = curvature * LENGTH;
    assert!(exact > 0.7 * PI && curvature * HEIGHT > 0.28);
    for (formulation, bound) in [("enhanced", 1e-3), ("linked", 5e-3), ("quadratic", 1e-3)] {
        for (elements, axis) in [(32, 'z'), (80, 'z'), (80, 'y')] {
            let [turn, negative] = bent(formulation, elements, axis, 1e9 * moment);
            let error = (turn / exact - 1.0).abs();
            assert!(error < bound, "{formulation}, {elements}, {axis}: {error:e}");
            assert!(negative <= 2.0, "{formulation}, {elements}, {axis}: unstable in {negative} directions");
        }
    }
}

/// A beam without a stated formulation has the deflection F L³/(3EI) + F L/(kGA) for any Poisson ratio, with one element.
#[test]
fn default_formulation_bends_by_timoshenko_for_any_poisson_ratio() {
    for (poisson, elements) in [(-0.2, 3), (0.0, 1), (0.35, 1), (0.49, 12)] {
        let run = Run::of(&parse(&format!(
            r#"
materials.s = {{ density = 1000, young = 3e9, poisson = {poisson} }}
sections.c = {{ kind = "rectangle", height = 0.08, width = 0.03 }}
bodies = [{{ kind = "beam", name = "arm", from = [0, 0, 0], to = [0, 1.5, 0], elements = {elements}, section = "c", material = "s" }}]
joints = [{{ kind = "clamp", name = "root", a = {{ body = "arm", at = "start" }} }}]
loads = [{{ kind = "force", on = {{ body = "arm", at = "end" }}, force = [0, 0, 2e-3] }}]
probes = [{{ name = "tip", on = {{ body = "arm", at = "end" }} }}]
[analysis]
kind = "statics"
stop = {{ rule = "energy", tolerance = 1e-14 }}
"#
        )));
        let section = Section::rectangle(0.08, 0.03);
        let (moments, shear) = (section.moments(), 3e9 / (2.0 * (1.0 + poisson)));
        let (up, across) = (moments.yy, moments.zz);
        let inertia = up.max(across);
        let k = section.shear_factors(poisson);
        let factor = if up > across { k[0] } else { k[1] };
        let exact = 2e-3 * (1.5_f64.powi(3) / (3.0 * 3e9 * inertia) + 1.5 / (factor * shear * moments.area));
        let found = *run.column("tip.z").last().unwrap();
        assert!((found / exact - 1.0).abs() < 1e-6, "nu = {poisson}: {}", found / exact);
    }
}
