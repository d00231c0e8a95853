use nalgebra::Vector3;

use super::{
    Beam, Body, Clamped, End, Formulation, Joint, Load, MaterialLaw, Model, ModelErrors, Place, Probe,
    Quantity,
};
use crate::mechanics::{
    self, BeamMesh, Blueprint, Coincide, CrossSection, Force, Kind, Marker, Medium, Perpendicular, Wrench,
    across,
};
use crate::system::{EquationsOfMotion, State, System, Term};

/// A model as equations of motion, with what is needed to read their solution.
#[derive(Debug)]
pub struct Assembly {
    /// The equations of motion.
    pub system: System,
    /// Names and points of the probes.
    pub probes: Vec<(String, Marker)>,
    /// What the probes record.
    pub measures: Vec<Measure>,
    /// Whether strain energies of bodies are recorded by part.
    pub energy_parts: bool,
    bodies: Vec<(String, BeamMesh)>,
    joints: Vec<JointEquations>,
}

/// One quantity that a probe records.
#[derive(Debug)]
pub struct Measure {
    /// Name of the probe.
    pub name: String,
    /// What it records.
    pub quantity: Quantity,
    /// The point.
    pub point: Marker,
    /// Number of the body.
    pub body: usize,
    /// Arc length.
    pub s: f64,
    /// (y, z) in the section.
    pub offset: [f64; 2],
}

/// The equations of one joint.
#[derive(Debug, Default)]
pub(super) struct JointEquations {
    name: String,
    coincide: Vec<Coincide>,
    perpendicular: Vec<Perpendicular>,
}

impl JointEquations {
    /// Number of multipliers.
    fn multipliers(&self) -> usize {
        3 * self.coincide.len() + self.perpendicular.len()
    }

    /// Keeps the tangent of a line normal to two directions across it of another body or the ground.
    fn tie_line(
        &mut self,
        line: &impl Fn(Vector3<f64>) -> Marker,
        section: &impl Fn(Vector3<f64>) -> Marker,
        tangent: Vector3<f64>,
        first: usize,
    ) {
        for normal in across(tangent) {
            let multiplier = first + self.multipliers();
            self.perpendicular.push(Perpendicular::new(&line(tangent), &section(normal), multiplier));
        }
    }

    /// Keeps the angles between the sections' directions of two beams that meet at an angle: their rotation is the same, and
    /// each section may change its size.
    ///
    /// Of the four products of r_y, r_z of one with r_y, r_z of the other the three whose rates tell rotations apart best.
    fn tie_corner(&mut self, [_, d, e]: [Marker; 3], [_, y, z]: [Marker; 3], first: usize) {
        let pairs = [(&d, &y), (&d, &z), (&e, &y), (&e, &z)];
        let turns = pairs.map(|(a, b)| a.reference().cross(&b.reference()));
        let volume = |left: usize| {
            let kept: Vec<_> = (0..4).filter(|&k| k != left).map(|k| turns[k]).collect();
            kept[0].dot(&kept[1].cross(&kept[2])).abs()
        };
        let left = (0..4).max_by(|&i, &j| volume(i).total_cmp(&volume(j))).unwrap_or(0);
        for (_, (a, b)) in pairs.iter().enumerate().filter(|(k, _)| *k != left) {
            let multiplier = first + self.multipliers();
            self.perpendicular.push(Perpendicular::new(a, b, multiplier));
        }
    }

    pub(super) fn terms(&self) -> impl Iterator<Item = Box<dyn Term>> {
        let coincide = self.coincide.iter().cloned().map(|c| Box::new(c) as Box<dyn Term>);
        coincide.chain(self.perpendicular.iter().cloned().map(|c| Box::new(c) as Box<dyn Term>))
    }
}

impl Assembly {
    /// The reference configuration at rest.
    pub fn rest(&self) -> State {
        State::rest(self.system.coordinates(), self.system.multipliers())
    }

    /// Names of the joints.
    pub fn joints(&self) -> impl Iterator<Item = &str> {
        self.joints.iter().map(|joint| joint.name.as_str())
    }

    /// What each joint exerts on its end `a` in a state.
    pub fn reactions<'a>(&'a self, s: &'a State) -> impl Iterator<Item = Wrench> + 'a {
        self.joints.iter().map(|joint| {
            let coincide = joint.coincide.iter().map(|c| c.reaction(s));
            let perpendicular = joint.perpendicular.iter().map(|c| c.reaction(s));
            coincide.chain(perpendicular).fold(Wrench::default(), |sum, part| Wrench {
                force: sum.force + part.force,
                moment: sum.moment + part.moment,
            })
        })
    }

    /// Names and meshes of the bodies.
    pub fn bodies(&self) -> impl Iterator<Item = (&str, &BeamMesh)> {
        self.bodies.iter().map(|(name, mesh)| (name.as_str(), mesh))
    }

    /// The mesh of a body by its number, as [`Measure`] has it.
    pub fn mesh_of(&self, body: usize) -> &BeamMesh {
        &self.bodies[body].1
    }

    /// The mesh of a body.
    pub fn mesh(&self, body: &str) -> Option<&BeamMesh> {
        self.bodies.iter().find(|(name, _)| name == body).map(|(_, mesh)| mesh)
    }

    /// What an equation belongs to, in words: a node of a body, or a joint.
    pub fn name_of(&self, equation: usize) -> String {
        let mut first = 0;
        for (name, mesh) in &self.bodies {
            if let Some((node, vector)) = mesh.place_of(equation) {
                let vector = match vector {
                    Kind::Position => "r",
                    Kind::Slope => "r_x",
                    Kind::Y => "r_y",
                    Kind::Z => "r_z",
                };
                let axis = ["x", "y", "z"][(equation - first) % 3];
                return format!("body `{name}`, node {node}, {vector} along {axis}");
            }
            first += mesh.coordinates();
        }
        for joint in &self.joints {
            if equation < first + joint.multipliers() {
                return format!("joint `{}`, equation {}", joint.name, equation - first + 1);
            }
            first += joint.multipliers();
        }
        format!("equation {equation}")
    }
}

impl Model {
    /// Turns a valid model into equations of motion in the model's own numbers.
    ///
    /// # Errors
    /// If the model is not valid.
    pub fn assemble(&self) -> Result<Assembly, ModelErrors> {
        self.check()?;
        let bodies = self.meshes();
        let joints = self.joint_equations(&bodies);
        let point = |place| {
            let (mesh, s) = self.locate(&bodies, place);
            mesh.point(s)
        };
        let mut terms: Vec<Box<dyn Term>> = Vec::new();
        for (_, mesh) in &bodies {
            terms.extend(mesh.terms());
        }
        terms.extend(joints.iter().flat_map(JointEquations::terms));
        for Load::Force { on, force } in &self.loads {
            terms.push(Box::new(Force::new(&point(on), Vector3::from(*force))));
        }
        let probes =
            self.probes.iter().map(|probe| (probe.name.clone(), self.probed(&bodies, probe).2)).collect();
        let measures = self.probes.iter().flat_map(|probe| {
            let (body, s, point) = self.probed(&bodies, probe);
            probe.record.iter().map(move |&quantity| {
                let (name, point, offset) = (probe.name.clone(), point.clone(), probe.offset);
                Measure { name, quantity, point, body, s, offset }
            })
        });
        let (measures, energy_parts) = (measures.collect(), self.output.energy_parts);
        let coordinates = bodies.iter().map(|(_, mesh)| mesh.coordinates()).sum();
        let multipliers = joints.iter().map(JointEquations::multipliers).sum();
        let system = System::new(coordinates, multipliers, terms);
        Ok(Assembly { system, probes, measures, energy_parts, bodies, joints })
    }

    /// Number of the body, arc length and point of a probe.
    fn probed(&self, meshes: &[(String, BeamMesh)], probe: &Probe) -> (usize, f64, Marker) {
        let index = self.bodies.iter().position(|body| body.name() == probe.on.body);
        let index = index.expect("a checked model names bodies that are there");
        let (s, [y, z]) = (self.bodies[index].arc_length(probe.on.at), probe.offset);
        (index, s, meshes[index].1.material_point(s, y, z))
    }

    /// The mesh and the arc length of a place.
    fn locate<'a>(&self, meshes: &'a [(String, BeamMesh)], place: &Place) -> (&'a BeamMesh, f64) {
        let index = self.bodies.iter().position(|body| body.name() == place.body);
        let index = index.expect("a checked model names bodies that are there");
        (&meshes[index].1, self.bodies[index].arc_length(place.at))
    }

    /// The equations of the joints, multipliers counted on from joint to joint.
    pub(super) fn joint_equations(&self, meshes: &[(String, BeamMesh)]) -> Vec<JointEquations> {
        let mut first = 0;
        let equations = self.joints.iter().map(|joint| {
            let equations =
                equations(joint, self.is_locking(joint), first, &|place| self.locate(meshes, place));
            first += equations.multipliers();
            equations
        });
        equations.collect()
    }

    /// Whether the first end of a joint is on a beam of the continuum formulation.
    fn is_locking(&self, joint: &Joint) -> bool {
        let body = self.bodies.iter().find(|body| body.name() == joint.ends().0.body);
        matches!(body, Some(Body::Beam(Beam { formulation: Formulation::Continuum, .. })))
    }

    /// The meshes of the bodies, coordinates counted on from body to body.
    pub(super) fn meshes(&self) -> Vec<(String, BeamMesh)> {
        let mut first = 0;
        let meshes = self.bodies.iter().map(|body| {
            let mesh = self.mesh(body, first);
            first += mesh.coordinates();
            (body.name().to_owned(), mesh)
        });
        meshes.collect()
    }

    fn mesh(&self, body: &Body, first: usize) -> BeamMesh {
        let material = &self.materials[body.material()];
        let medium = Medium {
            lame: material.lame(),
            neo_hookean: material.law == MaterialLaw::NeoHookean,
            density: material.density,
            retardation: material.damping.strain,
            drag: material.damping.mass,
            gravity: Vector3::from(self.gravity),
        };
        let elements = body.elements() as usize;
        let curve = body.curve().expect("a checked body has an axis");
        let (total, up) = (curve.length(), body.up().expect("a checked body has a direction `up`"));
        let nodes = |parts: usize, twist: f64| {
            let at: Vec<f64> = (0..=parts).map(|k| total * k as f64 / parts as f64).collect();
            curve.nodes(up, twist, &at)
        };
        let (length, slope) = (total / elements as f64, body.slope_length());
        let section = |s: f64| self.cross_section(body, s / total);
        let prismatic = !matches!(body, Body::Beam(Beam { section_end: Some(_), .. }));
        let origin = Vector3::from(body.span()[0]);
        let blueprint =
            Blueprint { first, origin, length, slope, medium: &medium, section: &section, prismatic };
        match body {
            Body::Beam(beam) => match beam.formulation.two_node() {
                Some(formulation) => {
                    BeamMesh::two_node(&blueprint, &nodes(elements, beam.twist), formulation)
                }
                None => BeamMesh::three_node(&blueprint, &nodes(2 * elements, beam.twist)),
            },
            Body::Cable(_) => BeamMesh::cable(&blueprint, &nodes(elements, 0.0)),
        }
    }

    /// The section of a body at a part of its length.
    fn cross_section(&self, body: &Body, part: f64) -> CrossSection {
        let start = &self.sections[body.section()];
        let section = match body {
            Body::Beam(Beam { section_end: Some(end), .. }) => start.towards(&self.sections[end], part),
            _ => *start,
        };
        section.cross_section(self.materials[body.material()].poisson)
    }
}

impl Formulation {
    /// The formulation of the two-node element, if it is one.
    const fn two_node(self) -> Option<mechanics::Formulation> {
        match self {
            Self::Continuum => Some(mechanics::Formulation::Continuum),
            Self::Enhanced => Some(mechanics::Formulation::Enhanced),
            Self::Linked => Some(mechanics::Formulation::Linked),
            Self::Quadratic => None,
        }
    }
}

/// A joint as equations between markers, by multipliers from `first` on.
fn equations<'a>(
    joint: &Joint,
    locking: bool,
    first: usize,
    find: &impl Fn(&Place) -> (&'a BeamMesh, f64),
) -> JointEquations {
    let (a, b) = joint.ends();
    let (mesh, s) = find(a);
    let other = |direction: Vector3<f64>| match b {
        End::Ground => Marker::fixed(direction),
        End::Place(place) => {
            let (mesh, s) = find(place);
            mesh.direction(s, direction)
        }
    };
    let point = mesh.point(s);
    let opposite = match b {
        End::Ground => Marker::fixed(point.reference()),
        End::Place(place) => {
            let (mesh, s) = find(place);
            mesh.point(s)
        }
    };
    let place_axes = |place| {
        let (mesh, s) = find(place);
        mesh.reference_axes(s)
    };
    let mut equations = JointEquations {
        name: joint.name().to_owned(),
        coincide: vec![Coincide::points(&point, &opposite, first)],
        ..JointEquations::default()
    };
    match joint {
        Joint::Spherical { .. } => {}
        Joint::Clamp { fix, .. } => {
            let sectional = |end: &End| !matches!(end, End::Place(place) if !find(place).0.has_sections());
            let fix = fix.unwrap_or(if locking { Clamped::All } else { Clamped::Section });
            let axes = mesh.reference_axes(s);
            let tied = match (mesh.has_sections(), sectional(b), fix) {
                (true, true, Clamped::All) => axes.as_slice(),
                (true, true, Clamped::Section) => match b {
                    End::Place(place) if corner(&axes, &place_axes(place)) => {
                        let other = find(place);
                        equations.tie_corner(mesh.axes(s), other.0.axes(other.1), first);
                        return equations;
                    }
                    _ => &axes[1..],
                },
                // A line has a tangent only: it stays normal to what the other end has across it.
                (true, false, Clamped::Section) => {
                    equations.tie_line(&other, &|x| mesh.direction(s, x), axes[0].normalize(), first);
                    return equations;
                }
                (false, true, Clamped::Section) => {
                    equations.tie_line(&|x| mesh.direction(s, x), &other, axes[0].normalize(), first);
                    return equations;
                }
                (false, false, _) => match b {
                    End::Place(place) if lines_corner(&axes, &place_axes(place)) => {
                        let (other, at) = find(place);
                        let multiplier = first + equations.multipliers();
                        let tie = Perpendicular::new(&mesh.axes(s)[0], &other.axes(at)[0], multiplier);
                        equations.perpendicular.push(tie);
                        return equations;
                    }
                    _ => &axes[..1],
                },
                (false, ..) | (_, false, _) => &axes[..1],
            };
            for &direction in tied {
                let multipliers = first + equations.multipliers();
                let tie = Coincide::directions(&mesh.direction(s, direction), &other(direction), multipliers);
                equations.coincide.push(tie);
            }
        }
        Joint::Revolute { axis, .. } => {
            let axis = Vector3::from(*axis).normalize();
            for normal in across(axis) {
                let multiplier = first + equations.multipliers();
                let tie = Perpendicular::new(&mesh.direction(s, axis), &other(normal), multiplier);
                equations.perpendicular.push(tie);
            }
        }
    }
    equations
}

/// Whether the sections of two beams are not parallel.
fn corner(a: &[Vector3<f64>; 3], b: &[Vector3<f64>; 3]) -> bool {
    let [a, b] = [a, b].map(|axes| axes[1].cross(&axes[2]).normalize());
    a.dot(&b).abs() < 0.996
}

/// Whether two lines are not parallel.
fn lines_corner(a: &[Vector3<f64>; 3], b: &[Vector3<f64>; 3]) -> bool {
    a[0].normalize().dot(&b[0].normalize()).abs() < 0.996
}
