//! What the work of an element takes at least: floating-point operations and bytes, counted by hand from the formulas.
//!
//! A product with a sum is two operations. Counts are those of the algorithm as it stands in its plain form; they are good to a
//! fifth, enough to see how far from the machine's best a row is.

/// Coordinates of a node of the beam.
const NODE: f64 = 12.0;
/// Points along the axis.
const POINTS: f64 = 5.0;
/// A product of two 3-vectors, or a multiple of one added to another.
const VECTOR: f64 = 6.0;
/// A multiple of a 3 × 3 matrix added to another.
const MATRIX: f64 = 18.0;
/// Size of a number.
const BYTES: f64 = 8.0;

/// Operations of the residual of a 24-coordinate beam element.
///
/// At each point: five directors of twelve parts (four of the axis, two of each of y, z and their derivatives), and back; fifteen
/// strains g0·u + u·g0 + u·u; fifteen resultants by a law that couples three of them; five forces of five resultants each.
/// Besides M a, with 4 × 4 + 2 × 2 + 2 × 2 entries, and the weight.
pub fn force() -> f64 {
    let (directors, strains, resultants, forces) =
        (2.0 * 12.0 * VECTOR, 15.0 * 2.0 * VECTOR, 15.0 + 2.0 * 3.0, 25.0 * VECTOR);
    POINTS * (directors + strains + resultants + forces) + 24.0 * VECTOR + 4.0 * VECTOR
}

/// Operations of residual and tangent.
///
/// At each point besides: fifteen blocks of about four dyads each; the rows of the four vectors with two parts, of which each
/// meets five directors; 36 lower blocks of 1.5 parts each on average.
pub fn force_and_tangent() -> f64 {
    let (blocks, rows, spread) = (15.0 * 4.0 * MATRIX, 4.0 * 2.0 * 5.0 * MATRIX, 36.0 * 1.5 * MATRIX);
    force() + POINTS * (blocks + rows + spread) + 36.0 * 3.0
}

/// Operations of L D Lᵀ of a chain of nodes with b coordinates and one solution: b³/3 for the node, b³ for what couples it to the
/// next, b³ for what that changes there; 6 b² to go forward and back, 8 b² for the residual that checks it.
pub fn equations() -> f64 {
    7.0 / 3.0 * NODE.powi(3) + 14.0 * NODE.powi(2)
}

/// Bytes of the lower triangle of one element's node: its own block and that with the next.
fn matrix() -> f64 {
    BYTES * (NODE * (NODE + 1.0) / 2.0 + NODE * NODE)
}

/// Bytes that scattering moves: the 300 entries of an element, read, and their places, of half the size; the matrix, cleared,
/// then read and written.
pub fn scattered() -> f64 {
    1.5 * BYTES * 300.0 + 3.0 * matrix()
}

/// Bytes of a factorisation and a solution that stay in no cache: the matrix read twice, as it is factorised and checked; the
/// factor written (read before, as caches do) and read twice.
pub fn factorised() -> f64 {
    6.0 * matrix()
}

/// Operations of a step of so many iterations, each a force, a tangent and a solution; one more force ends it.
pub fn step(iterations: f64) -> f64 {
    iterations * (force_and_tangent() + equations()) + force()
}

/// Bytes of a step of so many iterations that stay in no cache: the matrix summed (cleared, read, written), then factorised; the
/// state and work vectors, about ten of a node's coordinates read or written.
pub fn step_bytes(iterations: f64) -> f64 {
    iterations * (3.0 * matrix() + factorised() + 10.0 * NODE * BYTES)
}
