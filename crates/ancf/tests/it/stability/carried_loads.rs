//! Buckling under loads that joints carry without any displacement of first order.

use ancf::record::Series;
use ancf::{Model, simulate};

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

pub(super) fn factors(text: &str) -> Vec<f64> {
    let (model, mut series) = (Model::parse(text).unwrap(), Series::new());
    let summary = simulate(&model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    series.column("factor").unwrap_or_default().to_vec()
}

/// Rigid link of length L on a torsion spring k under an axial force P: k/(P L), from any length, force and direction.
#[test]
fn rigid_link_on_a_torsion_spring_buckles() {
    for (length, force, stiffness, axis) in [(1.5, 2.0, 40.0, "[0, 0, 1]"), (0.3, 700.0, 9.0, "[1, 0, 0]")] {
        let text = format!(
            "bodies = [{{ kind = \"rigid\", name = \"link\", center = [0, {}, 0], mass = 2, inertia = [1, 2, 1.5] }}]\n\
             joints = [{{ kind = \"revolute\", name = \"foot\", a = {{ body = \"link\", at = [0, 0, 0] }}, axis = {axis}, \
             spring = {{ stiffness = {stiffness} }} }}]\n\
             loads = [{{ kind = \"force\", on = {{ body = \"link\", at = [0, {length}, 0] }}, force = [0, {}, 0] }}]\n\
             [analysis]\nkind = \"buckling\"\n",
            0.4 * length,
            -force
        );
        let [found, ..] = factors(&text)[..] else { panic!("no critical load") };
        assert!((found * force * length / stiffness - 1.0).abs() < 1e-9, "{found}");
    }
}

/// Two bars of length L in line, the knee held by springs k: k L/2 in each of two directions.
#[test]
fn knee_of_two_bars_buckles() {
    let bars = "bodies = [{ kind = \"mass\", name = \"knee\", center = [0, 0.8, 0], mass = 3 }, \
                { kind = \"mass\", name = \"top\", center = [0, 1.6, 0], mass = 1 }]\n\
                joints = [{ kind = \"distance\", name = \"lower\", a = { body = \"knee\", at = \"center\" }, b = { point = [0, 0, 0] } }, \
                { kind = \"distance\", name = \"upper\", a = { body = \"top\", at = \"center\" }, b = { body = \"knee\", at = \"center\" } }, \
                { kind = \"point_on_line\", name = \"guide\", a = { body = \"top\", at = \"center\" }, axis = [0, 1, 0] }, \
                { kind = \"spring\", name = \"x\", a = { body = \"knee\", at = \"center\" }, b = { point = [1, 0.8, 0] }, stiffness = 60 }, \
                { kind = \"spring\", name = \"z\", a = { body = \"knee\", at = \"center\" }, b = { point = [0, 0.8, 1] }, stiffness = 90 }]\n\
                loads = [{ kind = \"force\", on = { body = \"top\", at = \"center\" }, force = [0, -1, 0] }]\n\
                [analysis]\nkind = \"buckling\"\ncount = 2\n";
    let found = factors(bars);
    for (found, expected) in found.iter().zip([24.0, 36.0]) {
        assert!((found / expected - 1.0).abs() < 1e-9, "{found} for {expected}");
    }
    assert_eq!(found.len(), 2);
}

/// A load on a clamped node has no effect.
#[test]
fn load_on_a_clamp_has_no_critical_factor() {
    for formulation in ["linked", "continuum", "quadratic"] {
        let text = format!(
            "materials.m = {{ density = 1000, young = 2e9 }}\nsections.s = {{ kind = \"circle\", diameter = 0.02 }}\n\
             bodies = [{{ kind = \"beam\", formulation = \"{formulation}\", name = \"b\", from = [0, 0, 0], to = [0.7, 0.1, 0], elements = 4, \
             section = \"s\", material = \"m\" }}]\n\
             joints = [{{ kind = \"clamp\", name = \"c\", a = {{ body = \"b\", at = \"start\" }} }}]\n\
             loads = [{{ kind = \"force\", on = {{ body = \"b\", at = \"start\" }}, force = [-30, 5, 0] }}]\n\
             [analysis]\nkind = \"buckling\"\n"
        );
        let found = factors(&text);
        assert!(found.is_empty(), "{formulation}: {found:?}");
    }
}

/// Lateral buckling of a strip of height h and width b under a force P at its end. The deflection before buckling rotates the end
/// by P L²/2EI₁ = 2.006 √(EI₂ GJ)/EI₁ (Prandtl 1899), and increases the load by 1/√((1 − EI₂/EI₁)(1 − GJ/EI₁)).
#[test]
fn deformation_before_buckling_is_warned_of() {
    for ratio in [0.1, 0.2, 0.25, 0.4_f64] {
        let (length, height, young) = (3.0, 0.1, 7e10);
        let width = ratio * height;
        let model = parse(&format!(
            "materials.alloy = {{ density = 2700, young = {young:e}, poisson = 0 }}
            sections.strip = {{ kind = \"rectangle\", height = {height}, width = {width} }}
            bodies = [{{ kind = \"beam\", name = \"strip\", from = [0, 0, 0], to = [{length}, 0, 0], up = [0, 0, 1], \
                         elements = 8, section = \"strip\", material = \"alloy\" }}]
            joints = [{{ kind = \"clamp\", name = \"wall\", a = {{ body = \"strip\", at = \"start\" }}, b = \"ground\" }}]
            loads = [{{ kind = \"force\", on = {{ body = \"strip\", at = \"end\" }}, force = [0, 0, -1] }}]
            analysis = {{ kind = \"buckling\", count = 1 }}\n"
        ));
        let run = Run::of(&model);
        let inertia = width * height.powi(3) / 12.0;
        let rotation = run.column("factor")[0] * length * length / (2.0 * young * inertia);
        let warnings = &run.summary.warnings;
        if rotation < 0.1 {
            assert!(warnings.is_empty(), "{warnings:?}");
            continue;
        }
        assert_eq!(warnings.len(), 1, "{warnings:?}");
        let (_, rest) =
            warnings[0].split_once("body `strip` at s = 3 by ").expect("place of the largest rotation");
        let stated: f64 = rest.split_once(" or more").unwrap().0.parse().unwrap();
        assert_relative("rotation before buckling", stated, rotation, 1e-2);
    }
}
