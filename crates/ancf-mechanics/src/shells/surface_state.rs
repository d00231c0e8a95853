use nalgebra::Vector3;

use super::hermite::{Shape, VECTORS};
use super::profile::{BendingPoint, MEMBRANE, MembraneSample, POINTS, ShellProfile, ShellTables, sum};

/// Strains, strain rates or stresses of an element: membrane components at the sampling points, bending at the integration points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShellStrains {
    pub(crate) membrane: [f64; MEMBRANE],
    pub(crate) bending: [Vector3<f64>; POINTS],
}

impl ShellStrains {
    pub(crate) const ZERO: Self =
        Self { membrane: [0.0; MEMBRANE], bending: [Vector3::new(0.0, 0.0, 0.0); POINTS] };

    /// Adds a multiple of other strains.
    pub(crate) fn add(&mut self, factor: f64, other: &Self) {
        self.membrane.iter_mut().zip(&other.membrane).for_each(|(own, other)| *own += factor * other);
        self.bending.iter_mut().zip(&other.bending).for_each(|(own, other)| *own += other * factor);
    }
}

/// Factors of the components ξξ, ηη and ξη of a curvature in 2 ε_ξη notation.
pub(crate) const VOIGT: [f64; 3] = [1.0, 1.0, 2.0];

/// Surface at an integration point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BentPoint {
    /// Second derivatives r_ξξ, r_ηη, r_ξη.
    pub(crate) second: [Vector3<f64>; 3],
    pub(crate) tangents: [Vector3<f64>; 2],
    pub(crate) normal: Vector3<f64>,
    /// |r_ξ × r_η|.
    pub(crate) area: f64,
    /// Dual tangents a^ξ and a^η.
    pub(crate) dual: [Vector3<f64>; 2],
    /// Γ^γ_αβ = r_,αβ · a^γ.
    pub(crate) christoffel: [[f64; 2]; 3],
    /// Changes of curvature κ = −(b − B), b_αβ = r_,αβ · n.
    pub(crate) curvature: Vector3<f64>,
}

impl BentPoint {
    /// Evaluates the curvatures without cancellation, from the displacements u_ξ, u_η, u_ξξ, u_ηη, u_ξη.
    fn new(point: &BendingPoint, u: &[Vector3<f64>; 5]) -> Self {
        let reference = &point.reference;
        let tangents = [reference[0] + u[0], reference[1] + u[1]];
        let change = u[0].cross(&reference[1]) + reference[0].cross(&u[1]) + u[0].cross(&u[1]);
        let product = tangents[0].cross(&tangents[1]);
        let area = product.norm();
        let before = point.normal * point.area;
        let stretch = (2.0 * before.dot(&change) + change.dot(&change)) / (area + point.area);
        let (normal, turned) = (product / area, (change - point.normal * stretch) / area);
        let dual = [tangents[1].cross(&normal) / area, normal.cross(&tangents[0]) / area];
        let second = [2, 3, 4].map(|k| reference[k] + u[k]);
        let christoffel = second.map(|r| dual.map(|a| r.dot(&a)));
        let of = |k: usize| -VOIGT[k] * (u[k + 2].dot(&normal) + reference[k + 2].dot(&turned));
        let curvature = Vector3::new(of(0), of(1), of(2));
        Self { second, tangents, normal, area, dual, christoffel, curvature }
    }

    /// Returns c_αβ = N_,αβ − Γ^γ_αβ N_,γ with the factors of [`VOIGT`]: δκ_αβ = −n · Σ_a c_αβ,a δe_a.
    pub(crate) fn gradients(&self, shapes: &[Shape; 5]) -> [Shape; 3] {
        std::array::from_fn(|k| {
            let [along, across] = self.christoffel[k];
            std::array::from_fn(|a| {
                VOIGT[k] * (shapes[k + 2][a] - along * shapes[0][a] - across * shapes[1][a])
            })
        })
    }
}

/// Surface of an element in a state.
#[derive(Clone, Debug)]
pub(crate) struct SurfaceState {
    /// r_ξ and r_η at the sampling points.
    pub(crate) samples: [[Vector3<f64>; 2]; MEMBRANE],
    pub(crate) points: [BentPoint; POINTS],
    pub(crate) strains: ShellStrains,
}

impl SurfaceState {
    /// Evaluates an element with the displacements `q` of its nodal vectors.
    pub(crate) fn new(tables: &ShellTables, profile: &ShellProfile, q: &[Vector3<f64>; VECTORS]) -> Self {
        let mut strains = ShellStrains::ZERO;
        let samples = std::array::from_fn(|t| {
            let MembraneSample { component, shapes, .. } = &tables.samples[t];
            let [reference, u] = [profile.samples[t], shapes.each_ref().map(|shape| sum(shape, q))];
            strains.membrane[t] = match component {
                &k @ (0 | 1) => (reference[k] + u[k] * 0.5).dot(&u[k]),
                _ => reference[0].dot(&u[1]) + u[0].dot(&reference[1]) + u[0].dot(&u[1]),
            };
            [reference[0] + u[0], reference[1] + u[1]]
        });
        let points = std::array::from_fn(|k| {
            let u = tables.points[k].each_ref().map(|shape| sum(shape, q));
            let point = BentPoint::new(&profile.points[k], &u);
            strains.bending[k] = point.curvature;
            point
        });
        Self { samples, points, strains }
    }

    /// Computes the strain rates B(q) v.
    pub(crate) fn rates(&self, tables: &ShellTables, v: &[Vector3<f64>; VECTORS]) -> ShellStrains {
        let mut rates = ShellStrains::ZERO;
        for (t, [a, b]) in self.samples.iter().enumerate() {
            let MembraneSample { component, shapes, .. } = &tables.samples[t];
            rates.membrane[t] = match component {
                0 => a.dot(&sum(&shapes[0], v)),
                1 => b.dot(&sum(&shapes[1], v)),
                _ => a.dot(&sum(&shapes[1], v)) + b.dot(&sum(&shapes[0], v)),
            };
        }
        for (k, point) in self.points.iter().enumerate() {
            let u = tables.points[k].each_ref().map(|shape| sum(shape, v));
            let [x, y] = [u[0].dot(&point.normal), u[1].dot(&point.normal)];
            let of = |i: usize| {
                let [along, across] = point.christoffel[i];
                -VOIGT[i] * (u[i + 2].dot(&point.normal) - along * x - across * y)
            };
            rates.bending[k] = Vector3::new(of(0), of(1), of(2));
        }
        rates
    }

    /// Adds the forces B(q)ᵀ σ of stresses on the nodal vectors.
    pub(crate) fn distribute(
        &self,
        tables: &ShellTables,
        stress: &ShellStrains,
        force: &mut [Vector3<f64>; VECTORS],
    ) {
        for (t, [a, b]) in self.samples.iter().enumerate() {
            let (MembraneSample { component, shapes: [x, y], .. }, n) =
                (&tables.samples[t], stress.membrane[t]);
            let (along, across) = match component {
                0 => (a * n, Vector3::zeros()),
                1 => (Vector3::zeros(), b * n),
                _ => (b * n, a * n),
            };
            for (i, force) in force.iter_mut().enumerate() {
                *force += along * x[i] + across * y[i];
            }
        }
        for (k, point) in self.points.iter().enumerate() {
            let (m, shapes) = (&stress.bending[k], &tables.points[k]);
            let weights: [f64; 3] = std::array::from_fn(|i| VOIGT[i] * m[i]);
            let [x, y] =
                [0, 1].map(|g| -> f64 { (0..3).map(|i| weights[i] * point.christoffel[i][g]).sum() });
            for (a, force) in force.iter_mut().enumerate() {
                let c = weights[0] * shapes[2][a] + weights[1] * shapes[3][a] + weights[2] * shapes[4][a]
                    - x * shapes[0][a]
                    - y * shapes[1][a];
                *force -= point.normal * c;
            }
        }
    }
}

impl ShellProfile {
    /// Computes the stresses D ε, integrated with the weights of the points.
    pub(crate) fn stress(&self, tables: &ShellTables, strains: &ShellStrains) -> ShellStrains {
        let mut stress = ShellStrains::ZERO;
        for (n, row) in stress.membrane.iter_mut().zip(&*self.membrane) {
            *n = row.iter().zip(&strains.membrane).map(|(d, strain)| d * strain).sum();
        }
        for (k, point) in self.points.iter().enumerate() {
            stress.bending[k] = point.bending * strains.bending[k];
            if self.is_coupled {
                let n = point.coupling * strains.bending[k];
                let mut strain = Vector3::zeros();
                for (t, MembraneSample { component, .. }) in tables.samples.iter().enumerate() {
                    strain[*component] += tables.sampling[k][t] * strains.membrane[t];
                    stress.membrane[t] += tables.sampling[k][t] * n[*component];
                }
                stress.bending[k] += point.coupling.transpose() * strain;
            }
        }
        stress
    }
}
