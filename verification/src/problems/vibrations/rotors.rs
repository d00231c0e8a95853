//! Damped modes and whirls of shafts with internal damping: complex eigenvalues λ.

use std::f64::consts::{PI, TAU};

use crate::reference::root;
use crate::{Findings, Problem, Refinement, SolvedModel, VerificationError};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "damped_cantilever",
        title: "Damped modes of a cantilever with strain damping",
        source: "Euler-Bernoulli beam, cos βL cosh βL = −1; λ = −τω²/2 ± iω √(1 − τ²ω²/4)",
        sketch: r"
    |/|=================    L = 1 m, rectangle 0.1 mm × 0.4 mm, E = 210 GPa, τω₁ = 0.02",
        goal: "Frequencies and growth rates of three bending modes in a plane within 1e-3 with 16 elements, of the first within 1e-5. Fourth order",
        run: damped_cantilever,
    },
    Problem {
        name: "whirling_shaft",
        title: "Whirling shaft with internal damping",
        source: "Euler-Bernoulli beam, ω = (nπ/L)² √(EI/ρA); u = y + iz in the rotating frame: λ² + (2iΩ + τω²) λ + ω² − Ω² = 0, Im λ ≈ |ω ∓ Ω|",
        sketch: r"
      o=================o   L = 1 m, L/d = 10 000, E = 210 GPa, τω₁ = 0.02, Ω = 0.4 ω₁",
        goal: "Forward and backward frequencies of two modes within 1e-4 with 16 elements, frequencies and growth rates of the first within 1e-5. Fourth order",
        run: || shaft(0.4),
    },
    Problem {
        name: "unstable_shaft",
        title: "Shaft with internal damping above its critical speed",
        source: "Kimball (1924): the forward whirl grows for Ω > ω₁; λ² + (2iΩ + τω²) λ + ω² − Ω² = 0",
        sketch: r"
      o=================o   L = 1 m, L/d = 10 000, E = 210 GPa, τω₁ = 0.02, Ω = 1.4 ω₁",
        goal: "Forward and backward frequencies of two modes within 1e-4 with 16 elements, frequencies and growth rates of the first within 1e-5. Fourth order",
        run: || shaft(1.4),
    },
];

/// Damping τω₁ of the first mode.
const DAMPING: f64 = 0.02;

/// Returns the value of a column in a row.
fn value<'a>(column: &'a str, row: usize) -> impl Fn(&SolvedModel) -> Result<f64, VerificationError> + 'a {
    move |s| {
        let found = s.column(column)?.get(row).copied();
        found.ok_or_else(|| VerificationError::Missing(format!("mode {}", row + 1)))
    }
}

fn damped_cantilever() -> Result<Findings, VerificationError> {
    const HEIGHT: f64 = 1e-4;
    let characteristic = |x: f64| x.cos() + 1.0 / x.cosh();
    let unit = (210e9 / 7850.0 / 12.0f64).sqrt() * HEIGHT;
    let omega = [1.8, 4.6, 7.8].map(|x| root(characteristic, x, x + 0.2).powi(2) * unit);
    let tau = DAMPING / omega[0];
    let frequency = |k: usize| omega[k] * (1.0 - (0.5 * tau * omega[k]).powi(2)).sqrt() / TAU;
    let growth = |k: usize| -0.5 * tau * omega[k].powi(2);
    let model = format!(
        r#"
        materials.steel = {{ density = 7850, young = 210e9, damping = {{ strain = {tau:?} }} }}
        sections.strip = {{ kind = "rectangle", height = {HEIGHT:?}, width = {:?} }}
        bodies = [{{ kind = "beam", name = "rod", from = [0, 0, 0], to = [1, 0, 0], elements = ELEMENTS, section = "strip", material = "steel" }}]
        joints = [{{ kind = "clamp", name = "root", a = {{ body = "rod", at = "start" }} }}]
        analysis = {{ kind = "modes", count = 4, damped = true }}
        "#,
        4.0 * HEIGHT
    );
    // The second mode bends the strip in its stiff plane, with 4 ω₁.
    Refinement::elements(&model, &[4, 8, 16])
        .value("first frequency, Hz", value("frequency", 0), frequency(0), 1e-5)
        .value("first growth rate, 1/s", value("growth_rate", 0), growth(0), 1e-5)
        .value("second frequency, Hz", value("frequency", 2), frequency(1), 1e-3)
        .order(4.0)
        .value("second growth rate, 1/s", value("growth_rate", 2), growth(1), 1e-3)
        .order(4.0)
        .value("third frequency, Hz", value("frequency", 3), frequency(2), 1e-3)
        .order(4.0)
        .value("third growth rate, 1/s", value("growth_rate", 3), growth(2), 1e-3)
        .order(4.0)
        .run()
}

/// Frequency and growth rate of the forward and of the backward whirl in the frame that rotates with the shaft.
///
/// λ = −a − iΩ ± (p + iq) with a = τω²/2 and (p + iq)² = a² − ω² + 2iΩa.
fn whirls(omega: f64, speed: f64, tau: f64) -> [[f64; 2]; 2] {
    let a = 0.5 * tau * omega.powi(2);
    let real = a.powi(2) - omega.powi(2);
    let q = (0.5 * (real.hypot(2.0 * speed * a) - real)).sqrt();
    let p = speed * a / q;
    [[(q - speed).abs() / TAU, p - a], [(q + speed) / TAU, -p - a]]
}

/// Shaft on two bearings, of which the first one also holds its rotation, at a speed relative to ω₁.
fn shaft(speed: f64) -> Result<Findings, VerificationError> {
    const DIAMETER: f64 = 1e-4;
    let first = PI.powi(2) * (210e9 / 7850.0f64).sqrt() * 0.25 * DIAMETER;
    let (omega, tau) = (speed * first, DAMPING / first);
    let [[forward, backward], [second_forward, second_backward]] =
        [1.0, 4.0].map(|order| whirls(order * first, omega, tau));
    let model = format!(
        r#"
        materials.steel = {{ density = 7850, young = 210e9, damping = {{ strain = {tau:?} }} }}
        sections.round = {{ kind = "circle", diameter = {DIAMETER:?} }}
        bodies = [{{ kind = "beam", name = "shaft", from = [0, 0, 0], to = [1, 0, 0], elements = ELEMENTS, section = "round", material = "steel" }}]
        joints = [
          {{ kind = "universal", name = "left", a = {{ body = "shaft", at = "start" }}, axis_a = [0, 0, 1], axis_b = [0, 1, 0] }},
          {{ kind = "point_on_line", name = "right", a = {{ body = "shaft", at = "end" }}, axis = [1, 0, 0] }},
        ]
        loads = [{{ kind = "base_rotation", angular_velocity = [{omega:?}, 0, 0] }}]
        analysis = {{ kind = "modes", count = 4, about = "equilibrium", damped = true }}
        "#
    );
    // By |λ|: the whirls of the first mode, then those of the second one.
    Refinement::elements(&model, &[4, 8, 16])
        .value("forward frequency, Hz", value("frequency", 0), forward[0], 1e-5)
        .order(4.0)
        .value("forward growth rate, 1/s", value("growth_rate", 0), forward[1], 1e-5)
        .value("backward frequency, Hz", value("frequency", 1), backward[0], 1e-5)
        .order(4.0)
        .value("backward growth rate, 1/s", value("growth_rate", 1), backward[1], 1e-5)
        .value("second forward frequency, Hz", value("frequency", 2), second_forward[0], 1e-4)
        .order(4.0)
        .value("second backward frequency, Hz", value("frequency", 3), second_backward[0], 1e-4)
        .order(4.0)
        .run()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hold() {
        crate::assert_all_hold(PROBLEMS);
    }

    /// Without damping the frequencies are |ω ∓ Ω|; the forward whirl decays below the critical speed and grows above it.
    #[test]
    fn whirls_have_their_limits() {
        let [[forward, still], [backward, _]] = whirls(3.0, 1.0, 0.0);
        assert!((forward * TAU - 2.0).abs() < 1e-12 && (backward * TAU - 4.0).abs() < 1e-12);
        assert_eq!(still, 0.0);
        assert!(whirls(3.0, 2.9, 0.01)[0][1] < 0.0 && whirls(3.0, 3.1, 0.01)[0][1] > 0.0);
    }
}
