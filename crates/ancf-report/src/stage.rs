use ancf::Model;
use ancf::model::Body;
use nalgebra::Vector3;

use crate::link::{Link, links};
use crate::marker::{Marker, markers};
use crate::obstacle::{Obstacle, obstacles};
use crate::place::Places;
use crate::{Geometry, Quantities, Recording};

/// Stations to an element, and of elements that are few.
pub(crate) const PARTS: u32 = 4;
const MORE_PARTS: u32 = 8;
const FEW: u32 = 4;

/// A recording with what stands in its scene besides bodies.
pub(crate) struct Stage<'a> {
    pub recording: &'a Recording<'a>,
    pub markers: Vec<Marker>,
    /// Of each joint, the number of its mark.
    pub of_joints: Vec<Option<usize>>,
    pub links: Vec<Link>,
    pub obstacles: Vec<Obstacle>,
    pub size: f64,
}

impl<'a> Stage<'a> {
    pub fn new(recording: &'a Recording<'a>, scaled: &Model) -> Self {
        let places = Places { model: scaled, assembly: recording.simulation.assembly() };
        let (markers, of_joints) = markers(places);
        let (links, obstacles) = (links(places), obstacles(places));
        let mut stage = Self { recording, markers, of_joints, links, obstacles, size: 1.0 };
        stage.size = stage.extent();
        stage
    }

    /// The diagonal of the box about the reference state, marks included.
    fn extent(&self) -> f64 {
        let (assembly, rest) =
            (self.recording.simulation.assembly(), self.recording.simulation.assembly().rest());
        let geometry = Geometry::new(self.recording.model, assembly, self.recording.scales(), 2, 1.0);
        let unit = self.length();
        let marks = self.markers.iter().map(|marker| marker.reference() * unit);
        let ends = self.links.iter().flat_map(|link| link.ends(&rest)).map(|end| end * unit);
        let [low, high] = bounds(geometry.place(&rest).centres.into_iter().chain(marks).chain(ends));
        let size = (high - low).norm();
        let other = || self.obstacles.iter().map(|o| o.radius * unit).fold(0.0, f64::max);
        if size > 0.0 && size.is_finite() {
            size
        } else {
            Some(other()).filter(|radius| *radius > 0.0).unwrap_or(1.0)
        }
    }

    /// The unit of length of the states.
    pub fn length(&self) -> f64 {
        self.recording.scales().length
    }

    /// Bytes of a frame with so many stations.
    fn cost(&self, stations: usize) -> usize {
        let fields = Quantities::most(self.recording.is_modal());
        let moving = self.obstacles.iter().filter(|obstacle| obstacle.moves).count();
        let marks = 12 * self.markers.len() + 24 * (self.of_joints.len() + self.links.len()) + 48 * moving;
        stations * (12 + 18 + 2 * fields) + marks + 8
    }

    /// Stations to an element, and how many frames there is room for.
    pub fn resolution(&self, budget: usize) -> (u32, usize) {
        let bodies = &self.recording.model.bodies;
        let flexible = || bodies.iter().filter(|body| body.is_flexible());
        let rigid = bodies.len() - flexible().count();
        let least = flexible().map(Body::elements).min().unwrap_or(FEW);
        let frames = self.recording.frames.len().max(1);
        let wanted = if least < FEW { MORE_PARTS } else { PARTS };
        let cost = |parts: u32| {
            let stations = |body: &Body| body.elements() as usize * parts as usize + 1;
            self.cost(rigid + flexible().map(stations).sum::<usize>())
        };
        let fits = |parts: &u32| cost(*parts).saturating_mul(frames + 1) <= budget;
        let parts = (1..=wanted).rev().find(fits).unwrap_or(1);
        (parts, (budget / cost(parts)).saturating_sub(1).max(2))
    }
}

/// The corners of the box about the points that are finite.
pub(crate) fn bounds(points: impl Iterator<Item = Vector3<f64>>) -> [Vector3<f64>; 2] {
    let finite = points.filter(|x| x.iter().all(|x| x.is_finite()));
    let grown = finite.fold(None, |sum: Option<[Vector3<f64>; 2]>, x| {
        Some(sum.map_or([x, x], |[low, high]| [low.inf(&x), high.sup(&x)]))
    });
    grown.unwrap_or([Vector3::zeros(); 2])
}
