//! Free flight of a flexible plate, and a stiff sheet that falls through a fluid.

use super::model::{Element, Sheet};
use crate::reference::runge_kutta;
use crate::{Findings, Plot, PlotCurve, Problem, SolvedModel, VerificationError, solve};

/// Problems of this file.
pub(super) const PROBLEMS: &[Problem] = &[
    Problem {
        name: "flying_plate",
        title: "Flexible plate in free flight",
        source: "Conservation of momentum, angular momentum and energy. At the start p = m v and L = J ω with J = m/12 (b² + h², \
                 a² + h², a² + b²), without h² for a thin shell",
        sketch: r"
      +-------+  ω     0.6 × 0.4 × 0.01 m, E = 1e6, ρ = 1000, ν = 0.3
      |   +-->|  v     v = (1.2, -1.7, 1), ω = (6, 2, 4)
      +-------+",
        goal: "Values at the start within 1e-13. Energy-momentum scheme: changes of momentum, angular momentum and energy below 1e-11 in \
               100 steps of 0.06 rad. Generalized-α with steps of a quarter of the size: change of the momentum below 1e-11, of the angular \
               momentum below 1e-3, of second order in the step",
        run: flight,
    },
    Problem {
        name: "falling_sheet",
        title: "Stiff sheet that turns over and glides in a fluid: load `surface_fluid`",
        source: "Rigid plate under the same forces per area, by a Runge-Kutta integration of its plane motion with the midpoint rule over \
                 the width: ½ρ_f (C_n |w_n| + C_l |w_t|) w_n along the normal, ½ρ_f C_t |w_t| w_t along the chord, added mass ρ_f a, \
                 buoyancy",
        sketch: r"
        ω_.-'          b = 0.2 m, h = 4 mm, ρ = 1200, ρ_f = 15 kg/m³, C_n = 1.6, C_t = 0.03,
       .-' -> v        C_l = 2, a = 0.1 m; at the start 0.4 rad, -12 rad/s and 1 m/s",
        goal: "Path of the middle over 6 m within 1 mm and angle over 2.2 rad within 5e-4, 480 steps of the energy-momentum scheme with \
               4 thin and 8 shear-deformable elements. Second order in the step",
        run: falling,
    },
];

/// Sum of squares, as a length.
fn norm(vector: [f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Returns three columns of a vector.
fn vectors(solved: &SolvedModel, name: &str) -> Result<Vec<[f64; 3]>, VerificationError> {
    let [x, y, z] = ["x", "y", "z"].map(|axis| solved.column(&format!("{name}{axis}")));
    Ok(x?.iter().zip(y?).zip(z?).map(|((x, y), z)| [*x, *y, *z]).collect())
}

/// Largest change of a vector, relative to its size at the start.
fn change(solved: &SolvedModel, name: &str) -> Result<f64, VerificationError> {
    let rows = vectors(solved, name)?;
    let from = |row: &[f64; 3]| norm(std::array::from_fn(|i| row[i] - rows[0][i]));
    Ok(rows.iter().map(from).fold(0.0, f64::max) / norm(rows[0]))
}

/// Largest change of the energy, relative to that at the start.
fn energy_change(solved: &SolvedModel) -> Result<f64, VerificationError> {
    let [kinetic, strain] = [solved.column("kinetic")?, solved.column("strain")?];
    let changes = kinetic.iter().zip(strain).map(|(k, u)| ((k + u) / kinetic[0] - 1.0).abs());
    Ok(changes.fold(0.0, f64::max))
}

const SIZES: [f64; 3] = [0.6, 0.4, 0.01];
const VELOCITY: [f64; 3] = [1.2, -1.7, 1.0];
const SPIN: [f64; 3] = [6.0, 2.0, 4.0];

/// Flight of one second in a number of steps.
fn fly(element: Element, scheme: &str, steps: u32) -> Result<SolvedModel, VerificationError> {
    let [a, b, h] = SIZES;
    let sheet = Sheet {
        element,
        corner: [-0.5 * a, -0.5 * b, 0.0],
        sides: [[a, 0.0, 0.0], [0.0, b, 0.0]],
        elements: [3, 2],
        thickness: h,
        material: "young = 1e6, poisson = 0.3, density = 1000".into(),
        keys: format!("motion = {{ velocity = {VELOCITY:?}, spin = {SPIN:?}, about = [0, 0, 0] }}\n"),
    };
    solve(&format!(
        "output.momentum = true\n{}[analysis]\nkind = \"dynamics\"\nduration = 1\nstep = {:?}\nscheme = {scheme}\n",
        sheet.body(),
        1.0 / f64::from(steps)
    ))
}

fn flight() -> Result<Findings, VerificationError> {
    let ([a, b, h], mut found, mut curves) = (SIZES, Findings::default(), Vec::new());
    let mass = a * b * h * 1000.0;
    for (element, rotary) in [(Element::Thin, 0.0), (Element::Shear, h * h)] {
        let name = element.name();
        let solved = fly(element, "\"energy\"", 100)?;
        let inertia = [b * b + rotary, a * a + rotary, a * a + b * b].map(|sum| mass / 12.0 * sum);
        let momentum = VELOCITY.map(|v| mass * v);
        let spin: [f64; 3] = std::array::from_fn(|i| inertia[i] * SPIN[i]);
        for (quantity, exact) in [("p", momentum), ("l", spin)] {
            let start = vectors(&solved, quantity)?[0];
            for (axis, (ours, exact)) in ["x", "y", "z"].into_iter().zip(start.into_iter().zip(exact)) {
                found.compare(format!("{quantity}{axis} at the start, {name}"), ours, exact, exact, 1e-13);
            }
        }
        for (what, change) in [
            ("momentum", change(&solved, "p")?),
            ("angular momentum", change(&solved, "l")?),
            ("energy", energy_change(&solved)?),
        ] {
            found.compare(format!("change of {what}, {name}"), change, 0.0, 1.0, 1e-11);
        }
        let [coarse, fine] = [200, 400].map(|steps| fly(element, "{ spectral_radius = 0.8 }", steps));
        let [coarse, fine] = [coarse?, fine?];
        found.compare(
            format!("change of momentum, generalized-α, {name}"),
            change(&fine, "p")?,
            0.0,
            1.0,
            1e-11,
        );
        let [rough, change] = [change(&coarse, "l")?, change(&fine, "l")?];
        found.compare(format!("change of angular momentum, generalized-α, {name}"), change, 0.0, 1.0, 1e-3);
        found.compare(format!("its order, {name}"), (rough / change).log2(), 2.0, 1.0, 0.25);
        curves.push(PlotCurve::line(format!("strain energy, {name}"), solved.points("t", "strain")?));
    }
    found.plot(Plot::new("Vibrations of the plate", ["t, s", "strain energy, J"], curves));
    Ok(found)
}

const WIDTH: f64 = 0.2;
const THICKNESS: f64 = 0.004;
const DENSITY: f64 = 1200.0;
const FLUID: f64 = 15.0;
const DRAG: [f64; 2] = [1.6, 0.03];
const LIFT: f64 = 2.0;
const ADDED: f64 = 0.1;
const GRAVITY: f64 = 9.81;
/// Position x and z of the middle, angle, and their rates.
const START: [f64; 6] = [0.0, 0.0, 0.4, 1.0, 0.0, -12.0];
const DURATION: f64 = 1.2;

/// Rates of the state of a rigid plate, per unit length; `rotary` is the square of the thickness in its moment of inertia.
fn rates([_, _, angle, vx, vz, spin]: &[f64; 6], rotary: f64) -> [f64; 6] {
    const POINTS: u32 = 400;
    let (sin, cos) = angle.sin_cos();
    let [along, across] = [-(vx * cos + vz * sin), -(vz * cos - vx * sin)];
    let (mut normal, mut moment) = (0.0, 0.0);
    for k in 0..POINTS {
        let arm = WIDTH * ((f64::from(k) + 0.5) / f64::from(POINTS) - 0.5);
        let across = across - spin * arm;
        let force =
            0.5 * FLUID * (DRAG[0] * across.abs() + LIFT * along.abs()) * across * WIDTH / f64::from(POINTS);
        normal += force;
        moment += arm * force;
    }
    let tangential = 0.5 * FLUID * DRAG[1] * along.abs() * along * WIDTH;
    let weight = (DENSITY - FLUID) * THICKNESS * WIDTH * GRAVITY;
    let [mass, added] = [DENSITY * THICKNESS * WIDTH, FLUID * ADDED * WIDTH];
    let across = (normal - weight * cos) / (mass + added);
    let along = (tangential - weight * sin) / mass;
    let inertia = (mass * (WIDTH * WIDTH + rotary) + added * WIDTH * WIDTH) / 12.0;
    [*vx, *vz, *spin, along * cos - across * sin, along * sin + across * cos, moment / inertia]
}

/// Largest deviations of the middle and of the angle from the rigid plate, its path and that of the sheet.
type Fall = ([f64; 2], [Vec<[f64; 2]>; 2]);

fn fall(element: Element, steps: u32) -> Result<Fall, VerificationError> {
    let (sin, cos) = START[2].sin_cos();
    let side = [WIDTH * cos, 0.0, WIDTH * sin];
    let elements = if element == Element::Thin { 4 } else { 8 };
    let sheet = Sheet {
        element,
        corner: side.map(|x| -0.5 * x),
        sides: [side, [0.0, 0.1, 0.0]],
        elements: [elements, 1],
        thickness: THICKNESS,
        material: format!("young = 1e10, density = {DENSITY:?}"),
        keys: format!(
            "motion = {{ velocity = [{:?}, 0, {:?}], spin = [0, {:?}, 0], about = [0, 0, 0] }}\n",
            START[3], START[4], -START[5]
        ),
    };
    let solved = solve(&format!(
        "gravity = [0, 0, {:?}]\n{}{}{}[[loads]]\nkind = \"surface_fluid\"\nbody = \"s\"\ndensity = {FLUID:?}\n\
         drag = {DRAG:?}\nlift = {LIFT:?}\nadded_mass = {ADDED:?}\n\
         [analysis]\nkind = \"dynamics\"\nduration = {DURATION:?}\nstep = {:?}\nscheme = \"energy\"\n",
        -GRAVITY,
        sheet.body(),
        sheet.probe("a", [0, 0]),
        sheet.probe("b", [1, 0]),
        DURATION / f64::from(steps)
    ))?;
    let rotary = if element == Element::Thin { 0.0 } else { THICKNESS * THICKNESS };
    let (mut exact, mut time) = (START, 0.0);
    let (mut errors, mut paths) = ([0.0_f64; 2], [Vec::new(), Vec::new()]);
    let ends = vectors(&solved, "a.")?.into_iter().zip(vectors(&solved, "b.")?);
    for (t, (a, b)) in solved.column("t")?.iter().zip(ends) {
        if *t > time {
            exact = runge_kutta(|_, state| rates(state, rotary), exact, t - time, 4);
            time = *t;
        }
        let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[2] + b[2])];
        // The angle between the chord and that of the rigid plate.
        let (sin, cos) = exact[2].sin_cos();
        let [x, z] = [b[0] - a[0], b[2] - a[2]];
        let turned = (z * cos - x * sin).atan2(x * cos + z * sin);
        errors[0] = errors[0].max((middle[0] - exact[0]).hypot(middle[1] - exact[1]));
        errors[1] = errors[1].max(turned.abs());
        paths[0].push(middle);
        paths[1].push([exact[0], exact[1]]);
    }
    Ok((errors, paths))
}

fn falling() -> Result<Findings, VerificationError> {
    let (mut found, mut curves) = (Findings::default(), Vec::new());
    for element in [Element::Thin, Element::Shear] {
        let name = element.name();
        let [(coarse, _), (errors, [path, exact])] = [fall(element, 240)?, fall(element, 480)?];
        found.compare(format!("largest deviation of the middle, m, {name}"), errors[0], 0.0, 1.0, 1e-3);
        found.compare(format!("largest deviation of the angle, {name}"), errors[1], 0.0, 1.0, 5e-4);
        found.compare(
            format!("order of the deviation, {name}"),
            (coarse[0] / errors[0]).log2(),
            2.0,
            1.0,
            0.25,
        );
        curves.push(PlotCurve::line(name, path));
        if element == Element::Shear {
            curves.push(PlotCurve::points("rigid plate", exact.into_iter().step_by(16).collect()));
        }
    }
    found.plot(Plot::new("Path of the middle", ["x, m", "z, m"], curves).with_equal_scales());
    Ok(found)
}

#[cfg(test)]
mod tests {
    #[test]
    fn hold() {
        crate::assert_all_hold(super::PROBLEMS);
    }
}
