use nalgebra::Vector3;

use pulp::{Arch, Simd, WithSimd};

use super::hermite::VECTORS;
use super::profile::{
    BendingPoint, GRADIENTS, MEMBRANE, POINTS, SHEARS, ShellProfile, ShellTables, TANGENTS,
};
use super::rows::{Row, add_sums};

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

    /// Returns Σ σ ε of stresses and strains.
    pub(crate) fn product(&self, strains: &Self) -> f64 {
        let membrane: f64 = self.membrane.iter().zip(&strains.membrane).map(|(n, e)| n * e).sum();
        let bending: f64 = self.bending.iter().zip(&strains.bending).map(|(m, k)| m.dot(k)).sum();
        membrane + bending
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
        Self { second, tangents, normal, dual, christoffel, curvature }
    }

    /// Returns c_αβ = N_,αβ − Γ^γ_αβ N_,γ with the factors of [`VOIGT`]: δκ_αβ = −n · Σ_a c_αβ,a δe_a.
    pub(crate) fn gradients(&self, shapes: &[Row; 5]) -> [Row; 3] {
        std::array::from_fn(|k| {
            let [along, across] = self.christoffel[k];
            Row(std::array::from_fn(|a| {
                VOIGT[k] * (shapes[k + 2].0[a] - along * shapes[0].0[a] - across * shapes[1].0[a])
            }))
        })
    }
}

/// Displacement gradients of an element, or velocity gradients.
struct Gradients([[Row; 3]; GRADIENTS]);

impl Gradients {
    fn new(tables: &ShellTables, x: &[Vector3<f64>; VECTORS]) -> Self {
        struct Job<'a>(&'a ShellTables, &'a [Vector3<f64>; VECTORS], &'a mut Gradients);

        impl WithSimd for Job<'_> {
            type Output = ();

            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) {
                let Self(tables, x, gradients) = self;
                for (sums, rows) in gradients.0.iter_mut().zip(&*tables.gradients) {
                    add_sums(simd, VECTORS, |a| (x[a].into(), &rows[a]), sums);
                }
            }
        }

        let mut gradients = Self([[Row::ZERO; 3]; GRADIENTS]);
        Arch::new().dispatch(Job(tables, x, &mut gradients));
        gradients
    }

    /// Returns the derivatives at an integration point.
    fn at_point(&self, k: usize) -> [Vector3<f64>; 5] {
        std::array::from_fn(|g| self.0[g].each_ref().map(|row| row.0[k]).into())
    }

    /// Returns a tangent at a sampling point.
    fn tangent(&self, r: usize) -> Vector3<f64> {
        self.0[5 + r / VECTORS].each_ref().map(|row| row.0[r % VECTORS]).into()
    }

    /// Returns the derivatives by ξ and η that the membrane strain t contains. The other one is zero.
    fn at_sample(&self, tables: &ShellTables, t: usize) -> [Vector3<f64>; 2] {
        match tables.samples[t].component {
            0 => [self.tangent(t), Vector3::zeros()],
            1 => [Vector3::zeros(), self.tangent(t)],
            _ => [self.tangent(t), self.tangent(t + SHEARS)],
        }
    }
}

/// Computes the areas |r_ξ × r_η| at the integration points.
pub(crate) fn surface_areas(
    tables: &ShellTables,
    profile: &ShellProfile,
    q: &[Vector3<f64>; VECTORS],
) -> [f64; POINTS] {
    let gradients = Gradients::new(tables, q);
    std::array::from_fn(|k| {
        let ([x, y, ..], [u, v, ..]) = (profile.points[k].reference, gradients.at_point(k));
        (x + u).cross(&(y + v)).norm()
    })
}

/// Surface of an element in a state.
#[derive(Clone, Debug)]
pub(crate) struct SurfaceState {
    /// r_ξ and r_η at the sampling points, as far as the strain contains them.
    pub(crate) samples: [[Vector3<f64>; 2]; MEMBRANE],
    pub(crate) points: [BentPoint; POINTS],
    pub(crate) strains: ShellStrains,
}

impl SurfaceState {
    /// Evaluates an element with the displacements `q` of its nodal vectors.
    pub(crate) fn new(tables: &ShellTables, profile: &ShellProfile, q: &[Vector3<f64>; VECTORS]) -> Self {
        let gradients = Gradients::new(tables, q);
        let mut strains = ShellStrains::ZERO;
        let samples = std::array::from_fn(|t| {
            let [reference, u] = [profile.samples[t], gradients.at_sample(tables, t)];
            strains.membrane[t] = match tables.samples[t].component {
                k @ (0 | 1) => (reference[k] + u[k] * 0.5).dot(&u[k]),
                _ => reference[0].dot(&u[1]) + u[0].dot(&reference[1]) + u[0].dot(&u[1]),
            };
            [reference[0] + u[0], reference[1] + u[1]]
        });
        let points = std::array::from_fn(|k| {
            let point = BentPoint::new(&profile.points[k], &gradients.at_point(k));
            strains.bending[k] = point.curvature;
            point
        });
        Self { samples, points, strains }
    }

    /// Computes the strain rates B(q) v.
    pub(crate) fn rates(&self, tables: &ShellTables, v: &[Vector3<f64>; VECTORS]) -> ShellStrains {
        let (mut rates, gradients) = (ShellStrains::ZERO, Gradients::new(tables, v));
        for (t, [a, b]) in self.samples.iter().enumerate() {
            let [x, y] = gradients.at_sample(tables, t);
            rates.membrane[t] = match tables.samples[t].component {
                0 => a.dot(&x),
                1 => b.dot(&y),
                _ => a.dot(&y) + b.dot(&x),
            };
        }
        for (k, point) in self.points.iter().enumerate() {
            let u = gradients.at_point(k);
            let [x, y] = [u[0].dot(&point.normal), u[1].dot(&point.normal)];
            let of = |i: usize| {
                let [along, across] = point.christoffel[i];
                -VOIGT[i] * (u[i + 2].dot(&point.normal) - along * x - across * y)
            };
            rates.bending[k] = Vector3::new(of(0), of(1), of(2));
        }
        rates
    }

    /// Computes the forces B(q)ᵀ σ of stresses on the nodal vectors, and Mᵀ a of the given vectors a.
    pub(crate) fn forces(
        &self,
        (tables, profile): (&ShellTables, &ShellProfile),
        stress: &ShellStrains,
        moved: &[Vector3<f64>; VECTORS],
    ) -> [Vector3<f64>; VECTORS] {
        struct Job<'a> {
            factors: &'a Factors,
            moved: &'a [Vector3<f64>; VECTORS],
            of: (&'a ShellTables, &'a ShellProfile),
            sums: &'a mut [Row; 3],
        }

        impl WithSimd for Job<'_> {
            type Output = ();

            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) {
                let Self { factors, moved, of: (tables, profile), sums } = self;
                add_sums(simd, VECTORS, |a| (moved[a].into(), &profile.mass[a]), sums);
                add_sums(simd, TANGENTS, |r| (factors.tangents[r], &tables.tangents[r]), sums);
                let point = |r: usize| (factors.points[r / 5][r % 5], &tables.points[r / 5][r % 5]);
                add_sums(simd, 5 * POINTS, point, sums);
            }
        }

        let mut sums = [Row::ZERO; 3];
        let factors = self.force_factors(tables, stress);
        Arch::new().dispatch(Job { factors: &factors, moved, of: (tables, profile), sums: &mut sums });
        std::array::from_fn(|a| sums.each_ref().map(|row| row.0[a]).into())
    }

    /// Returns the forces of stresses on the tangents and second derivatives.
    fn force_factors(&self, tables: &ShellTables, stress: &ShellStrains) -> Factors {
        let mut factors = Factors { tangents: [[0.0; 3]; TANGENTS], points: [[[0.0; 3]; 5]; POINTS] };
        for (t, ([a, b], n)) in self.samples.iter().zip(&stress.membrane).enumerate() {
            let (along, across) = ((a * *n).into(), (b * *n).into());
            match tables.samples[t].component {
                0 => factors.tangents[t] = along,
                1 => factors.tangents[t] = across,
                _ => (factors.tangents[t], factors.tangents[t + SHEARS]) = (across, along),
            }
        }
        for (k, point) in self.points.iter().enumerate() {
            let m = &stress.bending[k];
            let weights: [f64; 3] = std::array::from_fn(|i| VOIGT[i] * m[i]);
            let [x, y] =
                [0, 1].map(|g| -> f64 { (0..3).map(|i| weights[i] * point.christoffel[i][g]).sum() });
            let of = [x, y, -weights[0], -weights[1], -weights[2]];
            factors.points[k] = of.map(|factor| (point.normal * factor).into());
        }
        factors
    }
}

/// Forces on the tangents at the sampling points and on the derivatives at the integration points.
struct Factors {
    tangents: [[f64; 3]; TANGENTS],
    points: [[[f64; 3]; 5]; POINTS],
}

impl ShellProfile {
    /// Computes the stresses D ε, integrated with the weights of the points.
    pub(crate) fn stress(&self, tables: &ShellTables, strains: &ShellStrains) -> ShellStrains {
        let mut stress = self.moments(strains);
        stress.membrane = self.membrane.stress(&strains.membrane);
        for (k, point) in self.points.iter().enumerate().filter(|_| self.is_coupled) {
            let strain = tables.membrane_strain(k, &strains.membrane);
            tables.add_membrane_force(k, &(point.coupling * strains.bending[k]), &mut stress.membrane);
            stress.bending[k] += point.coupling.transpose() * strain;
        }
        stress
    }

    /// Computes the moments D κ of curvatures alone.
    pub(crate) fn moments(&self, strains: &ShellStrains) -> ShellStrains {
        let mut stress = ShellStrains::ZERO;
        for ((moment, point), curvature) in stress.bending.iter_mut().zip(&self.points).zip(&strains.bending)
        {
            *moment = point.bending * curvature;
        }
        stress
    }
}
