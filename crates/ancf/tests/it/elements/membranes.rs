//! Laws of membranes: rubber and tension fields.

use ancf::Model;
use ancf::mechanics::shells::{MembraneEnergy, MembraneLaw};
use nalgebra::{Matrix3, Vector3};

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::random::Random;
use crate::common::solutions::Run;

const LAWS: [MembraneLaw; 4] = {
    let (linear, rubber) = (
        MembraneEnergy::Linear { stiffness: 2.0, poisson: 0.3 },
        MembraneEnergy::NeoHookean { stiffness: 0.7 },
    );
    [
        MembraneLaw { energy: linear, tension_field: None },
        MembraneLaw { energy: rubber, tension_field: None },
        MembraneLaw { energy: linear, tension_field: Some(1e-3) },
        MembraneLaw { energy: rubber, tension_field: Some(1e-3) },
    ]
};

/// Forces are the derivatives of the energy, and the stiffness those of the forces: in tension, wrinkled and slack states.
#[test]
fn forces_and_stiffness_are_derivatives() {
    let mut random = Random(3);
    for law in LAWS {
        for shift in [0.3, 0.0, -0.2] {
            for _ in 0..20 {
                let strain = random.vector3() * 0.2 + Vector3::new(shift, shift, 0.0);
                let state = law.state(&strain);
                let difference = |k: usize, h: f64| law.state(&(strain + Vector3::ith(k, h)));
                for k in 0..3 {
                    let h = 1e-4;
                    let [far, near] = [2.0 * h, h].map(|h| [difference(k, h), difference(k, -h)]);
                    // A change between tension, wrinkles and slack has a jump in the stiffness.
                    let of = |pair: &[ancf::mechanics::shells::MembraneState; 2], h: f64| {
                        (
                            (pair[0].energy - pair[1].energy) / (2.0 * h),
                            (pair[0].force - pair[1].force) / (2.0 * h),
                        )
                    };
                    let ((e2, f2), (e1, f1)) = (of(&far, 2.0 * h), of(&near, h));
                    let jump = far.iter().any(|other| (other.stiffness - state.stiffness).amax() > 0.05);
                    let force = (4.0 * e1 - e2) / 3.0;
                    assert!(
                        (force - state.force[k]).abs() < 1e-6,
                        "{law:?} {strain:?}: {force} for {}",
                        state.force[k]
                    );
                    let column: Vector3<f64> = (f1 * 4.0 - f2) / 3.0;
                    let error = (column - state.stiffness.column(k)).amax();
                    assert!(jump || error < 1e-6, "{law:?} {strain:?}, column {k}: {error:e}");
                }
                let eigenvalues = state.stiffness.symmetric_eigenvalues();
                assert!(eigenvalues.min() > 0.0, "{law:?} {strain:?}: {eigenvalues:?}");
                assert_eq!(state.stiffness, state.stiffness.transpose());
            }
        }
    }
}

/// Without strain all laws are linear ones.
#[test]
fn small_strains_are_linear() {
    let rubber = LAWS[1].state(&Vector3::zeros()).stiffness;
    let (a, nu) = (3.0 * 0.7 / 0.75, 0.5);
    let plane = Matrix3::new(a, a * nu, 0.0, a * nu, a, 0.0, 0.0, 0.0, 0.5 * a * (1.0 - nu));
    assert!((rubber - plane).amax() < 1e-14);
    let strain = Vector3::new(3e-9, -1e-9, 2e-9);
    assert!((LAWS[1].state(&strain).force - plane * strain).amax() < 1e-15);
    assert!((LAWS[1].state(&strain).energy / (0.5 * strain.dot(&(plane * strain))) - 1.0).abs() < 1e-6);
}

/// Square of side 1 and thickness 0.01 with E = 3, free to contract, whose right edge is pulled by `force` per length.
fn strip(membrane: &str, force: f64, elements: [u32; 2]) -> String {
    format!(
        "analysis = {{ kind = \"statics\" }}\nmaterials.m = {{ density = 1, young = 3, poisson = 0.3 }}\n\
         [[bodies]]\nkind = \"shell\"\nname = \"s\"\nelements = {elements:?}\nthickness = 0.01\nmaterial = \"m\"\n{membrane}\n\
         surface = {{ kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0] }}\n\
         [[joints]]\nkind = \"support\"\nname = \"l\"\na = {{ body = \"s\", at = {{ edge = \"u_start\" }} }}\ncondition = \"symmetry\"\n\
         [[joints]]\nkind = \"support\"\nname = \"b\"\na = {{ body = \"s\", at = {{ edge = \"v_start\" }} }}\ncondition = \"symmetry\"\n\
         [[joints]]\nkind = \"support\"\nname = \"z\"\na = {{ body = \"s\", at = {{ edge = \"u_end\" }} }}\ncondition = \"guided\"\naxes = [\"z\"]\n\
         [[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"u_end\"\nforce = [{force}, 0, 0]\n\
         [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = [1, 1] }}\nrecord = [\"motion\", \"resultants\"]\n"
    )
}

/// Uniaxial tension of incompressible rubber: f = G h (λ − 1/λ²), width λ^(−1/2).
#[test]
fn rubber_strip_in_tension() {
    for stretch in [1.2, 2.0, 5.0_f64] {
        let force = 0.01 * (stretch - stretch.powi(-2));
        let run = Run::of(&parse(&strip("membrane = { law = \"neo_hookean\" }", force, [2, 1])));
        assert_relative("length", run.last("p.x"), stretch, 1e-9);
        assert_relative("width", run.last("p.y"), stretch.powf(-0.5), 1e-9);
        assert_relative("second Piola-Kirchhoff force", run.last("p.nuu"), force / stretch, 1e-9);
        let energy = 0.5 * 0.01 * (stretch * stretch + 2.0 / stretch - 3.0);
        assert_relative("energy", run.last("strain"), energy, 1e-9);
    }
}

/// Tube of incompressible rubber with fixed ends: p = G h (1 − λ⁻⁴)/R.
#[test]
fn rubber_tube_under_pressure() {
    for stretch in [1.5_f64, 2.5] {
        let pressure = 0.01 * (1.0 - stretch.powi(-4));
        let mut text = format!(
            "analysis = {{ kind = \"statics\" }}\nmaterials.m = {{ density = 1, young = 3, poisson = 0.3 }}\n\
             [[bodies]]\nkind = \"shell\"\nname = \"s\"\nelements = [4, 1]\nthickness = 0.01\nmaterial = \"m\"\n\
             membrane = {{ law = \"neo_hookean\" }}\n\
             surface = {{ kind = \"revolved\", from = [1, 0, 0], to = [1, 0, 0.5], center = [0, 0, 0], axis = [0, 0, 1], angle = {} }}\n\
             [[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\npressure = {pressure}\n\
             [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = [0, 0] }}\n",
            std::f64::consts::FRAC_PI_2
        );
        for edge in ["u_start", "u_end", "v_start", "v_end"] {
            text += &format!(
                "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"s\", at = {{ edge = \"{edge}\" }} }}\ncondition = \"symmetry\"\n"
            );
        }
        let run = Run::of(&parse(&text));
        assert_relative("radius", run.last("p.x"), stretch, 2e-3);
    }
}

/// Strip under tension P and a moment M in its plane, between a plane of symmetry and a rigid edge. It is wrinkled over H − c, c = 3 (H/2 − M/P),
/// and has the curvature κ = 2 P/(E h c²). Source: Stein & Hedgepeth (1961).
#[test]
fn stretched_strip_with_wrinkles() {
    let (tension, ratio) = (3e-6, 0.3);
    let text = format!(
        "analysis = {{ kind = \"statics\" }}\nmaterials.m = {{ density = 1, young = 3, poisson = 0 }}\n\
         [[bodies]]\nkind = \"shell\"\nname = \"s\"\nelements = [2, 20]\nthickness = 0.01\nmaterial = \"m\"\nmembrane = {{ tension_field = true }}\n\
         surface = {{ kind = \"flat\", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0] }}\n\
         [[bodies]]\nkind = \"rigid\"\nname = \"hub\"\ncenter = [1, 0.5, 0]\nmass = 1\ninertia = [1, 1, 1]\n\
         [[joints]]\nkind = \"support\"\nname = \"l\"\na = {{ body = \"s\", at = {{ edge = \"u_start\" }} }}\ncondition = \"symmetry\"\n\
         [[joints]]\nkind = \"support\"\nname = \"r\"\na = {{ body = \"s\", at = {{ edge = \"u_end\" }} }}\n\
         b = {{ body = \"hub\", at = \"center\" }}\ncondition = \"clamped\"\n\
         [[joints]]\nkind = \"planar\"\nname = \"plane\"\na = {{ body = \"hub\", at = \"center\" }}\nnormal = [0, 0, 1]\n\
         [[joints]]\nkind = \"support\"\nname = \"y\"\na = {{ body = \"s\", at = [0, 0.5] }}\ncondition = \"guided\"\naxes = [\"y\"]\n\
         [[loads]]\nkind = \"force\"\non = {{ body = \"hub\", at = \"center\" }}\nforce = [{tension}, 0, 0]\n\
         [[loads]]\nkind = \"moment\"\non = {{ body = \"hub\", at = \"center\" }}\nmoment = [0, 0, {}]\n\
         [[probes]]\nname = \"p\"\non = {{ body = \"hub\", at = \"center\" }}\nrecord = [\"rotation\"]\n",
        ratio * tension
    );
    let run = Run::of(&parse(&text));
    let angle = 2.0 * run.last("p.e3").asin();
    let width = 3.0 * (0.5 - ratio);
    assert_relative("rotation", angle, 2.0 * tension / (0.03 * width * width), 1e-2);
    let flat = parse(&text.replace("tension_field = true", "tension_field = false"));
    let angle = 2.0 * Run::of(&flat).last("p.e3").asin();
    assert_relative("rotation without wrinkles", angle, 12.0 * ratio * tension / 0.03, 1e-2);
}

/// The keys of a law require one isotropic material.
#[test]
fn wrong_membranes_are_rejected() {
    let text = strip("membrane = { law = \"neo_hookean\" }", 0.01, [1, 1]);
    for (part, other, key) in [
        ("thickness", "layers = [{ angle = 0 }, { angle = 1 }]\nthickness", "bodies[0].membrane"),
        ("neo_hookean", "rubber", "bodies[0].membrane.law"),
    ] {
        let error = Model::parse(&text.replacen(part, other, 1)).unwrap_err().to_string();
        assert!(error.contains(key), "{other}: {error}");
    }
}
