use nalgebra::Vector3;

use super::{Beam, Clamped, End, Joint, Load, Model, ModelErrors, Place};
use crate::mechanics::{BeamMesh, BeamShape, Coincide, Force, Marker, Perpendicular, Profile, Wrench};
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
    pub(super) fn bodies(&self) -> impl Iterator<Item = (&str, &BeamMesh)> {
        self.bodies.iter().map(|(name, mesh)| (name.as_str(), mesh))
    }

    /// The mesh of a body.
    pub fn mesh(&self, body: &str) -> Option<&BeamMesh> {
        self.bodies.iter().find(|(name, _)| name == body).map(|(_, mesh)| mesh)
    }

    /// What an equation belongs to, in words: a node of a body, or a joint.
    pub fn name_of(&self, equation: usize) -> String {
        let mut first = 0;
        for (name, mesh) in &self.bodies {
            if equation < first + mesh.coordinates() {
                let (node, coordinate) =
                    ((equation - first) / BeamMesh::NODE, (equation - first) % BeamMesh::NODE);
                let vector = ["r", "r_x", "r_y", "r_z"][coordinate / 3];
                return format!(
                    "body `{name}`, node {node}, {vector} along {}",
                    ["x", "y", "z"][coordinate % 3]
                );
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
            terms.extend(mesh.elements().map(|element| Box::new(element) as Box<dyn Term>));
        }
        terms.extend(joints.iter().flat_map(JointEquations::terms));
        for Load::Force { on, force } in &self.loads {
            terms.push(Box::new(Force::new(&point(on), Vector3::from(*force))));
        }
        let probes = self.probes.iter().map(|probe| (probe.name.clone(), point(&probe.on))).collect();
        let coordinates = bodies.iter().map(|(_, mesh)| mesh.coordinates()).sum();
        let multipliers = joints.iter().map(JointEquations::multipliers).sum();
        Ok(Assembly { system: System::new(coordinates, multipliers, terms), probes, bodies, joints })
    }

    /// The mesh and the arc length of a place.
    fn locate<'a>(&self, meshes: &'a [(String, BeamMesh)], place: &Place) -> (&'a BeamMesh, f64) {
        let index = self.bodies.iter().position(|body| body.name() == place.body);
        let index = index.expect("a checked model names bodies that are there");
        (&meshes[index].1, self.bodies[index].beam().arc_length(place.at))
    }

    /// The equations of the joints, multipliers counted on from joint to joint.
    pub(super) fn joint_equations(&self, meshes: &[(String, BeamMesh)]) -> Vec<JointEquations> {
        let mut first = 0;
        let equations = self.joints.iter().map(|joint| {
            let equations = equations(joint, first, &|place| self.locate(meshes, place));
            first += equations.multipliers();
            equations
        });
        equations.collect()
    }

    /// The meshes of the bodies, coordinates counted on from body to body.
    pub(super) fn meshes(&self) -> Vec<(String, BeamMesh)> {
        let mut first = 0;
        let meshes = self.bodies.iter().map(|body| {
            let mesh = self.mesh(body.beam(), first);
            first += mesh.coordinates();
            (body.name().to_owned(), mesh)
        });
        meshes.collect()
    }

    fn mesh(&self, beam: &Beam, first: usize) -> BeamMesh {
        let (material, section) = (&self.materials[&beam.material], &self.sections[&beam.section]);
        let shape = BeamShape { length: beam.element_length(), slope: beam.slope_length() };
        let gravity = Vector3::from(self.gravity);
        let profile = Profile::new(shape, material.lame(), material.density, section.moments(), gravity);
        let frame = beam.frame().expect("a checked beam has a length and a direction `up`");
        BeamMesh::new(first, beam.elements as usize, Vector3::from(beam.from), frame, profile)
    }
}

/// A joint as equations between markers, by multipliers from `first` on.
fn equations<'a>(
    joint: &Joint,
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
    let mut equations = JointEquations {
        name: joint.name().to_owned(),
        coincide: vec![Coincide::points(&point, &opposite, first)],
        ..JointEquations::default()
    };
    match joint {
        Joint::Spherical { .. } => {}
        Joint::Clamp { fix, .. } => {
            let tied = match fix {
                Clamped::All => mesh.frame().as_slice(),
                Clamped::Section => &mesh.frame()[1..],
            };
            for &direction in tied {
                let multipliers = first + equations.multipliers();
                let tie = Coincide::directions(&mesh.direction(s, direction), &other(direction), multipliers);
                equations.coincide.push(tie);
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
