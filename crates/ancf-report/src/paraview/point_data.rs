use ancf::mechanics::shells::{LAYERS, SurfaceStress};
use ancf::units::Dimension;
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

/// Names of the components of resultants and stresses.
const COMPONENTS: [&str; 3] = ["uu", "vv", "uv"];

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
        arrays.push(self.numbers("von_mises", |point| values.equivalent_stress(point)));
        arrays
    }

    /// Directors of the stations with their names.
    pub fn axes(&self, placed: &Placement, names: [&str; 3]) -> Vec<Array> {
        let of = |(k, name): (usize, &str)| {
            let axes: Vec<_> = self.points.iter().map(|point| placed.directors[point.station][k]).collect();
            self.vectors(name, &axes)
        };
        names.into_iter().enumerate().map(of).collect()
    }
}

/// Names of the data of middle surfaces and their dimensions, without those that other bodies have.
pub(super) fn shell_dimensions() -> Vec<(String, Dimension)> {
    let (number, stress) = (Dimension::NUMBER, Dimension::STRESS);
    let own = |name: &str, dimension| (name.to_owned(), dimension);
    let mut all: Vec<_> = ["u", "v", "u_axis", "v_axis"].map(|name| own(name, number)).into();
    all.push(own("thickness", Dimension::LENGTH));
    all.push(own("energy_density", Dimension::FORCE_PER_LENGTH));
    for component in COMPONENTS {
        all.push((format!("n{component}"), Dimension::FORCE_PER_LENGTH));
        all.push((format!("m{component}"), Dimension::FORCE));
    }
    for layer in LAYERS {
        all.extend(COMPONENTS.map(|component| (format!("s{component}_{layer}"), stress)));
        all.extend(["von_mises", "s1", "s2"].map(|name| (format!("{name}_{layer}"), stress)));
        all.push((format!("s1_direction_{layer}"), number));
    }
    all
}

/// Data of the middle surfaces of shells. Names are those of the columns of probes.
impl PointData<'_> {
    /// Parameters u and v, and the thickness.
    pub fn shell_places(&self) -> Vec<Array> {
        let stations = self.geometry.fields.stations();
        let parameter = |(k, name): (usize, &str)| {
            self.numbers(name, |point| {
                stations[point.station].surface.and_then(|at| at.patch()).map_or(f64::NAN, |at| at[k])
            })
        };
        let mut arrays: Vec<_> = ["u", "v"].into_iter().enumerate().map(parameter).collect();
        let thickness = |station: usize| {
            let shape = &self.geometry.bodies[stations[station].body];
            let scale = shape.scale_at(station - shape.stations.start)[0];
            shape.grid.map_or(f64::NAN, |grid| 2.0 * grid.half * scale)
        };
        arrays.push(self.numbers("thickness", |point| thickness(point.station)));
        arrays
    }

    /// Resultants, stresses, principal stresses and their directions, and the strain energy per area.
    pub fn shell_data(&self, values: &StationValues<'_>, placed: &Placement) -> Vec<Array> {
        let of = |name: String, dimension: Dimension, get: &dyn Fn(&SurfaceStress) -> f64| {
            let unit = values.scales.unit(dimension);
            self.numbers(&name, |point| {
                values.surfaces[point.station].as_ref().map_or(f64::NAN, |found| get(found) * unit)
            })
        };
        let mut arrays = Vec::new();
        for (k, component) in COMPONENTS.iter().enumerate() {
            arrays.push(of(format!("n{component}"), Dimension::FORCE_PER_LENGTH, &|found| found.force[k]));
            arrays.push(of(format!("m{component}"), Dimension::FORCE, &|found| found.moment[k]));
        }
        for (i, layer) in LAYERS.iter().enumerate() {
            for (k, component) in COMPONENTS.iter().enumerate() {
                let stress = |found: &SurfaceStress| found.layers[i][k];
                arrays.push(of(format!("s{component}_{layer}"), Dimension::STRESS, &stress));
            }
            arrays.push(of(format!("von_mises_{layer}"), Dimension::STRESS, &|found| found.von_mises()[i]));
            for (k, name) in ["s1", "s2"].iter().enumerate() {
                let stress = |found: &SurfaceStress| found.principal()[i][k];
                arrays.push(of(format!("{name}_{layer}"), Dimension::STRESS, &stress));
            }
            let directions = self.points.iter().map(|point| {
                let [_, x, y] = placed.directors[point.station];
                let angle =
                    values.surfaces[point.station].as_ref().map_or(f64::NAN, |found| found.principal()[i][2]);
                x * angle.cos() + y * angle.sin()
            });
            arrays.push(self.vectors(&format!("s1_direction_{layer}"), &directions.collect::<Vec<_>>()));
        }
        arrays.push(of("von_mises".to_owned(), Dimension::STRESS, &SurfaceStress::largest_von_mises));
        arrays.push(of("energy_density".to_owned(), Dimension::FORCE_PER_LENGTH, &SurfaceStress::energy));
        arrays
    }
}
