use nalgebra::{DMatrix, DVector, Matrix2, Matrix3, SMatrix, Vector3};

use super::faces::Shape;
use super::strains::{
    Fields, SURFACE, ShearTables, Strains, Vectors, Weighting, interpolate, sampled_shear,
    shear_interpolation,
};
use crate::shells::laminates::{
    LocalSection, MembranePoints, ShellSection, ThickSection, strain_transform, to_orthonormal,
};
use crate::shells::prestrain::{ReferencePoint, SurfaceLaw};

/// Number of enhanced membrane strain modes of a quadrilateral. A triangle and an element with a law of the membrane have none.
const MODES: usize = 5;

/// Material, inertia and loads of a shear-deformable shell that are common to its elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearMedium {
    /// Stiffness and mass per area.
    pub section: ThickSection,
    /// Axis whose projection on the surface is the first direction of the section and of stresses.
    pub axis: Vector3<f64>,
    /// Retardation time τ of the damping that is proportional to the stiffness.
    pub retardation: f64,
    /// Rate α of the damping α M v that is proportional to the mass.
    pub mass_damping: f64,
    /// Acceleration of gravity.
    pub gravity: Vector3<f64>,
}

/// Section and axis at a point.
pub(crate) struct ThickLaw {
    section: ThickSection,
    axis: Vector3<f64>,
}

impl ShearMedium {
    fn thick_law(&self, local: Option<&LocalSection>, tangents: [&Vector3<f64>; 2]) -> ThickLaw {
        let local = local.unwrap_or(&LocalSection::WHOLE);
        let axis = local.axis_at(Some(self.axis), tangents).unwrap_or(self.axis);
        ThickLaw { section: self.section.scaled(local.scale), axis }
    }

    /// Returns the law of the surface at a point with a section of its own and reference tangents.
    pub(crate) fn law(&self, local: Option<&LocalSection>, tangents: [&Vector3<f64>; 2]) -> SurfaceLaw {
        let ThickLaw { section, axis } = self.thick_law(local, tangents);
        SurfaceLaw { section: section.surface, axis: Some(axis), stress_axis: Some(self.axis) }
    }
}

/// Constant data of a shear-deformable shell element with V nodal vectors and S strains.
#[derive(Clone, Debug)]
pub(crate) struct ShearProfile<const V: usize, const S: usize> {
    pub(crate) shape: Shape,
    /// Nodal vectors in the reference state, positions relative to the first node.
    pub(crate) reference: Vectors<V>,
    /// Vectors of the surface in the reference state.
    pub(crate) fields: Fields,
    /// Stiffness of the strains after elimination of the enhanced modes.
    pub(crate) stiffness: Box<SMatrix<f64, S, S>>,
    /// Matrix of the enhanced strains that follow from the compatible strains of the surface.
    enhancement: DMatrix<f64>,
    /// Compact mass matrix of the nodal vectors and first moments of the mass.
    pub(crate) mass: [[f64; V]; V],
    pub(crate) first: [f64; V],
    pub(crate) medium: ShearMedium,
    sections: Sections,
    /// Law of the membrane forces if it is not linear.
    pub(super) membrane: Option<MembranePoints>,
}

/// Sections at the [`section_places`](Shape::section_places) of an element; none for equal sections.
type Sections = Vec<LocalSection>;

/// Returns a point of the reference surface with the nodal vectors x.
pub(crate) fn reference_point(shape: Shape, at: [f64; 2], x: &[Vector3<f64>]) -> ReferencePoint {
    let [_, of_x, of_y] = shape.values(at);
    let [tangents, directors] = [0, 1].map(|kind| [of_x, of_y].map(|of| interpolate(&of, kind, x)));
    ReferencePoint::of_directors(tangents, directors)
}

/// Tangents of the reference surface at a point, and its area per unit of ξ and η.
pub(crate) fn tangents(shape: Shape, at: [f64; 2], x: &[Vector3<f64>]) -> ([Vector3<f64>; 2], f64) {
    let [_, of_x, of_y] = shape.values(at);
    let [a, b] = [of_x, of_y].map(|weights| interpolate(&weights, 0, x));
    ([a, b], a.cross(&b).norm())
}

/// Volume (a_ξ × a_η)·d at a node.
pub(crate) fn volume(shape: Shape, corner: usize, x: &[Vector3<f64>]) -> f64 {
    let ([t, s], _) = tangents(shape, shape.corners()[corner], x);
    t.cross(&s).dot(&x[2 * corner + 1])
}

/// Computes the enhanced membrane strains at the integration points, in covariant components there.
///
/// The modes are (s, 0, 0), (0, t, 0), (0, 0, s), (0, 0, t), (0, 0, s t) with s = 2ξ − 1, t = 2η − 1, in the basis of the
/// middle of the element, times the ratio of the areas there and at the point. Their means over the area vanish.
///
/// Source: Simo & Rifai (1990); Andelfinger & Ramm (1993), five parameters.
fn modes(shape: Shape, reference: &[Vector3<f64>], medium: &ShearMedium) -> DMatrix<f64> {
    let points = shape.surface_points();
    if shape == Shape::Triangle || medium.section.surface.law.is_some() {
        return DMatrix::zeros(SURFACE * points.len(), 0);
    }
    let mut modes = DMatrix::zeros(SURFACE * points.len(), MODES);
    let ([t, s], middle) = tangents(shape, shape.middle(), reference);
    let normal = t.cross(&s) / middle;
    let dual = [s.cross(&normal) / middle, normal.cross(&t) / middle];
    for (k, (at, _)) in points.iter().enumerate() {
        let (own, area) = tangents(shape, *at, reference);
        // ε_αβ at the point = Σ ε_γδ (G_α·G₀^γ)(G_β·G₀^δ) of the components in the middle.
        let to_point = strain_transform(own.map(|a| [a.dot(&dual[0]), a.dot(&dual[1])]));
        let [x, y] = at.map(|x| 2.0 * x - 1.0);
        let values = [
            Vector3::new(x, 0.0, 0.0),
            Vector3::new(0.0, y, 0.0),
            Vector3::new(0.0, 0.0, x),
            Vector3::new(0.0, 0.0, y),
            Vector3::new(0.0, 0.0, x * y),
        ];
        for (mode, value) in values.into_iter().enumerate() {
            let strain = to_point * value * (middle / area);
            modes.fixed_view_mut::<3, 1>(SURFACE * k, mode).copy_from(&strain);
        }
    }
    modes
}

/// Returns the matrix from covariant transverse shear strains to those in the orthonormal basis with a first direction.
fn shear_transform([t, s]: [&Vector3<f64>; 2], axis: &Vector3<f64>) -> Matrix2<f64> {
    let normal = t.cross(s);
    let area = normal.norm();
    let unit = normal / area;
    let e1 = (axis - unit * axis.dot(&unit)).normalize();
    let e2 = unit.cross(&e1);
    let dual = [s.cross(&unit) / area, unit.cross(t) / area];
    Matrix2::new(e1.dot(&dual[0]), e1.dot(&dual[1]), e2.dot(&dual[0]), e2.dot(&dual[1]))
}

/// Matrices from covariant strains to the basis of the section at the integration points of the surface, and their areas times the
/// relative thickness.
fn membrane_points(
    shape: Shape,
    reference: &[Vector3<f64>],
    (medium, sections): (&ShearMedium, &Sections),
) -> impl Iterator<Item = (Matrix3<f64>, f64)> {
    shape.surface_points().iter().enumerate().map(move |(k, (at, weight))| {
        let ([t, s], area) = tangents(shape, *at, reference);
        let scale = sections.get(k).map_or(1.0, |section| section.scale);
        (to_orthonormal([&t, &s], &medium.axis), weight * area * scale)
    })
}

/// Stiffness of the strains of the surface at the integration points.
fn surface_stiffness(
    shape: Shape,
    reference: &[Vector3<f64>],
    (medium, sections): (&ShearMedium, &Sections),
) -> DMatrix<f64> {
    let points = shape.surface_points();
    let mut stiffness = DMatrix::zeros(SURFACE * points.len(), SURFACE * points.len());
    for (k, (at, weight)) in points.iter().enumerate() {
        let ([t, s], area) = tangents(shape, *at, reference);
        let law = medium.law(sections.get(k), [&t, &s]);
        let [a, b, d] = law.section.covariant([&t, &s], law.axis).map(|c| c * (weight * area));
        let mut put = |row: usize, column: usize, block: &Matrix3<f64>| {
            stiffness.fixed_view_mut::<3, 3>(SURFACE * k + row, SURFACE * k + column).copy_from(block);
        };
        put(0, 0, &a);
        put(0, 3, &b);
        put(3, 0, &b);
        put(3, 3, &d);
    }
    stiffness
}

/// Factor α of the transverse shear stiffness h²/(h² + α l²) of triangles.
const STABILISATION: f64 = 0.1;

/// Reduction of the transverse shear stiffness of a triangle with the longest edge l: h²/(h² + α l²), h² = 12 D/A.
///
/// A thin plate has as many edges without shear as coordinates, and locks without this factor. It changes the energy of shear by
/// terms of the second power of the size of the elements.
///
/// Source: Lyly, Stenberg & Vihinen (1993); Bischoff & Bletzinger (2001).
fn stabilisation(reference: &[Vector3<f64>], section: &ShellSection) -> f64 {
    let trace = |c: &Matrix3<f64>| c[(0, 0)] + c[(1, 1)] + 2.0 * c[(2, 2)];
    let square = 12.0 * trace(&section.bending) / trace(&section.membrane);
    let edges = [(0, 2), (2, 4), (4, 0)].map(|(a, b)| (reference[a] - reference[b]).norm_squared());
    square / (square + STABILISATION * edges.into_iter().fold(0.0, f64::max))
}

/// Stiffness of the sampled transverse shear strains.
fn shear_stiffness(
    shape: Shape,
    reference: &[Vector3<f64>],
    (medium, sections): (&ShearMedium, &Sections),
) -> DMatrix<f64> {
    let sampled = sampled_shear(shape).len();
    let mut stiffness = DMatrix::zeros(sampled, sampled);
    for (k, (at, weight)) in shape.points().iter().enumerate() {
        let ([t, s], area) = tangents(shape, *at, reference);
        let ThickLaw { section, axis } =
            medium.thick_law(sections.get(shape.surface_points().len() + k), [&t, &s]);
        let factor = if shape == Shape::Triangle { stabilisation(reference, &section.surface) } else { 1.0 };
        let to_local = shear_transform([&t, &s], &axis);
        let covariant = to_local.transpose() * section.shear * to_local * (factor * weight * area);
        let weights = shear_interpolation(shape, *at);
        for i in 0..sampled {
            for j in 0..sampled {
                let [p, q] = [i, j].map(|k| [weights[0][k], weights[1][k]]);
                for (a, p) in p.iter().enumerate() {
                    stiffness[(i, j)] += p * (covariant[(a, 0)] * q[0] + covariant[(a, 1)] * q[1]);
                }
            }
        }
    }
    stiffness
}

impl<const V: usize, const S: usize> ShearProfile<V, S> {
    /// Creates the data of an element with the given nodal vectors in the reference state. `sections` are those at the
    /// [`section_places`](Shape::section_places), or none.
    pub(crate) fn new(
        tables: &ShearTables,
        reference: &Vectors<V>,
        medium: &ShearMedium,
        sections: Sections,
    ) -> Self {
        let shape = tables.shape;
        let own = surface_stiffness(shape, reference, (medium, &sections));
        let modes = modes(shape, reference, medium);
        let (of_modes, loads) = (modes.transpose() * (&own * &modes), modes.transpose() * &own);
        let solved = of_modes.cholesky().map(|factor| factor.solve(&loads));
        // A singular element has no stiffness that could be used: its entries are NaN.
        let solved = solved.unwrap_or_else(|| loads.map(|_| f64::NAN));
        let condensed = own - loads.transpose() * &solved;
        let mut stiffness = Box::new(SMatrix::<f64, S, S>::zeros());
        let surface = condensed.nrows();
        stiffness
            .view_mut((0, 0), (surface, surface))
            .copy_from(&((&condensed + condensed.transpose()) * 0.5));
        let sheared = shear_stiffness(shape, reference, (medium, &sections));
        stiffness.view_mut((surface, surface), sheared.shape()).copy_from(&sheared);
        let thickness = surface + sheared.nrows();
        let (mut mass, mut first) = ([[0.0; V]; V], [0.0; V]);
        for (k, (at, weight)) in shape.points().iter().enumerate() {
            let ([weights, ..], ([t, s], area)) = (shape.values(*at), tangents(shape, *at, reference));
            let section = medium.thick_law(sections.get(shape.surface_points().len() + k), [&t, &s]).section;
            let ([of_area, moment, rotary], size) = (section.inertia, weight * area);
            for a in 0..shape.nodes() {
                first[2 * a] += size * of_area * weights[a];
                first[2 * a + 1] += size * moment * weights[a];
                stiffness[(thickness + a, thickness + a)] += size * section.thickness * weights[a];
                for b in 0..shape.nodes() {
                    let part = size * weights[a] * weights[b];
                    mass[2 * a][2 * b] += part * of_area;
                    mass[2 * a][2 * b + 1] += part * moment;
                    mass[2 * a + 1][2 * b] += part * moment;
                    mass[2 * a + 1][2 * b + 1] += part * rotary;
                }
            }
        }
        let fields = tables.fields(reference);
        let enhancement = -(modes * solved);
        let points = membrane_points(shape, reference, (medium, &sections));
        let membrane = MembranePoints::new(&medium.section.surface, points);
        let (reference, medium) = (*reference, *medium);
        Self { shape, reference, fields, stiffness, enhancement, mass, first, medium, sections, membrane }
    }

    /// Returns the law at an integration point of the surface with reference tangents.
    pub(crate) fn law(&self, point: usize, tangents: [&Vector3<f64>; 2]) -> SurfaceLaw {
        self.medium.law(self.sections.get(point), tangents)
    }

    /// Returns the strains of the surface with the enhanced ones, at the integration points.
    pub(crate) fn enhanced(&self, strains: &Strains<S>) -> DVector<f64> {
        let own = DVector::from_column_slice(&strains.as_slice()[..self.enhancement.nrows()]);
        &own + &self.enhancement * &own
    }

    /// Adds bounds of the rounding errors of the forces, for an element with displacements and velocities of the given magnitudes.
    pub(crate) fn add_rounding(
        &self,
        tables: &ShearTables,
        [q, v]: [&Weighting<V>; 2],
        (strains, stress): (&Strains<S>, &Strains<S>),
        bound: &mut Weighting<V>,
    ) {
        let (sum, time) = (Self::SUM, self.medium.retardation);
        let sizes: [Weighting<V>; S] = tables.gradient_sizes(&tables.sizes(&self.fields, q));
        let mut errors = [0.0; S];
        for (error, sizes) in errors.iter_mut().zip(&sizes) {
            *error = sum * (0..V).map(|a| sizes[a] * (q[a] + time * v[a])).sum::<f64>();
        }
        let mut of_stress = [0.0; S];
        for (k, error) in of_stress.iter_mut().enumerate() {
            let row = self.stiffness.row(k);
            *error =
                row.iter().enumerate().map(|(l, c)| c.abs() * (errors[l] + sum * strains[l].abs())).sum();
        }
        Self::distribute_rounding(&sizes, (&of_stress, stress), bound);
    }

    /// Adds bounds of the rounding errors of the forces of constant stresses.
    pub(crate) fn add_stress_rounding(
        &self,
        tables: &ShearTables,
        q: &Weighting<V>,
        stress: &Strains<S>,
        bound: &mut Weighting<V>,
    ) {
        let sizes = tables.gradient_sizes(&tables.sizes(&self.fields, q));
        Self::distribute_rounding(&sizes, (&[0.0; S], stress), bound);
    }

    /// Adds bounds of the rounding errors of the forces of stresses with errors, for bounds of the gradients of the strains.
    fn distribute_rounding(
        sizes: &[Weighting<V>; S],
        (errors, stress): (&[f64; S], &Strains<S>),
        bound: &mut Weighting<V>,
    ) {
        for (k, sizes) in sizes.iter().enumerate() {
            let error = errors[k] + Self::SUM * stress[k].abs();
            (0..V).for_each(|a| bound[a] += error * sizes[a]);
        }
    }

    /// Roundings in a sum of V products, relative to the sum of their magnitudes.
    const SUM: f64 = 0.5 * V as f64 * f64::EPSILON;
}
