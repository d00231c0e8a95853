//! Reduction of a model with a finding to a small one.

use ancf::Model;
use ancf::model::{Analysis, Body, Joint, Load, Shape, Step, TimeFunction};

use crate::compare::{Case, Finding};
use crate::hunt::random_of;
use crate::laws::{Check, LAWS};

/// Maximum number of attempts.
const ATTEMPTS: usize = 400;

/// Finding of a law for a model, with the random numbers of a case of a hunt.
pub fn find(model: &Model, law: &str, seed: u64, number: u64) -> Option<Finding> {
    let law = LAWS.iter().find(|known| known.name() == law)?;
    let mut random = random_of(law.name(), seed, number);
    // As in a hunt, the first number is the choice of the law.
    let _ = random.unit();
    match law.check(&Case::new(model.clone()), &mut random) {
        Check::Violated(finding) => Some(finding),
        Check::Holds | Check::Explained(_) | Check::Inapplicable => None,
    }
}

/// Removes parts of a model and simplifies others while it violates the law in the same way: by its verdict, or by its values.
pub fn shrink(model: &Model, found: &Finding, seed: u64, number: u64) -> Model {
    let mut small = model.clone();
    let is_verdict = found.quantity == "verdict";
    let fails = |model: &Model| {
        find(model, found.law, seed, number).is_some_and(|other| (other.quantity == "verdict") == is_verdict)
    };
    let mut left = ATTEMPTS;
    loop {
        let smaller = reductions(&small).into_iter().find(|candidate| {
            left = left.saturating_sub(1);
            left > 0 && *candidate != small && fails(candidate)
        });
        match smaller {
            Some(model) => small = model,
            None => return small,
        }
    }
}

/// Smaller models, in the order of attempts.
fn reductions(model: &Model) -> Vec<Model> {
    let mut all = Vec::new();
    let mut add = |change: &dyn Fn(&mut Model)| {
        let mut other = model.clone();
        change(&mut other);
        all.push(other);
    };
    for body in &model.bodies {
        add(&|model| without_body(model, body.name()));
    }
    for i in 0..model.loads.len() {
        add(&|model| _ = model.loads.remove(i));
    }
    for i in 0..model.joints.len() {
        add(&|model| without_joint(model, i));
    }
    for i in 0..model.contacts.len() {
        add(&|model| _ = model.contacts.remove(i));
    }
    for i in 0..model.couplings.len() {
        add(&|model| _ = model.couplings.remove(i));
    }
    for i in 0..model.probes.len() {
        add(&|model| _ = model.probes.remove(i));
    }
    add(&|model| model.gravity = [0.0; 3]);
    add(&shorten);
    for i in 0..model.bodies.len() {
        for change in BODY_CHANGES {
            add(&|model| change(&mut model.bodies[i]));
        }
    }
    add(&|model| model.materials.values_mut().for_each(|material| material.damping = Default::default()));
    add(&|model| model.materials.values_mut().for_each(|material| material.poisson = 0.0));
    for i in 0..model.joints.len() {
        add(&|model| plain(&mut model.joints[i]));
    }
    for i in 0..model.loads.len() {
        add(&|model| constant(&mut model.loads[i]));
    }
    all
}

const BODY_CHANGES: [fn(&mut Body); 6] = [
    |body| {
        if let Body::Beam(beam) = body {
            beam.elements = beam.elements.div_ceil(2);
        }
    },
    |body| {
        if let Body::Beam(beam) = body {
            beam.twist = 0.0;
        }
    },
    |body| {
        if let Body::Beam(beam) = body {
            beam.shape = Shape::Straight;
        }
    },
    |body| {
        if let Body::Beam(beam) = body {
            beam.section_end = None;
        }
    },
    |body| match body {
        Body::Beam(beam) => beam.up = None,
        Body::Cable(cable) => cable.up = None,
        Body::Shell(_) | Body::ShearShell(_) | Body::Rigid(_) | Body::Mass(_) => {}
    },
    |body| match body {
        Body::Beam(beam) => beam.motion = Default::default(),
        Body::Cable(cable) => cable.motion = Default::default(),
        Body::Shell(shell) => shell.motion = Default::default(),
        Body::ShearShell(shell) => shell.motion = Default::default(),
        Body::Rigid(rigid) => (rigid.motion, rigid.products) = Default::default(),
        Body::Mass(mass) => mass.motion = Default::default(),
    },
];

fn without_body(model: &mut Model, name: &str) {
    let is_of = |joint: &Joint| {
        let (a, b) = joint.ends();
        a.body == name || matches!(b, ancf::model::End::Place(place) if place.body == name)
    };
    let gone: Vec<String> =
        model.joints.iter().filter(|joint| is_of(joint)).map(|joint| joint.name().to_owned()).collect();
    model.joints.retain(|joint| !is_of(joint));
    model.couplings.retain(|coupling| !coupling.joints.iter().any(|part| gone.contains(&part.joint)));
    model.bodies.retain(|body| body.name() != name);
    model.probes.retain(|probe| probe.on.body != name);
    model.loads.retain(|load| match load {
        Load::DistributedForce(line) => line.body != name,
        Load::DistributedMoment(line) => line.body != name,
        Load::Prestrain(prestrain) => prestrain.body != name,
        Load::SurfacePrestrain(prestrain) => prestrain.body != name,
        Load::SurfaceForce(surface) => surface.body != name,
        Load::SurfacePressure(surface) => surface.body != name,
        Load::Gas(gas) => !gas.surfaces.iter().any(|surface| surface.body == name),
        Load::SurfaceFluid(surface) => surface.body != name,
        Load::Fluid(fluid) => !fluid.bodies.iter().any(|body| body == name),
        other => other.on().is_none_or(|place| place.body != name),
    });
}

fn without_joint(model: &mut Model, i: usize) {
    let gone = model.joints.remove(i);
    model.couplings.retain(|coupling| !coupling.joints.iter().any(|part| part.joint == gone.name()));
}

fn shorten(model: &mut Model) {
    if let Analysis::Dynamics(dynamics) = &mut model.analysis
        && let Step::Fixed(step) = dynamics.step
    {
        dynamics.duration = (0.5 * dynamics.duration).max(4.0 * step);
    }
}

/// Removes springs, friction and drives of a joint.
fn plain(joint: &mut Joint) {
    match joint {
        Joint::Revolute(joint) => (joint.spring, joint.friction, joint.drive) = (None, None, None),
        Joint::Prismatic(joint) => (joint.spring, joint.friction, joint.drive) = (None, None, None),
        Joint::Slide(joint) => (joint.spring, joint.friction, joint.drive) = (None, None, None),
        Joint::Cylindrical(joint) => {
            (joint.spring, joint.drive, joint.feed, joint.friction) = (None, None, None, None);
        }
        Joint::Spherical(joint) => joint.friction = None,
        Joint::Universal(joint) => joint.friction = None,
        Joint::Planar(joint) => joint.friction = None,
        Joint::PointOnLine(joint) => joint.friction = None,
        _ => {}
    }
}

fn constant(load: &mut Load) {
    match load {
        Load::Force(load) => (load.time, load.on.offset) = (TimeFunction::default(), [0.0; 3]),
        Load::Moment(load) => load.time = TimeFunction::default(),
        Load::DistributedForce(load) => (load.time, load.force_end) = (TimeFunction::default(), None),
        Load::DistributedMoment(load) => (load.time, load.moment_end) = (TimeFunction::default(), None),
        Load::Prestrain(load) => {
            (load.time, load.strain_end, load.curvature_end) = (TimeFunction::default(), None, None);
        }
        Load::SurfacePrestrain(load) => load.time = TimeFunction::default(),
        _ => {}
    }
}
