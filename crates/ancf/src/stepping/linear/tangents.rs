use ancf_mechanics::functions::InputTransition;
use ancf_solver::dynamics::consistent_accelerations;
use ancf_solver::equations::{EquationsOfMotion, Level, State, System, Weights};
use ancf_solver::factor::Factor;
use ancf_solver::newton::{SolveError, SolveFailure};
use nalgebra::{DMatrix, DVector};

use super::input_derivatives::input_derivatives;
use super::null_space::null_space;
use crate::errors::quoted;
use crate::stepping::step_error::{StepError, argument};
use crate::stepping::stepper::Stepper;

/// Largest deviation of a derivative from finite differences, relative to the sum of the magnitudes of its parts.
const DEVIATION: f64 = 1e-3;

/// Linear equations at a state in solver units.
pub(super) struct Linearised {
    pub(super) s: State,
    pub(super) mass: DMatrix<f64>,
    pub(super) damping: DMatrix<f64>,
    pub(super) stiffness: DMatrix<f64>,
    pub(super) constraints: DMatrix<f64>,
    /// Forces −∂r/∂u of the inputs.
    pub(super) forces: DMatrix<f64>,
    /// Basis Z, and N of δv = Z η + N ξ. The last columns are coordinates of states of force laws.
    pub(super) basis: DMatrix<f64>,
    /// Number of columns that are motions: nothing depends on the coordinates of states, only on their rates.
    pub(super) positions: usize,
    pub(super) drift: DMatrix<f64>,
}

impl Stepper {
    /// Exact tangents, null space of the constraints, and forces of the inputs.
    pub(super) fn linear_equations(&self) -> Result<Linearised, StepError> {
        let eom = self.dynamics.equations();
        let mut s = self.dynamics.state().clone();
        let mut matrix = eom.matrix();
        consistent_accelerations(eom, &mut matrix, &mut s).map_err(|error| self.failed(error))?;
        let (n, m) = (s.q.len(), s.lambda.len());
        let mut dense = |s: &State, q: f64, v: f64, a: f64| {
            eom.tangent(s, Weights { q, v, a }, &mut matrix);
            let rows = matrix.dense();
            DMatrix::from_fn(n + m, n + m, |i, j| rows[i][j])
        };
        let (mass, damping) = (dense(&s, 0.0, 0.0, 1.0), dense(&s, 0.0, 1.0, 0.0));
        let of_coordinates = |k: &DMatrix<f64>| k.view((0, 0), (n, n)).into_owned();
        let constraints = mass.view((n, 0), (m, n)).into_owned();
        let mass = of_coordinates(&mass);
        type Entries = Vec<(usize, usize, f64)>;
        let complete = |k: &DMatrix<f64>, skew: Entries, omitted: Entries| {
            let mut sum = of_coordinates(k);
            for (i, j, value) in skew {
                sum[(i, j)] += value;
                sum[(j, i)] -= value;
            }
            omitted.into_iter().for_each(|(i, j, value)| sum[(i, j)] += value);
            sum
        };
        let damping = complete(&damping, eom.skew_damping(&s), eom.omitted_damping(&s));
        let mut stiffness_of =
            |s: &State| complete(&dense(s, 1.0, 0.0, 0.0), eom.skew_stiffness(s), eom.omitted_stiffness(s));
        let mut stiffness = stiffness_of(&s);
        if s.v.iter().any(|v| *v != 0.0) {
            let mut still = s.clone();
            still.v.fill(0.0);
            stiffness = self.complete_rate_stiffness(&s, stiffness, &stiffness_of(&still));
        }
        let basis = null_space(&constraints, &mass).ok_or_else(|| {
            argument("linearise", "a motion without mass", "bodies with mass in all free motions")
        })?;
        let joints = &self.simulation.assembly.joints;
        let states: Vec<usize> = joints.iter().flat_map(|joint| &joint.states).copied().collect();
        let (basis, positions) = states_last(&basis, &states);
        let forces = self.input_forces(&s)?;
        let rates = |moved: &State| {
            let mut rates = vec![0.0; m];
            eom.constraints(moved, Level::Velocity, &mut rates);
            DVector::from_vec(rates)
        };
        let mut drift = DMatrix::zeros(n, basis.ncols());
        if m > 0 && s.v.iter().any(|v| *v != 0.0) {
            let mut solver = ConstrainedSolver::new(eom, &s).map_err(|()| self.singular(&s))?;
            for j in 0..basis.ncols() {
                let rate = self.central(&s, &basis.column(j).into_owned(), None, rates);
                let change = solver.solve(&DVector::zeros(n), &-rate).map_err(|()| self.singular(&s))?;
                drift.set_column(j, &change.rows(0, n));
            }
        }
        Ok(Linearised { s, mass, damping, stiffness, constraints, forces, basis, positions, drift })
    }

    pub(super) fn singular(&self, s: &State) -> StepError {
        self.failed(SolveError::at(s.t, SolveFailure::Singular))
    }

    /// Forces −∂r/∂u of the inputs.
    fn input_forces(&self, s: &State) -> Result<DMatrix<f64>, StepError> {
        let (eom, signals) = (self.dynamics.equations(), &self.simulation.inputs);
        let mut floor = vec![0.0; s.q.len() + s.lambda.len()];
        eom.rounding(s, &mut floor);
        floor.truncate(s.q.len());
        let floor = DVector::from_vec(floor);
        let mut forces = DMatrix::zeros(s.q.len(), signals.len());
        for (j, signal) in signals.iter().enumerate() {
            let (own, value) = (signal.transition(), signal.at(s.t).value);
            let at = |h: f64| {
                signal.set(InputTransition { values: [value + h; 2], ..own });
                self.forces_at(s)
            };
            let change = input_derivatives(value, at, (|_: &DVector<f64>| floor.clone(), true));
            signal.set(own);
            let place = |i: usize| self.simulation.assembly.name_in(i, self.simulation.scales().length);
            let change =
                change.map_err(|i| self.not_differentiable(j, &format!("a force at {}", place(i))))?;
            forces.set_column(j, &-change);
        }
        Ok(forces)
    }

    /// Error of a quantity without a derivative by an input.
    pub(super) fn not_differentiable(&self, input: usize, what: &str) -> StepError {
        let name = self.inputs().nth(input).unwrap_or_default();
        let found = format!("{what} that is not differentiable by the input {} here", quoted(name));
        argument("linearise", found, "a value of the input away from kinks, jumps and the ends of domains")
    }

    /// Compares the derivatives of the forces along all free motions with finite differences.
    pub(super) fn check_derivatives(&self, of: &Linearised) -> Result<(), StepError> {
        let (eom, n) = (self.dynamics.equations(), of.s.q.len());
        let forces = |s: &State| self.forces_at(s);
        let mut floor = vec![0.0; n + of.s.lambda.len()];
        eom.rounding(&of.s, &mut floor);
        let zeros = DVector::zeros(n);
        for (matrix, is_stiffness) in [(&of.stiffness, true), (&of.damping, false)] {
            let magnitudes = matrix.abs();
            for z in of.basis.column_iter() {
                let z = z.into_owned();
                let found = match is_stiffness {
                    true => self.central(&of.s, &z, None, forces),
                    false => self.central(&of.s, &zeros, Some(&z), forces),
                };
                let expected = matrix * &z;
                let size = (&magnitudes * z.abs()).amax();
                let h = self.difference(&z);
                let wrong = (0..n).find(|&i| {
                    let rounding = 8.0 * floor[i] / h;
                    (found[i] - expected[i]).abs() > DEVIATION * size.max(found.amax()) + rounding
                });
                if let Some(i) = wrong {
                    let place = self.simulation.assembly.name_in(i, self.simulation.scales().length);
                    let found = format!(
                        "a force that is not differentiable here, or whose derivative is not symmetric, at {place}"
                    );
                    let expected = "a state away from the opening and closing of contacts, and forces with known derivatives";
                    return Err(argument("linearise", found, expected));
                }
            }
        }
        Ok(())
    }
}

/// Moves the columns of coordinates of states to the end of a basis. Returns also the number of the other columns.
fn states_last(basis: &DMatrix<f64>, states: &[usize]) -> (DMatrix<f64>, usize) {
    let is_state = |j: &usize| {
        let rows: Vec<usize> = (0..basis.nrows()).filter(|&i| basis[(i, *j)] != 0.0).collect();
        matches!(rows[..], [row] if states.contains(&row))
    };
    let (last, mut order): (Vec<usize>, Vec<usize>) = (0..basis.ncols()).partition(is_state);
    let positions = order.len();
    order.extend(last);
    (basis.select_columns(&order), positions)
}

/// Factors of [M, Φ_qᵀ; Φ_q, 0] in a state.
pub(super) struct ConstrainedSolver {
    matrix: ancf_solver::sparse::SparseMatrix,
    factor: Factor,
}

impl ConstrainedSolver {
    pub(super) fn new(eom: &System, s: &State) -> Result<Self, ()> {
        let mut matrix = eom.matrix();
        eom.tangent(s, Weights::MASS, &mut matrix);
        let mut factor = Factor::new(matrix.pattern()).map_err(|_| ())?;
        factor.factorise(&matrix).map_err(|_| ())?;
        Ok(Self { matrix, factor })
    }

    /// Solves for the right-hand sides of coordinates and multipliers. Contradictions of redundant constraints are ignored.
    pub(super) fn solve(
        &mut self,
        force: &DVector<f64>,
        constraint: &DVector<f64>,
    ) -> Result<DVector<f64>, ()> {
        let mut x: Vec<f64> = force.iter().chain(constraint.iter()).copied().collect();
        self.factor.solve_increment(&self.matrix, &mut x, &[]).map_err(|_| ())?;
        Ok(DVector::from_vec(x))
    }
}
