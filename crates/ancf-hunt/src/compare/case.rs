use std::ops::Range;

use ancf::Model;
use ancf::model::{
    Analysis, Body, Cylindrical, Joint, Planar, PointOnLine, Prismatic, Revolute, Slide, Spherical, Stop,
    Universal,
};

use super::magnitudes::Magnitudes;
use crate::run::{Record, Run, run};

/// Relative change of the properties of the neighbour of a model.
pub(super) const NUDGE: f64 = 1e-11;
/// Deviation of a neighbour, relative to the magnitude, up to which rows are compared.
const LARGEST_SPREAD: f64 = 1e-8;

/// Model with its run and the run of a neighbour, a model with properties that differ in the eleventh digit.
#[derive(Clone, Debug)]
pub struct Case {
    /// Model.
    pub model: Model,
    /// Run of the model.
    pub base: Run,
    /// Run of the neighbour; as the base in cases without rows.
    pub neighbour: Run,
    /// Magnitudes of the quantities of the run.
    pub magnitudes: Magnitudes,
}

impl Case {
    /// Runs a model and its neighbour.
    pub fn new(model: Model) -> Self {
        let base = run(&model);
        let neighbour = if base.verdict.is_finished() { run(&nudged(&model, NUDGE)) } else { base.clone() };
        let magnitudes = Magnitudes::new(&model, &base);
        Self { model, base, neighbour, magnitudes }
    }

    /// True for dynamics.
    pub fn is_dynamic(&self) -> bool {
        self.model.analysis.dynamics().is_some()
    }

    /// True if the friction of a joint is proportional to its reaction.
    pub fn rubs_by_reaction(&self) -> bool {
        let coefficient = |joint: &Joint| match joint {
            Joint::Revolute(Revolute { friction, .. })
            | Joint::Spherical(Spherical { friction, .. })
            | Joint::Universal(Universal { friction, .. }) => friction.map(|friction| friction.coefficient),
            Joint::Prismatic(Prismatic { friction, .. })
            | Joint::Cylindrical(Cylindrical { friction, .. })
            | Joint::Planar(Planar { friction, .. })
            | Joint::PointOnLine(PointOnLine { friction, .. })
            | Joint::Slide(Slide { friction, .. }) => friction.map(|friction| friction.coefficient),
            _ => None,
        };
        self.model.joints.iter().filter_map(coefficient).any(|coefficient| coefficient > 0.0)
    }

    /// True for steps by error control.
    pub fn has_controlled_steps(&self) -> bool {
        self.model.analysis.dynamics().is_some_and(|own| own.step.fixed().is_none())
    }

    /// Relative tolerance of twins, larger if the convergence criterion is coarse.
    pub fn tolerance(&self, relative: f64) -> f64 {
        let stop = match &self.model.analysis {
            Analysis::Dynamics(dynamics) => dynamics.stop,
            Analysis::Statics(statics) => statics.stop,
            Analysis::Path(path) => path.stop,
            Analysis::Modes(_) | Analysis::Buckling(_) => return relative,
        };
        match stop {
            Stop::Energy { tolerance } if tolerance < 1e-10 => relative,
            _ => 1e3 * relative,
        }
    }

    /// Deviation of the neighbour from the base in a row.
    pub fn spread(&self, column: &Record, neighbour: Option<&Record>, row: usize) -> f64 {
        let other = neighbour.and_then(|record| record.values.get(row));
        other.map_or(0.0, |other| (column.values[row] - other).abs()).min(f64::MAX)
    }

    /// Rows in which a twin is compared with the base; `None` if there are none.
    ///
    /// In statics and on paths the increments may differ, hence only the last row counts. A path may end before its last load
    /// factor by the number of its points, which lie elsewhere if an increment took another number of iterations. Rows of a
    /// motion count until the neighbour departs.
    pub fn shared_rows(&self, twin: &Run) -> Option<Range<usize>> {
        let rows = self.base.rows().min(self.neighbour.rows());
        match &self.model.analysis {
            Analysis::Statics(_) | Analysis::Path(_) => {
                let is_same = twin.rows() == rows && self.base.rows() == rows;
                let is_comparable = self.has_reached_load() || same_iterations(&self.base, twin);
                (is_same && is_comparable && rows > 0 && !self.is_unstable()).then(|| rows - 1..rows)
            }
            Analysis::Modes(_) | Analysis::Buckling(_) => Some(0..rows.min(twin.rows())),
            Analysis::Dynamics(_) => Some(0..self.calm_rows(rows.min(twin.rows()))),
        }
    }

    /// True if the last load factor is that of the analysis.
    fn has_reached_load(&self) -> bool {
        let Analysis::Path(path) = &self.model.analysis else { return true };
        self.base.column("load").and_then(|column| column.values.last()) == Some(&path.load)
    }

    /// True if a row has negative eigenvalues: other branches of equilibria are near.
    fn is_unstable(&self) -> bool {
        let counts = self.base.column("unstable").map_or(&[][..], |column| &column.values);
        counts.iter().any(|count| *count != 0.0 && !count.is_nan())
    }

    /// Rows before the neighbour departs from the base.
    fn calm_rows(&self, rows: usize) -> usize {
        (0..rows)
            .find(|&row| {
                self.base.columns.iter().any(|column| {
                    let Some(dimension) = column.dimension else { return false };
                    let spread = self.spread(column, self.neighbour.column(&column.name), row);
                    spread > LARGEST_SPREAD * self.magnitudes.of(dimension)
                })
            })
            .unwrap_or(rows)
    }
}

/// True if all increments took the same numbers of iterations.
fn same_iterations(base: &Run, twin: &Run) -> bool {
    let counts = |run: &Run| run.column("iterations").map(|column| column.values.clone());
    counts(base) == counts(twin)
}

/// Model with properties that differ by a relative change of this size.
pub(super) fn nudged(model: &Model, nudge: f64) -> Model {
    let mut model = model.clone();
    for material in model.materials.values_mut() {
        material.young *= 1.0 + nudge;
        material.density *= 1.0 - 0.7 * nudge;
    }
    for body in &mut model.bodies {
        match body {
            Body::Rigid(rigid) => rigid.mass *= 1.0 + 0.6 * nudge,
            Body::Mass(mass) => mass.mass *= 1.0 + 0.6 * nudge,
            Body::Beam(_) | Body::Cable(_) | Body::Shell(_) | Body::ShearShell(_) => {}
        }
    }
    model.gravity = model.gravity.map(|x| x * (1.0 + 0.4 * nudge));
    model
}
