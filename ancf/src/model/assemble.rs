use nalgebra::Vector3;

use super::function::Clock;
use super::ties::{JointEquations, On};
use super::{Beam, Body, Formulation, Joint, Load, MaterialLaw, Model, ModelErrors, Place, Probe, Quantity};
use crate::mechanics::{self, BeamMesh, Blueprint, CrossSection, Kind, Marker, Medium, Wrench};
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
    breaks: Vec<f64>,
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
        self.joints.iter().map(|joint| joint.reaction(s))
    }

    /// Names and meshes of the bodies.
    pub fn bodies(&self) -> impl Iterator<Item = (&str, &BeamMesh)> {
        self.bodies.iter().map(|(name, mesh)| (name.as_str(), mesh))
    }

    /// The mesh of a body by its number, as [`Measure`] has it.
    pub fn mesh_of(&self, body: usize) -> &BeamMesh {
        &self.bodies[body].1
    }

    /// Times at which loads and drives or their rates jump, in order: steps are best ended there.
    pub fn breaks(&self) -> &[f64] {
        &self.breaks
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
        self.assembled(Clock::Runs)
    }

    /// The same for statics: functions of time are 1, so that loads and angles have their full values, times the load factor of
    /// a state.
    ///
    /// # Errors
    /// If the model is not valid.
    pub fn assemble_static(&self) -> Result<Assembly, ModelErrors> {
        self.assembled(Clock::Stands)
    }

    fn assembled(&self, clock: Clock) -> Result<Assembly, ModelErrors> {
        self.check()?;
        let bodies = self.meshes();
        let joints = self.joint_equations(&bodies, clock);
        let mut terms: Vec<Box<dyn Term>> = Vec::new();
        for (_, mesh) in &bodies {
            terms.extend(mesh.terms());
        }
        terms.extend(joints.iter().flat_map(JointEquations::terms));
        for load in &self.loads {
            let (mesh, s) = self.locate(&bodies, load.on());
            terms.push(load.term(mesh, s, clock));
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
        let system = System::new(coordinates, multipliers, terms).with(self.encounters(&bodies));
        let breaks = self.breaks(clock);
        Ok(Assembly { system, probes, measures, energy_parts, bodies, joints, breaks })
    }

    /// Number of the body, arc length and point of a probe.
    fn probed(&self, meshes: &[(String, BeamMesh)], probe: &Probe) -> (usize, f64, Marker) {
        let index = self.body_of(&probe.on);
        let (s, [y, z]) = (self.bodies[index].arc_length(probe.on.at), probe.offset);
        (index, s, meshes[index].1.material_point(s, y, z))
    }

    /// Breaks of all functions of time, in order.
    fn breaks(&self, clock: Clock) -> Vec<f64> {
        let of_joints = self.joints.iter().filter_map(Joint::time);
        let functions = self.loads.iter().map(Load::time).chain(of_joints);
        let mut breaks: Vec<f64> = functions.flat_map(|time| clock.function(time).breaks()).collect();
        breaks.sort_unstable_by(f64::total_cmp);
        breaks.dedup();
        breaks
    }

    /// Number of the body of a place.
    fn body_of(&self, place: &Place) -> usize {
        let index = self.bodies.iter().position(|body| body.name() == place.body);
        index.expect("a checked model names bodies that are there")
    }

    /// The mesh and the arc length of a place.
    pub(super) fn locate<'a>(&self, meshes: &'a [(String, BeamMesh)], place: &Place) -> (&'a BeamMesh, f64) {
        let index = self.body_of(place);
        (&meshes[index].1, self.bodies[index].arc_length(place.at))
    }

    /// The equations of the joints, multipliers counted on from joint to joint.
    pub(super) fn joint_equations(&self, meshes: &[(String, BeamMesh)], clock: Clock) -> Vec<JointEquations> {
        let mut first = 0;
        let equations = self.joints.iter().map(|joint| {
            let find = |place: &Place| {
                let (mesh, s) = self.locate(meshes, place);
                On { mesh, s }
            };
            let equations = JointEquations::new(joint, self.is_locking(joint), first, clock, &find);
            first += equations.multipliers();
            equations
        });
        equations.collect()
    }

    /// Whether the first end of a joint is on a beam of the continuum formulation.
    fn is_locking(&self, joint: &Joint) -> bool {
        let body = &self.bodies[self.body_of(joint.ends().0)];
        matches!(body, Body::Beam(Beam { formulation: Formulation::Continuum, .. }))
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
