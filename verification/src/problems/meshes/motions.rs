//! Estimated errors of motions: those of the time steps and of the mesh.

use crate::{Effectivity, Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "motion_oscillator",
        title: "Estimated error: a mass on a spring, scheme of second order",
        source: "x = x₀ + v/ω sin ωt",
        sketch: OSCILLATOR,
        goal: "Ratio of estimate and error 0.3 to 3 in 400 to 1600 steps; value + error within 1e-5 of the amplitude",
        run: || oscillator("{ spectral_radius = 0.8 }", &[400, 800, 1600], 1e-5),
    },
    Problem {
        name: "motion_oscillator_damped",
        title: "Estimated error: a mass on a spring, scheme of first order",
        source: "x = x₀ + v/ω sin ωt",
        sketch: OSCILLATOR,
        goal: "Ratio of estimate and error 0.3 to 3 in 4000 to 16000 steps; value + error within 2e-3 of the amplitude",
        run: || oscillator("\"adams\"", &[4000, 8000, 16000], 2e-3),
    },
    Problem {
        name: "motion_pendulum",
        title: "Estimated error: a rigid rod on a hinge in large rotations",
        source: "θ̈ = 3g/2L cos θ, integrated by the classical Runge-Kutta method in 20000 steps",
        sketch: r"
     o=====================   L = 1 m, at rest
     hinge      | g",
        goal: "Ratio of estimate and error 0.3 to 3 in 100 to 400 steps; value + error within 1e-5 of the length",
        run: pendulum,
    },
    Problem {
        name: "motion_cantilever_steps",
        title: "Estimated error: time steps of a dropped cantilever",
        source: "Euler-Bernoulli beam, 40 modes",
        sketch: DROPPED,
        goal: "Ratio of estimate and error 0.3 to 3 in 200 to 800 steps, 8 linked elements; value + error within 2e-3",
        run: || dropped("linked", &[(8, 200), (8, 400), (8, 800)], true, 2e-3),
    },
    Problem {
        name: "motion_cantilever_enhanced",
        title: "Estimated error: mesh of a dropped cantilever of enhanced elements",
        source: "Euler-Bernoulli beam, 40 modes",
        sketch: DROPPED,
        goal: "Ratio of estimate and error 0.3 to 3 with 4 to 16 elements in 1600 steps; value + error within 5e-3",
        run: || dropped("enhanced", &[(4, 1600), (8, 1600), (16, 1600)], false, 5e-3),
    },
    Problem {
        name: "motion_cantilever_quadratic",
        title: "Estimated error: mesh of a dropped cantilever of quadratic elements",
        source: "Euler-Bernoulli beam, 40 modes",
        sketch: DROPPED,
        goal: "Ratio of estimate and error 0.3 to 3 with 3 to 6 elements in 1600 steps; value + error within 1e-3",
        run: || dropped("quadratic", &[(3, 1600), (4, 1600), (6, 1600)], false, 1e-3),
    },
    Problem {
        name: "motion_spin_up",
        title: "Estimated error: a beam that a drive spins up",
        source: "The same model in 6400 steps with twice the elements",
        sketch: r"
    (drive)=================   L = 10, smooth spin-up, 8 s",
        goal: "Ratio of estimate and error 0.3 to 3 in 100 to 400 steps, 6 elements; value + error within 1e-4 of the length",
        run: spin_up,
    },
];

const OSCILLATOR: &str = r"
    |/|\/\/\/[m]  →    ω = 20 rad/s, 6 periods";

const DROPPED: &str = r"
    |/|=================   L/h = 1000, straight at t = 0
              | g          4 periods";

/// Permitted ratios of the estimated and the true error.
const MOTIONS: [f64; 2] = [0.3, 3.0];

/// Root of the mean squares.
fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), x| (sum + x * x, count + 1.0));
    f64::sqrt(sum / count)
}

/// Model of a level with the number of the level, and the errors of a column against the reference.
struct Motion<'a> {
    column: &'a str,
    amplitude: f64,
    tolerance: f64,
}

impl Motion<'_> {
    /// Compares the root mean squares of the estimated and the true errors of each level, and value + error of the last one.
    fn compare(
        &self,
        levels: &[u32],
        model: impl Fn(usize) -> Result<SolvedModel, VerificationError>,
        exact: impl Fn(f64) -> f64,
    ) -> Result<Findings, VerificationError> {
        let mut findings = Findings::default();
        let [mut before, mut after] = [Vec::new(), Vec::new()];
        for (index, &level) in levels.iter().enumerate() {
            let solved = model(index)?;
            let (t, values) = (solved.column("t")?, solved.column(self.column)?);
            let errors = solved.column(&format!("{}_error", self.column))?;
            let error = rms(t.iter().zip(values).map(|(t, value)| exact(*t) - value));
            let rows = t.iter().zip(values).zip(errors);
            let left = rms(rows.map(|((t, value), error)| exact(*t) - value - error));
            let (what, estimate) = (self.column.to_owned(), rms(errors.iter().copied()));
            findings.effectivities.push(Effectivity { what, level, estimate, error, range: MOTIONS });
            before.push([f64::from(level), error / self.amplitude]);
            after.push([f64::from(level), left / self.amplitude]);
            if index + 1 == levels.len() {
                let what =
                    format!("{}: root mean square of value + estimated error − reference", self.column);
                findings.compare(what, left, 0.0, self.amplitude, self.tolerance);
            }
        }
        let curves =
            vec![PlotCurve::line("value", before), PlotCurve::line("value + estimated error", after)];
        let axes = ["steps or elements", "relative error, root mean square"];
        let plot = Plot::new("Errors against the reference", axes, curves);
        findings.plot(plot.with_logarithmic_axes([true, true]));
        Ok(findings)
    }
}

fn oscillator(scheme: &str, steps: &[u32], tolerance: f64) -> Result<Findings, VerificationError> {
    let model = |steps: u32| {
        format!(
            r#"
            output.errors = true
            bodies = [{{ kind = "rigid", name = "m", center = [1, 0, 0], mass = 2, inertia = [1, 1, 1],
                motion = {{ velocity = [1, 0, 0] }} }}]
            joints = [{{ kind = "prismatic", name = "guide", a = {{ body = "m", at = "center" }},
                axis = [1, 0, 0], spring = {{ stiffness = 800 }} }}]
            probes = [{{ name = "mass", on = {{ body = "m", at = "center" }} }}]
            analysis = {{ kind = "dynamics", duration = 2, step = {}, scheme = {scheme} }}
            "#,
            2.0 / f64::from(steps)
        )
    };
    let motion = Motion { column: "mass.x", amplitude: 0.05, tolerance };
    motion.compare(steps, |k| solve(&model(steps[k])), |t| 1.0 + 0.05 * (20.0 * t).sin())
}

fn pendulum() -> Result<Findings, VerificationError> {
    let model = |steps: u32| {
        format!(
            r#"
            output.errors = true
            gravity = [0, -9.81, 0]
            bodies = [{{ kind = "rigid", name = "rod", center = [0.5, 0, 0], mass = 12,
                inertia = [1e-3, 1, 1] }}]
            joints = [{{ kind = "revolute", name = "hinge", a = {{ body = "rod", at = [0, 0, 0] }},
                axis = [0, 0, 1] }}]
            probes = [{{ name = "tip", on = {{ body = "rod", at = [1, 0, 0] }} }}]
            analysis = {{ kind = "dynamics", duration = 2, step = {},
                scheme = {{ spectral_radius = 0.8 }} }}
            "#,
            2.0 / f64::from(steps)
        )
    };
    // θ is the angle below the horizontal.
    let count = 20_000_u32;
    let h = 2.0 / f64::from(count);
    let rate = |[angle, speed]: [f64; 2]| [speed, 1.5 * 9.81 * f64::cos(angle)];
    let moved = |[a, b]: [f64; 2], [da, db]: [f64; 2], h: f64| [a + h * da, b + h * db];
    let (mut state, mut angles) = ([0.0; 2], vec![0.0]);
    for _ in 0..count {
        let first = rate(state);
        let second = rate(moved(state, first, 0.5 * h));
        let third = rate(moved(state, second, 0.5 * h));
        let fourth = rate(moved(state, third, h));
        let mean = |k: usize| (first[k] + 2.0 * second[k] + 2.0 * third[k] + fourth[k]) / 6.0;
        state = moved(state, [mean(0), mean(1)], h);
        angles.push(state[0]);
    }
    let steps = [100, 200, 400];
    let motion = Motion { column: "tip.y", amplitude: 1.0, tolerance: 1e-5 };
    motion.compare(&steps, |k| solve(&model(steps[k])), |t| -angles[(t / h).round() as usize].sin())
}

/// Roots of cos β cosh β = −1.
const ROOTS: [f64; 4] =
    [1.875_104_068_711_961, 4.694_091_132_974_174, 7.854_757_438_237_613, 10.995_540_734_875_467];
/// Mass per length with E I = 1 and L = 1, and the gravity.
const MASS: f64 = 1e-3;
const GRAVITY: f64 = 1.0;

/// Deflection of the tip of a dropped cantilever: Σ 2 σ/β (−1)ⁿ 2 g/ω² (1 − cos ωt), σ = (sinh β − sin β)/(cosh β + cos β).
fn deflection(t: f64) -> f64 {
    let of_mode = |n: usize| {
        let beta = ROOTS.get(n).copied().unwrap_or((n as f64 + 0.5) * std::f64::consts::PI);
        let part = if beta < 30.0 { (beta.sinh() - beta.sin()) / (beta.cosh() + beta.cos()) } else { 1.0 };
        let (omega, sign) = (beta * beta / MASS.sqrt(), if n.is_multiple_of(2) { 1.0 } else { -1.0 });
        4.0 * part / beta * sign * GRAVITY / (omega * omega) * (1.0 - (omega * t).cos())
    };
    (0..40).map(of_mode).sum()
}

/// Solves with numbers of elements and steps, the levels of which are the steps or the elements.
fn dropped(
    formulation: &str,
    levels: &[(u32, u32)],
    is_by_steps: bool,
    tolerance: f64,
) -> Result<Findings, VerificationError> {
    // Four periods of the first mode.
    let duration = 4.0 * std::f64::consts::TAU * MASS.sqrt() / (ROOTS[0] * ROOTS[0]);
    let model = |(elements, steps): (u32, u32)| {
        format!(
            r#"
            output.errors = true
            gravity = [0, {gravity}, 0]
            materials.m = {{ density = 1000, young = 12e12, poisson = 0 }}
            sections.s = {{ kind = "rectangle", height = 1e-3, width = 1e-3 }}
            bodies = [{{ kind = "beam", name = "b", formulation = "{formulation}", from = [0, 0, 0],
                to = [1, 0, 0], elements = {elements}, section = "s", material = "m" }}]
            joints = [{{ kind = "clamp", name = "root", a = {{ body = "b", at = "start" }} }}]
            probes = [{{ name = "tip", on = {{ body = "b", at = "end" }} }}]
            analysis = {{ kind = "dynamics", duration = {duration}, step = {step},
                scheme = {{ spectral_radius = 0.8 }} }}
            "#,
            gravity = -GRAVITY,
            step = duration / f64::from(steps)
        )
    };
    let numbers: Vec<u32> =
        levels.iter().map(|(elements, steps)| if is_by_steps { *steps } else { *elements }).collect();
    let motion = Motion { column: "tip.y", amplitude: 2.0 * MASS * GRAVITY / 8.0, tolerance };
    motion.compare(&numbers, |k| solve(&model(levels[k])), |t| -deflection(t))
}

fn spin_up() -> Result<Findings, VerificationError> {
    let model = |steps: u32, elements: u32, has_errors: bool| {
        format!(
            r#"
            output = {{ errors = {has_errors}, interval = 0.08 }}
            materials.m = {{ density = 1.2, young = 2.8e7 }}
            sections.s = {{ kind = "general", area = 1, iy = 5e-4, iz = 5e-4, ky = 0.7142857142857143,
                kz = 0.7142857142857143 }}
            bodies = [{{ kind = "beam", name = "b", formulation = "linked", from = [0, 0, 0], to = [10, 0, 0],
                elements = {elements}, section = "s", material = "m" }}]
            joints = [{{ kind = "drive", name = "hub", a = {{ body = "b", at = "start" }}, axis = [0, 0, 1],
                time = {{ kind = "expression",
                    text = "0.4*(t^2/2 + (7.5/pi)^2*(cos(2*pi*t/15) - 1))" }} }}]
            probes = [{{ name = "tip", on = {{ body = "b", at = "end" }} }}]
            analysis = {{ kind = "dynamics", duration = 8, step = {},
                scheme = {{ spectral_radius = 0.8 }} }}
            "#,
            8.0 / f64::from(steps)
        )
    };
    let fine = solve(&model(6400, 12, false))?;
    let values = fine.column("tip.y")?.to_vec();
    let steps = [100, 200, 400];
    let motion = Motion { column: "tip.y", amplitude: 10.0, tolerance: 1e-4 };
    let exact = |t: f64| values[(t / 0.08).round() as usize];
    motion.compare(&steps, |k| solve(&model(steps[k], 6, true)), exact)
}

#[cfg(test)]
mod tests {
    #[test]
    fn problems_hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }

    /// The modes add up to the static deflection, p L⁴/8EI, as the mean over time.
    #[test]
    fn the_series_has_the_static_deflection() {
        let mean: f64 = (0..20_000).map(|k| super::deflection(f64::from(k) * 1e-3)).sum::<f64>() / 20_000.0;
        assert!((mean / (super::MASS * super::GRAVITY / 8.0) - 1.0).abs() < 1e-2, "{mean}");
    }
}
