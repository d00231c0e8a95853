//! Points of a shell to which the nodes of a beam are bonded.

use ancf_mechanics::bodies::ShellPlace;
use nalgebra::{Matrix2, Vector2, Vector3};

use crate::errors::number;
use crate::model::{At, Body, NodePlace, ShearShell, Shell};

/// Largest component of an arm along a thin shell, relative to the length of the beam.
const NORMAL: f64 = 1e-6;
/// Largest component of an arm along a shear-deformable shell, relative to the distance of neighbouring nodes.
const OVER_NODE: f64 = 0.02;
/// Largest length of an element of the beam, relative to one of the shell.
const LONGEST: f64 = 1.0 + 1e-6;
/// Smallest distance of points of the shell below neighbouring nodes, relative to the length of the element of the beam.
const LEVEL: f64 = 0.2;
/// Factor of a span from a vector between two points of a curved surface, whose length is not exact.
const SHORTEST: f64 = 0.95;
/// Largest number of cells in a direction among whose corners the search for the first point starts.
const CELLS: u32 = 32;
const ITERATIONS: usize = 400;

/// Point of a shell below a point of a beam.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot {
    /// Arc length of the point of the beam.
    pub(super) s: f64,
    /// True below a node, false below an integration point.
    pub(super) is_node: bool,
    pub(super) place: ShellPlace,
    /// Unit normal or director of the shell.
    pub(super) normal: Vector3<f64>,
}

/// Reason why a beam cannot be bonded to a shell.
#[derive(Debug)]
pub(super) struct Unfit {
    pub(super) found: String,
    pub(super) expected: String,
}

/// Points of a shell below the nodes of a beam, for a thin shell also below two Gauss points of each of its elements.
///
/// # Errors
/// The reason why a node has no such point, or why the meshes do not fit.
pub(super) fn feet(beam: &Body, shell: &Body) -> Result<Vec<Foot>, Unfit> {
    let gauss = 0.5 - 0.5 / 3.0_f64.sqrt();
    let inner = if matches!(shell, Body::Shell(_)) { &[gauss, 1.0 - gauss][..] } else { &[] };
    let count = beam.elements();
    let point = |element: u32, xi: f64| {
        let s = beam.length() * (f64::from(element) + xi) / f64::from(count);
        (s, beam.point(&At::Length(s)).expect("the length is on the beam"))
    };
    let mut points: Vec<(f64, Vector3<f64>)> = Vec::new();
    for element in 0..count {
        points.push(point(element, 0.0));
        points.extend(inner.iter().map(|xi| point(element, *xi)));
    }
    points.push(point(count, 0.0));
    match shell {
        Body::Shell(shell) => feet_on_patch(&points, shell, beam.length()),
        Body::ShearShell(shell) => feet_at_nodes(&points, shell),
        _ => Ok(Vec::new()),
    }
}

/// Closest points of a thin shell.
fn feet_on_patch(points: &[(f64, Vector3<f64>)], shell: &Shell, length: f64) -> Result<Vec<Foot>, Unfit> {
    let mut feet: Vec<Foot> = Vec::new();
    let [mut last, mut node]: [Option<Closest>; 2] = [None; 2];
    for (k, (s, point)) in points.iter().enumerate() {
        let is_unfit = |found: &Closest| found.along.norm() > NORMAL * length || found.along.x.is_nan();
        let near = last.map(|last| closest(shell, last.at, point)).filter(|found| !is_unfit(found));
        // A line that passes an edge with a seam continues at the other edge.
        let found = near.unwrap_or_else(|| closest(shell, start(shell, point), point));
        if is_unfit(&found) {
            let [x, y, z] = <[f64; 3]>::from(*point).map(number);
            let found = format!(
                "the point ({x}, {y}, {z}) of the beam, {} beside the nearest point of the shell",
                number(found.along.norm())
            );
            return Err(Unfit { found, expected: "a beam over the shell along its whole length".into() });
        }
        let is_node = k % 3 == 0;
        let element = length * 3.0 / (points.len() - 1) as f64;
        if is_node {
            if node.is_some_and(|node| (found.point - node.point).norm() < LEVEL * element) {
                let found = format!("a beam that rises from the shell, element {}", k / 3);
                return Err(Unfit { found, expected: "a beam along the shell".into() });
            }
            let span = node.map_or(0.0, |node| node.span(&found, shell.elements));
            if span > LONGEST {
                let (span, number_of) = (number(span), k / 3);
                let found =
                    format!("an element of the beam over {span} elements of the shell, number {number_of}");
                let expected = "elements of the beam that are no longer than those of the shell".into();
                return Err(Unfit { found, expected });
            }
            node = Some(found);
        }
        last = Some(found);
        let place = ShellPlace::Patch(found.at);
        feet.push(Foot { s: *s, is_node, place, normal: found.normal });
    }
    Ok(feet)
}

/// Closest point of a patch.
#[derive(Clone, Copy, Debug)]
struct Closest {
    at: [f64; 2],
    point: Vector3<f64>,
    /// Derivatives by u and v.
    tangents: [Vector3<f64>; 2],
    normal: Vector3<f64>,
    /// Component of the arm along the surface.
    along: Vector3<f64>,
}

impl Closest {
    /// Largest number of elements along u or v between two points: by the parameters, or by the vector between the points if the line
    /// passes from an edge to another one.
    fn span(&self, other: &Self, elements: [u32; 2]) -> f64 {
        let [a, b] = self.tangents;
        let metric = Matrix2::new(a.dot(&a), a.dot(&b), a.dot(&b), b.dot(&b));
        let chord = other.point - self.point;
        let change =
            metric.try_inverse().unwrap_or_else(Matrix2::zeros) * Vector2::new(chord.dot(&a), chord.dot(&b));
        let largest = |change: [f64; 2]| {
            (change[0].abs() * f64::from(elements[0])).max(change[1].abs() * f64::from(elements[1]))
        };
        largest([0, 1].map(|k| other.at[k] - self.at[k])).min(SHORTEST * largest(change.into()))
    }
}

/// Corner of a cell that is nearest to a point.
fn start(shell: &Shell, point: &Vector3<f64>) -> [f64; 2] {
    let geometry = shell.geometry();
    let cells = shell.elements.map(|count| (2 * count).min(CELLS));
    let corner = |i: u32, j: u32| [f64::from(i) / f64::from(cells[0]), f64::from(j) / f64::from(cells[1])];
    let corners = (0..=cells[1]).flat_map(|j| (0..=cells[0]).map(move |i| corner(i, j)));
    let distance = |at: &[f64; 2]| (geometry.point(*at) - point).norm_squared();
    corners.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or([0.5; 2])
}

/// Closest point of a patch by the method of Gauss and Newton from a start. At a bound, the free parameter alone is changed.
fn closest(shell: &Shell, from: [f64; 2], point: &Vector3<f64>) -> Closest {
    let geometry = shell.geometry();
    let mut at = Vector2::from(from);
    let values = |at: &Vector2<f64>| {
        let [r, a, b, _] = geometry.map((*at).into());
        (point - geometry.origin() - r, [a, b])
    };
    for _ in 0..ITERATIONS {
        let (arm, [a, b]) = values(&at);
        let gradient = Vector2::new(arm.dot(&a), arm.dot(&b));
        let metric = Matrix2::new(a.dot(&a), a.dot(&b), a.dot(&b), b.dot(&b));
        let Some(inverse) = metric.try_inverse() else { break };
        let mut step = inverse * gradient;
        for k in 0..2 {
            if (at[k] <= 0.0 && step[k] < 0.0) || (at[k] >= 1.0 && step[k] > 0.0) {
                step[k] = 0.0;
                step[1 - k] = gradient[1 - k] / metric[(1 - k, 1 - k)];
            }
        }
        let next = (at + step).map(|x| x.clamp(0.0, 1.0));
        let change = (next - at).amax();
        at = next;
        if change < f64::EPSILON {
            break;
        }
    }
    let (arm, [a, b]) = values(&at);
    let normal = a.cross(&b).normalize();
    let along = arm - normal * arm.dot(&normal);
    Closest { at: at.into(), point: point - arm, tangents: [a, b], normal, along }
}

/// Nodes of a mesh below the nodes of a beam.
fn feet_at_nodes(points: &[(f64, Vector3<f64>)], shell: &ShearShell) -> Result<Vec<Foot>, Unfit> {
    let (nodes, directors) = (shell.points(), shell.unit_directors());
    let mut before = None;
    let mut feet = Vec::new();
    for (node, (s, point)) in points.iter().enumerate() {
        let distance = |k: &usize| (nodes[*k] - point).norm_squared();
        let nearest =
            (0..nodes.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).expect("a mesh has nodes");
        let beside = {
            let arm = point - nodes[nearest];
            (arm - directors[nearest] * arm.dot(&directors[nearest])).norm()
        };
        let neighbour = points.get(node + 1).or_else(|| points.get(node.wrapping_sub(1)));
        let length = neighbour.map_or(0.0, |(_, next)| (next - point).norm());
        if beside.is_nan() || beside > OVER_NODE * length {
            let [x, y, z] = <[f64; 3]>::from(*point).map(number);
            let found = format!(
                "node {node} of the beam, at ({x}, {y}, {z}), {} beside the nearest node of the mesh",
                number(beside)
            );
            let expected = "nodes of the beam over the nodes of the mesh, along lines of its elements".into();
            return Err(Unfit { found, expected });
        }
        let joins = |last: usize| {
            let is_own = |[a, b]: [usize; 2]| [a, b] == [last, nearest] || [b, a] == [last, nearest];
            shell.mesh.elements.iter().any(|element| element.face().edges().any(is_own))
        };
        if let Some(last) = before
            && !joins(last)
        {
            let found = format!(
                "an element of the beam between {} and {}, which no edge of an element connects",
                shell.describe_node(last),
                shell.describe_node(nearest)
            );
            return Err(Unfit {
                found,
                expected: "one element of the beam for each edge of the mesh".into(),
            });
        }
        before = Some(nearest);
        if let Some(place) = shell.place(&At::Node(NodePlace { node: nearest as u32 })) {
            let place = ShellPlace::Element(place);
            feet.push(Foot { s: *s, is_node: true, place, normal: directors[nearest] });
        }
    }
    Ok(feet)
}
