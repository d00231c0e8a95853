use nalgebra::{Cholesky, Matrix3, SMatrix, Vector3};
use pulp::Simd;

use super::hermite::{Shape, VECTORS, bicubic, hermite, surface_derivatives};
use super::laminates::{LocalSection, ShellSection};
use super::prestrain::SurfaceLaw;
use super::rows::Row;
use crate::kinematics::gauss4;

/// Number of points of an element at which curvatures are evaluated.
pub(crate) const POINTS: usize = 16;
/// Number of membrane strains of an element: ε_ξξ at 3 × 4, ε_ηη at 4 × 3 and 2 ε_ξη at 3 × 3 Lobatto points.
pub(crate) const MEMBRANE: usize = 33;
/// Number of membrane strains of one direction.
const DIRECT: usize = 12;
/// Number of tangents at the sampling points: one for a strain of one direction, two for a shear strain.
pub(crate) const TANGENTS: usize = 2 * DIRECT + 2 * SHEARS;
/// Number of shear strains.
pub(crate) const SHEARS: usize = 9;
/// Number of lists of displacement gradients: five derivatives at the integration points, and the tangents of the sampling points.
pub(crate) const GRADIENTS: usize = 5 + TANGENTS.div_ceil(VECTORS);

/// Material, inertia and loads of a shell that are common to its elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShellMedium {
    /// Stiffness and mass per area.
    pub section: ShellSection,
    /// Axis whose projection on the surface is the first direction of the section. `None` for the direction of r_ξ.
    pub axis: Option<Vector3<f64>>,
    /// Retardation time τ of the damping that is proportional to the stiffness.
    pub retardation: f64,
    /// Rate α of the damping α M v that is proportional to the mass.
    pub mass_damping: f64,
    /// Acceleration of gravity.
    pub gravity: Vector3<f64>,
}

impl ShellMedium {
    /// Returns the law at a point with a section of its own and reference tangents.
    pub(crate) fn law(&self, local: Option<&LocalSection>, tangents: [&Vector3<f64>; 2]) -> SurfaceLaw {
        let local = local.unwrap_or(&LocalSection::WHOLE);
        let (section, axis) = (self.section.scaled(local.scale), local.axis_at(self.axis, tangents));
        SurfaceLaw { section, axis, stress_axis: None }
    }
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
    pub(crate) membrane: MembraneStiffness,
    /// True if the section couples membrane strains and curvatures.
    pub(crate) is_coupled: bool,
    /// Compact mass matrix M_ab = ∫ ρ h N_a N_b dA, and first moments ∫ ρ h N_a dA.
    pub(crate) mass: [Row; VECTORS],
    pub(crate) first: Shape,
    pub(crate) medium: ShellMedium,
    /// Sections at the places of [`section_places`](ShellProfile::section_places); none for equal sections.
    sections: Vec<LocalSection>,
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
}

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
        for (g, a) in (0..GRADIENTS).flat_map(|g| (0..VECTORS).map(move |a| (g, a))) {
            let of = |k: usize| match g {
                0..5 => points[k][g].0[a],
                _ => tangents.get((g - 5) * VECTORS + k).map_or(0.0, |row| row.0[a]),
            };
            gradients[g][a] = Row(std::array::from_fn(of));
        }
        let hermite = [0, 1, 2].map(|order| gauss4().map(|(x, _)| hermite(x, order)));
        Self { points, hermite, gradients, tangents, samples, sampling }
    }

    /// Returns the membrane strain of a tangent.
    pub(crate) const fn strain_of(tangent: usize) -> usize {
        if tangent < MEMBRANE { tangent } else { tangent - SHEARS }
    }
}

impl ShellTables {
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

impl ShellProfile {
    /// Creates the data of an element with the given nodal vectors in the reference state.
    ///
    /// Positions may be relative to any point. `sections` are those at the [`section_places`](Self::section_places), or none.
    pub(crate) fn new(
        tables: &ShellTables,
        reference: &[Vector3<f64>; VECTORS],
        medium: &ShellMedium,
        sections: Vec<LocalSection>,
    ) -> Self {
        let rule = integration_points();
        let mut membrane = SMatrix::<f64, MEMBRANE, MEMBRANE>::zeros();
        let (mut mass, mut first) = ([Row::ZERO; VECTORS], [0.0; VECTORS]);
        let mut points = Vec::with_capacity(POINTS);
        for (k, (at, weight)) in rule.into_iter().enumerate() {
            let values = tables.points[k].map(|shape| sum(&shape.0, reference));
            let normal = values[0].cross(&values[1]);
            let area = normal.norm();
            let tangents = [&values[0], &values[1]];
            let law = medium.law(sections.get(k), tangents);
            let [a, b, d] = law.section.covariant(tangents, law.axis).map(|c| c * (weight * area));
            tables.add_membrane_stiffness(k, &a, &mut membrane);
            let shape = bicubic(at, [0, 0]);
            for i in 0..VECTORS {
                first[i] += weight * area * law.section.density * shape[i];
                for j in 0..VECTORS {
                    mass[i].0[j] += weight * area * law.section.density * shape[i] * shape[j];
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
        let membrane = MembraneStiffness::new(&membrane);
        Self { points, samples, membrane, is_coupled, mass, first, medium: *medium, sections }
    }

    /// Returns the places of an element at which sections are evaluated: the integration points with their weights, then the sampling
    /// points of the membrane strains, among them the corners, with the weight 0.
    pub fn section_places() -> Vec<([f64; 2], f64)> {
        let mut places = integration_points().to_vec();
        each_sample(|_, [along, across], [i, j]| places.push(([along[i], across[j]], 0.0)));
        places
    }

    /// Returns the law at one of the [`section_places`](Self::section_places) with reference tangents.
    pub(crate) fn law(&self, place: usize, tangents: [&Vector3<f64>; 2]) -> SurfaceLaw {
        self.medium.law(self.sections.get(place), tangents)
    }

    /// Returns the thickness at an integration point, relative to that of the whole shell.
    pub(crate) fn scale(&self, point: usize) -> f64 {
        self.sections.get(point).map_or(1.0, |section| section.scale)
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

    /// Returns an entry ∫ ρ h N_a N_b dA of the compact mass matrix.
    pub fn mass(&self, a: usize, b: usize) -> f64 {
        self.mass[a].0[b]
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

/// Membrane stiffness D of an element over its membrane strains, as the factor R of D = Rᵀ R.
///
/// With the factor, Bᵀ D B is the square of R B, which takes half of the operations.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MembraneStiffness {
    /// Rows of the upper triangle.
    factor: [f64; start(MEMBRANE)],
}

/// Index of the first entry of a row of the upper triangle.
const fn start(row: usize) -> usize {
    row * MEMBRANE - row * (row + 1) / 2 + row
}

impl MembraneStiffness {
    /// Factorises a stiffness matrix. The entries are NaN if the matrix is not positive definite.
    pub(crate) fn new(stiffness: &SMatrix<f64, MEMBRANE, MEMBRANE>) -> Self {
        let factor = Cholesky::new(*stiffness).map(|factor| factor.unpack());
        let entry = |t: usize, s: usize| factor.as_ref().map_or(f64::NAN, |factor| factor[(s, t)]);
        let mut rows = [0.0; start(MEMBRANE)];
        for t in 0..MEMBRANE {
            (t..MEMBRANE).for_each(|s| rows[start(t) + s - t] = entry(t, s));
        }
        Self { factor: rows }
    }

    /// Returns the diagonal and the following entries of a row of R.
    #[inline(always)]
    fn row(&self, t: usize) -> &[f64] {
        &self.factor[start(t)..start(t) + MEMBRANE - t]
    }

    /// Computes D ε.
    pub(crate) fn stress(&self, strains: &[f64; MEMBRANE]) -> [f64; MEMBRANE] {
        let mut stress = [0.0; MEMBRANE];
        for t in 0..MEMBRANE {
            let row = self.row(t);
            let part: f64 = row.iter().zip(&strains[t..]).map(|(r, strain)| r * strain).sum();
            stress[t..].iter_mut().zip(row).for_each(|(stress, r)| *stress += r * part);
        }
        stress
    }

    /// Computes |R|ᵀ |R| x, a bound of the rounding error of D ε for errors of size x.
    pub(crate) fn bound(&self, x: &[f64; MEMBRANE]) -> [f64; MEMBRANE] {
        let mut bound = [0.0; MEMBRANE];
        for t in 0..MEMBRANE {
            let row = self.row(t);
            let part: f64 = row.iter().zip(&x[t..]).map(|(r, x)| r.abs() * x).sum();
            bound[t..].iter_mut().zip(row).for_each(|(bound, r)| *bound += r.abs() * part);
        }
        bound
    }

    /// Replaces the rows B by R B.
    #[inline(always)]
    pub(crate) fn multiply<S: Simd>(&self, simd: S, rows: &mut [[Row; 3]; MEMBRANE]) {
        if VECTORS / S::F64_LANES < 4 {
            self.multiply_wide::<S, 2>(simd, rows);
        } else {
            self.multiply_wide::<S, 4>(simd, rows);
        }
    }

    #[inline(always)]
    fn multiply_wide<S: Simd, const WIDTH: usize>(&self, simd: S, rows: &mut [[Row; 3]; MEMBRANE]) {
        for t in 0..MEMBRANE {
            // Rows before t are complete, and rows from t on are still those of B.
            let factors = self.row(t);
            for first in (0..VECTORS / S::F64_LANES).step_by(WIDTH) {
                let mut sums = [[simd.splat_f64s(0.0); WIDTH]; 3];
                for (factor, row) in factors.iter().zip(&rows[t..]) {
                    if *factor == 0.0 {
                        continue;
                    }
                    let factor = simd.splat_f64s(*factor);
                    for i in 0..3 {
                        for k in 0..WIDTH {
                            sums[i][k] = simd.mul_add_e_f64s(factor, row[i].load::<S>(first + k), sums[i][k]);
                        }
                    }
                }
                for (row, sums) in rows[t].iter_mut().zip(sums) {
                    for k in 0..WIDTH {
                        row.store::<S>(first + k, sums[k]);
                    }
                }
            }
        }
    }
}
