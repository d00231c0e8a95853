use std::fmt;
use std::sync::Arc;

use ancf_solver::equations::{State, Term};
use nalgebra::{Matrix3, Vector3};

use super::mesh_element::{ElementList, VectorWeights};
use crate::elements::{
    Beam24, Beam27, BeamMaterial, Cable12, CableDamping, CableProfile, CableRule, CableSection, Prestrains,
    Profile, TwoNodeLaw,
};
use crate::kinematics::{BeamShape, NodalVector, QuadraticShape, ReferenceNode, VectorKind};
use crate::sections::{CrossSection, DeformationFactors, Lame};

/// Stress-strain law at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StressLaw {
    /// Three-dimensional St. Venant-Kirchhoff law.
    Continuum,
    NeoHookean,
    /// Rod law of [`SectionLaw::enhanced`](crate::sections::SectionLaw::enhanced), with or without linked strains.
    Rod {
        linked: bool,
    },
    /// Uniaxial law of a line.
    Line,
}

/// Mesh of the nodes and elements of a beam or cable.
///
/// The coordinates of the nodal vectors are consecutive from `first`. The vectors of a node are (r, ℓ r_x, ℓ r_y, ℓ
/// r_z) for two-node beam elements, (r, ℓ r_y, ℓ r_z) for three-node beam elements, and (r, ℓ r_x) for cables.
#[derive(Clone, Debug)]
pub struct BeamMesh {
    pub(crate) first: usize,
    /// Length l of each element.
    pub(crate) length: f64,
    pub(crate) slope: f64,
    pub(crate) elements: Arc<dyn ElementList>,
    /// Origin of the reference positions.
    pub(crate) origin: Vector3<f64>,
    /// Reference values of the vectors.
    pub(crate) reference: Vec<Vector3<f64>>,
    pub(crate) lame: Lame,
    pub(super) retardation: DeformationFactors,
    pub(crate) elasticity: StressLaw,
    /// Direction of the y-axis of the first node in the reference state.
    pub(crate) up: Vector3<f64>,
    /// Weight w_y of the section frame at the ends of the elements; ½ if empty.
    pub(super) frame_weights: Vec<f64>,
    /// Prescribed strains.
    pub(super) prestrains: Prestrains,
}

/// Common data of all elements of a mesh.
pub struct MeshParameters<'a> {
    /// First coordinate.
    pub first: usize,
    /// Origin of the positions of the nodes.
    pub origin: Vector3<f64>,
    /// Length of one element.
    pub length: f64,
    /// Slope length ℓ.
    pub slope: f64,
    /// Material, damping and gravity.
    pub medium: &'a BeamMaterial,
    /// Section at an arc length.
    pub section: &'a dyn Fn(f64) -> CrossSection,
    /// True if the section is constant along the beam.
    pub prismatic: bool,
}

impl MeshParameters<'_> {
    /// Returns I_y/(I_y + I_z) of the sections at the nodes, I_y = ∫ y² dA.
    fn frame_weights(&self, nodes: usize) -> Vec<f64> {
        let weight = |k: usize| {
            let moments = (self.section)(k as f64 * self.length).moments;
            moments.yy / (moments.yy + moments.zz)
        };
        if self.prismatic { vec![weight(0); nodes] } else { (0..nodes).map(weight).collect() }
    }
}

impl fmt::Debug for MeshParameters<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("MeshParameters")
            .field("first", &self.first)
            .field("length", &self.length)
            .finish_non_exhaustive()
    }
}

impl BeamMesh {
    /// Creates the mesh of elements with their reference vectors, whose section frames have equal weights, without prescribed strains.
    fn new(
        parameters: &MeshParameters<'_>,
        nodes: &[ReferenceNode],
        reference: Vec<Vector3<f64>>,
        elements: Arc<dyn ElementList>,
        elasticity: StressLaw,
    ) -> Self {
        Self {
            first: parameters.first,
            length: parameters.length,
            slope: parameters.slope,
            elements,
            origin: parameters.origin,
            reference,
            lame: parameters.medium.lame,
            retardation: parameters.medium.retardation,
            elasticity,
            up: nodes[0].frame[1],
            frame_weights: Vec::new(),
            prestrains: Prestrains::default(),
        }
    }

    /// Creates two-node elements between consecutive nodes.
    pub fn two_node(
        parameters: &MeshParameters<'_>,
        nodes: &[ReferenceNode],
        formulation: TwoNodeLaw,
    ) -> Self {
        let MeshParameters { first, length, slope, .. } = *parameters;
        let shape = BeamShape { length, slope };
        let reference = nodes.iter().flat_map(|ReferenceNode { position, frame: [x, y, z] }| {
            [*position, x * slope, y * slope, z * slope]
        });
        let reference: Vec<_> = reference.collect();
        let elements = elements(parameters, nodes, 1, &reference, 4, |local, section| {
            Profile::two_node(shape, local, section, parameters.medium, formulation)
        });
        let elements = elements.into_iter().enumerate().map(|(k, (frame, profile))| {
            let first = first + 12 * k;
            Beam24::new(first..first + 24, frame, profile)
        });
        let elasticity = match formulation {
            TwoNodeLaw::Continuum if parameters.medium.neo_hookean => StressLaw::NeoHookean,
            TwoNodeLaw::Continuum => StressLaw::Continuum,
            TwoNodeLaw::Enhanced => StressLaw::Rod { linked: false },
            TwoNodeLaw::Linked => StressLaw::Rod { linked: true },
        };
        let elements = Arc::new(elements.collect::<Vec<_>>());
        let frame_weights = match formulation {
            TwoNodeLaw::Continuum => parameters.frame_weights(nodes.len()),
            TwoNodeLaw::Enhanced | TwoNodeLaw::Linked => Vec::new(),
        };
        Self { frame_weights, ..Self::new(parameters, nodes, reference, elements, elasticity) }
    }

    /// Creates three-node elements on nodes 0 1 2, 2 3 4, and so on.
    pub fn three_node(parameters: &MeshParameters<'_>, nodes: &[ReferenceNode]) -> Self {
        let MeshParameters { first, length, slope, .. } = *parameters;
        let shape = QuadraticShape { length, slope };
        let reference = nodes
            .iter()
            .flat_map(|ReferenceNode { position, frame: [_, y, z] }| [*position, y * slope, z * slope]);
        let reference: Vec<_> = reference.collect();
        let elements = elements(parameters, nodes, 2, &reference, 3, |local, section| {
            Profile::three_node(shape, local, section, parameters.medium)
        });
        let elements = elements.into_iter().enumerate().map(|(k, (frame, profile))| {
            let first = first + 18 * k;
            Beam27::new(first..first + 27, frame, profile)
        });
        let elements = Arc::new(elements.collect::<Vec<_>>());
        let elasticity = StressLaw::Rod { linked: false };
        Self::new(parameters, nodes, reference, elements, elasticity)
    }

    /// Creates cable elements between consecutive nodes of a straight line, integrated by [`CableRule::Lobatto`].
    pub fn cable(parameters: &MeshParameters<'_>, nodes: &[ReferenceNode]) -> Self {
        let MeshParameters { first, length, slope, medium, section, .. } = *parameters;
        let BeamMaterial { lame, density, retardation, mass_damping, gravity, .. } = *medium;
        let (young, moments) = (lame.young(), section(0.0).moments);
        let section = CableSection {
            axial: young * moments.area,
            bending: young * moments.yy,
            line_density: density * moments.area,
        };
        let profile = CableProfile::new(BeamShape { length, slope }, section, gravity)
            .with_damping(CableDamping {
                stretch: retardation.stretch,
                bending: retardation.bending,
                mass: mass_damping,
            })
            .with_rule(CableRule::Lobatto);
        let profile = Arc::new(profile);
        let reference = nodes
            .iter()
            .flat_map(|ReferenceNode { position, frame }| [*position, frame[0] * slope])
            .collect();
        let elements = nodes[1..].iter().enumerate().map(|(k, node)| {
            let first = first + 6 * k;
            Cable12::new(std::array::from_fn(|i| first + i), node.frame[0], Arc::clone(&profile))
        });
        let elements = Arc::new(elements.collect::<Vec<_>>());
        Self::new(parameters, nodes, reference, elements, StressLaw::Line)
    }

    /// Returns true if the body has cross-sections with the directions r_y and r_z. Cables have none.
    pub fn has_sections(&self) -> bool {
        self.node_kinds().contains(&VectorKind::Y)
    }

    /// Returns true if the elements have a middle node.
    pub(super) fn has_middle_nodes(&self) -> bool {
        self.stride() > self.node_kinds().len()
    }

    /// Returns the number of coordinates.
    pub fn coordinates(&self) -> usize {
        3 * self.reference.len()
    }

    /// Returns the first coordinate.
    pub fn first_coordinate(&self) -> usize {
        self.first
    }

    /// Returns the number of elements.
    pub fn count(&self) -> usize {
        self.elements.count()
    }

    /// Returns the length of the axis.
    pub fn length(&self) -> f64 {
        self.length * self.count() as f64
    }

    /// Returns the length of an element.
    pub fn element_length(&self) -> f64 {
        self.length
    }

    /// Returns the first coordinate of an element.
    pub fn first_coordinate_of(&self, element: usize) -> usize {
        self.first + 3 * self.stride() * element
    }

    pub(crate) fn term(&self, element: usize) -> &dyn Term {
        self.elements.term(element)
    }

    /// Returns the kinds of the vectors of a node.
    pub(crate) fn node_kinds(&self) -> &'static [VectorKind] {
        self.elements.node()
    }

    /// Returns all nodal vectors in a state, in the order of the coordinates.
    pub fn vectors<'a>(&'a self, s: &'a State) -> impl Iterator<Item = NodalVector> + 'a {
        let kinds = self.node_kinds();
        self.reference.iter().enumerate().map(move |(i, &reference)| {
            let (first, kind) = (self.first + 3 * i, kinds[i % kinds.len()]);
            let reference = if kind == VectorKind::Position { reference + self.origin } else { reference };
            NodalVector { first, kind, value: reference + Vector3::from_column_slice(&s.q[first..first + 3]) }
        })
    }

    /// Returns the value of a vector in a state.
    pub(super) fn vector(&self, state: &State, vector: usize) -> Vector3<f64> {
        self.reference[vector] + self.displacement(state, vector)
    }

    /// Returns the displacement of a vector.
    pub(super) fn displacement(&self, state: &State, vector: usize) -> Vector3<f64> {
        self.part(&state.q, vector)
    }

    /// Returns the part of a vector in the coordinates or velocities.
    pub(super) fn part(&self, coordinates: &[f64], vector: usize) -> Vector3<f64> {
        let first = self.first + 3 * vector;
        Vector3::from_column_slice(&coordinates[first..first + 3])
    }

    /// Returns the node and the kind of vector to which a coordinate of this mesh belongs.
    pub fn locate_coordinate(&self, coordinate: usize) -> Option<(usize, VectorKind)> {
        let (vector, kinds) = (coordinate.checked_sub(self.first)? / 3, self.node_kinds());
        (vector < self.reference.len()).then(|| (vector / kinds.len(), kinds[vector % kinds.len()]))
    }

    /// Returns the weights of the vectors of an element at ξ: in r, r_y or r_z, and in the directors.
    pub(crate) fn weights(&self, xi: f64) -> Vec<VectorWeights> {
        self.elements.weights(self.length, self.slope, xi)
    }

    /// Returns the number of vectors between the starts of consecutive elements.
    pub(crate) fn stride(&self) -> usize {
        self.elements.stride()
    }

    /// Returns the element and ξ of an arc length. At a node, ξ is exactly 0 or 1.
    pub fn locate(&self, s: f64) -> (usize, f64) {
        let at = s / self.length;
        let node = at.round();
        let at = if (at - node).abs() < 1e-9 { node } else { at };
        let element = (at.floor().max(0.0) as usize).min(self.count() - 1);
        (element, (at - element as f64).clamp(0.0, 1.0))
    }
}

/// Creates frame and profile of each element. Consecutive congruent elements share a profile.
fn elements<const N: usize>(
    parameters: &MeshParameters<'_>,
    nodes: &[ReferenceNode],
    span: usize,
    reference: &[Vector3<f64>],
    stride: usize,
    profile: impl Fn(&[Vector3<f64>; N], &dyn Fn(f64) -> CrossSection) -> Profile<N>,
) -> Vec<([Vector3<f64>; 3], Arc<Profile<N>>)> {
    let mut last: Option<([Vector3<f64>; N], Arc<Profile<N>>)> = None;
    let of = |k: usize| {
        let frame = nodes[k * span].frame;
        let to_local = Matrix3::from_columns(&frame).transpose();
        let origin = nodes[k * span].position;
        let local: [Vector3<f64>; N] = std::array::from_fn(|i| {
            let shift = if i % stride == 0 { origin } else { Vector3::zeros() };
            to_local * (reference[k * span * stride + i] - shift)
        });
        // Far from the origin, differences of positions have this rounding error.
        let rounding = 8.0 * f64::EPSILON * (origin - nodes[0].position).norm();
        let congruent = |(known, _): &&([Vector3<f64>; N], Arc<Profile<N>>)| {
            let near = |(i, (x, y)): (usize, (&Vector3<f64>, &Vector3<f64>))| {
                let size = if i % stride == 0 { parameters.length } else { parameters.slope };
                (x - y).amax() <= 1e-12 * size + rounding
            };
            parameters.prismatic && known.iter().zip(&local).enumerate().all(near)
        };
        if let Some((_, profile)) = last.as_ref().filter(congruent) {
            return (frame, Arc::clone(profile));
        }
        let section = |xi: f64| (parameters.section)((k as f64 + xi) * parameters.length);
        let profile = Arc::new(profile(&local, &section));
        last = Some((local, Arc::clone(&profile)));
        (frame, profile)
    };
    (0..(nodes.len() - 1) / span).map(of).collect()
}
