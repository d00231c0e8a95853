//! The beam of Kim et al. (2017): a steel rod of 1 m along x, under gravity along −y.
//!
//! Table 2 prints a diameter of 0.20 m and no Poisson ratio. Its results belong to 0.02 m and ν = 0.

use ancf::Model;
use ancf::model::{
    Analysis, At, Beam, Body, Clamp, ClampedGradients, Dynamics, End, EnergyGuard, Formulation, Initial,
    Joint, Material, NamedPosition, NewtonMethod, Output, Place, Probe, Revolute, ScaleChoice, Scheme,
    Section, Start, Step, Stop,
};

/// Length L.
pub(crate) const LENGTH: f64 = 1.0;
/// Acceleration of gravity.
pub(crate) const GRAVITY: f64 = 9.81;

/// Rod without joints, with a probe at its end. Analysis as in the paper: 2 s in steps of 1 ms.
pub(crate) fn free(elements: u32) -> Model {
    let straight = Beam::straight("rod", [[0.0; 3], [LENGTH, 0.0, 0.0]], elements, "circle", "steel");
    let beam = Beam { formulation: Formulation::Continuum, ..straight };
    let steel = Material::elastic(8030.0, 193e9, 0.0);
    Model {
        title: None,
        units: None,
        gravity: [0.0, -GRAVITY, 0.0],
        materials: [("steel".into(), steel)].into(),
        sections: [("circle".into(), Section::circle(0.02))].into(),
        bodies: vec![Body::Beam(beam)],
        joints: Vec::new(),
        couplings: Vec::new(),
        loads: Vec::new(),
        inputs: Vec::new(),
        assemble: false,
        contacts: Vec::new(),
        initial: Initial::default(),
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
            energy_guard: EnergyGuard::default(),
            until: Vec::new(),
        }),
        probes: vec![Probe::of_motion("tip", end())],
        output: Output::default(),
    }
}

/// Rod clamped at its start, all twelve coordinates of the node.
pub(crate) fn cantilever(elements: u32) -> Model {
    clamped(elements, ClampedGradients::All)
}

/// Rod clamped at its start.
pub(crate) fn clamped(elements: u32, fix: ClampedGradients) -> Model {
    let clamp = Joint::Clamp(Clamp { name: "root".into(), a: start(), b: End::Ground, fix: Some(fix) });
    Model { joints: vec![clamp], ..free(elements) }
}

/// Rod with a revolute joint about z at its start.
pub(crate) fn revolute(elements: u32) -> Model {
    let hinge = Joint::Revolute(Revolute {
        name: "root".into(),
        a: start(),
        b: End::Ground,
        axis: [0.0, 0.0, 1.0],
        drive: None,
        spring: None,
        friction: None,
        moment: None,
        stops: None,
    });
    Model { joints: vec![hinge], ..free(elements) }
}

/// Rod with a spherical joint at its start, E = 193 MPa, under gravity along −y and −z.
pub(crate) fn spherical(elements: u32) -> Model {
    let ball = Joint::spherical("root", start(), End::Ground);
    let mut model = Model { joints: vec![ball], gravity: [0.0, -GRAVITY, -GRAVITY], ..free(elements) };
    material(&mut model).young /= 1000.0;
    model
}

/// Start of the rod.
pub(crate) fn start() -> Place {
    Place::new("rod", At::Named(NamedPosition::Start))
}

/// End of the rod.
pub(crate) fn end() -> Place {
    Place::new("rod", At::Named(NamedPosition::End))
}

/// Returns the beam, the first body.
pub(crate) fn beam(model: &mut Model) -> &mut Beam {
    match &mut model.bodies[0] {
        Body::Beam(beam) => beam,
        _ => panic!("the rod is a beam"),
    }
}

/// Returns the material.
pub(crate) fn material(model: &mut Model) -> &mut Material {
    model.materials.values_mut().next().unwrap()
}

/// Returns the settings of the analysis.
pub(crate) fn settings(model: &mut Model) -> &mut Dynamics {
    model.analysis.dynamics_mut().unwrap()
}
