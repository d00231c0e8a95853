//! Joints, loads and sections of a program's own kinds.

use ancf::errors::{Finding, finding};
use ancf::joints::{Capability, JointActions, JointBuilder, JointFriction, JointKind};
use ancf::loads::{LoadBuilder, LoadKind};
use ancf::mechanics::sections::{Moments, SectionPoint};
use ancf::model::{
    At, End, NamedPosition, Place, Rectangle, SectionOutline, SectionShape, TimeFunction, Varying,
};
use ancf::record::{Series, Sink};
use ancf::units::Scaled;
use ancf::{Extension, Model, Simulation};
use nalgebra::Vector3;

/// Hinge with dry friction, like the revolute joint of model files.
#[derive(Clone, Debug, Scaled)]
struct Bearing {
    a: Place,
    b: End,
    #[unit(none)]
    axis: [f64; 3],
    #[unit(force * length)]
    torque: f64,
    #[unit(radian / time)]
    rate: f64,
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
            &JointActions {
                friction: Some(JointFriction::constant(self.torque, self.rate)),
                ..JointActions::default()
            },
        );
    }
}

/// Force at a point, like that of model files.
#[derive(Clone, Debug, Scaled)]
struct Pull {
    on: Place,
    #[unit(force)]
    force: [f64; 3],
    time: TimeFunction,
}

impl LoadKind for Pull {
    fn noun(&self) -> &'static str {
        "pull"
    }

    fn on(&self) -> Option<&Place> {
        Some(&self.on)
    }

    fn time(&self) -> Option<&TimeFunction> {
        Some(&self.time)
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let on = builder.attachment(&self.on);
        builder.force(&on.point, self.force, builder.function(&self.time));
    }
}

/// Rectangle, like that of model files.
#[derive(Clone, Debug, Scaled)]
struct Bar {
    #[unit(length)]
    height: f64,
    #[unit(length)]
    width: f64,
}

impl Bar {
    fn rectangle(&self) -> Rectangle {
        Rectangle { height: self.height, width: self.width }
    }
}

impl SectionShape for Bar {
    fn moments(&self) -> Moments {
        self.rectangle().moments()
    }

    fn torsion_constant(&self) -> f64 {
        self.rectangle().torsion_constant()
    }

    fn shear_factors(&self, poisson: f64) -> [f64; 2] {
        self.rectangle().shear_factors(poisson)
    }

    fn points(&self) -> Option<Vec<SectionPoint>> {
        self.rectangle().points()
    }

    fn outline(&self) -> SectionOutline {
        self.rectangle().outline()
    }

    fn towards(&self, end: &Self, fraction: f64) -> Self {
        let Rectangle { height, width } = self.rectangle().towards(&end.rectangle(), fraction);
        Self { height, width }
    }

    fn check(&self, path: &str) -> Vec<Finding> {
        let found = || finding(format!("{path}.height"), self.height.to_string(), "a number > 0");
        (self.height <= 0.0).then(found).into_iter().collect()
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

fn place(at: NamedPosition) -> Place {
    Place::new("rod", At::Named(at))
}

fn bearing() -> Bearing {
    Bearing {
        a: place(NamedPosition::Start),
        b: End::Ground,
        axis: [0.8, 0.1, -0.6],
        torque: 0.7,
        rate: 1e-2,
    }
}

fn pull() -> Pull {
    let time = TimeFunction::Varying(Varying::Ramp { start: 0.0, end: 0.1 });
    Pull { on: place(NamedPosition::End), force: [1.0, 2.0, -3.0], time }
}

fn rows(simulation: &Simulation) -> Series {
    let mut series = Series::new();
    let mut sink: &mut dyn Sink = &mut series;
    let summary = simulation.run(&mut sink).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    series
}

/// Parts of a program give the same numbers as built-in parts with equal equations.
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
    let round = r#"sections.rod = { kind = "circle", diameter = 0.02 }"#;
    let [tapered, end] = [stated.replace(round, r#"sections = { rod = { kind = "rectangle", height = 0.03, width = 0.02 }, tip = { kind = "rectangle", height = 0.01, width = 0.02 } }"#), MODEL.replace(round, r#"sections = { rod = { kind = "circle", diameter = 0.02 }, tip = { kind = "circle", diameter = 0.02 } }"#)]
        .map(|text| text.replace("section = \"rod\"", "section = \"rod\"\nsection_end = \"tip\""));
    let built_in = Simulation::new(&Model::parse(&tapered).unwrap()).unwrap();
    let model = Model::parse(&end).unwrap();
    let added = Simulation::builder(&model)
        .with(Extension::joint(bearing()))
        .with(Extension::load(pull()))
        .with(Extension::section("rod", Bar { height: 0.03, width: 0.02 }))
        .with(Extension::section("tip", Bar { height: 0.01, width: 0.02 }))
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

/// A joint that records two angles.
#[derive(Clone, Debug, Scaled)]
struct Cross(Bearing);

impl JointKind for Cross {
    fn word(&self) -> &'static str {
        "cross"
    }

    fn name(&self) -> &str {
        self.0.name()
    }

    fn ends(&self) -> (&Place, &End) {
        self.0.ends()
    }

    fn removes(&self) -> usize {
        4
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        builder.coincide();
        builder.angle([1.0, 0.0, 0.0], &JointActions::default());
        builder.angle([0.0, 1.0, 0.0], &JointActions::default());
    }
}

#[test]
fn columns_of_one_name_are_rejected() {
    let model = Model::parse(MODEL).unwrap();
    let wrong = Simulation::builder(&model).with(Extension::joint(Cross(bearing()))).build().unwrap_err();
    assert!(wrong.to_string().contains("two coordinates `angle` of joint \"shaft\""), "{wrong}");
}

#[test]
fn added_parts_are_checked() {
    let model = Model::parse(MODEL).unwrap();
    let nowhere = Place::new("mast", At::Named(NamedPosition::Start));
    let wrong = Simulation::builder(&model)
        .with(Extension::joint(Bearing { axis: [0.0; 3], ..bearing() }))
        .with(Extension::load(Pull { on: nowhere, ..pull() }))
        .with(Extension::section("rod", Bar { height: -1.0, width: 1.0 }))
        .build()
        .unwrap_err();
    let paths: Vec<&str> = wrong.iter().map(|error| error.path.as_str()).collect();
    assert_eq!(paths, ["sections.rod.height", "loads[0].on.body", "joints[0].axis"]);
}

#[test]
fn the_diagnosis_counts_added_parts() {
    let mut model = Model::parse(MODEL).unwrap();
    model.joints.push(ancf::model::Joint::Custom(ancf::joints::CustomJoint::new(bearing())));
    let diagnosis = model.diagnose().unwrap();
    assert_eq!(diagnosis.joints["bearing"], 1);
    assert_eq!(diagnosis.gruebler, 1);
}
