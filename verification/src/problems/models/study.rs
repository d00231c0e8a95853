//! Convergence of displacements to their references.

use crate::{Findings, Plot, PlotCurve, VerificationError};

/// Displacements on several meshes, relative to their references.
#[derive(Debug, Default)]
pub(in crate::problems) struct Convergence {
    found: Findings,
    curves: Vec<PlotCurve>,
}

impl Convergence {
    /// Runs a model on several meshes and compares the finest one. `exact` has the reference and the tolerance.
    pub(in crate::problems) fn case(
        &mut self,
        name: impl Into<String>,
        meshes: &[u32],
        (exact, tolerance): (f64, f64),
        run: impl Fn(u32) -> Result<f64, VerificationError>,
    ) -> Result<(), VerificationError> {
        let (name, mut points) = (name.into(), Vec::new());
        for &n in meshes {
            points.push([f64::from(n), run(n)? / exact]);
        }
        let finest = points.last().map_or(f64::NAN, |[_, ratio]| ratio * exact);
        self.found.compare(name.clone(), finest, exact, exact, tolerance);
        self.curves.push(PlotCurve::points(name, points));
        Ok(())
    }

    /// Adds the plot over the number of elements that `axis` names.
    pub(in crate::problems) fn finish(mut self, axis: &str) -> Findings {
        let all = || self.curves.iter().flat_map(|curve| &curve.points).map(|[n, _]| *n);
        let (first, last) = (all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max));
        let line = PlotCurve::line("reference", vec![[first, 1.0], [last, 1.0]]);
        let curves = std::iter::once(line).chain(self.curves).collect();
        self.found.plot(Plot::new("Values relative to the reference", [axis, "ratio"], curves));
        self.found
    }
}

/// Runs a model on several square meshes and compares the finest one.
pub(in crate::problems) fn study(
    meshes: &[u32],
    what: &str,
    exact: (f64, f64),
    run: impl Fn(u32) -> Result<f64, VerificationError>,
) -> Result<Findings, VerificationError> {
    let (mut convergence, n) = (Convergence::default(), meshes[meshes.len() - 1]);
    convergence.case(format!("{what}, {n} x {n} elements"), meshes, exact, run)?;
    Ok(convergence.finish("elements along an edge"))
}
