use ancf::Field;
use ancf::assembly::Assembly;
use ancf::solver::equations::State;
use ancf::units::Scales;
use nalgebra::Vector3;

use super::array::{Array, Values};
use super::mesh::{Mesh, Point};
use crate::fields::SectionStress;
use crate::geometry::{Geometry, Placement};

/// Computes point data of a mesh in a state.
#[derive(Debug)]
pub(super) struct PointData<'a> {
    pub geometry: &'a Geometry<'a>,
    pub assembly: &'a Assembly,
    pub sections: &'a [Option<SectionStress>],
    pub scales: Scales,
    /// True for point data in single precision.
    pub single: bool,
}

/// Names of section forces and moments.
const FORCES: [&str; 6] = ["N", "Qy", "Qz", "T", "My", "Mz"];

impl PointData<'_> {
    /// Vectors at the points of a mesh.
    pub fn vectors(&self, name: &str, vectors: &[Vector3<f64>]) -> Array {
        let numbers = vectors.iter().flat_map(|x| [x[0], x[1], x[2]]);
        Array::new(name, 3, self.values(numbers))
    }

    fn numbers(&self, name: &str, numbers: impl Iterator<Item = f64>) -> Array {
        Array::new(name, 1, self.values(numbers))
    }

    fn values(&self, numbers: impl Iterator<Item = f64>) -> Values {
        if self.single {
            Values::F32(numbers.map(|x| x as f32).collect())
        } else {
            Values::F64(numbers.collect())
        }
    }

    /// Arc length.
    pub fn arc_length(&self, mesh: &Mesh) -> Array {
        let stations = self.geometry.fields.stations();
        self.numbers("s", mesh.points.iter().map(|point| stations[point.station].s))
    }

    /// Section forces, strain and stress.
    pub fn section_data(&self, mesh: &Mesh, s: &State) -> Vec<Array> {
        let forces = self.geometry.read(Field::SectionForces, s);
        let of = |point: &Point| -> [f64; 6] { std::array::from_fn(|k| forces[6 * point.station + k]) };
        let mut arrays: Vec<Array> = FORCES
            .iter()
            .enumerate()
            .map(|(k, name)| {
                self.numbers(name, mesh.points.iter().map(|point| self.with_axes(point, of(point))[k]))
            })
            .collect();
        let moment = |forces: [f64; 6]| forces[4].hypot(forces[5]);
        arrays.push(self.numbers("bending_moment", mesh.points.iter().map(|point| moment(of(point)))));
        arrays.push(self.numbers("strain", mesh.points.iter().map(|point| self.strain(point, s))));
        let stress = |point: &Point| {
            let [_, y, z] = point.arm;
            self.section(point).map_or(f64::NAN, |section| section.stress(of(point), [y, z]))
        };
        arrays.push(self.numbers("stress", mesh.points.iter().map(stress)));
        let largest =
            |point: &Point| self.section(point).map_or(f64::NAN, |section| section.largest_stress(of(point)));
        arrays.push(self.numbers("largest_stress", mesh.points.iter().map(largest)));
        arrays
    }

    /// Normal and transverse axes of the sections.
    pub fn axes(&self, mesh: &Mesh, placed: &Placement) -> Vec<Array> {
        let of = |(k, name): (usize, &str)| {
            let axes: Vec<_> = mesh.points.iter().map(|point| placed.directors[point.station][k]).collect();
            self.vectors(name, &axes)
        };
        ["normal", "y_axis", "z_axis"].into_iter().enumerate().map(of).collect()
    }

    fn section(&self, point: &Point) -> Option<&SectionStress> {
        self.sections[point.station].as_ref()
    }

    /// Section forces, with NaN for components along transverse axes of a cable.
    fn with_axes(&self, point: &Point, [n, qy, qz, t, my, mz]: [f64; 6]) -> [f64; 6] {
        match self.section(point) {
            Some(section) if section.has_axes => [n, qy, qz, t, my, mz],
            _ => [n, f64::NAN, f64::NAN, t, f64::NAN, f64::NAN],
        }
    }

    /// Green's strain E_xx at a point of a section.
    fn strain(&self, point: &Point, s: &State) -> f64 {
        let station = &self.geometry.fields.stations()[point.station];
        let Some(mesh) = self.assembly.body_of(station.body).mesh() else { return f64::NAN };
        let (unit, [_, y, z]) = (self.scales.length, point.arm);
        mesh.strain_and_stress(s, station.s / unit, [y / unit, z / unit])[0][(0, 0)]
    }
}
