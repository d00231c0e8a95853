use ancf_solver::equations::State;

use super::body_errors::BodyError;
use super::discretisation_errors::{DiscretisationErrors, EigenvalueError, Resolution};
use super::finer::{Convergence, FinerMesh, HalvedModel, RecordedValues, ValueChange};
use super::value_errors::{ProbeError, STILL, ValueError, largest_error};
use crate::assembly::Assembly;
use crate::errors::percentage;
use crate::model::{Body, Model, Quantity};
use crate::units::{Dimension, Scales};

/// Relative error above which the mesh does not resolve the shape.
const UNRESOLVED: f64 = 0.5;
/// Displacement, relative to the largest one of a probe, above which its error states the class.
const FAR: f64 = 0.1;
/// Orders by which forces and stresses from second derivatives of displacements converge slower, and their lowest order.
const DERIVATIVES: f64 = 2.0;
const LOWEST: f64 = 1.0;

/// Comparison of the results of a model with those on a mesh with elements of half the size, by Richardson's extrapolation.
///
/// The error of a value is its change on the finer mesh times 2^p/(2^p − 1), with the lowest order p of the bodies.
///
/// Source: Richardson (1911).
pub(crate) struct MeshComparison<'a> {
    model: &'a Model,
    assembly: &'a Assembly,
    scales: Scales,
    convergence: Result<Convergence, String>,
}

impl<'a> MeshComparison<'a> {
    /// Creates the comparison for a model with flexible bodies in solver units.
    pub(crate) fn new(model: &'a Model, assembly: &'a Assembly, scales: Scales) -> Self {
        Self { model, assembly, scales, convergence: Convergence::of(model, assembly) }
    }

    /// Solver units of the model.
    pub(crate) const fn scales(&self) -> Scales {
        self.scales
    }

    /// Reason for which a second solution does not state the error.
    pub(crate) fn obstacle(&self) -> Option<&str> {
        self.convergence.as_ref().err().map(String::as_str)
    }

    /// Flexible bodies.
    fn bodies(&self) -> impl Iterator<Item = &'a Body> + use<'a> {
        self.model.bodies.iter().filter(|body| body.elements() > 0)
    }

    /// Errors without values, of a class, for a reason.
    fn without_values(
        &self,
        resolution: Resolution,
        elements: Option<usize>,
        reason: Option<String>,
    ) -> DiscretisationErrors {
        let largest = self.bodies().max_by_key(|body| body.elements());
        let order = self.convergence.as_ref().ok().map(|found| found.order);
        DiscretisationErrors {
            resolution,
            gaps: 0.0,
            body: largest.map(|body| body.name().to_owned()).unwrap_or_default(),
            elements: largest.map_or(0, |body| body.elements() as usize),
            law: 0.0,
            displacement: None,
            eigenvalue: None,
            bodies: Vec::new(),
            values: Vec::new(),
            finer: Some(FinerMesh { elements, order, reason }),
        }
    }

    /// Errors that are not known for a reason.
    pub(crate) fn unknown(&self, reason: impl Into<String>) -> DiscretisationErrors {
        self.without_values(Resolution::Unknown, None, Some(reason.into()))
    }

    /// Errors with values of a regular or irregular order, before the values are set.
    fn known(&self, elements: usize, convergence: &Convergence) -> DiscretisationErrors {
        let class = if convergence.irregular.is_some() { Resolution::Rough } else { Resolution::Good };
        self.without_values(class, Some(elements), convergence.irregular.clone())
    }

    /// Errors of the values in a state, from that on the finer mesh.
    fn values(
        &self,
        given: &State,
        (finer, fine): (&HalvedModel, &State),
        convergence: &Convergence,
    ) -> Vec<ValueError> {
        let coarse = RecordedValues::new(self.assembly, given, self.scales);
        let changes = RecordedValues::new(&finer.assembly, fine, self.scales).changes_from(&coarse);
        let error = |ValueChange { column, value, change, is_derivative }: ValueChange| {
            let order = convergence.order;
            let order = if is_derivative { (order - DERIVATIVES).max(LOWEST) } else { order };
            ValueError { column, value, error: change * extrapolation(order) }
        };
        changes.into_iter().map(error).collect()
    }

    /// Errors of the values in a state of a motion, from that on the finer mesh, and the description of this mesh.
    ///
    /// # Errors
    /// The reason for which a second solution does not state the error.
    pub(crate) fn motion(
        &self,
        given: &State,
        finer: &HalvedModel,
        fine: &State,
    ) -> Result<(Vec<ValueError>, FinerMesh), String> {
        let convergence = self.convergence.as_ref().map_err(String::clone)?;
        let values = self.values(given, (finer, fine), convergence);
        let elements = Some(finer.elements());
        let reason = convergence.irregular.clone();
        Ok((values, FinerMesh { elements, order: Some(convergence.order), reason }))
    }

    /// Errors of the values in an equilibrium, from that on the finer mesh.
    pub(crate) fn equilibrium(
        &self,
        given: &State,
        finer: &HalvedModel,
        fine: &State,
    ) -> DiscretisationErrors {
        let convergence = match &self.convergence {
            Ok(convergence) => convergence,
            Err(reason) => return self.unknown(reason),
        };
        let values = self.values(given, (finer, fine), convergence);
        let [worst, main] = self.displacements(given, &values);
        if let Some(main) = main.filter(|main| main.relative > UNRESOLVED || main.relative.is_nan()) {
            let change = main.relative / extrapolation(convergence.order);
            let change = match change <= 1.0 {
                true => percentage(change),
                false => "more than 100 %, or lead to another equilibrium".into(),
            };
            let probe = &main.probe;
            let reason =
                format!("elements of half the size change the displacement of `{probe}` by {change}");
            return self.without_values(Resolution::Unresolved, Some(finer.elements()), Some(reason));
        }
        let mut errors = self.known(finer.elements(), convergence);
        if worst.as_ref().is_some_and(|worst| worst.relative > UNRESOLVED) {
            errors.resolution = Resolution::Rough;
        }
        errors.bodies = self.share(worst.as_ref().map(|worst| worst.relative), convergence);
        DiscretisationErrors { displacement: worst, values, ..errors }
    }

    /// Largest relative errors of the displacements of all probes that move, and of those that move far.
    fn displacements(&self, state: &State, values: &[ValueError]) -> [Option<ProbeError>; 2] {
        let unit = self.scales.unit(Dimension::LENGTH);
        let of_probe = |probe: &str| {
            let first = values.iter().position(|value| value.column.strip_prefix(probe) == Some(".x"))?;
            Some(values.get(first..first + 3)?.to_vec())
        };
        let motions =
            self.assembly.recorded_quantities.iter().filter(|probe| probe.quantity == Quantity::Motion);
        let errors = motions.filter_map(|probe| {
            Some((probe.place.point.displacement(state) * unit, of_probe(&probe.name)?, probe))
        });
        let errors: Vec<_> = errors.collect();
        let still = STILL * unit * self.assembly.displacement(&self.assembly.rest(), state);
        let farthest = errors.iter().map(|(moved, ..)| moved.norm()).fold(0.0, f64::max);
        [still, still.max(FAR * farthest)].map(|least| largest_error(&errors, least))
    }

    /// Contribution of the body of a model with one flexible body. The error is not divided among several bodies.
    fn share(&self, relative: Option<f64>, convergence: &Convergence) -> Vec<BodyError> {
        let (mut bodies, Some(error)) = (self.bodies(), relative) else { return Vec::new() };
        let (Some(body), None) = (bodies.next(), bodies.next()) else { return Vec::new() };
        let elements = body.elements() as usize;
        let found = BodyError {
            body: body.name().to_owned(),
            elements,
            error: error.abs(),
            share: 1.0,
            elements_for_one_percent: None,
        };
        // The number of elements of a surface grows with the square of that along a line.
        let order = convergence.order / if body.is_shell() { 2.0 } else { 1.0 };
        let number = convergence.irregular.is_none().then(|| found.elements_for_one_percent(order));
        vec![BodyError { elements_for_one_percent: number, ..found }]
    }

    /// Errors of eigenvalues, whose column has the name `column`, from those on the finer mesh; also relative to the values, NaN if
    /// they are not known.
    pub(crate) fn eigenvalues(
        &self,
        column: &str,
        given: &[f64],
        finer: (&HalvedModel, &[f64]),
    ) -> (DiscretisationErrors, Vec<f64>) {
        let unknown = vec![f64::NAN; given.len()];
        let convergence = match &self.convergence {
            Ok(convergence) => convergence,
            Err(reason) => return (self.unknown(reason), unknown),
        };
        let (finer, fine) = finer;
        let relative = |(value, fine): (&f64, &f64)| (fine / value - 1.0) * extrapolation(convergence.order);
        let relative: Vec<_> = given.iter().zip(fine).map(relative).collect();
        let is_resolved = |error: &f64| error.abs() <= UNRESOLVED;
        let is_finite = relative.iter().any(|error| error.is_finite());
        let relative: Vec<_> =
            relative.into_iter().map(|error| if is_resolved(&error) { error } else { f64::NAN }).collect();
        let known = || relative.iter().enumerate().filter(|(_, error)| error.is_finite());
        let worst = known().max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()));
        let Some((worst, &error)) = worst else {
            let reason = "elements of half the size change the values by more than a third";
            let (class, reason) = match is_finite {
                true => (Resolution::Unresolved, reason.to_owned()),
                false => (Resolution::Unknown, "no value is above zero on both meshes".to_owned()),
            };
            return (self.without_values(class, Some(finer.elements()), Some(reason)), unknown);
        };
        let value = |(k, error): (usize, &f64)| ValueError {
            column: format!("{column}[{}]", k + 1),
            value: given[k],
            error: given[k] * error,
        };
        let eigenvalue = EigenvalueError {
            column: column.to_owned(),
            number: worst + 1,
            value: given[worst],
            relative: error,
        };
        let errors = DiscretisationErrors {
            values: known().map(value).collect(),
            eigenvalue: Some(eigenvalue),
            bodies: self.share(Some(error), convergence),
            ..self.known(finer.elements(), convergence)
        };
        (errors, relative)
    }
}

/// Error of a value in units of its change on elements of half the size, for an order of convergence.
fn extrapolation(order: f64) -> f64 {
    let ratio = order.exp2();
    ratio / (ratio - 1.0)
}
