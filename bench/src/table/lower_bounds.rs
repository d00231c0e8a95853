//! Lower bounds of the work per element: floating-point operations and bytes, counted from the formulas.
//!
//! A multiply-add counts as two operations. Counts are those of the straightforward algorithm, with an accuracy of about 20 %.

/// Coordinates of a node of a beam.
const NODE: f64 = 12.0;
/// Integration points along the axis.
const POINTS: f64 = 5.0;
/// Operations of a scalar product of two 3-vectors, or of adding a multiple of a 3-vector.
const VECTOR: f64 = 6.0;
/// Operations of adding a multiple of a 3 × 3 matrix.
const MATRIX: f64 = 18.0;
/// Bytes of a number.
const BYTES: f64 = 8.0;

/// Operations of the residual of a beam element with 24 coordinates.
///
/// At each point: five gradients with twelve contributions (four of the axis, two each of y, z and their derivatives), and back;
/// fifteen strains g0·u + u·g0 + u·u; fifteen resultants by a law that couples three of them; five forces of five resultants
/// each. In addition M a with 4 × 4 + 2 × 2 + 2 × 2 entries, and the weight.
pub fn force() -> f64 {
    let (directors, strains, resultants, forces) =
        (2.0 * 12.0 * VECTOR, 15.0 * 2.0 * VECTOR, 15.0 + 2.0 * 3.0, 25.0 * VECTOR);
    POINTS * (directors + strains + resultants + forces) + 24.0 * VECTOR + 4.0 * VECTOR
}

/// Operations of residual and tangent.
///
/// At each point in addition: fifteen blocks of about four dyads each; rows of the four vectors with two contributions, each
/// combined with five gradients; 36 lower blocks with 1.5 contributions on average.
pub fn force_and_tangent() -> f64 {
    let (blocks, rows, spread) = (15.0 * 4.0 * MATRIX, 4.0 * 2.0 * 5.0 * MATRIX, 36.0 * 1.5 * MATRIX);
    force() + POINTS * (blocks + rows + spread) + 36.0 * 3.0
}

/// Operations of the factorisation L D Lᵀ of a chain of nodes with b coordinates, and one solution.
///
/// Per node: b³/3 for its own block, b³ for the coupling block, b³ for the update of the next node; 6 b² for forward and backward
/// substitution, 8 b² for the residual of the solution.
pub fn equations() -> f64 {
    7.0 / 3.0 * NODE.powi(3) + 14.0 * NODE.powi(2)
}

/// Bytes of the lower triangle of the matrix per node: its own block and the block with the next node.
fn matrix() -> f64 {
    BYTES * (NODE * (NODE + 1.0) / 2.0 + NODE * NODE)
}

/// Bytes moved by scattering: 300 entries of an element and their indices, of half the size; the matrix, cleared, read and
/// written.
pub fn scattered() -> f64 {
    1.5 * BYTES * 300.0 + 3.0 * matrix()
}

/// Bytes moved by a factorisation and a solution without cache: the matrix read twice, for factorisation and residual; the
/// factor written (read before by the cache) and read twice.
pub fn factorised() -> f64 {
    6.0 * matrix()
}

/// Operations of a step with a number of iterations, each with residual, tangent and solution, and a final residual.
pub fn step(iterations: f64) -> f64 {
    iterations * (force_and_tangent() + equations()) + force()
}

/// Bytes moved by a step with a number of iterations without cache: the matrix assembled (cleared, read, written) and factorised;
/// state and work vectors, about ten with the coordinates of a node read or written.
pub fn step_bytes(iterations: f64) -> f64 {
    iterations * (3.0 * matrix() + factorised() + 10.0 * NODE * BYTES)
}
