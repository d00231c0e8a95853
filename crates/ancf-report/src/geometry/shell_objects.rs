//! Supports on edges of shells, and loads on their edges and surfaces.

use ancf::Model;
use ancf::mechanics::functions::Function;
use ancf::model::{Analysis, At, Body, EdgeName, ElementNodes, Joint, Load, ShearShell};
use ancf::solver::equations::State;
use nalgebra::{Matrix3, Vector3};

use super::body_shape::{BodyShape, SurfaceGrid};
use super::stations::Placement;

/// Maximum number of arrows along a direction of a shell.
pub(crate) const ARROWS: usize = 6;

/// Joint along an edge of a shell.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct EdgeSupport {
    /// Index of the joint.
    pub joint: usize,
    /// Stations along the edge.
    pub stations: Vec<usize>,
}

/// Returns the joints along edges of shells.
pub(crate) fn edge_supports(model: &Model, bodies: &[BodyShape]) -> Vec<EdgeSupport> {
    let of = |(joint, data): (usize, &Joint)| {
        let (place, _) = data.ends();
        let At::Edge(place_on_edge) = &place.at else { return None };
        let shape = bodies.iter().find(|shape| shape.name == place.body)?;
        let stations = edge_stations(&shape.grid?, &place_on_edge.edge, mesh_of(model, &place.body));
        let stations = stations.into_iter().map(|k| shape.stations.start + k).collect();
        Some(EdgeSupport { joint, stations })
    };
    model.joints.iter().enumerate().filter_map(of).collect()
}

/// Shear-deformable shell of a name.
fn mesh_of<'m>(model: &'m Model, name: &str) -> Option<&'m ShearShell> {
    model.bodies.iter().find_map(|body| match body {
        Body::ShearShell(shell) if shell.name == name => Some(shell),
        _ => None,
    })
}

/// Station of a node of a mesh, in its first element.
fn node_station(grid: &SurfaceGrid, shell: &ShearShell, node: usize) -> Option<usize> {
    let [n, m] = grid.counts;
    let corners = [0, n - 1, n * m - 1, (m - 1) * n];
    let of = |(k, element): (usize, &ElementNodes)| {
        // The third node of a triangle is the whole upper side of its grid.
        let corner = element.nodes().iter().position(|own| *own as usize == node)?;
        Some(k * n * m + corners[corner])
    };
    shell.mesh.elements.iter().enumerate().find_map(of)
}

/// Stations of an edge, counted from the first station of the body.
fn edge_stations(grid: &SurfaceGrid, edge: &EdgeName, mesh: Option<&ShearShell>) -> Vec<usize> {
    if let Some(shell) = mesh {
        return shell
            .edge_nodes(edge)
            .into_iter()
            .filter_map(|node| node_station(grid, shell, node))
            .collect();
    }
    let [n, m] = grid.counts;
    let (count, first, step) = match edge {
        EdgeName::Named(_) => return Vec::new(),
        EdgeName::UStart => (m, 0, n),
        EdgeName::UEnd => (m, n - 1, n),
        EdgeName::VStart => (n, 0, 1),
        EdgeName::VEnd => (n, (m - 1) * n, 1),
    };
    (0..count).map(|k| first + k * step).collect()
}

/// Load on an edge or on the surface of a shell, drawn as arrows at some stations.
#[derive(Clone, Debug)]
pub(crate) struct ShellLoad {
    /// Kind of the load.
    pub noun: &'static str,
    /// True for moments.
    pub is_moment: bool,
    /// Stations of the arrows.
    pub stations: Vec<usize>,
    direction: LoadDirection,
    /// Factor of time; `None` in statics, where the load factor is the factor.
    function: Option<Function>,
}

/// Direction of a load on a shell.
#[derive(Clone, Copy, Debug, PartialEq)]
enum LoadDirection {
    /// Constant vector.
    Fixed(Vector3<f64>),
    /// Vector that rotates with the surface.
    Follower(Vector3<f64>),
    /// Multiple of the normal.
    Normal(f64),
}

impl ShellLoad {
    /// Vectors at the stations in a state at a time in the user's units, given its placement and the undeformed one.
    pub fn vectors(&self, [placed, undeformed]: [&Placement; 2], s: &State, time: f64) -> Vec<Vector3<f64>> {
        let factor = self.function.as_ref().map_or(s.load, |function| function.value(time));
        let at = |&station: &usize| {
            factor
                * match self.direction {
                    LoadDirection::Fixed(vector) => vector,
                    LoadDirection::Normal(size) => placed.directors[station][0] * size,
                    LoadDirection::Follower(vector) => {
                        let [now, rest] =
                            [placed, undeformed].map(|of| Matrix3::from_columns(&of.directors[station]));
                        now * (rest.transpose() * vector)
                    }
                }
        };
        self.stations.iter().map(at).collect()
    }
}

/// Returns the loads on shells of a model in the user's units.
pub(crate) fn shell_loads(model: &Model, bodies: &[BodyShape]) -> Vec<ShellLoad> {
    model.loads.iter().filter_map(|load| shell_load(model, bodies, load)).collect()
}

fn shell_load(model: &Model, bodies: &[BodyShape], load: &Load) -> Option<ShellLoad> {
    let turned = |vector: &[f64; 3], follower: bool| {
        let vector = Vector3::from(*vector);
        if follower { LoadDirection::Follower(vector) } else { LoadDirection::Fixed(vector) }
    };
    let (body, edge, direction) = match load {
        Load::EdgeForce(load) => (&load.body, Some(&load.edge), turned(&load.force, false)),
        Load::EdgeMoment(load) => (&load.body, Some(&load.edge), turned(&load.moment, load.follower)),
        Load::SurfaceForce(load) => (&load.body, None, turned(&load.force, false)),
        Load::SurfacePressure(load) => (&load.body, None, LoadDirection::Normal(load.pressure)),
        _ => return None,
    };
    let shape = bodies.iter().find(|shape| &shape.name == body)?;
    let grid = shape.grid?;
    let mesh = mesh_of(model, body);
    let own: Vec<usize> = match (edge, mesh) {
        (Some(edge), _) => sparse(&edge_stations(&grid, edge, mesh), true),
        (None, Some(shell)) => {
            let region = match load {
                Load::SurfaceForce(load) => load.region.as_deref(),
                Load::SurfacePressure(load) => load.region.as_deref(),
                _ => None,
            };
            let [n, m] = grid.counts;
            let middle = |element: usize| element * n * m + (m / 2) * n + n / 2;
            let all: Vec<usize> = shell.region(region)?.into_iter().map(middle).collect();
            sparse_of(&all, ARROWS * ARROWS, false)
        }
        (None, None) => {
            let [n, m] = grid.counts.map(|count| sparse(&(0..count).collect::<Vec<_>>(), false));
            m.iter().flat_map(|j| n.iter().map(move |i| j * grid.counts[0] + i)).collect()
        }
    };
    let is_static = !matches!(model.analysis, Analysis::Dynamics(_));
    let function = load.time().filter(|_| !is_static).map(|time| time.compile().unwrap_or(Function::ONE));
    Some(ShellLoad {
        noun: load.kind().noun(),
        is_moment: matches!(load, Load::EdgeMoment(_)),
        stations: own.into_iter().map(|k| shape.stations.start + k).collect(),
        direction,
        function,
    })
}

/// At most [`ARROWS`] evenly spaced items, with the ends or without them.
fn sparse(all: &[usize], with_ends: bool) -> Vec<usize> {
    sparse_of(all, ARROWS, with_ends)
}

/// At most a number of evenly spaced items, with the ends or without them.
fn sparse_of(all: &[usize], most: usize, with_ends: bool) -> Vec<usize> {
    let count = most.min(all.len());
    let last = all.len().saturating_sub(1);
    let place = |k: usize| match with_ends {
        true => k * last / (count - 1).max(1),
        false => (2 * k + 1) * last / (2 * count),
    };
    let mut places: Vec<usize> = (0..count).map(place).collect();
    places.dedup();
    places.into_iter().map(|k| all[k]).collect()
}
