use std::collections::BTreeSet;

use ancf_mechanics::bodies::BeamMesh;
use ancf_mechanics::constraints::{Measure as Measured, Tie, Wrench};
use ancf_mechanics::kinematics::{Attachment, ElementAxis, Kind, Marker};
use ancf_solver::equations::{EquationsOfMotion, State, System, Term};
use ancf_solver::newton::SolveError;
use nalgebra::Vector3;

use super::freedom::Freedom;
use super::gap_closing::Closed;
use super::inputs::Inputs;
use super::joint_builder::{Holds, JointEquations};
use super::redundant::Redundant;
use crate::model::{
    Beam, Body, Clock, Coupled, Coupling, Formulation, Joint, Model, ModelErrors, Place, Probe, Quantity,
};

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
    bodies: Vec<(String, ancf_mechanics::bodies::Body)>,
    pub(crate) joints: Vec<JointEquations>,
    pub(crate) couplings: Vec<String>,
    pub(crate) redundant: Vec<Redundant>,
    pub(crate) undetermined: BTreeSet<usize>,
    pub(crate) closed: Option<Closed>,
    breaks: Vec<f64>,
    pub(crate) inputs: Inputs,
}

/// One quantity that a probe records.
#[derive(Debug)]
pub struct Measure {
    /// Name of the probe.
    pub name: String,
    /// What it records.
    pub quantity: Quantity,
    /// The point, and the directions there.
    pub place: Attachment,
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

    /// The angles and displacements by which joints move, with the names of the joints.
    pub fn freedoms(&self) -> impl Iterator<Item = (&str, &Freedom)> {
        self.joints
            .iter()
            .flat_map(|joint| joint.freedoms().iter().map(|freedom| (joint.name.as_str(), freedom)))
    }

    /// The bodies and their names.
    pub fn bodies(&self) -> impl Iterator<Item = (&str, &ancf_mechanics::bodies::Body)> {
        self.bodies.iter().map(|(name, body)| (name.as_str(), body))
    }

    /// The body of a number, as [`Measure`] has it.
    pub fn body_of(&self, number: usize) -> &ancf_mechanics::bodies::Body {
        &self.bodies[number].1
    }

    /// Times at which loads and drives or their rates jump, in order: steps are best ended there.
    pub fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    /// The mesh of a flexible body.
    pub fn mesh(&self, body: &str) -> Option<&BeamMesh> {
        self.bodies.iter().find(|(name, _)| name == body).and_then(|(_, body)| body.mesh())
    }

    /// What an equation belongs to, in words: a node of a body, or a joint.
    pub fn name_of(&self, equation: usize) -> String {
        self.name_in(equation, 1.0)
    }

    /// Where an iteration failed, in words, with arc lengths as in [`name_in`](Self::name_in).
    pub(crate) fn place_of(&self, error: &SolveError, length: f64) -> String {
        error.worst.map_or_else(|| "the whole system".into(), |worst| self.name_in(worst, length))
    }

    /// The same, with arc lengths of nodes in units of which a length of the assembly has so many.
    pub(crate) fn name_in(&self, equation: usize, length: f64) -> String {
        let mut first = 0;
        for (name, body) in &self.bodies {
            if let Some((node, kind)) = body.place_of(equation) {
                let axis = ["x", "y", "z"][(equation - first) % 3];
                return match node {
                    Some(node) => {
                        let s = short(length * body.arc_length(node));
                        format!("body `{name}`, node {node} (s = {s}), {} along {axis}", word(kind))
                    }
                    None => format!("body `{name}`, {} along {axis}", director(kind)),
                };
            }
            first += body.coordinates();
        }
        for joint in &self.joints {
            if equation < first + joint.coordinates() {
                return format!("joint `{}`, its freedom", joint.name);
            }
            first += joint.coordinates();
        }
        for (name, body) in &self.bodies {
            if equation < first + body.multipliers() {
                return format!("body `{name}`, what keeps it rigid");
            }
            first += body.multipliers();
        }
        for joint in &self.joints {
            if equation < first + joint.multipliers() {
                return format!("joint `{}`, {}", joint.name, joint.ties()[equation - first]);
            }
            first += joint.multipliers();
        }
        match self.couplings.get(equation.wrapping_sub(first)) {
            Some(name) => format!("coupling `{name}`"),
            None => format!("equation {equation}"),
        }
    }
}

/// At most four digits, without trailing zeros.
fn short(x: f64) -> String {
    format!("{x:.3e}").parse::<f64>().map_or_else(|_| x.to_string(), |x| x.to_string())
}

/// A vector of a node.
const fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Position => "r",
        Kind::Slope => "r_x",
        Kind::Y => "r_y",
        Kind::Z => "r_z",
    }
}

/// A vector of a rigid body.
const fn director(kind: Kind) -> &'static str {
    match kind {
        Kind::Position => "its centre",
        Kind::Slope => "its first director",
        Kind::Y => "its second director",
        Kind::Z => "its third director",
    }
}

impl Model {
    /// Turns a valid model into equations of motion in the model's own numbers.
    ///
    /// # Errors
    /// If the model is not valid, or functions are not supplied.
    pub fn assemble(&self) -> Result<Assembly, ModelErrors> {
        self.assembled(Clock::Runs)
    }

    /// The same for statics: functions of time are 1, so that loads and angles have their full values, times the load factor of
    /// a state.
    ///
    /// # Errors
    /// If the model is not valid, or functions are not supplied.
    pub fn assemble_static(&self) -> Result<Assembly, ModelErrors> {
        self.assembled(Clock::Stands)
    }

    fn assembled(&self, clock: Clock) -> Result<Assembly, ModelErrors> {
        self.check()?;
        self.check_supplies()?;
        let bodies = self.meshes();
        let joints = self.joint_equations(&bodies, clock);
        let (mut terms, mut batches): (Vec<Box<dyn Term>>, Vec<_>) = Default::default();
        for (_, body) in &bodies {
            let first = terms.len();
            batches.extend(body.batches().into_iter().map(|(at, batch)| (first + at, batch)));
            terms.extend(body.terms());
        }
        terms.extend(joints.iter().flat_map(JointEquations::terms));
        terms.extend(self.coupling_terms(&bodies, &joints));
        for load in &self.loads {
            if let Some(place) = load.on() {
                terms.extend(load.term(&self.attachment(&bodies, place), clock, self.length()));
            }
            terms.extend(self.spread_load(load, &bodies, clock));
        }
        let probes = self
            .probes
            .iter()
            .map(|probe| (probe.name.clone(), self.probed(&bodies, probe).2.point))
            .collect();
        let measures = self.probes.iter().flat_map(|probe| {
            let (body, s, place) = self.probed(&bodies, probe);
            probe.record.iter().map(move |&quantity| {
                let (name, place, offset) = (probe.name.clone(), place.clone(), probe.offset);
                Measure { name, quantity, place, body, s, offset }
            })
        });
        let (measures, energy_parts) = (measures.collect(), self.output.energy_parts);
        let [coordinates, multipliers] = Self::numbers(&bodies, &joints);
        let multipliers = multipliers + self.couplings.len();
        let system = System::new(coordinates, multipliers, terms).batched(batches);
        let (breaks, inputs) = (self.breaks(clock), self.inputs(&bodies, clock));
        let couplings = self.couplings.iter().map(|coupling| coupling.name.clone()).collect();
        let (redundant, undetermined, closed) = (Vec::new(), BTreeSet::new(), None);
        let assembly = Assembly {
            system,
            probes,
            measures,
            energy_parts,
            bodies,
            joints,
            couplings,
            redundant,
            undetermined,
            closed,
            breaks,
            inputs,
        };
        let assembly = assembly.sharing();
        let closed = if self.assemble { Some(self.close(&assembly)?) } else { None };
        let mut assembly = Assembly { closed, ..assembly };
        let encounters = self.encounters(&assembly.bodies, &assembly.initial());
        assembly.system = assembly.system.with(encounters);
        Ok(assembly)
    }

    /// Numbers of coordinates and multipliers of bodies and joints.
    pub(crate) fn numbers(
        bodies: &[(String, ancf_mechanics::bodies::Body)],
        joints: &[JointEquations],
    ) -> [usize; 2] {
        let of_bodies = bodies.iter().map(|(_, body)| [body.coordinates(), body.multipliers()]);
        let of_joints = joints.iter().map(|joint| [joint.coordinates(), joint.multipliers()]);
        of_bodies.chain(of_joints).fold([0, 0], |[n, m], [c, l]| [n + c, m + l])
    }

    /// Number of the body, arc length and place of a probe.
    fn probed(
        &self,
        bodies: &[(String, ancf_mechanics::bodies::Body)],
        probe: &Probe,
    ) -> (usize, f64, Attachment) {
        let index = self.body_of(&probe.on);
        let (s, [y, z]) = (self.bodies[index].arc_length(probe.on.at), probe.offset);
        let place = self.attachment(bodies, &probe.on);
        let point = match (place.axes(), &bodies[index].1) {
            (Some([_, d, e]), ancf_mechanics::bodies::Body::Flexible(_)) => {
                Marker::combined([(1.0, &place.point), (y, d), (z, e)])
            }
            _ => place.point.clone(),
        };
        (index, s, Attachment { point, ..place })
    }

    /// Breaks of all functions of time, in order.
    pub(crate) fn breaks(&self, clock: Clock) -> Vec<f64> {
        let functions = self.time_functions().into_iter();
        let mut breaks: Vec<f64> = functions.flat_map(|(_, time)| clock.function(time).breaks()).collect();
        breaks.sort_unstable_by(f64::total_cmp);
        breaks.dedup();
        breaks
    }

    /// Number of the body of a place.
    fn body_of(&self, place: &Place) -> usize {
        let index = self.bodies.iter().position(|body| body.name() == place.body);
        index.expect("a checked model names bodies that are there")
    }

    /// What a place holds on to.
    pub(crate) fn attachment(
        &self,
        bodies: &[(String, ancf_mechanics::bodies::Body)],
        place: &Place,
    ) -> Attachment {
        let index = self.body_of(place);
        let body = &self.bodies[index];
        let point = body.point(place.at).expect("a checked place is on its body");
        let attachment = bodies[index].1.attachment(body.arc_length(place.at), point);
        if place.offset == [0.0; 3] { attachment } else { attachment.offset(Vector3::from(place.offset)) }
    }

    /// The equations of the joints, multipliers counted on from the bodies' and from joint to joint.
    pub(crate) fn joint_equations(
        &self,
        bodies: &[(String, ancf_mechanics::bodies::Body)],
        clock: Clock,
    ) -> Vec<JointEquations> {
        let mut first = Self::numbers(bodies, &[]);
        let held = Held { model: self, bodies };
        let equations = self.joints.iter().enumerate().map(|(number, joint)| {
            let (locking, coupled) = (self.is_locking(joint), |freed| self.is_coupled(number, freed));
            let equations = JointEquations::new(joint, locking, first, clock, coupled, &held);
            first = [first[0] + equations.coordinates(), first[1] + equations.multipliers()];
            equations.with_gap(self.gap(joint))
        });
        equations.collect()
    }

    /// The equations of the couplings, by multipliers after those of the joints.
    pub(crate) fn coupling_terms(
        &self,
        bodies: &[(String, ancf_mechanics::bodies::Body)],
        joints: &[JointEquations],
    ) -> Vec<Box<dyn Term>> {
        let [_, first] = Self::numbers(bodies, joints);
        let part = |measure: Measured, part: &Coupled| {
            let (joint, freed) = self.coupled(part)?;
            let coordinate = joints[joint].freedoms().iter().find_map(|freedom| freedom.coupled(freed))?;
            Some(measure.plus(coordinate, part.factor))
        };
        let tie = |(k, coupling): (usize, &Coupling)| {
            let measure = coupling.joints.iter().try_fold(Measured::default(), part);
            let measure = measure.expect("a checked coupling names freedoms that are there");
            Box::new(Tie::new(measure, first + k).named("coupling")) as Box<dyn Term>
        };
        self.couplings.iter().enumerate().map(tie).collect()
    }

    /// Whether the first end of a joint is on a beam of the continuum formulation.
    fn is_locking(&self, joint: &Joint) -> bool {
        let body = &self.bodies[self.body_of(joint.ends().0)];
        matches!(body, Body::Beam(Beam { formulation: Formulation::Continuum, .. }))
    }
}

/// The bodies of a model, for its joints to hold on to.
struct Held<'a> {
    model: &'a Model,
    bodies: &'a [(String, ancf_mechanics::bodies::Body)],
}

impl Holds for Held<'_> {
    fn attachment(&self, place: &Place) -> Attachment {
        self.model.attachment(self.bodies, place)
    }

    fn beam(&self, place: &Place) -> Option<(Vec<ElementAxis>, f64)> {
        let index = self.model.body_of(place);
        let axes = self.bodies[index].1.mesh()?.element_axes().collect();
        Some((axes, self.model.bodies[index].arc_length(place.at)))
    }
}
