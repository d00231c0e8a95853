//! Beams and cables bonded to shells.

use ancf::Model;

use super::shell_fields::{CLAMP, KINDS, Kind, MATERIAL, Sheet};
use crate::common::assertions::{assert_near, assert_relative};
use crate::common::models::parse;
use crate::common::solutions::Run;

/// Sheet of the sides 1 and 0.25 with lines of nodes along its middle.
fn sheet(kind: Kind, n: usize) -> Sheet {
    Sheet { sides: [1.0, 0.25], ..Sheet::unit(kind, [n, 2]) }
}

/// Body `rib` from the first to the second place, below the middle line of a sheet at the depth `z`.
fn rib(kind: &str, [from, to]: [f64; 2], z: f64, elements: usize, keys: &str) -> String {
    let formulation = if kind == "beam" { "formulation = \"linked\"\n" } else { "" };
    format!(
        "[[bodies]]\nkind = \"{kind}\"\nname = \"rib\"\nfrom = [{from:?}, 0.125, {z:?}]\nto = [{to:?}, 0.125, {z:?}]\n\
         elements = {elements}\n{formulation}section = \"r\"\nmaterial = \"m\"\n{keys}"
    )
}

const SECTION: &str = "sections.r = { kind = \"rectangle\", height = 0.03, width = 0.03 }\n";

/// Bond of the rib at a place to the sheet.
fn bond(at: &str, sheet: &Sheet) -> String {
    format!(
        "[[joints]]\nkind = \"bond\"\nname = \"t\"\na = {{ body = \"rib\", at = {at} }}\nb = {}\n",
        sheet.corner([0, 0])
    )
}

const STATICS: &str = "analysis = { kind = \"statics\" }\n";

/// A rib that nothing else supports hands its load to the shell: the reaction of the bond and that of the support balance it, with their
/// moments.
#[test]
fn reactions_of_bonds_balance_the_load_of_the_rib() {
    for kind in KINDS {
        let sheet = sheet(kind, 4);
        let (force, place) = ([0.3, 0.2, -0.4], [1.0, 0.125, -0.05]);
        let load = format!(
            "[[loads]]\nkind = \"force\"\non = {{ body = \"rib\", at = \"end\" }}\nforce = {force:?}\n"
        );
        let text = format!(
            "{STATICS}{MATERIAL}{SECTION}{}{}{CLAMP}{}{load}",
            sheet.body("thickness = 0.02"),
            rib("beam", [0.0, 1.0], place[2], 4, ""),
            bond("\"start\"", &sheet)
        )
        // A stiff material, so that the arms are those of the undeformed state.
        .replace("young = 1e6", "young = 1e13");
        let run = Run::of(&parse(&text));
        let arm = [1.0, 0.0, 0.0];
        let moment = [
            arm[1] * force[2] - arm[2] * force[1],
            arm[2] * force[0] - arm[0] * force[2],
            arm[0] * force[1] - arm[1] * force[0],
        ];
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            assert_near(&format!("{kind:?}, force {axis}"), run.last(&format!("t.f{axis}")), -force[k], 1e-6);
            assert_near(
                &format!("{kind:?}, moment {axis}"),
                run.last(&format!("t.m{axis}")),
                -moment[k],
                1e-5,
            );
            assert_near(
                &format!("{kind:?}, support {axis}"),
                run.last(&format!("c.f{axis}")),
                -force[k],
                1e-6,
            );
        }
    }
}

/// Large deflections do not depend on the direction of the rib, on the side of the sheet and on the place that names a body.
#[test]
fn bonds_are_invariant() {
    for kind in KINDS {
        let sheet = sheet(kind, 4);
        let tip = |[from, to]: [f64; 2], z: f64, at: &str| {
            let text = format!(
                "{STATICS}{MATERIAL}{SECTION}{}{}{CLAMP}{}\
                 [[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"u_end\"\nforce = [0, 0, {:?}]\n\
                 [[probes]]\nname = \"p\"\non = {}\nrecord = [\"motion\"]\n",
                sheet.body("thickness = 0.02"),
                rib("beam", [from, to], z, 4, ""),
                bond(at, &sheet),
                -6.0 * z.signum(),
                sheet.corner([1, 0])
            );
            let run = Run::of(&parse(&text));
            ["p.x", "p.y", "p.z"].map(|name| run.last(name))
        };
        let first = tip([0.0, 1.0], 0.025, "\"start\"");
        assert!(first[2] < -0.4, "{kind:?}: a small deflection {first:?}");
        for (name, other, sign) in [
            ("reversed", tip([1.0, 0.0], 0.025, "\"end\""), 1.0),
            ("other place", tip([0.0, 1.0], 0.025, "0.3"), 1.0),
            ("other side", tip([0.0, 1.0], -0.025, "\"start\""), -1.0),
        ] {
            for k in 0..3 {
                let expected = if k == 2 { sign * first[k] } else { first[k] };
                // The triangles are divided along one diagonal, which is another one seen from the other side of the middle line.
                assert_near(&format!("{kind:?}, {name}, {k}"), other[k], expected, 1e-7);
            }
        }
    }
}

/// A free plate with a rib below it keeps its momenta and its energy.
#[test]
fn stiffened_plates_in_flight_conserve_momenta_and_energy() {
    for kind in [Kind::Thin, Kind::Quads] {
        let sheet = sheet(kind, 4);
        let motion = "motion = { velocity = [0.3, 0.1, 0.2], spin = [0.5, 3.0, 1.0], about = [0, 0, 0] }\n";
        let text = format!(
            "{MATERIAL}{SECTION}{}{}{}[[probes]]\nname = \"p\"\non = {}\nrecord = [\"motion\"]\n\
             [analysis]\nkind = \"dynamics\"\nduration = 0.1\nstep = 2.5e-3\nscheme = \"energy\"\n[output]\nmomentum = true\n",
            sheet.body(&format!("thickness = 0.02\n{motion}")),
            rib("beam", [0.0, 1.0], -0.025, 4, motion),
            bond("\"start\"", &sheet),
            sheet.corner([1, 1])
        )
        .replace("young = 1e6", "young = 2e4");
        let run = Run::of(&parse(&text));
        let (kinetic, strain) = (run.column("kinetic"), run.column("strain"));
        let total: Vec<f64> = kinetic.iter().zip(strain).map(|(a, b)| a + b).collect();
        let drift = total.iter().map(|e| (e - total[0]).abs()).fold(0.0, f64::max);
        assert!(drift < 1e-8 * total[0], "{kind:?}: {drift:e} of {}", total[0]);
        assert!(strain.iter().any(|e| *e > 1e-4 * total[0]), "{kind:?}: no strain");
        for name in ["px", "py", "pz", "lx", "ly", "lz"] {
            let values = run.column(name);
            let size = ["x", "y", "z"].map(|axis| run.column(&format!("{}{axis}", &name[..1]))[0].abs());
            let size = size.into_iter().fold(0.0, f64::max);
            let off = values.iter().map(|x| (x - values[0]).abs()).fold(0.0, f64::max);
            assert!(off < 1e-8 * size, "{kind:?}, {name}: {off:e} of {size:e}");
        }
    }
}

/// The nodes of a rib on a thin shell may lie anywhere on it: more elements, and a line across the lines of its elements.
#[test]
fn ribs_on_thin_shells_need_no_common_nodes() {
    let deflection = |n: usize, elements: usize, from: [f64; 2], to: [f64; 2]| {
        let sheet = Sheet { sides: [1.0, 1.0], ..Sheet::unit(Kind::Thin, [n, n]) };
        let text = format!(
            "{STATICS}{MATERIAL}{SECTION}{}{CLAMP}{}[[bodies]]\nkind = \"beam\"\nname = \"rib\"\nfrom = [{:?}, {:?}, 0.03]\n\
             to = [{:?}, {:?}, 0.03]\nelements = {elements}\nformulation = \"linked\"\nsection = \"r\"\nmaterial = \"m\"\n\
             [[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"u_end\"\nforce = [0, 0, 1e-4]\n\
             [[probes]]\nname = \"p\"\non = {}\nrecord = [\"motion\"]\n",
            sheet.body("thickness = 0.02"),
            bond("\"start\"", &sheet),
            from[0],
            from[1],
            to[0],
            to[1],
            sheet.corner([1, 1])
        );
        Run::of(&parse(&text)).last("p.z")
    };
    let matched = deflection(8, 8, [0.0, 0.5], [1.0, 0.5]);
    assert_relative("more elements", deflection(8, 13, [0.0, 0.5], [1.0, 0.5]), matched, 2e-3);
    assert_relative("between lines", deflection(7, 9, [0.0, 0.5], [1.0, 0.5]), matched, 5e-3);
    let diagonal = [[0.0, 0.1], [1.0, 0.8]];
    let fine = deflection(12, 16, diagonal[0], diagonal[1]);
    assert_relative("across", deflection(6, 8, diagonal[0], diagonal[1]), fine, 1e-2);
}

/// Joints act between the nodes of a thin shell as at nodes.
#[test]
fn joints_act_between_nodes_of_thin_shells() {
    let deflection = |n: usize| {
        let sheet = sheet(Kind::Thin, n);
        let text = format!(
            "{STATICS}{MATERIAL}{}{CLAMP}[[bodies]]\nkind = \"rigid\"\nname = \"block\"\ncenter = [0.6, 0.125, 0.1]\nmass = 1\n\
             inertia = [1, 1, 1]\n[[joints]]\nkind = \"clamp\"\nname = \"bolt\"\na = {{ body = \"block\", at = [0.6, 0.125, 0] }}\n\
             b = {{ body = \"s\", at = [0.6, 0.5] }}\n\
             [[loads]]\nkind = \"force\"\non = {{ body = \"block\", at = \"center\" }}\nforce = [0, 0, 1e-3]\n\
             [[probes]]\nname = \"p\"\non = {{ body = \"block\", at = \"center\" }}\nrecord = [\"motion\"]\n",
            sheet.body("thickness = 0.02")
        );
        let run = Run::of(&parse(&text));
        assert_near("force of the bolt", run.last("bolt.fz"), -1e-3, 1e-9);
        run.last("p.z") - 0.1
    };
    // Nodes are at multiples of 1/5, not of 1/4 or 1/6.
    let exact = deflection(20);
    for n in [4, 6, 8] {
        assert_relative(&format!("{n} elements"), deflection(n), exact, 5e-3);
    }
}

/// Asserts that a model is rejected by a message with the given parts.
fn assert_rejected(text: &str, parts: &[&str]) {
    let error = Model::parse(text).and_then(|model| model.check().map(|()| model)).unwrap_err().to_string();
    assert!(parts.iter().all(|part| error.contains(part)), "{error}");
}

/// Bonds that have no meaning are rejected with the place.
#[test]
fn wrong_bonds_are_rejected() {
    for kind in [Kind::Thin, Kind::Quads] {
        let sheet = sheet(kind, 4);
        let model = |rib: &str, bond: &str| {
            format!("{STATICS}{MATERIAL}{SECTION}{}{rib}{CLAMP}{bond}", sheet.body("thickness = 0.02"))
        };
        let own = bond("\"start\"", &sheet);
        let over = "the nearest";
        assert_rejected(&model(&rib("beam", [0.0, 1.2], -0.025, 6, ""), &own), &["joints[1]", over]);
        let aside = rib("beam", [0.0, 1.0], -0.025, 4, "").replace("0.125", "0.3");
        assert_rejected(&model(&aside, &own), &["joints[1]", over]);
        let expected = if kind == Kind::Thin {
            "no longer than those of the shell"
        } else {
            "one element of the beam for each edge"
        };
        assert_rejected(&model(&rib("beam", [0.0, 1.0], -0.025, 2, ""), &own), &["joints[1]", expected]);
        let quadratic = rib("beam", [0.0, 1.0], -0.025, 4, "").replace("linked", "quadratic");
        assert_rejected(&model(&quadratic, &own), &["joints[1].a.body", "quadratic"]);
        let right = rib("beam", [0.0, 1.0], -0.025, 4, "");
        let ground = own.split("b = ").next().unwrap().to_owned() + "b = \"ground\"\n";
        assert_rejected(&model(&right, &ground), &["joints[1].b", "a place on a shell"]);
        let arm = own.replace("at = \"start\" }", "at = \"start\", offset = [0, 0, 0.1] }");
        assert_rejected(&model(&right, &arm), &["joints[1].a.offset", "an arm"]);
        let itself = "[[joints]]\nkind = \"bond\"\nname = \"t\"\na = { body = \"rib\", at = 0 }\nb = { body = \"rib\", at = \"end\" }\n";
        assert_rejected(&model(&right, itself), &["joints[1].b.body", "no shell"]);
        let missing = own.replace("body = \"rib\"", "body = \"rob\"");
        assert_rejected(&model(&right, &missing), &["joints[1].a.body", "rob"]);
    }
    let sheet_below = sheet(Kind::Thin, 4);
    let post =
        rib("beam", [0.5, 0.5], 0.0, 4, "").replace("to = [0.5, 0.125, 0.0]", "to = [0.5, 0.125, 1.0]");
    let text = format!(
        "{STATICS}{MATERIAL}{SECTION}{}{post}{CLAMP}{}",
        sheet_below.body("thickness = 0.02"),
        bond("\"start\"", &sheet_below)
    );
    assert_rejected(&text, &["joints[1]", "rises from the shell"]);
    let between = bond("\"start\"", &sheet(Kind::Quads, 4));
    let sheet = sheet(Kind::Quads, 4);
    let off = rib("beam", [0.0, 1.0], -0.025, 4, "").replace("0.125", "0.1");
    let text = format!("{STATICS}{MATERIAL}{SECTION}{}{off}{CLAMP}{between}", sheet.body("thickness = 0.02"));
    assert_rejected(&text, &["joints[1]", "node 0 of the beam", "over the nodes of the mesh"]);
}

/// A rib in one line of a curved shell, with elements shorter than those of the shell, keeps free states free of forces.
#[test]
fn rigid_motions_of_curved_stiffened_shells_are_free_of_stress() {
    let r = 1.05_f64;
    let (half, turn) = (0.5_f64.sqrt() * r, "axis = [0.3, -0.5, 0.8]");
    let text = format!(
        "{STATICS}{MATERIAL}{SECTION}[[bodies]]\nkind = \"shell\"\nname = \"s\"\nthickness = 0.02\nmaterial = \"m\"\nelements = [5, 3]\n\
         surface = {{ kind = \"revolved\", from = [-0.5, 0, 1], to = [0.5, 0, 1], center = [0, 0, 0], axis = [1, 0, 0], angle = {:?} }}\n\
         [[bodies]]\nkind = \"beam\"\nname = \"rib\"\nfrom = [0.1, 0, {r:?}]\nto = [0.1, {:?}, 0]\n\
         shape = {{ kind = \"arc\", through = [0.1, {:?}, {half:?}] }}\nelements = 8\nformulation = \"linked\"\nsection = \"r\"\nmaterial = \"m\"\n\
         [[bodies]]\nkind = \"rigid\"\nname = \"hub\"\ncenter = [0, 0, 0]\nmass = 1\ninertia = [1, 1, 1]\n\
         [[joints]]\nkind = \"support\"\nname = \"c\"\na = {{ body = \"s\", at = {{ edge = \"u_start\" }} }}\nb = {{ body = \"hub\", at = \"center\" }}\ncondition = \"clamped\"\n\
         [[joints]]\nkind = \"drive\"\nname = \"turn\"\na = {{ body = \"rib\", at = \"center\" }}\n{turn}\nangle = 1.2\ndisplacement = [0.2, 0.1, 0.4]\ntime = 1\n\
         [[joints]]\nkind = \"bond\"\nname = \"t\"\na = {{ body = \"rib\", at = \"start\" }}\nb = {{ body = \"s\", at = \"center\" }}\n",
        std::f64::consts::FRAC_PI_2,
        -r,
        -half
    );
    let run = Run::of(&parse(&text));
    let strain = run.last("strain");
    // The strain energy of a bending by this angle is E h³ L φ²/24, about 1.
    assert!(strain.abs() < 1e-12, "strain energy {strain:e}");
    assert_near("force of the bond", run.last("t.fz"), 0.0, 1e-7);
}

/// Two half rings around a whole cylinder, which a seam closes, start at the seam or pass it in their middle.
#[test]
fn rings_pass_seams() {
    let r = 1.015_f64;
    let radius = |first: f64| {
        let at = |angle: f64| [0.0, -r * (first + angle).sin(), r * (first + angle).cos()];
        let ring = |name: &str, start: f64| {
            let [from, through, to] = [0.0, 0.5, 1.0].map(|part| at(start + part * std::f64::consts::PI));
            format!(
                "[[bodies]]\nkind = \"beam\"\nname = \"{name}\"\nfrom = {from:?}\nto = {to:?}\nshape = {{ kind = \"arc\", through = {through:?} }}\n\
                 elements = 8\nformulation = \"linked\"\nsection = \"r\"\nmaterial = \"m\"\n\
                 [[joints]]\nkind = \"bond\"\nname = \"{name}\"\na = {{ body = \"{name}\", at = \"start\" }}\nb = {{ body = \"s\", at = \"center\" }}\n"
            )
        };
        let text = format!(
            "{STATICS}{MATERIAL}sections.r = {{ kind = \"rectangle\", height = 0.02, width = 0.02 }}\n\
             [[bodies]]\nkind = \"shell\"\nname = \"s\"\nelements = [16, 8]\nthickness = 0.01\nmaterial = \"m\"\n\
             surface = {{ kind = \"revolved\", from = [-0.6, 0, 1], to = [0.6, 0, 1], center = [0, 0, 0], axis = [1, 0, 0], angle = {:?} }}\n\
             [[joints]]\nkind = \"seam\"\nname = \"seam\"\na = {{ body = \"s\", at = {{ edge = \"u_start\" }} }}\nb = {{ body = \"s\", at = {{ edge = \"u_end\" }} }}\n\
             [[joints]]\nkind = \"support\"\nname = \"c\"\na = {{ body = \"s\", at = {{ edge = \"v_start\" }} }}\ncondition = \"clamped\"\n{}{}\
             [[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\npressure = 1e-3\n\
             [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = [0.125, 0.5] }}\nrecord = [\"motion\"]\n",
            std::f64::consts::TAU,
            ring("first", 0.0),
            ring("second", std::f64::consts::PI)
        );
        let run = Run::of(&parse(&text));
        run.last("p.y").hypot(run.last("p.z")) - 1.0
    };
    // The pressure of a long cylinder with a ring: p R²/(E h)/(1 + A β R/(2 h (R + e))), ν = 0.
    let decay = 3.0_f64.powf(0.25) * 10.0;
    let exact = 1e-7 / (1.0 + 4e-4 * decay / (2.0 * 0.01 * r));
    for first in [0.0, std::f64::consts::FRAC_PI_2] {
        assert_relative(&format!("from {first}"), radius(first), exact, 2e-2);
    }
    assert_relative("both", radius(0.0), radius(std::f64::consts::FRAC_PI_2), 2e-3);
}
