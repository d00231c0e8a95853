//! Buckling of columns beside other bodies.

use super::carried_loads::factors;

const YOUNG: f64 = 2e9;
const DIAMETER: f64 = 0.02;
const LENGTH: f64 = 0.8;

/// Materials and `columns` clamped at their feet, each with an axial force at its head.
fn columns(forces: &[f64], count: u32) -> String {
    let mut text = format!(
        "materials.m = {{ density = 1200, young = {YOUNG:e} }}\nsections.s = {{ kind = \"circle\", diameter = {DIAMETER} }}\n\
         analysis = {{ kind = \"buckling\", count = {count} }}\n"
    );
    for (k, force) in forces.iter().enumerate() {
        text += &format!(
            "[[bodies]]\nkind = \"beam\"\nname = \"b{k}\"\nfrom = [{k}, 0, 0]\nto = [{k}, {LENGTH}, 0]\nelements = 4\nformulation = \"linked\"\n\
             section = \"s\"\nmaterial = \"m\"\n\
             [[joints]]\nkind = \"clamp\"\nname = \"c{k}\"\na = {{ body = \"b{k}\", at = \"start\" }}\n\
             [[loads]]\nkind = \"force\"\non = {{ body = \"b{k}\", at = \"end\" }}\nforce = [0, {force}, 0]\n"
        );
    }
    text
}

/// Factors of a column in compression do not depend on columns in tension beside it, whose factors of the other sign are smaller by
/// orders of magnitude. Both directions of bending have the same factors.
#[test]
fn columns_in_tension_do_not_hide_a_column_in_compression() {
    let alone = factors(&columns(&[-1.0], 4));
    let euler = std::f64::consts::PI.powi(3) * YOUNG * DIAMETER.powi(4) / (256.0 * LENGTH * LENGTH);
    for (factor, exact) in alone.iter().zip([euler, euler, 9.0 * euler, 9.0 * euler]) {
        assert!((factor / exact - 1.0).abs() < 0.02, "{factor} for {exact}");
    }
    for tension in [1.0, 1e2, 1e4] {
        for count in [1, 4] {
            let forces = [tension, tension, tension, tension, -1.0, tension, tension];
            let beside = factors(&columns(&forces, count));
            assert_eq!(beside.len(), count as usize, "tension {tension}");
            for (factor, alone) in beside.iter().zip(&alone) {
                assert!(
                    (factor / alone - 1.0).abs() < 1e-6,
                    "tension {tension}, {count}: {factor} for {alone}"
                );
            }
        }
    }
}

/// A rigid body on the clamped section of a column changes nothing, also with redundant constraints: the joint of the body holds the
/// section as well.
#[test]
fn rigid_bodies_on_a_clamped_section_do_not_change_the_factors() {
    for formulation in ["linked", "continuum", "quadratic"] {
        let column = format!(
            "gravity = [0, -9.81, 0]\nmaterials.m = {{ density = 1200, young = {YOUNG:e} }}\n\
             sections.s = {{ kind = \"circle\", diameter = {DIAMETER} }}\nanalysis = {{ kind = \"buckling\", count = 2 }}\n\
             [[bodies]]\nkind = \"beam\"\nname = \"b\"\nfrom = [0.1, -0.2, 0.3]\nto = [0.1, {}, 0.3]\nelements = 2\n\
             formulation = \"{formulation}\"\nsection = \"s\"\nmaterial = \"m\"\n",
            LENGTH - 0.2
        );
        let foot = "[[joints]]\nkind = \"clamp\"\nname = \"c\"\na = { body = \"b\", at = \"start\" }\n";
        let alone = factors(&format!("{column}{foot}"));
        let beside = "[[bodies]]\nkind = \"rigid\"\nname = \"base\"\ncenter = [0, 0, 0]\nmass = 7\ninertia = [0.5, 0.4, 0.3]\n\
             [[bodies]]\nkind = \"rigid\"\nname = \"block\"\ncenter = [-0.4, -0.1, 0.2]\nmass = 12\ninertia = [0.3, 0.7, 0.6]\n\
             [[joints]]\nkind = \"clamp\"\nname = \"g\"\na = { body = \"base\", at = [0, 0, 0] }\n\
             [[joints]]\nkind = \"clamp\"\nname = \"c\"\na = { body = \"b\", at = \"start\" }\nb = { body = \"base\", at = [0.1, -0.2, 0.3] }\n\
             [[joints]]\nkind = \"clamp\"\nname = \"d\"\na = { body = \"b\", at = \"start\" }\nb = { body = \"block\", at = [0.1, -0.2, 0.3] }\n";
        let beside = factors(&format!("{column}{beside}"));
        assert_eq!(alone.len(), 2);
        for (factor, alone) in beside.iter().zip(&alone) {
            assert!((factor / alone - 1.0).abs() < 1e-8, "{formulation}: {factor} for {alone}");
        }
    }
}

/// A column between clamps buckles when one of them approaches: 4π² EI/L² = EA u/L, with a shortening that multiplies the load factor.
/// Loads are absent, so the work of the prescribed displacement alone determines the response.
#[test]
fn a_column_buckles_by_displacement_alone() {
    let (length, diameter) = (2.0, 0.02_f64);
    let shortening = 2e-4;
    let text = format!(
        "materials.m = {{ density = 1200, young = {YOUNG:e}, poisson = 0.3 }}\nsections.s = {{ kind = \"circle\", diameter = {diameter} }}\n\
         analysis = {{ kind = \"buckling\", count = 2 }}\n\
         [[bodies]]\nkind = \"beam\"\nname = \"b\"\nfrom = [0, 0, 0]\nto = [{length}, 0, 0]\nelements = 16\nsection = \"s\"\nmaterial = \"m\"\n\
         [[joints]]\nkind = \"clamp\"\nname = \"l\"\na = {{ body = \"b\", at = \"start\" }}\n\
         [[joints]]\nkind = \"drive\"\nname = \"r\"\na = {{ body = \"b\", at = \"end\" }}\ndisplacement = [-{shortening}, 0, 0]\n\
         time = {{ kind = \"ramp\", end = 1 }}\n"
    );
    let exact = 4.0 * std::f64::consts::PI.powi(2) * diameter.powi(2) / (16.0 * length * shortening);
    for factor in factors(&text) {
        assert!((factor / exact - 1.0).abs() < 5e-3, "{factor} for {exact}");
    }
}
