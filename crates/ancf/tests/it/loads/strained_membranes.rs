//! Prescribed strains of shells with laws of the membrane forces, against closed forms.

use std::fmt::Write;

use ancf::{Model, Scales};

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;
use crate::errors::shells::Shell::{self, Quadrilaterals, Thin, Triangles};

const KINDS: [Shell; 3] = [Thin, Quadrilaterals, Triangles];
const RUBBER: &str = "{ law = \"neo_hookean\" }";
const FIELD: &str = "{ tension_field = true }";
const RUBBER_FIELD: &str = "{ law = \"neo_hookean\", tension_field = true }";
/// Compressed sheets crumple without the part of the energy that remains.
const STIFF_FIELD: &str = "{ tension_field = true, slack = 0.1 }";
const LAWS: [&str; 3] = [RUBBER, FIELD, RUBBER_FIELD];

/// Thickness times the shear modulus.
const SHEAR: f64 = 0.01;

/// Shell of 1 × 1 with moved inner nodes: E = 3, h = 0.01, ν = 0.3.
struct Sheet {
    kind: Shell,
    elements: u32,
    membrane: &'static str,
    supports: [&'static str; 4],
    loads: String,
    analysis: &'static str,
}

impl Sheet {
    fn text(&self) -> String {
        let Self { kind, elements, membrane, supports, loads, analysis } = self;
        let distorted = |[x, y]: [f64; 2]| {
            let inner = x * (1.0 - x) * y * (1.0 - y);
            [x + (1.3 * y - 0.4) * inner, y + (0.9 - 1.7 * x) * inner, 0.0]
        };
        let mut text = format!(
            "{analysis}\nmaterials.m = {{ density = 100, young = 3, poisson = 0.3, damping = {{ strain = 1e-3 }} }}\n{}fibre_axis = [1, 0, 0]\nmembrane = {membrane}\n{loads}\n{}",
            kind.body_on([1.0; 2], [*elements; 2], 0.01, distorted),
            kind.probe([1.0; 2], [1.0; 2], "record = [\"motion\", \"resultants\"]")
        );
        for (name, condition) in ["left", "right", "front", "back"].into_iter().zip(supports) {
            let _ = writeln!(
                text,
                "[[joints]]\nkind = \"support\"\nname = \"{name}\"\na = {{ body = \"s\", at = {} }}\n{condition}",
                kind.edge(name)
            );
        }
        text
    }

    fn run(&self) -> Run {
        Run::of(&parse(&self.text()))
    }
}

const STATICS: &str = "analysis = { kind = \"statics\", stop = { rule = \"energy\", tolerance = 1e-18 } }";
const SYMMETRIC: &str = "condition = \"symmetry\"";
const GUIDED: &str = "condition = \"guided\"\naxes = [\"z\"]";
const HELD: [&str; 4] = ["condition = \"hinged\""; 4];

fn sheet(kind: Shell, membrane: &'static str, supports: [&'static str; 4], prestrains: &[&str]) -> Sheet {
    let load = |keys: &&str| {
        format!("[[loads]]\nkind = \"surface_prestrain\"\nbody = \"s\"\naxis = [1, 0, 0]\n{keys}\n")
    };
    Sheet {
        kind,
        elements: 3,
        membrane,
        supports,
        loads: prestrains.iter().map(load).collect(),
        analysis: STATICS,
    }
}

/// A sheet that can move within two planes of symmetry takes the elongations, without stress, large ones too.
#[test]
fn a_free_sheet_takes_the_prescribed_strain() {
    for (kind, membrane) in KINDS.into_iter().flat_map(|kind| LAWS.map(|law| (kind, law))) {
        let supports = [SYMMETRIC, GUIDED, SYMMETRIC, GUIDED];
        for (keys, x, y) in [("strain = [0.03, 0.01, 0]", 1.03, 1.01), ("strain = [0.6, -0.3, 0]", 1.6, 0.7)]
        {
            let run = sheet(kind, membrane, supports, &[keys]).run();
            let what = format!("{kind:?} {membrane} {keys}");
            assert_relative(&what, run.last("p.x"), x, 1e-9);
            assert_relative(&what, run.last("p.y"), y, 1e-9);
            assert!(run.last("strain") < 1e-14, "{what}: {:e}", run.last("strain"));
            for name in ["p.nuu", "p.nvv", "p.nuv"] {
                assert!(run.last(name).abs() < 1e-9, "{what}: {name} {:e}", run.last(name));
            }
        }
    }
}

/// Rubber that is held at the stretches λ₁ and λ₂ has the forces G h (λ₁² − 1/(λ₁ λ₂)²) per present length and the energy of the
/// stretches, for any stretch.
#[test]
fn held_rubber_has_the_forces_of_its_stretch() {
    for (kind, membrane) in KINDS.into_iter().flat_map(|kind| [RUBBER, RUBBER_FIELD].map(|law| (kind, law))) {
        for (keys, stretches) in [
            (["strain = [-0.2, -0.2, 0]", ""], [1.25, 1.25]),
            (["strain = [-0.5, -0.2, 0]", ""], [2.0, 1.25]),
            (["strain = [-0.3, -0.1, 0]", "strain = [-0.2, -0.1, 0]"], [2.0, 1.25]),
        ] {
            let loads: Vec<_> = keys.into_iter().filter(|keys| !keys.is_empty()).collect();
            let run = sheet(kind, membrane, HELD, &loads).run();
            let what = format!("{kind:?} {membrane} {loads:?}");
            let [a, b]: [f64; 2] = stretches;
            let thin = (a * b).powi(-2);
            assert_relative(&what, run.last("p.nuu"), SHEAR * (a * a - thin), 1e-10);
            assert_relative(&what, run.last("p.nvv"), SHEAR * (b * b - thin), 1e-10);
            assert_relative(&what, run.last("strain"), 0.5 * SHEAR * (a * a + b * b + thin - 3.0), 1e-10);
        }
    }
}

/// A strip of rubber with a prestretch 1.5 that is let go of has its free length; pulled by a force it has the stretch of the free strip.
#[test]
fn a_prestretched_strip_is_a_shorter_strip() {
    for kind in KINDS {
        let stretch = 2.0_f64;
        // Per present length of the free strip, whose thickness is that of the same volume: h λ₁ λ₂ of the reference shape.
        let [along, across] = [1.0 / 1.5, 0.8];
        let force = SHEAR * (stretch - stretch.powi(-2)) / along;
        let edge = kind.edge("right").replace("{ ", "").replace(" }", "");
        let mut own = sheet(
            kind,
            RUBBER,
            [SYMMETRIC, GUIDED, SYMMETRIC, GUIDED],
            &["strain = [-0.3333333333333333, -0.2, 0]"],
        );
        let _ = write!(
            own.loads,
            "[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\n{edge}\nforce = [{force}, 0, 0]\n"
        );
        let run = own.run();
        assert_relative(&format!("{kind:?}, length"), run.last("p.x"), stretch * along, 1e-9);
        assert_relative(&format!("{kind:?}, width"), run.last("p.y"), stretch.powf(-0.5) * across, 1e-9);
        let energy = 0.5 * SHEAR * (stretch * stretch + 2.0 / stretch - 3.0);
        assert_relative(&format!("{kind:?}, energy"), run.last("strain"), energy, 1e-9);
    }
}

/// A tension field has its tension in the reference shape. Heated by more than the strain of the tension it is slack; heated in one
/// direction only it has the uniaxial tension E h ε of the other.
#[test]
fn a_tension_field_has_its_tension_until_it_is_slack() {
    for kind in KINDS {
        let forces = |loads: &[&str]| {
            let run = sheet(kind, FIELD, HELD, loads).run();
            ["p.nuu", "p.nvv"].map(|name| run.last(name))
        };
        let tension = "tension = [3e-4, 2e-4, 0]";
        let [nuu, nvv] = forces(&[tension]);
        assert_relative(&format!("{kind:?}, 11"), nuu, 3e-4, 1e-9);
        assert_relative(&format!("{kind:?}, 22"), nvv, 2e-4, 1e-9);
        let [nuu, nvv] = forces(&[tension, "strain = [0.02, 0.02, 0]"]);
        assert!(nuu.abs() < 1e-6 && nvv.abs() < 1e-6, "{kind:?}: {nuu:e} {nvv:e}");
        let [nuu, nvv] = forces(&[tension, "strain = [0, 0.02, 0]"]);
        let strain = (3e-4 - 0.3 * 2e-4) / 0.03;
        assert!((nuu / (0.03 * strain) - 1.0).abs() < 1e-3, "{kind:?}: {nuu:e}");
        assert!(nvv.abs() < 1e-6, "{kind:?}: {nvv:e}");
    }
}

/// A stretched membrane vibrates with f² = (n/ρh) (1/a² + 1/b²)/4.
#[test]
fn a_stretched_membrane_vibrates() {
    let rubber = SHEAR * (1.25_f64.powi(2) - 1.25_f64.powi(-4));
    for (kind, tolerance) in [(Thin, 2e-2), (Quadrilaterals, 3e-2)] {
        for (membrane, keys, tension) in
            [(FIELD, "tension = [3e-3, 3e-3, 0]", 3e-3), (RUBBER_FIELD, "strain = [-0.2, -0.2, 0]", rubber)]
        {
            let analysis = "analysis = { kind = \"modes\", about = \"equilibrium\", count = 1 }";
            let own = Sheet { elements: 8, analysis, ..sheet(kind, membrane, HELD, &[keys]) };
            let exact = (0.5 * tension / (100.0 * 0.01_f64)).sqrt();
            assert_relative(&format!("{kind:?} {membrane}"), own.run().last("frequency"), exact, tolerance);
        }
    }
}

/// A heated square plate of rubber with immovable hinged edges buckles at ε = π² h²/(6 (1 + ν) a²), with ν = 0.5: the first-order
/// response of its forces is that of the linear law.
#[test]
fn a_heated_plate_of_rubber_buckles() {
    let critical = std::f64::consts::PI.powi(2) * 1e-4 / (6.0 * 1.5);
    let strain = format!("strain = [{critical:e}, {critical:e}, 0]");
    let analysis = "analysis = { kind = \"buckling\", count = 1 }";
    for (kind, tolerance) in [(Thin, 2e-3), (Quadrilaterals, 4e-2)] {
        let own = Sheet { elements: 8, analysis, ..sheet(kind, RUBBER, HELD, &[&strain]) };
        let text = own.text().replace("poisson = 0.3", "poisson = 0.4999999");
        assert_relative(&format!("{kind:?}"), Run::of(&parse(&text)).last("factor"), 1.0, tolerance);
    }
}

/// Sheet that is heated, bent and cooled in time, clamped on one side.
fn heated(kind: Shell, membrane: &'static str, scheme: &str, step: f64) -> Model {
    let keys =
        "strain = [0.2, 0.1, 0.05]\ncurvature = [2, 1, -1]\ntime = { kind = \"sine\", frequency = 0.2 }";
    let mut own = sheet(kind, membrane, HELD, &[keys, "strain = [-0.1, -0.2, 0]"]);
    own.analysis = "";
    let text = own.text();
    let clamped = text.split("[[joints]]").take(2).collect::<Vec<_>>().join("[[joints]]");
    parse(&format!(
        "analysis = {{ kind = \"dynamics\", duration = 1.2, step = {step}{scheme} }}\n{}",
        clamped.replace("hinged", "clamped")
    ))
}

/// The work of the prescribed strains closes the energy balance; its error falls with the second power of the step, for a tension field
/// with the first power at least, since wrinkles are kinks of the forces.
#[test]
fn the_energy_balance_closes() {
    for (kind, membrane) in KINDS.into_iter().flat_map(|kind| [RUBBER, FIELD].map(|law| (kind, law))) {
        for scheme in ["", ", scheme = \"energy\""] {
            let errors = [2e-2, 1e-2].map(|step| {
                let run = Run::of(&heated(kind, membrane, scheme, step));
                let part = |name: &str| run.last(name);
                let stored = part("kinetic") + part("strain") + part("potential") - run.column("strain")[0];
                assert!(part("work").abs() > 1e-6, "{kind:?} {membrane}: work {:e}", part("work"));
                (stored - part("work") + part("dissipated")).abs() / part("work").abs()
            });
            let fall = if membrane == RUBBER { 0.4 } else { 0.6 };
            assert!(
                errors[0] < 5e-2 && errors[1] < fall * errors[0],
                "{kind:?} {membrane} {scheme}: {errors:?}"
            );
        }
    }
}

/// Constant prescribed strains do no work: the energy-momentum scheme preserves the energy.
#[test]
fn constant_prestrains_preserve_the_energy() {
    for (kind, membrane) in KINDS.into_iter().flat_map(|kind| [RUBBER, STIFF_FIELD].map(|law| (kind, law))) {
        let mut model = heated(
            kind,
            membrane,
            ", scheme = \"energy\", stop = { rule = \"energy\", tolerance = 1e-16 }",
            2e-2,
        );
        model.loads.remove(0);
        model.materials.values_mut().for_each(|material| material.damping.strain = 0.0);
        let run = Run::of(&model);
        let error = run.energy_error();
        assert!(run.largest("kinetic") > 0.1 * run.column("strain")[0], "{kind:?} {membrane}");
        assert!(error < 1e-9, "{kind:?} {membrane}: {error:e}");
    }
}

/// Other units change no result.
#[test]
fn results_do_not_depend_on_units() {
    let scales = Scales { length: 0.037, time: 13.0, force: 2.9e5 };
    for (kind, membrane) in KINDS.into_iter().flat_map(|kind| [RUBBER, FIELD].map(|law| (kind, law))) {
        let model = heated(kind, membrane, "", 2e-2);
        let (own, other) = (Run::of(&model), Run::of(&model.scaled(&scales)));
        let (a, b) = (own.last("p.z"), other.last("p.z") * scales.length);
        assert!((a - b).abs() < 1e-8, "{kind:?} {membrane}: {a} and {b}");
    }
}

/// Tensions that a law cannot have are rejected with what is expected.
#[test]
fn wrong_tensions_are_rejected() {
    for (membrane, keys, part) in [
        (RUBBER, "tension = [1e-4, 0, 0]", "1/λ − 1"),
        (RUBBER_FIELD, "tension = [1e-4, 0, 0]", "1/λ − 1"),
        (FIELD, "tension = [1e-4, -1e-5, 0]", "zero or more"),
        (FIELD, "tension = [1e-4, 1e-4, 1.1e-4]", "zero or more"),
    ] {
        let error = Model::parse(&sheet(Thin, membrane, HELD, &[keys]).text()).unwrap_err().to_string();
        assert!(error.contains("loads[0].tension") && error.contains(part), "{membrane} {keys}: {error}");
    }
    parse(&sheet(Thin, FIELD, HELD, &["tension = [1e-4, 1e-4, 1e-4]"]).text());
}
