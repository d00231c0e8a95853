use super::{column, derivative, gradients_of, relative};
use crate::common::assertions::{assert_near, assert_relative};

/// Sections of cables, and of beams.
const ROUND: (&str, &str) = ("cable", "{ kind = \"circle\", diameter = 0.001 }");
const SQUARE: (&str, &str) = ("beam", "{ kind = \"rectangle\", width = 0.002, height = 0.002 }");

fn paths_of(count: usize, key: &str) -> Vec<String> {
    (1..=count).map(|k| format!("materials.m{k}.{key}")).collect()
}

/// Relative derivatives of the frequencies of a cantilever with respect to the stiffness and the mass of four parts, in closed form by
/// the beam functions.
#[test]
fn frequencies_of_four_parts() {
    let text = column(4, 8, ROUND, "[analysis]\nkind = \"modes\"\ncount = 6\n");
    let (stiffness, mass) = (paths_of(4, "young"), paths_of(4, "density"));
    let paths: Vec<&str> = stiffness.iter().chain(&mass).map(String::as_str).collect();
    let found = gradients_of(&text, &paths);
    let modes = [
        (0, [0.347944921616, 0.1266751879435, 0.02439193347352, 0.0009879569669737]),
        (3, [0.1408382570401, 0.1385149914802, 0.19918887448, 0.02145787699976]),
        (1, [0.347944921616, 0.1266751879435, 0.02439193347352, 0.0009879569669737]),
    ];
    for (mode, exact) in modes {
        let quantity = format!("frequency[{mode}]");
        for k in 0..4 {
            assert_near(&stiffness[k], relative(&found, &quantity, &stiffness[k]), exact[k], 1e-6);
            assert_near(&mass[k], relative(&found, &quantity, &mass[k]), -exact[3 - k], 1e-6);
        }
    }
}

/// Frequencies of a round rod are equal in pairs. The derivatives of a pair with respect to the height of a rectangle that is a square
/// are those of bending in both directions.
#[test]
fn equal_frequencies() {
    let text = column(1, 8, SQUARE, "[analysis]\nkind = \"modes\"\ncount = 3\n");
    let found = gradients_of(&text, &["sections.rod.height", "sections.rod.width", "bodies.b1.to[0]"]);
    assert_eq!(found.warnings.len(), 1, "{:?}", found.warnings);
    assert!(found.warnings[0].contains("frequency[0]") && found.warnings[0].contains("are equal"));
    for path in ["sections.rod.height", "sections.rod.width"] {
        assert_near(path, relative(&found, "frequency[0]", path), 0.0, 1e-5);
        assert_near(path, relative(&found, "frequency[1]", path), 1.0, 1e-5);
    }
    // The third frequency has its equal beyond the requested ones.
    for mode in 0..3 {
        assert_near("length", relative(&found, &format!("frequency[{mode}]"), "bodies.b1.to[0]"), -2.0, 5e-5);
    }
}

/// The frequency of a string depends on its tension: ω² = T π²/(ρA L²) + EI π⁴/(ρA L⁴), also by the stiffness, from the equilibrium.
#[test]
fn frequencies_about_an_equilibrium() {
    let text = r#"
        materials.m = { density = 1000.0, young = 2e9 }
        sections.s = { kind = "circle", diameter = 0.001 }
        [[bodies]]
        kind = "cable"
        name = "string"
        from = [0, 0, 0]
        to = [1, 0, 0]
        elements = 16
        section = "s"
        material = "m"
        [[joints]]
        kind = "spherical"
        name = "left"
        a = { body = "string", at = "start" }
        [[joints]]
        kind = "point_on_line"
        name = "right"
        a = { body = "string", at = "end" }
        axis = [1, 0, 0]
        [[loads]]
        kind = "force"
        on = { body = "string", at = "end" }
        force = [2.0, 0, 0]
        [analysis]
        kind = "modes"
        about = "equilibrium"
        count = 2
        "#;
    let found = gradients_of(text, &["loads[0].force[0]", "materials.m.young"]);
    let area = std::f64::consts::PI * 1e-6 / 4.0;
    let rigidity = 2e9 * area * 1e-6 / 16.0;
    // With the strain ε = T/EA: ω² = (T + EI π²/(L²(1+ε)...)) π²/(ρ A L²); the stretched length enters with the order of ε = 0.13 %.
    let share = 2.0 / (2.0 + rigidity * std::f64::consts::PI.powi(2));
    assert_near("tension", relative(&found, "frequency[0]", "loads[0].force[0]"), 0.5 * share, 2e-3);
    let both = relative(&found, "frequency[0]", "loads[0].force[0]")
        + relative(&found, "frequency[0]", "materials.m.young");
    assert_near("units", both, 0.5, 1e-8);
}

/// Relative derivatives of Euler's load of a cantilever with respect to the rigidity of ten parts, in closed form.
#[test]
fn critical_load_of_ten_parts() {
    let rest = "
        [[loads]]
        kind = \"force\"
        on = { body = \"b10\", at = \"end\" }
        force = [-1.0, 0, 0]
        [analysis]
        kind = \"buckling\"
        count = 1
        ";
    let text = column(10, 2, ROUND, rest);
    let mut paths = paths_of(10, "young");
    paths.push("loads[0].force[0]".to_owned());
    let found = gradients_of(&text, &paths.iter().map(String::as_str).collect::<Vec<_>>());
    let exact = [
        0.1983631643083,
        0.1887346924494,
        0.1704202506425,
        0.145212584056,
        0.1155791947275,
        0.08442080527247,
        0.05478741594398,
        0.02957974935749,
        0.01126530755062,
        0.001636835691653,
    ];
    for (path, exact) in paths.iter().zip(exact) {
        assert_near(path, relative(&found, "factor[0]", path), exact, 1e-5);
    }
    assert_relative("load", derivative(&found, "factor[0]", "loads[0].force[0]"), found.values[0], 1e-9);
}
