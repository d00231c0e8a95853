//! Statics where joints carry all loads: nothing moves but for rounding errors, and reactions balance the loads.

use ancf::record::Series;
use ancf::{Model, Outcome, Summary, simulate};
use nalgebra::{Rotation3, Vector3};

use crate::common::random::Random;

const ANALYSES: [&str; 4] = [
    "kind = \"statics\", stop = { rule = \"energy\", tolerance = 1e-11 }",
    "kind = \"statics\", first = 0.3, stop = { rule = \"energy\", tolerance = 1e-8 }",
    "kind = \"path\", first = 0.05, points = 60, stop = { rule = \"energy\", tolerance = 1e-8 }",
    "kind = \"path\", first = 0.2, points = 60, stop = { rule = \"energy\", tolerance = 1e-11 }",
];

fn run(text: &str) -> (Summary, Series) {
    let model = Model::parse(text).unwrap_or_else(|errors| panic!("{errors}\n{text}"));
    let mut series = Series::new();
    (simulate(&model, &mut series).unwrap(), series)
}

/// Frame in which a model is stated.
struct Frame(Rotation3<f64>);

impl Frame {
    fn vector(&self, x: [f64; 3]) -> String {
        format!("{:?}", <[f64; 3]>::from(self.0 * Vector3::from(x)))
    }
}

/// Bodies and joints whose first joint `root` carries a force at the place `on`.
fn models(frame: &Frame) -> [(&'static str, String); 4] {
    let v = |x| frame.vector(x);
    let [center, away, far] = [v([0.2, -0.9, 0.1]), v([0.8, -1.3, -0.2]), v([-0.5, 0.4, 0.9])];
    let spring = |name: &str, at: &str, point: &str, k: f64| {
        format!(
            "{{ kind = \"spring\", name = \"{name}\", a = {{ body = \"b\", at = {at} }}, b = {{ point = {point} }}, stiffness = {k} }}"
        )
    };
    let rod = |formulation: &str| {
        format!(
            "materials.m = {{ density = 1200, young = 3e8 }}
            sections.s = {{ kind = \"circle\", diameter = 0.05 }}
            bodies = [{{ kind = \"beam\", name = \"b\", from = {center}, to = {far}, elements = 2, formulation = \"{formulation}\", section = \"s\", material = \"m\" }}]
            joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"b\", at = \"start\" }} }}, {}]
            loads = [{{ kind = \"force\", on = {{ body = \"b\", at = \"start\" }}, force = {}, follower = true }}]",
            spring("side", "\"start\"", &away, 210.0),
            v([3.0, -7.0, 40.0])
        )
    };
    let rigid = format!(
        "bodies = [{{ kind = \"rigid\", name = \"b\", center = {center}, mass = 11, inertia = [0.6, 0.6, 0.6] }}]
        joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"b\", at = {center} }} }}, {}]
        loads = [{{ kind = \"force\", on = {{ body = \"b\", at = {center} }}, force = {} }}]",
        spring("side", &center, &away, 4700.0),
        v([3.0, -7.0, 40.0])
    );
    let point = format!(
        "bodies = [{{ kind = \"mass\", name = \"b\", center = {center}, mass = 2 }}]
        joints = [{{ kind = \"spherical\", name = \"root\", a = {{ body = \"b\", at = \"center\" }} }}, {}, {}]
        loads = [{{ kind = \"force\", on = {{ body = \"b\", at = \"center\" }}, force = {} }}]",
        spring("side", "\"center\"", &away, 71.0),
        spring("top", "\"center\"", &far, 350.0),
        v([3.0, -7.0, 40.0])
    );
    [("enhanced", rod("enhanced")), ("quadratic", rod("quadratic")), ("rigid", rigid), ("point", point)]
}

/// All forces are carried, in any frame and units: reaction −F, no displacement.
#[test]
fn reactions_balance_loads_without_motion() {
    let mut random = Random(2027);
    for case in 0..12 {
        let frame =
            Frame(if case == 0 { Rotation3::identity() } else { Rotation3::new(random.vector3() * 2.0) });
        let scales = ["none", "auto"][case % 2];
        let place = frame.0 * Vector3::new(0.2, -0.9, 0.1);
        let force = frame.0 * Vector3::new(3.0, -7.0, 40.0);
        for (name, model) in models(&frame) {
            let at = if name == "point" || name == "rigid" { "center" } else { "start" };
            let analysis = ANALYSES[case % ANALYSES.len()];
            let (summary, series) = run(&format!(
                "{model}\nscales = {{ kind = \"{scales}\" }}\nanalysis = {{ {analysis} }}\n\
                 probes = [{{ name = \"p\", on = {{ body = \"b\", at = \"{at}\" }} }}]"
            ));
            let name = format!("{name}, case {case}, {analysis}");
            assert!(matches!(summary.outcome, Outcome::Finished), "{name}: {:?}", summary.outcome);
            let last = |column: String| *series.column(&column).unwrap().last().unwrap();
            let vector =
                |owner: &str| Vector3::from(["x", "y", "z"].map(|axis| last(format!("{owner}{axis}"))));
            assert!((vector("p.") - place).norm() < 1e-14, "{name}: {}", vector("p.") - place);
            assert!((vector("root.f") + force).norm() < 1e-11, "{name}: {}", vector("root.f"));
        }
    }
}

/// A rigid body without any degree of freedom under a dead moment, whose stiffness is not symmetric.
#[test]
fn moments_on_bodies_without_degrees_of_freedom_are_carried() {
    for analysis in ANALYSES {
        let (summary, series) = run(&format!(
            "bodies = [{{ kind = \"rigid\", name = \"b\", center = [0, 0, 0], mass = 2, inertia = [0.4, 0.5, 0.3] }}]
            joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"b\", at = \"center\" }} }}]
            loads = [{{ kind = \"moment\", on = {{ body = \"b\", at = \"center\" }}, moment = [0.3, -1.1, 0.7] }}]
            analysis = {{ {analysis} }}"
        ));
        assert!(matches!(summary.outcome, Outcome::Finished), "{:?}", summary.outcome);
        for (axis, expected) in [("x", -0.3), ("y", 1.1), ("z", -0.7)] {
            let found = *series.column(&format!("root.m{axis}")).unwrap().last().unwrap();
            assert!((found - expected).abs() < 1e-12, "{axis}: {found}");
        }
    }
}

/// A clamp carries a moment on a rigid body, along any axis. Gaps of its joint are rounding errors of rounding errors, which no increment
/// closes.
#[test]
fn a_clamp_carries_moments_on_a_rigid_body() {
    for case in 0..12 {
        let mut moment = [0.0; 3];
        moment[case % 3] = 1037.0;
        let mut at = [0.3, -0.2 * (case / 3) as f64, 0.7];
        let center = at;
        at[(case + 2) % 3] -= 0.07;
        let (summary, series) = run(&format!(
            "gravity = [0, 0, 0]
            scales = {{ kind = \"none\" }}
            bodies = [{{ kind = \"rigid\", name = \"b\", center = {center:?}, mass = 4.34, inertia = [0.041, 0.0225, 0.0277] }}]
            joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"b\", at = {at:?} }} }}]
            loads = [{{ kind = \"moment\", on = {{ body = \"b\", at = {center:?} }}, moment = {moment:?} }}]
            analysis = {{ kind = \"statics\" }}"
        ));
        assert_eq!(summary.outcome, Outcome::Finished, "{moment:?} at {at:?}");
        for (axis, moment) in ["mx", "my", "mz"].into_iter().zip(moment) {
            let values = series.column(&format!("root.{axis}")).unwrap();
            let reaction = values[values.len() - 1];
            assert!((reaction.abs() - moment).abs() < 1e-9 * 1037.0, "{axis}: {reaction} for {moment}");
        }
    }
}
