use std::ops::Range;
use std::sync::Arc;

use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;

use super::element_surface::ElementSurface;
use super::laminates::SectionField;
use super::prestrain::{ElementPrestrain, SurfacePrestrain, SurfacePrestrains};
use super::thin::{Shell48, ShellMedium, VECTORS, bicubic, integration_points};
use crate::inertia::MassVisitor;
use crate::kinematics::{
    Attachment, Directions, Marker, NodalVector, SectionFrame, VectorKind, gauss4, round_to_zero,
    simpson_points,
};

/// Kinds of the vectors of a node.
const NODE: [VectorKind; 4] = [VectorKind::Position, VectorKind::Slope, VectorKind::Y, VectorKind::Twist];

/// Distance from a node, in elements, that counts as rounding.
const ON_NODE: f64 = 1e-9;

/// Edge of a patch, on which u or v is 0 or 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShellEdge {
    /// True for an edge with constant u.
    pub along_v: bool,
    /// True for the edge with u = 1 or v = 1.
    pub at_end: bool,
}

/// Structured mesh of n × m shell elements over the patch 0 ≤ u, v ≤ 1.
///
/// The vectors of a node are r, r_ξ, r_η, r_ξη with ξ = n u, η = m v. Nodes are numbered along u first.
#[derive(Clone, Debug)]
pub struct ShellMesh {
    first: usize,
    divisions: [usize; 2],
    origin: Vector3<f64>,
    /// Reference values of the vectors, positions relative to the origin.
    reference: Vec<Vector3<f64>>,
    elements: Arc<Vec<Shell48>>,
    pub(super) sections: Option<SectionField>,
    prestrains: SurfacePrestrains,
}

impl ShellMesh {
    /// Creates a mesh that interpolates a map (u, v) → r, ∂r/∂u, ∂r/∂v, ∂²r/∂u∂v relative to the origin.
    pub fn new(
        first: usize,
        divisions: [usize; 2],
        origin: Vector3<f64>,
        map: impl Fn([f64; 2]) -> [Vector3<f64>; 4],
        medium: &ShellMedium,
    ) -> Self {
        Self::varying(first, divisions, origin, map, (medium, None))
    }

    /// Creates a mesh as [`new`](Self::new), with sections that vary over the surface.
    pub fn varying(
        first: usize,
        divisions: [usize; 2],
        origin: Vector3<f64>,
        map: impl Fn([f64; 2]) -> [Vector3<f64>; 4],
        (medium, sections): (&ShellMedium, Option<SectionField>),
    ) -> Self {
        let [n, m] = divisions;
        let scale = [1.0, 1.0 / n as f64, 1.0 / m as f64, 1.0 / (n * m) as f64];
        let nodes = (0..=m).flat_map(|j| (0..=n).map(move |i| [i as f64 / n as f64, j as f64 / m as f64]));
        let reference: Vec<_> = nodes
            .flat_map(|at| {
                let values = map(at);
                [0, 1, 2, 3].map(|k| values[k] * scale[k])
            })
            .collect();
        let vectors = |element: usize| Self::vectors_of(divisions, element);
        let data = (0..n * m).map(|element| {
            let own = vectors(element);
            let coordinates = own.iter().flat_map(|v| (0..3).map(move |i| first + 3 * v + i)).collect();
            let corner = reference[own[0]];
            let of =
                |a: usize| reference[own[a]] - if a.is_multiple_of(4) { corner } else { Vector3::zeros() };
            (coordinates, std::array::from_fn(of))
        });
        let elements = Arc::new(Shell48::all(data, medium, sections.as_ref()));
        let prestrains = SurfacePrestrains::default();
        Self { first, divisions, origin, reference, elements, sections, prestrains }
    }

    /// Prescribes strains.
    #[must_use]
    pub fn with_prestrains(self, sources: Vec<SurfacePrestrain>) -> Self {
        let of = |element: usize, here| ElementPrestrain::new(&self.elements[element], here);
        Self { prestrains: SurfacePrestrains::new(sources, self.elements.len(), of), ..self }
    }

    pub(super) fn prestrains(&self) -> &SurfacePrestrains {
        &self.prestrains
    }

    /// Returns the indices of the vectors of an element, in local order.
    fn vectors_of([n, _]: [usize; 2], element: usize) -> [usize; VECTORS] {
        let (i, j) = (element % n, element / n);
        std::array::from_fn(|a| {
            let (node, kind) = (a / 4, a % 4);
            4 * ((j + node / 2) * (n + 1) + i + node % 2) + kind
        })
    }

    /// Returns the number of elements along u and v.
    pub fn divisions(&self) -> [usize; 2] {
        self.divisions
    }

    /// Returns the number of coordinates.
    pub fn coordinates(&self) -> usize {
        3 * self.reference.len()
    }

    /// Returns the elements.
    pub fn elements(&self) -> &[Shell48] {
        &self.elements
    }

    /// Returns the elements, then their prescribed strains as terms.
    pub fn terms(&self) -> Vec<Box<dyn Term>> {
        let elements = self.elements.iter().map(|element| Box::new(element.clone()) as _);
        elements.chain(self.prestrains.copied()).collect()
    }

    /// Returns all nodal vectors in a state, in the order of the coordinates.
    pub fn vectors<'a>(&'a self, s: &'a State) -> impl Iterator<Item = NodalVector> + 'a {
        self.reference.iter().enumerate().map(move |(i, reference)| {
            let (first, kind) = (self.first + 3 * i, NODE[i % 4]);
            let reference = if i % 4 == 0 { reference + self.origin } else { *reference };
            NodalVector { first, kind, value: reference + Vector3::from_column_slice(&s.q[first..first + 3]) }
        })
    }

    /// Returns the nodal vectors of an element in a state, in local order.
    pub fn element_vectors(&self, s: &State, element: usize) -> [NodalVector; VECTORS] {
        let vectors = self.patch_vectors(element);
        std::array::from_fn(|a| {
            let (first, reference) = vectors[a];
            let value = reference + Vector3::from_column_slice(&s.q[first..first + 3]);
            NodalVector { first, kind: NODE[a % 4], value }
        })
    }

    /// Returns the first coordinate and the reference value of each nodal vector of an element.
    pub(super) fn patch_vectors(&self, element: usize) -> [(usize, Vector3<f64>); VECTORS] {
        Self::vectors_of(self.divisions, element).map(|i| {
            let origin = if i % 4 == 0 { self.origin } else { Vector3::zeros() };
            (self.first + 3 * i, self.reference[i] + origin)
        })
    }

    /// Returns the first coordinate and the reference position of the corners of an element, counter-clockwise about its normal.
    pub fn corners(&self, element: usize) -> [(usize, Vector3<f64>); 4] {
        let vectors = self.patch_vectors(element);
        [0, 4, 12, 8].map(|a| vectors[a])
    }

    /// Returns the reference values of the nodal vectors of an element, positions relative to its first node, and their displacements.
    pub(crate) fn reference_and_displacements(
        &self,
        s: &State,
        element: usize,
    ) -> [[Vector3<f64>; VECTORS]; 2] {
        let own = Self::vectors_of(self.divisions, element);
        let corner = self.reference[own[0]];
        let rest =
            |a: usize| self.reference[own[a]] - if a.is_multiple_of(4) { corner } else { Vector3::zeros() };
        [std::array::from_fn(rest), self.vectors_in(&s.q, element)]
    }

    /// Returns the parts of the nodal vectors of an element in the coordinates or velocities.
    pub(crate) fn vectors_in(&self, coordinates: &[f64], element: usize) -> [Vector3<f64>; VECTORS] {
        Self::vectors_of(self.divisions, element).map(|vector| {
            let first = self.first + 3 * vector;
            Vector3::from_column_slice(&coordinates[first..first + 3])
        })
    }

    /// Returns the node and the kind of vector to which a coordinate of this mesh belongs.
    pub fn locate_coordinate(&self, coordinate: usize) -> Option<(usize, VectorKind)> {
        let vector = coordinate.checked_sub(self.first)? / 3;
        (vector < self.reference.len()).then(|| (vector / 4, NODE[vector % 4]))
    }

    /// Returns the node nearest to (u, v).
    pub fn node_at(&self, [u, v]: [f64; 2]) -> usize {
        let [n, m] = self.divisions;
        let [i, j] = [u * n as f64, v * m as f64].map(|x| x.round() as usize);
        j.min(m) * (n + 1) + i.min(n)
    }

    /// Returns (u, v) of a node.
    pub fn node_place(&self, node: usize) -> [f64; 2] {
        let [n, m] = self.divisions;
        [(node % (n + 1)) as f64 / n as f64, (node / (n + 1)) as f64 / m as f64]
    }

    /// Returns the element and (ξ, η) in it of a point (u, v). At nodes ξ and η are exactly 0 or 1.
    pub fn locate(&self, at: [f64; 2]) -> (usize, [f64; 2]) {
        let of = |k: usize| {
            let (count, x) = (self.divisions[k], at[k] * self.divisions[k] as f64);
            let x = if (x - x.round()).abs() < ON_NODE { x.round() } else { x };
            let cell = (x.floor().max(0.0) as usize).min(count - 1);
            (cell, (x - cell as f64).clamp(0.0, 1.0))
        };
        let ((i, x), (j, y)) = (of(0), of(1));
        (j * self.divisions[0] + i, [x, y])
    }

    /// Returns true if (u, v) is a node.
    pub fn is_node(&self, at: [f64; 2]) -> bool {
        self.locate(at).1.iter().all(|x| *x == 0.0 || *x == 1.0)
    }

    /// Returns the marker of Σ_a w_a e_a over the vectors of an element.
    fn marker(&self, element: usize, weights: &[f64; VECTORS]) -> Marker {
        let own = Self::vectors_of(self.divisions, element);
        let positions: f64 = (0..VECTORS).step_by(4).map(|a| weights[a]).sum();
        let sum: Vector3<f64> = own.iter().zip(weights).map(|(&i, w)| self.reference[i] * *w).sum();
        let parts = own.iter().zip(weights).map(|(i, &w)| (self.first + 3 * i, w));
        Marker::new(parts, sum + self.origin * round_to_zero(positions))
    }

    /// Returns the derivative of the surface at a point: of order i by ξ and j by η.
    pub fn derivative(&self, at: [f64; 2], order: [usize; 2]) -> Marker {
        let (element, local) = self.locate(at);
        self.marker(element, &bicubic(local, order))
    }

    /// Returns the point of the surface at (u, v).
    pub fn point(&self, at: [f64; 2]) -> Marker {
        self.derivative(at, [0, 0])
    }

    /// Returns the frame of the surface at (u, v): its normal r_ξ × r_η and two tangents.
    pub fn frame(&self, at: [f64; 2]) -> SectionFrame {
        SectionFrame::new([&self.derivative(at, [1, 0]), &self.derivative(at, [0, 1])], 0.5)
    }

    /// Returns the attachment of joints, loads and probes at (u, v).
    pub fn attachment(&self, at: [f64; 2]) -> Attachment {
        Attachment { point: self.point(at).into(), directions: Directions::Surface(self.frame(at)) }
    }

    /// Returns the attachment at (u, v) with the frame of stresses: the normal, e₁ along r_,u, and n × e₁.
    pub fn station(&self, at: [f64; 2]) -> Attachment {
        let frame = SectionFrame::new([&self.derivative(at, [1, 0]), &self.derivative(at, [0, 1])], 1.0);
        Attachment { point: self.point(at).into(), directions: Directions::Surface(frame) }
    }

    /// Returns the grid of (u, v) at the nodes and at `parts` − 1 points between them in each direction, along u first.
    pub fn grid(&self, parts: usize) -> impl Iterator<Item = [f64; 2]> + use<> {
        let [n, m] = self.grid_divisions(parts);
        (0..=m).flat_map(move |j| (0..=n).map(move |i| [i as f64 / n as f64, j as f64 / m as f64]))
    }

    /// Returns the numbers of cells of [`grid`](Self::grid) along u and v.
    pub fn grid_divisions(&self, parts: usize) -> [usize; 2] {
        self.divisions.map(|count| count * parts)
    }

    /// Returns the tangents r_ξ and r_η of the reference surface at a point of an element.
    pub(crate) fn tangents(&self, element: usize, local: [f64; 2]) -> [Vector3<f64>; 2] {
        [[1, 0], [0, 1]].map(|order| self.marker(element, &bicubic(local, order)).reference())
    }

    /// Returns the points r, tangents r_ξ and r_η, areas and relative thicknesses at the integration points of an element.
    pub(crate) fn flow_points(&self, element: usize) -> Vec<([Marker; 3], [f64; 2])> {
        let profile = self.elements[element].profile();
        let of = |(k, (at, weight)): (usize, ([f64; 2], f64))| {
            let markers = [[0, 0], [1, 0], [0, 1]].map(|order| self.marker(element, &bicubic(at, order)));
            let area = markers[1].reference().cross(&markers[2].reference()).norm();
            (markers, [weight * area, profile.scale(k)])
        };
        integration_points().into_iter().enumerate().map(of).collect()
    }

    /// Returns the surfaces of the elements, with marks of the edges ξ = 0 and 1, η = 0 and 1 that are edges of the patch.
    pub fn element_surfaces(&self) -> impl Iterator<Item = (ElementSurface, [[bool; 2]; 2])> + '_ {
        let [n, m] = self.divisions;
        (0..n * m).map(move |element| {
            let own = Self::vectors_of(self.divisions, element);
            let origin = |i: usize| if i.is_multiple_of(4) { self.origin } else { Vector3::zeros() };
            let surface = ElementSurface::new(
                own.map(|i| self.first + 3 * i),
                own.map(|i| self.reference[i] + origin(i)),
            );
            let (i, j) = (element % n, element / n);
            (surface, [[i == 0, i + 1 == n], [j == 0, j + 1 == m]])
        })
    }

    /// Returns the largest length of r_ξ and r_η in the middle of an element.
    pub fn largest_side(&self) -> f64 {
        let size =
            |element: usize| self.tangents(element, [0.5; 2]).iter().map(Vector3::norm).fold(0.0, f64::max);
        (0..self.elements.len()).map(size).fold(0.0, f64::max)
    }

    /// Returns the points of Simpson's rule on `cells` × `cells` cells of each element, along u first, with their reference areas and
    /// relative thicknesses.
    pub fn surface_points(&self, cells: usize) -> impl Iterator<Item = (Marker, [f64; 2])> + '_ {
        let [n, m] = self.divisions;
        (0..n * m).flat_map(move |element| {
            simpson_points(cells).map(move |(at, weight)| {
                let [t, s] = self.tangents(element, at);
                let scale = self.sections.as_ref().map_or(1.0, |field| field.at(element, at).scale);
                (self.marker(element, &bicubic(at, [0, 0])), [t.cross(&s).norm() * weight, scale])
            })
        })
    }

    /// Returns the sums Σ m x over parts of the body, one for each element.
    pub fn mass_markers(&self) -> impl Iterator<Item = Marker> + '_ {
        let of = |(k, element): (usize, &Shell48)| self.marker(k, &element.profile().first);
        self.elements.iter().enumerate().map(of)
    }

    /// Visits the elements with their nodal vectors in a state and their compact mass matrices.
    pub(crate) fn visit_masses(&self, s: &State, visit: &mut MassVisitor<'_>) {
        for (k, element) in self.elements.iter().enumerate() {
            let profile = element.profile();
            visit(&self.element_vectors(s, k), &|a, b| profile.mass(a, b));
        }
    }

    /// Returns the markers ∫ r dA over the elements, in the reference state.
    pub fn area_markers(&self) -> impl Iterator<Item = Marker> + '_ {
        let of = |(k, element): (usize, &Shell48)| self.marker(k, &element.profile().areas());
        self.elements.iter().enumerate().map(of)
    }

    /// Returns the nodes of an edge, in ascending order of u or v.
    pub fn edge_nodes(&self, edge: ShellEdge) -> Vec<usize> {
        let [n, m] = self.divisions;
        let node = |i: usize, j: usize| j * (n + 1) + i;
        match (edge.along_v, edge.at_end) {
            (true, end) => (0..=m).map(|j| node(if end { n } else { 0 }, j)).collect(),
            (false, end) => (0..=n).map(|i| node(i, if end { m } else { 0 })).collect(),
        }
    }

    /// Returns the middle of an edge as (u, v).
    pub fn edge_middle(edge: ShellEdge) -> [f64; 2] {
        let fixed = if edge.at_end { 1.0 } else { 0.0 };
        if edge.along_v { [fixed, 0.5] } else { [0.5, fixed] }
    }

    /// Returns the first coordinate and the reference value of a vector of a node.
    pub fn nodal(&self, node: usize, kind: usize) -> (usize, Vector3<f64>) {
        let i = 4 * node + kind;
        let origin = if kind == 0 { self.origin } else { Vector3::zeros() };
        (self.first + 3 * i, self.reference[i] + origin)
    }

    /// Returns the strain energy.
    pub fn strain_energy(&self, s: &State) -> f64 {
        let displacements = |element: usize| -> Vec<f64> {
            self.elements[element].coordinates().iter().map(|&c| s.q[c]).collect()
        };
        let of = |(k, element): (usize, &Shell48)| element.strain_energy(&displacements(k));
        let own: f64 = self.elements.iter().enumerate().map(of).sum();
        own + self.prestrains.strain_energy(s, displacements)
    }

    /// Returns the integration points of an edge with the lengths that they stand for, element by element.
    pub fn edge_points(&self, edge: ShellEdge) -> Vec<[([f64; 2], f64); 4]> {
        let count = self.divisions[usize::from(edge.along_v)];
        let fixed = if edge.at_end { 1.0 } else { 0.0 };
        let of = |cell: usize| {
            gauss4().map(|(x, weight)| {
                let t = (cell as f64 + x) / count as f64;
                let at = if edge.along_v { [fixed, t] } else { [t, fixed] };
                let order = if edge.along_v { [0, 1] } else { [1, 0] };
                (at, weight * self.derivative(at, order).reference().norm())
            })
        };
        (0..count).map(of).collect()
    }

    /// Returns the range of the coordinates.
    pub fn range(&self) -> Range<usize> {
        self.first..self.first + self.coordinates()
    }

    /// Returns the first element whose reference surface is degenerate: r_ξ and r_η nearly parallel or zero.
    pub fn degenerate(&self) -> Option<[f64; 2]> {
        let k = self.elements.iter().position(|e| {
            e.profile().least_angle().partial_cmp(&1e-3) != Some(std::cmp::Ordering::Greater)
        })?;
        let [n, m] = self.divisions;
        Some([((k % n) as f64 + 0.5) / n as f64, ((k / n) as f64 + 0.5) / m as f64])
    }
}
