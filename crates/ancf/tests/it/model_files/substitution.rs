//! Substitution of values in the data of a model by paths, and errors of invalid paths.

use ancf::Model;
use ancf::reading::substitute;
use toml::Value;

const MODEL: &str = r#"
    materials.steel = { density = 7850, young = 2.1e11 }
    materials.rubber = { density = 1100, young = 2e6, damping = { strain = 1e-3 } }
    sections.rod = { kind = "circle", diameter = 0.02 }
    sections."thin wire" = { kind = "circle", diameter = 0.001 }

    [[bodies]]
    kind = "beam"
    name = "rod"
    from = [0, 0, 0]
    to = [1, 0, 0]
    elements = 2
    section = "rod"
    material = "steel"

    [[bodies]]
    kind = "rigid"
    name = "block"
    center = [1, 0, 0]
    mass = 2
    inertia = [1, 1, 1]

    [[bodies]]
    kind = "cable"
    name = "guy wire"
    from = [0, 1, 0]
    to = [1, 1, 0]
    elements = 3
    section = "thin wire"
    material = "rubber"

    [[joints]]
    kind = "clamp"
    name = "root"
    a = { body = "rod", at = "start" }

    [[joints]]
    kind = "clamp"
    name = "weld"
    a = { body = "rod", at = "end" }
    b = { body = "block", at = [1, 0, 0] }

    [[joints]]
    kind = "spherical"
    name = "eye"
    a = { body = "guy wire", at = "start" }

    [[loads]]
    kind = "force"
    on = { body = "rod", at = "end" }
    force = [0, -1, 0]

    [analysis]
    kind = "dynamics"
    duration = 0.1
    step = 1e-3
"#;

fn data() -> Value {
    Value::Table(MODEL.parse().unwrap())
}

/// Returns the model after a substitution and the paths that were set.
fn set(path: &str, value: impl Into<Value>) -> (Model, Vec<String>) {
    let mut data = data();
    let set = substitute(&mut data, path, value.into()).unwrap();
    (Model::from_value(&data).unwrap(), set)
}

/// Error of an invalid path. Asserts that the data are unchanged.
fn rejection(path: &str) -> String {
    let mut data = data();
    let error = substitute(&mut data, path, 1.into()).unwrap_err();
    assert_eq!(data, self::data(), "{path}");
    error.to_string()
}

#[test]
fn keys_items_and_indices_are_found() {
    for (path, resolved) in [
        ("analysis.step", "analysis.step"),
        ("gravity[1]", "gravity[1]"),
        ("materials.steel.young", "materials.steel.young"),
        ("materials.rubber.damping.strain", "materials.rubber.damping.strain"),
        ("sections.\"thin wire\".diameter", "sections.\"thin wire\".diameter"),
        ("bodies.rod.to[0]", "bodies[0].to[0]"),
        ("bodies[0].to[0]", "bodies[0].to[0]"),
        ("bodies.'guy wire'.elements", "bodies[2].elements"),
        ("bodies.guy wire.elements", "bodies[2].elements"),
        ("loads[0].force[1]", "loads[0].force[1]"),
    ] {
        let mut data = data();
        assert_eq!(substitute(&mut data, path, 7.into()).unwrap(), [resolved], "{path}");
        assert_ne!(data, self::data(), "{path}");
    }
    assert_eq!(set("gravity[1]", -9.81).0.gravity, [0.0, -9.81, 0.0], "an omitted vector");
    let (model, _) = set("gravity", vec![1, 2, 3]);
    assert_eq!(model.gravity, [1.0, 2.0, 3.0]);
}

/// Names of materials, sections and bodies are followed; at the end of a path the name itself is set.
#[test]
fn names_are_followed() {
    for (path, resolved) in [
        ("bodies.rod.material.young", "materials.steel.young"),
        ("bodies.rod.section.diameter", "sections.rod.diameter"),
        ("bodies.guy wire.section.diameter", "sections.\"thin wire\".diameter"),
        ("joints.root.a.body.elements", "bodies[0].elements"),
        ("loads[0].on.body.material.density", "materials.steel.density"),
    ] {
        assert_eq!(set(path, 5).1, [resolved], "{path}");
    }
    let (model, set) = set("bodies.rod.material", "rubber");
    assert_eq!(set, ["bodies[0].material"]);
    assert_eq!(model.bodies[0].section_and_material(), Some(("rod", "rubber")));
}

#[test]
fn omitted_keys_can_be_set() {
    let (model, _) = set("bodies.rod.material.poisson", 0.3);
    assert_eq!(model.materials["steel"].poisson, 0.3);
    let (model, _) = set("output.every", 10);
    assert_eq!(
        (model.output.every, model.output.csv),
        (10, true),
        "other keys of an omitted table keep their defaults"
    );
    let (model, _) = set("bodies.rod.motion.velocity[2]", 3);
    assert_eq!(Value::try_from(&model.bodies[0]).unwrap()["motion"]["velocity"][2].as_float(), Some(3.0));
    assert_eq!(set("joints.weld.fix", "section").1, ["joints[1].fix"]);
}

/// Keys that only some bodies have are set in these bodies.
#[test]
fn bare_keys_apply_to_all_suitable_bodies() {
    let (model, paths) = set("elements", 4);
    assert_eq!(paths, ["bodies[0].elements", "bodies[2].elements"]);
    assert_eq!(model.bodies.iter().map(ancf::model::Body::elements).collect::<Vec<_>>(), [4, 0, 4]);
    assert_eq!(set("mass", 3).1, ["bodies[1].mass"]);
    assert_eq!(set("twist", 0.1).1, ["bodies[0].twist"], "omitted, and no key of a cable");
    assert_eq!(set("material.density", 5e3).1, ["materials.steel.density", "materials.rubber.density"]);
}

/// Returned paths lead to the same place, for all names of materials.
#[test]
fn returned_paths_lead_to_the_same_place() {
    let names = [
        "",
        " ",
        "a.b",
        "a[0]",
        "\"",
        "'",
        "\\",
        "\\\"",
        "\"\\",
        "say \"steel\"",
        "C:\\steel\\",
        "a'b\"c",
        "line\nbreak",
        "tab\tand bell\u{7}",
        "\u{7f}\u{85}",
        "Stahl für Öfen",
        "鋼",
        "🔩",
        "\\u0041",
    ];
    for name in names {
        let mut data = data();
        let steel = data["materials"]["steel"].clone();
        data["materials"].as_table_mut().unwrap().insert(name.into(), steel);
        data["bodies"][0]["material"] = name.into();
        let set = substitute(&mut data, "bodies.rod.material.young", 5.into()).unwrap();
        assert_eq!(data["materials"][name]["young"].as_integer(), Some(5), "{name:?}");
        assert_eq!(substitute(&mut data, &set[0], 7.into()).unwrap(), set, "{name:?}");
        assert_eq!(data["materials"][name]["young"].as_integer(), Some(7), "{name:?}");
        let line: Value = Value::Table(format!("{} = 1", set[0]).parse().unwrap());
        assert_eq!(
            line["materials"][name]["young"].as_integer(),
            Some(1),
            "{name:?}: the path is valid TOML"
        );
    }
}

#[test]
fn shared_places_are_set_once() {
    let mut data = data();
    substitute(&mut data, "bodies.guy wire.material", "steel".into()).unwrap();
    assert_eq!(substitute(&mut data, "material.young", 1e9.into()).unwrap(), ["materials.steel.young"]);
}

#[test]
fn paths_without_target_are_rejected() {
    for (path, message) in [
        (
            "bodies.rood.elements",
            "bodies.rood: found no `rood`, expected `rod`, `block` or `guy wire` (did you mean `rod`?)",
        ),
        (
            "bodies.rod.material.youngs",
            "bodies.rod.material.youngs: found unknown key `youngs`, expected `damping`, `density`, `law`, `orthotropic`, `poisson` or `young` \
             (did you mean `young`?)",
        ),
        (
            "materials.stel.young",
            "materials.stel: found no `stel`, expected `rubber` or `steel` (did you mean `steel`?)",
        ),
        (
            "element",
            "element: found unknown key `element`, expected a key of the model or of a body (did you mean `elements`?)",
        ),
        ("up[1]", "up[1]: found no `up` before it, expected a value for `up` as a whole"),
        ("bodies[3].mass", "bodies[3]: found index `[3]`, expected an index from `[0]` to `[2]`"),
        ("gravity[3]", "gravity[3]: found index `[3]`, expected an index from `[0]` to `[2]`"),
        ("loads[1]", "loads[1]: found index `[1]`, expected the only item, `[0]`"),
        (
            "probes.tip.offset[0]",
            "probes.tip: found no `tip`, expected a path without a name, since there are no items",
        ),
        (
            "loads.wind.force",
            "loads.wind: found `wind` after an array of 1, expected an index from 0 in brackets, such as `loads[0]`",
        ),
        (
            "gravity.y",
            "gravity.y: found `y` after an array of 3, expected an index from 0 in brackets, such as `gravity[0]`",
        ),
        ("analysis[0]", "analysis[0]: found index `[0]` of a table, expected a key"),
        (
            "analysis.step.size",
            "analysis.step.size: found 0.001 before it, expected a path that ends with `analysis.step`",
        ),
        (
            "bodies.rod.name.x",
            "bodies.rod.name.x: found the text \"rod\" before it, expected a path that ends with `bodies.rod.name`",
        ),
        ("bodies.block.elements", "bodies.block.elements: found unknown key `elements`, expected `center`,"),
    ] {
        let error = rejection(path);
        assert!(error.starts_with(message), "{path}: {error}");
    }
}

/// Keys that only bodies of other kinds have.
#[test]
fn bare_keys_without_suitable_body_are_rejected() {
    let mut data = data();
    data["bodies"].as_array_mut().unwrap().remove(1);
    let error = substitute(&mut data, "mass", 1.into()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "mass: found no body that can have `mass`, expected a key of the model or of a body"
    );
}

#[test]
fn malformed_paths_are_rejected() {
    for (path, found) in [
        ("", "an empty path"),
        ("bodies..rod", "an empty key"),
        ("bodies.rod.", "an empty key"),
        (".gravity", "an empty key"),
        ("gravity[1", "a bracket that does not end"),
        ("gravity[y]", "`y` in brackets"),
        ("gravity[-1]", "`-1` in brackets"),
        ("bodies.\"guy wire.elements", "quotes that do not end"),
        ("bodies.\"guy wire\\\".elements", "quotes that do not end"),
        ("bodies.\"guy\\ wire\".elements", "an invalid escape sequence"),
        ("gravity[1]x", "`x` after a bracket or quotes"),
    ] {
        let error = rejection(path);
        assert!(
            error.contains(&format!("found {found}, expected keys separated by dots")),
            "{path}: {error}"
        );
    }
}

/// Values of wrong type and unknown names are found by the check of the model.
#[test]
fn unsuitable_values_are_found_by_the_check() {
    let mut data = data();
    substitute(&mut data, "elements", "many".into()).unwrap();
    substitute(&mut data, "bodies.rod.material", "stel".into()).unwrap();
    let errors = Model::from_value(&data).unwrap_err();
    let text = errors.to_string();
    assert!(
        text.contains("bodies[0].elements: found \"many\"") && text.contains("bodies[2].elements"),
        "{text}"
    );
    assert!(text.contains("did you mean `steel`") || text.contains("\"steel\""), "{text}");
    let error = substitute(&mut data, "bodies.rod.material.young", 1.into()).unwrap_err();
    assert!(error.to_string().contains("found the text \"stel\" before it"), "{error}");
}
