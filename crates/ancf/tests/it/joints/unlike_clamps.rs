//! Clamps between bodies of unlike formulations: closed forms on any mesh, and equal results for exchanged ends.

use std::f64::consts::PI;

use ancf::Model;

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

const YOUNG: f64 = 2.6e9;
const DIAMETER: f64 = 0.05;
const POST: f64 = 0.7;
const ARM: f64 = 0.4;
const FORCE: f64 = 0.2;

/// Post along z with an arm along x at its top. The tip of the arm has a force along x.
fn frame([post, arm]: [&str; 2], elements: u32, exchanged: bool) -> Model {
    let body = |kind: &str, name: &str, ends: &str| {
        let kind = match kind {
            "cable" => "kind = \"cable\"".to_owned(),
            formulation => format!("kind = \"beam\", formulation = \"{formulation}\""),
        };
        format!(
            "{{ {kind}, name = \"{name}\", {ends}, elements = {elements}, section = \"s\", material = \"m\" }}"
        )
    };
    let bodies = [
        body(post, "post", &format!("from = [0, 0, 0], to = [0, 0, {POST}]")),
        body(arm, "arm", &format!("from = [0, 0, {POST}], to = [{ARM}, 0, {POST}]")),
    ]
    .join(", ");
    let (a, b) = ("{ body = \"post\", at = \"end\" }", "{ body = \"arm\", at = \"start\" }");
    let (a, b) = if exchanged { (b, a) } else { (a, b) };
    parse(&format!(
        "materials.m = {{ density = 900, young = {YOUNG} }}
        sections.s = {{ kind = \"circle\", diameter = {DIAMETER} }}
        bodies = [{bodies}]
        joints = [
          {{ kind = \"clamp\", name = \"root\", a = {{ body = \"post\", at = \"start\" }} }},
          {{ kind = \"clamp\", name = \"corner\", a = {a}, b = {b} }},
        ]
        loads = [{{ kind = \"force\", on = {{ body = \"arm\", at = \"end\" }}, force = [{FORCE}, 0, 0] }}]
        probes = [{{ name = \"tip\", on = {{ body = \"arm\", at = \"end\" }} }}]
        [analysis]
        kind = \"statics\"
        stop = {{ rule = \"energy\", tolerance = 1e-11 }}"
    ))
}

const PAIRS: [[&str; 2]; 8] = [
    ["linked", "continuum"],
    ["quadratic", "continuum"],
    ["continuum", "linked"],
    ["continuum", "quadratic"],
    ["continuum", "enhanced"],
    ["continuum", "continuum"],
    ["linked", "quadratic"],
    ["continuum", "cable"],
];

/// F (L³/3EI + L/kGA + l/EA), z: −F L² l/2EI, on all meshes. The shear factor is near one; shear is 1.3 % here.
#[test]
fn corners_have_closed_forms_on_any_mesh() {
    let (area, second) = (PI * DIAMETER.powi(2) / 4.0, PI * DIAMETER.powi(4) / 64.0);
    let bending = YOUNG * second;
    for pair in PAIRS {
        for elements in [4, 48] {
            let [run, other] = [false, true].map(|exchanged| Run::of(&frame(pair, elements, exchanged)));
            let name = format!("{pair:?}, {elements} elements");
            let lower = FORCE * (POST.powi(3) / (3.0 * bending) + ARM / (YOUNG * area));
            let shear = FORCE * POST / (0.5 * YOUNG * area);
            let (x, z) = (run.last("tip.x") - ARM, run.last("tip.z") - POST);
            // An element of the continuum formulation at a clamp of all gradients has 1 − 1/(4n²) of the deflection.
            let coarse = if elements == 4 { 0.02 } else { 1e-4 };
            assert!(
                x > lower + 0.9 * shear - coarse * lower && x < lower + 1.3 * shear,
                "{name}: {x} {lower} {shear}"
            );
            if pair[1] != "cable" {
                assert_relative(
                    &name,
                    z,
                    -FORCE * POST.powi(2) / (2.0 * bending) * ARM,
                    0.5 * coarse.max(2e-3),
                );
            }
            for column in ["tip.x", "tip.z", "corner.my", "corner.fx"] {
                let sign = if column.starts_with("corner") { -1.0 } else { 1.0 };
                let (found, expected) = (sign * other.last(column), run.last(column));
                assert!(
                    (found - expected).abs() < 1e-8 * expected.abs().max(1e-3),
                    "{name}, {column}: {found} {expected}"
                );
            }
        }
    }
}

/// `fix = "all"` at a corner of beams gives a warning in the check and in the summary.
#[test]
fn all_gradients_at_corners_give_a_warning() {
    let with = |fix: &str, along: bool| {
        let arm = if along { "to = [0, 0, 1.4]" } else { "to = [0.5, 0, 0.7]" };
        parse(&format!(
            "materials.m = {{ density = 900, young = 1e9 }}
            sections.s = {{ kind = \"circle\", diameter = 0.05 }}
            bodies = [
              {{ kind = \"beam\", name = \"post\", from = [0, 0, 0], to = [0, 0, 0.7], elements = 2, section = \"s\", material = \"m\" }},
              {{ kind = \"beam\", name = \"arm\", from = [0, 0, 0.7], {arm}, elements = 2, section = \"s\", material = \"m\" }},
            ]
            joints = [
              {{ kind = \"clamp\", name = \"root\", a = {{ body = \"post\", at = \"start\" }} }},
              {{ kind = \"clamp\", name = \"corner\", a = {{ body = \"post\", at = \"end\" }}, b = {{ body = \"arm\", at = \"start\" }}{fix} }},
            ]
            analysis = {{ kind = \"statics\" }}"
        ))
    };
    let warnings = |model: &Model| model.diagnose().unwrap().warnings;
    let found = warnings(&with(", fix = \"all\"", false));
    assert!(
        found.len() == 1 && found[0].contains("`corner`") && found[0].contains("\"section\""),
        "{found:?}"
    );
    for model in [with("", false), with(", fix = \"section\"", false), with(", fix = \"all\"", true)] {
        assert_eq!(warnings(&model), Vec::<String>::new());
    }
}
