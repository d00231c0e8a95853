//! Differences between successive refinements of steps and of meshes fall.

use ancf::Model;
use ancf::model::{Body, Scheme, Step};

use super::law::{Check, Law};
use crate::compare::{Case, Finding, unequal_verdicts};
use crate::random::Random;
use crate::run::{Run, run};

/// Step, half of it and a quarter of it, and an eighth if the difference does not fall: motions at common times.
pub(super) struct Steps;

/// Difference relative to the length below which its decrease is not checked: vibrations that the steps do not resolve remain.
const SMALL: f64 = 2e-4;
/// Difference relative to the length above which the steps do not resolve the motion.
const UNRESOLVED: f64 = 0.05;

impl Law for Steps {
    fn name(&self) -> &'static str {
        "steps"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let Some(dynamics) = case.model.analysis.dynamics() else { return Check::Inapplicable };
        let Step::Fixed(step) = dynamics.step else { return Check::Inapplicable };
        if !case.base.verdict.is_finished() || case.base.is_divided || !case.model.contacts.is_empty() {
            return Check::Inapplicable;
        }
        // An initial velocity that joints stop is an impulse, which excites all vibrations.
        let has_motion = case.model.bodies.iter().any(|body| !body.motion().is_rest());
        if has_motion && !case.model.joints.is_empty() {
            return Check::Inapplicable;
        }
        let factor = if matches!(dynamics.scheme, Scheme::Adams) { 0.9 } else { 0.75 };
        let with = |divisor: f64| {
            let mut model = case.model.clone();
            if let Some(dynamics) = model.analysis.dynamics_mut() {
                dynamics.step = Step::Fixed(step / divisor);
            }
            run(&model)
        };
        let (half, quarter) = (with(2.0), with(4.0));
        if let Some(found) = unequal_verdicts(self.name(), &case.base, &half) {
            return Check::Violated(found);
        }
        if !quarter.verdict.is_finished() || half.is_divided || quarter.is_divided {
            return Check::Inapplicable;
        }
        let length = case.model.length();
        let coarse = distance([&case.base, &half], 2) / length;
        let fine = distance([&half, &quarter], 2) / length;
        if coarse > UNRESOLVED || fine < SMALL || fine < factor * coarse {
            return Check::Holds;
        }
        let eighth = with(8.0);
        if !eighth.verdict.is_finished() || eighth.is_divided {
            return Check::Inapplicable;
        }
        let finest = distance([&quarter, &eighth], 2) / length;
        if finest < SMALL || finest < factor * fine {
            return Check::Holds;
        }
        let values = format!(
            "differences {coarse:.2e}, {fine:.2e}, {finest:.2e} of the length with steps divided by 1, 2, 4, 8"
        );
        Check::Violated(Finding {
            law: self.name(),
            quantity: "position".into(),
            values,
            excess: finest / fine,
        })
    }
}

/// Root mean square distance of the probes of two runs, of which the second one has `ratio` times the rows.
pub(super) fn distance([coarse, fine]: [&Run; 2], ratio: usize) -> f64 {
    let mut sum = 0.0;
    let mut count = 0.0;
    for column in coarse.columns.iter().filter(|column| is_position(&column.name)) {
        let Some(other) = fine.column(&column.name) else { continue };
        for (row, value) in column.values.iter().enumerate() {
            if let Some(other) = other.values.get(ratio * row) {
                sum += (value - other).powi(2);
                count += 1.0;
            }
        }
    }
    (sum / f64::max(count, 1.0)).sqrt()
}

/// True for a column of a position.
pub(super) fn is_position(name: &str) -> bool {
    [".x", ".y", ".z"].iter().any(|end| name.ends_with(end))
}

/// Four, eight and 16 times the elements, and 32 times if the difference does not fall: equilibria, frequencies and critical loads.
pub(super) struct Elements;

impl Law for Elements {
    fn name(&self) -> &'static str {
        "elements"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let is_flexible = case.model.bodies.iter().any(Body::is_flexible);
        if case.base.warnings.iter().any(|text| text.starts_with(PREBUCKLING)) {
            return Check::Inapplicable;
        }
        if case.is_dynamic() || !is_flexible || !case.base.verdict.is_finished() {
            return Check::Inapplicable;
        }
        let with = |factor| run(&refined(&case.model, factor));
        let size = case.base.column("p0.x").map_or(1.0, |_| case.model.length());
        let runs = [4, 8, 16].map(with);
        let (Some(coarse), Some(fine)) =
            (last_difference([&runs[0], &runs[1]], size), last_difference([&runs[1], &runs[2]], size))
        else {
            return Check::Inapplicable;
        };
        if fine < 1e-4 || fine < 0.8 * coarse {
            return Check::Holds;
        }
        let Some(finest) = last_difference([&runs[2], &with(32)], size) else { return Check::Inapplicable };
        if finest < 1e-4 || finest < 0.8 * fine {
            return Check::Holds;
        }
        let values = format!(
            "relative differences {coarse:.2e}, {fine:.2e}, {finest:.2e} with 4, 8, 16, 32 times the elements"
        );
        Check::Violated(Finding {
            law: self.name(),
            quantity: "last row".into(),
            values,
            excess: finest / fine,
        })
    }
}

/// Model with a multiple of the elements.
pub(super) fn refined(model: &Model, factor: u32) -> Model {
    let mut model = model.clone();
    for body in &mut model.bodies {
        body.set_elements(factor * body.elements());
    }
    model
}

/// Start of the warning of critical loads with a large deformation before buckling. The continuum loses its stability there in
/// each element, by the St. Venant-Kirchhoff law, and the factors accumulate.
const PREBUCKLING: &str = "linear buckling neglects the deformation before buckling";

/// Largest difference of eigenvalues, or of positions in the last row. `None` if a run is not finished, or if the last load
/// factors differ: paths may end by their number of points.
fn last_difference([coarse, fine]: [&Run; 2], length: f64) -> Option<f64> {
    if !coarse.verdict.is_finished() || !fine.verdict.is_finished() {
        return None;
    }
    let load = |run: &Run| run.column("load").and_then(|column| column.values.last().copied()).unwrap_or(1.0);
    if (load(coarse) - load(fine)).abs() > 1e-9 {
        return None;
    }
    let is_eigen = coarse.column("mode").is_some();
    let mut worst = 0.0_f64;
    for column in &coarse.columns {
        let Some(other) = fine.column(&column.name) else { continue };
        let pairs = column.values.iter().zip(&other.values);
        let scale = column.values.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        match column.name.as_str() {
            "squared" | "factor" => {
                let relative =
                    pairs.map(|(a, b)| (a - b).abs() / (a.abs() + 1e-6 * scale + f64::MIN_POSITIVE));
                worst = relative.fold(worst, f64::max);
            }
            name if !is_eigen && is_position(name) => {
                if let (Some(a), Some(b)) = (column.values.last(), other.values.last()) {
                    worst = worst.max((a - b).abs() / length);
                }
            }
            _ => {}
        }
    }
    Some(worst)
}
