//! Gases in the volumes that shells enclose: their equations, and checks of the surfaces around them.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use ancf_mechanics::bodies::BodyTerms;
use ancf_mechanics::shells::{ElementPatch, EnclosedVolume, GasPressure, PatchMeasures};
use nalgebra::Vector3;

use crate::errors::{Finding, finding, number};
use crate::joints::{
    End, EquationOwner, Joint, JointEquations, JointTerm, Numbering, Part, RecordedCoordinate, Source,
};
use crate::loads::{Gas, GasSurface, Load, patches};
use crate::model::{Body, IndexedModel, Model, loads_of};

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
            let parts = terms.into_iter().chain([last]).map(|term| Part { term, reacts: false });
            let recorded = RecordedCoordinate { source: Source::Gas(pressure), coordinate: Some(coordinate) };
            all.push(JointEquations {
                owner: EquationOwner::Gas,
                name: gas.name.clone(),
                coordinates: coordinate..coordinate + 1,
                multipliers: multiplier..multiplier + 1,
                position: None,
                parts: parts.collect(),
                recorded: vec![recorded],
                states: Vec::new(),
                laws: Vec::new(),
            });
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
        let mut volume = 0.0;
        let mut terms: Vec<Box<dyn JointTerm>> = Vec::new();
        for (patch, reversed) in self.gas_patches(bodies, gas, origin) {
            let own = patch.measures().volume;
            volume += if reversed { -own } else { own };
            terms.push(match patch {
                ElementPatch::Thin(patch) => Box::new(EnclosedVolume::new(patch, reversed, multiplier)),
                ElementPatch::Triangle(patch) => Box::new(EnclosedVolume::new(patch, reversed, multiplier)),
                ElementPatch::Quad(patch) => Box::new(EnclosedVolume::new(patch, reversed, multiplier)),
            });
        }
        (terms, volume)
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
            let corners: Vec<Vec<_>> = if let Some(mesh) = terms.shell() {
                (0..mesh.elements().len()).map(|k| mesh.corners(k).to_vec()).collect()
            } else if let Some((mesh, shell)) = terms.shear_shell().zip(body.shear_shell()) {
                let elements = shell.region(data.region.as_deref()).unwrap_or_default();
                elements.into_iter().map(|k| mesh.corners(k)).collect()
            } else {
                continue;
            };
            all.extend(corners.into_iter().map(|mut corners| {
                if data.reversed {
                    corners.reverse();
                }
                SurfaceElement { surface, corners }
            }));
        }
        all
    }
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

/// Elements at an edge.
struct EdgeUse {
    /// Number of elements that run along the edge from the first to the second point, and back.
    directions: [usize; 2],
    middle: Vector3<f64>,
    /// Surface of each element, and the first coordinates of both nodes in ascending order.
    sides: Vec<(usize, [usize; 2])>,
}

/// Collects the edges of elements. Corners at the same place are one point.
fn edges(elements: &[SurfaceElement]) -> Vec<EdgeUse> {
    let [low, high] = bounds(elements);
    let mut points = Points::new(COINCIDENT * (high - low).norm());
    let mut edges: BTreeMap<[usize; 2], EdgeUse> = BTreeMap::new();
    for SurfaceElement { surface, corners } in elements {
        let ids: Vec<usize> = corners.iter().map(|(_, place)| points.id(*place)).collect();
        for k in 0..corners.len() {
            let next = (k + 1) % corners.len();
            let (a, b) = (ids[k], ids[next]);
            if a == b {
                continue;
            }
            let middle = 0.5 * (corners[k].1 + corners[next].1);
            let mut nodes = [corners[k].0, corners[next].0];
            nodes.sort_unstable();
            let edge = edges.entry([a.min(b), a.max(b)]).or_insert_with(|| EdgeUse {
                directions: [0; 2],
                middle,
                sides: Vec::new(),
            });
            edge.directions[usize::from(a > b)] += 1;
            edge.sides.push((*surface, nodes));
        }
    }
    edges.into_values().collect()
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
    let at = |edge: &EdgeUse| {
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
