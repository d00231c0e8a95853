use ancf::assembly::Assembly;
use ancf::solver::equations::State;
use ancf::units::Scales;
use ancf::{Field, Fields, Model};
use ancf_surface::BodySurfaces;
use nalgebra::Vector3;

use super::body_shape::{BodyKind, BodyShape};
use super::triad::{Triad, triad};

/// Shapes of the bodies of a model, and the stations along them.
#[derive(Debug)]
pub struct Geometry<'a> {
    /// Shapes of the bodies, in the order of the model.
    pub bodies: Vec<BodyShape>,
    pub(crate) fields: Fields<'a>,
    /// Directions of y at the start of each body, from which those of cables are transported.
    start: Vec<Vector3<f64>>,
}

/// Positions and directors of all stations in a state, in the user's units.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// Points of the axes.
    pub centres: Vec<Vector3<f64>>,
    /// Orthonormal directors: normal or first axis, y and z of the section.
    pub directors: Vec<[Vector3<f64>; 3]>,
}

impl Placement {
    /// True if all positions are finite and have squares in single precision.
    pub fn is_finite(&self) -> bool {
        const LARGEST: f64 = 1e18;
        self.centres.iter().all(|x| x.iter().all(|x| x.abs() < LARGEST))
    }
}

impl<'a> Geometry<'a> {
    /// Geometry of a model in the user's units, with `parts` stations per element.
    ///
    /// `size` is the size of the model. It determines the size of point masses and of rigid bodies without `surfaces`.
    pub fn new(
        model: &Model,
        assembly: &'a Assembly,
        scales: Scales,
        surfaces: &BodySurfaces,
        parts: u32,
        size: f64,
    ) -> Self {
        let fields = Fields::new(assembly, scales, parts);
        let mut first = 0;
        let bodies = model.bodies.iter().enumerate().map(|(number, body)| {
            let count =
                fields.stations()[first..].iter().take_while(|station| station.body == number).count();
            let stations = first..first + count;
            first += count;
            let surface = surfaces.get(number).cloned();
            let places = fields.stations()[stations.clone()].iter().filter_map(|station| station.surface);
            let thickness = body.thickness_at(places).unwrap_or_default();
            BodyShape::new(model, body, surface, stations, parts as usize, size).with_thickness(&thickness)
        });
        let bodies: Vec<_> = bodies.collect();
        let mut geometry = Self { bodies, fields, start: Vec::new() };
        let rest = geometry.read(Field::Directors, &assembly.rest());
        let y = |shape: &BodyShape| Vector3::from_column_slice(&rest[9 * shape.stations.start + 3..][..3]);
        geometry.start = geometry.bodies.iter().map(y).collect();
        geometry
    }

    /// Number of stations.
    pub fn stations(&self) -> usize {
        self.fields.stations().len()
    }

    /// Returns the numbers of a field in a state, station by station.
    pub fn read(&self, field: Field, s: &State) -> Vec<f64> {
        let mut numbers = Vec::with_capacity(self.stations() * field.width());
        self.fields.fill(field, s, &mut numbers);
        numbers
    }

    /// Computes positions and directors in a state.
    ///
    /// A cable has no torsion: its transverse directors are transported from station to station with minimal rotation.
    pub fn place(&self, s: &State) -> Placement {
        let centres = self.read(Field::Position, s);
        let read = self.read(Field::Directors, s);
        let mut directors: Vec<Triad> = read.chunks_exact(9).map(of_nine).collect();
        for (shape, start) in self.bodies.iter().zip(&self.start) {
            let own = &mut directors[shape.stations.clone()];
            match shape.kind {
                BodyKind::Beam | BodyKind::Shell | BodyKind::PointMass => {}
                BodyKind::Cable => {
                    let mut y = *start;
                    for triad_here in own {
                        *triad_here = triad(triad_here[0], y);
                        y = triad_here[1];
                    }
                }
                BodyKind::Rigid => {
                    for triad_here in own {
                        let [x, y, _] = shape.axes.map(|axis| {
                            triad_here[0] * axis[0] + triad_here[1] * axis[1] + triad_here[2] * axis[2]
                        });
                        *triad_here = triad(x, y);
                    }
                }
            }
        }
        Placement { centres: centres.chunks_exact(3).map(Vector3::from_column_slice).collect(), directors }
    }
}

fn of_nine(numbers: &[f64]) -> Triad {
    let [x, y] = [0, 3].map(|k| Vector3::from_column_slice(&numbers[k..k + 3]));
    triad(x, y)
}
