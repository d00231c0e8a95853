use ancf_solver::equations::Lanes;
use pulp::Simd;

use super::relative::{MixWeights, VectorLayout};
use super::stiffness::{MatrixLanes, StiffnessLanes, add, at, load, subtract, times, transposed};
use crate::lanes::{Lane, Pass};

/// Stiffness over the vectors of an element in the order of [`RelativeLanes`](super::relative::RelativeLanes), by kinds.
///
/// Only the lower blocks are used within the axis, within Y and within Z.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(crate) struct VectorBlocks<S: Simd, const A: usize, const B: usize> {
    pub axis: [[MatrixLanes<S>; A]; A],
    /// Rows of Y and of Z, and columns of the axis.
    y_axis: [[MatrixLanes<S>; A]; B],
    z_axis: [[MatrixLanes<S>; A]; B],
    y: [[MatrixLanes<S>; B]; B],
    z: [[MatrixLanes<S>; B]; B],
    /// Rows of Z and columns of Y.
    z_y: [[MatrixLanes<S>; B]; B],
}

/// Stiffness within the directors (d, b) or (e, c): dd, db, the transpose of bd, and bb.
struct SectionPairBlocks<'a>([&'a [Lanes; 9]; 4]);

/// Indices of the entries of a block in its transpose.
const TRANSPOSED: [usize; 9] = [0, 3, 6, 1, 4, 7, 2, 5, 8];

impl SectionPairBlocks<'_> {
    /// Adds the stiffness to two vectors with these weights. The first vectors have no weight in b and c.
    #[inline(always)]
    fn add_to<S: Simd>(&self, pass: Pass<S>, sum: &mut MatrixLanes<S>, of: [[f64; 2]; 2], first: [bool; 2]) {
        let (Self([dd, db, bd, bb]), [[dn, bn], [dm, bm]]) = (self, of);
        let [dd_, db_, bd_, bb_] = [dn * dm, dn * bm, bn * dm, bn * bm].map(|w| pass.splat(w));
        for e in 0..9 {
            let mut part = pass.load(&dd[e]).mul_add(dd_, sum[e]);
            if !first[1] {
                part = pass.load(&db[e]).mul_add(db_, part);
            }
            if !first[0] {
                part = pass.load(&bd[TRANSPOSED[e]]).mul_add(bd_, part);
            }
            if !first[0] && !first[1] {
                part = pass.load(&bb[e]).mul_add(bb_, part);
            }
            sum[e] = part;
        }
    }
}

impl<S: Simd, const A: usize, const B: usize> VectorBlocks<S, A, B> {
    #[inline(always)]
    pub fn zero(pass: Pass<S>) -> Self {
        let zero = [pass.zero(); 9];
        Self {
            axis: [[zero; A]; A],
            y_axis: [[zero; A]; B],
            z_axis: [[zero; A]; B],
            y: [[zero; B]; B],
            z: [[zero; B]; B],
            z_y: [[zero; B]; B],
        }
    }

    /// Adds the stiffness of the directors at a station.
    #[inline(always)]
    pub fn add(&mut self, pass: Pass<S>, mix: &MixWeights<A, B>, h: &StiffnessLanes, reach: usize) {
        self.add_sections(pass, mix, h);
        if reach > 5 {
            self.add_varying_axis(pass, mix, h);
            return;
        }
        let of_axis = load(pass, &h[0]);
        for i in 0..A {
            for j in 0..=i {
                add(&mut self.axis[i][j], &of_axis, pass.splat(mix.axis[i][0] * mix.axis[j][0]));
            }
        }
        for (rows, d, b) in [(&mut self.y_axis, 3, 1), (&mut self.z_axis, 4, 2)] {
            for n in 0..B {
                let mut part = times(&load(pass, &h[at(d, 0)]), pass.splat(mix.section[n][0]));
                if n > 0 {
                    add(&mut part, &load(pass, &h[at(b, 0)]), pass.splat(mix.section[n][1]));
                }
                for i in 0..A {
                    add(&mut rows[n][i], &part, pass.splat(mix.axis[i][0]));
                }
            }
        }
    }

    /// Adds the stiffness within the sections.
    #[inline(always)]
    fn add_sections(&mut self, pass: Pass<S>, mix: &MixWeights<A, B>, h: &StiffnessLanes) {
        let w = &mix.section;
        let y = SectionPairBlocks([&h[at(3, 3)], &h[at(3, 1)], &h[at(3, 1)], &h[at(1, 1)]]);
        let z = SectionPairBlocks([&h[at(4, 4)], &h[at(4, 2)], &h[at(4, 2)], &h[at(2, 2)]]);
        let z_y = SectionPairBlocks([&h[at(4, 3)], &h[at(4, 1)], &h[at(3, 2)], &h[at(2, 1)]]);
        for n in 0..B {
            for m in 0..B {
                let first = [n == 0, m == 0];
                if m <= n {
                    y.add_to(pass, &mut self.y[n][m], [w[n], w[m]], first);
                    z.add_to(pass, &mut self.z[n][m], [w[n], w[m]], first);
                }
                z_y.add_to(pass, &mut self.z_y[n][m], [w[n], w[m]], first);
            }
        }
    }

    /// Adds the stiffness of the axis and its coupling with the sections, including h and k.
    #[inline(always)]
    fn add_varying_axis(&mut self, pass: Pass<S>, mix: &MixWeights<A, B>, h: &StiffnessLanes) {
        let full = |i: usize, j: usize| {
            if i >= j { load(pass, &h[at(i, j)]) } else { transposed(&load(pass, &h[at(j, i)])) }
        };
        for i in 0..A {
            let w = [pass.splat(mix.axis[i][0]), pass.splat(mix.axis[i][1]), pass.splat(mix.axis[i][2])];
            // Rows of the directors and column of vector i.
            for (rows, d, b) in [(&mut self.y_axis, 3, 1), (&mut self.z_axis, 4, 2)] {
                let [of_d, of_b] = [column(d, w, full), column(b, w, full)];
                for n in 0..B {
                    add(&mut rows[n][i], &of_d, pass.splat(mix.section[n][0]));
                    if n > 0 {
                        add(&mut rows[n][i], &of_b, pass.splat(mix.section[n][1]));
                    }
                }
            }
            let of_axis = [column(0, w, full), column(5, w, full), column(6, w, full)];
            for j in i..A {
                for k in 0..3 {
                    add(&mut self.axis[j][i], &of_axis[k], pass.splat(mix.axis[j][k]));
                }
            }
        }
    }

    /// Transforms the first vectors of kind Y and Z from base vectors to nodal vectors.
    #[inline(always)]
    fn complete_first_vectors(&mut self) {
        for n in 1..B {
            for i in 0..A {
                let (y, z) = (self.y_axis[n][i], self.z_axis[n][i]);
                subtract(&mut self.y_axis[0][i], &y);
                subtract(&mut self.z_axis[0][i], &z);
            }
        }
        for own in [&mut self.y, &mut self.z] {
            for n in 1..B {
                for m in 1..B {
                    // Columns of the first vector, then its diagonal block: K₀₀ − Σ(K₀ₙ + Kₙ₀) + ΣΣ Kₙₘ.
                    let block = if n >= m { own[n][m] } else { transposed(&own[m][n]) };
                    for e in 0..9 {
                        own[0][0][e] = own[0][0][e] + block[e];
                    }
                }
                let block = own[n][0];
                subtract(&mut own[0][0], &block);
                subtract(&mut own[0][0], &transposed(&block));
            }
            for n in 1..B {
                for m in 1..B {
                    let block = if n >= m { own[n][m] } else { transposed(&own[m][n]) };
                    subtract(&mut own[n][0], &block);
                }
            }
        }
        for n in 0..B {
            for m in 1..B {
                let block = self.z_y[n][m];
                subtract(&mut self.z_y[n][0], &block);
            }
        }
        for m in 0..B {
            for n in 1..B {
                let block = self.z_y[n][m];
                subtract(&mut self.z_y[0][m], &block);
            }
        }
    }

    /// Writes the lower triangle by columns over the coordinates of N vectors.
    #[inline(always)]
    pub fn write<const N: usize>(&mut self, pass: Pass<S>, layout: &VectorLayout<A, B>, k: &mut [Lanes]) {
        self.complete_first_vectors();
        let (axis, y, z) = (layout.axis.map(|(number, _)| number), layout.y, layout.z);
        let mut write_block =
            |a: usize, b: usize, block: &MatrixLanes<S>| write_block::<S, N>(pass, k, a, b, block);
        let mut corner = [pass.zero(); 9];
        for i in 0..A {
            for j in 0..i {
                self.axis[j][i] = transposed(&self.axis[i][j]);
            }
        }
        for i in 0..A {
            let first = first_position_block(pass, layout, &self.axis[i]);
            if layout.axis[i].1 {
                subtract(&mut corner, &first);
            }
            write_block(axis[i], 0, &first);
            for j in 0..=i {
                write_block(axis[i], axis[j], &self.axis[i][j]);
            }
        }
        write_block(0, 0, &corner);
        for n in 0..B {
            write_block(y[n], 0, &first_position_block(pass, layout, &self.y_axis[n]));
            write_block(z[n], 0, &first_position_block(pass, layout, &self.z_axis[n]));
            for i in 0..A {
                write_block(y[n], axis[i], &self.y_axis[n][i]);
                write_block(z[n], axis[i], &self.z_axis[n][i]);
            }
            for m in 0..=n {
                write_block(y[n], y[m], &self.y[n][m]);
                write_block(z[n], z[m], &self.z[n][m]);
            }
            for m in 0..B {
                write_block(z[n], y[m], &self.z_y[n][m]);
            }
        }
    }
}

/// Returns the block of the first position: the negative sum over the other positions.
#[inline(always)]
fn first_position_block<S: Simd, const A: usize, const B: usize>(
    pass: Pass<S>,
    layout: &VectorLayout<A, B>,
    of: &[MatrixLanes<S>; A],
) -> MatrixLanes<S> {
    let mut sum = [pass.zero(); 9];
    for i in 0..A {
        if layout.axis[i].1 {
            subtract(&mut sum, &of[i]);
        }
    }
    sum
}

/// Writes a block of N vectors. A block above the diagonal is transposed.
#[inline(always)]
fn write_block<S: Simd, const N: usize>(
    pass: Pass<S>,
    k: &mut [Lanes],
    a: usize,
    b: usize,
    block: &MatrixLanes<S>,
) {
    let (row, column, turned) = if a >= b { (a, b, false) } else { (b, a, true) };
    for c in 0..3 {
        let from = if a == b { c } else { 0 };
        let start = lower(3 * N, 3 * row, 3 * column + c);
        let entries = &mut k[start + from..start + 3];
        for r in from..3 {
            pass.store(&mut entries[r - from], block[if turned { 3 * c + r } else { 3 * r + c }]);
        }
    }
}

/// Computes the block of director α and a vector of the axis with weights in a, h and k.
#[inline(always)]
fn column<S: Simd>(
    alpha: usize,
    w: [Lane<S>; 3],
    full: impl Fn(usize, usize) -> MatrixLanes<S>,
) -> MatrixLanes<S> {
    let mut sum = times(&full(alpha, 0), w[0]);
    add(&mut sum, &full(alpha, 5), w[1]);
    add(&mut sum, &full(alpha, 6), w[2]);
    sum
}

/// Returns the index of entry (i, j), i ≥ j, in a lower triangle by columns.
#[inline(always)]
pub(crate) const fn lower(size: usize, i: usize, j: usize) -> usize {
    (j * size + i).wrapping_sub(j * (j + 1) / 2)
}
