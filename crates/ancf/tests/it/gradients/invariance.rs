use super::equilibria::beam_with_block;
use super::gradients_of;

const BASE: [f64; 4] = [5e8, 300.0, 0.04, 1.05];
const PATHS: [&str; 3] = ["materials.m.young", "joints.spring.stiffness", "sections.s.width"];

/// Derivatives do not depend on the units of the equations, nor on redundant constraints.
#[test]
fn units_and_redundant_joints() {
    let text = beam_with_block(BASE);
    let given = gradients_of(&text, &PATHS);
    let redundant = "[[joints]]\nkind = \"spherical\"\nname = \"again\"\na = { body = \"beam\", at = \"start\" }\n[analysis]";
    let variants = [
        format!("scales = {{ kind = \"given\", length = 3.1, time = 0.37, force = 17.3 }}\n{text}"),
        format!("scales = {{ kind = \"given\", length = 1e-3, time = 1.0, force = 1e3 }}\n{text}"),
        text.replace("[analysis]", redundant),
    ];
    for text in variants {
        let found = gradients_of(&text, &PATHS);
        for (row, quantity) in found.quantities.iter().enumerate() {
            // Redundant joints share their reaction.
            let Some(own) = given.quantities.iter().position(|name| name == quantity) else { continue };
            if quantity.starts_with("root.") {
                continue;
            }
            for column in 0..PATHS.len() {
                let (value, expected) = (found.derivatives[(row, column)], given.derivatives[(own, column)]);
                let scale = expected.abs() + given.values[own].abs() / given.parameter_values[column].abs();
                let error = (value - expected).abs();
                assert!(error <= 1e-7 * scale + 1e-15, "{quantity}: {value} for {expected}");
            }
        }
    }
}

/// A force that follows the tip has no potential, and its stiffness a skew part. Derivatives agree with differences of equilibria.
#[test]
fn follower_forces() {
    let text = |force: f64, young: f64| {
        format!(
            r#"
            materials.m = {{ density = 1200.0, young = {young:?}, poisson = 0.3 }}
            sections.s = {{ kind = "rectangle", width = 0.02, height = 0.03 }}
            [[bodies]]
            kind = "beam"
            name = "beam"
            from = [0, 0, 0]
            to = [1, 0, 0]
            elements = 6
            section = "s"
            material = "m"
            [[joints]]
            kind = "clamp"
            name = "root"
            a = {{ body = "beam", at = "start" }}
            [[loads]]
            kind = "force"
            on = {{ body = "beam", at = "end" }}
            force = [0, 3.0, {force:?}]
            follower = true
            [[probes]]
            name = "tip"
            on = {{ body = "beam", at = "end" }}
            [analysis]
            kind = "statics"
            "#
        )
    };
    let (force, young) = (10.0, 5e8);
    let found = gradients_of(&text(force, young), &["loads[0].force[2]", "materials.m.young"]);
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    let values = |force: f64, young: f64| gradients_of(&text(force, young), &[]).values;
    let h = 1e-3;
    let pairs = [
        [values(force * (1.0 + h), young), values(force * (1.0 - h), young)],
        [values(force, young * (1.0 + h)), values(force, young * (1.0 - h))],
    ];
    for (column, ([after, before], p)) in pairs.iter().zip([force, young]).enumerate() {
        for (row, quantity) in found.quantities.iter().enumerate() {
            let difference = (after[row] - before[row]) / (2.0 * h * p);
            let value = found.derivatives[(row, column)];
            let scale = (found.values[row] / p).abs() + value.abs();
            assert!(
                (value - difference).abs() <= 2e-5 * scale + 1e-12,
                "{quantity}: {value} for {difference}"
            );
        }
    }
}
