//! Motions that continue other motions of the same joints.

use ancf::record::Series;

use super::sequences::{last, run_all};

fn first(series: &Series, name: &str) -> f64 {
    series.column(name).unwrap()[0]
}

/// Arm with damped strains, clamped to a rotating hub, under a force at its tip. `step` and `scheme` are those of both motions.
fn arm_on_hub(step: &str, scheme: &str) -> String {
    let motion = |name: &str| {
        format!(
            "{{ kind = \"dynamics\", name = \"{name}\", duration = 0.2, step = {step}, scheme = {scheme} }}"
        )
    };
    format!(
        "gravity = [0, 0, 0]\n\
         materials.s = {{ density = 7850, poisson = 0.3, young = 2.1e11, damping = {{ strain = 1e-3 }} }}\n\
         sections.q = {{ kind = \"rectangle\", height = 0.01, width = 0.02 }}\n\
         bodies = [\n\
         {{ kind = \"beam\", name = \"arm\", from = [0.1, 0, 0], to = [1, 0, 0], elements = 4, section = \"q\", material = \"s\", \
         motion = {{ about = [0, 0, 0], spin = [0, 0, 10] }} }},\n\
         {{ kind = \"rigid\", name = \"hub\", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.1, 0.1], motion = {{ spin = [0, 0, 10] }} }}]\n\
         joints = [\n\
         {{ kind = \"revolute\", name = \"axle\", axis = [0, 0, 1], a = {{ body = \"hub\", at = \"center\" }} }},\n\
         {{ kind = \"clamp\", name = \"root\", a = {{ body = \"arm\", at = \"start\" }}, b = {{ body = \"hub\", at = [0.1, 0, 0] }} }}]\n\
         loads = [{{ kind = \"force\", on = {{ body = \"arm\", at = \"end\" }}, force = [0, 20, 0] }}]\n\
         analysis = [{}, {}]\n",
        motion("a"),
        motion("b")
    )
}

/// The first reactions of a motion are the last ones of the motion that it continues. A projection of the velocities in the norm of the
/// kinetic energy would change the strain rates of the section in the clamp: 366 N in place of 15 N with steps of 4 ms.
#[test]
fn reactions_continue() {
    for (step, tolerance) in [("0.004", 2e-3), ("0.002", 1e-3), ("{ tolerance = 1e-4 }", 2e-2)] {
        let runs = run_all(&arm_on_hub(step, "{ spectral_radius = 0.6 }"));
        let largest =
            |name: &str| runs[0].0.column(name).unwrap().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        for name in ["root.fx", "root.fy", "root.mz", "axle.fx", "axle.fy"] {
            let [before, after] = [last(&runs[0].0, name), first(&runs[1].0, name)];
            let difference = (after - before).abs() / largest(name);
            assert!(difference < tolerance, "{step}: {name} {before} and {after}");
        }
    }
}

/// A hinge has its turns after a motion with a spring, whose angle is a coordinate, and before one without a spring.
#[test]
fn turns_continue_without_the_spring() {
    let hinge = |parts: &str| {
        format!(
            "{{ kind = \"revolute\", name = \"h\", a = {{ body = \"rod\", at = [0, 0, 0] }}, axis = [0, 0, 1], {parts} }}"
        )
    };
    let text = format!(
        "bodies = [{{ kind = \"rigid\", name = \"rod\", center = [0.5, 0, 0], mass = 2, inertia = [0.01, 0.2, 0.2], \
         motion = {{ about = [0, 0, 0], spin = [0, 0, 20] }} }}]\n\
         joints = [{}, {}]\n\
         analysis = [{{ kind = \"dynamics\", name = \"a\", duration = 1, step = 0.01 }}, \
         {{ kind = \"dynamics\", name = \"b\", duration = 1, step = 0.01 }}]\n",
        hinge("spring = { stiffness = 1e-3 }, only_in = [\"a\"]"),
        hinge("not_in = [\"a\"]")
    );
    let runs = run_all(&text);
    let [before, after] = [last(&runs[0].0, "h.angle"), first(&runs[1].0, "h.angle")];
    assert!(before > 19.0 && (after - before).abs() < 1e-9, "{before} and {after}");
    assert!((last(&runs[1].0, "h.angle") - 2.0 * before).abs() < 0.2);
}
