//! Diagnosis of models: contents, mobility, loose bodies, names of equations.

use ancf::model::{
    Analysis, At, Beam, Body, End, Formulation, Joint, NamedPosition, Place, Section, Statics,
};
use ancf::record::Series;
use ancf::{Model, Outcome, simulate};

use crate::common::models::{parse, rod};
use crate::common::solutions::Run;

/// Adds beams without joints.
fn with_loose_beams(mut model: Model, names: &[&str]) -> Model {
    for (k, name) in names.iter().enumerate() {
        let (x, name) = (2.0 + k as f64, (*name).to_owned());
        let beam =
            Beam { name, from: [x, 0.0, 0.0], to: [x + 1.0, 0.0, 0.0], ..rod::beam(&mut model).clone() };
        model.bodies.push(Body::Beam(beam));
    }
    model
}

fn end(body: &str, end: NamedPosition) -> Place {
    Place::new(body, At::Named(end))
}

#[test]
fn diagnosis_of_a_pendulum_counts_bodies_and_mobility() {
    let diagnosis = rod::revolute(2).diagnose().unwrap();
    assert_eq!(
        diagnosis.to_string(),
        "bodies:    1 beam\n\
         joints:    1 revolute\n\
         loads:     gravity\n\
         equations: 36 coordinates, 5 constraints, 0 of them redundant\n\
         mobility:  1 by Grübler's formula for rigid bodies, which counts every joint\n           \
         1 free motion of the bodies if they are rigid, by the rank of the constraints\n           \
         31 degrees of freedom with the deformation of the bodies\n\
         free:      body `rod` can rotate about the axis through (0, 0, 0) along z\n\
         warning:   beam `rod`, formulation \"continuum\": deflections are about 8.333 % too small with 2 elements (shear locking); \
         \"linked\" and \"quadratic\" have no such error\n"
    );
}

/// Warnings of locking state the size of the error: (λ+2G)/E = (1 − ν)/((1 + ν)(1 − 2ν)), the polar moment of a square over
/// J = 0.1406 h⁴, and 1/(3n²).
#[test]
fn locking_is_reported_with_its_size() {
    let warnings = |formulation, poisson, section, elements| {
        let mut model = rod::cantilever(elements);
        rod::beam(&mut model).formulation = formulation;
        rod::material(&mut model).poisson = poisson;
        model.sections.insert("circle".into(), section);
        model.diagnose().unwrap().warnings.join(" ")
    };
    let (round, square) = (Section::circle(0.02), Section::rectangle(0.02, 0.02));
    let text = warnings(Formulation::Continuum, 0.3, square.clone(), 3);
    for part in ["1.346 E I", "1.186 G J", "3.704 %"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    assert!(warnings(Formulation::Enhanced, 0.3, square.clone(), 2).contains("8.333 %"));
    for formulation in [Formulation::Linked, Formulation::Quadratic] {
        assert_eq!(warnings(formulation, 0.45, square.clone(), 1), "");
    }
    assert_eq!(warnings(Formulation::Continuum, 0.0, round, 6), "");
    assert_eq!(Formulation::default(), Formulation::Linked);
}

/// Deflections of curved elements with shear locking are too small by the reported share: λ = (κ l²)² A/(180 I).
#[test]
fn thickness_locking_of_arcs_is_reported_with_its_size() {
    let arc = |formulation: &str, elements: u32| {
        parse(&format!(
            r#"
materials.m = {{ density = 1000, young = 7e9, poisson = 0 }}
sections.s = {{ kind = "rectangle", height = 0.03, width = 0.03 }}
bodies = [{{ kind = "beam", name = "b", from = [0, 0, 0], to = [1, 0, 0], elements = {elements}, section = "s", material = "m", formulation = "{formulation}", up = [0, 1, 0], shape = {{ kind = "arc", through = [0.5, 0.25, 0] }} }}]
joints = [{{ kind = "clamp", name = "c", a = {{ body = "b", at = "start" }} }}]
loads = [{{ kind = "force", on = {{ body = "b", at = "end" }}, force = [0, 0.1, 0] }}]
probes = [{{ name = "tip", on = {{ body = "b", at = "end" }} }}]
analysis = {{ kind = "statics" }}
"#
        ))
    };
    let deflection = |model: &Model| Run::of(model).last("tip.y");
    let exact = deflection(&arc("quadratic", 16));
    for elements in [4, 8] {
        let model = arc("enhanced", elements);
        let warnings = model.diagnose().unwrap().warnings.join(" ");
        let stated = warnings.split("up to ").nth(1).and_then(|text| text.split(' ').next()).unwrap();
        let (stated, missing) = (stated.parse::<f64>().unwrap() / 100.0, 1.0 - deflection(&model) / exact);
        // Some elements of the arc bend less than others, and those of the shear locking are included.
        assert!((0.7 * stated..1.1 * stated).contains(&missing), "{elements}: {stated} {missing}");
        assert_eq!(arc("linked", elements).diagnose().unwrap().warnings.join(" "), "");
    }
}

/// Bodies without joints and chains without connection to the ground.
#[test]
fn unconnected_bodies_are_named() {
    let mut model = with_loose_beams(rod::cantilever(1), &["alone", "one", "two"]);
    let (a, b) = (end("two", NamedPosition::Start), End::Place(end("one", NamedPosition::End)));
    model.joints.push(Joint::spherical("elbow", a, b));
    let diagnosis = model.diagnose().unwrap();
    assert_eq!(diagnosis.unconnected, ["alone"]);
    assert_eq!(diagnosis.unreached, ["one", "two"]);
    assert_eq!((diagnosis.gruebler, diagnosis.motions.as_ref().unwrap().len()), (15, 15));
    let text = diagnosis.to_string();
    assert!(text.contains("no joints: `alone`\n"), "{text}");
    assert!(text.contains("no ground: `one`, `two`, not connected to the ground by joints\n"), "{text}");
}

/// Failures of statics name the free motions.
#[test]
fn free_motions_are_named_when_statics_fails() {
    let failed = |mut model: Model| {
        model.analysis = Analysis::Statics(Statics::default());
        match simulate(&model, &mut Series::new()).unwrap().outcome {
            Outcome::Failed { at, .. } => at,
            outcome => panic!("{outcome:?}"),
        }
    };
    assert_eq!(failed(rod::revolute(2)), "body `rod` can rotate about the axis through (0, 0, 0) along z");
    let alone = failed(with_loose_beams(rod::cantilever(2), &["alone"]));
    assert!(
        alone.starts_with("body `alone` can translate along x; body `alone` can translate along y"),
        "{alone}"
    );
}

/// Lengths are in the units of the user, independent of the scales of the solver.
#[test]
fn diagnosis_does_not_depend_on_scales() {
    let model = rod::spherical(2);
    let mut other = model.clone();
    other.scales = ancf::model::ScaleChoice::Given { length: 1e-3, force: 1e3, time: Some(10.0) };
    assert_eq!(model.diagnose(), other.diagnose());
}

/// Names contain the joint, the constrained quantity and the axis.
#[test]
fn joint_equations_have_names() {
    let assembly = rod::revolute(1).assemble().unwrap();
    let names: Vec<String> = (24..29).map(|equation| assembly.name_of(equation)).collect();
    assert_eq!(
        names,
        [
            "joint `root`, position along x",
            "joint `root`, position along y",
            "joint `root`, position along z",
            "joint `root`, hinge axis, first equation",
            "joint `root`, hinge axis, second equation",
        ]
    );
    let assembly = rod::cantilever(1).assemble().unwrap();
    assert_eq!(assembly.name_of(24 + 4), "joint `root`, direction x along y");
}
