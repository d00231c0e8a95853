use nalgebra::Vector3;

use super::array::{Array, Values};
use super::mesh::Point;
use super::station_values::StationValues;
use crate::geometry::{Geometry, Placement};

/// Computes data at points that are fixed to stations.
#[derive(Debug)]
pub(super) struct PointData<'a> {
    pub geometry: &'a Geometry<'a>,
    pub points: &'a [Point],
    /// True for data in single precision.
    pub single: bool,
}

/// Names of section forces and moments.
const FORCES: [&str; 6] = ["N", "Qy", "Qz", "T", "My", "Mz"];

impl PointData<'_> {
    /// Vectors at the points.
    pub fn vectors(&self, name: &str, vectors: &[Vector3<f64>]) -> Array {
        let numbers = vectors.iter().flat_map(|x| [x[0], x[1], x[2]]);
        Array::new(name, 3, self.values(numbers))
    }

    fn numbers(&self, name: &str, of: impl Fn(&Point) -> f64) -> Array {
        Array::new(name, 1, self.values(self.points.iter().map(of)))
    }

    fn values(&self, numbers: impl Iterator<Item = f64>) -> Values {
        if self.single {
            Values::F32(numbers.map(|x| x as f32).collect())
        } else {
            Values::F64(numbers.collect())
        }
    }

    /// Arc length.
    pub fn arc_length(&self) -> Array {
        let stations = self.geometry.fields.stations();
        self.numbers("s", |point| stations[point.station].s)
    }

    /// Section forces, strain and stress.
    pub fn section_data(&self, values: &StationValues<'_>) -> Vec<Array> {
        let forces = FORCES.iter().enumerate();
        let mut arrays: Vec<Array> =
            forces.map(|(k, name)| self.numbers(name, |point| values.shown[point.station][k])).collect();
        arrays.push(self.numbers("bending_moment", |point| values.bending_moments[point.station]));
        arrays.push(self.numbers("strain", |point| values.strain(point)));
        arrays.push(self.numbers("stress", |point| values.stress(point)));
        arrays.push(self.numbers("largest_stress", |point| values.largest_stresses[point.station]));
        arrays
    }

    /// Normal and transverse axes of the sections.
    pub fn axes(&self, placed: &Placement) -> Vec<Array> {
        let of = |(k, name): (usize, &str)| {
            let axes: Vec<_> = self.points.iter().map(|point| placed.directors[point.station][k]).collect();
            self.vectors(name, &axes)
        };
        ["normal", "y_axis", "z_axis"].into_iter().enumerate().map(of).collect()
    }
}
