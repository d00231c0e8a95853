use super::{column, derivative, gradients_of, relative, value};
use crate::common::assertions::{assert_near, assert_relative};

/// Cantilever with a force at its tip, of a cable with the rigidity EI = 100.
///
fn elastica(elements: usize) -> String {
    format!(
        r#"
        materials.m = {{ density = 1.0, young = 1.2e11 }}
        sections.s = {{ kind = "rectangle", width = 0.01, height = 0.01 }}
        [[bodies]]
        kind = "cable"
        name = "beam"
        from = [0, 0, 0]
        to = [10, 0, 0]
        elements = {elements}
        section = "s"
        material = "m"
        [[joints]]
        kind = "clamp"
        name = "root"
        a = {{ body = "beam", at = "start" }}
        [[loads]]
        kind = "force"
        on = {{ body = "beam", at = "end" }}
        force = [0, 0, 4.0]
        [[probes]]
        name = "end"
        on = {{ body = "beam", at = "end" }}
        [analysis]
        kind = "statics"
        "#
    )
}

/// Derivatives of the tip of the elastica with PL²/EI = 4 (Sze, Liu & Lo 2004, problem 3.1; derivatives by elliptic integrals).
#[test]
fn elastica_with_large_displacements() {
    let paths = ["loads[0].force[2]", "materials.m.young", "bodies.beam.to[0]"];
    let found = gradients_of(&elastica(32), &paths);
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    assert_relative("y", value(&found, "end.z"), 6.699641812777, 1e-5);
    // By P, E and L, of the deflection and of the shortening.
    let deflection = [0.5302671180167, -2.121068472067 / 1.2e11, 1.094177875691];
    let shortening = [0.6585689605867, -2.634275842347 / 1.2e11, 0.8557964107162];
    for ((path, y), u) in paths.iter().zip(deflection).zip(shortening) {
        let moved = if *path == "bodies.beam.to[0]" { 1.0 } else { 0.0 };
        assert_relative(path, derivative(&found, "end.z", path), y, 1e-5);
        assert_relative(path, moved - derivative(&found, "end.x", path), u, 1e-5);
    }
}

/// Relative derivatives of the deflection of the elastica with PL²/EI = 1 with respect to the rigidity of tenths, by shooting.
#[test]
fn elastica_of_ten_parts() {
    let rest = "
        [[loads]]
        kind = \"force\"
        on = { body = \"b10\", at = \"end\" }
        force = [0, 0, 0.0175]
        [[probes]]
        name = \"end\"
        on = { body = \"b10\", at = \"end\" }
        [analysis]
        kind = \"statics\"
        ";
    // EI = 2.1e11 · 0.001⁴/12 = 0.0175.
    let text = column(10, 8, ("cable", "{ kind = \"rectangle\", width = 0.001, height = 0.001 }"), rest);
    let paths: Vec<String> = (1..=10).map(|k| format!("materials.m{k}.young")).collect();
    let found = gradients_of(&text, &paths.iter().map(String::as_str).collect::<Vec<_>>());
    let exact = [
        -0.071337466510,
        -0.055556216548,
        -0.041991964325,
        -0.030616413302,
        -0.021311783347,
        -0.013915313850,
        -0.0082530191911,
        -0.0041637543453,
        -0.0015154050142,
        -0.00021510669442,
    ];
    for (path, exact) in paths.iter().zip(exact) {
        assert_near(path, 2.1e11 * derivative(&found, "end.z", path), exact, 1e-6);
    }
}

/// Derivatives of the small deflection of a cantilever under its own weight and a force, w = PL³/3EI + ρgAL⁴/8EI.
#[test]
fn linear_cantilever() {
    let text = r#"
        gravity = [0, 0, -9.81]
        materials.m = { density = 7800.0, young = 2.1e13 }
        sections.s = { kind = "rectangle", width = 0.01, height = 0.02 }
        [[bodies]]
        kind = "beam"
        name = "beam"
        from = [0, 0, 0]
        to = [1, 0, 0]
        elements = 2
        section = "s"
        material = "m"
        [[joints]]
        kind = "clamp"
        name = "root"
        a = { body = "beam", at = "start" }
        [[loads]]
        kind = "force"
        on = { body = "beam", at = "end" }
        force = [0, 0, -10.0]
        [[probes]]
        name = "end"
        on = { body = "beam", at = "end" }
        [analysis]
        kind = "statics"
        "#;
    let paths =
        ["materials.m.young", "materials.m.density", "sections.s.height", "sections.s.width", "gravity[2]"];
    let found = gradients_of(text, &paths);
    let [force, weight] = [9.523809523809e-5, 5.465571428571e-5];
    let total = force + weight;
    // The shear deformation is of the order h²/L².
    for (path, exact) in paths.iter().zip([
        -1.0,
        weight / total,
        -force / total,
        -(3.0 * force + 2.0 * weight) / total,
        weight / total,
    ]) {
        assert_near(path, relative(&found, "end.z", path), exact, 2e-4);
    }
    // The reaction and the strain energy: the weight is exact, the energy half the work of the loads.
    assert_relative("reaction", relative(&found, "root.fz", "materials.m.density"), 0.6048, 1e-3);
}

/// Model file of a cantilever beam with a rigid block at its end, which a spring holds, by modulus, stiffness of the spring, width of the
/// beam and place of the centre of the block.
pub(super) fn beam_with_block([young, stiffness, width, x]: [f64; 4]) -> String {
    format!(
        r#"
        gravity = [0, 0, -9.81]
        materials.m = {{ density = 1200.0, young = {young:?}, poisson = 0.3 }}
        sections.s = {{ kind = "rectangle", width = {width:?}, height = 0.03 }}
        [[bodies]]
        kind = "beam"
        name = "beam"
        from = [0, 0, 0]
        to = [1, 0.2, 0]
        elements = 4
        section = "s"
        material = "m"
        [[bodies]]
        kind = "rigid"
        name = "block"
        mass = 2.0
        inertia = [0.02, 0.03, 0.04]
        center = [{x:?}, 0.2, -0.3]
        [[joints]]
        kind = "clamp"
        name = "root"
        a = {{ body = "beam", at = "start" }}
        [[joints]]
        kind = "clamp"
        name = "weld"
        a = {{ body = "block", at = [1, 0.2, 0] }}
        b = {{ body = "beam", at = "end" }}
        [[joints]]
        kind = "spring"
        name = "spring"
        a = {{ body = "block", at = [1.05, 0.2, -0.3] }}
        b = {{ point = [1.4, 0, -0.2] }}
        stiffness = {stiffness:?}
        [[probes]]
        name = "mid"
        on = {{ body = "beam", at = "center" }}
        record = ["motion", "rotation", "section_forces", "stress"]
        [analysis]
        kind = "statics"
        [output]
        energy_parts = true
        "#
    )
}

/// Derivatives agree with differences of neighbouring equilibria, for all columns.
#[test]
fn differences_of_equilibria() {
    let base = [5e8, 300.0, 0.04, 1.05];
    let paths =
        ["materials.m.young", "joints.spring.stiffness", "sections.s.width", "bodies.block.center[0]"];
    let found = gradients_of(&beam_with_block(base), &paths);
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
    for (column, path) in paths.iter().enumerate() {
        let at = |factor: f64| {
            let mut p = base;
            p[column] *= 1.0 + factor;
            gradients_of(&beam_with_block(p), &[]).values
        };
        let h = 1e-3;
        let (near, far) = ([at(h), at(-h)], [at(2.0 * h), at(-2.0 * h)]);
        for (row, quantity) in found.quantities.iter().enumerate() {
            let central =
                |pair: &[Vec<f64>; 2], h: f64| (pair[0][row] - pair[1][row]) / (2.0 * h * base[column]);
            let difference = (4.0 * central(&near, h) - central(&far, 2.0 * h)) / 3.0;
            let value = found.derivatives[(row, column)];
            let scale = found.values[row].abs().max(1e-9) / base[column];
            let error = (value - difference).abs();
            assert!(error <= 1e-7 * (scale + value.abs()), "{quantity} by {path}: {value} for {difference}");
        }
    }
}
