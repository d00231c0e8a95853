use std::io;
use std::ops::ControlFlow;

use ancf_solver::equations::State;
use ancf_solver::newton::Interrupt;

use crate::assembly::Assembly;
use crate::failure::{RunFailure, unloaded};
use crate::initial::{EquilibriumSearch, StartState};
use crate::model::{About, Model, Statics};
use crate::results::Column;
use crate::simulate::run::{AnalysisRun, RunResult};
use crate::units::{Dimension, Scales, UnitQuantity};

/// Upper limit on the relative residual of a mode.
pub(super) const MAX_RESIDUAL: f64 = 1e-3;

/// Columns of the solver for modes.
pub(crate) const MODE_COLUMNS: [&str; 4] = ["frequency", "squared", "residual", "frequency_error"];
/// Columns of the solver for damped modes.
pub(crate) const DAMPED_COLUMNS: [&str; 4] = ["frequency", "damping_ratio", "growth_rate", "residual"];
/// Columns of the solver for buckling.
pub(crate) const BUCKLING_COLUMNS: [&str; 3] = ["factor", "residual", "factor_error"];

/// Columns of shapes: number, columns of the solver, displacements of the probes.
pub(crate) fn columns(assembly: &Assembly, solver: &[&str]) -> Vec<Column> {
    let dimension = |name: &str| match name {
        "frequency" | "frequency_error" | "growth_rate" => Some(Dimension::RATE),
        "squared" => Some(Dimension::new(0, -2, 0)),
        "factor" | "factor_error" | "damping_ratio" => Some(Dimension::NUMBER),
        _ => None,
    };
    let mut columns = vec![Column::new("mode", None)];
    let quantity = |name: &str| match name {
        "frequency" | "frequency_error" => UnitQuantity::Frequency,
        _ => UnitQuantity::Other,
    };
    columns
        .extend(solver.iter().map(|&name| Column::new(name, dimension(name)).with_quantity(quantity(name))));
    for (probe, _) in &assembly.probes {
        columns.extend(["x", "y", "z"].map(|axis| Column::new(format!("{probe}.{axis}"), None)));
    }
    columns
}

/// Computes the state about which a model in solver units is linearised.
pub(super) fn state_about(
    (model, assembly, scales): (&Model, &Assembly, Scales),
    about: About,
    given: Option<&StartState>,
    interrupt: &Interrupt,
) -> Result<State, RunFailure> {
    if about == About::Reference {
        return Ok(unloaded(assembly));
    }
    let settings = &Statics::default();
    EquilibriumSearch { model, scales, assembly, settings, interrupt, given }.run(&mut |_, _| ())
}

impl AnalysisRun<'_> {
    /// Computes the state about which the model is linearised.
    pub(super) fn state_about(
        &mut self,
        model: &Model,
        about: About,
        given: Option<&StartState>,
    ) -> Result<State, RunFailure> {
        if about == About::Equilibrium {
            self.summary.initial = given.map(StartState::released);
        }
        state_about((model, self.assembly, self.summary.scales), about, given, self.interrupt)
    }

    pub(super) fn begin(&mut self, solver: &[&str]) -> io::Result<()> {
        let columns = columns(self.assembly, solver).into_iter().map(|column| column.name);
        self.observer.begin(&columns.collect::<Vec<_>>())
    }

    /// Records values and real shapes about a state.
    pub(super) fn shapes<'s>(
        &mut self,
        about: State,
        found: impl Iterator<Item = (Vec<f64>, &'s [f64])>,
    ) -> RunResult {
        self.complex_shapes(about, found.map(|(values, shape)| (values, [shape, &[]])))
    }

    /// Records values and shapes about a state. Velocities are the real part of a shape, accelerations its imaginary part. An empty
    /// imaginary part is zero.
    pub(super) fn complex_shapes<'s>(
        &mut self,
        mut about: State,
        found: impl Iterator<Item = (Vec<f64>, [&'s [f64]; 2])>,
    ) -> RunResult {
        // xᵀ M x = 1: with the unit of mass m, the unit of displacements is 1/√m.
        let scales = self.summary.scales;
        let mass = scales.force * scales.time.powi(2) / scales.length;
        let as_velocity = scales.time / scales.length / mass.sqrt();
        let mut found = found.enumerate().peekable();
        while let Some((number, (values, [shape, imaginary]))) = found.next() {
            let mut row = vec![(number + 1) as f64];
            row.extend(values);
            for (_, point) in &self.assembly.probes {
                row.extend(point.variation(&about, shape).iter().map(|x| x / mass.sqrt()));
            }
            about.v.iter_mut().zip(shape).for_each(|(v, x)| *v = x * as_velocity);
            about.a.fill(0.0);
            about.a.iter_mut().zip(imaginary).for_each(|(a, x)| *a = x * as_velocity * scales.time);
            self.summary.steps += 1;
            // A stop request at the last shape has no effect.
            if self.observer.record(&row, &about)?.is_break() && found.peek().is_some() {
                return Ok(Ok(ControlFlow::Break(())));
            }
        }
        Ok(Ok(ControlFlow::Continue(())))
    }
}
