use std::sync::Arc;

use ancf::assembly::Assembly;
use ancf::estimate::BodyError;
use ancf::model::Body;
use ancf::solver::equations::State;
use ancf::units::{Dimension, Scales};
use ancf::{Field, Model};
use nalgebra::Vector3;

use super::section_stress::SectionStress;
use super::surface_fields;
use crate::geometry::{Geometry, Placement};

/// Scalar along the bodies, by which they are coloured.
#[derive(Clone, Debug, PartialEq)]
pub struct ScalarField {
    /// Name.
    pub name: &'static str,
    /// Symbol.
    pub symbol: &'static str,
    /// Dimension.
    pub dimension: Dimension,
    /// True if the field has positive and negative values.
    pub diverging: bool,
    /// Values in the user's units, frame by frame and station by station; NaN where the field is not defined.
    pub values: Vec<f32>,
}

/// Scalar fields of frames that are added one by one.
///
/// | name | definition |
/// |---|---|
/// | axial force, torque, bending moment y, z | N, T, My, Mz of the section; cables have no bending moment about an axis |
/// | shear force, bending moment | √(Qy² + Qz²), √(My² + Mz²) |
/// | axial stress | maximum of abs(N/A + My z/I_y − Mz y/I_z) over the outline |
/// | shear stress | sum of the maxima of the shear stresses by torsion and by the shear force |
/// | von Mises stress | beams: √(σ² + 3τ²), the larger of its values at the extreme fibre and at the neutral axis; shells: the larger of the values at both faces |
/// | strain | Green's strain E_xx of the axis |
/// | speed | speed of the axis |
/// | displacement | distance from the reference placement |
/// | relative displacement | displacement of a mode shape relative to its maximum; of a complex shape √(Re² + Im²) |
/// | error of the mesh | contribution of the body to the largest relative error ([`BodyError`]) |
/// | membrane force, moment | components per length of a shell in the orthonormal frame of its reference surface |
/// | stress, principal stress, von Mises stress | of a shell at its top (+h/2 along the normal), middle and bottom |
/// | energy density | strain energy of a shell per area |
#[derive(Debug)]
pub struct ScalarFields<'a> {
    all: Vec<ScalarField>,
    sections: Vec<Option<Arc<SectionStress>>>,
    assembly: &'a Assembly,
    scales: Scales,
    has_velocities: bool,
    is_modal: bool,
    has_shells: bool,
    /// Error of the body of each station.
    errors: Vec<f32>,
}

/// Index of the equivalent stress, which beams and shells have.
const EQUIVALENT: usize = 8;
/// Index of the first field that depends on the motion only.
const MOTION: usize = 10;
/// Index of the first field of shells.
const SURFACE: usize = MOTION + 3;

impl<'a> ScalarFields<'a> {
    /// Fields of a model in the user's units, without values.
    pub fn new(
        model: &Model,
        assembly: &'a Assembly,
        scales: Scales,
        geometry: &Geometry<'_>,
        body_errors: &[BodyError],
    ) -> Self {
        let of = |name, symbol, dimension, diverging| ScalarField {
            name,
            symbol,
            dimension,
            diverging,
            values: Vec::new(),
        };
        let is_modal = model.analysis.has_shapes();
        let (displacement, length) = match is_modal {
            true => ("relative displacement", Dimension::NUMBER),
            false => ("displacement", Dimension::LENGTH),
        };
        let mut all = vec![
            of("axial force", "N", Dimension::FORCE, true),
            of("shear force", "Q", Dimension::FORCE, false),
            of("torque", "T", Dimension::ENERGY, true),
            of("bending moment", "M", Dimension::ENERGY, false),
            of("bending moment y", "My", Dimension::ENERGY, true),
            of("bending moment z", "Mz", Dimension::ENERGY, true),
            of("axial stress", "σ", Dimension::STRESS, false),
            of("shear stress", "τ", Dimension::STRESS, false),
            of("von Mises stress", "σv", Dimension::STRESS, false),
            of("strain", "ε", Dimension::NUMBER, true),
            of("speed", "v", Dimension::VELOCITY, false),
            of(displacement, "u", length, false),
            of("error of the mesh", "e", Dimension::NUMBER, false),
        ];
        let surfaces = surface_fields::FIELDS.into_iter();
        all.extend(
            surfaces.map(|(name, symbol, dimension, diverging)| of(name, symbol, dimension, diverging)),
        );
        let has_velocities = model.analysis.dynamics().is_some();
        let has_shells = model.has_shells();
        let sections = SectionStress::at_stations(model, geometry);
        let error_of = |body: usize| {
            let name = model.bodies.get(body).map(Body::name);
            let found = body_errors.iter().find(|error| Some(error.body.as_str()) == name);
            found.map_or(f32::NAN, |found| found.error as f32)
        };
        let errors = geometry.fields.stations().iter().map(|station| error_of(station.body)).collect();
        Self { all, sections, assembly, scales, has_velocities, is_modal, has_shells, errors }
    }

    /// Adds the values of a state with its placement, or those by the real and imaginary part of its shape. Displacements are measured
    /// from a reference placement.
    ///
    /// Mode shapes have displacements only, because their amplitude is arbitrary. Speeds exist in dynamics only.
    pub fn push(&mut self, geometry: &Geometry<'_>, s: &State, placed: &[&Placement], reference: &Placement) {
        if !self.is_modal {
            let forces = geometry.read(Field::SectionForces, s);
            for (k, forces) in forces.chunks_exact(6).enumerate() {
                let values = self.of_section(geometry, k, s, forces);
                let (sections, _) = self.all.split_at_mut(MOTION);
                sections.iter_mut().zip(values).for_each(|(field, x)| field.values.push(x as f32));
            }
            if self.has_shells {
                self.push_surfaces(geometry, s);
            }
        }
        if self.has_velocities {
            let speeds = geometry.read(Field::Velocity, s);
            let speed = |v: &[f64]| Vector3::from_column_slice(v).norm() as f32;
            self.all[MOTION].values.extend(speeds.chunks_exact(3).map(speed));
        }
        let distance = |(k, from): (usize, &Vector3<f64>)| {
            placed.iter().map(|placed| (placed.centres[k] - from).norm_squared()).sum::<f64>().sqrt()
        };
        let moved: Vec<f64> = reference.centres.iter().enumerate().map(distance).collect();
        let largest = moved.iter().copied().fold(0.0, f64::max);
        let unit = if self.is_modal && largest > 0.0 { largest } else { 1.0 };
        self.all[MOTION + 1].values.extend(moved.iter().map(|x| (x / unit) as f32));
        self.all[MOTION + 2].values.extend_from_slice(&self.errors);
    }

    /// Adds the fields of shells, and their equivalent stress to that of beams.
    fn push_surfaces(&mut self, geometry: &Geometry<'_>, s: &State) {
        let (sections, fields) = self.all.split_at_mut(SURFACE);
        let equivalent = &mut sections[EQUIVALENT].values;
        let stress = self.scales.unit(Dimension::STRESS);
        let mut station = equivalent.len() - geometry.stations();
        geometry.fields.each_surface_stress(s, |found| {
            if let Some(found) = &found {
                equivalent[station] = (found.largest_von_mises() * stress) as f32;
            }
            let values = found.map(|found| surface_fields::values(&found, &self.scales));
            station += 1;
            for (k, field) in fields.iter_mut().enumerate() {
                field.values.push(values.map_or(f32::NAN, |values| values[k] as f32));
            }
        });
    }

    fn of_section(&self, geometry: &Geometry<'_>, k: usize, s: &State, forces: &[f64]) -> [f64; MOTION] {
        let station = &geometry.fields.stations()[k];
        let (Some(section), Some(mesh)) = (&self.sections[k], self.assembly.body_of(station.body).mesh())
        else {
            return [f64::NAN; MOTION];
        };
        let &[n, qy, qz, t, my, mz] = forces else { return [f64::NAN; MOTION] };
        let forces = [n, qy, qz, t, my, mz];
        let stress = section.largest_stress(forces);
        let (shear, equivalent) = (section.largest_shear(forces), section.von_mises(forces));
        let strain = mesh.section_strain(s, station.s / self.scales.length).at([0.0; 2]);
        let axes = if section.has_axes { [my, mz] } else { [f64::NAN; 2] };
        [n, qy.hypot(qz), t, my.hypot(mz), axes[0], axes[1], stress, shear, equivalent, strain[(0, 0)]]
    }

    /// Returns the fields that have a finite value.
    pub fn into_defined(self) -> Vec<ScalarField> {
        let has_values = |field: &ScalarField| field.values.iter().any(|x| x.is_finite());
        self.all.into_iter().filter(has_values).collect()
    }

    /// Maximum number of fields of a model.
    pub(crate) fn most(model: &Model, is_modal: bool) -> usize {
        if is_modal {
            return 2;
        }
        let has_rods = model.bodies.iter().any(|body| matches!(body, Body::Beam(_) | Body::Cable(_)));
        let own = [(has_rods, MOTION), (model.has_shells(), surface_fields::COUNT + 1)];
        3 + own.into_iter().filter(|(has, _)| *has).map(|(_, count)| count).sum::<usize>()
    }
}
