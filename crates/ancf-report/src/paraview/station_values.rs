use std::sync::Arc;

use ancf::Field;
use ancf::assembly::Assembly;
use ancf::mechanics::bodies::SectionStrain;
use ancf::mechanics::shells::SurfaceStress;
use ancf::solver::equations::State;
use ancf::units::{Dimension, Scales};

use super::mesh::Point;
use crate::fields::SectionStress;
use crate::geometry::Geometry;

/// Section forces, strains and stresses at the stations in a state.
#[derive(Debug)]
pub(super) struct StationValues<'a> {
    sections: &'a [Option<Arc<SectionStress>>],
    /// Section forces.
    forces: Vec<[f64; 6]>,
    /// Section forces, with NaN for components along transverse axes of a cable.
    pub shown: Vec<[f64; 6]>,
    pub bending_moments: Vec<f64>,
    pub largest_stresses: Vec<f64>,
    /// Strains of the sections; `None` for rigid bodies.
    strains: Vec<Option<SectionStrain>>,
    /// Stresses of shells, in the units of the solver.
    pub surfaces: Vec<Option<SurfaceStress>>,
    /// Units of the solver in those of the user.
    pub scales: Scales,
}

impl<'a> StationValues<'a> {
    /// Evaluates the stations of a geometry. `sections` are those of the stations.
    pub fn new(
        geometry: &Geometry<'_>,
        sections: &'a [Option<Arc<SectionStress>>],
        assembly: &Assembly,
        scales: Scales,
        s: &State,
    ) -> Self {
        let forces: Vec<[f64; 6]> = geometry
            .read(Field::SectionForces, s)
            .chunks_exact(6)
            .map(|of_station| std::array::from_fn(|k| of_station[k]))
            .collect();
        let of_stations = || forces.iter().zip(sections);
        let largest = |(forces, section): (&[f64; 6], &Option<Arc<SectionStress>>)| {
            section.as_ref().map_or(f64::NAN, |section| section.largest_stress(*forces))
        };
        let strain = |station: &ancf::Station| {
            let mesh = assembly.body_of(station.body).mesh()?;
            Some(mesh.section_strain(s, station.s / scales.length))
        };
        let mut surfaces = Vec::with_capacity(geometry.stations());
        geometry.fields.each_surface_stress(s, |found| surfaces.push(found));
        Self {
            shown: of_stations().map(|(forces, section)| with_axes(*forces, section.as_deref())).collect(),
            bending_moments: forces.iter().map(|[.., my, mz]| my.hypot(*mz)).collect(),
            largest_stresses: of_stations().map(largest).collect(),
            strains: geometry.fields.stations().iter().map(strain).collect(),
            surfaces,
            scales,
            sections,
            forces,
        }
    }

    /// Green's strain E_xx at a point of a section.
    pub fn strain(&self, point: &Point) -> f64 {
        let [_, y, z] = point.arm;
        let at = [y / self.scales.length, z / self.scales.length];
        self.strains[point.station].as_ref().map_or(f64::NAN, |section| section.at(at)[(0, 0)])
    }

    /// Stress of the section forces at a point of a section.
    pub fn stress(&self, point: &Point) -> f64 {
        let ([_, y, z], section) = (point.arm, self.sections[point.station].as_deref());
        section.map_or(f64::NAN, |section| section.stress(self.forces[point.station], [y, z]))
    }

    /// Equivalent stress of von Mises: of beams and cables the largest one of the section, of shells at the face of the point.
    pub fn equivalent_stress(&self, point: &Point) -> f64 {
        match (&self.sections[point.station], &self.surfaces[point.station]) {
            (Some(section), _) => section.von_mises(self.forces[point.station]),
            (None, Some(found)) => {
                let [top, _, bottom] = found.von_mises();
                let face = if point.arm[0] > 0.0 { top } else { bottom };
                face * self.scales.unit(Dimension::STRESS)
            }
            (None, None) => f64::NAN,
        }
    }
}

fn with_axes([n, qy, qz, t, my, mz]: [f64; 6], section: Option<&SectionStress>) -> [f64; 6] {
    match section {
        Some(section) if section.has_axes => [n, qy, qz, t, my, mz],
        _ => [n, f64::NAN, f64::NAN, t, f64::NAN, f64::NAN],
    }
}
