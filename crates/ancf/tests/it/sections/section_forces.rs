//! Section forces of coarse meshes: loads between the nodes, and the frame of a cable.

use std::f64::consts::PI;

use ancf::Model;
use ancf::mechanics::bodies::{BeamMesh, CarriedFrame};
use ancf::solver::equations::State;
use nalgebra::{Rotation3, Vector3};

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

const BODIES: [&str; 5] = [
    "kind = \"beam\"\nformulation = \"continuum\"",
    "kind = \"beam\"\nformulation = \"enhanced\"",
    "kind = \"beam\"\nformulation = \"linked\"",
    "kind = \"beam\"\nformulation = \"quadratic\"",
    "kind = \"cable\"",
];
const STATICS: &str = "kind = \"statics\"\nstop = { rule = \"energy\", tolerance = 1e-12 }";
const NAMES: [[&str; 3]; 2] = [["N", "Qy", "Qz"], ["T", "My", "Mz"]];

/// Cantilever of 1.6 m along x with probes at its start and its centre.
fn cantilever(body: &str, elements: u32, loads: &str, analysis: &str) -> Model {
    parse(&format!(
        "{loads}
        materials.steel = {{ density = 7850, young = 2.1e11 }}
        sections.bar = {{ kind = \"circle\", diameter = 0.05 }}
        joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"bar\", at = \"start\" }} }}]
        [[probes]]
        name = \"foot\"
        on = {{ body = \"bar\", at = \"start\" }}
        record = [\"section_forces\"]
        [[probes]]
        name = \"middle\"
        on = {{ body = \"bar\", at = 0.8 }}
        record = [\"section_forces\"]
        [[bodies]]
        {body}
        name = \"bar\"
        from = [0, 0, 0]
        to = [1.6, 0, 0]
        elements = {elements}
        section = \"bar\"
        material = \"steel\"
        [analysis]
        {analysis}"
    ))
}

/// Force and moment of a probe at the end of a run.
fn section_forces(run: &Run, probe: &str) -> [Vector3<f64>; 2] {
    NAMES.map(|names| Vector3::from(names.map(|name| run.last(&format!("{probe}.{name}")))))
}

/// Q = q L, M = q L²/2 at the root, q L/2 and q L²/8 in the middle.
#[test]
fn uniform_loads_are_exact_with_one_element() {
    let load = "loads = [{ kind = \"distributed_force\", body = \"bar\", force = [0, 0.02, 0] }]";
    for body in BODIES {
        for elements in [1, 2, 3] {
            let run = Run::of(&cantilever(body, elements, load, STATICS));
            let ([root, bend], [half, quarter]) =
                (section_forces(&run, "foot"), section_forces(&run, "middle"));
            let name = format!("{body}, {elements} elements");
            assert_relative(&name, root.y, 0.02 * 1.6, 1e-6);
            assert_relative(&name, bend.z, 0.01 * 1.6 * 1.6, 1e-6);
            assert_relative(&name, half.y, 0.02 * 0.8, 1e-6);
            assert_relative(&name, quarter.z, 0.01 * 0.8 * 0.8, 1e-5);
        }
    }
}

/// Section forces at the clamp are the reversed reaction, for all loads between the nodes.
#[test]
fn section_forces_at_the_clamp_balance_its_reaction() {
    let force = "{ kind = \"distributed_force\", body = \"bar\", force = [3, -20, 9], force_end = [0, 60, 5], from = 0.13, to = 1.1 }";
    let follower = "{ kind = \"distributed_force\", body = \"bar\", force = [0, 40, 20], follower = true }";
    let point = "{ kind = \"force\", on = { body = \"bar\", at = 0.31 }, force = [10, 50, -20] }";
    let fluid = "{ kind = \"fluid\", bodies = [\"bar\"], density = 1000, drag = [1.2, 0.1], current = [0.3, 1.5, 0.4] }";
    let base = "{ kind = \"base_acceleration\", acceleration = [1, 20, -3] }";
    let dynamics = "kind = \"dynamics\"\nduration = 0.01\nstep = 1e-3";
    let moments = "{ kind = \"distributed_moment\", body = \"bar\", moment = [30, 10, -20] }, { kind = \"moment\", on = { body = \"bar\", at = 1.21 }, moment = [3, 2, 5] }";
    for body in BODIES {
        let is_cable = body.contains("cable");
        for load in [force, follower, point, fluid, base, moments] {
            for (elements, analysis) in [(1, STATICS), (2, STATICS), (1, dynamics)] {
                if is_cable && (load == moments || load == follower) {
                    continue;
                }
                let run = Run::of(&cantilever(body, elements, &format!("loads = [{load}]"), analysis));
                let found = section_forces(&run, "foot");
                let [f, m] = ["root.f", "root.m"].map(|name| run.last_vector(name));
                let size = f.norm() + m.norm();
                assert!(size > 1.0, "{body}, {load}: no reaction");
                let error = (found[0] + f).norm() + (found[1] + m).norm();
                assert!(error < 1e-6 * size, "{body}, {elements}, {analysis}, {load}: {found:?}, {f}, {m}");
            }
        }
    }
}

/// A support at the centre of the only element, and a floor below it.
#[test]
fn supports_and_contacts_within_an_element_are_included() {
    let load = "loads = [{ kind = \"distributed_force\", body = \"bar\", force = [0, 0, -400] }]\n";
    let floor = "contacts = [{ with = { kind = \"plane\", point = [0, 0, -0.0251], normal = [0, 0, 1] }, bodies = [\"bar\"],
        stiffness = 1e6, points = 5 }]\n";
    for body in BODIES {
        let run = Run::of(&cantilever(body, 1, &format!("{load}{floor}"), STATICS));
        let found = section_forces(&run, "foot");
        let [f, m] = ["root.f", "root.m"].map(|name| run.last_vector(name));
        assert!(f.norm() < 0.9 * 640.0, "{body}: the floor has no load, {f}");
        assert!(
            (found[0] + f).norm() + (found[1] + m).norm() < 1e-6 * m.norm(),
            "{body}: {found:?}, {f}, {m}"
        );
    }
}

fn line(mesh: &str) -> Model {
    parse(&format!(
        "materials.rubber = {{ density = 1100, young = 1e7 }}
        sections.rod = {{ kind = \"circle\", diameter = 0.02 }}
        {mesh}
        analysis = {{ kind = \"statics\" }}"
    ))
}

const ROPE: &str = "bodies = [{ kind = \"cable\", name = \"rope\", from = [0, 0, 0], to = [1, 1, 1], elements = 24, section = \"rod\", material = \"rubber\" }]";

/// State of a rope on a curve r(s) with unit tangent t(s).
fn shaped(mesh: &BeamMesh, rest: &State, curve: impl Fn(f64) -> [Vector3<f64>; 2]) -> State {
    let mut state = rest.clone();
    for (i, vector) in mesh.vectors(rest).enumerate() {
        let s = mesh.length() * (i / 2) as f64 / mesh.count() as f64;
        let [r, t] = curve(s);
        let target = if vector.is_position() { r } else { t * vector.value.norm() };
        (0..3).for_each(|k| state.q[vector.first + k] += target[k] - vector.value[k]);
    }
    state
}

/// The frame turns with the tangent without twist and without jumps, along the rope and while the rope rotates.
#[test]
fn frames_of_cables_are_continuous() {
    let assembly = line(ROPE).assemble().unwrap();
    let (mesh, rest) = (assembly.mesh("rope").unwrap(), assembly.rest());
    // Three quarters of a circle in an oblique plane.
    let turn = Rotation3::new(Vector3::new(0.4, -0.9, 0.3));
    let radius = mesh.length() / (1.5 * PI);
    let circle = |s: f64| {
        let (sin, cos) = (s / radius).sin_cos();
        [turn * Vector3::new(radius * sin, 0.0, radius * (1.0 - cos)), turn * Vector3::new(cos, 0.0, sin)]
    };
    let state = shaped(mesh, &rest, circle);
    let (count, mut carried) = (3000, CarriedFrame::default());
    let frames: Vec<_> = (0..=count)
        .map(|i| mesh.carried_frame(&state, mesh.length() * f64::from(i) / f64::from(count), &mut carried))
        .collect();
    for pair in frames.windows(2) {
        assert!((0..3).all(|k| (pair[1][k] - pair[0][k]).norm() < 3e-3), "{pair:?}");
    }
    // Without twist, the angle between the frame and the normal of the plane of the curve is constant.
    let normal = turn * Vector3::y();
    for [x, y, z] in &frames {
        assert!((y.dot(&normal) - frames[0][1].dot(&normal)).abs() < 1e-9);
        assert!((z.dot(&normal) - frames[0][2].dot(&normal)).abs() < 1e-9);
        assert!((x.cross(y) - z).norm() < 1e-12);
    }
    let alone = mesh.section_frame(&state, 0.77 * mesh.length());
    let index = (0.77 * f64::from(count)) as usize;
    assert!((0..3).all(|k| (alone[k] - frames[index][k]).norm() < 1e-12));
    let mut last: Option<[Vector3<f64>; 3]> = None;
    for step in 0..400 {
        let angle = 2.0 * PI * f64::from(step) / 400.0;
        let spin = Rotation3::new(Vector3::new(0.3, 1.0, -0.2).normalize() * angle);
        let state = shaped(mesh, &rest, |s| circle(s).map(|x| spin * x));
        let frame = mesh.section_frame(&state, 0.6 * mesh.length());
        if let Some(last) = last {
            assert!((0..3).all(|k| (frame[k] - last[k]).norm() < 0.1), "{step}: {frame:?} after {last:?}");
        }
        last = Some(frame);
    }
}
