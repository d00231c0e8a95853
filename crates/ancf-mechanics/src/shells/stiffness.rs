//! Tangent of a shell element.

use nalgebra::Vector3;

use super::hermite::{Shape, VECTORS};
use super::profile::{MEMBRANE, ShellProfile, ShellTables, Tie};
use super::surface_state::{BentPoint, ShellStrains, SurfaceState, VOIGT};

/// Number of coordinates of an element.
pub(crate) const SIZE: usize = 3 * VECTORS;

/// Lower triangle of a matrix over the coordinates of an element, by rows.
pub(crate) type Square = [[f64; SIZE]; SIZE];

impl SurfaceState {
    /// Returns the derivatives of a membrane strain.
    fn membrane_row(&self, tables: &ShellTables, t: usize) -> [f64; SIZE] {
        let ([a, b], Tie { component, shapes: [x, y] }) = (&self.ties[t], &tables.ties[t]);
        let mut row = [0.0; SIZE];
        for k in 0..VECTORS {
            for i in 0..3 {
                row[3 * k + i] = match component {
                    0 => a[i] * x[k],
                    1 => b[i] * y[k],
                    _ => a[i] * y[k] + b[i] * x[k],
                };
            }
        }
        row
    }

    /// Adds `weight` times the material stiffness Bᵀ D B.
    pub(crate) fn add_material(
        &self,
        tables: &ShellTables,
        profile: &ShellProfile,
        weight: f64,
        k: &mut Square,
    ) {
        let rows: [[f64; SIZE]; MEMBRANE] = std::array::from_fn(|t| self.membrane_row(tables, t));
        for (row, stiffness) in rows.iter().zip(&*profile.membrane) {
            let mut stress = [0.0; SIZE];
            for (d, other) in stiffness.iter().zip(&rows) {
                let d = d * weight;
                stress.iter_mut().zip(other).for_each(|(stress, strain)| *stress += d * strain);
            }
            add_outer(row, &stress, k);
        }
        for (p, point) in self.points.iter().enumerate() {
            let c = point.gradients(&tables.points[p]);
            let d = profile.points[p].bending * weight;
            let stress: [Shape; 3] =
                std::array::from_fn(|i| std::array::from_fn(|a| (0..3).map(|j| d[(i, j)] * c[j][a]).sum()));
            let n = &point.normal;
            for a in 0..VECTORS {
                for b in 0..=a {
                    let q: f64 = (0..3).map(|i| c[i][a] * stress[i][b]).sum();
                    add_block(a, b, |i, j| q * n[i] * n[j], k);
                }
            }
            if profile.is_coupled {
                self.add_coupling(&c, (&rows, tables, p), profile.points[p].coupling * weight, n, k);
            }
        }
    }

    /// Adds the products of membrane strains and curvatures at a point.
    fn add_coupling(
        &self,
        c: &[Shape; 3],
        (rows, tables, point): (&[[f64; SIZE]; MEMBRANE], &ShellTables, usize),
        coupling: nalgebra::Matrix3<f64>,
        n: &Vector3<f64>,
        k: &mut Square,
    ) {
        let mut strains = [[0.0; SIZE]; 3];
        for (t, row) in rows.iter().enumerate() {
            let (tying, strain) = (tables.tying[point][t], &mut strains[tables.ties[t].component]);
            strain.iter_mut().zip(row).for_each(|(sum, x)| *sum += tying * x);
        }
        for (i, strain) in strains.iter().enumerate() {
            let mut moment = [0.0; SIZE];
            for a in 0..VECTORS {
                let of: f64 = (0..3).map(|j| coupling[(i, j)] * c[j][a]).sum();
                (0..3).for_each(|m| moment[3 * a + m] = -n[m] * of);
            }
            add_outer(strain, &moment, k);
            add_outer(&moment, strain, k);
        }
    }

    /// Adds the stiffness Σ σ ∂²ε/∂q² of stresses.
    pub(crate) fn add_geometric(&self, tables: &ShellTables, stress: &ShellStrains, k: &mut Square) {
        for (t, Tie { component, shapes: [x, y] }) in tables.ties.iter().enumerate() {
            let n = stress.membrane[t];
            for a in 0..VECTORS {
                let (along, across) = match component {
                    0 => (n * x[a], 0.0),
                    1 => (0.0, n * y[a]),
                    _ => (n * y[a], n * x[a]),
                };
                for b in 0..=a {
                    let value = along * x[b] + across * y[b];
                    (0..3).for_each(|i| k[3 * a + i][3 * b + i] += value);
                }
            }
        }
        for (p, point) in self.points.iter().enumerate() {
            point.add_geometric(&tables.points[p], &stress.bending[p], k);
        }
    }
}

impl BentPoint {
    /// Adds the stiffness of moments: with c_m = Σ m c, b_m = Σ m b and w_a = a^γ N_a,γ,
    /// n nᵀ b_m (w_a·w_b) + c_m,a w_b nᵀ + c_m,b n w_aᵀ.
    fn add_geometric(&self, shapes: &[Shape; 5], m: &Vector3<f64>, k: &mut Square) {
        let gradients = self.gradients(shapes);
        let c: Shape = std::array::from_fn(|a| (0..3).map(|i| m[i] * gradients[i][a]).sum());
        let w: [Vector3<f64>; VECTORS] =
            std::array::from_fn(|a| self.dual[0] * shapes[0][a] + self.dual[1] * shapes[1][a]);
        let n = &self.normal;
        let bent: f64 = (0..3).map(|i| VOIGT[i] * m[i] * self.second[i].dot(n)).sum();
        for a in 0..VECTORS {
            for b in 0..=a {
                let inner = bent * w[a].dot(&w[b]);
                add_block(
                    a,
                    b,
                    |i, j| n[i] * n[j] * inner + c[a] * w[b][i] * n[j] + c[b] * n[i] * w[a][j],
                    k,
                );
            }
        }
    }
}

/// Adds a block over the nodal vectors a ≥ b.
#[inline]
fn add_block(a: usize, b: usize, block: impl Fn(usize, usize) -> f64, k: &mut Square) {
    for i in 0..3 {
        for j in 0..3 {
            k[3 * a + i][3 * b + j] += block(i, j);
        }
    }
}

/// Adds the lower triangle of x yᵀ.
#[inline]
fn add_outer(x: &[f64; SIZE], y: &[f64; SIZE], k: &mut Square) {
    for (i, (row, x)) in k.iter_mut().zip(x).enumerate() {
        if *x != 0.0 {
            row[..=i].iter_mut().zip(y).for_each(|(value, y)| *value += x * y);
        }
    }
}
