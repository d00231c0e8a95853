//! Points of a thin element and its shape functions there.

use nalgebra::{Matrix3, SMatrix, Vector3};

use super::hermite::{Shape, VECTORS, bicubic, hermite, surface_derivatives};
use crate::kinematics::gauss4;
use crate::lanes::Row;

/// Number of points of an element at which curvatures are evaluated.
pub(crate) const POINTS: usize = 16;
/// Number of membrane strains of an element: ε_ξξ at 3 × 4, ε_ηη at 4 × 3 and 2 ε_ξη at 3 × 3 Lobatto points.
pub(crate) const MEMBRANE: usize = 33;
/// Number of membrane strains of one direction.
pub(crate) const DIRECT: usize = 12;
/// Number of tangents at the sampling points: one for a strain of one direction, two for a shear strain.
pub(crate) const TANGENTS: usize = 2 * DIRECT + 2 * SHEARS;
/// Number of shear strains.
pub(crate) const SHEARS: usize = 9;
/// Number of lists of tangents at the sampling points: two of the direct strains, r_ξ and r_η of the shear strains.
pub(crate) const TANGENT_LISTS: usize = 4;
/// Number of lists of displacement gradients: five derivatives at the integration points, and the tangents at the sampling points.
pub(crate) const GRADIENTS: usize = 5 + TANGENT_LISTS;

/// Returns the list of a tangent and its place there.
#[inline(always)]
pub(crate) const fn tangent_place(r: usize) -> [usize; 2] {
    match r {
        MEMBRANE.. => [3, r - MEMBRANE],
        r if r >= 2 * DIRECT => [2, r - 2 * DIRECT],
        r => [r / VECTORS, r % VECTORS],
    }
}

/// Shape functions at the points of the unit square, common to all elements.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ShellTables {
    /// Derivatives of the shape functions at the integration points of bending.
    pub(crate) points: [[Row; 5]; POINTS],
    /// Values of the cubic Hermite functions and their derivatives at the four points of a direction.
    pub(crate) hermite: [[[f64; 4]; 4]; 3],
    /// Displacement gradients of unit vectors: list g of vector a has \[g\]\[a\].
    pub(crate) gradients: Box<[[Row; VECTORS]; GRADIENTS]>,
    /// Shape functions of the tangents at the sampling points: r_ξ, r_η of the direct strains, then r_ξ and r_η of the shear strains.
    pub(crate) tangents: [Row; TANGENTS],
    /// Membrane strains.
    pub(crate) samples: [MembraneSample; MEMBRANE],
    /// Values of the interpolation functions of the membrane strains at the integration points.
    pub(crate) sampling: [[f64; MEMBRANE]; POINTS],
    /// The same values: a row over the points for each strain, and rows over the strains of each component for each point.
    pub(crate) of_strains: [Row; MEMBRANE],
    pub(crate) of_points: [[Row; 3]; POINTS],
}

/// First membrane strain of each component, and the number of all.
pub(crate) const FIRST: [usize; 4] = [0, DIRECT, 2 * DIRECT, MEMBRANE];

/// Membrane strain at a sampling point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MembraneSample {
    /// Component: 0 for ε_ξξ, 1 for ε_ηη, 2 for 2 ε_ξη.
    pub(crate) component: usize,
    /// Derivatives of the shape functions by ξ and η.
    pub(crate) shapes: [Shape; 2],
}

/// Integration points of an element with their weights.
pub(crate) fn integration_points() -> [([f64; 2], f64); POINTS] {
    let rule = gauss4();
    std::array::from_fn(|k| {
        let ((x, u), (y, v)) = (rule[k % 4], rule[k / 4]);
        ([x, y], u * v)
    })
}

/// Three-point and four-point Lobatto rules on [0, 1].
fn lobatto() -> [Vec<f64>; 2] {
    let inner = 0.5 * 0.2_f64.sqrt();
    [vec![0.0, 0.5, 1.0], vec![0.0, 0.5 - inner, 0.5 + inner, 1.0]]
}

/// Components and rules along ξ and η of the membrane strains. Each is reduced along its own directions.
const RULES: [[usize; 2]; 3] = [[0, 1], [1, 0], [0, 0]];

/// Value of the k-th Lagrange polynomial of some nodes.
pub(crate) fn lagrange(nodes: &[f64], k: usize, x: f64) -> f64 {
    let others = nodes.iter().enumerate().filter(|(i, _)| *i != k);
    others.map(|(_, node)| (x - node) / (nodes[k] - node)).product()
}

/// Calls `visit` with the component, the rules and the place in them of each membrane strain.
pub(crate) fn each_sample(mut visit: impl FnMut(usize, [&[f64]; 2], [usize; 2])) {
    let rules = lobatto();
    for (component, rule) in RULES.into_iter().enumerate() {
        let [along, across] = rule.map(|k| &rules[k][..]);
        for (j, i) in (0..across.len()).flat_map(|j| (0..along.len()).map(move |i| (j, i))) {
            visit(component, [along, across], [i, j]);
        }
    }
}

impl ShellTables {
    pub(crate) fn new() -> Self {
        let points = integration_points();
        let none = MembraneSample { component: 0, shapes: [[0.0; VECTORS]; 2] };
        let (mut samples, mut sampling, mut row) = ([none; MEMBRANE], [[0.0; MEMBRANE]; POINTS], 0);
        each_sample(|component, [along, across], [i, j]| {
            let at = [along[i], across[j]];
            samples[row] = MembraneSample { component, shapes: [bicubic(at, [1, 0]), bicubic(at, [0, 1])] };
            for (values, ([x, y], _)) in sampling.iter_mut().zip(points) {
                values[row] = lagrange(along, i, x) * lagrange(across, j, y);
            }
            row += 1;
        });
        let mut tangents = [Row::ZERO; TANGENTS];
        for (r, row) in tangents.iter_mut().enumerate() {
            let MembraneSample { component, shapes, .. } = &samples[Self::strain_of(r)];
            let of = if r < MEMBRANE && *component != 1 { 0 } else { 1 };
            *row = Row(shapes[of]);
        }
        let points = points.map(|(at, _)| surface_derivatives(at).map(Row));
        let mut gradients = Box::new([[Row::ZERO; VECTORS]; GRADIENTS]);
        for a in 0..VECTORS {
            for (k, g) in (0..POINTS).flat_map(|k| (0..5).map(move |g| (k, g))) {
                gradients[g][a].0[k] = points[k][g].0[a];
            }
            for (r, row) in tangents.iter().enumerate() {
                let [list, k] = tangent_place(r);
                gradients[5 + list][a].0[k] = row.0[a];
            }
        }
        let hermite = [0, 1, 2].map(|order| gauss4().map(|(x, _)| hermite(x, order)));
        let of_strains = std::array::from_fn(|t| Row(std::array::from_fn(|k| sampling[k][t])));
        let mut of_points = [[Row::ZERO; 3]; POINTS];
        for (t, k) in (0..MEMBRANE).flat_map(|t| (0..POINTS).map(move |k| (t, k))) {
            let component = samples[t].component;
            of_points[k][component].0[t - FIRST[component]] = sampling[k][t];
        }
        Self { points, hermite, gradients, tangents, samples, sampling, of_strains, of_points }
    }

    /// Returns the membrane strain of a tangent.
    pub(crate) const fn strain_of(tangent: usize) -> usize {
        if tangent < MEMBRANE { tangent } else { tangent - SHEARS }
    }

    /// Returns the covariant membrane strain at an integration point.
    pub(crate) fn membrane_strain(&self, k: usize, membrane: &[f64; MEMBRANE]) -> Vector3<f64> {
        let mut strain = Vector3::zeros();
        for ((weight, value), sample) in self.sampling[k].iter().zip(membrane).zip(&self.samples) {
            strain[sample.component] += weight * value;
        }
        strain
    }

    /// Adds a membrane force at an integration point to the forces of the membrane strains.
    pub(crate) fn add_membrane_force(&self, k: usize, force: &Vector3<f64>, sum: &mut [f64; MEMBRANE]) {
        for ((weight, sum), sample) in self.sampling[k].iter().zip(sum).zip(&self.samples) {
            *sum += weight * force[sample.component];
        }
    }

    /// Adds the stiffness of the covariant membrane strain at an integration point.
    pub(crate) fn add_membrane_stiffness(
        &self,
        k: usize,
        stiffness: &Matrix3<f64>,
        sum: &mut SMatrix<f64, MEMBRANE, MEMBRANE>,
    ) {
        let sampling = &self.sampling[k];
        for (t, s) in (0..MEMBRANE).flat_map(|t| (0..MEMBRANE).map(move |s| (t, s))) {
            let entry = stiffness[(self.samples[t].component, self.samples[s].component)];
            sum[(t, s)] += sampling[t] * sampling[s] * entry;
        }
    }
}

/// Computes Σ_a N_a x_a.
pub(crate) fn sum(shape: &Shape, x: &[Vector3<f64>; VECTORS]) -> Vector3<f64> {
    shape.iter().zip(x).fold(Vector3::zeros(), |sum, (shape, x)| sum + x * *shape)
}
