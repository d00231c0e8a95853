//! Queries on a model: derived quantities, and components with the paths of their keys.

use std::borrow::Cow;

use ancf_mechanics::contact::ObstacleShape;
use ancf_mechanics::functions::{Function, InputSignal};
use ancf_mechanics::shells::{Laminate, Ply};

use crate::joints::Joint;
use crate::loads::Load;
use crate::model::bodies::{Beam, Body, Layup, PointMass, Rigid, ShearShell, Shell};
use crate::model::contacts::{Contact, ObstacleKind};
use crate::model::functions::{JointLaw, LawUse, TimeFunction, TimeMode, Varying};
use crate::model::sections::Section;
use crate::model::{Analysis, Model, Origin};

impl Model {
    /// True if the program added joints, loads or sections of kinds that model files do not have.
    pub fn is_extended(&self) -> bool {
        self.joints.iter().any(|joint| matches!(joint, Joint::Custom(_)))
            || self.loads.iter().any(|load| matches!(load, Load::Custom(_)))
            || self.sections.values().any(|section| matches!(section, Section::Custom(_)))
    }

    /// True if a body is a shell.
    pub fn has_shells(&self) -> bool {
        self.bodies.iter().any(Body::is_shell)
    }

    /// Time at the end of a motion; 0 of other analyses.
    pub(crate) fn end_time(&self) -> f64 {
        self.analysis.dynamics().map_or(0.0, |dynamics| self.initial.start_time + dynamics.duration)
    }

    /// Total mass of all bodies.
    pub fn mass(&self) -> f64 {
        let mass = |body: &Body| match body {
            Body::Rigid(Rigid { mass, .. }) | Body::Mass(PointMass { mass, .. }) => *mass,
            Body::Beam(_) | Body::Cable(_) => self.line_mass(body),
            Body::Shell(_) | Body::ShearShell(_) => {
                body.layup().map_or(0.0, |layup| self.laminate(layup).section().density * body.area())
            }
        };
        self.bodies.iter().map(mass).sum()
    }

    /// Layers of a shell of a valid model.
    pub fn laminate(&self, layup: Layup<'_>) -> Laminate {
        let ply = |(material, thickness, angle): (&str, f64, f64)| {
            let material = &self.materials[material];
            Ply { elasticity: material.ply(), density: material.density, thickness, angle }
        };
        Laminate::new(layup.plies().into_iter().map(ply).collect())
    }

    /// Mass of a flexible body. Simpson's rule is exact, since areas are at most quadratic along the axis.
    fn line_mass(&self, body: &Body) -> f64 {
        let Some((_, material)) = body.section_and_material() else { return 0.0 };
        let area = |part| self.section_at(body, part).map_or(0.0, |section| section.moments().area);
        let mean = (area(0.0) + 4.0 * area(0.5) + area(1.0)) / 6.0;
        self.materials[material].density * mean * body.length()
    }

    /// Mass per length ρA and smaller bending stiffness E I of a flexible body.
    pub(crate) fn line_properties(&self, body: &Body) -> (f64, f64) {
        let Some((section, material)) = body.section_and_material() else { return (0.0, 0.0) };
        let (material, section) = (&self.materials[material], self.sections[section].moments());
        (material.density * section.area, material.young * section.yy.min(section.zz))
    }

    /// Section of a flexible body of a valid model at a fraction of its length, from 0 to 1.
    pub fn section_at(&self, body: &Body, part: f64) -> Option<Section> {
        let start = &self.sections[body.section_and_material()?.0];
        match body {
            Body::Beam(Beam { section_end: Some(end), .. }) => start.towards(&self.sections[end], part),
            _ => Some(start.clone()),
        }
    }

    /// Gradient of the warping function of a section of a flexible body at an arc length and at (y, z) of the section.
    pub(crate) fn warping_gradient(&self, body: &Body, s: f64, at: [f64; 2]) -> [f64; 2] {
        if at == [0.0; 2] {
            // Sections are symmetric about both axes.
            return at;
        }
        let part = (s / body.length()).clamp(0.0, 1.0);
        self.section_at(body, part).map_or([0.0; 2], |section| section.shape().warping_gradient(at))
    }

    /// Treatment of functions of time in the analysis of the model.
    pub(crate) const fn time_mode(&self) -> TimeMode {
        if self.analysis.dynamics().is_some() { TimeMode::AsGiven } else { TimeMode::One }
    }

    /// Interval of the recorded rows, at least 1: `output.every`, and 1 for modes, critical loads and points of paths, which are all
    /// recorded.
    pub fn row_interval(&self) -> u32 {
        match self.analysis {
            Analysis::Modes(_) | Analysis::Buckling(_) | Analysis::Path(_) => 1,
            Analysis::Dynamics(_) | Analysis::Statics(_) => self.output.every.max(1),
        }
    }

    /// True if the analysis is a motion from the undeformed state, where drives are zero and points of joints coincide.
    pub(crate) fn starts_undeformed(&self) -> bool {
        self.analysis.dynamics().is_some() && self.initial.from == Origin::Undeformed
    }

    /// Results folder in whose state the analysis starts.
    pub fn starts_from(&self) -> Option<&str> {
        if let Origin::Folder(folder) = &self.initial.from { Some(folder) } else { None }
    }

    /// True if the model has external functions of time that are supplied, or that are not yet supplied.
    pub(crate) fn has_external_functions(&self, are_supplied: bool) -> bool {
        let is_meant = |time: &TimeFunction| match time {
            TimeFunction::Varying(Varying::External { supplied, .. }) => supplied.is_some() == are_supplied,
            _ => false,
        };
        self.time_functions().iter().any(|(_, time)| is_meant(time))
    }

    /// Creates a signal for each input and connects the functions of time with it. Returns the signals in the order of the inputs.
    pub(crate) fn connect_inputs(&mut self) -> Vec<InputSignal> {
        let signals: Vec<_> = self.inputs.iter().map(|input| InputSignal::new(input.value)).collect();
        let names: Vec<String> = self.inputs.iter().map(|input| input.name.clone()).collect();
        for law in self.joints.iter_mut().flat_map(|joint| joint.kind_mut().laws_mut()) {
            if let JointLaw::Expression { inputs, .. } = law {
                *inputs = names.iter().cloned().zip(signals.iter().cloned()).collect();
            }
        }
        for time in self.time_functions_mut() {
            if let TimeFunction::Varying(Varying::Input { name, signal }) = time {
                let number = names.iter().position(|own| own == name);
                *signal = number.map(|number| signals[number].clone());
            }
        }
        signals
    }

    /// Model with signals of its inputs, as [`connect_inputs`](Self::connect_inputs) connects them.
    pub(crate) fn with_signals(&self) -> Cow<'_, Self> {
        if self.inputs.is_empty() {
            return Cow::Borrowed(self);
        }
        let mut connected = self.clone();
        connected.connect_inputs();
        Cow::Owned(connected)
    }

    /// Functions of time with their paths.
    pub(crate) fn time_functions(&self) -> Vec<(String, &TimeFunction)> {
        let of_loads =
            loads_of(self).filter_map(|(path, load)| load.time().map(|time| (format!("{path}.time"), time)));
        let of_joints = joints_of(self).flat_map(|(path, joint)| {
            let times = joint.times().into_iter();
            times.map(|(table, time)| (format!("{path}{table}.time"), time)).collect::<Vec<_>>()
        });
        of_loads.chain(of_joints).collect()
    }

    /// Force laws of joints with their paths.
    pub(crate) fn laws(&self) -> impl Iterator<Item = (String, LawUse<'_>)> {
        joints_of(self).flat_map(|(path, joint)| {
            let laws = joint.kind().laws().into_iter();
            laws.map(move |one| (format!("{path}.{}", one.key), one))
        })
    }

    /// Force laws whose formulas contain the time, as functions of the time alone, with their paths. Inputs must be
    /// [connected](Self::connect_inputs).
    pub(crate) fn laws_of_time(&self) -> impl Iterator<Item = (String, Function)> {
        self.laws().filter_map(|(path, one)| {
            let law = one.law.expression(one.kind, 1.0, &[]).ok()??;
            Some((path, law.function_of_time()?))
        })
    }

    /// Mutable functions of time.
    pub(crate) fn time_functions_mut(&mut self) -> impl Iterator<Item = &mut TimeFunction> {
        let of_loads = self.loads.iter_mut().filter_map(|load| load.kind_mut().time_mut());
        of_loads.chain(self.joints.iter_mut().flat_map(|joint| joint.kind_mut().times_mut()))
    }
}

/// Smallest and largest default number of contact points per element.
const POINTS: [f64; 2] = [4.0, 1e4];

impl Contact {
    /// Numbers of the bodies in contact.
    pub(crate) fn bodies(&self, model: &Model) -> Vec<usize> {
        let carrier = self.with.on().map(|place| place.body.as_str());
        let is_meant = |name: &str| match self.bodies.is_empty() {
            true => Some(name) != carrier,
            false => self.bodies.iter().any(|body| body == name),
        };
        (0..model.bodies.len())
            .filter(|&i| self.touches(&model.bodies[i]) && is_meant(model.bodies[i].name()))
            .collect()
    }

    /// True for beams, cables and shells, and for bodies with a surface if the partner is an obstacle.
    pub(crate) fn touches(&self, body: &Body) -> bool {
        body.is_flexible() || body.is_shell() || (body.surface().is_some() && self.with.obstacle().is_some())
    }

    /// Contact radius of a flexible body: as given, or the outer radius of a round, constant section.
    pub(crate) fn radius(&self, model: &Model, body: &Body) -> Option<f64> {
        let tapered = matches!(body, Body::Beam(Beam { section_end: Some(_), .. }));
        let own = || {
            model.sections.get(body.section_and_material()?.0).filter(|_| !tapered)?.shape().outer_radius()
        };
        self.radius.or_else(own)
    }

    /// Number of contact points per element of a body with a radius, of a shell in each direction.
    pub(crate) fn points(&self, length: f64, radius: f64, is_shell: bool) -> usize {
        let spacing = match self.with.obstacle().map(ObstacleKind::shape) {
            None if is_shell => f64::INFINITY,
            Some(ObstacleShape::Plane) => f64::INFINITY,
            Some(ObstacleShape::Sphere { radius: r, .. } | ObstacleShape::Cylinder { radius: r, .. }) => {
                0.25 * (r + radius)
            }
            None => 0.5 * radius,
        };
        self.points.map_or_else(
            || (length / spacing).ceil().clamp(POINTS[0], POINTS[1]) as usize,
            |points| points as usize,
        )
    }
}

/// Loads with their paths.
pub(crate) fn loads_of(model: &Model) -> impl Iterator<Item = (String, &Load)> {
    model.loads.iter().enumerate().map(|(i, load)| (format!("loads[{i}]"), load))
}

/// Bodies with their paths.
pub(crate) fn bodies_of(model: &Model) -> impl Iterator<Item = (String, &Body)> {
    model.bodies.iter().enumerate().map(|(i, body)| (format!("bodies[{i}]"), body))
}

/// Beams with their paths.
pub(crate) fn beams_of(model: &Model) -> impl Iterator<Item = (String, &Beam)> {
    bodies_of(model)
        .filter_map(|(path, body)| if let Body::Beam(beam) = body { Some((path, beam)) } else { None })
}

/// Thin shells with their paths.
pub(crate) fn shells_of(model: &Model) -> impl Iterator<Item = (String, &Shell)> {
    bodies_of(model)
        .filter_map(|(path, body)| if let Body::Shell(shell) = body { Some((path, shell)) } else { None })
}

/// Shear-deformable shells with their paths.
pub(crate) fn shear_shells_of(model: &Model) -> impl Iterator<Item = (String, &ShearShell)> {
    bodies_of(model).filter_map(
        |(path, body)| {
            if let Body::ShearShell(shell) = body { Some((path, shell)) } else { None }
        },
    )
}

/// Joints with their paths.
pub(crate) fn joints_of(model: &Model) -> impl Iterator<Item = (String, &Joint)> {
    model.joints.iter().enumerate().map(|(i, joint)| (format!("joints[{i}]"), joint))
}
