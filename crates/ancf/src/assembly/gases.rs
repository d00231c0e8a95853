//! Gases in the volumes that shells enclose: their equations, and checks of the surfaces around them.

use std::collections::{BTreeSet, HashMap};

use ancf_mechanics::bodies::BodyTerms;
use ancf_mechanics::shells::{
    ElementPatch, EnclosedVolume, Face, GasPressure, MeshTopology, PatchMeasures, SurfacePatch,
};
use nalgebra::Vector3;

use crate::errors::{Finding, finding, number};
use crate::joints::{
    End, EquationOwner, Joint, JointEquations, JointTerm, Numbering, Part, RecordedCoordinate, Source,
};
use crate::loads::{Gas, GasSurface, Load, patches};
use crate::model::{Body, IndexedModel, Model, elements_of, loads_of};

/// Distance of points that coincide, relative to the size of the surfaces.
const COINCIDENT: f64 = 1e-6;
/// Largest resultant ∫ n dA of a closed surface, relative to its area.
const CLOSED: f64 = 1e-6;

impl IndexedModel<'_> {
    /// Equations of the gases, numbered after those of the joints.
    pub(super) fn gas_equations(
        &self,
        bodies: &[(String, BodyTerms)],
        numbering: Numbering,
    ) -> Vec<JointEquations> {
        let Numbering { mut coordinate, mut multiplier, time_mode, .. } = numbering;
        let mut all = Vec::new();
        for gas in gases(self) {
            let (terms, volume) = self.enclosing_terms(bodies, gas, multiplier);
            let amount = time_mode.function(&gas.time);
            let pressures = [gas.pressure, gas.ambient];
            let pressure =
                GasPressure::new((coordinate, multiplier), volume, pressures, gas.exponent, amount);
            let last: Box<dyn JointTerm> = Box::new(pressure.clone());
            let recorded = RecordedCoordinate { source: Source::Gas(pressure), coordinate: Some(coordinate) };
            let mut own = JointEquations::new(EquationOwner::Gas, &gas.name, coordinate, multiplier);
            (own.coordinates.end, own.multipliers.end) = (coordinate + 1, multiplier + 1);
            own.parts.extend(
                terms.into_iter().chain([last]).map(|term| Part { reacts: false, ..Part::new(term) }),
            );
            own.recorded.push(recorded);
            all.push(own);
            (coordinate, multiplier) = (coordinate + 1, multiplier + 1);
        }
        all
    }

    /// Terms of the elements around a gas, and the undeformed volume.
    fn enclosing_terms(
        &self,
        bodies: &[(String, BodyTerms)],
        gas: &Gas,
        multiplier: usize,
    ) -> (Vec<Box<dyn JointTerm>>, f64) {
        let origin = origin(gas, &self.surface_elements(bodies, gas));
        let parts = self.gas_patches(bodies, gas, origin).into_iter().map(|(patch, reversed)| match patch {
            ElementPatch::Thin(patch) => part(patch, reversed, multiplier),
            ElementPatch::Triangle(patch) => part(patch, reversed, multiplier),
            ElementPatch::Quad(patch) => part(patch, reversed, multiplier),
        });
        let (terms, volumes): (Vec<_>, Vec<f64>) = parts.unzip();
        (terms, volumes.iter().sum())
    }

    /// Middle surfaces of the elements around a gas, with marks of those whose normal points into it.
    fn gas_patches(
        &self,
        bodies: &[(String, BodyTerms)],
        gas: &Gas,
        origin: Vector3<f64>,
    ) -> Vec<(ElementPatch, bool)> {
        let of_surface = |surface: &GasSurface| {
            let (body, terms) = self.built(bodies, &surface.body)?;
            let all = patches(body, terms, surface.region.as_deref(), origin);
            let reversed = surface.reversed;
            Some(all.into_iter().map(move |patch| (patch, reversed)))
        };
        gas.surfaces.iter().filter_map(of_surface).flatten().collect()
    }

    /// Body of a name with its terms.
    fn built<'b>(
        &'b self,
        bodies: &'b [(String, BodyTerms)],
        name: &str,
    ) -> Option<(&'b Body, &'b BodyTerms)> {
        let number = self.body_number(name)?;
        Some((&self.bodies[number], &bodies[number].1))
    }

    /// Elements around a gas.
    fn surface_elements(&self, bodies: &[(String, BodyTerms)], gas: &Gas) -> Vec<SurfaceElement> {
        let mut all = Vec::new();
        for (surface, data) in gas.surfaces.iter().enumerate() {
            let Some((body, terms)) = self.built(bodies, &data.body) else { continue };
            let corners = |k: usize| match (terms.shell(), terms.shear_shell()) {
                (Some(mesh), _) => Some(mesh.corners(k).to_vec()),
                (_, Some(mesh)) => Some(mesh.corners(k)),
                _ => None,
            };
            let corners = elements_of(body, data.region.as_deref()).into_iter().filter_map(corners);
            all.extend(corners.map(|mut corners| {
                if data.reversed {
                    corners.reverse();
                }
                SurfaceElement { surface, corners }
            }));
        }
        all
    }
}

/// Part of an element of the equation of a gas, and of the undeformed volume.
fn part<const N: usize>(
    patch: SurfacePatch<N>,
    reversed: bool,
    multiplier: usize,
) -> (Box<dyn JointTerm>, f64) {
    let part = EnclosedVolume::new(patch, reversed, multiplier);
    let volume = part.reference_volume();
    (Box::new(part), volume)
}

/// Gases of a model.
fn gases(model: &Model) -> impl Iterator<Item = &Gas> {
    model.loads.iter().filter_map(|load| if let Load::Gas(gas) = load { Some(gas) } else { None })
}

/// Element around a gas.
struct SurfaceElement {
    /// Index of its surface.
    surface: usize,
    /// First coordinate and place of each corner, counter-clockwise seen from outside.
    corners: Vec<(usize, Vector3<f64>)>,
}

/// Origin of the volume: the apex of openings, otherwise the middle of the corners.
fn origin(gas: &Gas, elements: &[SurfaceElement]) -> Vector3<f64> {
    let [low, high] = bounds(elements);
    gas.apex.map_or(0.5 * (low + high), Vector3::from)
}

/// Corners of the box around elements.
fn bounds(elements: &[SurfaceElement]) -> [Vector3<f64>; 2] {
    let corners = || elements.iter().flat_map(|element| element.corners.iter().map(|(_, place)| *place));
    let first = corners().next().unwrap_or_default();
    corners().fold([first; 2], |[low, high], place| [low.inf(&place), high.sup(&place)])
}

/// Elements at an edge around a gas.
struct Edge {
    middle: Vector3<f64>,
    /// Number of elements that run along the edge from the first to the second point, and back.
    directions: [usize; 2],
    /// Surface of each element, and the first coordinates of its nodes there in ascending order.
    sides: Vec<(usize, [usize; 2])>,
}

/// Collects the edges of elements. Corners at the same place are one point.
fn edges(elements: &[SurfaceElement]) -> Vec<Edge> {
    let [low, high] = bounds(elements);
    let mut points = Points::new(COINCIDENT * (high - low).norm());
    let mut points_of = |element: &SurfaceElement| -> Vec<usize> {
        element.corners.iter().map(|(_, place)| points.id(*place)).collect()
    };
    let ids: Vec<Vec<usize>> = elements.iter().map(&mut points_of).collect();
    let faces: Vec<Face> = ids.iter().filter_map(|ids| Face::new(ids)).collect();
    let edge = |(ends, of): ([usize; 2], &[(usize, bool)])| {
        let side = |k: usize| ends.map(|end| corner(&elements[k], &ids[k], end));
        let [a, b] = side(of[0].0).map(|(_, place)| place);
        let forward = of.iter().filter(|(_, sense)| *sense).count();
        let nodes = |k: usize| {
            let mut nodes = side(k).map(|(first, _)| first);
            nodes.sort_unstable();
            nodes
        };
        Edge {
            middle: 0.5 * (a + b),
            directions: [forward, of.len() - forward],
            sides: of.iter().map(|(k, _)| (elements[*k].surface, nodes(*k))).collect(),
        }
    };
    // Collapsed edges are points.
    MeshTopology::new(points.count, &faces).edges().filter(|([a, b], _)| a != b).map(edge).collect()
}

/// Corner of an element at a point.
fn corner(element: &SurfaceElement, ids: &[usize], point: usize) -> (usize, Vector3<f64>) {
    let at = ids.iter().position(|id| *id == point).unwrap_or(0);
    element.corners[at]
}

/// Points that are distinct within a tolerance.
struct Points {
    tolerance: f64,
    cells: HashMap<[i64; 3], Vec<(usize, Vector3<f64>)>>,
    count: usize,
}

impl Points {
    fn new(tolerance: f64) -> Self {
        Self { tolerance, cells: HashMap::new(), count: 0 }
    }

    /// Number of the point at a place.
    fn id(&mut self, place: Vector3<f64>) -> usize {
        let cell = |x: f64| (x / (4.0 * self.tolerance)).floor() as i64;
        let [i, j, k] = [cell(place.x), cell(place.y), cell(place.z)];
        let near = |n: i64| [n - 1, n, n + 1];
        for at in near(i)
            .into_iter()
            .flat_map(|i| near(j).into_iter().flat_map(move |j| near(k).map(|k| [i, j, k])))
        {
            let known = self.cells.get(&at).into_iter().flatten();
            let mut same = known.filter(|(_, other)| (other - place).norm() <= self.tolerance);
            if let Some((id, _)) = same.next() {
                return *id;
            }
        }
        self.count += 1;
        self.cells.entry([i, j, k]).or_default().push((self.count - 1, place));
        self.count - 1
    }
}

/// Checks that surfaces enclose the gases. The model must satisfy all other checks.
pub(crate) fn enclosures(model: &Model) -> Vec<Finding> {
    if gases(model).next().is_none() {
        return Vec::new();
    }
    let model = &IndexedModel::new(model);
    let bodies = model.meshes();
    let gas = |(path, load): (String, &Load)| {
        if let Load::Gas(gas) = load { enclosure(model, &bodies, &path, gas) } else { None }
    };
    loads_of(model).filter_map(gas).collect()
}

/// Finding if surfaces do not enclose a gas.
fn enclosure(
    model: &IndexedModel<'_>,
    bodies: &[(String, BodyTerms)],
    path: &str,
    gas: &Gas,
) -> Option<Finding> {
    let (key, elements) = (format!("{path}.surfaces"), model.surface_elements(bodies, gas));
    let error = |found: String, expected: &str| Some(finding(key.clone(), found, expected));
    let edges = edges(&elements);
    let at = |edge: &Edge| {
        let [x, y, z] = [0, 1, 2].map(|k| number(edge.middle[k]));
        format!("at ({x}, {y}, {z})")
    };
    if let Some(edge) = edges.iter().find(|edge| edge.directions.iter().sum::<usize>() > 2) {
        return error(
            format!("more than two elements at one edge, {}", at(edge)),
            "surfaces that do not overlap",
        );
    }
    if let Some(edge) = edges.iter().find(|edge| edge.directions.contains(&2)) {
        let found = format!("elements on both sides of an edge with opposite normals, {}", at(edge));
        return error(
            found,
            "normals that all point out of the gas: `reversed = true` for the other surfaces",
        );
    }
    let open = edges.iter().filter(|edge| edge.directions.contains(&0)).count();
    if let Some(edge) = edges.iter().find(|edge| edge.directions.contains(&0)).filter(|_| gas.apex.is_none())
    {
        let found = format!("an opening with {open} edges of elements, one of them {}", at(edge));
        return error(
            found,
            "surfaces that enclose the gas, or `apex`, a point to which openings are closed",
        );
    }
    let origin = origin(gas, &elements);
    let mut sum = PatchMeasures::default();
    for (patch, reversed) in model.gas_patches(bodies, gas, origin) {
        let (own, sign) = (patch.measures(), if reversed { -1.0 } else { 1.0 });
        sum.volume += sign * own.volume;
        sum.normal += own.normal * sign;
        sum.area += own.area;
    }
    if open == 0 && sum.normal.norm() > CLOSED * sum.area {
        let found = "edges that meet at the nodes, but not between them";
        return error(found.into(), "edges of the same shape");
    }
    if sum.volume <= 1e-9 * sum.area.powf(1.5) {
        let found = format!("the volume {}", number(sum.volume));
        return error(found, "a positive volume: normals that point out of the gas, or `reversed = true`");
    }
    None
}

/// Warnings of edges around a gas that nothing keeps together.
pub(crate) fn gas_warnings(model: &Model) -> Vec<String> {
    if gases(model).next().is_none() {
        return Vec::new();
    }
    let model = &IndexedModel::new(model);
    let bodies = model.meshes();
    gases(model).flat_map(|gas| loose_edges(model, &bodies, gas)).collect()
}

fn loose_edges(model: &IndexedModel<'_>, bodies: &[(String, BodyTerms)], gas: &Gas) -> Vec<String> {
    let mut pairs: BTreeSet<[&str; 2]> = BTreeSet::new();
    for edge in edges(&model.surface_elements(bodies, gas)) {
        if let [(a, nodes), (b, others)] = *edge.sides.as_slice()
            && nodes != others
        {
            let mut names = [a, b].map(|k| gas.surfaces[k].body.as_str());
            names.sort_unstable();
            pairs.insert(names);
        }
    }
    let is_joined = |names: &[&str; 2]| {
        model.joints.iter().any(|joint| {
            let (Joint::Seam(_), (a, End::Place(b))) = (joint, joint.ends()) else { return false };
            let mut own = [a.body.as_str(), b.body.as_str()];
            own.sort_unstable();
            own == *names
        })
    };
    let text = |[a, b]: [&str; 2]| {
        let name = &gas.name;
        match a == b {
            true => format!(
                "edges of shell `{a}` meet around gas `{name}`, but no seam joins them: the volume can open"
            ),
            false => {
                format!(
                    "edges of shells `{a}` and `{b}` meet around gas `{name}`, but no seam joins them: the volume can open"
                )
            }
        }
    };
    pairs.into_iter().filter(|names| !is_joined(names)).map(text).collect()
}
