use ancf_mechanics::shells::{
    Face, MeshTopology, NearestPoint, SurfacePlace, TopologyDefect, directors, stress_axis,
};
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::element_mesh::ElementMesh;
use super::element_nodes::ElementNodes;
use super::fields::{
    FibreAngle, FibreAxis, FieldPlace, FieldPoint, FieldShell, GivenFields, ShellThickness, is_parallel,
};
use super::layer::Layer;
use super::layup::Layup;
use super::membrane::Membrane;
use crate::errors::number;
use crate::model::bodies::parts::{At, EdgeName, EdgePlace, InitialMotion, NodePlace, PointPlace};
use crate::units::Scaled;

/// Largest angle of the normals of neighbouring elements by default, in radians: 40 degrees.
const CREASE: f64 = 0.7;
/// Distance of the middle of an edge from a node, relative to the element edge, below which it is the node.
const AT_NODE: f64 = 1e-9;
/// Largest distance of a point from the middle surface, relative to the size of the mesh.
const ON_SURFACE: f64 = 1e-6;
/// Cosine of the angle from the normal of a plane above which a direction is not in the plane.
const IN_PLANE: f64 = 1e-6;

/// Shell or plate with transverse shear, on any mesh of quadrilaterals and triangles.
///
/// Each node has the position r and the director d.
///
/// Source: Yamashita, Valkeapää, Jayakumar & Sugiyama (2015); Lee & Bathe (2004) for triangles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct ShearShell {
    /// Name of the shell in joints, loads and probes.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Mesh of the middle surface in the reference state, which is free of stress.
    pub mesh: ElementMesh,
    /// Largest angle of the normals of neighbouring elements, in radians. Larger ones are kinks, which are rejected; 0.7 by default.
    #[unit(radian)]
    #[serde(default = "crease", skip_serializing_if = "is_crease")]
    #[schemars(extend("exclusiveMinimum" = 0, "exclusiveMaximum" = 1.5))]
    pub crease: f64,
    /// Thickness, length: a number or a field.
    pub thickness: ShellThickness,
    /// Name of the material, a key of `materials`.
    pub material: String,
    /// Layers from the lower to the upper side in the direction of the normal; by default a single one.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub layers: Vec<Layer>,
    /// Axis whose projection on the surface is the first direction of stresses and the fibre angle zero; required with orthotropic materials.
    /// A field is that of the fibre angle zero only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fibre_axis: Option<FibreAxis>,
    /// Angle about the normal by which all fibres are turned, in radians: a number or a field; 0 by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fibre_angle: Option<FibreAngle>,
    /// Law of the membrane forces; the linear one by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub membrane: Option<Membrane>,
    /// Initial velocities in dynamics; at rest by default.
    #[serde(default, skip_serializing_if = "InitialMotion::is_rest")]
    pub motion: InitialMotion,
}

const fn crease() -> f64 {
    CREASE
}

fn is_crease(angle: &f64) -> bool {
    *angle == CREASE
}

impl ShearShell {
    /// Thickness, material and layers.
    pub fn layup(&self) -> Layup<'_> {
        let (thickness, varies) = (self.thickness_range().mean, self.has_varying_thickness());
        Layup { thickness, varies, material: &self.material, layers: &self.layers }
    }

    /// Nodes.
    pub fn points(&self) -> Vec<Vector3<f64>> {
        self.mesh.nodes.iter().map(|node| Vector3::from(*node)).collect()
    }

    /// Nodes of the elements.
    pub fn faces(&self) -> Vec<Face> {
        self.mesh.elements.iter().map(ElementNodes::face).collect()
    }

    /// Unit directors of the nodes of a valid mesh: the given ones, or those of the normals.
    pub(crate) fn unit_directors(&self) -> Vec<Vector3<f64>> {
        if self.mesh.directors.is_empty() {
            return directors(&self.points(), &self.faces());
        }
        self.mesh.directors.iter().map(|director| Vector3::from(*director).normalize()).collect()
    }

    /// Description of a node and its place.
    pub(crate) fn describe_node(&self, node: usize) -> String {
        let [x, y, z] = self.mesh.nodes[node].map(number);
        format!("node {node} at ({x}, {y}, {z})")
    }

    /// Description of a place at which the normal or the director has the direction of an axis.
    pub(crate) fn normal_along(&self, axis: [f64; 3]) -> Option<String> {
        let (points, directors) = (self.points(), self.unit_directors());
        let normals = self.faces().into_iter().map(|face| (face.nodes()[0], face.normal(&points)));
        let mut all = directors.iter().copied().enumerate().chain(normals);
        let (node, _) = all.find(|(_, normal)| is_parallel(normal, &axis))?;
        Some(format!("the normal of the surface near {}", self.describe_node(node)))
    }

    /// Axis whose projection on the surface is the first direction of stresses, and of a section that does not vary.
    pub(crate) fn axis(&self, directors: &[Vector3<f64>]) -> Vector3<f64> {
        let automatic = || {
            let points = self.points();
            let normals = self.faces().into_iter().map(|face| face.normal(&points));
            stress_axis(&directors.iter().copied().chain(normals).collect::<Vec<_>>())
        };
        let given = self.fibre_axis.as_ref().and_then(FibreAxis::uniform);
        given.map_or_else(automatic, |axis| Vector3::from(axis).normalize())
    }

    /// Topology of a mesh whose elements have existing nodes.
    pub(crate) fn topology(&self) -> MeshTopology {
        MeshTopology::new(self.mesh.nodes.len(), &self.faces())
    }

    /// Chains of nodes of a named edge.
    pub fn edge(&self, edge: &EdgeName) -> Option<&[Vec<u32>]> {
        // Groups may have the names of the edges of thin shells.
        let group = self.mesh.groups.get(edge.name())?;
        (!group.edges.is_empty()).then_some(&group.edges)
    }

    /// Nodes of a named edge without repetition, in order.
    pub fn edge_nodes(&self, edge: &EdgeName) -> Vec<usize> {
        let mut nodes = Vec::new();
        for &node in self.edge(edge).into_iter().flatten().flatten() {
            if !nodes.contains(&(node as usize)) {
                nodes.push(node as usize);
            }
        }
        nodes
    }

    /// Pairs of nodes of the element edges of a named edge.
    pub(crate) fn edge_segments(&self, edge: &EdgeName) -> Vec<[usize; 2]> {
        let chains = self.edge(edge).into_iter().flatten();
        let segments =
            chains.flat_map(|chain| chain.windows(2).map(|pair| [pair[0] as usize, pair[1] as usize]));
        segments.filter(|segment| segment.iter().all(|node| *node < self.mesh.nodes.len())).collect()
    }

    /// Elements of a named region; all elements without a name.
    pub fn region(&self, region: Option<&str>) -> Option<Vec<usize>> {
        let Some(name) = region else { return Some((0..self.mesh.elements.len()).collect()) };
        let group = self.mesh.groups.get(name)?;
        (!group.elements.is_empty()).then(|| group.elements.iter().map(|k| *k as usize).collect())
    }

    /// True if the nodes of all elements exist.
    fn has_nodes(&self) -> bool {
        self.mesh
            .elements
            .iter()
            .flat_map(ElementNodes::nodes)
            .all(|node| (*node as usize) < self.mesh.nodes.len())
    }

    /// First defect of the mesh.
    pub(crate) fn defect(&self) -> Option<TopologyDefect> {
        MeshTopology::defect(&self.points(), &self.faces(), self.crease)
    }

    /// Node of a position at a node.
    pub(crate) fn node(&self, at: &At) -> Option<usize> {
        match at {
            At::Node(NodePlace { node }) => Some(*node as usize).filter(|node| *node < self.mesh.nodes.len()),
            At::NamedPoint(PointPlace { point }) => match &self.mesh.groups.get(point)?.nodes[..] {
                [node] => Some(*node as usize).filter(|node| *node < self.mesh.nodes.len()),
                _ => None,
            },
            _ => None,
        }
    }

    /// Middle by length of the first line of a named edge, which may be between two nodes.
    fn edge_middle(&self, edge: &EdgeName) -> Option<SurfacePlace> {
        let line = self.edge(edge)?.first()?;
        let segments: Vec<[usize; 2]> =
            line.windows(2).map(|pair| [pair[0] as usize, pair[1] as usize]).collect();
        let node = |k: usize| self.mesh.nodes.get(k).map(|node| Vector3::from(*node));
        let length = |[a, b]: [usize; 2]| Some((node(b)? - node(a)?).norm());
        let lengths: Vec<f64> = segments.iter().map(|segment| length(*segment)).collect::<Option<_>>()?;
        let (mut left, mut k) = (0.5 * lengths.iter().sum::<f64>(), 0);
        while k + 1 < segments.len() && left > lengths[k] * (1.0 + AT_NODE) {
            left -= lengths[k];
            k += 1;
        }
        let [from, to] = *segments.get(k)?;
        let share = match left / lengths[k] {
            share if share > 1.0 - AT_NODE => 1.0,
            share if share > AT_NODE => share,
            _ => 0.0,
        };
        let ends = |element: &ElementNodes| {
            let face = element.face();
            Some([face.place_of(from)?, face.place_of(to)?])
        };
        let found = self.mesh.elements.iter().enumerate().find_map(|(k, element)| Some((k, ends(element)?)));
        let (element, [a, b]) = found?;
        Some(SurfacePlace { element, at: [0, 1].map(|i| a[i] + share * (b[i] - a[i])) })
    }

    /// Place of a position on the mesh: of a node, of a point of the middle surface, or of the middle of an edge.
    ///
    /// `None` if elements have nodes that do not exist.
    pub fn place(&self, at: &At) -> Option<SurfacePlace> {
        if !self.has_nodes() {
            return None;
        }
        if let At::Point(point) = at {
            let nearest = self.nearest(point)?;
            return (nearest.distance <= self.tolerance()).then_some(nearest.place);
        }
        if let At::Edge(EdgePlace { edge }) = at {
            return self.edge_middle(edge);
        }
        let node = self.node(at)?;
        let places = self.mesh.elements.iter().map(|element| element.face().place_of(node));
        let (element, at) = places.enumerate().find_map(|(k, at)| at.map(|at| (k, at)))?;
        Some(SurfacePlace { element, at })
    }

    /// Unit normal of the plane of an edge that contains its nodes and their directors, as a plane of symmetry does.
    pub(crate) fn plane_of(&self, at: &At) -> Option<Vector3<f64>> {
        let At::Edge(EdgePlace { edge }) = at else { return None };
        let (segments, directors) = (self.edge_segments(edge), self.unit_directors());
        let points = |k: usize| Vector3::from(self.mesh.nodes[k]);
        let along = |[a, b]: [usize; 2]| (points(b) - points(a)).normalize();
        let first = *segments.first()?;
        let normal = along(first).cross(&(directors[first[0]] + directors[first[1]])).try_normalize(1e-9)?;
        let is_plane = segments.iter().all(|segment| {
            along(*segment).dot(&normal).abs() < IN_PLANE
                && segment.iter().all(|node| directors[*node].dot(&normal).abs() < IN_PLANE)
        });
        is_plane.then_some(normal)
    }

    /// Nearest point of the middle surface.
    pub(crate) fn nearest(&self, point: &[f64; 3]) -> Option<NearestPoint> {
        NearestPoint::of(&self.points(), &self.faces(), &Vector3::from(*point))
    }

    /// Largest distance of a point of the middle surface from it.
    pub(crate) fn tolerance(&self) -> f64 {
        ON_SURFACE * self.extent()
    }

    /// Point of the middle surface at a place.
    pub fn point_at(&self, SurfacePlace { element, at }: SurfacePlace) -> Vector3<f64> {
        let face = self.mesh.elements[element].face();
        let nodes = face.nodes().iter().map(|node| Vector3::from(self.mesh.nodes[*node]));
        nodes.zip(face.weights(at)).map(|(node, weight)| node * weight).sum()
    }

    /// Opposite corners of the box around the nodes.
    pub(crate) fn corners(&self) -> [[f64; 3]; 2] {
        let mut corners = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for node in &self.mesh.nodes {
            for k in 0..3 {
                corners[0][k] = corners[0][k].min(node[k]);
                corners[1][k] = corners[1][k].max(node[k]);
            }
        }
        corners
    }

    /// Diagonal of the box around the nodes.
    pub(crate) fn extent(&self) -> f64 {
        let [low, high] = self.corners().map(Vector3::from);
        (high - low).norm()
    }

    /// Area of the middle surface, as integrated in the elements.
    pub fn area(&self) -> f64 {
        let points = self.points();
        self.mesh.elements.iter().map(|element| element.face().area(&points)).sum()
    }
}

impl FieldShell for ShearShell {
    fn given(&self) -> GivenFields<'_> {
        GivenFields {
            thickness: &self.thickness,
            angle: self.fibre_angle.as_ref(),
            axis: self.fibre_axis.as_ref(),
            is_patch: false,
        }
    }

    fn field_points(&self) -> Box<dyn Fn(usize, [f64; 2]) -> FieldPoint + Send + Sync> {
        let (points, faces) = (self.points(), self.faces());
        Box::new(move |element, at| {
            let face = &faces[element];
            let weights = face.weights(at);
            let node = |k: usize| face.nodes().get(k).map_or((0, 0.0), |node| (*node, weights[k]));
            let nodes = [0, 1, 2, 3].map(node);
            let position = nodes.iter().map(|(node, weight)| points[*node] * *weight).sum();
            let normal = face.normal_at(at, &points);
            FieldPoint { position, parameters: None, normal, nodes }
        })
    }

    fn describe_point(&self, element: usize, point: &FieldPoint) -> String {
        let [x, y, z] = <[f64; 3]>::from(point.position).map(number);
        format!("({x}, {y}, {z}), element {element}")
    }

    fn field_places(&self) -> Box<dyn Iterator<Item = FieldPlace> + '_> {
        let faces = if self.has_nodes() { &self.mesh.elements[..] } else { &[] };
        let of = |(k, element): (usize, &ElementNodes)| {
            let places: Vec<_> = element.face().section_places().collect();
            places.into_iter().map(move |(at, weight)| (k, at, weight))
        };
        Box::new(faces.iter().enumerate().flat_map(of))
    }
}
