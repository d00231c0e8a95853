use nalgebra::{Matrix2, Matrix3, SMatrix, Vector3};

use super::forms::{
    CORNERS, Form, NODES, QUAD_POINTS, QUAD_VECTORS, SHEARED, STRAINS, SURFACE, Strains, Vectors, bilinear,
    forms, gradient, interpolate, points,
};
use crate::shells::laminates::{ThickSection, to_orthonormal};

/// Number of enhanced membrane strain modes.
pub(crate) const MODES: usize = 5;

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

/// Forms of the strains, common to all elements.
#[derive(Clone, Debug)]
pub(crate) struct ShearTables {
    pub(crate) forms: Box<[Form; STRAINS]>,
}

impl ShearTables {
    pub(crate) fn new() -> Self {
        Self { forms: forms() }
    }
}

/// Stiffness of the strains of an element.
pub(crate) type StrainStiffness = SMatrix<f64, STRAINS, STRAINS>;
/// Enhanced membrane strains at the integration points for unit parameters.
pub(crate) type SurfaceModes = SMatrix<f64, SURFACE, MODES>;

/// Constant data of a shear-deformable shell element.
#[derive(Clone, Debug)]
pub struct ShearProfile {
    /// Nodal vectors in the reference state, positions relative to the first node.
    pub(crate) reference: Vectors,
    /// Gradients of the strains by the nodal vectors in the reference state.
    pub(crate) gradients: Vec<Vectors>,
    /// Stiffness of the strains after elimination of the enhanced modes.
    pub(crate) stiffness: Box<StrainStiffness>,
    /// Matrix of the enhanced strains that follow from the compatible strains of the surface.
    pub(crate) enhancement: Box<SMatrix<f64, SURFACE, SURFACE>>,
    /// Compact mass matrix of the nodal vectors and first moments of the mass.
    pub(crate) mass: [[f64; QUAD_VECTORS]; QUAD_VECTORS],
    pub(crate) first: [f64; QUAD_VECTORS],
    /// Volumes (A_ξ × A_η)·D at the nodes.
    pub(crate) volumes: [f64; NODES],
    pub(crate) medium: ShearMedium,
}

/// Tangents of the reference surface at a point, and its area per unit of ξ and η.
pub(crate) fn tangents(at: [f64; 2], x: &Vectors) -> ([Vector3<f64>; 2], f64) {
    let [_, of_x, of_y] = bilinear(at);
    let [a, b] = [of_x, of_y].map(|shape| interpolate(&shape, 0, x));
    ([a, b], a.cross(&b).norm())
}

/// Computes the enhanced membrane strains at the integration points, in covariant components there.
///
/// The modes are (s, 0, 0), (0, t, 0), (0, 0, s), (0, 0, t), (0, 0, s t) with s = 2ξ − 1, t = 2η − 1, in the basis of the
/// middle of the element, times the ratio of the areas there and at the point. Their means over the area vanish.
///
/// Source: Simo & Rifai (1990); Andelfinger & Ramm (1993), five parameters.
fn modes(reference: &Vectors) -> SurfaceModes {
    let mut modes = SurfaceModes::zeros();
    let ([t, s], middle) = tangents([0.5, 0.5], reference);
    let normal = t.cross(&s) / middle;
    let dual = [s.cross(&normal) / middle, normal.cross(&t) / middle];
    for (k, (at, _)) in points().into_iter().enumerate() {
        let (own, area) = tangents(at, reference);
        // ε_αβ at the point = Σ ε_γδ (G_α·G₀^γ)(G_β·G₀^δ) of the components in the middle.
        let c = own.map(|a| [a.dot(&dual[0]), a.dot(&dual[1])]);
        let to_point = crate::shells::laminates::strain_transform(c);
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
            modes.fixed_view_mut::<3, 1>(6 * k, mode).copy_from(&strain);
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

/// Stiffness of the strains of the surface at the integration points.
fn surface_stiffness(reference: &Vectors, medium: &ShearMedium) -> SMatrix<f64, SURFACE, SURFACE> {
    let mut stiffness = SMatrix::<f64, SURFACE, SURFACE>::zeros();
    let section = &medium.section.surface;
    for (k, (at, weight)) in points().into_iter().enumerate() {
        let ([t, s], area) = tangents(at, reference);
        let to_local = to_orthonormal([&t, &s], &medium.axis);
        let [a, b, d] = [section.membrane, section.coupling, section.bending]
            .map(|c| to_local.transpose() * c * to_local * (weight * area));
        let mut put = |row: usize, column: usize, block: &Matrix3<f64>| {
            stiffness.fixed_view_mut::<3, 3>(6 * k + row, 6 * k + column).copy_from(block);
        };
        put(0, 0, &a);
        put(0, 3, &b);
        put(3, 0, &b);
        put(3, 3, &d);
    }
    stiffness
}

/// Stiffness of the transverse shear strains at their sampling points.
fn shear_stiffness(reference: &Vectors, medium: &ShearMedium) -> SMatrix<f64, SHEARED, SHEARED> {
    let mut stiffness = SMatrix::<f64, SHEARED, SHEARED>::zeros();
    for ([x, y], weight) in points() {
        let ([t, s], area) = tangents([x, y], reference);
        let to_local = shear_transform([&t, &s], &medium.axis);
        let covariant = to_local.transpose() * medium.section.shear * to_local * (weight * area);
        let interpolation = SMatrix::<f64, 2, SHEARED>::new(1.0 - y, y, 0.0, 0.0, 0.0, 0.0, 1.0 - x, x);
        stiffness += interpolation.transpose() * covariant * interpolation;
    }
    stiffness
}

impl ShearProfile {
    /// Creates the data of an element with the given nodal vectors in the reference state.
    pub(crate) fn new(tables: &ShearTables, reference: &Vectors, medium: &ShearMedium) -> Self {
        let own = surface_stiffness(reference, medium);
        let modes = modes(reference);
        let (of_modes, loads) = (modes.transpose() * own * modes, modes.transpose() * own);
        let solved = of_modes.cholesky().map(|factor| factor.solve(&loads));
        // A singular element has no stiffness that could be used: its entries are NaN.
        let solved = solved.unwrap_or_else(|| loads.map(|_| f64::NAN));
        let condensed = own - loads.transpose() * solved;
        let mut stiffness = Box::new(StrainStiffness::zeros());
        stiffness
            .fixed_view_mut::<SURFACE, SURFACE>(0, 0)
            .copy_from(&((condensed + condensed.transpose()) * 0.5));
        stiffness
            .fixed_view_mut::<SHEARED, SHEARED>(SURFACE, SURFACE)
            .copy_from(&shear_stiffness(reference, medium));
        let (mut mass, mut first) = ([[0.0; QUAD_VECTORS]; QUAD_VECTORS], [0.0; QUAD_VECTORS]);
        let [of_area, moment, rotary] = medium.section.inertia;
        for (at, weight) in points() {
            let ([shape, ..], (_, area)) = (bilinear(at), tangents(at, reference));
            let size = weight * area;
            for a in 0..NODES {
                first[2 * a] += size * of_area * shape[a];
                first[2 * a + 1] += size * moment * shape[a];
                let thickness = &mut stiffness[(SURFACE + SHEARED + a, SURFACE + SHEARED + a)];
                *thickness += size * medium.section.thickness * shape[a];
                for b in 0..NODES {
                    let part = size * shape[a] * shape[b];
                    mass[2 * a][2 * b] += part * of_area;
                    mass[2 * a][2 * b + 1] += part * moment;
                    mass[2 * a + 1][2 * b] += part * moment;
                    mass[2 * a + 1][2 * b + 1] += part * rotary;
                }
            }
        }
        let gradients = tables.forms.iter().map(|form| gradient(form, reference)).collect();
        let enhancement = Box::new(-(modes * solved));
        let volumes = volumes(reference);
        Self {
            reference: *reference,
            gradients,
            stiffness,
            enhancement,
            mass,
            first,
            volumes,
            medium: *medium,
        }
    }

    /// Returns an entry of the compact mass matrix of the vectors r₁, d₁, r₂, d₂, ..
    pub fn mass(&self, a: usize, b: usize) -> f64 {
        self.mass[a][b]
    }

    /// Returns ∫ N_a dA for the positions.
    pub(crate) fn areas(&self) -> [f64; NODES] {
        let mut areas = [0.0; NODES];
        for (at, weight) in points() {
            let ([shape, ..], (_, area)) = (bilinear(at), tangents(at, &self.reference));
            areas.iter_mut().zip(shape).for_each(|(sum, shape)| *sum += weight * area * shape);
        }
        areas
    }

    /// Returns the strains of the surface with the enhanced ones, at the integration points.
    pub(crate) fn enhanced(&self, strains: &Strains) -> SMatrix<f64, SURFACE, 1> {
        let own = strains.fixed_rows::<SURFACE>(0);
        own + *self.enhancement * own
    }
}

/// Volumes (a_ξ × a_η)·d at the nodes.
pub(crate) fn volumes(x: &Vectors) -> [f64; NODES] {
    std::array::from_fn(|a| {
        let ([t, s], _) = tangents(CORNERS[a], x);
        t.cross(&s).dot(&x[2 * a + 1])
    })
}

const _: () = assert!(QUAD_POINTS * 6 == SURFACE);
