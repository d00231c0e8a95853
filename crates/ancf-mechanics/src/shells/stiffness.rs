//! Tangent of a shell element.

use nalgebra::{Matrix3, Vector3};

use super::hermite::{Shape, VECTORS};
use super::profile::{MEMBRANE, MembraneSample, ShellProfile, ShellTables};
use super::surface_state::{BentPoint, ShellStrains, SurfaceState, VOIGT};

/// Number of coordinates of an element.
pub(crate) const SIZE: usize = 3 * VECTORS;

/// Lower triangle of a matrix over the coordinates of an element, by columns: entry \[j\]\[i\], i ≥ j.
pub(crate) type Square = [[f64; SIZE]; SIZE];

/// Row of derivatives by the coordinates of an element.
type Row = [f64; SIZE];

impl SurfaceState {
    /// Returns the derivatives of a membrane strain.
    #[inline(always)]
    fn membrane_row(&self, tables: &ShellTables, t: usize) -> Row {
        let ([a, b], MembraneSample { component, shapes: [x, y], .. }) =
            (&self.samples[t], &tables.samples[t]);
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

    /// Adds the stiffness: `material` times Bᵀ D B, plus Σ σ ∂²ε/∂q² of the given stresses.
    #[inline(always)]
    pub(crate) fn add_stiffness(
        &self,
        tables: &ShellTables,
        profile: &ShellProfile,
        (material, stress): (f64, &ShellStrains),
        k: &mut Square,
    ) {
        let rows: [Row; MEMBRANE] = std::array::from_fn(|t| self.membrane_row(tables, t));
        if material != 0.0 {
            for (t, stiffness) in profile.membrane.iter().enumerate() {
                let mut forces = [0.0; SIZE];
                for (s, d) in stiffness.iter().enumerate() {
                    let d = d * material;
                    for &v in tables.samples[s].vectors() {
                        (3 * v..3 * v + 3).for_each(|i| forces[i] += d * rows[s][i]);
                    }
                }
                for &v in tables.samples[t].vectors() {
                    (3 * v..3 * v + 3).for_each(|j| add_column(&mut k[j], j, rows[t][j], &forces));
                }
            }
        }
        self.add_membrane_geometry(tables, stress, k);
        for (p, point) in self.points.iter().enumerate() {
            let d = profile.points[p].bending * material;
            point.add_stiffness(&tables.points[p], (&d, &stress.bending[p]), k);
            if profile.is_coupled && material != 0.0 {
                let c = point.gradients(&tables.points[p]);
                let coupling = profile.points[p].coupling * material;
                self.add_coupling(&c, (&rows, tables, p), coupling, &point.normal, k);
            }
        }
    }

    /// Adds the products of membrane strains and curvatures at a point.
    fn add_coupling(
        &self,
        c: &[Shape; 3],
        (rows, tables, point): (&[Row; MEMBRANE], &ShellTables, usize),
        coupling: Matrix3<f64>,
        n: &Vector3<f64>,
        k: &mut Square,
    ) {
        let mut strains = [[0.0; SIZE]; 3];
        for (t, row) in rows.iter().enumerate() {
            let (sampling, strain) = (tables.sampling[point][t], &mut strains[tables.samples[t].component]);
            strain.iter_mut().zip(row).for_each(|(sum, x)| *sum += sampling * x);
        }
        for (i, strain) in strains.iter().enumerate() {
            let mut moment = [0.0; SIZE];
            for a in 0..VECTORS {
                let of: f64 = (0..3).map(|j| coupling[(i, j)] * c[j][a]).sum();
                (0..3).for_each(|m| moment[3 * a + m] = -n[m] * of);
            }
            for j in 0..SIZE {
                add_column(&mut k[j], j, strain[j], &moment);
                add_column(&mut k[j], j, moment[j], strain);
            }
        }
    }

    /// Adds the stiffness of membrane stresses.
    #[inline(always)]
    fn add_membrane_geometry(&self, tables: &ShellTables, stress: &ShellStrains, k: &mut Square) {
        for (sample, &n) in tables.samples.iter().zip(&stress.membrane) {
            let [x, y] = &sample.shapes;
            let vectors = sample.vectors();
            for (place, &a) in vectors.iter().enumerate() {
                let (along, across) = match sample.component {
                    0 => (n * x[a], 0.0),
                    1 => (0.0, n * y[a]),
                    _ => (n * y[a], n * x[a]),
                };
                for &b in &vectors[place..] {
                    let value = along * x[b] + across * y[b];
                    (0..3).for_each(|i| k[3 * a + i][3 * b + i] += value);
                }
            }
        }
    }
}

impl BentPoint {
    /// Adds the stiffness of a point with the bending stiffness D and the moments m: with the gradients c, c_m = Σ m c, b_m = Σ m b
    /// and w_a = a^γ N_a,γ the blocks n nᵀ (c_a·D c_b + b_m w_a·w_b) + c_m,a w_b nᵀ + c_m,b n w_aᵀ.
    #[inline(always)]
    fn add_stiffness(&self, shapes: &[Shape; 5], (d, m): (&Matrix3<f64>, &Vector3<f64>), k: &mut Square) {
        let gradients = self.gradients(shapes);
        let n = &self.normal;
        let bent: f64 = (0..3).map(|i| VOIGT[i] * m[i] * self.second[i].dot(n)).sum();
        let (mut c, mut w, mut stress) = ([0.0; VECTORS], [[0.0; VECTORS]; 3], [[0.0; VECTORS]; 3]);
        for a in 0..VECTORS {
            for i in 0..3 {
                c[a] += m[i] * gradients[i][a];
                w[i][a] = self.dual[0][i] * shapes[0][a] + self.dual[1][i] * shapes[1][a];
                stress[i][a] = (0..3).map(|j| d[(i, j)] * gradients[j][a]).sum();
            }
        }
        // Columns w_b,i n and c_b, over the coordinates of all b.
        let mut turned = [[0.0; SIZE]; 3];
        for b in 0..VECTORS {
            for i in 0..3 {
                (0..3).for_each(|j| turned[i][3 * b + j] = w[i][b] * n[j]);
            }
        }
        for a in 0..VECTORS {
            let mut common = [0.0; SIZE];
            for b in a..VECTORS {
                let scalar: f64 =
                    (0..3).map(|i| stress[i][a] * gradients[i][b] + bent * w[i][a] * w[i][b]).sum();
                (0..3).for_each(|j| common[3 * b + j] = n[j] * scalar + c[b] * w[j][a]);
            }
            for i in 0..3 {
                let (column, turned, n, c) = (&mut k[3 * a + i], &turned[i], n[i], c[a]);
                for r in 3 * a..SIZE {
                    column[r] += n * common[r] + c * turned[r];
                }
            }
        }
    }
}

/// Adds x y to the column j of a lower triangle.
#[inline(always)]
fn add_column(column: &mut Row, j: usize, x: f64, y: &Row) {
    column[j..].iter_mut().zip(&y[j..]).for_each(|(value, y)| *value += x * y);
}
