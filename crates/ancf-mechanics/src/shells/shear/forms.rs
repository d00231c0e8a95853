//! Strains of a four-node shell element as quadratic forms of its nodal vectors.

use nalgebra::{SMatrix, Vector3};

/// Number of nodes of an element.
pub const NODES: usize = 4;
/// Number of nodal vectors of an element: r and d of each node.
pub const QUAD_VECTORS: usize = 2 * NODES;
/// Number of coordinates of an element.
pub(crate) const COORDINATES: usize = 3 * QUAD_VECTORS;
/// Number of integration points.
pub(crate) const QUAD_POINTS: usize = 4;
/// Number of strains of the surface: ε and κ, three components each, at the integration points.
pub(crate) const SURFACE: usize = 6 * QUAD_POINTS;
/// Number of transverse shear strains: γ_ξ in the middle of two edges, γ_η in the middle of the other two.
pub(crate) const SHEARED: usize = 4;
/// Number of strains of an element, with the thickness strain at each node.
pub(crate) const STRAINS: usize = SURFACE + SHEARED + NODES;

/// Weights of the nodal vectors (r₁, d₁, r₂, d₂, ..).
pub(crate) type Weighting = [f64; QUAD_VECTORS];
/// Nodal vectors (r₁, d₁, r₂, d₂, ..) or their displacements.
pub(crate) type Vectors = [Vector3<f64>; QUAD_VECTORS];
/// Strains of an element.
pub(crate) type Strains = SMatrix<f64, STRAINS, 1>;

/// Places of the nodes in the unit square.
pub(crate) const CORNERS: [[f64; 2]; NODES] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];

/// Values of the bilinear shape functions, and their derivatives by ξ and η, at a point 0 ≤ ξ, η ≤ 1.
pub(crate) fn bilinear([x, y]: [f64; 2]) -> [[f64; NODES]; 3] {
    [
        [(1.0 - x) * (1.0 - y), x * (1.0 - y), x * y, (1.0 - x) * y],
        [-(1.0 - y), 1.0 - y, y, -y],
        [-(1.0 - x), -x, x, 1.0 - x],
    ]
}

/// Integration points with their weights on the unit square.
pub(crate) fn points() -> [([f64; 2], f64); QUAD_POINTS] {
    let near = 0.5 - 0.5 / 3.0_f64.sqrt();
    let at = [near, 1.0 - near];
    std::array::from_fn(|k| ([at[k % 2], at[k / 2]], 0.25))
}

/// Points at which the transverse shear strains are evaluated: γ_ξ for η = 0 and 1, γ_η for ξ = 0 and 1.
///
/// Source: Dvorkin & Bathe (1984).
pub(crate) const SHEAR_POINTS: [[f64; 2]; SHEARED] = [[0.5, 0.0], [0.5, 1.0], [0.0, 0.5], [1.0, 0.5]];

/// Symmetric matrix Q of a strain e = ½ Σ Q_ab (x_a·x_b − X_a·X_b) of the nodal vectors x, X in the reference state.
pub(crate) type Form = [Weighting; QUAD_VECTORS];

/// Weights of the positions (`director` = 0) or of the directors (1).
fn weighting(shape: &[f64; NODES], director: usize) -> Weighting {
    std::array::from_fn(|a| if a % 2 == director { shape[a / 2] } else { 0.0 })
}

/// Adds the form of the product p·q of two sums of nodal vectors.
fn add_product(form: &mut Form, p: &Weighting, q: &Weighting) {
    for a in 0..QUAD_VECTORS {
        for b in 0..QUAD_VECTORS {
            form[a][b] += p[a] * q[b] + q[a] * p[b];
        }
    }
}

/// Forms of all strains: those of the surface at each integration point (ε_ξξ, ε_ηη, 2 ε_ξη, κ_ξξ, κ_ηη, 2 κ_ξη), the transverse
/// shear strains, and the thickness strains.
///
/// ε_αβ = ½ (a_α·a_β − A_α·A_β), κ_αβ = ½ (a_α·d_,β + a_β·d_,α) minus its reference value, γ_α = a_α·d − A_α·D, and
/// ε_33 = ½ (d·d − D·D).
pub(crate) fn forms() -> Box<[Form; STRAINS]> {
    let mut forms = Box::new([[[0.0; QUAD_VECTORS]; QUAD_VECTORS]; STRAINS]);
    for (k, (at, _)) in points().into_iter().enumerate() {
        surface_forms(at).into_iter().enumerate().for_each(|(i, form)| forms[6 * k + i] = form);
    }
    for (k, at) in SHEAR_POINTS.into_iter().enumerate() {
        let shapes = bilinear(at);
        add_product(&mut forms[SURFACE + k], &weighting(&shapes[1 + k / 2], 0), &weighting(&shapes[0], 1));
    }
    for a in 0..NODES {
        forms[SURFACE + SHEARED + a][2 * a + 1][2 * a + 1] = 1.0;
    }
    forms
}

/// Forms of ε and κ at a point.
pub(crate) fn surface_forms(at: [f64; 2]) -> [Form; 6] {
    let [_, x, y] = bilinear(at);
    let [rx, ry] = [&x, &y].map(|shape| weighting(shape, 0));
    let [dx, dy] = [&x, &y].map(|shape| weighting(shape, 1));
    let mut forms = [[[0.0; QUAD_VECTORS]; QUAD_VECTORS]; 6];
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
pub(crate) fn gradient(form: &Form, x: &Vectors) -> Vectors {
    std::array::from_fn(|a| {
        form[a].iter().zip(x).filter(|(w, _)| **w != 0.0).fold(Vector3::zeros(), |sum, (w, x)| sum + x * *w)
    })
}

/// Computes Σ w_a x_a over the positions (`director` = 0) or the directors (1) of the nodes.
pub(crate) fn interpolate(shape: &[f64; NODES], director: usize, x: &Vectors) -> Vector3<f64> {
    (0..NODES).fold(Vector3::zeros(), |sum, a| sum + x[2 * a + director] * shape[a])
}
