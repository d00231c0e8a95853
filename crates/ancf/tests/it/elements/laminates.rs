//! Laminated shells: stiffness of the classical theory of laminates, and rejected data.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, FRAC_PI_6};

use ancf::Model;
use ancf::mechanics::shells::{Laminate, Ply, PlyElasticity, ShellSection};
use ancf::record::Series;
use ancf::simulate;
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

use crate::common::assertions::assert_near;

/// Plies of E_L = 25, E_T = 1, G_LT = 0.5, ν_LT = 0.25 and unit thickness in total.
pub(super) fn laminate(angles: &[f64]) -> Laminate {
    let elasticity =
        PlyElasticity { young: [25.0, 1.0], poisson: 0.25, shear: 0.5, transverse_shear: [0.5, 0.2] };
    let thickness = 1.0 / angles.len() as f64;
    let ply = |&angle: &f64| Ply { elasticity, density: 1.0, thickness, angle };
    Laminate::new(angles.iter().map(ply).collect())
}

/// Strains and curvatures of given forces and moments.
pub(super) fn deformed(section: &ShellSection, loads: [f64; 6]) -> Vector6<f64> {
    let mut stiffness = Matrix6::zeros();
    let ShellSection { membrane, coupling, bending, .. } = section;
    let blocks: [(usize, usize, &Matrix3<f64>); 4] =
        [(0, 0, membrane), (0, 3, coupling), (3, 0, coupling), (3, 3, bending)];
    for (i, j, block) in blocks {
        stiffness.fixed_view_mut::<3, 3>(i, j).copy_from(block);
    }
    stiffness.lu().solve(&Vector6::from(loads)).unwrap()
}

/// Closed forms of A, B, D and of strips under N_x or M_x. Data computed by exact integration of the plies.
#[test]
fn stiffness_is_that_of_the_classical_theory() {
    let cross = laminate(&[0.0, FRAC_PI_2]).section();
    let near = |name: &str, ours: f64, exact: f64| assert_near(name, ours, exact, 1e-11);
    near("A11", cross.membrane[(0, 0)], 13.032581453634);
    near("A12", cross.membrane[(0, 1)], 0.250626566416);
    near("B11", cross.coupling[(0, 0)], -3.007518796992);
    near("B22", cross.coupling[(1, 1)], 3.007518796992);
    near("D11", cross.bending[(0, 0)], 1.08604845447);
    near("D66", cross.bending[(2, 2)], 0.041666666667);
    let strip = deformed(&cross, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    near("eps_x", strip[0], 0.2128);
    near("eps_y", strip[1], -0.004092307692308);
    near("kappa_x", strip[3], 0.5892923076923);
    let angled = laminate(&[FRAC_PI_4, -FRAC_PI_4]).section();
    near("A66", angled.membrane[(2, 2)], 6.390977443609);
    near("B16", angled.coupling[(0, 2)], -1.503759398496);
    let strip = deformed(&angled, [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    near("kappa_xy", strip[5], 0.589292307692);
    let symmetric = laminate(&[FRAC_PI_6, -FRAC_PI_6, -FRAC_PI_6, FRAC_PI_6]).section();
    near("D16", symmetric.bending[(0, 2)], 0.485002713797);
    assert_eq!(symmetric.coupling, Matrix3::zeros());
    let bent = deformed(&symmetric, [0.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
    near("kappa_xy", bent[5], -1.664047791266);
    let single = deformed(&laminate(&[FRAC_PI_6]).section(), [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    near("shear", single[2], -0.619208163706);
}

/// The stresses of plies, integrated over the thickness, are the resultants of the section.
#[test]
fn stresses_sum_up_to_the_resultants() {
    let laminate = laminate(&[0.3, 1.2, -0.7]);
    let section = laminate.section();
    let (strain, curvature) = (Vector3::new(0.1, -0.2, 0.3), Vector3::new(0.5, 0.2, -0.4));
    let [mut force, mut moment] = [Vector3::zeros(); 2];
    // Three Gauss points per ply.
    let x = 0.6_f64.sqrt();
    for ply in 0..3 {
        for (at, weight) in [(-x, 5.0 / 18.0), (0.0, 8.0 / 18.0), (x, 5.0 / 18.0)] {
            let z = -0.5 + (f64::from(ply) + 0.5 * (1.0 + at)) / 3.0;
            let stress = laminate.stress(z, &strain, &curvature) * (weight / 3.0);
            force += stress;
            moment += stress * z;
        }
    }
    let exact = section.membrane * strain + section.coupling * curvature;
    assert!((force - exact).norm() < 1e-13 * exact.norm(), "{force}");
    let exact = section.coupling * strain + section.bending * curvature;
    assert!((moment - exact).norm() < 1e-13 * exact.norm(), "{moment}");
}

/// A layer with the constants of an isotropic material is the isotropic shell.
#[test]
fn isotropic_layers_are_an_isotropic_shell() {
    let elasticity = PlyElasticity::isotropic(7.0, 0.3);
    let ply = |thickness, angle| Ply { elasticity, density: 2.0, thickness, angle };
    let ours = Laminate::new(vec![ply(0.4, 0.3), ply(0.7, 1.0)]).section();
    let exact = ShellSection::isotropic(7.0, 0.3, 2.0, 1.1);
    assert!((ours.membrane - exact.membrane).norm() < 1e-14 * exact.membrane.norm());
    assert!((ours.bending - exact.bending).norm() < 1e-14 * exact.bending.norm());
    assert!(ours.coupling.norm() < 1e-14 * exact.membrane.norm());
}

/// Strip of a 45/−45 laminate along `side`, clamped at a corner, under N = 1e-7 per length along its axis.
pub(super) fn strip(keys: &str, turned: bool) -> String {
    let [along, across] = if turned { ["[0, 4, 0]", "[-1, 0, 0]"] } else { ["[4, 0, 0]", "[0, 1, 0]"] };
    let force = if turned { "[0, 1e-7, 0]" } else { "[1e-7, 0, 0]" };
    format!(
        r#"
        materials.ply = {{ density = 1, young = 25, poisson = 0.25, orthotropic = {{ young = 1, shear = 0.5 }} }}
        [[bodies]]
        kind = "shell"
        name = "s"
        surface = {{ kind = "flat", corner = [0, 0, 0], side_u = {along}, side_v = {across} }}
        elements = [8, 2]
        thickness = 0.1
        material = "ply"
        {keys}
        [[joints]]
        kind = "clamp"
        name = "middle"
        a = {{ body = "s", at = [0.5, 0.5] }}
        [[loads]]
        kind = "edge_force"
        body = "s"
        edge = "u_end"
        force = {force}
        [[loads]]
        kind = "edge_force"
        body = "s"
        edge = "u_start"
        force = {}
        [[probes]]
        name = "A"
        on = {{ body = "s", at = [1, 1] }}
        [[probes]]
        name = "B"
        on = {{ body = "s", at = [1, 0] }}
        [analysis]
        kind = "statics"
        "#,
        force.replace("1e-7", "-1e-7")
    )
}

pub(super) fn last(text: &str, columns: &[&str]) -> Vec<f64> {
    let mut series = Series::new();
    let summary = simulate(&Model::parse(text).unwrap(), &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    columns.iter().map(|name| *series.column(name).unwrap().last().unwrap()).collect()
}

/// A free strip of a 45/−45 laminate twists under tension: κ_xy = 0.589292307692 N/(E h²) for these constants.
#[test]
fn unsymmetric_strips_twist() {
    let keys = "layers = [{ angle = 0.7853981633974483 }, { angle = -0.7853981633974483 }]";
    let found = last(&strip(keys, false), &["A.z", "B.z", "A.x"]);
    // w = −½ κ_xy x y about the middle: ±½ κ_xy at the corners x = 2, y = ±½.
    let exact = 0.5 * 0.589292307692 * 1e-7 / 0.1_f64.powi(2);
    assert!(((found[1] - found[0]).abs() / (2.0 * exact) - 1.0).abs() < 2e-3, "{found:?}, {exact}");
    let stretch = 2.0 * 0.604353846154 * 1e-7 / 0.1;
    assert!(((found[2] - 4.0) / stretch - 1.0).abs() < 2e-3, "{found:?}, {stretch}");
}

/// Fibres along a given axis do not depend on the directions of the patch.
#[test]
fn fibre_axes_do_not_depend_on_the_patch() {
    let straight = last(&strip("layers = [{ angle = 0.4 }]", false), &["A.x", "A.y"]);
    let turned = last(
        &strip("fibre_axis = [1, 0, 0]\nlayers = [{ angle = 1.9707963267948966 }]", true),
        &["A.y", "A.x"],
    );
    assert_near("along", turned[0], straight[0], 1e-10);
    assert_near("across", turned[1], -straight[1], 1e-10);
}

/// Paths of the keys that a strip with these keys is rejected for.
fn paths(keys: &str, from: &str, to: &str) -> Vec<String> {
    let text = strip(keys, false).replace(from, to);
    Model::parse(&text).expect_err(keys).0.iter().map(|error| error.path.clone()).collect()
}

#[test]
fn wrong_laminates_are_rejected() {
    for (keys, from, to, path) in [
        ("layers = [{ thickness = 0.05 }, {}]", "", "", "bodies[0].layers"),
        ("layers = [{ thickness = 0.05 }, { thickness = 0.04 }]", "", "", "bodies[0].layers"),
        ("layers = [{ thickness = -0.1 }]", "", "", "bodies[0].layers[0].thickness"),
        ("layers = [{ material = \"plie\" }]", "", "", "bodies[0].layers[0].material"),
        ("fibre_axis = [0, 0, 1]", "", "", "bodies[0].fibre_axis"),
        ("fibre_axis = [0, 0, 0]", "", "", "bodies[0].fibre_axis"),
        (
            "",
            "poisson = 0.25, orthotropic = { young = 1,",
            "poisson = 0.45, orthotropic = { young = 125,",
            "materials.ply.poisson",
        ),
        ("", "poisson = 0.25", "poisson = 0.25, law = \"neo_hookean\"", "materials.ply.law"),
        (
            "layers = [{}, { material = \"m\" }]",
            "materials.ply",
            "materials.m = { density = 1, young = 1, damping = { strain = 1 } }\nmaterials.ply",
            "bodies[0].layers[1].material",
        ),
    ] {
        let found = paths(keys, from, to);
        assert!(found.iter().any(|found| found == path), "{keys} {to}: {found:?}, expected {path}");
    }
    let beam = "sections.c = { kind = \"circle\", diameter = 0.1 }\n[[bodies]]\nkind = \"beam\"\nname = \"b\"\nfrom = [0, 0, 1]\n\
                to = [1, 0, 1]\nelements = 2\nsection = \"c\"\nmaterial = \"ply\"\n[[bodies]]\nkind = \"shell\"";
    let found = paths("", "[[bodies]]\n        kind = \"shell\"", beam);
    assert!(found.iter().any(|found| found == "bodies[0].material"), "{found:?}");
}

/// Layers of different density have their centre of mass off the middle surface, which is a warning.
#[test]
fn uneven_masses_are_warnings() {
    let keys = "layers = [{}, { material = \"heavy\" }]";
    let heavy = "materials.heavy = { density = 3, young = 25, poisson = 0.25 }\nmaterials.ply";
    let model = Model::parse(&strip(keys, false).replace("materials.ply", heavy)).unwrap();
    assert_near("mass", model.mass(), 4.0 * 0.1 * 2.0, 1e-12);
    let warnings = model.diagnose().unwrap().warnings;
    assert!(warnings.iter().any(|warning| warning.contains("centre of mass")), "{warnings:?}");
}
