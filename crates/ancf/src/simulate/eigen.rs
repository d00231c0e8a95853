use std::io;
use std::ops::ControlFlow;

use ancf_solver::eigen::{CriticalLoad, EigenError, Mode, buckling, modes};
use ancf_solver::equations::{EquationsOfMotion, State};
use ancf_solver::newton::SolveFailure;

use super::equilibria::{equilibrium, settled};
use super::run::{Ended, Reason, Run};
use crate::assembly::Assembly;
use crate::failure::unloaded;
use crate::model::{About, Buckling, Model, Modes};
use crate::results::Column;
use crate::units::Dimension;

/// Relative residual of what is no mode.
const WRONG: f64 = 1e-3;

/// The columns of modes and of critical loads.
pub(crate) const MODES: [&str; 3] = ["frequency", "squared", "residual"];
pub(crate) const BUCKLING: [&str; 1] = ["factor"];

/// The columns of shapes: their number, `own`, what probes move.
pub(crate) fn columns(assembly: &Assembly, own: &[&str]) -> Vec<Column> {
    let dimension = |name: &str| match name {
        "frequency" => Some(Dimension::RATE),
        "squared" => Some(Dimension::new(0, -2, 0)),
        _ => None,
    };
    let mut columns = vec![Column::new("mode", None)];
    columns.extend(own.iter().map(|&name| Column::new(name, dimension(name))));
    for (probe, _) in &assembly.probes {
        columns.extend(["x", "y", "z"].map(|axis| Column::new(format!("{probe}.{axis}"), None)));
    }
    columns
}

impl Run<'_> {
    fn state_about(&self, model: &Model, about: About) -> Result<State, Reason> {
        let start = unloaded(self.assembly);
        match (about, self.held(&start)) {
            (About::Reference, _) => Ok(start),
            (About::Equilibrium, Ok(())) => equilibrium(self.assembly, start, self.interrupt),
            (About::Equilibrium, Err(free)) => {
                // What nothing holds without loads may hang on them.
                let settled = settled(self.assembly, model, start, self.interrupt);
                let settled = settled.map_err(|error| match error.failure {
                    SolveFailure::Interrupted => error.into(),
                    _ => free,
                })?;
                self.held(&settled)?;
                match self.assembly.system.with_active_terms(&settled) {
                    Some(_) => equilibrium(self.assembly, settled, self.interrupt),
                    None => Ok(settled),
                }
            }
        }
    }

    /// Natural modes, one row each.
    pub(crate) fn modes(&mut self, model: &Model, settings: &Modes) -> Ended {
        self.begin(&MODES)?;
        let found = self.state_about(model, settings.about).and_then(|s| {
            let (system, count) = (&self.assembly.system, settings.count as usize);
            let found = match system.with_active_terms(&s) {
                Some((complete, matrix)) => modes(&complete, matrix, &s, count, self.interrupt)?,
                None => modes(system, system.matrix(), &s, count, self.interrupt)?,
            };
            Ok((s, found.modes))
        });
        let rate = self.summary.scales.time.recip();
        match found {
            // Not seen but where a motion without stiffness escaped notice: no result rather than a wrong one.
            Ok((_, found)) if found.iter().any(|mode| mode.residual > WRONG) => {
                Ok(Err(EigenError::NotConverged.into()))
            }
            Ok((about, found)) => self.shapes(
                about,
                found.iter().map(|mode| {
                    let Mode { omega_squared: squared, shape, residual } = mode;
                    let frequency = mode.frequency().map_or(f64::NAN, |frequency| frequency * rate);
                    (vec![frequency, squared * rate * rate, *residual], shape.as_slice())
                }),
            ),
            Err(reason) => Ok(Err(reason)),
        }
    }

    /// Critical loads, one row each.
    pub(crate) fn buckling(&mut self, settings: &Buckling) -> Ended {
        self.begin(&BUCKLING)?;
        let (system, s) = (&self.assembly.system, unloaded(self.assembly));
        let found = self.held(&s).and_then(|()| {
            let (count, sense) = (settings.count as usize, settings.sense.into());
            Ok(match system.with_active_terms(&s) {
                Some((complete, matrix)) => buckling(&complete, matrix, &s, count, sense, self.interrupt)?,
                None => buckling(system, system.matrix(), &s, count, sense, self.interrupt)?,
            })
        });
        match found {
            Ok(found) => self.shapes(
                s,
                found.iter().map(|CriticalLoad { factor, shape }| (vec![*factor], shape.as_slice())),
            ),
            Err(reason) => Ok(Err(reason)),
        }
    }

    fn begin(&mut self, own: &[&str]) -> io::Result<()> {
        let columns = columns(self.assembly, own).into_iter().map(|column| column.name);
        self.observer.begin(&columns.collect::<Vec<_>>())
    }

    /// Records numbers and shapes, motions about a state.
    fn shapes<'s>(&mut self, mut about: State, found: impl Iterator<Item = (Vec<f64>, &'s [f64])>) -> Ended {
        // xᵀ M x = 1: in a unit of mass m, displacements count in one over the root of m.
        let scales = self.summary.scales;
        let mass = scales.force * scales.time.powi(2) / scales.length;
        let as_velocity = scales.time / scales.length / mass.sqrt();
        let mut found = found.enumerate().peekable();
        while let Some((number, (own, shape))) = found.next() {
            let mut row = vec![(number + 1) as f64];
            row.extend(own);
            for (_, point) in &self.assembly.probes {
                row.extend(point.sum(shape).iter().map(|x| x / mass.sqrt()));
            }
            about.v.iter_mut().zip(shape).for_each(|(v, x)| *v = x * as_velocity);
            self.summary.steps += 1;
            // Who breaks on the last one has stopped nothing.
            if self.observer.record(&row, &about)?.is_break() && found.peek().is_some() {
                return Ok(Ok(ControlFlow::Break(())));
            }
        }
        Ok(Ok(ControlFlow::Continue(())))
    }
}
