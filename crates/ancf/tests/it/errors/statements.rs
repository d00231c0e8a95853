//! What is stated and what is not: classes, warnings, invariance, states without error.

use ancf::estimate::{DiscretisationErrors, Resolution};

use super::{BODIES, CLAMPED, beam, errors, of, summary};
use crate::common::assertions::assert_near;

fn bent(rest: &str) -> DiscretisationErrors {
    let load = r#"loads = [{ kind = "force", on = { body = "b", at = "end" }, force = [0, -20, 7] }]"#;
    errors(&beam(BODIES[2], 2, &format!("{CLAMPED}\n{load}\n{rest}")))
}

/// Few elements in large bending are refused an estimate, and the run warns.
#[test]
fn unresolved_bending_is_a_warning() {
    let load = r#"loads = [{ kind = "force", on = { body = "b", at = "end" }, force = [0, -133, 0] }]"#;
    let coarse = summary(&beam(BODIES[1], 2, &format!("{CLAMPED}\n{load}")));
    let found = coarse.errors.unwrap();
    assert_eq!(found.resolution, Resolution::Unresolved);
    assert!(found.values.is_empty() && found.displacement.is_none());
    assert!(coarse.warnings.iter().any(|text| text.contains("mesh: not resolved")), "{:?}", coarse.warnings);
    let fine = summary(&beam(BODIES[3], 8, &format!("{CLAMPED}\n{load}")));
    assert_eq!(fine.errors.unwrap().resolution, Resolution::Good);
    assert!(fine.warnings.is_empty(), "{:?}", fine.warnings);
}

/// Nothing is stated with a joint between the nodes of an element; a node there makes it known.
#[test]
fn joint_within_an_element_is_unknown() {
    let frame = |elements: u32| {
        let branch = r#"
            [[bodies]]
            kind = "beam"
            name = "c"
            from = [0.25, 0, 0]
            to = [0.25, 0.4, 0.1]
            elements = 2
            section = "s"
            material = "m"
            [[joints]]
            kind = "clamp"
            name = "root"
            a = { body = "b", at = "start" }
            [[joints]]
            kind = "clamp"
            name = "knot"
            a = { body = "c", at = "start" }
            b = { body = "b", at = 0.25 }
            [[probes]]"#;
        let text = beam(BODIES[2], elements, "gravity = [0, -9.81, 0]");
        errors(&text.replacen("[[probes]]", branch, 1))
    };
    let inside = frame(2);
    assert_eq!(inside.resolution, Resolution::Unknown);
    assert!(
        inside.values.is_empty() && inside.sentence().contains("joints or moments act within elements"),
        "{inside:?}"
    );
    assert_eq!(frame(4).resolution, Resolution::Good);
}

/// Moments that vary within elements, or act at a point there, have no estimate: their place does not follow from the nodal forces. A
/// uniform moment on the whole beam has one.
#[test]
fn moments_within_elements_are_unknown() {
    let with =
        |load: &str| errors(&beam(BODIES[2], 3, &format!("{CLAMPED}\nloads = [{{ {load} }}]"))).resolution;
    let distributed = "kind = \"distributed_moment\", body = \"b\", moment = [0, 0, 0.1]";
    let point =
        |at: &str| format!("kind = \"moment\", on = {{ body = \"b\", at = {at} }}, moment = [0, 0, 0.1]");
    for unknown in [
        format!("{distributed}, moment_end = [0, 0, 0.2]"),
        format!("{distributed}, from = 0.13, to = 0.77"),
        point("0.6"),
    ] {
        assert_eq!(with(&unknown), Resolution::Unknown, "{unknown}");
    }
    for known in [distributed.to_owned(), point("\"end\"")] {
        assert_eq!(with(&known), Resolution::Good, "{known}");
    }
}

/// The last element of a coarse hanging cable is taut at one end only. Short elements resolve the transition.
#[test]
fn free_end_of_a_hanging_cable() {
    let hanging = |elements: u32| {
        let load = r#"gravity = [9.81, 0, 0]
            loads = [{ kind = "force", on = { body = "b", at = "end" }, force = [0, 1e-2, 0] }]"#;
        let text = beam(BODIES[4], elements, &format!("{load}\n{CLAMPED}"));
        let section = "kind = \"rectangle\", height = 0.02, width = 0.02";
        let text = text.replace(section, "kind = \"circle\", diameter = 0.005");
        errors(&text.replace("young = 1e9", "young = 2e6"))
    };
    let coarse = hanging(4);
    assert_eq!(coarse.resolution, Resolution::Unknown, "{coarse:?}");
    assert!(coarse.values.is_empty() && coarse.sentence().contains("tension"), "{coarse:?}");
    let [fine, finer] = [64, 128].map(|elements| of(&hanging(elements), "tip.y"));
    assert_near("tip.y", fine[0] + fine[1], finer[0] + finer[1], 0.3 * fine[1].abs() + 1e-9);
}

/// The units of the equations have no effect.
#[test]
fn scales_leave_the_estimate() {
    let reference = bent("");
    let scaled = bent("scales = { kind = \"given\", length = 0.01, time = 3, force = 700 }");
    for column in ["tip.x", "tip.y", "tip.z", "root.my", "root.mz"] {
        let ([value, error], [other, same]) = (of(&reference, column), of(&scaled, column));
        assert_near(column, other, value, 1e-9 * value.abs());
        assert_near(column, same, error, 1e-5 * error.abs() + 1e-12);
    }
    assert_near("gaps", scaled.gaps, reference.gaps, 1e-6 * reference.gaps);
}

/// The frame of reference has no effect: x y z become y z x.
#[test]
fn axes_leave_the_estimate() {
    let load = r#"loads = [{ kind = "force", on = { body = "b", at = "end" }, force = [0, -20, 7] }]"#;
    let text = beam(&format!("{}\nup = [0, 1, 0]", BODIES[2]), 2, &format!("{CLAMPED}\n{load}"));
    let turned = text
        .replace("up = [0, 1, 0]", "up = [0, 0, 1]")
        .replace("to = [1, 0, 0]", "to = [0, 1, 0]")
        .replace("[0, -20, 7]", "[7, 0, -20]");
    let (found, turned) = (errors(&text), errors(&turned));
    for (column, other) in
        [("tip.x", "tip.y"), ("tip.y", "tip.z"), ("tip.z", "tip.x"), ("root.mz", "root.mx")]
    {
        let ([_, error], [_, same]) = (of(&found, column), of(&turned, other));
        assert_near(column, same, error, 1e-6 * error.abs() + 1e-12);
    }
}

/// A driven beam without loads has no error, whatever its rotation.
#[test]
fn rigid_motion_has_no_error() {
    let drive = r#"joints = [{ kind = "revolute", name = "h", axis = [0.6, 0, 0.8], a = { body = "b", at = "start" },
        drive = { angle = 1.9, time = 1 } }]"#;
    for body in &BODIES[2..4] {
        let found = errors(&beam(body, 3, drive));
        assert_eq!(found.resolution, Resolution::Good, "{body}");
        for column in ["tip.x", "tip.y", "tip.z"] {
            assert_near(body, of(&found, column)[1], 0.0, 1e-9);
        }
    }
}

/// The statement of the end of a run names the probe, the size and the better value.
#[test]
fn sentence_of_a_run() {
    let found = bent("");
    let text = found.sentence();
    assert!(text.starts_with("mesh: displacement of `tip` ") && text.contains(" % too "), "{text}");
    assert!(text.contains("(better: tip.") && text.contains("; section law within 0.0"), "{text}");
    let error = found.displacement.unwrap();
    let [value, expected] = of(&bent(""), &error.column);
    assert_eq!((error.value, error.error), (value, expected));
}

/// Beams with a prescribed strain are stiffer by (1 + ε⁰)²: an error of the section law, which the mesh does not have. The error of the
/// mesh is that of a fine mesh.
#[test]
fn prescribed_strains_are_errors_of_the_law() {
    let found = |body: &str, elements: u32| {
        let loads = r#"loads = [{ kind = "prestrain", body = "b", strain = 0.02 }]"#;
        errors(&beam(body, elements, &format!("gravity = [0, -9.81, 0]\n{CLAMPED}\n{loads}")))
    };
    for body in &BODIES[2..4] {
        let [coarse, fine] = [4, 32].map(|elements| found(body, elements));
        assert!((fine.law - 0.0404).abs() < 5e-3, "{body}: {}", fine.law);
        let [[coarse, error], [fine, rest]] = [&coarse, &fine].map(|errors| of(errors, "tip.y"));
        assert!(rest.abs() < 3e-5 * fine.abs(), "{body}: {rest} of {fine}");
        assert!(
            (coarse + error - fine).abs() < 0.2 * (coarse - fine).abs().max(1e-4 * fine.abs()),
            "{body}: {coarse} + {error}, {fine}"
        );
    }
}

/// Uniform tension is exact on every mesh: ½ λ (λ² − 1) = F/EA, and λ − 1 = F/EA for cables. The law of Green's strain is no error of the
/// mesh. The short elements of the thick beam are rods, the long ones of the thin beam strings.
#[test]
fn uniform_stretch_has_no_error_of_the_mesh() {
    for (body, (elements, width)) in
        BODIES[1..].iter().flat_map(|body| [(body, (2, "0.02")), (body, (32, "0.2"))])
    {
        let area = width.parse::<f64>().unwrap().powi(2);
        let force = format!("force = [{}, 0, 0]", 0.3 * 1e9 * area);
        let load =
            format!("loads = [{{ kind = \"force\", on = {{ body = \"b\", at = \"end\" }}, {force} }}]");
        let text = beam(body, elements, &format!("{CLAMPED}\n{load}")).replace("0.02", width);
        let found = errors(&text);
        let what = format!("{body}, {elements} elements");
        assert_eq!(found.resolution, Resolution::Good, "{what}: {found:?}");
        let [value, error] = of(&found, "tip.x");
        let stretch = if *body == BODIES[4] { 1.3 } else { 1.221_196_686_181_077 };
        assert_near(&what, value, stretch, 1e-6);
        assert_near(&what, error, 0.0, 1e-7);
    }
}
