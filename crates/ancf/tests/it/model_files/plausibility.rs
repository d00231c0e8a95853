//! Warnings of numbers in mixed units and of bodies that fall, and their absence in models of any coherent units.

use std::fs;
use std::path::Path;

use ancf::Model;
use ancf::record::Series;
use ancf::simulate;

/// Model of a horizontal beam of steel; `keys` precede the tables.
fn beam(keys: &str, analysis: &str, [length, diameter]: [f64; 2], [young, density]: [f64; 2]) -> Model {
    let text = format!(
        "{keys}
        materials.steel = {{ density = {density}, young = {young} }}
        sections.round = {{ kind = \"circle\", diameter = {diameter} }}
        bodies = [{{ kind = \"beam\", name = \"rod\", from = [0, 0, 0], to = [{length}, 0, 0], elements = 4, section = \"round\",
                    material = \"steel\" }}]
        joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"rod\", at = \"start\" }} }}]
        analysis = {{ kind = \"{analysis}\" }}"
    );
    Model::parse(&text).unwrap()
}

fn warnings(model: &Model) -> Vec<String> {
    model.diagnose().unwrap().warnings
}

fn steel(keys: &str, sizes: [f64; 2], material: [f64; 2]) -> Vec<String> {
    warnings(&beam(keys, "statics", sizes, material))
}

const SI: &str = "gravity = [0, 0, -9.81]\nunits = { length = \"m\", time = \"s\", force = \"N\" }";
const MILLIMETRES: &str = "gravity = [0, 0, -9810]\nunits = { length = \"mm\", time = \"s\", force = \"N\" }";

/// Steel in coherent units: m-kg-s, mm-t-s, and without names.
#[test]
fn coherent_units_have_no_warning() {
    let metres = ([1.0, 0.02], [2.1e11, 7850.0]);
    let millimetres = ([1000.0, 20.0], [2.1e5, 7.85e-9]);
    for (keys, (sizes, material)) in [
        (SI, metres),
        (MILLIMETRES, millimetres),
        ("gravity = [0, 0, -9.81]", metres),
        ("gravity = [0, 0, -9810]", millimetres),
        ("", metres),
        ("", millimetres),
    ] {
        assert!(steel(keys, sizes, material).is_empty(), "{keys}: {:?}", steel(keys, sizes, material));
    }
    // Silicone: 70 kPa.
    assert!(steel(SI, [0.1, 0.02], [7e4, 1070.0]).is_empty());
}

/// The example models state plausible numbers, and their bodies fall on purpose only.
#[test]
fn example_models_have_no_warning() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    let files = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    for file in files.filter(|file| file.extension().is_some_and(|end| end == "toml")) {
        let found = warnings(&Model::read(&file).unwrap());
        let is_meant = |text: &&String| text.contains("the units of") || text.contains("falls");
        assert_eq!(found.iter().find(is_meant), None, "{}", file.display());
    }
}

/// A diameter in mm, a modulus in kPa, a length and a modulus in mm and MPa with a density in kg/m³.
#[test]
fn mixed_units_are_named() {
    for keys in [SI, "gravity = [0, 0, -9.81]"] {
        for (sizes, material, parts) in [
            ([1.0, 20.0], [2.1e11, 7850.0], ["`sections.round`", "is 1 long", "20 thick"]),
            ([1.0, 0.02], [2.1e14, 7850.0], ["`materials.steel`", "`young` and `density`", "= 163600 m/s"]),
            ([1000.0, 20.0], [2.1e5, 7850.0], ["`materials.steel`", "100 to 20000 m/s", "= 5.172 m/s"]),
        ] {
            let found = steel(keys, sizes, material);
            assert!(parts.iter().all(|part| found[0].contains(part)), "{found:?}");
        }
    }
}

/// Gravity in m/s² in a model in mm.
#[test]
fn gravity_in_other_units_is_named() {
    let metres = "gravity = [0, -9.81, 0]\nunits = { length = \"mm\", time = \"s\", force = \"N\" }";
    let found = steel(metres, [1000.0, 20.0], [2.1e5, 7.85e-9]);
    assert_eq!(
        found,
        ["`gravity` is 9.81 mm/s², which is 0.00981 m/s²: that of the earth is 9810 in these units"]
    );
    // Gravity of the moon.
    let moon = "gravity = [0, -1.62, 0]\nunits = { length = \"m\", time = \"s\", force = \"N\" }";
    assert!(steel(moon, [1.0, 0.02], [2.1e11, 7850.0]).is_empty());
}

/// w/L = ρ A g L³/(8 E I) = 2 ρ g L³/(E d²) of a round cantilever.
#[test]
fn a_beam_much_softer_than_its_weight_is_named() {
    let found = steel(SI, [1.0, 0.001], [2.1e8, 7850.0]);
    let ratio = 2.0 * 7850.0 * 9.81 / (2.1e8 * 1e-6);
    assert!(found.len() == 1 && found[0].contains("`sections.round`"), "{found:?}");
    assert!(found[0].contains(&format!("by {ratio:.1} lengths")), "{found:?} {ratio}");
    assert!(steel(SI, [1.0, 0.01], [2.1e8, 7850.0]).is_empty());
}

/// A run states the warnings of the diagnosis, in any units of the solver.
#[test]
fn warnings_do_not_depend_on_the_units_of_the_solver() {
    for keys in
        ["", "scales = { kind = \"auto\" }", "scales = { kind = \"given\", length = 1e-3, force = 7.0 }"]
    {
        let keys = format!("{SI}\n{keys}");
        for (sizes, material) in [
            ([1.0, 20.0], [2.1e11, 7850.0]),
            ([0.1, 0.001], [2.1e14, 7850.0]),
            ([1.0, 0.001], [2.1e8, 7850.0]),
        ] {
            let model = beam(&keys, "modes", sizes, material);
            let stated = warnings(&model);
            assert_eq!(stated.len(), 1);
            let summary = simulate(&model, &mut Series::new()).unwrap();
            assert!(summary.warnings.contains(&stated[0]), "{keys}: {stated:?} {:?}", summary.warnings);
        }
    }
}

/// A body without joints falls. An initial motion, a load, or a contact shows that this is intended.
#[test]
fn falling_bodies_are_named() {
    let model = |keys: &str, parts: &str| {
        let text = format!(
            "{keys}\nanalysis = {{ kind = \"dynamics\", duration = 1, step = 0.1 }}
            bodies = [{{ kind = \"mass\", name = \"ball\", center = [0, 0, 1], mass = 1, surface = {{ radius = 0.1 }} {parts} }}]"
        );
        warnings(&Model::parse(&text).unwrap())
    };
    let gravity = "gravity = [0, 0, -9.81]";
    let falls = "no joint, spring, contact or load acts on body `ball`: it falls freely from rest";
    assert_eq!(model(gravity, ""), [falls]);
    for (keys, parts) in [
        ("", ""),
        (gravity, ", motion = { velocity = [1, 0, 0] }"),
        (
            "gravity = [0, 0, -9.81]\nloads = [{ kind = \"force\", on = { body = \"ball\", at = \"center\" }, force = [0, 0, 1] }]",
            "",
        ),
        (
            "gravity = [0, 0, -9.81]\ncontacts = [{ stiffness = 1e4, with = { kind = \"plane\", \
             point = [0, 0, 0], normal = [0, 0, 1] } }]",
            "",
        ),
    ] {
        assert!(model(keys, parts).is_empty(), "{keys}: {:?}", model(keys, parts));
    }
}
