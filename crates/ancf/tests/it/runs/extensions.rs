//! Joints and loads of a program's own kinds.

use ancf::joints::{Capability, JointActions, JointBuilder, JointKind};
use ancf::mechanics::forces::Force;
use ancf::mechanics::functions::Function;
use ancf::mechanics::kinematics::Attachment;
use ancf::model::{At, End, LoadKind, Named, Place, TimeFunction, Varying};
use ancf::record::{Series, Sink};
use ancf::solver::equations::Term;
use ancf::units::{Dimension, Scaled, Scales};
use ancf::{Extension, Model, Simulation};
use nalgebra::Vector3;

/// Hinge with dry friction, like the revolute joint of model files.
#[derive(Clone, Debug)]
struct Bearing {
    a: Place,
    b: End,
    axis: [f64; 3],
    torque: f64,
    rate: f64,
}

impl Scaled for Bearing {
    fn scaled(self, to: &Scales) -> Self {
        let (torque, rate) = (self.torque / to.unit(Dimension::ENERGY), self.rate / to.unit(Dimension::RATE));
        Self { a: self.a.scaled(to), b: self.b.scaled(to), torque, rate, ..self }
    }
}

impl JointKind for Bearing {
    fn word(&self) -> &'static str {
        "bearing"
    }

    fn name(&self) -> &str {
        "shaft"
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        5
    }

    fn axes(&self) -> Vec<(&'static str, [f64; 3])> {
        vec![("axis", self.axis)]
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [Some((Capability::Section, "a bearing")); 2]
    }

    fn closes(&self) -> bool {
        true
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        let axis = Vector3::from(self.axis).normalize();
        builder.coincide();
        builder.parallel(axis, "hinge axis");
        builder.angle(
            axis,
            &JointActions { friction: Some([self.torque, self.rate]), ..JointActions::default() },
        );
    }
}

/// Force at a point, like that of model files.
#[derive(Clone, Debug)]
struct Pull {
    on: Place,
    force: [f64; 3],
    time: TimeFunction,
}

impl Scaled for Pull {
    fn scaled(self, to: &Scales) -> Self {
        let force = self.force.map(|x| x / to.unit(Dimension::FORCE));
        Self { on: self.on.scaled(to), force, time: self.time.scaled(to) }
    }
}

impl LoadKind for Pull {
    fn noun(&self) -> &'static str {
        "pull"
    }

    fn on(&self) -> &Place {
        &self.on
    }

    fn time(&self) -> Option<&TimeFunction> {
        Some(&self.time)
    }

    fn terms(&self, on: &Attachment, function: Function) -> Vec<Box<dyn Term>> {
        vec![Box::new(Force::varying(&on.point, Vector3::from(self.force), function))]
    }
}

const MODEL: &str = r#"
gravity = [0, -9.81, 0]
materials.steel = { density = 7800, young = 2e9 }
sections.rod = { kind = "circle", diameter = 0.02 }
scales = { kind = "auto" }

[[bodies]]
kind = "beam"
name = "rod"
from = [0, 0, 0]
to = [0.6, 0, 0.8]
elements = 2
section = "rod"
material = "steel"

[[probes]]
name = "tip"
on = { body = "rod", at = "end" }

[analysis]
kind = "dynamics"
duration = 0.2
step = 2e-3
"#;

const AXIS: &str = "[0.8, 0.1, -0.6]";

fn place(at: Named) -> Place {
    Place::new("rod", At::Named(at))
}

fn bearing() -> Bearing {
    Bearing { a: place(Named::Start), b: End::Ground, axis: [0.8, 0.1, -0.6], torque: 0.7, rate: 1e-2 }
}

fn pull() -> Pull {
    let time = TimeFunction::Varying(Varying::Ramp { start: 0.0, end: 0.1 });
    Pull { on: place(Named::End), force: [1.0, 2.0, -3.0], time }
}

fn rows(simulation: &Simulation) -> Series {
    let mut series = Series::new();
    let mut sink: &mut dyn Sink = &mut series;
    let summary = simulation.run(&mut sink).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    series
}

/// Built-in and added joints and loads with equal equations give equal results.
#[test]
fn added_parts_give_the_results_of_built_in_ones() {
    let stated = format!(
        r#"{MODEL}
        [[joints]]
        kind = "revolute"
        name = "shaft"
        a = {{ body = "rod", at = "start" }}
        axis = {AXIS}
        friction = {{ moment = 0.7, rate = 1e-2 }}

        [[loads]]
        kind = "force"
        on = {{ body = "rod", at = "end" }}
        force = [1, 2, -3]
        time = {{ kind = "ramp", end = 0.1 }}
        "#
    );
    let built_in = Simulation::new(&Model::parse(&stated).unwrap()).unwrap();
    let model = Model::parse(MODEL).unwrap();
    let added = Simulation::builder(&model)
        .with(Extension::joint(bearing()))
        .with(Extension::load(pull()))
        .build()
        .unwrap();
    assert_eq!(built_in.scales(), added.scales());
    let (one, other) = (rows(&built_in), rows(&added));
    for column in ["tip.x", "tip.y", "tip.z", "shaft.angle", "shaft.fx", "kinetic"] {
        let (one, other) = (one.column(column), other.column(column));
        assert!(one.is_some() && one == other, "{column}");
    }
    assert!(one.column("tip.y").unwrap().last().unwrap().abs() > 1e-3, "the rod moves");
}

#[test]
fn added_parts_are_checked() {
    let model = Model::parse(MODEL).unwrap();
    let nowhere = Place::new("mast", At::Named(Named::Start));
    let wrong = Simulation::builder(&model)
        .with(Extension::joint(Bearing { axis: [0.0; 3], ..bearing() }))
        .with(Extension::load(Pull { on: nowhere, ..pull() }))
        .build()
        .unwrap_err();
    let paths: Vec<&str> = wrong.iter().map(|error| error.path.as_str()).collect();
    assert_eq!(paths, ["loads[0].on.body", "joints[0].axis"]);
}

#[test]
fn the_diagnosis_counts_added_parts() {
    let mut model = Model::parse(MODEL).unwrap();
    model.joints.push(ancf::model::Joint::Custom(ancf::joints::CustomJoint::new(bearing())));
    let diagnosis = model.diagnose().unwrap();
    assert_eq!(diagnosis.joints["bearing"], 1);
    assert_eq!(diagnosis.gruebler, 1);
}
