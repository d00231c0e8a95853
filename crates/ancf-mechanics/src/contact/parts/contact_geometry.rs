use std::iter::StepBy;
use std::slice::Iter;
use std::sync::Arc;

use super::face_geometry::FaceGeometry;
use super::thickness_deviation::{places, thickness_deviation};
use crate::bodies::BeamMesh;
use crate::kinematics::{BicubicNet, ElementAxis, Marker};
use crate::shells::{ElementSurface, Shape, ShearShellMesh, ShellMesh, SurfacePlace};

/// Contact geometry of a body: a round tube about its axis, the balls of a rigid body, or the middle surface of a shell with
/// its thickness, with contact points on it.
#[derive(Clone, Debug, Default)]
pub struct ContactGeometry {
    pub(in crate::contact) axes: Vec<ElementAxis>,
    pub(in crate::contact) surfaces: Vec<SurfaceGeometry>,
    pub(in crate::contact) faces: Vec<FaceGeometry>,
    pub(in crate::contact) points: Vec<ContactPoint>,
    /// Number of points per element.
    pub(in crate::contact) count: usize,
    /// True for the points of a shell: lines of equal numbers of points, element by element.
    is_surface: bool,
    /// Radius of the tube or the balls, or half the smallest thickness of the shell.
    pub(in crate::contact) radius: f64,
    /// Search margin.
    pub(in crate::contact) margin: f64,
    /// Largest relative deviation of a surface that is touched from half the thickness.
    deviation: f64,
    /// Directions of a rigid body with balls.
    pub(in crate::contact) turning: Option<[Marker; 3]>,
}

/// Surface of an element of a thin shell.
#[derive(Clone, Debug)]
pub struct SurfaceGeometry {
    /// Number of the element in its shell.
    pub(in crate::contact) number: usize,
    pub(in crate::contact) surface: ElementSurface,
    /// Free edges: ξ = 0 and ξ = 1, η = 0 and η = 1.
    pub(in crate::contact) free: [[bool; 2]; 2],
    /// Half the thickness less the smallest one, if it varies.
    pub(in crate::contact) excess: Option<Arc<BicubicNet<f64>>>,
}

/// Contact point of a body.
#[derive(Clone, Debug)]
pub struct ContactPoint {
    /// Position of the point, or its vector from an obstacle.
    pub(in crate::contact) place: Marker,
    /// Length of beam or area of shell that the point represents.
    pub(in crate::contact) extent: f64,
    /// Radius of the body at the point less the smallest one.
    pub(in crate::contact) excess: f64,
}

impl ContactPoint {
    /// Creates a point of a body that represents a length of beam or an area of shell.
    pub const fn new(place: Marker, extent: f64) -> Self {
        Self { place, extent, excess: 0.0 }
    }

    /// Returns the point with another place.
    #[must_use]
    pub(in crate::contact) const fn at(&self, place: Marker) -> Self {
        Self { place, extent: self.extent, excess: self.excess }
    }
}

/// Search margin of points without a radius, relative to the size of their body.
const POINT_MARGIN: f64 = 0.05;

/// Returns the cells of Simpson's rule in each direction of an element, for at least a number of points.
const fn cells(count: usize) -> usize {
    if count < 3 { 1 } else { count / 2 }
}

impl ContactGeometry {
    /// Creates the tube of a body with a radius and a number of points per element.
    pub fn tube(mesh: &BeamMesh, radius: f64, count: usize) -> Self {
        let all = mesh.count() * count;
        let length = mesh.length() / all as f64;
        let point = |i: usize| ContactPoint::new(mesh.point((i as f64 + 0.5) * length), length);
        let points: Vec<_> = (0..all).map(point).collect();
        let axes = mesh.element_axes().collect();
        Self { axes, points, count, radius, margin: radius, ..Self::default() }
    }

    /// Creates the balls of a body about its points. They share the size of the body as the length.
    ///
    /// `turning` are the directions of a rigid body, and `None` for a point mass, which has no rotation.
    pub fn of_points(points: Vec<Marker>, turning: Option<[Marker; 3]>, radius: f64, size: f64) -> Self {
        let count = points.len();
        let points = points.into_iter().map(|place| ContactPoint::new(place, size / count as f64)).collect();
        let margin = radius.max(POINT_MARGIN * size);
        Self { points, count, radius, margin, turning, ..Self::default() }
    }

    /// Creates the surface of a thin shell with a thickness and at least `count` points per element in each direction.
    ///
    /// A thickness that varies is bicubic in each element of a surface that is touched.
    pub fn shell(mesh: &ShellMesh, thickness: f64, count: usize) -> Self {
        let own = Self::of_surface(mesh.surface_points(cells(count)), thickness, 2 * cells(count) + 1);
        let (mut nets, mut deviation) = (Vec::new(), 0.0_f64);
        for (number, values) in mesh.relative_thicknesses().into_iter().flatten().enumerate() {
            // Values have the smallest radius as their origin, derivatives have none.
            let of =
                |k: usize| 0.5 * thickness * values[k] - if k.is_multiple_of(4) { own.radius } else { 0.0 };
            let net = BicubicNet::from_nodes(&std::array::from_fn(of));
            for at in places() {
                let [t, s] = mesh.tangents(number, at);
                let radii = [own.radius, 0.5 * thickness * mesh.relative_thickness(number, at)];
                deviation = deviation.max(thickness_deviation([&t, &s], &net.at(at), radii));
            }
            nets.push(Arc::new(net));
        }
        let elements = mesh.element_surfaces().enumerate();
        let surface = |(number, (surface, free))| SurfaceGeometry {
            number,
            surface,
            free,
            excess: nets.get(number).cloned(),
        };
        Self { surfaces: elements.map(surface).collect(), deviation, ..own }
    }

    /// Creates the surface of a shear-deformable shell with a thickness and at least `count` points per element in each direction.
    ///
    /// A thickness that varies is linear or bilinear in each element of a surface that is touched.
    pub fn shear_shell(mesh: &ShearShellMesh, thickness: f64, count: usize) -> Self {
        let own = Self::of_surface(mesh.surface_points(cells(count)), thickness, 2 * cells(count) + 1);
        let faces = FaceGeometry::all(mesh, |scale| 0.5 * thickness * scale - own.radius);
        let mut deviation = 0.0_f64;
        for (element, face) in faces.iter().enumerate() {
            let Some(excess) = &face.excess else { continue };
            for at in places().filter(|[x, y]| face.shape == Shape::Quad || x + y <= 1.0) {
                let place = SurfacePlace { element, at };
                let [t, s] = mesh.tangents(place).map(|tangent| tangent.reference());
                let radii = [own.radius, 0.5 * thickness * mesh.relative_thickness(place)];
                let e = face.shape.offset_values(at, excess);
                deviation = deviation.max(thickness_deviation([&t, &s], &e, radii));
            }
        }
        Self { faces, deviation, ..own }
    }

    /// Returns the largest relative deviation of the surface that other bodies touch from half the thickness, where it varies.
    pub const fn thickness_deviation(&self) -> f64 {
        self.deviation
    }

    /// Creates the surface of points with their areas and their thicknesses relative to a given one.
    fn of_surface(points: impl Iterator<Item = (Marker, [f64; 2])>, thickness: f64, count: usize) -> Self {
        let radii = points.map(|(place, [extent, scale])| (place, extent, 0.5 * thickness * scale));
        let radii: Vec<_> = radii.collect();
        let all = || radii.iter().map(|(.., radius)| *radius);
        let (radius, margin) = (all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max));
        let point = |(place, extent, own)| ContactPoint { place, extent, excess: own - radius };
        let points = radii.into_iter().map(point).collect();
        Self { points, count: count * count, is_surface: true, radius, margin, ..Self::default() }
    }

    /// Returns the lines of points between which the body extends: along a beam, or in both directions of each element of a shell.
    pub(in crate::contact) fn lines(&self) -> impl Iterator<Item = StepBy<Iter<'_, ContactPoint>>> {
        let (count, of_element) =
            if self.is_surface { (self.count.isqrt(), self.count) } else { (1, self.points.len().max(1)) };
        self.points.chunks(of_element).flat_map(move |points| {
            let along =
                points.chunks(if count > 1 { count } else { of_element }).map(|line| line.iter().step_by(1));
            let across = if count > 1 { count } else { 0 };
            along.chain((0..across).map(move |k| points[k..].iter().step_by(count)))
        })
    }

    /// Returns true for a thin shell.
    pub const fn is_thin(&self) -> bool {
        !self.surfaces.is_empty()
    }

    /// Returns true for a shear-deformable shell.
    pub const fn has_faces(&self) -> bool {
        !self.faces.is_empty()
    }

    /// Returns the smallest radius, or the search margin of points without a radius.
    pub const fn margin(&self) -> f64 {
        if self.is_surface { self.radius } else { self.margin }
    }
}
