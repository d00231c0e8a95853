use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::{DETERMINED, solve_with_skew_part};
use crate::newton::{LinearSolution, SolveFailure, StateUpdate};
use crate::sparse::SparseMatrix;
use crate::vectors::dot;

/// Direction in the space of states and load factors, with its dual in the metric of the path.
#[derive(Clone, Debug)]
pub(crate) struct PathTangent {
    /// Derivative dz/dσ of coordinates and multipliers.
    pub(crate) z: Vec<f64>,
    /// Derivative ds/dσ of the load factor s.
    pub(crate) load: f64,
    /// Dual ½ w M dq/dσ.
    dual: Vec<f64>,
}

impl PathTangent {
    pub(crate) fn zero(size: usize) -> Self {
        Self { z: vec![0.0; size], load: 0.0, dual: Vec::new() }
    }

    /// Returns the inner product of the coordinates with those of a vector, which may also contain multipliers.
    fn along(&self, z: &[f64]) -> f64 {
        dot(&self.dual, &z[..self.dual.len()])
    }

    /// Returns the inner product with another direction in the metric.
    pub(crate) fn product(&self, other: &Self) -> f64 {
        self.along(&other.z) + 0.5 * self.load * other.load
    }

    /// Returns the distance between two states along this direction.
    pub(crate) fn length(&self, from: &State, to: &State) -> f64 {
        let moved: Vec<f64> = to.q.iter().zip(&from.q).map(|(to, from)| to - from).collect();
        self.along(&moved) + 0.5 * self.load * (to.load - from.load)
    }

    /// Moves a state by a length along this direction.
    pub(crate) fn move_by(&self, length: f64, s: &mut State) {
        let (q, lambda) = self.z.split_at(s.q.len());
        s.q.iter_mut().zip(q).for_each(|(q, z)| *q += length * z);
        s.lambda.iter_mut().zip(lambda).for_each(|(lambda, z)| *lambda += length * z);
        s.load += length * self.load;
    }
}

/// Metric of the arc length of an equilibrium path, dσ² = ½ (w dqᵀ M dq + ds²).
///
/// The mass matrix gives a mean square of displacements, independent of units, slope coordinates and frame. The weight
/// w is the inverse square of the norm of dq/ds at the start of the path. At the start dσ = ds, with equal shares of
/// both terms.
#[derive(Debug)]
pub(crate) struct Metric {
    mass: SparseMatrix,
    weight: f64,
}

impl Metric {
    /// Creates the metric at a state with the given dz/ds. Without moving mass the metric reduces to ds.
    ///
    /// `refined` is the response after a further step of refinement. Where joints carry all loads, the responses are rounding
    /// errors, which change by their own size: nothing moves.
    pub(crate) fn new(
        eom: &dyn EquationsOfMotion,
        s: &State,
        mut mass: SparseMatrix,
        [response, refined]: [&[f64]; 2],
    ) -> Self {
        eom.tangent(s, Weights::MASS, &mut mass);
        let mut metric = Self { mass, weight: 1.0 };
        let square = |z: &[f64]| dot(&metric.mass_times(z, s.q.len()), &z[..s.q.len()]);
        let difference: Vec<f64> = response.iter().zip(refined).map(|(a, b)| a - b).collect();
        let (size, rounding) = (square(response), square(&difference));
        let is_motion = size > 0.0 && rounding < DETERMINED * DETERMINED * size;
        metric.weight = if is_motion { 1.0 / size } else { 0.0 };
        metric
    }

    /// Returns the straight-line distance between two states.
    pub(crate) fn distance(&self, from: &State, to: &State) -> f64 {
        let mut moved: Vec<f64> = to.q.iter().zip(&from.q).map(|(to, from)| to - from).collect();
        moved.resize(to.q.len() + to.lambda.len(), 0.0);
        let dual = self.mass_times(&moved, to.q.len());
        let square = self.weight * dot(&dual, &moved[..dual.len()]);
        (0.5 * (square + (to.load - from.load).powi(2))).sqrt()
    }

    /// Returns M dq for the coordinates of z.
    fn mass_times(&self, z: &[f64], coordinates: usize) -> Vec<f64> {
        let mut moved = z.to_vec();
        moved[coordinates..].fill(0.0);
        let mut product = self.mass.times(&moved);
        product.truncate(coordinates);
        product
    }

    /// Returns the unit tangent along dz/ds = `response` in the direction of increasing load.
    pub(crate) fn tangent(&self, response: Vec<f64>, coordinates: usize) -> PathTangent {
        let mut dual = self.mass_times(&response, coordinates);
        dual.iter_mut().for_each(|x| *x *= 0.5 * self.weight);
        let mut tangent = PathTangent { z: response, load: 1.0, dual };
        let length = tangent.product(&tangent).sqrt();
        tangent.scale(1.0 / length);
        tangent
    }
}

impl PathTangent {
    /// Multiplies the direction by a number; −1 reverses it.
    pub(crate) fn scale(&mut self, by: f64) {
        self.z.iter_mut().chain(&mut self.dual).for_each(|x| *x *= by);
        self.load *= by;
    }
}

/// Update within the plane normal to a tangent with free load factor: z = δ + ds dz/ds with τ·(z, ds) = 0.
///
/// Two solutions with the symmetric factor replace the solution of the bordered matrix.
///
/// Source: Keller (1977), Riks (1979) for the plane; Crisfield (1981) for the two solutions.
#[derive(Debug)]
pub(crate) struct PlaneUpdate<'a>(pub(crate) &'a PathTangent);

impl StateUpdate for PlaneUpdate<'_> {
    fn apply(&mut self, at: LinearSolution<'_>, s: &mut State, w: Weights) -> Result<(), SolveFailure> {
        let LinearSolution { eom, matrix, factor, z, .. } = at;
        let mut response = eom.load_force(s);
        solve_with_skew_part(&eom.skew_stiffness(s), &mut response, &mut |x| factor.solve(matrix, x))
            .map_err(|_| SolveFailure::Singular)?;
        let tangent = self.0;
        let load = -tangent.along(z) / (tangent.along(&response) + 0.5 * tangent.load);
        z.iter_mut().zip(&response).for_each(|(z, response)| *z += load * response);
        s.add(z, w);
        s.load += load;
        Ok(())
    }
}
