use nalgebra::{Matrix3, SMatrix, Vector3};

use super::bent_points::BendingPoints;
use super::hermite::{Shape, VECTORS, bicubic};
use super::membrane_stiffness::MembraneStiffness;
use super::tables::{
    MEMBRANE, POINTS, ShellTables, TANGENT_LISTS, each_sample, integration_points, sum, tangent_place,
};
use crate::lanes::{Row, VectorRows};
use crate::shells::laminates::{LocalSection, ShellSection};
use crate::shells::prestrain::SurfaceLaw;

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

/// Constant data of a shell element.
#[derive(Clone, Debug, PartialEq)]
pub struct ShellProfile {
    pub(crate) points: BendingPoints,
    /// Stiffness B of membrane strains and curvatures at the integration points, times the weights; none if they are not coupled.
    pub(crate) coupling: Vec<Matrix3<f64>>,
    /// Reference values of r_ξ and r_η at the sampling points.
    pub(crate) samples: Vec<[Vector3<f64>; 2]>,
    /// Reference tangents at the sampling points, in the lists of [`tangent_place`].
    pub(crate) tangents: [VectorRows; TANGENT_LISTS],
    /// Membrane stiffness of the strains at the sampling points.
    pub(crate) membrane: MembraneStiffness,
    /// Compact mass matrix M_ab = ∫ ρ h N_a N_b dA, and first moments ∫ ρ h N_a dA.
    pub(crate) mass: [Row; VECTORS],
    pub(crate) first: Shape,
    pub(crate) medium: ShellMedium,
    /// Sections at the places of [`section_places`](ShellProfile::section_places); none for equal sections.
    sections: Vec<LocalSection>,
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
        let (mut points, mut coupling) = (BendingPoints::ZERO, Vec::new());
        for (k, (at, weight)) in rule.into_iter().enumerate() {
            let values = tables.points[k].map(|shape| sum(&shape.0, reference));
            let area = values[0].cross(&values[1]).norm();
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
            points.set(k, &values, [&a, &d]);
            if medium.section.coupling != Matrix3::zeros() {
                coupling.push(b);
            }
        }
        let samples =
            tables.samples.iter().map(|sample| sample.shapes.map(|shape| sum(&shape, reference))).collect();
        let mut tangents = [[Row::ZERO; 3]; TANGENT_LISTS];
        for (r, row) in tables.tangents.iter().enumerate() {
            let ([list, k], tangent) = (tangent_place(r), sum(&row.0, reference));
            tangents[list].iter_mut().zip(tangent.iter()).for_each(|(row, x)| row.0[k] = *x);
        }
        let membrane = MembraneStiffness::new(&membrane);
        Self { points, coupling, samples, tangents, membrane, mass, first, medium: *medium, sections }
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
        for ((at, weight), area) in integration_points().into_iter().zip(self.points.areas.0) {
            let shape = bicubic(at, [0, 0]);
            areas.iter_mut().zip(shape).for_each(|(sum, shape)| *sum += weight * area * shape);
        }
        areas
    }

    /// Returns an entry ∫ ρ h N_a N_b dA of the compact mass matrix.
    pub fn mass(&self, a: usize, b: usize) -> f64 {
        self.mass[a].0[b]
    }

    /// Returns the smallest area r_ξ × r_η at the integration points, relative to the product of the lengths of r_ξ and r_η.
    pub(crate) fn least_angle(&self) -> f64 {
        let of = |k: usize| {
            let point = self.points.at(k);
            let [t, s, ..] = &point.reference;
            point.area / (t.norm() * s.norm())
        };
        (0..POINTS).map(of).fold(f64::INFINITY, |least, x| if x < least { x } else { least })
    }
}
