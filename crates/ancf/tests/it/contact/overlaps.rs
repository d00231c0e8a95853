//! Warnings of bodies in contact that overlap in the initial state.

use crate::common::models::parse;

fn warnings(bodies: &str, more: &str) -> Vec<String> {
    let text = format!(
        "materials.m = {{ density = 1000, young = 1e6 }}\nsections.r = {{ kind = \"circle\", diameter = 0.1 }}\n{bodies}{more}\
         [analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 0.1\n"
    );
    parse(&text).diagnose().unwrap().warnings
}

fn cable(name: &str, from: [f64; 3], to: [f64; 3]) -> String {
    format!(
        "[[bodies]]\nkind = \"cable\"\nname = \"{name}\"\nfrom = {from:?}\nto = {to:?}\nelements = 4\nsection = \"r\"\nmaterial = \"m\"\n\
         motion = {{ velocity = [0, 0, 1] }}\n"
    )
}

fn sheet(name: &str, z: f64) -> String {
    format!(
        "[[bodies]]\nkind = \"shear_shell\"\nname = \"{name}\"\nthickness = 0.1\nmaterial = \"m\"\nmotion = {{ velocity = [0, 0, 1] }}\n\
         mesh = {{ nodes = [[-1, -1, {z}], [1, -1, {z}], [1, 1, {z}], [-1, 1, {z}]], elements = [[0, 1, 2, 3]] }}\n"
    )
}

const CONTACT: &str = "[[contacts]]\nwith = { kind = \"bodies\" }\n";

fn is_named(warnings: &[String], names: &str) -> bool {
    warnings
        .iter()
        .any(|warning| warning.starts_with(&format!("bodies {names} overlap in the initial state")))
}

/// Cables that cross with a depth above 1 % of their radii, without a joint, are named. With a gap, or a joint, there is no warning.
#[test]
fn crossing_cables_are_named() {
    let crossing = |z: f64, more: &str| {
        let bodies =
            cable("a", [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]) + &cable("b", [0.0, -1.0, z], [0.0, 1.0, z]);
        warnings(&bodies, &format!("{CONTACT}stiffness = 1e4\n{more}"))
    };
    assert!(is_named(&crossing(0.09, ""), "`a` and `b`"), "{:?}", crossing(0.09, ""));
    let joint = "[[joints]]\nkind = \"spherical\"\nname = \"j\"\na = { body = \"a\", at = 1.0 }\nb = { body = \"b\", at = 1.0 }\n";
    for (z, more) in [(0.1, ""), (0.0995, ""), (0.0, joint)] {
        let found = crossing(z, more);
        assert!(!found.iter().any(|warning| warning.contains("overlap")), "{z}: {found:?}");
    }
}

/// Bodies that begin deep in an obstacle are named with their depth. Bodies that touch it, or are in the space of hollow obstacles, are
/// not.
#[test]
fn bodies_in_obstacles_are_named() {
    let named = |z: f64, with: &str| {
        let bodies = cable("a", [-1.0, 0.0, z], [1.0, 0.0, z]) + &sheet("s", z);
        let contact = format!("[[contacts]]\nwith = {with}\nstiffness = 1e4\nsurface_stiffness = 1e5\n");
        let found = warnings(&bodies, &contact).into_iter();
        found
            .filter(|warning| warning.contains("begins in the obstacle of `contacts[0]`"))
            .collect::<Vec<_>>()
    };
    let plane =
        |normal: f64| format!("{{ kind = \"plane\", point = [0, 0, 0], normal = [0, 0, {normal:?}] }}");
    let deep = named(0.2, &plane(-1.0));
    assert!(deep.len() == 2 && deep[0].starts_with("body `a`") && deep[0].contains("500 %"), "{deep:?}");
    let hollow = "{ kind = \"sphere\", center = [0, 0, 0], radius = 3, inside = true }";
    for (z, with) in [(0.2, plane(1.0).as_str()), (0.0497, &plane(1.0)), (0.0, hollow)] {
        assert!(named(z, with).is_empty(), "{:?}", named(z, with));
    }
    assert_eq!(named(0.04, &plane(1.0)).len(), 2);
}

/// Shells of both kinds and cables on them, in any order. Four pairs are counted.
#[test]
fn shells_that_overlap_are_named() {
    let keys = format!("{CONTACT}surface_stiffness = 1e5\n");
    let thin = "[[bodies]]\nkind = \"shell\"\nname = \"t\"\nthickness = 0.1\nmaterial = \"m\"\nelements = [2, 2]\n\
                motion = { velocity = [0, 0, 1] }\n\
                surface = { kind = \"flat\", corner = [-0.5, -0.5, 0.08], side_u = [1, 0, 0], side_v = [0, 1, 0] }\n";
    assert!(is_named(&warnings(&(sheet("s", 0.0) + thin), &keys), "`s` and `t`"));
    assert!(is_named(&warnings(&(thin.to_owned() + &sheet("s", 0.0)), &keys), "`t` and `s`"));
    let cables = format!("{keys}stiffness = 1e4\n");
    let rod = cable("c", [-0.5, 0.0, 0.05], [0.5, 0.0, 0.05]);
    assert!(is_named(&warnings(&(rod + &sheet("s", 0.0)), &cables), "`c` and `s`"));
    let four = (0..4).map(|k| sheet(&format!("s{k}"), 0.05 * f64::from(k))).collect::<String>();
    let found = warnings(&four, &keys);
    assert!(is_named(&found, "`s0` and `s1`, `s1` and `s2`, `s2` and `s3`"), "{found:?}");
    let many = (0..5).map(|k| sheet(&format!("s{k}"), 0.05 * f64::from(k))).collect::<String>();
    let found = warnings(&many, &keys);
    assert!(is_named(&found, "`s0` and `s1`, `s1` and `s2`, `s2` and `s3` and another pair"), "{found:?}");
    let apart = sheet("s", 0.0) + &sheet("t", 0.1);
    assert!(!warnings(&apart, &keys).iter().any(|warning| warning.contains("overlap")));
}

/// A thickness that elements do not resolve, or that is steep, is named. A resolved one is not.
#[test]
fn thicknesses_that_vary_fast_are_named() {
    let found = |text: &str, elements: u32| {
        let formula = format!("thickness = {{ kind = \"expression\", text = \"{text}\" }}");
        let thin = format!(
            "[[bodies]]\nkind = \"shell\"\nname = \"t\"\nelements = [{elements}, 1]\n{formula}\nmaterial = \"m\"\n\
             motion = {{ velocity = [0, 0, 1] }}\n\
             surface = {{ kind = \"flat\", corner = [-1, -1, 0], side_u = [2, 0, 0], side_v = [0, 2, 0] }}\n"
        );
        [thin, sheet("s", 0.0).replace("thickness = 0.1", &formula)].map(|body| {
            let all = warnings(&body, &format!("{CONTACT}surface_stiffness = 1e4\n"));
            all.iter().any(|warning| warning.contains("of half the thickness, which varies fast"))
        })
    };
    assert_eq!(found("0.1*(2 + x)", 2), [false; 2]);
    assert_eq!(found("0.1*(1 + 0.5*sin(9*x))", 2), [true; 2]);
    assert!(!found("0.1*(1 + 0.5*sin(9*x))", 24)[0]);
    assert_eq!(found("0.1 + 0.9*(x + 1)", 8), [true; 2]);
}
