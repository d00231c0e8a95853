use nalgebra::{Matrix3, Vector3};

use super::hermite::{Shape, VECTORS, bicubic, surface_derivatives};
use super::section::ShellSection;
use crate::kinematics::gauss4;

/// Number of points of an element at which curvatures are evaluated.
pub(crate) const POINTS: usize = 16;
/// Number of membrane strains of an element: ε_ξξ at 3 × 4, ε_ηη at 4 × 3 and 2 ε_ξη at 3 × 3 Lobatto points.
pub(crate) const MEMBRANE: usize = 33;

/// Material, inertia and loads of a shell that are common to its elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShellMedium {
    /// Stiffness and mass per area.
    pub section: ShellSection,
    /// Retardation time τ of the damping that is proportional to the stiffness.
    pub retardation: f64,
    /// Rate α of the damping α M v that is proportional to the mass.
    pub mass_damping: f64,
    /// Acceleration of gravity.
    pub gravity: Vector3<f64>,
}

/// Integration point of bending.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BendingPoint {
    /// Reference values of r_ξ, r_η, r_ξξ, r_ηη, r_ξη.
    pub(crate) reference: [Vector3<f64>; 5],
    /// Unit normal and its magnitude before normalisation.
    pub(crate) normal: Vector3<f64>,
    pub(crate) area: f64,
    /// D and B for covariant components, times the weight.
    pub(crate) bending: Matrix3<f64>,
    pub(crate) coupling: Matrix3<f64>,
}

/// Constant data of a shell element.
#[derive(Clone, Debug, PartialEq)]
pub struct ShellProfile {
    pub(crate) points: Vec<BendingPoint>,
    /// Reference values of r_ξ and r_η at the sampling points.
    pub(crate) samples: Vec<[Vector3<f64>; 2]>,
    /// Membrane stiffness of the strains at the sampling points.
    pub(crate) membrane: Box<[[f64; MEMBRANE]; MEMBRANE]>,
    /// True if the section couples membrane strains and curvatures.
    pub(crate) is_coupled: bool,
    /// Compact mass matrix M_ab = ∫ ρ h N_a N_b dA, and first moments ∫ ρ h N_a dA.
    pub(crate) mass: [[f64; VECTORS]; VECTORS],
    pub(crate) first: Shape,
    pub(crate) medium: ShellMedium,
}

/// Shape functions at the points of the unit square, common to all elements.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ShellTables {
    /// Derivatives of the shape functions at the integration points of bending.
    pub(crate) points: [[Shape; 5]; POINTS],
    /// Membrane strains.
    pub(crate) samples: [MembraneSample; MEMBRANE],
    /// Values of the interpolation functions of the membrane strains at the integration points.
    pub(crate) sampling: [[f64; MEMBRANE]; POINTS],
}

/// Membrane strain at a sampling point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct MembraneSample {
    /// Component: 0 for ε_ξξ, 1 for ε_ηη, 2 for 2 ε_ξη.
    pub(crate) component: usize,
    /// Derivatives of the shape functions by ξ and η.
    pub(crate) shapes: [Shape; 2],
    /// Vectors on which the strain depends, in ascending order, and their number.
    active: ([usize; VECTORS], usize),
}

impl MembraneSample {
    fn new(component: usize, shapes: [Shape; 2]) -> Self {
        let used = |a: usize| match component {
            0 => shapes[0][a] != 0.0,
            1 => shapes[1][a] != 0.0,
            _ => shapes[0][a] != 0.0 || shapes[1][a] != 0.0,
        };
        let mut active = ([0; VECTORS], 0);
        for a in (0..VECTORS).filter(|&a| used(a)) {
            active.0[active.1] = a;
            active.1 += 1;
        }
        Self { component, shapes, active }
    }

    /// Returns the vectors on which the strain depends, in ascending order.
    pub(crate) fn vectors(&self) -> &[usize] {
        &self.active.0[..self.active.1]
    }
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
        let none = MembraneSample::new(0, [[0.0; VECTORS]; 2]);
        let (mut samples, mut sampling, mut row) = ([none; MEMBRANE], [[0.0; MEMBRANE]; POINTS], 0);
        each_sample(|component, [along, across], [i, j]| {
            let at = [along[i], across[j]];
            samples[row] = MembraneSample::new(component, [bicubic(at, [1, 0]), bicubic(at, [0, 1])]);
            for (values, ([x, y], _)) in sampling.iter_mut().zip(points) {
                values[row] = lagrange(along, i, x) * lagrange(across, j, y);
            }
            row += 1;
        });
        Self { points: points.map(|(at, _)| surface_derivatives(at)), samples, sampling }
    }
}

/// Computes Σ_a N_a x_a.
pub(crate) fn sum(shape: &Shape, x: &[Vector3<f64>; VECTORS]) -> Vector3<f64> {
    shape.iter().zip(x).fold(Vector3::zeros(), |sum, (shape, x)| sum + x * *shape)
}

impl ShellProfile {
    /// Creates the data of an element with the given nodal vectors in the reference state.
    ///
    /// Positions may be relative to any point.
    pub(crate) fn new(
        tables: &ShellTables,
        reference: &[Vector3<f64>; VECTORS],
        medium: &ShellMedium,
    ) -> Self {
        let rule = integration_points();
        let mut membrane = Box::new([[0.0; MEMBRANE]; MEMBRANE]);
        let (mut mass, mut first) = ([[0.0; VECTORS]; VECTORS], [0.0; VECTORS]);
        let mut points = Vec::with_capacity(POINTS);
        for (k, (at, weight)) in rule.into_iter().enumerate() {
            let values = tables.points[k].map(|shape| sum(&shape, reference));
            let normal = values[0].cross(&values[1]);
            let area = normal.norm();
            let [a, b, d] = medium.section.covariant(&values[0], &values[1]).map(|c| c * (weight * area));
            for (t, s) in (0..MEMBRANE).flat_map(|t| (0..MEMBRANE).map(move |s| (t, s))) {
                let stiffness = a[(tables.samples[t].component, tables.samples[s].component)];
                membrane[t][s] += tables.sampling[k][t] * tables.sampling[k][s] * stiffness;
            }
            let shape = bicubic(at, [0, 0]);
            for i in 0..VECTORS {
                first[i] += weight * area * medium.section.density * shape[i];
                for j in 0..VECTORS {
                    mass[i][j] += weight * area * medium.section.density * shape[i] * shape[j];
                }
            }
            points.push(BendingPoint {
                reference: values,
                normal: normal / area,
                area,
                bending: d,
                coupling: b,
            });
        }
        let samples =
            tables.samples.iter().map(|sample| sample.shapes.map(|shape| sum(&shape, reference))).collect();
        let is_coupled = medium.section.coupling != Matrix3::zeros();
        Self { points, samples, membrane, is_coupled, mass, first, medium: *medium }
    }

    /// Returns ∫ N_a dA.
    pub(crate) fn areas(&self) -> Shape {
        let mut areas = [0.0; VECTORS];
        for ((at, weight), point) in integration_points().into_iter().zip(&self.points) {
            let shape = bicubic(at, [0, 0]);
            areas.iter_mut().zip(shape).for_each(|(sum, shape)| *sum += weight * point.area * shape);
        }
        areas
    }

    /// Returns the compact mass matrix M_ab = ∫ ρ h N_a N_b dA.
    pub fn mass(&self) -> &[[f64; VECTORS]; VECTORS] {
        &self.mass
    }

    /// Returns the smallest area r_ξ × r_η at the integration points, relative to the product of the lengths of r_ξ and r_η.
    pub(crate) fn least_angle(&self) -> f64 {
        let of = |point: &BendingPoint| {
            let [t, s, ..] = &point.reference;
            point.area / (t.norm() * s.norm())
        };
        self.points.iter().map(of).fold(f64::INFINITY, |least, x| if x < least { x } else { least })
    }
}
