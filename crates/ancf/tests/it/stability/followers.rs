//! Loads without a potential: Beck's column, which flutters and has no critical load of equilibria.

use std::f64::consts::TAU;

use ancf::record::Series;
use ancf::{Model, Outcome, Summary, simulate};

const LENGTH: f64 = 1.3;
const DIAMETER: f64 = 0.02;
const YOUNG: f64 = 7e9;
const DENSITY: f64 = 1500.0;

/// A clamped column under a compressive force that follows its tip, in multiples of EI/L².
fn column(p: f64, analysis: &str) -> (Summary, Series) {
    let force = p * YOUNG * std::f64::consts::PI * DIAMETER.powi(4) / 64.0 / LENGTH.powi(2);
    let text = format!(
        r#"
        materials.s = {{ density = {DENSITY}, young = {YOUNG} }}
        sections.c = {{ kind = "circle", diameter = {DIAMETER} }}
        bodies = [{{ kind = "beam", name = "arm", from = [0, 0, 0], to = [0, 0, {LENGTH}], elements = 16, formulation = "linked", section = "c", material = "s" }}]
        joints = [{{ kind = "clamp", name = "root", a = {{ body = "arm", at = "start" }} }}]
        loads = [{{ kind = "force", on = {{ body = "arm", at = "end" }}, force = [0, 0, {}], follower = true }}]
        analysis = {{ {analysis} }}
        "#,
        -force
    );
    let (model, mut series) = (Model::parse(&text).unwrap(), Series::new());
    (simulate(&model, &mut series).unwrap(), series)
}

const MODES: &str = r#"kind = "modes", count = 4, about = "equilibrium""#;

/// Left-hand side of Beck's frequency equation, with Ω = ω L² √(ρA/EI).
fn beck(p: f64, omega: f64) -> f64 {
    let root = (0.25 * p * p + omega * omega).sqrt();
    let (a, b) = ((root + 0.5 * p).sqrt(), (root - 0.5 * p).sqrt());
    p * p + 2.0 * omega.powi(2) * (1.0 + a.cos() * b.cosh()) + p * omega * a.sin() * b.sinh()
}

/// The lowest two roots Ω.
fn roots(p: f64) -> [f64; 2] {
    let step = 1e-2;
    let brackets = (1..3000).map(|k| f64::from(k) * step).filter(|w| beck(p, *w) * beck(p, w + step) < 0.0);
    let root = |start: f64| {
        let (mut low, mut high) = (start, start + step);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if beck(p, low) * beck(p, middle) <= 0.0 { high = middle } else { low = middle }
        }
        low
    };
    let found: Vec<f64> = brackets.take(2).map(root).collect();
    [found[0], found[1]]
}

/// Frequencies of the loaded column are those of Beck's equation, in both planes.
#[test]
fn frequencies_under_a_follower_force() {
    let unit = (YOUNG * DIAMETER.powi(2) / 16.0 / DENSITY).sqrt() / LENGTH.powi(2) / TAU;
    for p in [-4.0, 0.0, 6.0, 12.0, 17.0] {
        let (summary, series) = column(p, MODES);
        assert!(summary.outcome.is_finished() && summary.warnings.is_empty(), "{p}: {summary:?}");
        let found = series.column("frequency").unwrap();
        let exact = if p < 0.0 { continue } else { roots(p) };
        for (found, exact) in found.iter().zip([exact[0], exact[0], exact[1], exact[1]]) {
            assert!((found / (exact * unit) - 1.0).abs() < 4e-3, "{p}: {found} not {}", exact * unit);
        }
    }
}

/// The column flutters beyond 20.05 EI/L², where two frequencies meet.
#[test]
fn column_flutters_at_becks_load() {
    let (summary, series) = column(19.6, MODES);
    assert!(summary.warnings.is_empty() && series.column("frequency").unwrap().iter().all(|f| f.is_finite()));
    let (summary, series) = column(20.6, MODES);
    assert!(series.column("frequency").unwrap().iter().all(|f| f.is_nan()));
    assert_eq!(summary.warnings.len(), 4);
    assert!(summary.warnings[0].contains("flutters"), "{:?}", summary.warnings);
}

/// Statics states flutter, and not the indefinite symmetric part of the stiffness.
#[test]
fn stability_of_equilibria_under_a_follower_force() {
    let (summary, _) = column(15.0, r#"kind = "statics""#);
    assert!(summary.outcome.is_finished() && summary.warnings.is_empty(), "{:?}", summary.warnings);
    let (summary, _) = column(21.0, r#"kind = "statics""#);
    assert!(summary.warnings.iter().any(|warning| warning.contains("flutters")), "{:?}", summary.warnings);
}

/// Paths, damped modes and motions do not count the negative eigenvalues of the symmetric part, which begin at π² EI/L².
#[test]
fn equilibria_below_the_flutter_load_are_not_called_unstable() {
    let (summary, series) = column(17.0, r#"kind = "path""#);
    assert!(summary.outcome.is_finished() && summary.warnings.is_empty(), "{:?}", summary.warnings);
    let unstable = series.column("unstable").unwrap();
    assert!(unstable.iter().all(|count| *count == 0.0 || count.is_nan()), "{unstable:?}");
    for analysis in
        [format!("{MODES}, damped = true"), "kind = \"dynamics\", duration = 2, step = 0.01".into()]
    {
        let (summary, _) = column(17.0, &analysis);
        let calls_unstable = |warning: &String| warning.contains("unstable");
        assert!(summary.outcome.is_finished(), "{analysis}: {:?}", summary.outcome);
        assert!(!summary.warnings.iter().any(calls_unstable), "{analysis}: {:?}", summary.warnings);
    }
}

/// Linear buckling with a follower force is refused: there is no critical load of equilibria.
#[test]
fn buckling_under_a_follower_force_is_refused() {
    let (summary, series) = column(1.0, r#"kind = "buckling""#);
    let Outcome::Failed { reason, advice, .. } = &summary.outcome else { panic!("{:?}", summary.outcome) };
    assert!(reason.contains("no potential") && advice.contains("modes"), "{reason}; {advice}");
    assert!(series.column("factor").unwrap().is_empty());
}
