use super::step_error::{StepError, argument};
use super::stepper::Stepper;
use crate::errors::{nearest, quoted};
use crate::results::Column;
use crate::simulate::{Summary, energy_warnings, turn_warning};

impl Stepper {
    /// Value of a column in the present state, such as `tip.y` or `motor.mz`.
    ///
    /// # Errors
    /// If there is no such column.
    pub fn read(&mut self, column: &str) -> Result<f64, StepError> {
        let number = self.column_number(column)?;
        Ok(self.row()[number])
    }

    pub(super) fn column_number(&self, column: &str) -> Result<usize, StepError> {
        let unknown = || {
            let expected = match nearest(column, self.columns.keys().map(String::as_str)) {
                Some(meant) => format!("the name of a column, perhaps {}", quoted(meant)),
                None => "the name of a column; a probe records further ones".to_owned(),
            };
            argument("column", quoted(column), &expected)
        };
        self.columns.get(column).copied().ok_or_else(unknown)
    }

    /// All columns of the present state, in the order of [`columns`](Self::columns).
    pub fn row(&mut self) -> &[f64] {
        if !self.is_row_current {
            self.is_row_current = true;
            let report = self.report;
            let values = [
                f64::from(report.iterations),
                report.residual,
                report.increment,
                report.drift,
                report.violation,
            ];
            let t = self.time();
            let Self { rows, dynamics, simulation, .. } = self;
            let exchange = Some(dynamics.energy_exchange());
            rows.set_step_start(dynamics.step_start());
            rows.fill(&simulation.assembly, dynamics.state(), t, &values, dynamics.energy(), exchange);
        }
        self.rows.last()
    }

    /// Columns of the rows, as of a run.
    pub fn columns(&self) -> Vec<Column> {
        self.simulation.columns()
    }

    /// Number of the column of a name.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.columns.get(name).copied()
    }

    /// Kinetic, strain and potential energy, work, dissipation and balance since the start, as the columns of these names.
    pub fn energies(&mut self) -> [(&'static str, f64); 6] {
        let names = ["kinetic", "strain", "potential", "work", "dissipated", "balance"];
        let numbers = names.map(|name| self.columns[name]);
        let row = self.row();
        std::array::from_fn(|i| (names[i], row[numbers[i]]))
    }

    /// Summary of all steps so far, with their warnings.
    pub fn summary(&self) -> Summary {
        let (scales, mut summary) = (self.simulation.scales(), self.summary.clone());
        summary.time = self.time();
        summary.warnings.extend(self.warnings_of_steps());
        summary.warnings.extend(turn_warning(&self.rows, "t", scales.time));
        summary
    }

    fn warnings_of_steps(&self) -> Vec<String> {
        let (assembly, scales) = (&self.simulation.assembly, self.simulation.scales());
        let settings = self.simulation.scaled.analysis.dynamics();
        let energy = settings
            .map(|own| energy_warnings(own, &self.simulation.scaled, &self.dynamics))
            .unwrap_or_default();
        let rotations = self.monitors.rotations.warning(assembly, scales);
        rotations.into_iter().chain(self.monitors.alternations.warning(scales)).chain(energy).collect()
    }
}
