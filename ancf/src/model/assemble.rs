use nalgebra::Vector3;

use super::function::Clock;
use super::{
    Beam, Body, Clamped, End, Formulation, Ground, Joint, Load, MaterialLaw, Model, ModelErrors, Place,
};
use crate::mechanics::{
    self, BeamMesh, Blueprint, Coincide, CrossSection, Drive, Kind, Marker, Medium, Perpendicular, Wrench,
};
use crate::system::{EquationsOfMotion, State, System, Term};

/// A model as equations of motion, with what is needed to read their solution.
#[derive(Debug)]
pub struct Assembly {
    /// The equations of motion.
    pub system: System,
    /// Names and points of the probes.
    pub probes: Vec<(String, Marker)>,
    bodies: Vec<(String, BeamMesh)>,
    joints: Vec<JointEquations>,
    breaks: Vec<f64>,
}

/// The equations of one joint.
#[derive(Debug, Default)]
pub(super) struct JointEquations {
    name: String,
    coincide: Vec<Coincide>,
    perpendicular: Vec<Perpendicular>,
    drives: Vec<Drive>,
}

impl JointEquations {
    /// Number of multipliers.
    fn multipliers(&self) -> usize {
        3 * self.coincide.len() + self.perpendicular.len() + 3 * self.drives.len()
    }

    pub(super) fn terms(&self) -> impl Iterator<Item = Box<dyn Term>> {
        let coincide = self.coincide.iter().cloned().map(|c| Box::new(c) as Box<dyn Term>);
        let perpendicular = self.perpendicular.iter().cloned().map(|c| Box::new(c) as Box<dyn Term>);
        let drives = self.drives.iter().cloned().map(|c| Box::new(c) as Box<dyn Term>);
        coincide.chain(perpendicular).chain(drives)
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
            let drives = joint.drives.iter().map(|c| c.reaction(s));
            coincide.chain(perpendicular).chain(drives).fold(Wrench::default(), |sum, part| Wrench {
                force: sum.force + part.force,
                moment: sum.moment + part.moment,
            })
        })
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
        let point = |place| {
            let (mesh, s) = self.locate(&bodies, place);
            mesh.point(s)
        };
        let mut terms: Vec<Box<dyn Term>> = Vec::new();
        for (_, mesh) in &bodies {
            terms.extend(mesh.terms());
        }
        terms.extend(joints.iter().flat_map(JointEquations::terms));
        for load in &self.loads {
            let (mesh, s) = self.locate(&bodies, load.on());
            terms.push(load.term(mesh, s, clock));
        }
        let probes = self.probes.iter().map(|probe| (probe.name.clone(), point(&probe.on))).collect();
        let coordinates = bodies.iter().map(|(_, mesh)| mesh.coordinates()).sum();
        let multipliers = joints.iter().map(JointEquations::multipliers).sum();
        let (system, breaks) = (System::new(coordinates, multipliers, terms), self.breaks(clock));
        Ok(Assembly { system, probes, bodies, joints, breaks })
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

    /// The mesh and the arc length of a place.
    fn locate<'a>(&self, meshes: &'a [(String, BeamMesh)], place: &Place) -> (&'a BeamMesh, f64) {
        let index = self.bodies.iter().position(|body| body.name() == place.body);
        let index = index.expect("a checked model names bodies that are there");
        (&meshes[index].1, self.bodies[index].arc_length(place.at))
    }

    /// The equations of the joints, multipliers counted on from joint to joint.
    pub(super) fn joint_equations(&self, meshes: &[(String, BeamMesh)], clock: Clock) -> Vec<JointEquations> {
        let mut first = 0;
        let equations = self.joints.iter().map(|joint| {
            let equations = equations(joint, first, clock, &|place| self.locate(meshes, place));
            first += equations.multipliers();
            equations
        });
        equations.collect()
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
            Body::Cable(_) => todo!("cable"),
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

impl Clamped {
    /// Which of the directors r_x, r_y, r_z are tied.
    fn of(self, axes: &[Vector3<f64>; 3]) -> &[Vector3<f64>] {
        match self {
            Self::All => axes,
            Self::Section => &axes[1..],
        }
    }
}

/// A joint as equations between markers, by multipliers from `first` on.
fn equations<'a>(
    joint: &Joint,
    first: usize,
    clock: Clock,
    find: &impl Fn(&Place) -> (&'a BeamMesh, f64),
) -> JointEquations {
    let (a, b) = joint.ends();
    let (mesh, s) = find(a);
    let other = |direction: Vector3<f64>| match b {
        End::Ground | End::Point(_) => Marker::fixed(direction),
        End::Place(place) => {
            let (mesh, s) = find(place);
            mesh.direction(s, direction)
        }
    };
    let point = mesh.point(s);
    let place = match b {
        End::Ground => Coincide::points(&point, &Marker::fixed(point.reference()), first),
        End::Point(Ground { point: target }) => Coincide::toward(&point, Vector3::from(*target), first),
        End::Place(place) => {
            let (mesh, s) = find(place);
            Coincide::points(&point, &mesh.point(s), first)
        }
    };
    let mut equations =
        JointEquations { name: joint.name().to_owned(), coincide: vec![place], ..JointEquations::default() };
    match joint {
        Joint::Spherical { .. } => {}
        Joint::Clamp { fix, .. } => {
            for &direction in fix.of(&mesh.reference_axes(s)) {
                let multipliers = first + equations.multipliers();
                let tie = Coincide::directions(&mesh.direction(s, direction), &other(direction), multipliers);
                equations.coincide.push(tie);
            }
        }
        Joint::Drive { axis, angle, time, fix, .. } => {
            let (axis, function) = (Vector3::from(*axis).normalize(), clock.function(time));
            for &direction in fix.of(&mesh.reference_axes(s)) {
                let (multipliers, a) = (first + equations.multipliers(), mesh.direction(s, direction));
                equations.drives.push(Drive::new(&a, axis, *angle, function.clone(), multipliers));
            }
        }
        Joint::Revolute { axis, .. } => {
            let axis = Vector3::from(*axis).normalize();
            for normal in normals(axis) {
                let multiplier = first + equations.multipliers();
                let tie = Perpendicular::new(&mesh.direction(s, axis), &other(normal), multiplier);
                equations.perpendicular.push(tie);
            }
        }
    }
    equations
}

/// Two unit vectors normal to a unit vector and to each other; the global axes where they fit.
fn normals(axis: Vector3<f64>) -> [Vector3<f64>; 2] {
    let least = axis.iamin();
    let guide = Vector3::from_fn(|i, _| if i == least { 1.0 } else { 0.0 });
    let first = (guide - axis * axis.dot(&guide)).normalize();
    [first, axis.cross(&first)]
}
