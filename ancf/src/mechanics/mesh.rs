use std::fmt;
use std::sync::Arc;

use nalgebra::{Matrix3, Vector3};

use super::{
    Beam24, Beam27, BeamShape, CrossSection, Formulation, Interpolation, Kind, Marker, Medium, Node, Profile,
    QuadraticShape, Wrench,
};
use crate::system::{LOCAL, Local, State, Term};

/// The elements of a body, all of one kind.
#[derive(Clone, Debug)]
enum Elements {
    Two(Vec<Beam24>),
    Three(Vec<Beam27>),
}

/// The nodes and elements of a beam.
///
/// The coordinates of its vectors follow each other from `first` on: (r, ℓ r_x, ℓ r_y, ℓ r_z) for each node of a two-node
/// element, (r, ℓ r_y, ℓ r_z) for each of a three-node one.
#[derive(Clone, Debug)]
pub struct BeamMesh {
    first: usize,
    /// Length l of each element.
    length: f64,
    slope: f64,
    elements: Elements,
    /// The point from which reference positions count.
    origin: Vector3<f64>,
    /// Reference values of the vectors.
    reference: Vec<Vector3<f64>>,
}

/// A vector of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshVector {
    /// Its first coordinate.
    pub first: usize,
    /// What it is.
    pub kind: Kind,
    /// Its reference value; slopes times ℓ.
    pub reference: Vector3<f64>,
}

/// What all elements of a mesh have in common.
pub struct Blueprint<'a> {
    /// First coordinate.
    pub first: usize,
    /// The point from which the positions of the nodes count.
    pub origin: Vector3<f64>,
    /// Length of one element.
    pub length: f64,
    /// Slope length ℓ.
    pub slope: f64,
    /// Material, damping and gravity.
    pub medium: &'a Medium,
    /// The section at an arc length.
    pub section: &'a dyn Fn(f64) -> CrossSection,
    /// Whether the section is the same everywhere.
    pub prismatic: bool,
}

impl fmt::Debug for Blueprint<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Blueprint")
            .field("first", &self.first)
            .field("length", &self.length)
            .finish_non_exhaustive()
    }
}

impl BeamMesh {
    /// Two-node elements between consecutive nodes.
    pub fn two_node(blueprint: &Blueprint<'_>, nodes: &[Node], formulation: Formulation) -> Self {
        let Blueprint { first, origin, length, slope, .. } = *blueprint;
        let shape = BeamShape { length, slope };
        let reference = nodes
            .iter()
            .flat_map(|Node { position, frame: [x, y, z] }| [*position, x * slope, y * slope, z * slope]);
        let reference: Vec<_> = reference.collect();
        let elements = elements(blueprint, nodes, 1, &reference, 4, |local, section| {
            Profile::two_node(shape, local, section, blueprint.medium, formulation)
        });
        let elements = elements.into_iter().enumerate().map(|(k, (frame, profile))| {
            let first = first + 12 * k;
            Beam24::new(first..first + 24, frame, profile)
        });
        Self { first, length, slope, elements: Elements::Two(elements.collect()), origin, reference }
    }

    /// Three-node elements on nodes 0 1 2, 2 3 4, and so on.
    pub fn three_node(blueprint: &Blueprint<'_>, nodes: &[Node]) -> Self {
        let Blueprint { first, origin, length, slope, .. } = *blueprint;
        let shape = QuadraticShape { length, slope };
        let reference =
            nodes.iter().flat_map(|Node { position, frame: [_, y, z] }| [*position, y * slope, z * slope]);
        let reference: Vec<_> = reference.collect();
        let elements = elements(blueprint, nodes, 2, &reference, 3, |local, section| {
            Profile::three_node(shape, local, section, blueprint.medium)
        });
        let elements = elements.into_iter().enumerate().map(|(k, (frame, profile))| {
            let first = first + 18 * k;
            Beam27::new(first..first + 27, frame, profile)
        });
        Self { first, length, slope, elements: Elements::Three(elements.collect()), origin, reference }
    }

    /// Number of coordinates.
    pub fn coordinates(&self) -> usize {
        3 * self.reference.len()
    }

    /// Number of elements.
    pub fn count(&self) -> usize {
        match &self.elements {
            Elements::Two(elements) => elements.len(),
            Elements::Three(elements) => elements.len(),
        }
    }

    /// Length of the axis.
    pub fn length(&self) -> f64 {
        self.length * self.count() as f64
    }

    /// The elements as terms.
    pub fn terms(&self) -> Vec<Box<dyn Term>> {
        match &self.elements {
            Elements::Two(elements) => {
                elements.iter().map(|e| Box::new(e.clone()) as Box<dyn Term>).collect()
            }
            Elements::Three(elements) => {
                elements.iter().map(|e| Box::new(e.clone()) as Box<dyn Term>).collect()
            }
        }
    }

    fn term(&self, element: usize) -> &dyn Term {
        match &self.elements {
            Elements::Two(elements) => &elements[element],
            Elements::Three(elements) => &elements[element],
        }
    }

    /// Kinds of the vectors of a node.
    fn node_kinds(&self) -> &'static [Kind] {
        match self.elements {
            Elements::Two(_) => &[Kind::Position, Kind::Slope, Kind::Y, Kind::Z],
            Elements::Three(_) => &[Kind::Position, Kind::Y, Kind::Z],
        }
    }

    /// Its vectors in the order of their coordinates.
    pub fn vectors(&self) -> impl Iterator<Item = MeshVector> + '_ {
        let kinds = self.node_kinds();
        self.reference.iter().enumerate().map(move |(i, &reference)| MeshVector {
            first: self.first + 3 * i,
            kind: kinds[i % kinds.len()],
            reference: if i % kinds.len() == 0 { reference + self.origin } else { reference },
        })
    }

    /// The node and the vector that a coordinate belongs to, if it is one of this mesh.
    pub fn place_of(&self, coordinate: usize) -> Option<(usize, Kind)> {
        let (vector, kinds) = (coordinate.checked_sub(self.first)? / 3, self.node_kinds());
        (vector < self.reference.len()).then(|| (vector / kinds.len(), kinds[vector % kinds.len()]))
    }

    /// The directors r_x, r_y and r_z at an arc length in the reference state.
    pub fn reference_axes(&self, s: f64) -> [Vector3<f64>; 3] {
        self.axes(s).map(|axis| axis.reference())
    }

    /// Weights of an element's vectors at ξ: in r, r_y or r_z, and in the directors that each enters.
    fn weights(&self, xi: f64) -> Vec<(Kind, f64, [f64; 3])> {
        fn of<const N: usize, S: Interpolation<N>>(shape: &S, xi: f64) -> Vec<(Kind, f64, [f64; 3])> {
            let (values, directors) = (shape.values(xi), shape.directors(xi));
            (0..N).map(|i| (S::KINDS[i], values[i], directors[i])).collect()
        }
        let (length, slope) = (self.length, self.slope);
        match self.elements {
            Elements::Two(_) => of(&BeamShape { length, slope }, xi),
            Elements::Three(_) => of(&QuadraticShape { length, slope }, xi),
        }
    }

    /// The point of the axis at an arc length.
    pub fn point(&self, s: f64) -> Marker {
        self.material_point(s, 0.0, 0.0)
    }

    /// The point of the body at an arc length and (y, z) in its section.
    pub fn material_point(&self, s: f64, y: f64, z: f64) -> Marker {
        self.marker(s, |kind, value, _| match kind {
            Kind::Position | Kind::Slope => value,
            Kind::Y => y * value,
            Kind::Z => z * value,
        })
    }

    /// The direction of the body at an arc length that is `direction` in the reference state: J d with J = [r_x r_y r_z].
    pub fn direction(&self, s: f64, direction: Vector3<f64>) -> Marker {
        let [a, d, e] = self.axes(s).map(|axis| axis.reference());
        let inverse = Matrix3::from_columns(&[a, d, e]).try_inverse().unwrap_or_else(Matrix3::zeros);
        let [x, y, z]: [f64; 3] = (inverse * direction).map(clean).into();
        self.marker(s, |kind, value, directors| match kind {
            Kind::Position | Kind::Slope => x * directors[0],
            Kind::Y => y * value,
            Kind::Z => z * value,
        })
    }

    /// The directors r_x, r_y and r_z at an arc length.
    pub fn axes(&self, s: f64) -> [Marker; 3] {
        [0, 1, 2].map(|axis| {
            self.marker(s, |kind, value, directors| match (kind, axis) {
                (Kind::Position | Kind::Slope, 0) => directors[0],
                (Kind::Y, 1) | (Kind::Z, 2) => value,
                _ => 0.0,
            })
        })
    }

    fn marker(&self, s: f64, weight: impl Fn(Kind, f64, [f64; 3]) -> f64) -> Marker {
        let (element, xi) = self.locate(s);
        let offset = element * self.stride();
        let of = self.weights(xi);
        let weights: Vec<f64> =
            of.iter().map(|&(kind, value, directors)| weight(kind, value, directors)).collect();
        // The weights of positions sum to one in a point and to zero in a direction.
        let positions = weights.iter().zip(&of).filter(|(_, (kind, ..))| *kind == Kind::Position);
        let origin = self.origin * clean(positions.map(|(weight, _)| weight).sum());
        let vectors = &self.reference[offset..offset + weights.len()];
        let reference =
            weights.iter().zip(vectors).map(|(weight, vector)| vector * *weight).sum::<Vector3<f64>>()
                + origin;
        let parts = weights.iter().enumerate().map(|(i, &w)| (self.first + 3 * (offset + i), w));
        Marker::new(parts, reference)
    }

    /// Vectors from the start of one element to that of the next.
    fn stride(&self) -> usize {
        match self.elements {
            Elements::Two(_) => 4,
            Elements::Three(_) => 6,
        }
    }

    /// Element and ξ of an arc length; a node belongs to one of its elements at exactly ξ = 0 or 1.
    fn locate(&self, s: f64) -> (usize, f64) {
        let at = s / self.length;
        let node = at.round();
        let at = if (at - node).abs() < 1e-9 { node } else { at };
        let element = (at.floor().max(0.0) as usize).min(self.count() - 1);
        (element, (at - element as f64).clamp(0.0, 1.0))
    }
}

/// Frame and profile of each element; congruent neighbours share their profile.
fn elements<const N: usize>(
    blueprint: &Blueprint<'_>,
    nodes: &[Node],
    span: usize,
    reference: &[Vector3<f64>],
    stride: usize,
    profile: impl Fn(&[Vector3<f64>; N], &dyn Fn(f64) -> CrossSection) -> Profile<N>,
) -> Vec<([Vector3<f64>; 3], Arc<Profile<N>>)> {
    let mut last: Option<([Vector3<f64>; N], Arc<Profile<N>>)> = None;
    let count = (nodes.len() - 1) / span;
    let of = |k: usize| {
        let frame = nodes[k * span].frame;
        let to_local = Matrix3::from_columns(&frame).transpose();
        let origin = nodes[k * span].position;
        let local: [Vector3<f64>; N] = std::array::from_fn(|i| {
            let vector = reference[k * span * stride + i];
            to_local * if i % stride == 0 { vector - origin } else { vector }
        });
        let congruent = |(known, _): &&([Vector3<f64>; N], Arc<Profile<N>>)| {
            let near = |(i, (x, y)): (usize, (&Vector3<f64>, &Vector3<f64>))| {
                let size = if i % stride == 0 { blueprint.length } else { blueprint.slope };
                (x - y).amax() <= 1e-12 * size
            };
            blueprint.prismatic && known.iter().zip(&local).enumerate().all(near)
        };
        let shared = last.as_ref().filter(congruent).map(|(_, profile)| Arc::clone(profile));
        let profile = shared.unwrap_or_else(|| {
            let section = |xi: f64| (blueprint.section)((k as f64 + xi) * blueprint.length);
            Arc::new(profile(&local, &section))
        });
        last = Some((local, Arc::clone(&profile)));
        (frame, profile)
    };
    (0..count).map(of).collect()
}

/// Numbers that are zero but for rounding, such as components along a frame's own directions, are zero.
fn clean(component: f64) -> f64 {
    if component.abs() < 1e-14 { 0.0 } else { component }
}

impl BeamMesh {
    /// What is transmitted through the section at an arc length: force, and moment about the section's centre, that the
    /// part beyond (greater arc length) exerts on the part before, in the global frame. Resolved in
    /// [`section_frame`](Self::section_frame), a positive first component is tension.
    ///
    /// At nodes these are the forces that hold an element in equilibrium with its own inertia, body force and
    /// damping: exact where an element has no other loads, whatever the mesh. Between the nodes of an element they are
    /// interpolated linearly.
    pub fn resultants(&self, state: &State, s: f64) -> Wrench {
        let (element, xi) = self.locate(s);
        let [start, end] = self.ends(state, element);
        Wrench {
            force: end.force * xi - start.force * (1.0 - xi),
            moment: end.moment * xi - start.moment * (1.0 - xi),
        }
    }

    /// Forces and moments that hold the two ends of an element.
    fn ends(&self, state: &State, element: usize) -> [Wrench; 2] {
        let term = self.term(element);
        let coordinates = term.coordinates();
        let n = coordinates.len();
        let mut local = [[0.0; LOCAL]; 4];
        for (i, &c) in coordinates.iter().enumerate() {
            local[0][i] = state.q[c];
            local[1][i] = state.v[c];
            local[2][i] = state.a[c];
        }
        let [q, v, a, mut r] = local;
        let at = Local { q: &q[..n], v: &v[..n], a: &a[..n], lambda: &[], t: state.t, load: state.load };
        term.residual(&at, &mut r[..n]);
        let kinds = self.node_kinds();
        let last = n / 3 - kinds.len();
        let offset = element * self.stride();
        [0, last].map(|first| {
            let mut wrench = Wrench::default();
            for (i, kind) in kinds.iter().enumerate() {
                let place = first + i;
                let force = Vector3::from_column_slice(&r[3 * place..3 * place + 3]);
                if *kind == Kind::Position {
                    wrench.force += force;
                } else {
                    let vector = self.reference[offset + place]
                        + Vector3::from_column_slice(&q[3 * place..3 * place + 3]);
                    wrench.moment += vector.cross(&force);
                }
            }
            wrench
        })
    }

    /// The directors of an orthonormal section frame at an arc length: its normal, and y and z as near to r_y and r_z as
    /// they can be.
    pub fn section_frame(&self, state: &State, s: f64) -> [Vector3<f64>; 3] {
        let [_, d, e] = self.axes(s).map(|axis| axis.value(state));
        let normal = d.cross(&e).normalize();
        let y = (d.normalize() + e.cross(&normal).normalize()).normalize();
        [normal, y, normal.cross(&y)]
    }
}
