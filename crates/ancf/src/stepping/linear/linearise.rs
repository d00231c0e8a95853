use ancf_solver::equations::{EquationsOfMotion, State};
use nalgebra::{DMatrix, DVector};

use super::linear_model::{DescriptorForm, LinearModel};
use super::tangents::Linearised;
use crate::errors::quoted;
use crate::initial::coordinate_units;
use crate::joints::JointEquations;
use crate::stepping::inputs::InputUse;
use crate::stepping::step_error::{StepError, argument};
use crate::stepping::stepper::Stepper;

/// Largest number of coordinates and multipliers of dense matrices.
const LARGEST: usize = 4000;
impl Stepper {
    /// Linearises the equations of motion about the present state, for all inputs and for the columns `outputs`.
    ///
    /// New settings of inputs are applied first, as the next step would do. The matrices follow from the exact tangents, the rank of
    /// the constraints from elimination with full pivoting. All derivatives of forces are compared with finite differences.
    ///
    /// # Errors
    /// If an input prescribes a motion, a column is no function of the state, a force is not differentiable, friction depends on a
    /// reaction, the model has more than 4000 unknowns, or a free motion has no mass.
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
        let has_friction = |joint: &&JointEquations| {
            joint.parts.iter().any(|part| !part.term.observed_multipliers().is_empty())
        };
        if let Some(joint) = self.simulation.assembly.joints.iter().find(has_friction) {
            let expected = "no friction by reactions: its derivatives by them are not assembled";
            let found = format!("the friction of joint {}", quoted(&joint.name));
            return Err(argument("linearise", found, expected));
        }
        let numbers = self.differentiable(outputs)?;
        let equations = self.linear_equations()?;
        self.check_derivatives(&equations)?;
        let [c, d] = self.output_matrices(&equations, &numbers)?;
        Ok(self.in_user_units(equations, outputs, [c, d]))
    }

    fn in_user_units(&self, of: Linearised, outputs: &[&str], [c, d]: [DMatrix<f64>; 2]) -> LinearModel {
        let (scales, units) =
            (self.simulation.scales(), coordinate_units(&self.simulation.assembly, self.simulation.scales()));
        let Linearised { s, mass, damping, stiffness, constraints, forces, basis, positions, drift } = of;
        let (count, n, t) = (basis.ncols(), s.q.len(), scales.time);
        // Unit of ξ: √mass × length.
        let unit = (scales.force * scales.length).sqrt() * t;
        let zt = basis.transpose();
        let reduced_stiffness = &zt * (&stiffness * &basis + &damping * &drift) / (t * t);
        let reduced_damping = &zt * (&damping * &basis) / t;
        let size = positions + count;
        let mut a = DMatrix::zeros(size, size);
        a.view_mut((0, positions), (positions, positions)).fill_with_identity();
        a.view_mut((positions, 0), (count, positions)).copy_from(&-reduced_stiffness.columns(0, positions));
        a.view_mut((positions, positions), (count, count)).copy_from(&-reduced_damping);
        let mut b = DMatrix::zeros(size, forces.ncols());
        b.view_mut((positions, 0), (count, forces.ncols())).copy_from(&(&zt * &forces * (unit / (t * t))));
        let mut c = c;
        c.view_mut((0, 0), (c.nrows(), positions)).scale_mut(unit.recip());
        c.view_mut((0, positions), (c.nrows(), count)).scale_mut(t / unit);
        let momenta = &zt * &mass;
        let rate = |x: &[f64], scale: f64| &momenta * DVector::from_column_slice(x) * scale;
        let mut x_rate = DVector::zeros(size);
        x_rate.rows_mut(0, positions).copy_from(&rate(&s.v, unit / t).rows(0, positions));
        x_rate.rows_mut(positions, count).copy_from(&rate(&s.a, unit / (t * t)));
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
            warnings: self.warnings_of_motion(&s).chain(self.warnings_of_contacts(&s)).collect(),
            a,
            b,
            c,
            d,
        }
    }

    /// Warning of a moving state. Its minimal coordinates belong to a fixed basis: those of a body that rotates by φ are sin φ.
    fn warnings_of_motion(&self, s: &State) -> impl Iterator<Item = String> {
        let is_moving = s.v.iter().any(|v| *v != 0.0);
        let text = "the state moves: the linear model describes deviations from the motion in coordinates of a fixed basis, and its \
                    poles are not the frequencies of a structure";
        is_moving.then(|| text.to_owned()).into_iter()
    }

    fn warnings_of_contacts(&self, s: &State) -> Option<String> {
        let count = self.dynamics.equations().acting_pairs(s).map_or(0, |pairs| pairs.len());
        let text = || {
            format!(
                "{count} contact points are closed: the linear model holds while the same ones are closed"
            )
        };
        (count > 0).then(text)
    }
}
