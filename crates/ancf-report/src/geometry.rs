use ancf::model::Assembly;
use ancf::scales::Scales;
use ancf::system::State;
use ancf::{Field, Fields, Model};
use nalgebra::Vector3;

use crate::frame::{Frame, frame};
use crate::{Drawn, Kind};

/// What the bodies of a model look like: sections swept through stations, boxes and balls.
#[derive(Debug)]
pub struct Geometry<'a> {
    /// The bodies, in the order of the model.
    pub bodies: Vec<Drawn>,
    pub(crate) fields: Fields<'a>,
    /// Directions of y at the start of each body, for what has none of its own.
    start: Vec<Vector3<f64>>,
}

/// Where the stations are in a state, in the user's units.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// The points of the axis.
    pub centres: Vec<Vector3<f64>>,
    /// Three orthonormal directors each: normal or first axis, y and z of the section.
    pub directors: Vec<[Vector3<f64>; 3]>,
}

impl Placement {
    /// Whether all positions are numbers of which single precision has squares.
    pub fn is_finite(&self) -> bool {
        const LARGEST: f64 = 1e18;
        self.centres.iter().all(|x| x.iter().all(|x| x.abs() < LARGEST))
    }
}

impl<'a> Geometry<'a> {
    /// The bodies of a model in the user's units, with `parts` stations to an element; `size` is that of the model, for what
    /// has no size of its own.
    pub fn new(model: &Model, assembly: &'a Assembly, scales: Scales, parts: u32, size: f64) -> Self {
        let fields = Fields::new(assembly, scales, parts);
        let mut first = 0;
        let bodies = model.bodies.iter().enumerate().map(|(number, body)| {
            let count =
                fields.stations()[first..].iter().take_while(|station| station.body == number).count();
            let stations = first..first + count;
            first += count;
            Drawn::new(model, body, stations, parts as usize, size)
        });
        let bodies: Vec<_> = bodies.collect();
        let mut geometry = Self { bodies, fields, start: Vec::new() };
        let rest = geometry.read(Field::Directors, &assembly.rest());
        let y = |drawn: &Drawn| Vector3::from_column_slice(&rest[9 * drawn.stations.start + 3..][..3]);
        geometry.start = geometry.bodies.iter().map(y).collect();
        geometry
    }

    /// Number of stations.
    pub fn stations(&self) -> usize {
        self.fields.stations().len()
    }

    /// The numbers of a field in a state, station by station.
    pub fn read(&self, field: Field, s: &State) -> Vec<f64> {
        let mut numbers = Vec::with_capacity(self.stations() * field.width());
        self.fields.fill(field, s, &mut numbers);
        numbers
    }

    /// Where the stations are in a state.
    ///
    /// The sections of a cable do not turn about its axis from station to station: each has the directions across of the one
    /// before, turned as little as can be.
    pub fn place(&self, s: &State) -> Placement {
        let centres = self.read(Field::Position, s);
        let read = self.read(Field::Directors, s);
        let mut directors: Vec<Frame> = read.chunks_exact(9).map(of_nine).collect();
        for (drawn, start) in self.bodies.iter().zip(&self.start) {
            let frames = &mut directors[drawn.stations.clone()];
            match drawn.kind {
                Kind::Beam | Kind::Point => {}
                Kind::Cable => {
                    let mut y = *start;
                    for own in frames {
                        *own = frame(own[0], y);
                        y = own[1];
                    }
                }
                Kind::Rigid => {
                    for own in frames {
                        let turned = |k: usize| {
                            let axis = drawn.axes.column(k);
                            own[0] * axis[0] + own[1] * axis[1] + own[2] * axis[2]
                        };
                        *own = frame(turned(0), turned(1));
                    }
                }
            }
        }
        Placement { centres: centres.chunks_exact(3).map(Vector3::from_column_slice).collect(), directors }
    }
}

fn of_nine(numbers: &[f64]) -> Frame {
    let [x, y] = [0, 3].map(|k| Vector3::from_column_slice(&numbers[k..k + 3]));
    frame(x, y)
}
