use std::ops::Range;
use std::sync::Arc;

use ancf_solver::equations::{State, Term};
use nalgebra::{Matrix2, Vector3};
use smallvec::SmallVec;

use super::any_element::AnyElement;
use super::faces::{Face, MeshTopology, NODES};
use super::profile::ShearMedium;
use super::strains::FACE_VECTORS;
use crate::inertia::MassVisitor;
use crate::kinematics::{
    Attachment, Directions, Marker, NodalVector, SectionFrame, VectorKind, gauss2, round_to_zero,
};
use crate::shells::laminates::SectionField;
use crate::shells::prestrain::{SurfaceLaw, SurfacePrestrain, SurfacePrestrains};

/// Place on a mesh: an element and (ξ, η) in it, from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePlace {
    /// Element, from 0.
    pub element: usize,
    /// Coordinates ξ and η.
    pub at: [f64; 2],
}

/// Mesh of shear-deformable shell elements with any connectivity of quadrilaterals and triangles.
///
/// Each node has the position r and the director d, a unit vector in the reference state.
#[derive(Clone, Debug)]
pub struct ShearShellMesh {
    first: usize,
    origin: Vector3<f64>,
    /// Positions relative to the origin and directors of the nodes.
    reference: Vec<[Vector3<f64>; 2]>,
    faces: Arc<Vec<Face>>,
    topology: Arc<MeshTopology>,
    neighbours: Arc<Vec<Vec<usize>>>,
    elements: Arc<Vec<AnyElement>>,
    axis: Vector3<f64>,
    sections: Option<SectionField>,
    prestrains: SurfacePrestrains,
}

impl ShearShellMesh {
    /// Creates a mesh. Positions of nodes are global, directors are unit vectors, and elements list their nodes counter-clockwise,
    /// seen from the side to which the directors point.
    pub fn new(
        first: usize,
        nodes: &[Vector3<f64>],
        directors: &[Vector3<f64>],
        faces: Vec<Face>,
        medium: &ShearMedium,
    ) -> Self {
        Self::varying(first, (nodes, directors), faces, medium, None)
    }

    /// Creates a mesh as [`new`](Self::new), with sections that vary over the surface.
    pub fn varying(
        first: usize,
        (nodes, directors): (&[Vector3<f64>], &[Vector3<f64>]),
        faces: Vec<Face>,
        medium: &ShearMedium,
        sections: Option<SectionField>,
    ) -> Self {
        let origin = nodes.first().copied().unwrap_or_default();
        let reference: Vec<_> = nodes.iter().zip(directors).map(|(r, d)| [r - origin, *d]).collect();
        let data = faces.iter().map(|face| {
            let nodes = face.nodes();
            let coordinates =
                nodes.iter().flat_map(|node| (0..6).map(move |i| first + 6 * node + i)).collect();
            let corner = reference[nodes[0]][0];
            let vectors = nodes.iter().flat_map(|node| [reference[*node][0] - corner, reference[*node][1]]);
            (coordinates, vectors.collect())
        });
        let elements = Arc::new(AnyElement::all(data, medium, sections.as_ref()));
        let topology = MeshTopology::new(nodes.len(), &faces);
        let neighbours = Arc::new(topology.neighbours(nodes.len()));
        let (topology, faces) = (Arc::new(topology), Arc::new(faces));
        let (axis, prestrains) = (medium.axis, SurfacePrestrains::default());
        Self { first, origin, reference, faces, topology, neighbours, elements, axis, sections, prestrains }
    }

    /// Prescribes strains.
    #[must_use]
    pub fn with_prestrains(self, sources: Vec<SurfacePrestrain>) -> Self {
        let of = |element: usize, here| self.elements[element].prestrained(here);
        Self { prestrains: SurfacePrestrains::new(sources, self.elements.len(), of), ..self }
    }

    pub(crate) fn prestrains(&self) -> &SurfacePrestrains {
        &self.prestrains
    }

    /// Returns the number of coordinates.
    pub fn coordinates(&self) -> usize {
        6 * self.reference.len()
    }

    /// Returns the range of the coordinates.
    pub fn range(&self) -> Range<usize> {
        self.first..self.first + self.coordinates()
    }

    /// Returns the number of nodes.
    pub fn nodes(&self) -> usize {
        self.reference.len()
    }

    /// Returns the nodes of the elements.
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    pub(crate) fn elements(&self) -> &[AnyElement] {
        &self.elements
    }

    /// Returns the elements, then their prescribed strains as terms.
    pub fn terms(&self) -> Vec<Box<dyn Term>> {
        self.elements.iter().map(AnyElement::term).chain(self.prestrains.copied()).collect()
    }

    /// Returns the elements at a node.
    pub(crate) fn at_node(&self, node: usize) -> &[usize] {
        self.topology.at_node(node)
    }

    /// Returns the first coordinate and the reference value of the position (`kind` = 0) or the director (1) of a node.
    pub fn nodal(&self, node: usize, kind: usize) -> (usize, Vector3<f64>) {
        let [r, d] = self.reference[node];
        (self.first + 6 * node + 3 * kind, if kind == 0 { r + self.origin } else { d })
    }

    /// Returns the first coordinate and the reference position of the corners of an element, counter-clockwise about its normal.
    pub fn corners(&self, element: usize) -> Vec<(usize, Vector3<f64>)> {
        self.faces()[element].nodes().iter().map(|node| self.nodal(*node, 0)).collect()
    }

    fn nodal_vector(&self, s: &State, node: usize, kind: usize) -> NodalVector {
        let (first, reference) = self.nodal(node, kind);
        let value = reference + Vector3::from_column_slice(&s.q[first..first + 3]);
        NodalVector { first, kind: if kind == 0 { VectorKind::Position } else { VectorKind::Z }, value }
    }

    /// Returns all nodal vectors in a state, in the order of the coordinates.
    pub fn vectors<'a>(&'a self, s: &'a State) -> impl Iterator<Item = NodalVector> + 'a {
        (0..2 * self.nodes()).map(move |i| self.nodal_vector(s, i / 2, i % 2))
    }

    /// Returns the displacements of the nodal vectors of an element in a state.
    pub(crate) fn displacements(&self, s: &State, element: usize) -> SmallVec<[Vector3<f64>; FACE_VECTORS]> {
        self.vectors_in(&s.q, element)
    }

    /// Returns the parts of the nodal vectors of an element in the coordinates or velocities.
    pub(crate) fn vectors_in(
        &self,
        coordinates: &[f64],
        element: usize,
    ) -> SmallVec<[Vector3<f64>; FACE_VECTORS]> {
        let of = |node: &usize| [0, 3].map(|kind| self.first + 6 * node + kind);
        let starts = self.faces[element].nodes().iter().flat_map(of);
        starts.map(|start| Vector3::from_column_slice(&coordinates[start..start + 3])).collect()
    }

    /// Returns the node and the kind of vector to which a coordinate of this mesh belongs.
    pub fn locate_coordinate(&self, coordinate: usize) -> Option<(usize, VectorKind)> {
        let vector = coordinate.checked_sub(self.first)? / 3;
        let kind = if vector.is_multiple_of(2) { VectorKind::Position } else { VectorKind::Z };
        (vector / 2 < self.nodes()).then_some((vector / 2, kind))
    }

    /// Returns the place of a node in its first element.
    pub fn place_of(&self, node: usize) -> SurfacePlace {
        let element = self.topology.at_node(node)[0];
        SurfacePlace { element, at: self.faces[element].place_of(node).expect("an element at a node has it") }
    }

    /// Returns the node at a place, if there is one.
    pub fn node_at(&self, place: SurfacePlace) -> Option<usize> {
        let face = &self.faces[place.element];
        let corner = face.shape().corners().iter().position(|at| *at == place.at)?;
        Some(face.nodes()[corner])
    }

    /// Returns the marker Σ w_a r_a (`kind` = 0) or Σ w_a d_a (1) over the nodes of an element.
    fn marker(&self, element: usize, weights: &[f64; NODES], kind: usize) -> Marker {
        let own = || self.faces[element].nodes().iter().zip(weights);
        let sum: Vector3<f64> = own().map(|(&n, &w)| self.reference[n][kind] * w).sum();
        let parts = own().map(|(&n, &w)| (self.first + 6 * n + 3 * kind, w));
        let origin = if kind == 0 { round_to_zero(weights.iter().sum()) } else { 0.0 };
        Marker::new(parts, sum + self.origin * origin)
    }

    /// Returns the shape functions at a place and their derivatives.
    fn shapes(&self, place: SurfacePlace) -> [[f64; NODES]; 3] {
        self.faces[place.element].shape().values(place.at)
    }

    /// Returns the point of the middle surface at a place.
    pub fn point(&self, place: SurfacePlace) -> Marker {
        self.marker(place.element, &self.shapes(place)[0], 0)
    }

    /// Returns the director at a place.
    pub fn director(&self, place: SurfacePlace) -> Marker {
        self.marker(place.element, &self.shapes(place)[0], 1)
    }

    /// Returns the tangents r_ξ and r_η at a place.
    pub fn tangents(&self, place: SurfacePlace) -> [Marker; 2] {
        let [_, x, y] = self.shapes(place);
        [x, y].map(|shape| self.marker(place.element, &shape, 0))
    }

    /// Returns the direction normal to the director at which a tangent of the frame is taken.
    fn direction(&self, director: &Vector3<f64>) -> Vector3<f64> {
        let normal = director.normalize();
        (self.axis - normal * self.axis.dot(&normal)).normalize()
    }

    /// Returns the derivative of the middle surface along a direction of the reference state.
    ///
    /// Within elements it is that of the element. At a node it is a fit to the edges there, without preference of an element.
    fn tangent(&self, place: SurfacePlace, along: &Vector3<f64>) -> Marker {
        if let Some(node) = self.node_at(place) {
            let d = self.reference[node][1];
            let other = d.cross(along);
            let arms: Vec<_> = self.neighbours[node]
                .iter()
                .map(|&n| {
                    let arm = self.reference[n][0] - self.reference[node][0];
                    (n, [arm.dot(along), arm.dot(&other)])
                })
                .collect();
            let mut moment = Matrix2::zeros();
            for (_, [x, y]) in &arms {
                moment += Matrix2::new(x * x, x * y, x * y, y * y);
            }
            let inverse = moment.try_inverse().unwrap_or_else(Matrix2::zeros);
            let weights: Vec<(usize, f64)> =
                arms.iter().map(|(n, [x, y])| (*n, inverse[(0, 0)] * x + inverse[(0, 1)] * y)).collect();
            let own = -weights.iter().map(|(_, w)| w).sum::<f64>();
            let all = || weights.iter().copied().chain([(node, own)]);
            let reference = all().map(|(n, w)| self.reference[n][0] * w).sum();
            return Marker::new(all().map(|(n, w)| (self.first + 6 * n, w)), reference);
        }
        let tangents = self.tangents(place);
        let [t, s] = tangents.each_ref().map(Marker::reference);
        let normal = t.cross(&s);
        let square = normal.norm_squared();
        let dual = [s.cross(&normal) / square, normal.cross(&t) / square];
        Marker::combined((0..2).map(|k| (along.dot(&dual[k]), &tangents[k])))
    }

    /// Returns the frame of the section at a place: y along the director, and a tangent of the middle surface.
    ///
    /// Rotations of the director are those of the frame. The rotation about it is that of the tangent.
    pub fn frame(&self, place: SurfacePlace) -> SectionFrame {
        let director = self.director(place);
        let along = self.direction(&director.reference());
        SectionFrame::new([&director, &self.tangent(place, &along)], 1.0)
    }

    /// Returns the attachment of joints, loads and probes at a place.
    pub fn attachment(&self, place: SurfacePlace) -> Attachment {
        Attachment { point: self.point(place).into(), directions: Directions::Surface(self.frame(place)) }
    }

    /// Returns the attachment at a place with the frame of stresses: the normal of the middle surface, e₁ along the projection of
    /// the axis of the section, and n × e₁.
    pub fn station(&self, place: SurfacePlace) -> Attachment {
        let tangents = self.tangents(place);
        let [t, s] = tangents.each_ref().map(Marker::reference);
        let normal = t.cross(&s).normalize();
        let along = self.direction(&normal);
        let square = t.cross(&s).norm_squared();
        let dual = [s.cross(&t.cross(&s)) / square, t.cross(&s).cross(&t) / square];
        let direction = |e: Vector3<f64>| Marker::combined((0..2).map(|k| (e.dot(&dual[k]), &tangents[k])));
        let frame = SectionFrame::new([&direction(along), &direction(normal.cross(&along))], 1.0);
        Attachment { point: self.point(place).into(), directions: Directions::Surface(frame) }
    }

    /// Returns the length of the longest edge of an element.
    pub fn largest_side(&self) -> f64 {
        let edges = self.faces.iter().flat_map(Face::edges);
        edges.map(|[a, b]| (self.reference[b][0] - self.reference[a][0]).norm()).fold(0.0, f64::max)
    }

    /// Returns the law of the section at a place.
    pub(super) fn law_at(&self, place: SurfacePlace) -> SurfaceLaw {
        let section = self.sections.as_ref().map(|field| field.at(place.element, place.at));
        let data = self.elements[place.element].data();
        let [t, s] = data.tangents(place.at);
        data.medium().law(section.as_ref(), [&t, &s])
    }

    /// Returns the thickness at a place, relative to that of the whole shell.
    pub(crate) fn relative_thickness(&self, place: SurfacePlace) -> f64 {
        self.sections.as_ref().map_or(1.0, |field| field.at(place.element, place.at).scale)
    }

    /// Returns the relative thickness at the nodes of an element; `None` if it is constant.
    pub(crate) fn relative_thicknesses(&self, element: usize) -> Option<SmallVec<[f64; NODES]>> {
        self.sections.as_ref()?;
        let corners = self.faces[element].shape().corners().iter();
        Some(corners.map(|at| self.relative_thickness(SurfacePlace { element, at: *at })).collect())
    }

    /// Returns a grid of 2 `cells` + 1 points in each direction of each element, line by line, with their reference areas and relative
    /// thicknesses.
    ///
    /// A uniform pressure on them is exact.
    pub fn surface_points(&self, cells: usize) -> impl Iterator<Item = (Marker, [f64; 2])> + '_ {
        (0..self.faces.len()).flat_map(move |element| {
            self.faces[element].grid_rule(cells).into_iter().map(move |(at, weight)| {
                let place = SurfacePlace { element, at };
                let [t, s] = self.tangents(place).map(|tangent| tangent.reference());
                (self.point(place), [t.cross(&s).norm() * weight, self.relative_thickness(place)])
            })
        })
    }

    /// Returns the points r, tangents r_ξ and r_η, areas and relative thicknesses at the integration points of an element.
    pub(crate) fn flow_points(&self, element: usize) -> Vec<([Marker; 3], [f64; 2])> {
        let of = |(at, weight): &([f64; 2], f64)| {
            let place = SurfacePlace { element, at: *at };
            let [a, b] = self.tangents(place);
            let area = a.reference().cross(&b.reference()).norm();
            ([self.point(place), a, b], [weight * area, self.relative_thickness(place)])
        };
        self.faces[element].shape().points().iter().map(of).collect()
    }

    /// Returns the sums Σ m x over parts of the body, one for each element.
    pub fn mass_markers(&self) -> impl Iterator<Item = Marker> + '_ {
        self.elements.iter().enumerate().map(|(k, element)| {
            let first = element.data().first_moments();
            let mut weights = [[0.0; NODES]; 2];
            first.iter().enumerate().for_each(|(a, m)| weights[a % 2][a / 2] = *m);
            let [of_points, of_directors] = [0, 1].map(|kind| self.marker(k, &weights[kind], kind));
            Marker::combined([(1.0, &of_points), (1.0, &of_directors)])
        })
    }

    /// Visits the elements with their nodal vectors in a state and their compact mass matrices.
    pub(crate) fn visit_masses(&self, s: &State, visit: &mut MassVisitor<'_>) {
        for (face, element) in self.faces.iter().zip(self.elements.iter()) {
            let vectors: SmallVec<[NodalVector; FACE_VECTORS]> = face
                .nodes()
                .iter()
                .flat_map(|node| [0, 1].map(|kind| self.nodal_vector(s, *node, kind)))
                .collect();
            visit(&vectors, &|a, b| element.data().mass(a, b));
        }
    }

    /// Returns the marker ∫ r dA over an element, in the reference state.
    pub fn area_marker(&self, element: usize) -> Marker {
        self.marker(element, &self.elements[element].data().areas(), 0)
    }

    /// Returns the places on an edge between two nodes at which loads are integrated, with the lengths that they stand for.
    ///
    /// `None` if no element has the edge.
    pub fn edge_points(&self, [from, to]: [usize; 2]) -> Option<[(SurfacePlace, f64); 2]> {
        let element = self.topology.of_edge([from, to]).next()?;
        let face = &self.faces[element];
        let (a, b) = (face.place_of(from)?, face.place_of(to)?);
        let length = (self.reference[to][0] - self.reference[from][0]).norm();
        Some(gauss2().map(|(x, weight)| {
            let at = [0, 1].map(|i| a[i] + (b[i] - a[i]) * x);
            (SurfacePlace { element, at }, weight * length)
        }))
    }

    /// Returns the strain energy.
    pub fn strain_energy(&self, s: &State) -> f64 {
        let of = |(k, element): (usize, &AnyElement)| element.data().strain_energy(&self.displacements(s, k));
        let own: f64 = self.elements.iter().enumerate().map(of).sum();
        let flat = |k: usize| self.displacements(s, k).iter().flatten().copied().collect();
        own + self.prestrains.strain_energy(s, flat)
    }
}
