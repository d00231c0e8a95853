use nalgebra::{DMatrix, DVector};

use crate::stepping::step_error::{StepError, argument};
use crate::stepping::stepper::Stepper;

/// Linear model of a motion about a state, in the user's units:
///
/// ẋ = A x + B u,  y = C x + D u,
///
/// where x, u and y are deviations from the state, the inputs and the columns there. About a state that is no equilibrium, the constant
/// part of ẋ is left out.
///
/// The minimal coordinates x = (ξ, η) are ξ = Zᵀ M (q − q₀) and η = Zᵀ M (v − v₀), with a basis Z of the motions that the constraints
/// permit, Φ_q Z = 0 and Zᵀ M Z = I. Then ξ̇ = η, and a mode of the frequency ω is a pair of eigenvalues ±i ω of A. A state of a
/// force law is a further η, after those of the motions, without a ξ.
#[derive(Clone, Debug)]
pub struct LinearModel {
    /// State matrix A, of the size 2d + s of d degrees of freedom and s states of force laws.
    pub a: DMatrix<f64>,
    /// Input matrix B.
    pub b: DMatrix<f64>,
    /// Output matrix C.
    pub c: DMatrix<f64>,
    /// Feedthrough D.
    pub d: DMatrix<f64>,
    /// Names of the inputs u.
    pub inputs: Vec<String>,
    /// Names of the columns y.
    pub outputs: Vec<String>,
    /// Values of the inputs and of the columns in the state.
    pub input_values: Vec<f64>,
    /// Values of the columns.
    pub output_values: Vec<f64>,
    /// Rate ẋ in the state: zero in an equilibrium.
    pub rate: DVector<f64>,
    /// Basis Z of the changes of the coordinates of the complete state.
    pub basis: DMatrix<f64>,
    /// Projection Zᵀ M: ξ = Zᵀ M (q − q₀) for the coordinates of the complete state.
    pub projection: DMatrix<f64>,
    /// Descriptor form in the coordinates q of the complete state.
    pub descriptor: DescriptorForm,
    /// Time of the state.
    pub time: f64,
    /// Coordinates q₀ and velocities v₀ of the state.
    pub coordinates: Vec<f64>,
    /// Velocities of the state.
    pub velocities: Vec<f64>,
    /// Restrictions of the validity.
    pub warnings: Vec<String>,
}

/// Linear equations in redundant coordinates:
///
/// M δq̈ + C δq̇ + K δq + Gᵀ δλ = F δu,  G δq = 0.
///
/// The coordinates are those of the complete state. Multipliers have units in which M, C, K and G are consistent: those of force for
/// constraints of lengths in the user's units.
#[derive(Clone, Debug)]
pub struct DescriptorForm {
    /// Mass matrix M.
    pub mass: DMatrix<f64>,
    /// Damping matrix C.
    pub damping: DMatrix<f64>,
    /// Stiffness matrix K, not symmetric with follower loads.
    pub stiffness: DMatrix<f64>,
    /// Jacobian matrix G of the constraints, in rows without dimension or of lengths.
    pub constraints: DMatrix<f64>,
    /// Input matrix F.
    pub inputs: DMatrix<f64>,
}

impl LinearModel {
    /// Minimal coordinates x of the present state of a stepper of the same model.
    ///
    /// # Errors
    /// If the stepper has another number of coordinates.
    pub fn state_of(&self, stepper: &Stepper) -> Result<DVector<f64>, StepError> {
        let state = stepper.state();
        let n = self.projection.ncols();
        if state.coordinates.len() != n {
            return Err(argument("state", state.coordinates.len(), &format!("{n} coordinates")));
        }
        let d = self.projection.nrows();
        let positions = self.a.nrows() - d;
        let difference = |now: &[f64], then: &[f64]| {
            &self.projection * DVector::from_iterator(n, now.iter().zip(then).map(|(a, b)| a - b))
        };
        let mut x = DVector::zeros(positions + d);
        let of_positions = difference(&state.coordinates, &self.coordinates);
        x.rows_mut(0, positions).copy_from(&of_positions.rows(0, positions));
        x.rows_mut(positions, d).copy_from(&difference(&state.velocities, &self.velocities));
        Ok(x)
    }
}
