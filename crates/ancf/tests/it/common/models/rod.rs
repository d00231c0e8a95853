//! The beam of Kim et al. (2017) in Rust: one metre of steel rod, straight along x, under gravity along −y.
//!
//! Table 2 prints a diameter of 0.20 m and no Poisson ratio; 0.02 m and ν = 0 are what its results belong to.

use ancf::Model;
use ancf::model::{
    Analysis, At, Beam, Body, Clamped, Dynamics, End, Joint, Material, Named, NewtonMethod, Output, Place,
    Probe, ScaleChoice, Scheme, Section, Start, Step, Stop,
};

/// Length L.
pub(crate) const LENGTH: f64 = 1.0;
/// Acceleration of gravity.
pub(crate) const GRAVITY: f64 = 9.81;

/// The rod without any joint, two seconds in steps of a millisecond as the paper has it, and a probe at its end.
pub(crate) fn free(elements: u32) -> Model {
    let beam = Beam::straight("rod", [[0.0; 3], [LENGTH, 0.0, 0.0]], elements, "circle", "steel");
    let steel = Material::elastic(8030.0, 193e9, 0.0);
    Model {
        title: None,
        units: None,
        gravity: [0.0, -GRAVITY, 0.0],
        materials: [("steel".into(), steel)].into(),
        sections: [("circle".into(), Section::Circle { diameter: 0.02 })].into(),
        bodies: vec![Body::Beam(beam)],
        joints: Vec::new(),
        couplings: Vec::new(),
        loads: Vec::new(),
        assemble: false,
        contacts: Vec::new(),
        scales: ScaleChoice::None,
        analysis: Analysis::Dynamics(Dynamics {
            duration: 2.0,
            step: Step::Fixed(1e-3),
            scheme: Scheme::Adams,
            start: Start::Zero,
            stop: Stop::default(),
            newton: NewtonMethod::Modified,
            max_iterations: 50,
            max_halvings: 0,
        }),
        probes: vec![Probe::of_motion("tip", end())],
        output: Output::default(),
    }
}

/// Clamped at its start, all twelve coordinates of the node.
pub(crate) fn cantilever(elements: u32) -> Model {
    clamped(elements, Clamped::All)
}

/// Clamped at its start in one way or the other.
pub(crate) fn clamped(elements: u32, fix: Clamped) -> Model {
    let clamp = Joint::Clamp { name: "root".into(), a: start(), b: End::Ground, fix: Some(fix) };
    Model { joints: vec![clamp], ..free(elements) }
}

/// Hinged at its start about z.
pub(crate) fn revolute(elements: u32) -> Model {
    let hinge = Joint::Revolute {
        name: "root".into(),
        a: start(),
        b: End::Ground,
        axis: [0.0, 0.0, 1.0],
        drive: None,
        spring: None,
        friction: None,
    };
    Model { joints: vec![hinge], ..free(elements) }
}

/// Hung by a ball at its start, a thousand times softer, under gravity along −y and along −z.
pub(crate) fn spherical(elements: u32) -> Model {
    let ball = Joint::Spherical { name: "root".into(), a: start(), b: End::Ground };
    let mut model = Model { joints: vec![ball], gravity: [0.0, -GRAVITY, -GRAVITY], ..free(elements) };
    material(&mut model).young /= 1000.0;
    model
}

/// The start of the rod.
pub(crate) fn start() -> Place {
    Place::new("rod", At::Named(Named::Start))
}

/// The end of the rod.
pub(crate) fn end() -> Place {
    Place::new("rod", At::Named(Named::End))
}

/// The first body.
pub(crate) fn beam(model: &mut Model) -> &mut Beam {
    match &mut model.bodies[0] {
        Body::Beam(beam) => beam,
        _ => panic!("the rod is a beam"),
    }
}

/// The only material.
pub(crate) fn material(model: &mut Model) -> &mut Material {
    model.materials.values_mut().next().unwrap()
}

/// Settings of the analysis.
pub(crate) fn settings(model: &mut Model) -> &mut Dynamics {
    model.analysis.dynamics_mut().unwrap()
}
