use ancf_mechanics::functions::InputTransition;
use ancf_solver::dynamics::consistent_accelerations;
use ancf_solver::equations::{EquationsOfMotion, Level, State, System, Weights};
use ancf_solver::factor::Factor;
use ancf_solver::newton::{SolveError, SolveFailure};
use nalgebra::{DMatrix, DVector};

use super::inputs::InputUse;
use super::linear_model::{DescriptorForm, LinearModel};
use super::null_space::null_space;
use super::step_error::{StepError, argument};
use super::stepper::Stepper;
use crate::errors::quoted;
use crate::initial::coordinate_units;

/// Largest number of coordinates and multipliers of dense matrices.
const LARGEST: usize = 4000;
/// Displacement of finite differences, relative to the length of the model.
const DIFFERENCE: f64 = 1e-6;
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
    /// Basis Z, and N of δv = Z η + N ξ.
    pub(super) basis: DMatrix<f64>,
    pub(super) drift: DMatrix<f64>,
}

impl Stepper {
    /// Linearises the equations of motion about the present state, for all inputs and for the columns `outputs`.
    ///
    /// New settings of inputs are applied first, as the next step would do. The matrices follow from the exact tangents, the rank of
    /// the constraints from elimination with full pivoting. All derivatives of forces are compared with finite differences.
    ///
    /// # Errors
    /// If an input prescribes a motion, a column is no function of the state, a force is not differentiable, the model has more than
    /// 4000 unknowns, or a free motion has no mass.
    pub fn linearise(&mut self, outputs: &[&str]) -> Result<LinearModel, StepError> {
        self.apply_inputs()?;
        let size = self.dynamics.equations().coordinates() + self.dynamics.equations().multipliers();
        if size > LARGEST {
            let expected = format!("a model of at most {LARGEST} coordinates and multipliers");
            return Err(argument("linearise", size, &expected));
        }
        let driving =
            self.inputs().find(|name| InputUse::of(&self.simulation.scaled, name) != InputUse::Load);
        if let Some(name) = driving {
            let expected =
                "inputs of loads only: the motion depends on the rates of an input that prescribes a motion";
            return Err(argument("linearise", format!("the drive input {}", quoted(name)), expected));
        }
        let numbers = self.differentiable(outputs)?;
        let equations = self.linear_equations()?;
        self.check_derivatives(&equations)?;
        let [c, d] = self.output_matrices(&equations, &numbers)?;
        Ok(self.in_user_units(equations, outputs, [c, d]))
    }

    /// Exact tangents, null space of the constraints, and forces of the inputs.
    fn linear_equations(&self) -> Result<Linearised, StepError> {
        let eom = self.dynamics.equations();
        let mut s = self.dynamics.state().clone();
        let mut matrix = eom.matrix();
        consistent_accelerations(eom, &mut matrix, &mut s).map_err(|error| self.failed(error))?;
        let (n, m) = (s.q.len(), s.lambda.len());
        let mut dense = |q: f64, v: f64, a: f64| {
            eom.tangent(&s, Weights { q, v, a }, &mut matrix);
            let rows = matrix.dense();
            DMatrix::from_fn(n + m, n + m, |i, j| rows[i][j])
        };
        let (mass, damping, stiffness) = (dense(0.0, 0.0, 1.0), dense(0.0, 1.0, 0.0), dense(1.0, 0.0, 0.0));
        let of_coordinates = |k: &DMatrix<f64>| k.view((0, 0), (n, n)).into_owned();
        let constraints = mass.view((n, 0), (m, n)).into_owned();
        let (mass, damping) = (of_coordinates(&mass), of_coordinates(&damping));
        let mut stiffness = of_coordinates(&stiffness);
        for (i, j, value) in eom.skew_stiffness(&s) {
            stiffness[(i, j)] += value;
            stiffness[(j, i)] -= value;
        }
        let basis = null_space(&constraints, &mass).ok_or_else(|| {
            argument("linearise", "a motion without mass", "bodies with mass in all free motions")
        })?;
        let forces = self.input_forces(&s);
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
        Ok(Linearised { s, mass, damping, stiffness, constraints, forces, basis, drift })
    }

    pub(super) fn singular(&self, s: &State) -> StepError {
        self.failed(SolveError::at(s.t, SolveFailure::Singular))
    }

    /// Step of finite differences along a direction.
    pub(super) fn difference(&self, direction: &DVector<f64>) -> f64 {
        DIFFERENCE * self.simulation.scaled.length() / direction.amax().max(f64::MIN_POSITIVE)
    }

    /// Central difference of a function along directions of positions and of velocities.
    pub(super) fn central(
        &self,
        s: &State,
        dq: &DVector<f64>,
        dv: Option<&DVector<f64>>,
        of: impl Fn(&State) -> DVector<f64>,
    ) -> DVector<f64> {
        let h = dv.map_or_else(|| self.difference(dq), |dv| self.difference(dq).min(self.difference(dv)));
        let moved = |h: f64| {
            let mut there = s.clone();
            there.q.iter_mut().zip(dq.iter()).for_each(|(q, dq)| *q += h * dq);
            if let Some(dv) = dv {
                there.v.iter_mut().zip(dv.iter()).for_each(|(v, dv)| *v += h * dv);
            }
            of(&there)
        };
        (moved(h) - moved(-h)) / (2.0 * h)
    }

    /// Forces −∂r/∂u of the inputs, which are affine in u.
    fn input_forces(&self, s: &State) -> DMatrix<f64> {
        let (eom, signals) = (self.dynamics.equations(), &self.simulation.inputs);
        let residual = || {
            let mut r = vec![0.0; s.q.len() + s.lambda.len()];
            eom.residual(s, &mut r);
            DVector::from_vec(r)
        };
        let mut forces = DMatrix::zeros(s.q.len(), signals.len());
        for (j, signal) in signals.iter().enumerate() {
            let own = signal.transition();
            let (value, h) = (signal.at(s.t).value, signal.at(s.t).value.abs().max(1.0));
            let at = |value: f64| {
                signal.set(InputTransition { values: [value; 2], ..own });
                residual()
            };
            let change = (at(value - h) - at(value + h)) / (2.0 * h);
            signal.set(own);
            forces.set_column(j, &change.rows(0, s.q.len()));
        }
        forces
    }

    /// Compares the derivatives of the forces along all free motions with finite differences.
    fn check_derivatives(&self, of: &Linearised) -> Result<(), StepError> {
        let (eom, n) = (self.dynamics.equations(), of.s.q.len());
        let residual = |s: &State| {
            let mut r = vec![0.0; n + s.lambda.len()];
            eom.residual(s, &mut r);
            DVector::from_vec(r).rows(0, n).into_owned()
        };
        let mut floor = vec![0.0; n + of.s.lambda.len()];
        eom.rounding(&of.s, &mut floor);
        let zeros = DVector::zeros(n);
        for (matrix, is_stiffness) in [(&of.stiffness, true), (&of.damping, false)] {
            let magnitudes = matrix.abs();
            for z in of.basis.column_iter() {
                let z = z.into_owned();
                let found = match is_stiffness {
                    true => self.central(&of.s, &z, None, residual),
                    false => self.central(&of.s, &zeros, Some(&z), residual),
                };
                let expected = matrix * &z;
                let size = (&magnitudes * z.abs()).amax();
                let h = self.difference(&z);
                let wrong = (0..n).find(|&i| {
                    let rounding = 8.0 * floor[i] / h;
                    (found[i] - expected[i]).abs() > DEVIATION * size.max((&found).amax()) + rounding
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

    fn in_user_units(&self, of: Linearised, outputs: &[&str], [c, d]: [DMatrix<f64>; 2]) -> LinearModel {
        let (scales, units) =
            (self.simulation.scales(), coordinate_units(&self.simulation.assembly, self.simulation.scales()));
        let Linearised { s, mass, damping, stiffness, constraints, forces, basis, drift } = of;
        let (count, n, t) = (basis.ncols(), s.q.len(), scales.time);
        // Unit of ξ: √mass × length.
        let unit = (scales.force * scales.length).sqrt() * t;
        let zt = basis.transpose();
        let reduced_stiffness = &zt * (&stiffness * &basis + &damping * &drift) / (t * t);
        let reduced_damping = &zt * (&damping * &basis) / t;
        let mut a = DMatrix::zeros(2 * count, 2 * count);
        a.view_mut((0, count), (count, count)).fill_with_identity();
        a.view_mut((count, 0), (count, count)).copy_from(&-reduced_stiffness);
        a.view_mut((count, count), (count, count)).copy_from(&-reduced_damping);
        let mut b = DMatrix::zeros(2 * count, forces.ncols());
        b.view_mut((count, 0), (count, forces.ncols())).copy_from(&(&zt * &forces * (unit / (t * t))));
        let mut c = c;
        c.view_mut((0, 0), (c.nrows(), count)).scale_mut(unit.recip());
        c.view_mut((0, count), (c.nrows(), count)).scale_mut(t / unit);
        let momenta = &zt * &mass;
        let rate = |x: &[f64], scale: f64| &momenta * DVector::from_column_slice(x) * scale;
        let mut x_rate = DVector::zeros(2 * count);
        x_rate.rows_mut(0, count).copy_from(&rate(&s.v, unit / t));
        x_rate.rows_mut(count, count).copy_from(&rate(&s.a, unit / (t * t)));
        let of_coordinates = |k: DMatrix<f64>, energy: f64| {
            DMatrix::from_fn(n, n, |i, j| k[(i, j)] * energy / (units[i] * units[j]))
        };
        let energy = scales.force * scales.length;
        let state = self.state();
        let descriptor = DescriptorForm {
            mass: of_coordinates(mass, energy * t * t),
            damping: of_coordinates(damping, energy * t),
            stiffness: of_coordinates(stiffness, energy),
            constraints: DMatrix::from_fn(constraints.nrows(), n, |i, j| constraints[(i, j)] / units[j]),
            inputs: DMatrix::from_fn(n, forces.ncols(), |i, j| forces[(i, j)] * energy / units[i]),
        };
        let row = self.rows.last();
        LinearModel {
            inputs: self.inputs().map(str::to_owned).collect(),
            outputs: outputs.iter().map(|&name| name.to_owned()).collect(),
            input_values: self.simulation.inputs.iter().map(|input| input.at(s.t).value).collect(),
            output_values: outputs.iter().map(|&name| row[self.columns[name]]).collect(),
            rate: x_rate,
            basis: DMatrix::from_fn(n, count, |i, j| basis[(i, j)] * units[i] / unit),
            projection: DMatrix::from_fn(count, n, |i, j| momenta[(i, j)] * unit / units[j]),
            descriptor,
            time: state.time,
            coordinates: state.coordinates,
            velocities: state.velocities,
            warnings: self.warnings_of_contacts(&s),
            a,
            b,
            c,
            d,
        }
    }

    fn warnings_of_contacts(&self, s: &State) -> Vec<String> {
        let count = self.dynamics.equations().acting_pairs(s).map_or(0, |pairs| pairs.len());
        let text = || {
            format!(
                "{count} contact points are closed: the linear model holds while the same ones are closed"
            )
        };
        (count > 0).then(text).into_iter().collect()
    }
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
