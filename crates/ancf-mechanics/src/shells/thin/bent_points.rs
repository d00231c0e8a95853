use nalgebra::{Matrix3, Vector3};
use pulp::Simd;

use super::hermite::VECTORS;
use super::tables::{FIRST, MEMBRANE, POINTS, ShellTables};
use crate::lanes::{Lane, Row, VectorRows, added, cross, dot, load, minus, of_lane, plus, scaled, store};

/// Factors of the components ξξ, ηη and ξη of a curvature in 2 ε_ξη notation.
pub(crate) const VOIGT: [f64; 3] = [1.0, 1.0, 2.0];

/// Reference surface and bending stiffness at the integration points of an element, one lane for each point.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BendingPoints {
    /// Reference values of r_ξ, r_η, r_ξξ, r_ηη, r_ξη.
    reference: [VectorRows; 5],
    /// Unit normals and their magnitudes before normalisation.
    normals: VectorRows,
    pub(crate) areas: Row,
    /// A and D for covariant components, times the weights: the rows of the upper triangles.
    membrane: [Row; 6],
    bending: [Row; 6],
}

/// Reference surface at an integration point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BendingPoint {
    /// Values of r_ξ, r_η, r_ξξ, r_ηη, r_ξη.
    pub(crate) reference: [Vector3<f64>; 5],
    pub(crate) area: f64,
}

/// Places of the entries of a symmetric matrix in its upper triangle.
const UPPER: [[usize; 3]; 3] = [[0, 1, 2], [1, 3, 4], [2, 4, 5]];

/// Computes the products of symmetric matrices with vectors.
#[inline(always)]
fn products<S: Simd>(simd: S, matrices: &[Row; 6], x: &VectorRows) -> VectorRows {
    let mut products = [Row::ZERO; 3];
    for v in 0..VECTORS / S::F64_LANES {
        let x = load(simd, x, v);
        for i in 0..3 {
            let [a, b, c] = UPPER[i];
            let row = [matrices[a].lane(simd, v), matrices[b].lane(simd, v), matrices[c].lane(simd, v)];
            products[i].store::<S>(v, dot(row, x).register());
        }
    }
    products
}

impl BendingPoints {
    pub(crate) const ZERO: Self = Self {
        reference: [[Row::ZERO; 3]; 5],
        normals: [Row::ZERO; 3],
        areas: Row::ZERO,
        membrane: [Row::ZERO; 6],
        bending: [Row::ZERO; 6],
    };

    /// Sets the point k.
    pub(crate) fn set(&mut self, k: usize, reference: &[Vector3<f64>; 5], [a, d]: [&Matrix3<f64>; 2]) {
        let normal = reference[0].cross(&reference[1]);
        self.areas.0[k] = normal.norm();
        for i in 0..3 {
            self.normals[i].0[k] = normal[i] / normal.norm();
            self.reference.iter_mut().zip(reference).for_each(|(rows, x)| rows[i].0[k] = x[i]);
            for j in i..3 {
                self.membrane[UPPER[i][j]].0[k] = a[(i, j)];
                self.bending[UPPER[i][j]].0[k] = d[(i, j)];
            }
        }
    }

    /// Returns A of the point k.
    pub(crate) fn membrane(&self, k: usize) -> Matrix3<f64> {
        Matrix3::from_fn(|i, j| self.membrane[UPPER[i][j]].0[k])
    }

    /// Returns D of the point k.
    #[inline(always)]
    pub(crate) fn bending(&self, k: usize) -> Matrix3<f64> {
        Matrix3::from_fn(|i, j| self.bending[UPPER[i][j]].0[k])
    }

    /// Returns the point k.
    pub(crate) fn at(&self, k: usize) -> BendingPoint {
        let reference = self.reference.each_ref().map(|rows| of_lane(rows, k));
        BendingPoint { reference, area: self.areas.0[k] }
    }

    /// Computes the moments D κ of curvatures.
    #[inline(always)]
    pub(crate) fn moments<S: Simd>(&self, simd: S, curvatures: &VectorRows) -> VectorRows {
        products(simd, &self.bending, curvatures)
    }

    /// Computes the forces of membrane strains, integrated over the element.
    #[inline(always)]
    pub(crate) fn membrane_stress<S: Simd>(
        &self,
        simd: S,
        tables: &ShellTables,
        strains: &[f64; MEMBRANE],
    ) -> [f64; MEMBRANE] {
        let (mut stress, mut at_points) = ([0.0; MEMBRANE], [Row::ZERO; 3]);
        for v in 0..VECTORS / S::F64_LANES {
            for c in 0..3 {
                let mut sum = Lane::splat(simd, 0.0);
                for t in FIRST[c]..FIRST[c + 1] {
                    sum = tables.of_strains[t].lane(simd, v).mul_add(Lane::splat(simd, strains[t]), sum);
                }
                at_points[c].store::<S>(v, sum.register());
            }
        }
        let forces = products(simd, &self.membrane, &at_points);
        for c in 0..3 {
            let mut row = Row::ZERO;
            for v in 0..VECTORS / S::F64_LANES {
                let mut sum = Lane::splat(simd, 0.0);
                for k in 0..POINTS {
                    let force = Lane::splat(simd, forces[c].0[k]);
                    sum = tables.of_points[k][c].lane(simd, v).mul_add(force, sum);
                }
                row.store::<S>(v, sum.register());
            }
            let own = &mut stress[FIRST[c]..FIRST[c + 1]];
            own.copy_from_slice(&row.0[..own.len()]);
        }
        stress
    }

    /// Computes the areas |r_ξ × r_η| for the displacements u_ξ and u_η.
    #[inline(always)]
    pub(crate) fn displaced_areas<S: Simd>(&self, simd: S, [x, y]: [&VectorRows; 2]) -> Row {
        let mut areas = Row::ZERO;
        for v in 0..VECTORS / S::F64_LANES {
            let a = added(load(simd, &self.reference[0], v), load(simd, x, v));
            let b = added(load(simd, &self.reference[1], v), load(simd, y, v));
            let product = cross(a, b);
            areas.store::<S>(v, dot(product, product).sqrt().register());
        }
        areas
    }
}

/// Surface of a state at the integration points of an element, one lane for each point.
///
/// Closures are avoided around SIMD operations: a closure that is not inlined is compiled without vector units.
#[derive(Clone, Debug)]
pub(crate) struct BentPoints {
    second: [VectorRows; 3],
    tangents: [VectorRows; 2],
    normals: VectorRows,
    dual: [VectorRows; 2],
    christoffel: [[Row; 2]; 3],
}

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
}

impl BentPoints {
    pub(crate) const ZERO: Self = Self {
        second: [[Row::ZERO; 3]; 3],
        tangents: [[Row::ZERO; 3]; 2],
        normals: [Row::ZERO; 3],
        dual: [[Row::ZERO; 3]; 2],
        christoffel: [[Row::ZERO; 2]; 3],
    };

    /// Returns the point k.
    #[inline(always)]
    pub(crate) fn at(&self, k: usize) -> BentPoint {
        BentPoint {
            second: self.second.each_ref().map(|rows| of_lane(rows, k)),
            tangents: self.tangents.each_ref().map(|rows| of_lane(rows, k)),
            normal: of_lane(&self.normals, k),
            dual: self.dual.each_ref().map(|rows| of_lane(rows, k)),
            christoffel: self.christoffel.each_ref().map(|of| of.each_ref().map(|row| row.0[k])),
        }
    }

    /// Evaluates the surface from the displacements u_ξ, u_η, u_ξξ, u_ηη, u_ξη. Returns the changes of curvature κ = −(b − B),
    /// b_αβ = r_,αβ · n, without cancellation.
    #[inline(always)]
    pub(crate) fn set<S: Simd>(&mut self, simd: S, rest: &BendingPoints, u: &[VectorRows]) -> VectorRows {
        let mut curvatures = [Row::ZERO; 3];
        for v in 0..VECTORS / S::F64_LANES {
            let [x, y] = [load(simd, &rest.reference[0], v), load(simd, &rest.reference[1], v)];
            let [u_x, u_y] = [load(simd, &u[0], v), load(simd, &u[1], v)];
            let tangents = [added(x, u_x), added(y, u_y)];
            let change = added(added(cross(u_x, y), cross(x, u_y)), cross(u_x, u_y));
            let product = cross(tangents[0], tangents[1]);
            let (area, before) = (dot(product, product).sqrt(), rest.areas.lane(simd, v));
            let over_area = Lane::splat(simd, 1.0).over(area);
            let unit = load(simd, &rest.normals, v);
            let twice = scaled(unit, before + before);
            let stretch = (dot(twice, change) + dot(change, change)).over(area + before);
            let normal = scaled(product, over_area);
            let turned = scaled(minus(change, scaled(unit, stretch)), over_area);
            let dual = [
                scaled(cross(tangents[1], normal), over_area),
                scaled(cross(normal, tangents[0]), over_area),
            ];
            store(&mut self.normals, v, normal);
            for g in 0..2 {
                store(&mut self.tangents[g], v, tangents[g]);
                store(&mut self.dual[g], v, dual[g]);
            }
            for k in 0..3 {
                let moved = load(simd, &u[k + 2], v);
                let rest = load(simd, &rest.reference[k + 2], v);
                let second = added(rest, moved);
                store(&mut self.second[k], v, second);
                for g in 0..2 {
                    self.christoffel[k][g].store::<S>(v, dot(second, dual[g]).register());
                }
                let curvature = (dot(moved, normal) + dot(rest, turned)) * Lane::splat(simd, -VOIGT[k]);
                curvatures[k].store::<S>(v, curvature.register());
            }
        }
        curvatures
    }

    /// Computes the rates of the curvatures from the gradients of velocities.
    #[inline(always)]
    pub(crate) fn rates<S: Simd>(&self, simd: S, u: &[VectorRows]) -> VectorRows {
        let mut rates = [Row::ZERO; 3];
        for v in 0..VECTORS / S::F64_LANES {
            let normal = load(simd, &self.normals, v);
            let (x, y) = (dot(load(simd, &u[0], v), normal), dot(load(simd, &u[1], v), normal));
            for k in 0..3 {
                let (of_x, of_y) =
                    (self.christoffel[k][0].lane(simd, v), self.christoffel[k][1].lane(simd, v));
                let bent = dot(load(simd, &u[k + 2], v), normal) - of_x * x - of_y * y;
                rates[k].store::<S>(v, (bent * Lane::splat(simd, -VOIGT[k])).register());
            }
        }
        rates
    }

    /// Computes the forces of moments on the derivatives r_ξ, r_η, r_ξξ, r_ηη, r_ξη.
    #[inline(always)]
    pub(crate) fn factors<S: Simd>(&self, simd: S, moments: &VectorRows, factors: &mut [VectorRows; 5]) {
        for v in 0..VECTORS / S::F64_LANES {
            let normal = load(simd, &self.normals, v);
            let mut of_tangents = [scaled(normal, Lane::splat(simd, 0.0)); 2];
            for k in 0..3 {
                let moment = moments[k].lane(simd, v) * Lane::splat(simd, VOIGT[k]);
                let force = scaled(normal, moment);
                for g in 0..2 {
                    of_tangents[g] = plus(of_tangents[g], force, self.christoffel[k][g].lane(simd, v));
                }
                store(&mut factors[k + 2], v, scaled(normal, -moment));
            }
            store(&mut factors[0], v, of_tangents[0]);
            store(&mut factors[1], v, of_tangents[1]);
        }
    }
}

impl BentPoint {
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
