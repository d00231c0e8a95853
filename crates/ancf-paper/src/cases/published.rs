//! Printed numbers of Kim et al. (2017), in the order of [`ELEMENTS`](super::models::ELEMENTS).

/// Table 3: T_ND, s.
pub const TABLE_3: [f64; 6] = [0.32, 0.45, 0.71, 1.01, 1.24, 1.43];
/// Table 4: analysis time of the cantilever, s, dimensional (MATLAB R2012a, i7-4930K at 3.4 GHz).
pub const TABLE_4_DIM: [f64; 6] = [6.27, 16.28, 41.90, 109.64, 166.69, 231.52];
/// Table 4, non-dimensional.
pub const TABLE_4_NONDIM: [f64; 6] = [28.45, 38.65, 54.67, 93.63, 114.47, 131.04];
/// Table 5: mean tip deflection of the cantilever, mm, dimensional.
pub const TABLE_5_DIM: [f64; 6] = [-1.357, -1.870, -2.014, -2.032, -2.036, -2.037];
/// Table 5, non-dimensional.
pub const TABLE_5_NONDIM: [f64; 6] = [-1.356, -1.872, -2.015, -2.032, -2.036, -2.037];
/// Table 6: step of the revolute pendulum, s, dimensional and non-dimensional.
pub const TABLE_6_STEP: [f64; 2] = [0.00100, 0.00032];
/// Table 6: "number of iteration", which is the number of instants.
pub const TABLE_6_INSTANTS: [u64; 2] = [2001, 6263];
/// Table 6: analysis time, s.
pub const TABLE_6_SECONDS: [f64; 2] = [37.62, 27.96];
/// Eq. (34): static deflection, mm.
pub const STATIC: f64 = -2.040;
/// Section 4: the non-dimensional form is "more than fourfold" faster at 20 elements.
pub const TABLE_7_CLAIM: f64 = 4.0;
/// Section 3.2: iterations of the initial step of the revolute pendulum, dimensional form; "approximately".
pub const FIGURE_7_ITERATIONS: u32 = 80;
/// Software and machine of the printed times.
pub const MACHINE: &str = "MATLAB R2012a on an Intel Core i7-4930K at 3.4 GHz";

/// Returns the printed ratio DIM / Non-DIM of Table 4 with the largest mesh.
pub fn printed_gain() -> f64 {
    let last = |column: [f64; 6]| column[column.len() - 1];
    last(TABLE_4_DIM) / last(TABLE_4_NONDIM)
}
