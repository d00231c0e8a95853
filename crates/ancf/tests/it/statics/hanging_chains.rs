//! Chains of rigid links that only their weight supports hang from their first hinge, whatever their direction at the start.

use crate::common::models::parse;
use crate::common::solutions::Run;

/// Chain of links of 0.1 m along x.
fn chain(count: usize, hinge: &str) -> Run {
    let link = |k: usize| {
        let x = 0.1 * k as f64 + 0.05;
        format!(
            "{{ kind = \"rigid\", name = \"b{k}\", center = [{x}, 0, 0], mass = 0.01, inertia = [1e-9, 8.33e-6, 8.33e-6] }}"
        )
    };
    let joint = |k: usize| {
        let end = |body: usize| format!("{{ body = \"b{body}\", at = [{}, 0, 0] }}", 0.1 * k as f64);
        let other = if k == 0 { String::new() } else { format!(", b = {}", end(k - 1)) };
        format!("{{ name = \"j{k}\", {hinge}, a = {}{other} }}", end(k))
    };
    let list = |of: &dyn Fn(usize) -> String| (0..count).map(of).collect::<Vec<_>>().join(",\n");
    Run::of(&parse(&format!(
        "gravity = [0, 0, -9.81]
        bodies = [{}]
        joints = [{}]
        probes = [{{ name = \"end\", on = {{ body = \"b{}\", at = \"center\" }} }}]
        initial.from = \"equilibrium\"
        analysis = {{ kind = \"dynamics\", duration = 1e-3, step = 1e-3 }}",
        list(&link),
        list(&joint),
        count - 1
    )))
}

#[test]
fn chains_hang() {
    for count in [2, 6, 9, 20] {
        let z = chain(count, "kind = \"revolute\", axis = [0, 1, 0]").last("end.z");
        let expected = -0.1 * (count as f64 - 0.5);
        assert!((z / expected - 1.0).abs() < 1e-6, "{count} links: {z}, not {expected}");
    }
}
