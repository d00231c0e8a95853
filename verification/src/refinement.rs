//! Refinement: quantities of a model on finer meshes or with shorter steps, and their orders of convergence.

use crate::{Effectivity, Findings, Plot, PlotCurve, SolvedModel, VerificationError, solve};

/// Value of a solved model.
type Reading<'a> = Box<dyn Fn(&SolvedModel) -> Result<f64, VerificationError> + 'a>;
/// Reference as a function of the abscissa.
type Law<'a> = Box<dyn Fn(f64) -> f64 + 'a>;

/// Permitted difference of an observed order and the expected one.
const ORDER: f64 = 0.25;
/// Error, relative to the required accuracy, above which it is compared with its estimate.
const SIGNIFICANT: f64 = 2.0;
/// Smallest error of a plot with logarithmic axes.
const SMALLEST: f64 = 1e-16;
/// Number of markers of a reference curve.
const MARKERS: usize = 30;

/// Model with a level of refinement, and the quantities that are compared on the finest level.
pub struct Refinement<'a> {
    refined: &'a str,
    levels: Vec<u32>,
    model: Box<dyn Fn(u32) -> String + 'a>,
    quantities: Vec<Quantity<'a>>,
}

/// Quantity with its reference.
struct Quantity<'a> {
    what: &'a str,
    measure: Measure<'a>,
    scale: f64,
    tolerance: f64,
    order: Option<f64>,
}

/// Measurement of a quantity.
enum Measure<'a> {
    /// Number.
    Value(Reading<'a>, f64),
    /// Columns x and y, and y as a function of x.
    Curve([&'a str; 2], Law<'a>),
}

impl<'a> Refinement<'a> {
    /// Creates the refinement of a model at several levels, the finest last. `refined` names the level, such as `"elements"`.
    pub fn new(refined: &'a str, levels: &[u32], model: impl Fn(u32) -> String + 'a) -> Self {
        Self { refined, levels: levels.to_vec(), model: Box::new(model), quantities: Vec::new() }
    }

    /// Creates the refinement of a motion in a number of equal steps. `DURATION` and `STEP` in the model are replaced.
    pub fn steps(model: &'a str, duration: f64, levels: &[u32]) -> Self {
        let text = move |n: u32| {
            let step = duration / f64::from(n);
            model.replace("DURATION", &format!("{duration:?}")).replace("STEP", &format!("{step:?}"))
        };
        Self::new("steps", levels, text)
    }

    /// Creates the refinement of a mesh. `ELEMENTS` in the model is replaced.
    pub fn elements(model: &'a str, levels: &[u32]) -> Self {
        Self::new("elements", levels, |n| model.replace("ELEMENTS", &n.to_string()))
    }

    /// Creates the refinement of one model.
    pub fn single(model: String) -> Self {
        Self::new("", &[1], move |_| model.clone())
    }

    /// Compares a number. The scale of its error is the reference.
    #[must_use]
    pub fn value(
        self,
        what: &'a str,
        reading: impl Fn(&SolvedModel) -> Result<f64, VerificationError> + 'a,
        reference: f64,
        tolerance: f64,
    ) -> Self {
        self.quantity(what, Measure::Value(Box::new(reading), reference), reference.abs(), tolerance)
    }

    /// Compares the last value of a column. The scale of its error is the reference.
    #[must_use]
    pub fn last(self, what: &'a str, column: &'a str, reference: f64, tolerance: f64) -> Self {
        self.value(what, move |solved| solved.last(column), reference, tolerance)
    }

    /// Compares all values of the column `columns[1]` with a function of the column `columns[0]`.
    #[must_use]
    pub fn curve(
        self,
        what: &'a str,
        columns: [&'a str; 2],
        law: impl Fn(f64) -> f64 + 'a,
        scale: f64,
        tolerance: f64,
    ) -> Self {
        self.quantity(what, Measure::Curve(columns, Box::new(law)), scale, tolerance)
    }

    /// Sets the scale of the error of the last quantity.
    #[must_use]
    pub fn scaled(mut self, scale: f64) -> Self {
        if let Some(quantity) = self.quantities.last_mut() {
            quantity.scale = scale.abs();
        }
        self
    }

    /// States the order of convergence of the last quantity, which is observed on the two finest levels.
    #[must_use]
    pub fn order(mut self, order: f64) -> Self {
        if let Some(quantity) = self.quantities.last_mut() {
            quantity.order = Some(order);
        }
        self
    }

    fn quantity(mut self, what: &'a str, measure: Measure<'a>, scale: f64, tolerance: f64) -> Self {
        self.quantities.push(Quantity { what, measure, scale, tolerance, order: None });
        self
    }

    /// Solves all levels and compares.
    ///
    /// # Errors
    /// If a model fails or lacks a column.
    pub fn run(&self) -> Result<Findings, VerificationError> {
        let solved: Vec<SolvedModel> =
            self.levels.iter().map(|&level| solve(&(self.model)(level))).collect::<Result<_, _>>()?;
        let mut findings = Findings::default();
        let mut convergence = Vec::new();
        for quantity in &self.quantities {
            let measured: Vec<[f64; 2]> =
                solved.iter().map(|solved| quantity.measure.of(solved)).collect::<Result<_, _>>()?;
            let errors: Vec<f64> =
                measured.iter().map(|[ours, reference]| (ours - reference).abs()).collect();
            if let Some([ours, reference]) = measured.last() {
                findings.compare(quantity.what, *ours, *reference, quantity.scale, quantity.tolerance);
            }
            if let (Some(order), Some(observed)) = (quantity.order, self.observed(&errors)) {
                findings.compare(format!("{}: order", quantity.what), observed, order, 1.0, ORDER);
            }
            let points = self.levels.iter().zip(&errors);
            let points =
                points.map(|(&n, error)| [f64::from(n), (error / quantity.scale).max(SMALLEST)]).collect();
            convergence.push(PlotCurve::line(quantity.what, points));
        }
        findings.effectivities = self.effectivities(&solved);
        self.plot(&mut findings, &solved, convergence)?;
        Ok(findings)
    }

    /// Returns the estimated errors of all levels whose true error exceeds the accuracy of the comparison with the reference.
    fn effectivities(&self, solved: &[SolvedModel]) -> Vec<Effectivity> {
        let mut found = Vec::new();
        for (&level, solved) in self.levels.iter().zip(solved) {
            let Some(corrected) = solved.corrected() else { continue };
            for quantity in &self.quantities {
                let Measure::Value(reading, reference) = &quantity.measure else { continue };
                let (Ok(ours), Ok(better)) = (reading(solved), reading(&corrected)) else { continue };
                let is_significant =
                    (reference - ours).abs() > SIGNIFICANT * quantity.tolerance * quantity.scale;
                if is_significant && better.is_finite() && better != ours {
                    found.push(Effectivity::new(quantity.what, level, solved, [ours, better, *reference]));
                }
            }
        }
        found
    }

    /// Returns the order of convergence of the two finest levels.
    fn observed(&self, errors: &[f64]) -> Option<f64> {
        let (&[.., coarse, fine], &[.., n, m]) = (errors, &self.levels[..]) else { return None };
        Some((coarse / fine).ln() / (f64::from(m) / f64::from(n)).ln())
    }

    /// Plots the convergence, the curves, or else the numbers relative to their references.
    fn plot(
        &self,
        findings: &mut Findings,
        solved: &[SolvedModel],
        convergence: Vec<PlotCurve>,
    ) -> Result<(), VerificationError> {
        let Some(finest) = solved.last() else { return Ok(()) };
        for quantity in &self.quantities {
            let Measure::Curve(columns, law) = &quantity.measure else { continue };
            let points = finest.points(columns[0], columns[1])?;
            let every = points.len().div_ceil(MARKERS).max(1);
            let reference = points.iter().step_by(every).map(|&[x, _]| [x, law(x)]).collect();
            let curves = vec![PlotCurve::line("ancf", points), PlotCurve::points("reference", reference)];
            findings.plot(Plot::new(quantity.what, *columns, curves));
        }
        if solved.len() > 1 {
            let axes = [self.refined, "error relative to its scale"];
            findings.plot(
                Plot::new("Errors against refinement", axes, convergence).with_logarithmic_axes([true, true]),
            );
        } else if findings.plots.is_empty() {
            let number = |value: fn(&crate::Comparison) -> f64| {
                let all = findings.comparisons.iter().enumerate();
                all.map(|(k, comparison)| [(k + 1) as f64, value(comparison)]).collect()
            };
            let curves = vec![
                PlotCurve::line("ancf", number(|comparison| comparison.ours / comparison.scale)),
                PlotCurve::points("reference", number(|comparison| comparison.reference / comparison.scale)),
            ];
            let axes = ["number of the quantity", "value relative to its scale"];
            findings.plot(Plot::new("Numbers and references", axes, curves));
        }
        Ok(())
    }
}

impl Measure<'_> {
    /// Returns the value and its reference; of a curve the pair with the largest difference.
    fn of(&self, solved: &SolvedModel) -> Result<[f64; 2], VerificationError> {
        match self {
            Self::Value(reading, reference) => Ok([reading(solved)?, *reference]),
            Self::Curve([x, y], law) => {
                let pairs = solved.points(x, y)?.into_iter().map(|[x, y]| [y, law(x)]);
                let error = |pair: &[f64; 2]| {
                    let error = (pair[0] - pair[1]).abs();
                    if error.is_nan() { f64::INFINITY } else { error }
                };
                pairs
                    .max_by(|a, b| error(a).total_cmp(&error(b)))
                    .ok_or_else(|| VerificationError::Missing(format!("row in {y}")))
            }
        }
    }
}

impl std::fmt::Debug for Refinement<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Refinement").field("refined", &self.refined).field("levels", &self.levels).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A falling mass with constant steps of a second order scheme has an exact position.
    #[test]
    fn curves_and_values_are_compared() {
        let model = r#"
            gravity = [0, 0, -2]
            bodies = [{ kind = "mass", name = "ball", center = [0, 0, 0], mass = 1 }]
            probes = [{ name = "p", on = { body = "ball", at = "center" } }]
            analysis = { kind = "dynamics", duration = 1, step = 0.1 }
        "#;
        let study = Refinement::single(model.to_owned()).last("z", "p.z", -1.0, 1e-12).curve(
            "fall",
            ["t", "p.z"],
            |t| -t * t,
            1.0,
            1e-12,
        );
        let findings = study.run().unwrap();
        assert!(findings.broken().is_none(), "{findings:?}");
        assert_eq!((findings.comparisons.len(), findings.plots.len()), (2, 1));
    }

    #[test]
    fn orders_are_observed() {
        let study = Refinement::new("n", &[2, 4, 8], |_| String::new());
        assert!((study.observed(&[16.0, 4.0, 1.0]).unwrap() - 2.0).abs() < 1e-15);
    }
}
