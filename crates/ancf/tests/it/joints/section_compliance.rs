//! Sections in joints: rods against closed forms on any mesh, in any frame, for every formulation.

use std::f64::consts::PI;

use ancf::model::Body;
use nalgebra::{Rotation3, Vector3};

use crate::common::models::parse;
use crate::common::solutions::Run;

const FORMULATIONS: [&str; 4] = ["continuum", "enhanced", "linked", "quadratic"];
const YOUNG: f64 = 7e9;
const DIAMETER: f64 = 0.12;
const LENGTH: f64 = 0.8;

fn bending() -> f64 {
    YOUNG * PI * DIAMETER.powi(4) / 64.0
}

/// Shear modulus for ν = 0.
fn torsion() -> f64 {
    0.5 * YOUNG * PI * DIAMETER.powi(4) / 32.0
}

/// A rod along x in a frame that is turned: bodies, joints and loads are stated in the turned axes.
struct Rod<'a> {
    elements: u32,
    formulation: &'a str,
    section: &'a str,
    poisson: f64,
    turn: Rotation3<f64>,
}

const CIRCLE: &str = "{ kind = \"circle\", diameter = 0.12 }";

impl<'a> Rod<'a> {
    fn new(elements: u32, formulation: &'a str) -> Self {
        Self { elements, formulation, section: CIRCLE, poisson: 0.0, turn: Rotation3::identity() }
    }

    fn vector(&self, x: [f64; 3]) -> String {
        format!("{:?}", <[f64; 3]>::from(self.turn * Vector3::from(x)))
    }

    /// Beam with a name from a point to another one.
    fn beam(&self, name: &str, [from, to]: [[f64; 3]; 2], up: [f64; 3]) -> String {
        let Self { elements, formulation, .. } = self;
        let [from, to, up] = [from, to, up].map(|x| self.vector(x));
        format!(
            "{{ kind = \"beam\", name = \"{name}\", from = {from}, to = {to}, up = {up}, elements = {elements}, \
             formulation = \"{formulation}\", section = \"s\", material = \"m\" }}"
        )
    }

    /// Runs a model of bodies, joints and loads in statics; the probe `tip` is at the end of the rod `arm`.
    fn run(&self, bodies: &[String], joints: &str, loads: &str) -> Run {
        let (section, poisson, bodies) = (self.section, self.poisson, bodies.join(", "));
        Run::of(&parse(&format!(
            "materials.m = {{ density = 900, young = {YOUNG}, poisson = {poisson} }}\nsections.s = {section}\n\
             bodies = [{bodies}]\njoints = [{joints}]\nloads = [{loads}]\n\
             probes = [{{ name = \"tip\", on = {{ body = \"arm\", at = \"end\" }}, record = [\"motion\", \"rotation\"] }}]\n\
             [analysis]\nkind = \"statics\"\nstop = {{ rule = \"energy\", tolerance = 1e-10 }}\n"
        )))
    }

    fn arm(&self) -> String {
        self.beam("arm", [[0.0; 3], [LENGTH, 0.0, 0.0]], [0.0, 1.0, 0.0])
    }

    /// Load at the tip.
    fn load(&self, kind: &str, vector: [f64; 3]) -> String {
        let vector = self.vector(vector);
        format!("{{ kind = \"{kind}\", on = {{ body = \"arm\", at = \"end\" }}, {kind} = {vector} }}")
    }

    /// Displacement and rotation vector of the tip, in the turned axes, small.
    fn tip(&self, run: &Run) -> [Vector3<f64>; 2] {
        let moved = run.last_vector("tip.") - self.turn * Vector3::new(LENGTH, 0.0, 0.0);
        let rotation = Vector3::from(["tip.e1", "tip.e2", "tip.e3"].map(|name| 2.0 * run.last(name)));
        [moved, rotation].map(|x| self.turn.inverse() * x)
    }
}

const START: &str = "name = \"root\", a = { body = \"arm\", at = \"start\" }";

/// Joints that hold the start of the rod, with the compliance against rotation about x, y and z; none: not held.
fn holders(rod: &Rod<'_>) -> Vec<(String, [Option<f64>; 3])> {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| rod.vector(axis));
    let stiff = [Some(0.0); 3];
    let hinge = |axis: &str, keys: &str| format!("kind = \"revolute\", {START}, axis = {axis}, {keys}");
    let spring = "spring = { stiffness = 4e4 }";
    let locked = "drive = { angle = 0, time = 1 }";
    let skew = rod.vector([0.48, 0.6, -0.64]);
    let drive = format!("kind = \"drive\", {START}, axis = {skew}, angle = 0, time = 1, fix = \"section\"");
    vec![
        (format!("kind = \"clamp\", {START}, fix = \"section\""), stiff),
        (drive, stiff),
        (hinge(&x, locked), stiff),
        (hinge(&y, locked), stiff),
        (hinge(&skew, locked), stiff),
        (hinge(&y, spring), [Some(0.0), Some(1.0 / 4e4), Some(0.0)]),
        (hinge(&x, spring), [Some(1.0 / 4e4), Some(0.0), Some(0.0)]),
        (
            format!(
                "kind = \"cylindrical\", {START}, axis = {z}, {locked}, feed = {{ displacement = 0, time = 1 }}"
            ),
            stiff,
        ),
        (format!("kind = \"prismatic\", {START}, axis = {x}, spring = {{ stiffness = 1e6 }}"), stiff),
        (format!("kind = \"universal\", {START}, axis_a = {y}, axis_b = {z}"), [Some(0.0), None, None]),
    ]
}

/// M L/EI and T L/GJ of the rod, plus the compliance of the joint.
#[test]
fn joints_add_no_compliance_of_their_own() {
    for (formulation, elements) in FORMULATIONS.into_iter().flat_map(|f| [1, 4, 48].map(|n| (f, n))) {
        let rod = Rod::new(elements, formulation);
        let own = [LENGTH / torsion(), LENGTH / bending(), LENGTH / bending()];
        for (joint, compliance) in holders(&rod) {
            for axis in (0..3).filter(|&axis| compliance[axis].is_some()) {
                if joint.contains("universal") {
                    continue; // Two free rotations: in `universal_joints_carry_torsion`.
                }
                let mut moment = [0.0; 3];
                moment[axis] = 0.7;
                let run = rod.run(&[rod.arm()], &format!("{{ {joint} }}"), &rod.load("moment", moment));
                let [_, found] = rod.tip(&run);
                let mut expected = Vector3::zeros();
                expected[axis] = 0.7 * (own[axis] + compliance[axis].unwrap_or(0.0));
                let error = (found - expected).norm() / expected.norm();
                assert!(error < 2e-6, "{formulation}, {elements}, {joint}, axis {axis}: {error:e}");
            }
        }
    }
}

/// Tip force on the formulations that bend exactly under it: F L³/3EI + F L/kGA, k = 6/7, on any mesh.
#[test]
fn tip_forces_bend_a_held_rod_exactly() {
    let area = PI * DIAMETER * DIAMETER / 4.0;
    let expected = LENGTH.powi(3) / (3.0 * bending()) + LENGTH / (6.0 / 7.0 * 0.5 * YOUNG * area);
    for (formulation, elements) in
        ["linked", "quadratic"].into_iter().flat_map(|f| [1, 6, 48].map(|n| (f, n)))
    {
        let rod = Rod::new(elements, formulation);
        for (joint, _) in holders(&rod).into_iter().filter(|(_, c)| *c == [Some(0.0); 3]) {
            for force in [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
                let run = rod.run(&[rod.arm()], &format!("{{ {joint} }}"), &rod.load("force", force));
                let [moved, _] = rod.tip(&run);
                let error = (moved.dot(&Vector3::from(force)) / expected - 1.0).abs();
                assert!(error < 2e-6, "{formulation}, {elements}, {joint}: {error:e}");
            }
        }
    }
}

/// Rectangle 1 : 2 in torsion. A continuum has the polar moment of area; the rods have their torsion constant.
#[test]
fn weights_of_the_frame_follow_the_formulation() {
    let section = "{ kind = \"rectangle\", width = 0.05, height = 0.1 }";
    let twist = |elements, formulation, up| {
        let rod = Rod { section, ..Rod::new(elements, formulation) };
        let arm = rod.beam("arm", [[0.0; 3], [LENGTH, 0.0, 0.0]], up);
        let joint = format!(
            "{{ kind = \"revolute\", {START}, axis = [0, 1, 0], drive = {{ angle = 0, time = 1 }} }}"
        );
        let [_, rotation] = rod.tip(&rod.run(&[arm], &joint, &rod.load("moment", [0.7, 0.0, 0.0])));
        rotation.x
    };
    let polar = 0.05 * 0.1 * (0.05_f64.powi(2) + 0.1_f64.powi(2)) / 12.0;
    let expected = 0.7 * LENGTH / (0.5 * YOUNG * polar);
    for elements in [1, 12, 48] {
        for up in [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, -0.6, 0.8]] {
            let error = (twist(elements, "continuum", up) / expected - 1.0).abs();
            assert!(error < 2e-6, "{elements}, {up:?}: {error:e}");
            for formulation in ["linked", "quadratic"] {
                let coarse = twist(1, formulation, [0.0, 1.0, 0.0]);
                let error = (twist(elements, formulation, up) / coarse - 1.0).abs();
                assert!(error < 2e-6, "{formulation}, {elements}, {up:?}: {error:e}");
            }
        }
    }
}

/// Sections against sections: a rod of two parts, and a corner, in both orders of the ends.
#[test]
fn clamps_join_sections_of_two_beams() {
    for (formulation, elements) in FORMULATIONS.into_iter().flat_map(|f| [1, 16].map(|n| (f, n))) {
        let rod = Rod::new(elements, formulation);
        let half = LENGTH / 2.0;
        let root = rod.beam("root beam", [[0.0; 3], [half, 0.0, 0.0]], [0.0, 1.0, 0.0]);
        let straight = [[half, 0.0, 0.0], [LENGTH, 0.0, 0.0]];
        let corner = [[half, 0.0, 0.0], [half, 0.0, half]];
        for (ends, up) in [(straight, [0.0, 0.6, 0.8]), (corner, [0.0, 1.0, 0.0])] {
            let arm = rod.beam("arm", ends, up);
            for order in [
                ["root beam\", at = \"end", "arm\", at = \"start"],
                ["arm\", at = \"start", "root beam\", at = \"end"],
            ] {
                let joints = format!(
                    "{{ kind = \"clamp\", name = \"base\", a = {{ body = \"root beam\", at = \"start\" }}, fix = \"section\" }}, \
                     {{ kind = \"clamp\", name = \"weld\", a = {{ body = \"{}\" }}, b = {{ body = \"{}\" }}, fix = \"section\" }}",
                    order[0], order[1]
                );
                for axis in 0..3 {
                    let mut moment = [0.0; 3];
                    moment[axis] = 0.7;
                    let run = rod.run(&[root.clone(), arm.clone()], &joints, &rod.load("moment", moment));
                    let [_, found] = rod.tip(&run);
                    let along = |direction: usize| if direction == axis { torsion() } else { bending() };
                    let second = if ends == straight { 0 } else { 2 };
                    let mut expected = Vector3::zeros();
                    expected[axis] = 0.7 * half * (1.0 / along(0) + 1.0 / along(second));
                    let error = (found - expected).norm() / expected.norm();
                    assert!(error < 2e-6, "{formulation}, {elements}, {joints}, axis {axis}: {error:e}");
                }
            }
        }
    }
}

/// Tension at a clamp of the section: F L/EA, and the section contracts freely.
#[test]
fn clamped_sections_contract_freely() {
    let area = PI * DIAMETER * DIAMETER / 4.0;
    for (formulation, elements) in FORMULATIONS.into_iter().flat_map(|f| [1, 8].map(|n| (f, n))) {
        for poisson in [0.3, 0.49] {
            let rod = Rod { poisson, ..Rod::new(elements, formulation) };
            let joint = format!("{{ kind = \"clamp\", {START}, fix = \"section\" }}");
            let [moved, _] = rod.tip(&rod.run(&[rod.arm()], &joint, &rod.load("force", [3.0, 0.0, 0.0])));
            let error = (moved.x * YOUNG * area / (3.0 * LENGTH) - 1.0).abs();
            assert!(error < 1e-6, "{formulation}, {elements}, {poisson}: {error:e}");
        }
    }
}

/// A force at an arm of the tip section twists the rod by F a L/GJ.
#[test]
fn forces_at_arms_act_on_the_frame() {
    for (formulation, elements) in FORMULATIONS.into_iter().flat_map(|f| [1, 8, 48].map(|n| (f, n))) {
        for (offset, force, sign) in
            [([0.0, 0.3, 0.0], [0.0, 0.0, 2.0], 1.0), ([0.0, 0.0, 0.3], [0.0, 2.0, 0.0], -1.0)]
        {
            let rod = Rod::new(elements, formulation);
            let joint = format!("{{ kind = \"clamp\", {START}, fix = \"section\" }}");
            let load = format!(
                "{{ kind = \"force\", on = {{ body = \"arm\", at = \"end\", offset = {offset:?} }}, force = {force:?} }}"
            );
            let [_, rotation] = rod.tip(&rod.run(&[rod.arm()], &joint, &load));
            let error = (sign * rotation.x * torsion() / (0.6 * LENGTH) - 1.0).abs();
            assert!(error < 2e-6, "{formulation}, {elements}, {offset:?}: {error:e}");
        }
    }
}

/// A hinge that turns a loaded rod by 0.7: as a drive of its clamp, on any mesh, in any frame, with exchanged ends.
#[test]
fn driven_hinges_turn_the_section_by_their_angle() {
    let tip = |rod: &Rod<'_>, joint: &str| {
        let hub = format!(
            "{{ kind = \"rigid\", name = \"hub\", center = [0, 0, 0], mass = 1, inertia = [1, 1, 1] }}, {}",
            rod.arm()
        );
        let base = "{ kind = \"clamp\", name = \"base\", a = { body = \"hub\", at = \"center\" } }";
        let force = rod.load("force", [0.0, 300.0, 6e3]);
        let run = rod.run(&[hub], &format!("{base}, {joint}"), &force);
        rod.turn.inverse() * run.last_vector("tip.")
    };
    let driven = |rod: &Rod<'_>, axis: [f64; 3], ends: &str, angle: f64| {
        let axis = rod.vector(axis);
        format!(
            "{{ kind = \"revolute\", name = \"hinge\", {ends}, axis = {axis}, drive = {{ angle = {angle}, time = 1 }} }}"
        )
    };
    let direct = "a = { body = \"arm\", at = \"start\" }, b = { body = \"hub\", at = \"center\" }";
    let exchanged = "a = { body = \"hub\", at = \"center\" }, b = { body = \"arm\", at = \"start\" }";
    let axis = [0.48, 0.6, -0.64];
    for formulation in ["continuum", "linked", "quadratic"] {
        let rod = Rod::new(6, formulation);
        let expected = tip(&rod, &driven(&rod, axis, direct, 0.7));
        let back = tip(&rod, &driven(&rod, axis, exchanged, -0.7));
        assert!((back - expected).norm() < 1e-9, "{formulation}: exchanged ends, {back} for {expected}");
        let turned = Rod { turn: Rotation3::from_euler_angles(0.7, -1.2, 2.5), ..Rod::new(6, formulation) };
        let other = tip(&turned, &driven(&turned, axis, direct, 0.7));
        assert!((other - expected).norm() < 1e-9, "{formulation}: turned, {other} for {expected}");
        let drive = format!(
            "{{ kind = \"drive\", {START}, axis = {axis:?}, angle = 0.7, time = 1, fix = \"section\" }}"
        );
        let clamped = tip(&rod, &drive);
        assert!((clamped - expected).norm() < 1e-9, "{formulation}: drive, {clamped} for {expected}");
        let fine = Rod::new(24, formulation);
        let refined = tip(&fine, &driven(&fine, axis, direct, 0.7));
        let tolerance = if formulation == "continuum" { 2e-4 } else { 5e-6 };
        assert!((refined - expected).norm() < tolerance, "{formulation}: mesh, {refined} for {expected}");
    }
}

/// The universal joint carries torsion: T L/GJ between two hubs, of which one is held.
#[test]
fn universal_joints_carry_torsion() {
    for (formulation, elements) in FORMULATIONS.into_iter().flat_map(|f| [1, 8, 48].map(|n| (f, n))) {
        let rod = Rod::new(elements, formulation);
        let joints = format!(
            "{{ kind = \"universal\", {START}, axis_a = [0, 1, 0], axis_b = [0, 0, 1] }}, \
             {{ kind = \"point_on_line\", name = \"guide\", a = {{ body = \"arm\", at = \"end\" }}, axis = [1, 0, 0] }}"
        );
        let run = rod.run(&[rod.arm()], &joints, &rod.load("moment", [0.7, 0.0, 0.0]));
        let [_, rotation] = rod.tip(&run);
        let error = (rotation.x * torsion() / (0.7 * LENGTH) - 1.0).abs();
        assert!(error < 2e-6, "{formulation}, {elements}: {error:e}");
    }
}

/// The sag of the robot arm does not depend on the mesh: −0.28315 by links clamped to rigid hubs with hinges between them.
#[test]
fn robot_arm_sags_by_its_links_only() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/robot_arm.toml");
    let text = std::fs::read_to_string(path).unwrap();
    for elements in [4, 12] {
        let mut model = parse(&text);
        for body in &mut model.bodies {
            if let Body::Beam(beam) = body {
                beam.elements = elements;
            }
        }
        let y = Run::of(&model).last("hand.y");
        assert!((y + 0.283146).abs() < 1e-5, "{elements}: {y}");
    }
}
