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
    assert_eq!(found.warnings.len(), 2, "{:?}", found.warnings);
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

/// Six equal clamped rods of one material each: the derivatives of the two lowest frequencies are those of the rod whose density
/// increases, also if only one of the twelve equal frequencies is requested.
#[test]
fn frequencies_of_equal_bodies() {
    let body = |k: usize| {
        format!(
            "materials.m{k} = {{ density = 7800.0, young = 2.1e11 }}\n[[bodies]]\nkind = \"cable\"\nname = \"b{k}\"\nfrom = [0, {k}, 0]\n\
             to = [1, {k}, 0]\nelements = 2\nsection = \"rod\"\nmaterial = \"m{k}\"\n[[joints]]\nkind = \"clamp\"\nname = \"c{k}\"\n\
             a = {{ body = \"b{k}\", at = \"start\" }}\n"
        )
    };
    let model = |count: usize| {
        let materials: Vec<String> = (0..6).map(body).collect();
        let (tables, arrays): (Vec<_>, Vec<_>) =
            materials.iter().map(|text| text.split_once('\n').unwrap()).unzip();
        let rest = format!("[analysis]\nkind = \"modes\"\ncount = {count}\n");
        format!(
            "sections.rod = {{ kind = \"circle\", diameter = 0.02 }}\n{}\n{}{rest}",
            tables.join("\n"),
            arrays.concat()
        )
    };
    for (count, number) in [(1, 0), (1, 5), (4, 3)] {
        let path = format!("materials.m{number}.density");
        let found = gradients_of(&model(count), &[&path]);
        assert_eq!(found.quantities.len(), count);
        for mode in 0..count {
            let exact = if mode < 2 { -0.5 } else { 0.0 };
            assert_near("density", relative(&found, &format!("frequency[{mode}]"), &path), exact, 1e-8);
        }
        assert!(found.warnings.iter().any(|warning| warning.contains("are equal")), "{:?}", found.warnings);
    }
}

/// Critical factors of both signs, of columns under forces in both directions: equal ones are differentiated together, in the order of
/// their magnitudes.
#[test]
fn critical_factors_of_both_signs() {
    let mut text = "sections.rod = { kind = \"circle\", diameter = 0.02 }\n".to_owned();
    (0..4).for_each(|k| text += &format!("materials.m{k} = {{ density = 7800.0, young = 2.1e11 }}\n"));
    for k in 0..4 {
        let force = if k % 2 == 0 { -1.0 } else { 1.0 };
        text += &format!(
            "[[bodies]]\nkind = \"cable\"\nname = \"b{k}\"\nfrom = [0, {k}, 0]\nto = [1, {k}, 0]\nelements = 2\nsection = \"rod\"\n\
             material = \"m{k}\"\n[[joints]]\nkind = \"clamp\"\nname = \"c{k}\"\na = {{ body = \"b{k}\", at = \"start\" }}\n\
             [[loads]]\nkind = \"force\"\non = {{ body = \"b{k}\", at = \"end\" }}\nforce = [{force:?}, 0, 0]\n"
        );
    }
    for (sense, number, sign) in [("either", 0, 1.0), ("either", 1, -1.0), ("reversed", 1, -1.0)] {
        let rest = format!("[analysis]\nkind = \"buckling\"\ncount = 8\nsense = \"{sense}\"\n");
        let path = format!("materials.m{number}.young");
        let found = gradients_of(&(text.clone() + &rest), &[&path]);
        let own: Vec<f64> = (0..found.quantities.len())
            .filter(|row| {
                found.values[*row] * sign > 0.0 && found.values[*row].abs() < 1.5 * found.values[0].abs()
            })
            .map(|row| found.derivatives[(row, 0)] * 2.1e11 / found.values[row])
            .collect();
        // Of the four equal factors, the two of the stiffer column become the larger ones.
        for (place, value) in own.iter().enumerate() {
            let exact = if place < 2 { 0.0 } else { 1.0 };
            assert_near(&format!("{sense} {place}"), *value, exact, 1e-6);
        }
        assert_eq!(own.len(), 4, "{own:?}");
    }
}

/// Joints that close gaps change the state about which a structure vibrates. Derivatives agree with differences.
#[test]
fn assembled_models() {
    let text = |x: f64, diameter: f64, analysis: &str| {
        format!(
            r#"
            assemble = true
            gravity = [0.0, -9.81, 0.0]
            materials.c = {{ density = 2700.0, young = 7e9 }}
            sections.s = {{ kind = "circle", diameter = {diameter:?} }}
            bodies = [
              {{ kind = "beam", name = "b", from = [0, 0, 0], to = [1, 0, 0], elements = 4, section = "s", material = "c" }},
              {{ kind = "beam", name = "b2", from = [{x:?}, 0.02, 0], to = [2, 0, 0], elements = 4, section = "s", material = "c" }},
            ]
            joints = [
              {{ kind = "clamp", name = "m", a = {{ body = "b", at = "start" }} }},
              {{ kind = "clamp", name = "m2", a = {{ body = "b2", at = "end" }} }},
              {{ kind = "clamp", name = "k", a = {{ body = "b2", at = "start" }}, b = {{ body = "b", at = "end" }} }},
            ]
            analysis = {{ kind = "{analysis}" }}
            "#
        )
    };
    let base = [1.02, 0.02];
    for analysis in ["modes", "buckling"] {
        let paths = ["bodies.b2.from[0]", "sections.s.diameter"];
        let found = gradients_of(&text(base[0], base[1], analysis), &paths);
        for column in 0..2 {
            let at = |factor: f64| {
                let mut p = base;
                p[column] *= 1.0 + factor;
                gradients_of(&text(p[0], p[1], analysis), &[]).values[0]
            };
            let h = 1e-4;
            let difference = (at(h) - at(-h)) / (2.0 * h * base[column]);
            assert_relative(paths[column], found.derivatives[(0, column)], difference, 1e-4);
        }
    }
}

/// The stiffness of a spring begins to increase at an equilibrium: its frequency has a kink, its force none.
#[test]
fn kinks_of_the_stiffness() {
    let text = |force: f64| {
        format!(
            r#"
            [[bodies]]
            kind = "mass"
            name = "block"
            mass = 1.0
            center = [0, 0, 0]
            [[joints]]
            kind = "spring"
            name = "spring"
            a = {{ body = "block", at = "center" }}
            b = {{ point = [0, 0, 2.0] }}
            tension = {{ kind = "expression", text = "x + 20*max(x - 1, 0)^2" }}
            [[joints]]
            kind = "point_on_line"
            name = "guide"
            a = {{ body = "block", at = "center" }}
            axis = [0, 0, 1]
            [[loads]]
            kind = "force"
            on = {{ body = "block", at = "center" }}
            force = [0, 0, {force:?}]
            [analysis]
            kind = "modes"
            about = "equilibrium"
            count = 1
            "#
        )
    };
    let parameters = [ancf::Parameter::new("loads[0].force[2]")];
    let model = crate::common::models::parse(&text(-1.0));
    let error = ancf::gradients(&model, &parameters, &Default::default()).unwrap_err();
    assert!(error.to_string().contains("a stiffness has a kink there"), "{error}");
    // Beside the kink k = 1 + 40 (x - 1) and F = x + 20 (x - 1)² at x = 1.1: ω dω/dF = 20/k.
    let found = gradients_of(&text(-1.3), &["loads[0].force[2]"]);
    let (frequency, stiffness) = (5.0_f64.sqrt() / std::f64::consts::TAU, 5.0);
    assert_relative("frequency", found.values[0], frequency, 1e-9);
    let exact = -0.5 * frequency / stiffness * 40.0 / stiffness;
    assert_relative("derivative", found.derivatives[(0, 0)], exact, 1e-6);
}
