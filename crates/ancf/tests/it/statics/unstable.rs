//! Unstable equilibria are reported, refused or left.

use ancf::record::Series;
use ancf::{Model, Summary, simulate};

/// A straight column, clamped below, under a multiple of Euler's load.
fn column(part: f64, analysis: &str) -> (Summary, Series) {
    let (length, diameter, young) = (1.2, 0.02, 4e9);
    let second = std::f64::consts::PI * f64::powi(diameter, 4) / 64.0;
    let force = part * std::f64::consts::PI.powi(2) * young * second / (4.0 * f64::powi(length, 2));
    let text = format!(
        r#"
        materials.s = {{ density = 1000, young = {young} }}
        sections.c = {{ kind = "circle", diameter = {diameter} }}
        bodies = [{{ kind = "beam", name = "arm", from = [0, 0, 0], to = [0, 0, {length}], elements = 8, formulation = "quadratic", section = "c", material = "s" }}]
        joints = [{{ kind = "clamp", name = "root", a = {{ body = "arm", at = "start" }} }}]
        loads = [{{ kind = "force", on = {{ body = "arm", at = "end" }}, force = [0, 0, {}] }}]
        probes = [{{ name = "tip", on = {{ body = "arm", at = "end" }} }}]
        analysis = {{ {analysis} }}
        "#,
        -force
    );
    finish(&text)
}

fn finish(text: &str) -> (Summary, Series) {
    let (model, mut series) = (Model::parse(text).unwrap(), Series::new());
    (simulate(&model, &mut series).unwrap(), series)
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap().last().unwrap()
}

/// Statics and paths of a perfect column beyond its critical load state that it is unstable, and where it became so.
#[test]
fn straight_column_is_called_unstable() {
    for kind in ["statics", "path"] {
        let (summary, series) = column(1.8848, &format!(r#"kind = "{kind}""#));
        assert!(summary.outcome.is_finished());
        assert_eq!(last(&series, "unstable"), 2.0);
        let [lost, end] = &summary.warnings[..] else { panic!("{:?}", summary.warnings) };
        assert!(lost.contains("lost its stability between the load factors 0.5"), "{lost}");
        assert!(end.contains("is unstable in 2 directions") && end.contains("`arm`"), "{end}");
    }
    let (summary, _) = column(0.9, r#"kind = "statics""#);
    assert!(summary.warnings.is_empty(), "{:?}", summary.warnings);
}

/// With `unstable = "stop"` the analysis fails at the critical load.
#[test]
fn loss_of_stability_may_be_a_failure() {
    let (summary, _) = column(2.0, r#"kind = "statics", unstable = "stop""#);
    let failure = summary.outcome.failure(&ancf::model::Analysis::Statics(Default::default())).unwrap();
    assert!(failure.contains("stability") && failure.contains("leave"), "{failure}");
    assert!((summary.time - 0.5).abs() < 0.01, "{}", summary.time);
}

/// With `unstable = "leave"` the column bends: the elastica at P/P_E = 1.8848 has its tip at 0.1232 L and 0.8032 L.
#[test]
fn column_is_left_to_the_elastica() {
    let (summary, series) = column(1.8848008689781, r#"kind = "statics", unstable = "leave""#);
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    assert_eq!(last(&series, "unstable"), 0.0);
    let (x, y, z) = (last(&series, "tip.x"), last(&series, "tip.y"), last(&series, "tip.z"));
    assert!((z / 1.2 - 0.12316).abs() < 4e-3 && (x.hypot(y) / 1.2 - 0.80317).abs() < 4e-3, "{x}, {y}, {z}");
    assert!(
        summary.warnings.iter().all(|warning| !warning.contains("last equilibrium")),
        "{:?}",
        summary.warnings
    );
}

/// An inverted rigid pendulum on a hinge spring, m g l = 12 and k = 7, leans by 0.002.
///
/// 7 a = 12 sin(a + 0.002) has the stable root a = 1.6929 on the side to which it leans.
#[test]
fn inverted_pendulum_falls_to_the_side_to_which_it_leans() {
    let model = |lean: f64, unstable: &str| {
        format!(
            r#"
            gravity = [0, 0, -10]
            bodies = [{{ kind = "rigid", name = "p", center = [{lean}, 0, 1], mass = 1.2, inertia = [0.1, 0.1, 0.1] }}]
            joints = [{{ kind = "revolute", name = "h", a = {{ body = "p", at = [0, 0, 0] }}, axis = [0, 1, 0], spring = {{ stiffness = 7 }} }}]
            analysis = {{ kind = "statics"{unstable} }}
            "#
        )
    };
    let root = |lean: f64| (0..200).fold(1.7_f64, |a, _| 12.0 / 7.0 * (a + lean).sin() * 0.5 + 0.5 * a);
    let (summary, series) = finish(&model(0.002, ""));
    assert!(summary.outcome.is_finished() && summary.warnings.is_empty(), "{summary:?}");
    assert!((last(&series, "h.angle") - root(0.002)).abs() < 1e-5, "{}", last(&series, "h.angle"));
    assert_eq!(last(&series, "unstable"), 0.0);
    // Exactly upright.
    let (summary, series) = finish(&model(0.0, ""));
    assert_eq!(last(&series, "unstable"), 1.0);
    assert!(summary.warnings[1].contains("1 direction"), "{:?}", summary.warnings);
    let (summary, series) = finish(&model(0.0, r#", unstable = "leave""#));
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    assert!((last(&series, "h.angle").abs() - root(0.0)).abs() < 1e-6, "{}", last(&series, "h.angle"));
}
