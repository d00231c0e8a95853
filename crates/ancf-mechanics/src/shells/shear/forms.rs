//! Strains of a shell element as quadratic forms of its nodal vectors.

use nalgebra::{SMatrix, Vector3};

use super::face::{NODES, Shape, ShapeValues};

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

/// Symmetric matrix Q of a strain e = ½ Σ Q_ab (x_a·x_b − X_a·X_b) of the nodal vectors x, X in the reference state.
pub(crate) type Form<const V: usize> = [Weighting<V>; V];

/// Weights of the positions (`director` = 0) or of the directors (1).
fn weighting<const V: usize>(shape: &[f64; NODES], director: usize) -> Weighting<V> {
    std::array::from_fn(|a| if a % 2 == director { shape[a / 2] } else { 0.0 })
}

/// Adds the form of the product p·q of two sums of nodal vectors.
fn add_product<const V: usize>(form: &mut Form<V>, p: &Weighting<V>, q: &Weighting<V>) {
    for a in 0..V {
        for b in 0..V {
            form[a][b] += p[a] * q[b] + q[a] * p[b];
        }
    }
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

/// Forms of all strains: those of the surface at each integration point (ε_ξξ, ε_ηη, 2 ε_ξη, κ_ξξ, κ_ηη, 2 κ_ξη), the transverse
/// shear strains, and the thickness strains.
///
/// ε_αβ = ½ (a_α·a_β − A_α·A_β), κ_αβ = ½ (a_α·d_,β + a_β·d_,α) minus its reference value, γ_α = a_α·d − A_α·D, and
/// ε_33 = ½ (d·d − D·D).
pub(crate) fn forms<const V: usize, const S: usize>(shape: Shape) -> Box<[Form<V>; S]> {
    let mut forms = Box::new([[[0.0; V]; V]; S]);
    for (k, (at, _)) in shape.surface_points().iter().enumerate() {
        let own = surface_forms(&shape.values(*at));
        own.into_iter().enumerate().for_each(|(i, form)| forms[SURFACE * k + i] = form);
    }
    let first = SURFACE * shape.surface_points().len();
    for (k, SampledShear { at, weights: [of_x, of_y] }) in sampled_shear(shape).iter().enumerate() {
        let [n, x, y] = shape.values(*at);
        let along = std::array::from_fn(|a| of_x * x[a] + of_y * y[a]);
        add_product(&mut forms[first + k], &weighting(&along, 0), &weighting(&n, 1));
    }
    for a in 0..shape.nodes() {
        forms[first + shape.nodes() + a][2 * a + 1][2 * a + 1] = 1.0;
    }
    forms
}

/// Forms of ε and κ at a point.
fn surface_forms<const V: usize>([_, x, y]: &ShapeValues) -> [Form<V>; SURFACE] {
    let [rx, ry] = [x, y].map(|shape| weighting::<V>(shape, 0));
    let [dx, dy] = [x, y].map(|shape| weighting::<V>(shape, 1));
    let mut forms = [[[0.0; V]; V]; SURFACE];
    add_product(&mut forms[0], &rx.map(|w| 0.5 * w), &rx);
    add_product(&mut forms[1], &ry.map(|w| 0.5 * w), &ry);
    add_product(&mut forms[2], &rx, &ry);
    add_product(&mut forms[3], &rx, &dx);
    add_product(&mut forms[4], &ry, &dy);
    add_product(&mut forms[5], &rx, &dy);
    add_product(&mut forms[5], &ry, &dx);
    forms
}

/// Computes Σ_b Q_ab x_b for all a.
pub(crate) fn gradient<const V: usize>(form: &Form<V>, x: &Vectors<V>) -> Vectors<V> {
    std::array::from_fn(|a| {
        form[a].iter().zip(x).filter(|(w, _)| **w != 0.0).fold(Vector3::zeros(), |sum, (w, x)| sum + x * *w)
    })
}

/// Computes Σ w_a x_a over the positions (`director` = 0) or the directors (1) of the nodes.
pub(crate) fn interpolate(shape: &[f64; NODES], director: usize, x: &[Vector3<f64>]) -> Vector3<f64> {
    x.chunks_exact(2).zip(shape).fold(Vector3::zeros(), |sum, (own, w)| sum + own[director] * *w)
}
