use nalgebra::Vector3;

use pulp::{Arch, Simd, WithSimd};

use super::bent_points::BentPoints;
use super::hermite::VECTORS;
use super::profile::ShellProfile;
use super::tables::{
    DIRECT, GRADIENTS, MEMBRANE, POINTS, SHEARS, ShellTables, TANGENT_LISTS, TANGENTS, tangent_place,
};
use crate::lanes::{Lane, Row, VectorRows, add_sums, added, dot, dot_add, load, of_lane, scaled, store};

/// Strains, strain rates or stresses of an element: membrane components at the sampling points, bending at the integration points.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShellStrains {
    pub(crate) membrane: [f64; MEMBRANE],
    bending: VectorRows,
}

impl ShellStrains {
    pub(crate) const ZERO: Self = Self { membrane: [0.0; MEMBRANE], bending: [Row::ZERO; 3] };

    /// Adds a multiple of other strains.
    pub(crate) fn add(&mut self, factor: f64, other: &Self) {
        self.membrane.iter_mut().zip(&other.membrane).for_each(|(own, other)| *own += factor * other);
        for (own, other) in self.bending.iter_mut().zip(&other.bending) {
            own.0.iter_mut().zip(&other.0).for_each(|(own, other)| *own += factor * other);
        }
    }

    /// Returns Σ σ ε of stresses and strains.
    pub(crate) fn product(&self, strains: &Self) -> f64 {
        let membrane: f64 = self.membrane.iter().zip(&strains.membrane).map(|(n, e)| n * e).sum();
        let rows = self.bending.iter().zip(&strains.bending);
        let bending: f64 = rows.flat_map(|(m, k)| m.0.iter().zip(&k.0)).map(|(m, k)| m * k).sum();
        membrane + bending
    }

    /// Returns the curvatures or moments at an integration point.
    #[inline(always)]
    pub(crate) fn bending(&self, point: usize) -> Vector3<f64> {
        of_lane(&self.bending, point)
    }

    pub(crate) fn set_bending(&mut self, point: usize, x: &Vector3<f64>) {
        self.bending.iter_mut().zip(x.iter()).for_each(|(row, x)| row.0[point] = *x);
    }
}

/// Displacement gradients of an element, or velocity gradients: the five derivatives at the integration points, then the tangents at
/// the sampling points.
type Gradients = [VectorRows; GRADIENTS];

/// Membrane strains in the order of the direct strains in two rows and of the shear strains in one.
type MembraneRows = [Row; 3];

fn from_rows(rows: &MembraneRows) -> [f64; MEMBRANE] {
    let mut membrane = [0.0; MEMBRANE];
    membrane[..VECTORS].copy_from_slice(&rows[0].0);
    membrane[VECTORS..DIRECTS].copy_from_slice(&rows[1].0[..DIRECTS - VECTORS]);
    membrane[DIRECTS..].copy_from_slice(&rows[2].0[..SHEARS]);
    membrane
}

fn to_rows(membrane: &[f64; MEMBRANE]) -> MembraneRows {
    let mut rows = [Row::ZERO; 3];
    rows[0].0.copy_from_slice(&membrane[..VECTORS]);
    rows[1].0[..DIRECTS - VECTORS].copy_from_slice(&membrane[VECTORS..DIRECTS]);
    rows[2].0[..SHEARS].copy_from_slice(&membrane[DIRECTS..]);
    rows
}

/// Number of strains of both directions.
const DIRECTS: usize = 2 * DIRECT;

/// Computes the gradients of an element.
#[inline(always)]
fn gradients<S: Simd>(simd: S, tables: &ShellTables, x: &[Vector3<f64>; VECTORS]) -> Gradients {
    let mut gradients = [[Row::ZERO; 3]; GRADIENTS];
    for (sums, rows) in gradients.iter_mut().zip(&*tables.gradients) {
        add_sums(simd, VECTORS, |a| (x[a].into(), &rows[a]), sums);
    }
    gradients
}

/// Computes the areas |r_ξ × r_η| at the integration points.
pub(crate) fn surface_areas(
    tables: &ShellTables,
    profile: &ShellProfile,
    q: &[Vector3<f64>; VECTORS],
) -> [f64; POINTS] {
    struct Job<'a>(&'a ShellTables, &'a ShellProfile, &'a [Vector3<f64>; VECTORS]);

    impl WithSimd for Job<'_> {
        type Output = Row;

        #[inline(always)]
        fn with_simd<S: Simd>(self, simd: S) -> Row {
            let Self(tables, profile, q) = self;
            let mut u = [[Row::ZERO; 3]; 2];
            for (sums, rows) in u.iter_mut().zip(&*tables.gradients) {
                add_sums(simd, VECTORS, |a| (q[a].into(), &rows[a]), sums);
            }
            profile.points.displaced_areas(simd, [&u[0], &u[1]])
        }
    }

    Arch::new().dispatch(Job(tables, profile, q)).0
}

/// Surface of an element in a state.
#[derive(Clone, Debug)]
pub(crate) struct SurfaceState {
    /// Tangents at the sampling points, in the lists of [`tangent_place`].
    tangents: [VectorRows; TANGENT_LISTS],
    pub(crate) points: BentPoints,
    pub(crate) strains: ShellStrains,
}

impl SurfaceState {
    /// Evaluates an element with the displacements `q` of its nodal vectors.
    pub(crate) fn new(tables: &ShellTables, profile: &ShellProfile, q: &[Vector3<f64>; VECTORS]) -> Self {
        struct Job<'a> {
            of: (&'a ShellTables, &'a ShellProfile),
            q: &'a [Vector3<f64>; VECTORS],
            state: &'a mut SurfaceState,
        }

        impl WithSimd for Job<'_> {
            type Output = ();

            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) {
                let Self { of: (tables, profile), q, state } = self;
                let gradients = gradients(simd, tables, q);
                state.strains.bending = state.points.set(simd, &profile.points, &gradients[..5]);
                let (reference, u) = (&profile.tangents, &gradients[5..]);
                let mut strains = [Row::ZERO; 3];
                let half = Lane::splat(simd, 0.5);
                for v in 0..VECTORS / S::F64_LANES {
                    for list in 0..TANGENT_LISTS {
                        let (rest, u) = (load(simd, &reference[list], v), load(simd, &u[list], v));
                        store(&mut state.tangents[list], v, added(rest, u));
                        if list < 2 {
                            strains[list].store::<S>(v, dot(added(rest, scaled(u, half)), u).register());
                        }
                    }
                    let (a, x) = (load(simd, &reference[2], v), load(simd, &u[2], v));
                    let (b, y) = (load(simd, &reference[3], v), load(simd, &u[3], v));
                    strains[2].store::<S>(v, (dot(a, y) + dot(x, b) + dot(x, y)).register());
                }
                state.strains.membrane = from_rows(&strains);
            }
        }

        let mut state = Self {
            tangents: [[Row::ZERO; 3]; TANGENT_LISTS],
            points: BentPoints::ZERO,
            strains: ShellStrains::ZERO,
        };
        Arch::new().dispatch(Job { of: (tables, profile), q, state: &mut state });
        state
    }

    /// Returns a tangent at a sampling point.
    #[inline(always)]
    pub(crate) fn tangent(&self, r: usize) -> Vector3<f64> {
        let [list, k] = tangent_place(r);
        of_lane(&self.tangents[list], k)
    }

    /// Computes the strain rates B(q) v.
    pub(crate) fn rates(&self, tables: &ShellTables, v: &[Vector3<f64>; VECTORS]) -> ShellStrains {
        struct Job<'a>(&'a SurfaceState, &'a ShellTables, &'a [Vector3<f64>; VECTORS], &'a mut ShellStrains);

        impl WithSimd for Job<'_> {
            type Output = ();

            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) {
                let Self(state, tables, x, rates) = self;
                let gradients = gradients(simd, tables, x);
                rates.bending = state.points.rates(simd, &gradients[..5]);
                let u = &gradients[5..];
                let mut strains = [Row::ZERO; 3];
                for v in 0..VECTORS / S::F64_LANES {
                    for list in 0..2 {
                        let product = dot(load(simd, &state.tangents[list], v), load(simd, &u[list], v));
                        strains[list].store::<S>(v, product.register());
                    }
                    let shear = dot_add(
                        load(simd, &state.tangents[2], v),
                        load(simd, &u[3], v),
                        dot(load(simd, &state.tangents[3], v), load(simd, &u[2], v)),
                    );
                    strains[2].store::<S>(v, shear.register());
                }
                rates.membrane = from_rows(&strains);
            }
        }

        let mut rates = ShellStrains::ZERO;
        Arch::new().dispatch(Job(self, tables, v, &mut rates));
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
            state: &'a SurfaceState,
            stress: &'a ShellStrains,
            moved: &'a [Vector3<f64>; VECTORS],
            of: (&'a ShellTables, &'a ShellProfile),
            sums: &'a mut VectorRows,
        }

        impl WithSimd for Job<'_> {
            type Output = ();

            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) {
                let Self { state, stress, moved, of: (tables, profile), sums } = self;
                add_sums(simd, VECTORS, |a| (moved[a].into(), &profile.mass[a]), sums);
                let tangents = state.tangent_forces(simd, stress);
                let of_tangent = |r: usize| {
                    let ([list, k], rows) = (tangent_place(r), &tables.tangents[r]);
                    ([tangents[list][0].0[k], tangents[list][1].0[k], tangents[list][2].0[k]], rows)
                };
                add_sums(simd, TANGENTS, of_tangent, sums);
                let mut points = [[Row::ZERO; 3]; 5];
                state.points.factors(simd, &stress.bending, &mut points);
                let of_point = |r: usize| {
                    let (k, rows) = (r / 5, &points[r % 5]);
                    ([rows[0].0[k], rows[1].0[k], rows[2].0[k]], &tables.points[k][r % 5])
                };
                add_sums(simd, 5 * POINTS, of_point, sums);
            }
        }

        let mut sums = [Row::ZERO; 3];
        Arch::new().dispatch(Job { state: self, stress, moved, of: (tables, profile), sums: &mut sums });
        std::array::from_fn(|a| of_lane(&sums, a))
    }

    /// Computes the forces of membrane stresses on the tangents at the sampling points.
    #[inline(always)]
    fn tangent_forces<S: Simd>(&self, simd: S, stress: &ShellStrains) -> [VectorRows; TANGENT_LISTS] {
        let (rows, mut forces) = (to_rows(&stress.membrane), [[Row::ZERO; 3]; TANGENT_LISTS]);
        for v in 0..VECTORS / S::F64_LANES {
            // A shear stress acts on r_ξ along r_η and the other way round.
            for (list, of, row) in [(0, 0, 0), (1, 1, 1), (2, 3, 2), (3, 2, 2)] {
                let force = scaled(load(simd, &self.tangents[of], v), rows[row].lane(simd, v));
                store(&mut forces[list], v, force);
            }
        }
        forces
    }
}

impl ShellProfile {
    /// Computes the stresses D ε, integrated with the weights of the points.
    pub(crate) fn stress(&self, tables: &ShellTables, strains: &ShellStrains) -> ShellStrains {
        struct Job<'a>(&'a ShellProfile, &'a ShellTables, &'a ShellStrains);

        impl WithSimd for Job<'_> {
            type Output = ShellStrains;

            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) -> ShellStrains {
                let Self(profile, tables, strains) = self;
                ShellStrains {
                    membrane: profile.points.membrane_stress(simd, tables, &strains.membrane),
                    bending: profile.points.moments(simd, &strains.bending),
                }
            }
        }

        let mut stress = Arch::new().dispatch(Job(self, tables, strains));
        for (k, coupling) in self.coupling.iter().enumerate() {
            let strain = tables.membrane_strain(k, &strains.membrane);
            tables.add_membrane_force(k, &(coupling * strains.bending(k)), &mut stress.membrane);
            stress.set_bending(k, &(stress.bending(k) + coupling.transpose() * strain));
        }
        stress
    }

    /// Computes the moments D κ of curvatures alone.
    pub(crate) fn moments(&self, strains: &ShellStrains) -> ShellStrains {
        struct Job<'a>(&'a ShellProfile, &'a ShellStrains);

        impl WithSimd for Job<'_> {
            type Output = VectorRows;

            #[inline(always)]
            fn with_simd<S: Simd>(self, simd: S) -> VectorRows {
                self.0.points.moments(simd, &self.1.bending)
            }
        }

        ShellStrains { membrane: [0.0; MEMBRANE], bending: Arch::new().dispatch(Job(self, strains)) }
    }
}
