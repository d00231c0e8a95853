use pulp::Simd;

use super::lane::{Lane, Pass};
use super::relative::{Layout, Mix};
use super::stiffness::{Matrix, Stiffness, add, at, subtract, times, transposed};
use crate::system::Lanes;

/// Stiffness over an element's vectors as they count in [`Relative`](super::relative::Relative), by kinds: of the axis and of
/// Y and Z the lower blocks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blocks<S: Simd, const A: usize, const B: usize> {
    pub axis: [[Matrix<S>; A]; A],
    /// Rows of Y, of Z and columns of the axis.
    y_axis: [[Matrix<S>; A]; B],
    z_axis: [[Matrix<S>; A]; B],
    y: [[Matrix<S>; B]; B],
    z: [[Matrix<S>; B]; B],
    /// Rows of Z and columns of Y.
    z_y: [[Matrix<S>; B]; B],
}

/// Where a vector of an element is among the [`Blocks`].
#[derive(Clone, Copy, Debug)]
enum Place {
    /// The first position.
    First,
    Axis(usize),
    Y(usize),
    Z(usize),
}

/// Stiffness of the directors (d, b) or (e, c) against each other: dd, db, bd and bb.
struct Pair<S: Simd>([Matrix<S>; 4]);

impl<S: Simd> Pair<S> {
    /// What it adds to two vectors with these weights.
    #[inline(always)]
    fn add_to(
        &self,
        pass: Pass<S>,
        sum: &mut Matrix<S>,
        [dn, bn]: [f64; 2],
        [dm, bm]: [f64; 2],
        first: [bool; 2],
    ) {
        let mut part = times(&self.0[0], pass.splat(dn * dm));
        if !first[1] {
            add(&mut part, &self.0[1], pass.splat(dn * bm));
        }
        if !first[0] {
            add(&mut part, &self.0[2], pass.splat(bn * dm));
        }
        if !first[0] && !first[1] {
            add(&mut part, &self.0[3], pass.splat(bn * bm));
        }
        for e in 0..9 {
            sum[e] = sum[e] + part[e];
        }
    }
}

impl<S: Simd, const A: usize, const B: usize> Blocks<S, A, B> {
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
    pub fn add(&mut self, pass: Pass<S>, mix: &Mix<A, B>, h: &Stiffness<S>, reach: usize) {
        self.add_sections(pass, mix, h);
        if reach > 5 {
            self.add_varying_axis(pass, mix, h);
            return;
        }
        for i in 0..A {
            for j in 0..=i {
                add(&mut self.axis[i][j], &h[0], pass.splat(mix.axis[i][0] * mix.axis[j][0]));
            }
        }
        for (rows, d, b) in [(&mut self.y_axis, 3, 1), (&mut self.z_axis, 4, 2)] {
            for n in 0..B {
                let mut part = times(&h[at(d, 0)], pass.splat(mix.section[n][0]));
                if n > 0 {
                    add(&mut part, &h[at(b, 0)], pass.splat(mix.section[n][1]));
                }
                for i in 0..A {
                    add(&mut rows[n][i], &part, pass.splat(mix.axis[i][0]));
                }
            }
        }
    }

    /// The sections against each other.
    #[inline(always)]
    fn add_sections(&mut self, pass: Pass<S>, mix: &Mix<A, B>, h: &Stiffness<S>) {
        let w = &mix.section;
        let own =
            |d: usize, b: usize| Pair([h[at(d, d)], h[at(d, b)], transposed(&h[at(d, b)]), h[at(b, b)]]);
        let (y, z) = (own(3, 1), own(4, 2));
        let z_y = Pair([h[at(4, 3)], h[at(4, 1)], transposed(&h[at(3, 2)]), h[at(2, 1)]]);
        for n in 0..B {
            for m in 0..B {
                let first = [n == 0, m == 0];
                if m <= n {
                    y.add_to(pass, &mut self.y[n][m], w[n], w[m], first);
                    z.add_to(pass, &mut self.z[n][m], w[n], w[m], first);
                }
                z_y.add_to(pass, &mut self.z_y[n][m], w[n], w[m], first);
            }
        }
    }

    /// The axis against itself and the sections, where h and k count besides a.
    #[inline(always)]
    fn add_varying_axis(&mut self, pass: Pass<S>, mix: &Mix<A, B>, h: &Stiffness<S>) {
        let full = |i: usize, j: usize| if i >= j { h[at(i, j)] } else { transposed(&h[at(j, i)]) };
        for i in 0..A {
            let w = [pass.splat(mix.axis[i][0]), pass.splat(mix.axis[i][1]), pass.splat(mix.axis[i][2])];
            // The rows of the directors against vector i.
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

    /// Turns the first vectors of kind Y and Z from what others are measured from to vectors like these.
    #[inline(always)]
    fn settle(&mut self) {
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
                    // Columns against the first, then the first against itself: K₀₀ − Σ(K₀ₙ + Kₙ₀) + ΣΣ Kₙₘ.
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

    /// Sets a lower triangle by columns over the coordinates of N vectors.
    #[inline(always)]
    pub fn write<const N: usize>(&mut self, pass: Pass<S>, layout: &Layout<A, B>, k: &mut [Lanes]) {
        self.settle();
        let mut places = [Place::First; N];
        for i in 0..A {
            places[layout.axis[i].0] = Place::Axis(i);
        }
        for n in 0..B {
            places[layout.y[n]] = Place::Y(n);
            places[layout.z[n]] = Place::Z(n);
        }
        for b in 0..N {
            for a in b..N {
                let block = self.block(pass, layout, places[a], places[b]);
                for c in 0..3 {
                    let column = lower(3 * N, 3 * a, 3 * b + c);
                    let rows = if a == b { c } else { 0 };
                    for r in rows..3 {
                        pass.store(&mut k[column + r], block[3 * r + c]);
                    }
                }
            }
        }
    }

    #[inline(always)]
    fn block(&self, pass: Pass<S>, layout: &Layout<A, B>, row: Place, column: Place) -> Matrix<S> {
        use Place::{Axis, First, Y, Z};
        let zero = [pass.zero(); 9];
        // Against the first position: what all other positions have, with the other sign.
        let against_first = |of: &[Matrix<S>; A]| {
            let mut sum = zero;
            for i in (0..A).filter(|&i| layout.axis[i].1) {
                subtract(&mut sum, &of[i]);
            }
            sum
        };
        let of_axis = |i: usize| {
            let mut row = [zero; A];
            for j in 0..A {
                row[j] = if i >= j { self.axis[i][j] } else { transposed(&self.axis[j][i]) };
            }
            row
        };
        match (row, column) {
            (First, First) => {
                let mut sum = [zero; A];
                for i in (0..A).filter(|&i| layout.axis[i].1) {
                    sum[i] = against_first(&of_axis(i));
                }
                against_first(&sum)
            }
            (Axis(i), First) => against_first(&of_axis(i)),
            (Axis(i), Axis(j)) => self.axis[i][j],
            (Axis(i), Y(m)) => transposed(&self.y_axis[m][i]),
            (Axis(i), Z(m)) => transposed(&self.z_axis[m][i]),
            (Y(n), First) => against_first(&self.y_axis[n]),
            (Y(n), Axis(i)) => self.y_axis[n][i],
            (Y(n), Y(m)) => self.y[n][m],
            (Y(n), Z(m)) => transposed(&self.z_y[m][n]),
            (Z(n), First) => against_first(&self.z_axis[n]),
            (Z(n), Axis(i)) => self.z_axis[n][i],
            (Z(n), Y(m)) => self.z_y[n][m],
            (Z(n), Z(m)) => self.z[n][m],
            // No vector comes before the first one.
            (First, Axis(_) | Y(_) | Z(_)) => zero,
        }
    }
}

/// The director α against a vector of the axis with weights in a, h and k.
#[inline(always)]
fn column<S: Simd>(alpha: usize, w: [Lane<S>; 3], full: impl Fn(usize, usize) -> Matrix<S>) -> Matrix<S> {
    let mut sum = times(&full(alpha, 0), w[0]);
    add(&mut sum, &full(alpha, 5), w[1]);
    add(&mut sum, &full(alpha, 6), w[2]);
    sum
}

/// The place of entry (i, j), i ≥ j, in a lower triangle by columns.
#[inline(always)]
pub(super) const fn lower(size: usize, i: usize, j: usize) -> usize {
    (j * size + i).wrapping_sub(j * (j + 1) / 2)
}
