//! Strains of a shell element as sums of products of vectors of its surface.

use nalgebra::{SMatrix, Vector3};

use super::faces::{NODES, Shape, ShapeValues};

/// Largest number of nodal vectors of an element: r and d of each node.
pub const FACE_VECTORS: usize = 2 * NODES;
/// Number of strains of the surface at an integration point: ε and κ, three components each.
pub(crate) const SURFACE: usize = 6;

/// Weights of the nodal vectors (r₁, d₁, r₂, d₂, ..).
pub(crate) type Weighting<const V: usize> = [f64; V];
/// Nodal vectors (r₁, d₁, r₂, d₂, ..) or their displacements.
pub(crate) type Vectors<const V: usize> = [Vector3<f64>; V];
/// Strains of an element.
pub(crate) type Strains<const S: usize> = SMatrix<f64, S, 1>;
/// Gradients of the strains by the coordinates, a row for each strain.
pub(super) type Gradients<const S: usize, const C: usize> = [[f64; C]; S];

/// Largest number of vectors of the surface of which the strains consist: four at each of four integration points, two for each
/// sampled shear strain, and the directors of the nodes.
const FIELDS: usize = 4 * NODES + 3 * NODES;
/// Vectors of the surface: tangents, directors and their derivatives at points. Those that an element does not have are zero.
pub(crate) type Fields = [Vector3<f64>; FIELDS];

/// Vector of the surface: Σ w_n x_n over the positions (`director` = 0) or the directors (1) of the nodes.
#[derive(Clone, Copy, Debug)]
struct Field {
    director: usize,
    weights: [f64; NODES],
}

/// Part f (p·q − P·Q) of a strain, with vectors p and q of the surface, P and Q in the reference state.
#[derive(Clone, Copy, Debug)]
struct StrainProduct {
    strain: usize,
    fields: [usize; 2],
    factor: f64,
}

/// Transverse shear strain of an element at a point: the sum of γ_ξ and γ_η with two weights.
pub(crate) struct SampledShear {
    at: [f64; 2],
    weights: [f64; 2],
}

/// Transverse shear strains of an element, along its edges in their middles.
///
/// Source: Dvorkin & Bathe (1984) for four nodes; Lee & Bathe (2004) for three nodes.
pub(crate) const fn sampled_shear(shape: Shape) -> &'static [SampledShear] {
    const XI: [f64; 2] = [1.0, 0.0];
    const ETA: [f64; 2] = [0.0, 1.0];
    match shape {
        Shape::Triangle => &[
            SampledShear { at: [0.5, 0.0], weights: XI },
            SampledShear { at: [0.0, 0.5], weights: ETA },
            SampledShear { at: [0.5, 0.5], weights: [-1.0, 1.0] },
        ],
        Shape::Quad => &[
            SampledShear { at: [0.5, 0.0], weights: XI },
            SampledShear { at: [0.5, 1.0], weights: XI },
            SampledShear { at: [0.0, 0.5], weights: ETA },
            SampledShear { at: [1.0, 0.5], weights: ETA },
        ],
    }
}

/// Returns the weights of the sampled shear strains in γ_ξ and γ_η at a point. The fourth weight of a triangle is zero.
///
/// On a triangle γ_ξ = γ₁ + c η and γ_η = γ₂ − c ξ with c = γ₂ − γ₁ − γ₃: the strain along each edge is constant.
pub(crate) fn shear_interpolation(shape: Shape, [x, y]: [f64; 2]) -> [[f64; NODES]; 2] {
    match shape {
        Shape::Triangle => [[1.0 - y, y, -y, 0.0], [x, 1.0 - x, x, 0.0]],
        Shape::Quad => [[1.0 - y, y, 0.0, 0.0], [0.0, 0.0, 1.0 - x, x]],
    }
}

/// Computes Σ w_a x_a over the positions (`director` = 0) or the directors (1) of the nodes.
pub(crate) fn interpolate(shape: &[f64; NODES], director: usize, x: &[Vector3<f64>]) -> Vector3<f64> {
    x.chunks_exact(2).zip(shape).fold(Vector3::zeros(), |sum, (own, w)| sum + own[director] * *w)
}

/// Strains of the elements of a shape: those of the surface at each integration point (ε_ξξ, ε_ηη, 2 ε_ξη, κ_ξξ, κ_ηη, 2 κ_ξη), the
/// transverse shear strains, and the thickness strains.
///
/// ε_αβ = ½ (a_α·a_β − A_α·A_β), κ_αβ = ½ (a_α·d_,β + a_β·d_,α) minus its reference value, γ_α = a_α·d − A_α·D, and
/// ε_33 = ½ (d·d − D·D). Strains are computed from the changes of the vectors, p·q − P·Q = (p − P)·Q + P·(q − Q) + (p − P)·(q − Q),
/// such that small ones keep their digits.
#[derive(Clone, Debug)]
pub(crate) struct ShearTables {
    pub(crate) shape: Shape,
    fields: Vec<Field>,
    products: Vec<StrainProduct>,
}

impl ShearTables {
    pub(crate) fn new(shape: Shape) -> Self {
        let mut tables = Self { shape, fields: Vec::new(), products: Vec::new() };
        for (k, (at, _)) in shape.surface_points().iter().enumerate() {
            tables.add_surface(SURFACE * k, &shape.values(*at));
        }
        let first = SURFACE * shape.surface_points().len();
        for (k, SampledShear { at, weights: [of_x, of_y] }) in sampled_shear(shape).iter().enumerate() {
            let [n, x, y] = shape.values(*at);
            let along = std::array::from_fn(|a| of_x * x[a] + of_y * y[a]);
            let fields = [tables.field(0, along), tables.field(1, n)];
            tables.add(first + k, fields, 1.0);
        }
        for node in 0..shape.nodes() {
            let own = std::array::from_fn(|n| if n == node { 1.0 } else { 0.0 });
            let director = tables.field(1, own);
            tables.add(first + shape.nodes() + node, [director; 2], 0.5);
        }
        tables
    }

    /// Adds a vector of the surface and returns its number.
    fn field(&mut self, director: usize, weights: [f64; NODES]) -> usize {
        self.fields.push(Field { director, weights });
        self.fields.len() - 1
    }

    fn add(&mut self, strain: usize, fields: [usize; 2], factor: f64) {
        self.products.push(StrainProduct { strain, fields, factor });
    }

    /// Adds ε and κ at a point.
    fn add_surface(&mut self, first: usize, [_, x, y]: &ShapeValues) {
        let [rx, ry] = [x, y].map(|shape| self.field(0, *shape));
        let [dx, dy] = [x, y].map(|shape| self.field(1, *shape));
        self.add(first, [rx, rx], 0.5);
        self.add(first + 1, [ry, ry], 0.5);
        self.add(first + 2, [rx, ry], 1.0);
        self.add(first + 3, [rx, dx], 1.0);
        self.add(first + 4, [ry, dy], 1.0);
        self.add(first + 5, [rx, dy], 1.0);
        self.add(first + 5, [ry, dx], 1.0);
    }

    /// Computes the vectors of the surface, or their changes, from nodal vectors.
    pub(super) fn fields(&self, x: &[Vector3<f64>]) -> Fields {
        let mut values = [Vector3::zeros(); FIELDS];
        for (value, Field { director, weights }) in values.iter_mut().zip(&self.fields) {
            *value = interpolate(weights, *director, x);
        }
        values
    }

    /// Computes the strains for changes of the vectors of the surface from those in the reference state.
    pub(super) fn strains<const S: usize>(&self, rest: &Fields, moved: &Fields) -> Strains<S> {
        let mut strains = Strains::zeros();
        for StrainProduct { strain, fields: [p, q], factor } in &self.products {
            let (p, q) = (*p, *q);
            let change = moved[p].dot(&(rest[q] + moved[q])) + rest[p].dot(&moved[q]);
            strains[*strain] += factor * change;
        }
        strains
    }

    /// Computes the rates of the strains from those of the vectors of the surface.
    pub(super) fn rates<const S: usize>(&self, fields: &Fields, rates: &Fields) -> Strains<S> {
        let mut strains = Strains::zeros();
        for StrainProduct { strain, fields: [p, q], factor } in &self.products {
            let (p, q) = (*p, *q);
            strains[*strain] += factor * (rates[p].dot(&fields[q]) + fields[p].dot(&rates[q]));
        }
        strains
    }

    /// Computes the forces of stresses on the nodal vectors.
    pub(super) fn forces<const V: usize, const S: usize>(
        &self,
        fields: &Fields,
        stress: &Strains<S>,
    ) -> Vectors<V> {
        let mut of_fields = [Vector3::zeros(); FIELDS];
        for StrainProduct { strain, fields: [p, q], factor } in &self.products {
            let (p, q, stress) = (*p, *q, factor * stress[*strain]);
            of_fields[p] += fields[q] * stress;
            of_fields[q] += fields[p] * stress;
        }
        let mut forces = [Vector3::zeros(); V];
        for (force, Field { director, weights }) in of_fields.iter().zip(&self.fields) {
            for (own, weight) in forces.chunks_exact_mut(2).zip(weights) {
                own[*director] += force * *weight;
            }
        }
        forces
    }

    /// Computes the gradients of the strains by the C = 3 V coordinates.
    pub(super) fn gradients<const S: usize, const C: usize>(&self, fields: &Fields) -> Gradients<S, C> {
        let mut gradients = [[0.0; C]; S];
        for StrainProduct { strain, fields: pair, factor } in &self.products {
            let row = &mut gradients[*strain];
            for (own, other) in [(pair[0], pair[1]), (pair[1], pair[0])] {
                let Field { director, weights } = &self.fields[own];
                let other = fields[other] * *factor;
                for (node, weight) in row.chunks_exact_mut(6).zip(weights) {
                    (0..3).for_each(|i| node[3 * director + i] += weight * other[i]);
                }
            }
        }
        gradients
    }

    /// Computes the scalar blocks Σ σ_k ∂²e_k/∂x_a∂x_b of the stiffness of stresses.
    pub(super) fn geometry<const V: usize, const S: usize>(&self, stress: &Strains<S>) -> [Weighting<V>; V] {
        let mut blocks = [[0.0; V]; V];
        for StrainProduct { strain, fields: [p, q], factor } in &self.products {
            let stress = factor * stress[*strain];
            let [p, q] = [p, q].map(|field| &self.fields[*field]);
            for (n, of_p) in p.weights.iter().enumerate().take(V / 2) {
                for (m, of_q) in q.weights.iter().enumerate().take(V / 2) {
                    let (a, b, block) = (2 * n + p.director, 2 * m + q.director, stress * of_p * of_q);
                    blocks[a][b] += block;
                    blocks[b][a] += block;
                }
            }
        }
        blocks
    }

    /// Bounds of the magnitudes of the vectors of the surface, for displacements of the given magnitudes.
    pub(super) fn sizes<const V: usize>(&self, rest: &Fields, q: &Weighting<V>) -> [f64; FIELDS] {
        let mut sizes = rest.map(|vector| vector.norm());
        for (size, Field { director, weights }) in sizes.iter_mut().zip(&self.fields) {
            *size += weights.iter().zip(q.chunks_exact(2)).map(|(w, q)| w.abs() * q[*director]).sum::<f64>();
        }
        sizes
    }

    /// Bounds of the gradients of each strain by each nodal vector, for vectors of the surface of the given magnitudes.
    pub(super) fn gradient_sizes<const V: usize, const S: usize>(
        &self,
        sizes: &[f64; FIELDS],
    ) -> [Weighting<V>; S] {
        let mut bounds = [[0.0; V]; S];
        for StrainProduct { strain, fields: pair, factor } in &self.products {
            for (own, other) in [(pair[0], pair[1]), (pair[1], pair[0])] {
                let Field { director, weights } = &self.fields[own];
                for (node, weight) in bounds[*strain].chunks_exact_mut(2).zip(weights) {
                    node[*director] += factor * weight.abs() * sizes[other];
                }
            }
        }
        bounds
    }
}
