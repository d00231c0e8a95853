//! Prescribed strains of both kinds of shells against closed forms.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use ancf::{Model, Scales};

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

fn run(text: &str) -> Run {
    Run::of(&parse(text))
}

const KINDS: [&str; 2] = ["shell", "shear_shell"];

/// Plate of a × b in the plane of x and y with the edges `u0`, `u1`, `v0`, `v1` and a probe of its middle and of its far corner.
struct Plate {
    kind: &'static str,
    elements: [usize; 2],
    sides: [f64; 2],
    thickness: f64,
    keys: &'static str,
}

impl Plate {
    fn text(&self) -> String {
        let Self { kind, elements: [n, m], sides: [a, b], thickness, keys } = self;
        let mut text = format!(
            "[[bodies]]\nkind = \"{kind}\"\nname = \"s\"\nthickness = {thickness:e}\nmaterial = \"m\"\n{keys}\n"
        );
        if *kind == "shell" {
            let _ = writeln!(
                text,
                "elements = [{n}, {m}]\nsurface = {{ kind = \"flat\", corner = [0, 0, 0], side_u = [{a}, 0, 0], side_v = [0, {b}, 0] }}"
            );
        } else {
            text += &self.mesh();
        }
        let record = "record = [\"motion\", \"resultants\"]";
        let [middle, corner] = if *kind == "shell" {
            ["[0.5, 0.5]".to_owned(), "[1, 1]".to_owned()]
        } else {
            [format!("[{}, {}, 0]", 0.5 * a, 0.5 * b), format!("[{a}, {b}, 0]")]
        };
        text + &format!(
            "[[probes]]\nname = \"middle\"\non = {{ body = \"s\", at = {middle} }}\n{record}\n\
             [[probes]]\nname = \"corner\"\non = {{ body = \"s\", at = {corner} }}\n{record}\n"
        )
    }

    fn mesh(&self) -> String {
        let Self { elements: [n, m], sides: [a, b], .. } = self;
        let node = |i: usize, j: usize| j * (n + 1) + i;
        let mut nodes = Vec::new();
        for (j, i) in (0..=*m).flat_map(|j| (0..=*n).map(move |i| (j, i))) {
            nodes.push([a * i as f64 / *n as f64, b * j as f64 / *m as f64, 0.0]);
        }
        let elements: Vec<_> = (0..*m)
            .flat_map(|j| (0..*n).map(move |i| (i, j)))
            .map(|(i, j)| [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)])
            .collect();
        let column = |i: usize| (0..=*m).map(|j| node(i, j)).collect::<Vec<_>>();
        let row = |j: usize| (0..=*n).map(|i| node(i, j)).collect::<Vec<_>>();
        let mut text = format!(
            "mesh.nodes = {nodes:?}\nmesh.elements = {elements:?}\nmesh.groups.left = {{ elements = [0] }}\n"
        );
        for (name, chain) in
            [("u_start", column(0)), ("u_end", column(*n)), ("v_start", row(0)), ("v_end", row(*m))]
        {
            let _ = writeln!(text, "mesh.groups.{name} = {{ edges = [{chain:?}] }}");
        }
        text
    }
}

fn edge(name: &str, condition: &str) -> String {
    format!(
        "[[joints]]\nkind = \"support\"\nname = \"{name}\"\na = {{ body = \"s\", at = {{ edge = \"{name}\" }} }}\ncondition = {condition}\n"
    )
}

fn all_edges(condition: &str) -> String {
    ["u_start", "u_end", "v_start", "v_end"].map(|name| edge(name, condition)).concat()
}

fn load(keys: &str) -> String {
    format!("[[loads]]\nkind = \"surface_prestrain\"\nbody = \"s\"\n{keys}\n")
}

const STATICS: &str = "[analysis]\nkind = \"statics\"\nstop = { rule = \"energy\", tolerance = 1e-14 }\n";

fn square(kind: &'static str, n: usize, thickness: f64) -> Plate {
    Plate { kind, elements: [n, n], sides: [1.0, 1.0], thickness, keys: "" }
}

/// A plate that can move within two planes of symmetry takes the elongations, without stress.
#[test]
fn a_free_plate_takes_the_prescribed_strain() {
    for kind in KINDS {
        let supports = edge("u_start", "\"symmetry\"") + &edge("v_start", "\"symmetry\"");
        let hold = match kind {
            "shell" => {
                "[[joints]]\nkind = \"support\"\nname = \"z\"\na = { body = \"s\", at = [0, 0] }\ncondition = \"guided\"\naxes = [\"z\"]\n"
            }
            _ => {
                "[[joints]]\nkind = \"support\"\nname = \"z\"\na = { body = \"s\", at = { node = 0 } }\ncondition = \"guided\"\naxes = [\"z\"]\n"
            }
        };
        let text = format!(
            "materials.m = {{ density = 1, young = 2e7, poisson = 0.3 }}\n{}{supports}{hold}{}{}{STATICS}",
            square(kind, 2, 0.02).text(),
            load("strain = [0.03, 0.01, 0]"),
            load("strain = [0.02, 0.02, 0]\naxis = [0, 1, 0]")
        );
        let series = run(&text);
        assert_relative(kind, series.last("corner.x"), 1.05, 1e-10);
        assert_relative(kind, series.last("corner.y"), 1.03, 1e-10);
        assert!(series.last("strain") < 1e-12, "{kind}: {:e}", series.last("strain"));
        for name in ["nuu", "nvv", "nuv", "muu"] {
            let n = series.last(&format!("middle.{name}"));
            assert!(n.abs() < 1e-5, "{kind}: {name} = {n:e}");
        }
    }
}

/// A plate between walls carries −E h ε/(1 − ν), and a stretched one its tension. The energy is that of the stress.
#[test]
fn a_held_plate_carries_the_stress() {
    for kind in KINDS {
        for (keys, exact) in
            [("strain = [-0.01, -0.01, 0]", 2e7 * 0.02 * 0.00995 / 0.7), ("tension = [500, 500, 0]", 500.0)]
        {
            let text = format!(
                "materials.m = {{ density = 1, young = 2e7, poisson = 0.3 }}\n{}{}{}{STATICS}",
                square(kind, 2, 0.02).text(),
                all_edges("\"hinged\""),
                load(keys)
            );
            let series = run(&text);
            for name in ["middle.nuu", "middle.nvv", "corner.nuu"] {
                assert_relative(name, series.last(name), exact, 1e-9);
            }
            let energy = exact * exact * (1.0 - 0.3) / (2e7 * 0.02);
            assert_relative(kind, series.last("strain"), energy, 1e-9);
        }
    }
}

/// A tension has no moments in the reference shape, also in a laminate with coupling. Its axis is its own.
#[test]
fn a_tension_is_exact_in_a_laminate() {
    for kind in KINDS {
        let plate = Plate {
            keys: "fibre_axis = [1, 0, 0]\nlayers = [{ angle = 0.3 }, { angle = -1.0 }]",
            ..square(kind, 2, 0.02)
        };
        let text = format!(
            "materials.m = {{ density = 1, young = 2e7, poisson = 0.3, orthotropic = {{ young = 1e6, shear = 5e5, transverse_shear = 4e5 }} }}\n\
             {}{}{}{STATICS}",
            plate.text(),
            all_edges("\"clamped\""),
            load("tension = [500, 100, 50]\naxis = [0, 1, 0]")
        );
        let series = run(&text);
        for (name, exact) in [("nuu", 100.0), ("nvv", 500.0), ("nuv", -50.0)] {
            assert_relative(name, series.last(&format!("middle.{name}")), exact, 1e-7);
        }
        assert!(series.last("middle.muu").abs() < 1e-6 * 500.0 * 0.02, "{kind}");
    }
}

/// A curvature of 2π/L rolls a strip up to a circle without stress, on the side opposite to the longer one.
#[test]
fn a_curvature_rolls_a_strip_up() {
    let kappa = TAU;
    for (kind, tolerance) in [("shell", 1e-4), ("shear_shell", 6e-3)] {
        let plate = Plate { kind, elements: [16, 1], sides: [1.0, 0.1], thickness: 0.01, keys: "" };
        let text = format!(
            "materials.m = {{ density = 1, young = 2e7, poisson = 0.3 }}\n{}{}{}{STATICS}",
            plate.text(),
            edge("u_start", "\"clamped\""),
            load(&format!("curvature = [{}, 0, 0]", -0.5 * kappa))
        );
        // Half of a circle above the plate: the lower side is longer.
        let series = run(&text);
        assert!(
            (series.last("corner.z") - 2.0 / PI).abs() < 3.0 * tolerance,
            "{kind}: {}",
            series.last("corner.z") * PI
        );
        assert!(series.last("corner.x").abs() < tolerance, "{kind}: {}", series.last("corner.x"));
        let energy = 0.5 * 2e7 * 0.1 * 1e-6 / 12.0 * (0.5 * kappa).powi(2);
        assert!(series.last("strain") < tolerance * energy, "{kind}: {:e}", series.last("strain") / energy);
    }
}

/// A heated square plate with immovable hinged edges buckles at ε = π² h²/(6 (1 + ν) a²).
#[test]
fn a_heated_plate_buckles() {
    for (kind, tolerance) in [("shell", 1e-3), ("shear_shell", 3e-2)] {
        let critical = PI * PI * 1e-4 / (6.0 * 1.3);
        let text = format!(
            "materials.m = {{ density = 1, young = 2e7, poisson = 0.3 }}\n{}{}{}[analysis]\nkind = \"buckling\"\ncount = 1\n",
            square(kind, 8, 0.01).text(),
            all_edges("\"hinged\""),
            load(&format!("strain = [{0:e}, {0:e}, 0]", critical))
        );
        assert_relative(kind, run(&text).last("factor"), 1.0, tolerance);
    }
}

/// A stretched membrane vibrates with f² = (n/ρh) (1/a² + 1/b²)/4.
#[test]
fn a_stretched_membrane_vibrates() {
    for (kind, tolerance) in [("shell", 2e-3), ("shear_shell", 1.5e-2)] {
        let plate = Plate { sides: [1.0, 0.5], ..square(kind, 12, 1e-3) };
        let text = format!(
            "materials.m = {{ density = 1000, young = 2e7, poisson = 0.3 }}\n{}{}{}[analysis]\nkind = \"modes\"\nabout = \"equilibrium\"\ncount = 1\n",
            plate.text(),
            all_edges("\"hinged\""),
            load("tension = [100, 100, 0]")
        );
        let exact = 0.5 * (100.0_f64 * (1.0 + 4.0)).sqrt();
        let unstretched = parse(&text.replace("\"equilibrium\"", "\"reference\""));
        let warnings = unstretched.diagnose().unwrap().warnings;
        assert!(warnings.iter().any(|text| text.contains("prestrain of `s`")), "{warnings:?}");
        assert_relative(kind, run(&text).last("frequency"), exact, tolerance);
    }
}

/// A damped plate that is heated and bent in time, in motion.
fn heated(kind: &'static str, scheme: &str, step: f64) -> Model {
    let plate = Plate { kind, elements: [3, 2], sides: [0.4, 0.3], thickness: 0.01, keys: "" };
    parse(&format!(
        "materials.m = {{ density = 1000, young = 1e6, poisson = 0.3, damping = {{ strain = 2e-3 }} }}\n{}{}{}\
         [analysis]\nkind = \"dynamics\"\nduration = 0.2\nstep = {step}\n{scheme}\n",
        plate.text(),
        edge("u_start", "\"clamped\""),
        load(
            "strain = [0.05, 0.02, 0.01]\ncurvature = [2, 1, -1]\ntime = { kind = \"sine\", frequency = 6 }"
        ),
    ))
}

/// The work of the prescribed strains closes the energy balance; its error falls with the second power of the step.
#[test]
fn the_energy_balance_closes() {
    for kind in KINDS {
        for scheme in ["", "scheme = \"energy\""] {
            let errors = [1e-3, 5e-4].map(|step| {
                let series = Run::of(&heated(kind, scheme, step));
                let part = |name: &str| series.last(name);
                let stored = part("kinetic") + part("strain") + part("potential");
                assert!(part("work").abs() > 1e-3, "{kind}: work {}", part("work"));
                (stored - part("work") + part("dissipated")).abs() / part("work").abs()
            });
            assert!(errors[0] < 2e-2 && errors[1] < 0.4 * errors[0], "{kind} {scheme}: {errors:?}");
        }
    }
}

/// Other units change no result.
#[test]
fn results_do_not_depend_on_units() {
    for kind in KINDS {
        let mut model = heated(kind, "", 2e-3);
        let tension = load("tension = [300, 100, 20]");
        model.loads.extend(
            parse(&format!(
                "materials.m = {{ density = 1, young = 2e7 }}\n{}{}{tension}{STATICS}",
                square(kind, 1, 0.02).text(),
                edge("u_start", "\"clamped\"")
            ))
            .loads,
        );
        let scales = Scales { length: 0.037, time: 13.0, force: 2.9e5 };
        let (own, other) = (Run::of(&model), Run::of(&model.scaled(&scales)));
        let (a, b) = (own.last("corner.z"), other.last("corner.z") * scales.length);
        assert!((a - b).abs() < 1e-9, "{kind}: {a} and {b}");
    }
}

/// Only the elements of a region are stressed.
#[test]
fn a_region_is_prestrained_alone() {
    let text = format!(
        "materials.m = {{ density = 1, young = 2e7, poisson = 0 }}\n{}{}{}{STATICS}",
        Plate { elements: [2, 1], ..square("shear_shell", 2, 0.02) }.text(),
        edge("u_start", "\"hinged\"")
            + &edge("v_start", "\"symmetry\"")
            + &edge("v_end", "\"guided\"\naxes = [\"y\", \"z\"]"),
        load("strain = [0.1, 0, 0]\nregion = \"left\"")
    );
    let series = run(&text);
    assert_relative("free end", series.last("corner.x"), 1.05, 1e-9);
    assert_relative("middle", series.last("middle.x"), 0.55, 1e-9);
}

/// Errors name their key and what is expected.
#[test]
fn wrong_prestrains_are_rejected() {
    let model = |keys: &str| {
        format!(
            "materials.m = {{ density = 1, young = 2e7 }}\n{}{}{}{STATICS}",
            square("shell", 1, 0.02).text(),
            edge("u_start", "\"clamped\""),
            load(keys)
        )
    };
    for (keys, key, part) in [
        ("axis = [0, 0, 1]", "axis", "nowhere normal"),
        ("axis = [0, 0, 0]", "axis", "direction"),
        ("tension = [2e5, 0, 0]", "tension", "times E h"),
        ("strain = [-0.7, 0, 0]", "strain", "-0.5"),
        ("region = \"left\"", "region", "shear-deformable"),
    ] {
        let error = Model::parse(&model(keys)).unwrap_err().to_string();
        assert!(error.contains(&format!("loads[0].{key}")) && error.contains(part), "{keys}: {error}");
    }
}
