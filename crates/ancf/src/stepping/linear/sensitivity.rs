use ancf_mechanics::functions::InputTransition;
use ancf_solver::equations::{EquationsOfMotion, Level, State};
use nalgebra::{DMatrix, DVector};

use super::input_derivatives::input_derivatives;
use super::tangents::{ConstrainedSolver, Linearised};
use crate::errors::quoted;
use crate::results::AngleRates;
use crate::simulate::COLUMNS;
use crate::stepping::step_error::{StepError, argument};
use crate::stepping::stepper::Stepper;

/// Rounding error of a column, relative to its value.
const ROUNDING: f64 = 16.0 * f64::EPSILON;
/// Columns that are no functions of the state.
const HISTORY: [&str; 4] = ["t", "work", "dissipated", "balance"];

/// Change of a state along a minimal coordinate or an input.
struct Change {
    q: DVector<f64>,
    v: DVector<f64>,
    a: DVector<f64>,
    lambda: DVector<f64>,
    /// Number of the input that changes by 1.
    input: Option<usize>,
}

impl Stepper {
    /// Numbers of columns that are functions of the state.
    pub(super) fn differentiable(&self, outputs: &[&str]) -> Result<Vec<usize>, StepError> {
        for name in outputs {
            if HISTORY.contains(name) || COLUMNS.contains(name) {
                let expected = "columns that are functions of the state and the inputs";
                return Err(argument("outputs", quoted(name), expected));
            }
        }
        outputs.iter().map(|name| self.column_number(name)).collect()
    }

    /// Derivatives of columns with respect to the minimal coordinates in solver units, and to the inputs.
    pub(super) fn output_matrices(
        &mut self,
        of: &Linearised,
        outputs: &[usize],
    ) -> Result<[DMatrix<f64>; 2], StepError> {
        let (count, inputs) = (of.positions + of.basis.ncols(), of.forces.ncols());
        let mut c = DMatrix::zeros(outputs.len(), count);
        let mut d = DMatrix::zeros(outputs.len(), inputs);
        self.row();
        if outputs.is_empty() {
            return Ok([c, d]);
        }
        let changes = self.changes(of)?;
        let history = self.rows.history();
        for (j, change) in changes.iter().enumerate() {
            let column = self.column_derivatives(&of.s, change, outputs);
            let column = column.map_err(|(input, at)| {
                let name = self.columns.iter().find(|(_, number)| **number == outputs[at]);
                let name = name.map_or_else(String::new, |(name, _)| quoted(name));
                self.not_differentiable(input, &format!("the column {name}"))
            })?;
            let to = if j < count { c.column_mut(j) } else { d.column_mut(j - count) };
            column.into_iter().zip(to).for_each(|(value, to)| *to = *value);
        }
        self.rows.restore(&history);
        self.is_row_current = false;
        self.row();
        Ok([c, d])
    }

    /// Consistent changes of positions, velocities, accelerations and multipliers: along ξ, η and the inputs.
    fn changes(&self, of: &Linearised) -> Result<Vec<Change>, StepError> {
        let (eom, n, m) = (self.dynamics.equations(), of.s.q.len(), of.s.lambda.len());
        let zeros = DVector::zeros(n);
        let mut solver = ConstrainedSolver::new(eom, &of.s).map_err(|()| self.singular(&of.s))?;
        let mut directions = Vec::new();
        for j in 0..of.positions {
            directions.push((of.basis.column(j).into_owned(), of.drift.column(j).into_owned(), None));
        }
        directions.extend(of.basis.column_iter().map(|z| (zeros.clone(), z.into_owned(), None)));
        directions.extend((0..of.forces.ncols()).map(|input| (zeros.clone(), zeros.clone(), Some(input))));
        let acceleration = |s: &State| constraint_acceleration(eom, s);
        let change = |(q, v, input): (DVector<f64>, DVector<f64>, Option<usize>)| {
            let mut force = -(&of.stiffness * &q + &of.damping * &v);
            let mut constraint = DVector::zeros(m);
            match input {
                Some(input) => force += of.forces.column(input),
                None => constraint -= self.central(&of.s, &q, Some(&v), acceleration),
            }
            let x = solver.solve(&force, &constraint).map_err(|()| self.singular(&of.s))?;
            Ok(Change { q, v, a: x.rows(0, n).into_owned(), lambda: x.rows(n, m).into_owned(), input })
        };
        directions.into_iter().map(change).collect()
    }

    /// Derivatives of columns along a change of the state: central differences along minimal coordinates. Returns the numbers of the
    /// input and of the column if there is none.
    fn column_derivatives(
        &mut self,
        s: &State,
        change: &Change,
        outputs: &[usize],
    ) -> Result<DVector<f64>, (usize, usize)> {
        let h = self.difference(&change.q).min(self.difference(&change.v));
        let value = change.input.map(|input| self.simulation.inputs[input].at(s.t).value);
        let mut at = |h: f64| {
            let mut there = s.clone();
            let parts = [&mut there.q, &mut there.v, &mut there.a, &mut there.lambda];
            for (x, by) in parts.into_iter().zip([&change.q, &change.v, &change.a, &change.lambda]) {
                x.iter_mut().zip(by.iter()).for_each(|(x, by)| *x += h * by);
            }
            DVector::from_vec(self.columns_at(&there, change.input.map(|input| (input, h)), outputs))
        };
        match change.input.zip(value) {
            Some((input, value)) => {
                let rounding = |values: &DVector<f64>| values.map(|x| ROUNDING * x.abs());
                input_derivatives(value, at, (rounding, false)).map_err(|column| (input, column))
            }
            None => Ok((at(h) - at(-h)) / (2.0 * h)),
        }
    }

    /// Columns in a state with a changed input.
    fn columns_at(&mut self, s: &State, input: Option<(usize, f64)>, outputs: &[usize]) -> Vec<f64> {
        let Self { rows, dynamics, simulation, .. } = self;
        let signal = input.map(|(number, by)| (&simulation.inputs[number], by));
        let own = signal.map(|(signal, by)| {
            let (own, value) = (signal.transition(), signal.at(s.t).value + by);
            signal.set(InputTransition { values: [value; 2], ..own });
            own
        });
        let energy = dynamics.equations().energy(s);
        rows.count_turns(s.t, s, AngleRates::Velocities);
        let exchange = Some(dynamics.energy_exchange());
        let row = rows.fill(&simulation.assembly, s, 0.0, &[0.0; COLUMNS.len()], energy, exchange);
        let values = outputs.iter().map(|&number| row[number]).collect();
        if let (Some((signal, _)), Some(own)) = (signal, own) {
            signal.set(own);
        }
        values
    }
}

/// Second derivative of the constraints, Φ_q a + (Φ_q v)_q v + Φ_tt.
fn constraint_acceleration(eom: &impl EquationsOfMotion, s: &State) -> DVector<f64> {
    let m = s.lambda.len();
    let at = |s: &State, level: Level| {
        let mut phi = vec![0.0; m];
        eom.constraints(s, level, &mut phi);
        DVector::from_vec(phi)
    };
    let accelerated = State { v: s.a.clone(), ..s.clone() };
    let resting = State { v: vec![0.0; s.v.len()], ..s.clone() };
    at(&accelerated, Level::Velocity) - at(&resting, Level::Velocity) + at(s, Level::Acceleration)
}
