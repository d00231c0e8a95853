//! Stiffness matrix of a shell element.
//!
//! Matrices are stored as 16 × 16 blocks, one for each pair of components of the nodal vectors. All sums are products of rows with
//! 16 numbers, evaluated in SIMD vectors along the rows.

use ancf_solver::equations::LocalMatrix;
use nalgebra::{Matrix3, Vector3};
use pulp::{Simd, WithSimd};

use super::bent_points::{BentPoint, VOIGT};
use super::hermite::VECTORS;
use super::membrane_stiffness::MembraneStiffness;
use super::profile::ShellProfile;
use super::surface_state::{ShellStrains, SurfaceState};
use super::tables::{MEMBRANE, POINTS, SHEARS, ShellTables};
use crate::lanes::{Row, add_products, combined};

/// Matrix over pairs of nodal vectors.
pub(crate) type Block = [Row; VECTORS];

/// Components (i, j) of the stored blocks.
const PAIRS: [[usize; 2]; 6] = [[0, 0], [1, 0], [1, 1], [2, 0], [2, 1], [2, 2]];

/// Symmetric matrix over the coordinates of an element: the blocks of [`PAIRS`].
pub(crate) struct ShellMatrix([Block; 6]);

impl ShellMatrix {
    pub(crate) const ZERO: Self = Self([[Row::ZERO; VECTORS]; 6]);

    /// Adds the same block for all three components.
    pub(crate) fn add_to_diagonal(&mut self, factor: f64, block: &Block) {
        for (place, _) in PAIRS.iter().enumerate().filter(|(_, [i, j])| i == j) {
            for (sum, row) in self.0[place].iter_mut().zip(block) {
                sum.0.iter_mut().zip(&row.0).for_each(|(sum, x)| *sum += factor * x);
            }
        }
    }

    /// Adds the lower triangle to the matrix of the element.
    pub(crate) fn add_to(&self, k: &mut LocalMatrix<'_>) {
        const PLACE: [[usize; 3]; 3] = [[0, 1, 3], [1, 2, 4], [3, 4, 5]];
        for a in 0..VECTORS {
            for i in 0..3 {
                let column = k.column_mut(3 * a + i);
                for j in 0..3 {
                    let block = &self.0[PLACE[i][j]];
                    let first = if j < i { a + 1 } else { a };
                    let rows = column.iter_mut().skip(3 * first + j - 3 * a - i).step_by(3);
                    if i >= j {
                        rows.zip(&block[a].0[first..]).for_each(|(sum, x)| *sum += x);
                    } else {
                        rows.zip(&block[first..]).for_each(|(sum, row)| *sum += row.0[a]);
                    }
                }
            }
        }
    }
}

/// Stiffness of a state: `material` times Bᵀ D B, plus Σ σ ∂²ε/∂q² of the given stresses.
pub(crate) struct StiffnessJob<'a> {
    pub(crate) state: &'a SurfaceState,
    pub(crate) tables: &'a ShellTables,
    pub(crate) profile: &'a ShellProfile,
    pub(crate) material: f64,
    /// Stiffness of the membrane strains in place of `material` times that of the profile.
    pub(crate) membrane: Option<&'a MembraneStiffness>,
    pub(crate) stress: &'a ShellStrains,
    /// Zero matrix that receives the result.
    pub(crate) sum: &'a mut ShellMatrix,
}

impl WithSimd for StiffnessJob<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { state, tables, profile, material, membrane, stress, sum } = self;
        if material != 0.0 {
            let mut rows = state.membrane_rows(tables);
            if !profile.coupling.is_empty() {
                add_coupling(simd, (state, tables, profile), &rows, &mut sum.0);
            }
            membrane.unwrap_or(&profile.membrane).multiply(simd, &mut rows);
            for (block, [i, j]) in sum.0.iter_mut().zip(PAIRS) {
                add_products(simd, MEMBRANE, |t| &rows[t][i], |t| &rows[t][j], block);
            }
            if material != 1.0 && membrane.is_none() {
                let numbers = sum.0.iter_mut().flatten().flat_map(|row| &mut row.0);
                numbers.for_each(|x| *x *= material);
            }
        }
        add_bending(simd, (state, tables, profile), (material, stress), &mut sum.0);
        let mut block = [Row::ZERO; VECTORS];
        add_membrane_geometry(simd, tables, stress, &mut block);
        sum.add_to_diagonal(1.0, &block);
    }
}

/// Rows of the derivatives of strains, one for each component of the nodal vectors.
type StrainRows = [[Row; 3]; MEMBRANE];

impl SurfaceState {
    /// Returns the derivatives of the membrane strains.
    #[inline(always)]
    pub(super) fn membrane_rows(&self, tables: &ShellTables) -> StrainRows {
        let mut rows = [[Row::ZERO; 3]; MEMBRANE];
        for (t, (row, sample)) in rows.iter_mut().zip(&tables.samples).enumerate() {
            let [x, y] = &sample.shapes;
            let [a, b] = [self.tangent(t), self.tangent(if t < MEMBRANE - SHEARS { t } else { t + SHEARS })];
            for (i, row) in row.iter_mut().enumerate() {
                for k in 0..VECTORS {
                    row.0[k] = match sample.component {
                        0 => a[i] * x[k],
                        1 => b[i] * y[k],
                        _ => a[i] * y[k] + b[i] * x[k],
                    };
                }
            }
        }
        rows
    }
}

/// Adds the stiffness of membrane stresses, one block for all components.
#[inline(always)]
fn add_membrane_geometry<S: Simd>(simd: S, tables: &ShellTables, stress: &ShellStrains, block: &mut Block) {
    let rows = &tables.tangents;
    let mut scaled = *rows;
    for (r, row) in scaled.iter_mut().enumerate() {
        row.0.iter_mut().for_each(|x| *x *= stress.membrane[ShellTables::strain_of(r)]);
    }
    // The stiffness of a shear strain is the product of r_ξ with r_η.
    let beside = |r: usize| match r {
        MEMBRANE.. => r - SHEARS,
        r if r >= MEMBRANE - SHEARS => r + SHEARS,
        r => r,
    };
    add_products(simd, rows.len(), |r| &scaled[r], |r| &rows[beside(r)], block);
}

/// Adds the products of membrane strains and curvatures, Bᵀ M + Mᵀ B with the rows M of the moments of each membrane strain.
#[inline(always)]
fn add_coupling<S: Simd>(
    simd: S,
    (state, tables, profile): (&SurfaceState, &ShellTables, &ShellProfile),
    rows: &StrainRows,
    sum: &mut [Block; 6],
) {
    // Forces −(C c)_k n of unit strains at the points, then of the membrane strains.
    let mut moments = [[Row::ZERO; 3]; MEMBRANE];
    for (p, coupling) in profile.coupling.iter().enumerate() {
        let point = state.points.at(p);
        let gradients = point.gradients(&tables.points[p]);
        let forces: [Row; 3] = std::array::from_fn(|k| {
            let of = |a: usize| -> f64 { (0..3).map(|j| coupling[(k, j)] * gradients[j].0[a]).sum() };
            Row(std::array::from_fn(of))
        });
        for (t, moment) in moments.iter_mut().enumerate() {
            let force = &forces[tables.samples[t].component];
            for (i, row) in moment.iter_mut().enumerate() {
                let factor = -tables.sampling[p][t] * point.normal[i];
                row.0.iter_mut().zip(&force.0).for_each(|(sum, x)| *sum += factor * x);
            }
        }
    }
    for (block, [i, j]) in sum.iter_mut().zip(PAIRS) {
        add_products(simd, MEMBRANE, |t| &rows[t][i], |t| &moments[t][j], block);
        add_products(simd, MEMBRANE, |t| &moments[t][i], |t| &rows[t][j], block);
    }
}

/// Rows of an integration point from which its stiffness is formed.
///
/// With the gradients c of the curvatures, c_m = Σ m c, b_m = Σ m b and w_a = a^γ N_a,γ the blocks are
/// n nᵀ (c_a·D c_b + b_m w_a·w_b) + c_m,a w_b nᵀ + c_m,b n w_aᵀ. As a function of the vector a they are
/// Σ_α N_a,α (q_α,b n nᵀ + μ_α w_b nᵀ + c_m,b n a^αᵀ) with the derivatives α: r_ξ, r_η, r_ξξ, r_ηη, r_ξη.
///
/// Iterators with closures are avoided around SIMD operations: a closure that is not inlined is compiled without vector units.
#[derive(Clone, Copy)]
struct BendingRows {
    normal: Vector3<f64>,
    dual: [Vector3<f64>; 2],
    /// c_m,a = Σ_α μ_α N_a,α.
    moments: [f64; 5],
    products: [Row; 5],
    turns: [Row; 3],
    moment: Row,
}

impl BendingRows {
    const ZERO: Self = Self {
        normal: Vector3::new(0.0, 0.0, 0.0),
        dual: [Vector3::new(0.0, 0.0, 0.0); 2],
        moments: [0.0; 5],
        products: [Row::ZERO; 5],
        turns: [Row::ZERO; 3],
        moment: Row::ZERO,
    };

    #[inline(always)]
    fn new<S: Simd>(
        simd: S,
        (point, shapes): (&BentPoint, &[Row; 5]),
        (d, m): (&Matrix3<f64>, &Vector3<f64>),
    ) -> Self {
        let (square, moments) = point.stiffness_factors(d, m);
        let all = [&shapes[0], &shapes[1], &shapes[2], &shapes[3], &shapes[4]];
        let mut rows = Self { normal: point.normal, dual: point.dual, moments, ..Self::ZERO };
        for x in 0..5 {
            rows.products[x] = combined(simd, &square[x], &all);
        }
        for i in 0..3 {
            rows.turns[i] = combined(simd, &[point.dual[0][i], point.dual[1][i]], &[all[0], all[1]]);
        }
        rows.moment = combined(simd, &moments, &all);
        rows
    }
}

impl BentPoint {
    /// Returns the matrix S with c_a·D c_b + b_m w_a·w_b = Σ S_αβ N_a,α N_b,β, and the factors μ of c_m.
    fn stiffness_factors(&self, d: &Matrix3<f64>, m: &Vector3<f64>) -> ([[f64; 5]; 5], [f64; 5]) {
        // Curvature k is −n·Σ_α factors[k][α] r_,α.
        let mut factors = [[0.0; 5]; 3];
        for (k, row) in factors.iter_mut().enumerate() {
            let [x, y] = self.christoffel[k];
            (row[0], row[1], row[k + 2]) = (-VOIGT[k] * x, -VOIGT[k] * y, VOIGT[k]);
        }
        let bent: f64 = (0..3).map(|k| VOIGT[k] * m[k] * self.second[k].dot(&self.normal)).sum();
        let (mut square, mut moments) = ([[0.0; 5]; 5], [0.0; 5]);
        for x in 0..5 {
            let gradient = Vector3::new(factors[0][x], factors[1][x], factors[2][x]);
            let stress = d * gradient;
            moments[x] = m.dot(&gradient);
            for y in 0..5 {
                square[x][y] =
                    stress[0] * factors[0][y] + stress[1] * factors[1][y] + stress[2] * factors[2][y];
            }
        }
        for (x, y) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            square[x][y] += bent * self.dual[x].dot(&self.dual[y]);
        }
        (square, moments)
    }
}

/// Points along a direction of the patch.
const LINE: usize = 4;

/// Adds the stiffness of curvatures. Sums over the points are evaluated along ξ, then along η.
#[inline(always)]
fn add_bending<S: Simd>(
    simd: S,
    (state, tables, profile): (&SurfaceState, &ShellTables, &ShellProfile),
    (material, stress): (f64, &ShellStrains),
    sum: &mut [Block; 6],
) {
    for line in 0..POINTS / LINE {
        let mut rows = [BendingRows::ZERO; LINE];
        for (p, row) in rows.iter_mut().enumerate() {
            let k = LINE * line + p;
            let (point, d) = (state.points.at(k), profile.points.bending(k) * material);
            *row = BendingRows::new(simd, (&point, &tables.points[k]), (&d, &stress.bending(k)));
        }
        for (block, pair) in sum.iter_mut().zip(PAIRS) {
            for v in 0..VECTORS / S::F64_LANES {
                add_line(simd, tables, (line, &rows), pair, v, block);
            }
        }
    }
}

/// Adds the stiffness of the points of a line, for a pair of components and a SIMD vector of columns.
#[inline(always)]
fn add_line<S: Simd>(
    simd: S,
    tables: &ShellTables,
    (line, rows): (usize, &[BendingRows; LINE]),
    [i, j]: [usize; 2],
    v: usize,
    block: &mut Block,
) {
    let [values, slopes, bends] = &tables.hermite;
    // Sums along ξ for each Hermite function of ξ, one list for each order of the derivative by η. They are in registers.
    let zero = [simd.splat_f64s(0.0); 4];
    let (mut of_values, mut of_slopes, mut of_bends) = (zero, zero, zero);
    for (p, row) in rows.iter().enumerate() {
        let n = [row.normal[i], row.normal[j]];
        let (turn, moment) = (row.turns[i].load::<S>(v), row.moment.load::<S>(v));
        let square = simd.splat_f64s(n[0] * n[1]);
        let mut of = [square; 5];
        for x in 0..5 {
            of[x] = simd.mul_f64s(square, row.products[x].load::<S>(v));
            of[x] = simd.mul_add_e_f64s(simd.splat_f64s(row.moments[x] * n[1]), turn, of[x]);
        }
        for x in 0..2 {
            of[x] = simd.mul_add_e_f64s(simd.splat_f64s(n[0] * row.dual[x][j]), moment, of[x]);
        }
        add_multiples(simd, &slopes[p], of[0], &mut of_values);
        add_multiples(simd, &values[p], of[1], &mut of_slopes);
        add_multiples(simd, &bends[p], of[2], &mut of_values);
        add_multiples(simd, &values[p], of[3], &mut of_bends);
        add_multiples(simd, &slopes[p], of[4], &mut of_slopes);
    }
    let along = [of_values, of_slopes, of_bends];
    let factors = [values[line], slopes[line], bends[line]];
    for (a, row) in block.iter_mut().enumerate() {
        let (node, kind) = (a / 4, a % 4);
        let (of_xi, of_eta) = (2 * (node % 2) + kind % 2, 2 * (node / 2) + kind / 2);
        let mut value = row.load::<S>(v);
        for k in 0..3 {
            value = simd.mul_add_e_f64s(simd.splat_f64s(factors[k][of_eta]), along[k][of_xi], value);
        }
        row.store::<S>(v, value);
    }
}

/// Adds multiples of a vector.
#[inline(always)]
fn add_multiples<S: Simd>(simd: S, factors: &[f64; 4], x: S::f64s, sums: &mut [S::f64s; 4]) {
    sums[0] = simd.mul_add_e_f64s(simd.splat_f64s(factors[0]), x, sums[0]);
    sums[1] = simd.mul_add_e_f64s(simd.splat_f64s(factors[1]), x, sums[1]);
    sums[2] = simd.mul_add_e_f64s(simd.splat_f64s(factors[2]), x, sums[2]);
    sums[3] = simd.mul_add_e_f64s(simd.splat_f64s(factors[3]), x, sums[3]);
}
