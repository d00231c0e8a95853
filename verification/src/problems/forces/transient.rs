//! Waves, base acceleration, sudden and moving loads.

use std::f64::consts::{PI, TAU};

use crate::reference::integral;
use crate::{Findings, Problem, Refinement, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "bar_wave",
        title: "Longitudinal wave in a bar",
        source: "d'Alembert: F(t) at the free end of a bar gives the velocity F(t)/ρcA there until the reflection returns",
        sketch: r"
    |/|=====================--> F sin²    L = 1 m, c = 100 m/s, pulse of 10 ms
                                          observed until the reflection returns after 20 ms",
        goal: "Displacement of the loaded end and its velocity with 32 and 64 elements. At least second order",
        run: bar_wave,
    },
    Problem {
        name: "shaken_oscillator",
        title: "Oscillator on an accelerated base: load `base_acceleration`",
        source: "u'' + ω² u = −a sin Ωt from rest: u = −a (sin Ωt − (Ω/ω) sin ωt)/(ω² − Ω²)",
        sketch: r"
      |--/\/\--[ m ]    m = 2 kg, k = 200 N/m, a = 3 m/s², Ω/2π = 1 Hz
      <-->",
        goal: "Displacement relative to the base. Second order",
        run: shaken_oscillator,
    },
    Problem {
        name: "sudden_load",
        title: "Sudden force at the middle of a simply supported beam",
        source: "Modal series: w = (2P/ρAL) Σ sin²(nπ/2) (1 − cos ω_n t)/ω_n²",
        sketch: r"
             | P
             v
      o=============o     L = 1 m, slender; observed over the first period",
        goal: "Deflection of the middle over the first period within 1e-2 of its maximum",
        run: sudden_load,
    },
    Problem {
        name: "moving_load",
        title: "Force that moves along a beam: joint `slide` with a driven speed",
        source: "Timoshenko, Krylov: modal series of a force of constant speed, Duhamel's integral by quadrature",
        sketch: r"
          P v -> c
      o===========o     L = 1 m, c = 0.3 L f₁, from 0.1 m to 0.9 m,
                        mass 1e-7 of that of the beam",
        goal: "Deflection of the middle at the end of the motion, within 1e-2",
        run: moving_load,
    },
];

fn bar_wave() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        materials.m = { density = 1000, young = 1e7 }
        sections.s = { kind = "general", area = 1e-2, iy = 1e-5, iz = 1e-5 }
        bodies = [{ kind = "beam", name = "bar", from = [0, 0, 0], to = [1, 0, 0], elements = ELEMENTS, section = "s", material = "m" }]
        joints = [{ kind = "clamp", name = "root", a = { body = "bar", at = "start" } }]
        loads = [{ kind = "force", on = { body = "bar", at = "end" }, force = [1e-3, 0, 0], time = { kind = "expression", text = "if(t < 0.01, sin(100*pi*t)^2, 0)" } }]
        probes = [{ name = "p", on = { body = "bar", at = "end" } }]
        analysis = { kind = "dynamics", duration = 0.018, step = STEP }
    "#;
    // ρcA = 1000 N s/m.
    let velocity = |t: f64| if t < 0.01 { 1e-6 * (100.0 * PI * t).sin().powi(2) } else { 0.0 };
    let moved = |t: f64| {
        let t = t.min(0.01);
        1.0 + 0.5e-6 * (t - (200.0 * PI * t).sin() / (200.0 * PI))
    };
    let model = |n: u32| {
        MODEL.replace("ELEMENTS", &n.to_string()).replace("STEP", &format!("{:?}", 0.0032 / f64::from(n)))
    };
    Refinement::new("elements", &[16, 32, 64], model)
        .curve("position of the end, m", ["t", "p.x"], moved, 5e-9, 1e-2)
        .order(2.0)
        .curve("velocity of the end, m/s", ["t", "p.vx"], velocity, 1e-6, 2e-2)
        .order(2.0)
        .run()
}

fn shaken_oscillator() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        bodies = [{ kind = "rigid", name = "block", center = [0, 0, 0], mass = 2, inertia = [1, 1, 1] }]
        joints = [{ kind = "prismatic", name = "guide", a = { body = "block", at = "center" }, axis = [1, 0, 0], spring = { stiffness = 200 } }]
        loads = [{ kind = "base_acceleration", acceleration = [3, 0, 0], time = { kind = "sine", frequency = 1 } }]
        analysis = { kind = "dynamics", duration = DURATION, step = STEP }
    "#;
    let law = |t: f64| -3.0 * ((TAU * t).sin() - TAU / 10.0 * (10.0 * t).sin()) / (100.0 - TAU * TAU);
    Refinement::steps(MODEL, 3.0, &[600, 1200])
        .curve("displacement, m", ["t", "guide.displacement"], law, 0.08, 1e-3)
        .order(2.0)
        .run()
}

fn sudden_load() -> Result<Findings, VerificationError> {
    const MODEL: &str = r#"
        materials.m = { density = 1000, young = 1e9 }
        sections.s = { kind = "circle", diameter = 0.01 }
        bodies = [{ kind = "beam", name = "beam", from = [0, 0, 0], to = [1, 0, 0], elements = ELEMENTS, section = "s", material = "m" }]
        joints = [
          { kind = "revolute", name = "left", a = { body = "beam", at = "start" }, axis = [0, 0, 1] },
          { kind = "point_on_line", name = "right", a = { body = "beam", at = "end" }, axis = [1, 0, 0] },
        ]
        loads = [{ kind = "force", on = { body = "beam", at = 0.5 }, force = [0, -1e-3, 0] }]
        probes = [{ name = "p", on = { body = "beam", at = 0.5 } }]
        analysis = { kind = "dynamics", duration = STEP00, step = STEP }
    "#;
    let (line, bending) = (1000.0 * PI * 0.005f64.powi(2), 1e9 * PI * 0.01f64.powi(4) / 64.0);
    let first = PI * PI * (bending / line).sqrt();
    let law = |t: f64| {
        let term = |k: u32| {
            let omega = first * f64::from((2 * k + 1).pow(2));
            (1.0 - (omega * t).cos()) / (omega * omega)
        };
        -2e-3 / line * (0..50).map(term).sum::<f64>()
    };
    let period = TAU / first;
    let model = |n: u32| {
        MODEL
            .replace("ELEMENTS", &n.to_string())
            .replace("STEP00", &format!("{period:?}"))
            .replace("STEP", &format!("{:?}", period / 400.0))
    };
    Refinement::new("elements", &[8, 16, 32], model)
        .curve("deflection of the middle, m", ["t", "p.y"], law, 1e-3 / (24.0 * bending), 1e-2)
        .run()
}

fn moving_load() -> Result<Findings, VerificationError> {
    let (line, bending) = (1000.0 * PI * 0.005f64.powi(2), 1e9 * PI * 0.01f64.powi(4) / 64.0);
    let first = PI * PI * (bending / line).sqrt();
    let speed = 0.3 * first / TAU;
    let duration = 0.8 / speed;
    let mass = 1e-7 * line;
    let model = format!(
        r#"
        materials.m = {{ density = 1000, young = 1e9 }}
        sections.s = {{ kind = "circle", diameter = 0.01 }}
        bodies = [
          {{ kind = "beam", name = "beam", from = [0, 0, 0], to = [1, 0, 0], elements = ELEMENTS, section = "s", material = "m" }},
          {{ kind = "mass", name = "load", center = [0.1, 0, 0], mass = {mass:?}, motion = {{ velocity = [{speed:?}, 0, 0] }} }},
        ]
        joints = [
          {{ kind = "revolute", name = "left", a = {{ body = "beam", at = "start" }}, axis = [0, 0, 1] }},
          {{ kind = "point_on_line", name = "right", a = {{ body = "beam", at = "end" }}, axis = [1, 0, 0] }},
          {{ kind = "slide", name = "slide", a = {{ body = "load", at = "center" }}, b = {{ body = "beam", at = 0.1 }}, drive = {{ speed = {speed:?} }} }},
        ]
        loads = [{{ kind = "force", on = {{ body = "load", at = "center" }}, force = [0, -1e-3, 0] }}]
        probes = [{{ name = "p", on = {{ body = "beam", at = 0.5 }} }}]
        analysis = {{ kind = "dynamics", duration = {duration:?}, step = {:?} }}
        "#,
        duration / 1000.0
    );
    let term = |k: u32| {
        let wave = f64::from(2 * k + 1) * PI;
        let omega = first * f64::from((2 * k + 1).pow(2));
        let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        let force = |t: f64| (wave * (0.1 + speed * t)).sin() * (omega * (duration - t)).sin() / omega;
        sign * integral(force, 0.0, duration)
    };
    let deflection = -2e-3 / line * (0..6).map(term).sum::<f64>();
    Refinement::elements(&model, &[4, 8, 16])
        .last("deflection of the middle, m", "p.y", deflection, 1e-2)
        .last("position of the load, m", "slide.position", 0.9, 1e-9)
        .run()
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
