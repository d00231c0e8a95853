use ancf::Model;
use ancf::model::Body;
use nalgebra::Vector3;

use crate::fields::ScalarFields;
use crate::geometry::{
    ARROWS, Attachments, BodyShape, Geometry, Link, Obstacle, Placement, Symbol, Symbols, bounding_box,
    links, obstacles,
};
use crate::run::Recording;

/// Stations per element, in each direction of a shell.
pub(super) const PARTS: u32 = 4;
/// Stations per element of a body with fewer than `FEW` elements.
const MORE_PARTS: u32 = 8;
const FEW: u32 = 4;

/// Recording with the symbols, links and obstacles of its scene.
pub(crate) struct SceneLayout<'a> {
    pub recording: &'a Recording<'a>,
    pub symbols: Symbols,
    pub links: Vec<Link>,
    pub obstacles: Vec<Obstacle>,
    /// Size of the model, by which symbols, rigid bodies and shapes are scaled.
    pub size: f64,
}

impl<'a> SceneLayout<'a> {
    /// `scaled` is the model in the units of the solver.
    pub fn new(recording: &'a Recording<'a>, scaled: &Model) -> Self {
        let attachments = Attachments::new(scaled, recording.simulation);
        let symbols = Symbols::new(attachments);
        let (links, obstacles) = (links(attachments, recording.surfaces), obstacles(attachments));
        let mut layout = Self { recording, symbols, links, obstacles, size: 1.0 };
        layout.size = layout.extent();
        layout
    }

    /// Diagonal of the box around the reference state, symbols, links and surfaces of rigid bodies included.
    fn extent(&self) -> f64 {
        let (assembly, rest) =
            (self.recording.simulation.assembly(), self.recording.simulation.assembly().rest());
        let Recording { model, surfaces, .. } = self.recording;
        let geometry = Geometry::new(model, assembly, self.recording.scales(), surfaces, 2, 1.0);
        let symbols = self.symbols.all.iter().map(Symbol::reference).map(Vector3::from);
        let ends = self.links.iter().flat_map(|link| link.ends(&rest));
        let placed = geometry.place(&rest);
        let corners = geometry.bodies.iter().flat_map(|shape| surface_corners(shape, &placed));
        let centres = placed.centres.iter().copied();
        let [low, high] = bounding_box(centres.chain(symbols).chain(ends).chain(corners));
        let size = (high - low).norm();
        let largest_radius = || self.obstacles.iter().map(|o| o.radius).fold(0.0, f64::max);
        if size > 0.0 && size.is_finite() {
            size
        } else {
            Some(largest_radius()).filter(|radius| *radius > 0.0).unwrap_or(1.0)
        }
    }

    /// Bytes of a frame, with the imaginary part of its shape.
    fn bytes_of_frame(&self, stations: usize) -> usize {
        let parts = if self.recording.is_complex() { 2 } else { 1 };
        let fields = ScalarFields::most(self.recording.model, self.recording.is_modal());
        let moving = self.obstacles.iter().filter(|obstacle| obstacle.moves).count();
        let vectors = 12 * self.symbols.all.len()
            + 24 * (self.symbols.of_joints.len() + self.links.len())
            + 48 * moving
            + 12 * ARROWS * ARROWS * self.recording.model.loads.len();
        parts * (stations * (12 + 18 + 2 * fields) + vectors) + 8
    }

    /// Returns stations per element and the number of frames that fit into a budget in bytes.
    pub fn resolution(&self, budget: usize) -> (u32, usize) {
        let frames = self.recording.frames.len().max(1);
        let bytes = |parts: u32| self.bytes_of_frame(self.stations(parts));
        let parts = self.finest_parts(|parts| bytes(parts).saturating_mul(frames + 1) <= budget);
        (parts, (budget / bytes(parts)).saturating_sub(1).max(2))
    }

    /// Returns stations per element for at most a number of stations of all bodies, but at least one.
    pub fn parts(&self, most: usize) -> u32 {
        self.finest_parts(|parts| self.stations(parts) <= most)
    }

    /// Number of stations of all bodies.
    fn stations(&self, parts: u32) -> usize {
        let along = |elements: u32| elements as usize * parts as usize + 1;
        let stations = |body: &Body| match body {
            Body::Beam(_) | Body::Cable(_) => along(body.elements()),
            Body::Shell(shell) => shell.elements.map(along).iter().product(),
            Body::ShearShell(shell) => shell.mesh.elements.len() * (parts as usize + 1).pow(2),
            Body::Rigid(_) | Body::Mass(_) => 1,
        };
        self.recording.model.bodies.iter().map(stations).sum()
    }

    /// Largest suitable number of stations per element.
    fn finest_parts(&self, is_suitable: impl Fn(u32) -> bool) -> u32 {
        let along = |body: &Body| match body {
            Body::Shell(shell) => shell.elements.into_iter().min(),
            // Elements are bilinear: points between their nodes add no shape.
            Body::ShearShell(shell) => Some(shell.mesh.elements.len() as u32),
            _ => body.is_flexible().then(|| body.elements()),
        };
        let least = self.recording.model.bodies.iter().filter_map(along).min().unwrap_or(FEW);
        let finest = if least < FEW { MORE_PARTS } else { PARTS };
        (1..=finest).rev().find(|parts| is_suitable(*parts)).unwrap_or(1)
    }
}

/// Opposite corners of the box around the surface of a rigid body, whose directors are the global axes.
fn surface_corners(shape: &BodyShape, placed: &Placement) -> Vec<Vector3<f64>> {
    let bounds = shape.surface.as_ref().and_then(|surface| surface.bounds());
    let centre = placed.centres[shape.stations.start];
    bounds.map_or_else(Vec::new, |bounds| bounds.map(|corner| centre + Vector3::from(corner)).to_vec())
}
