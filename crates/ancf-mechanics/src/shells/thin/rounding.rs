//! Bounds of the rounding errors of the forces of a shell element.

use super::bent_points::VOIGT;
use super::hermite::{Shape, VECTORS};
use super::profile::ShellProfile;
use super::surface_state::{ShellStrains, SurfaceState};
use super::tables::{MEMBRANE, MembraneSample, POINTS, ShellTables};

/// Roundings in a sum of sixteen products, relative to the sum of their magnitudes.
const SUM: f64 = 4.0 * f64::EPSILON;

fn size(shape: &Shape, x: &Shape) -> f64 {
    shape.iter().zip(x).map(|(shape, x)| shape.abs() * x).sum()
}

/// Errors of the stresses of an element, without those of their own rounding.
struct Errors {
    membrane: [f64; MEMBRANE],
    bending: [[f64; 3]; POINTS],
}

/// Adds the bounds for an element with displacements and velocities of the given magnitudes.
pub(crate) fn add_rounding(
    tables: &ShellTables,
    profile: &ShellProfile,
    [q, v]: [&Shape; 2],
    (state, stress): (&SurfaceState, &ShellStrains),
    bound: &mut Shape,
) {
    let time = profile.medium.retardation;
    let mut of = Errors { membrane: [0.0; MEMBRANE], bending: [[0.0; 3]; POINTS] };
    for (t, reference) in profile.samples.iter().enumerate() {
        let MembraneSample { component, shapes, .. } = &tables.samples[t];
        let [u, w] = shapes.each_ref().map(|shape| size(shape, q));
        let [x, y] = shapes.each_ref().map(|shape| time * size(shape, v));
        let [a, b] = [reference[0].norm() + u, reference[1].norm() + w];
        of.membrane[t] = SUM
            * match component {
                0 => a * (u + x),
                1 => b * (w + y),
                _ => a * (w + y) + b * (u + x),
            };
    }
    for k in 0..POINTS {
        let (point, shapes, reference) =
            (state.points.at(k), &tables.points[k], profile.points.at(k).reference);
        let sizes = shapes.each_ref().map(|shape| size(&shape.0, q));
        let rates = shapes.each_ref().map(|shape| time * size(&shape.0, v));
        let dual = point.dual.map(|a| a.norm());
        let turned = sizes[0] * dual[0] + sizes[1] * dual[1];
        for i in 0..3 {
            let second = reference[i + 2].norm() + sizes[i + 2];
            let rate = rates[i + 2] + second * (rates[0] * dual[0] + rates[1] * dual[1]);
            of.bending[k][i] = VOIGT[i] * SUM * (1.0 + turned) * (sizes[i + 2] + second * turned + rate);
        }
    }
    let of_stress = Errors {
        membrane: membrane_errors(tables, profile, &state.strains, &of),
        bending: bending_errors(tables, profile, &state.strains, &of),
    };
    distribute(tables, profile, (state, stress), &of_stress, bound, q);
}

/// Adds the bounds of the forces of constant stresses.
pub(crate) fn add_stress_rounding(
    tables: &ShellTables,
    profile: &ShellProfile,
    q: &Shape,
    (state, stress): (&SurfaceState, &ShellStrains),
    bound: &mut Shape,
) {
    let none = Errors { membrane: [0.0; MEMBRANE], bending: [[0.0; 3]; POINTS] };
    distribute(tables, profile, (state, stress), &none, bound, q);
}

/// Errors of the membrane stresses of strains with errors.
fn membrane_errors(
    tables: &ShellTables,
    profile: &ShellProfile,
    strains: &ShellStrains,
    of: &Errors,
) -> [f64; MEMBRANE] {
    let mut error = [0.0; MEMBRANE];
    for (k, sampling) in tables.sampling.iter().enumerate() {
        let mut at_point = [0.0; 3];
        for (t, strain) in strains.membrane.iter().enumerate() {
            at_point[tables.samples[t].component] +=
                sampling[t].abs() * (of.membrane[t] + SUM * strain.abs());
        }
        let stiffness = profile.points.membrane(k);
        for (t, error) in error.iter_mut().enumerate() {
            let i = tables.samples[t].component;
            let force: f64 = (0..3).map(|j| stiffness[(i, j)].abs() * at_point[j]).sum();
            *error += sampling[t].abs() * force;
        }
    }
    for (k, coupling) in profile.coupling.iter().enumerate() {
        let bent = strains.bending(k);
        for (r, error) in error.iter_mut().enumerate() {
            let of = |j: usize| {
                let i = tables.samples[r].component;
                coupling[(i, j)].abs() * (of.bending[k][j] + SUM * bent[j].abs())
            };
            *error += tables.sampling[k][r].abs() * (0..3).map(of).sum::<f64>();
        }
    }
    error
}

/// Errors of the moments of strains with errors.
fn bending_errors(
    tables: &ShellTables,
    profile: &ShellProfile,
    strains: &ShellStrains,
    of: &Errors,
) -> [[f64; 3]; POINTS] {
    std::array::from_fn(|k| {
        let (bending, curvature) = (profile.points.bending(k), strains.bending(k));
        std::array::from_fn(|i| {
            let bent = |j: usize| bending[(i, j)].abs() * (of.bending[k][j] + SUM * curvature[j].abs());
            let mut error: f64 = (0..3).map(bent).sum();
            if let Some(coupling) = profile.coupling.get(k) {
                for (r, strain) in strains.membrane.iter().enumerate() {
                    error += tables.sampling[k][r].abs()
                        * coupling[(tables.samples[r].component, i)].abs()
                        * (of.membrane[r] + SUM * strain.abs());
                }
            }
            error
        })
    })
}

/// Adds the bounds of the forces of stresses with errors.
fn distribute(
    tables: &ShellTables,
    profile: &ShellProfile,
    (state, stress): (&SurfaceState, &ShellStrains),
    errors: &Errors,
    bound: &mut Shape,
    q: &Shape,
) {
    for (t, MembraneSample { component, shapes: [x, y], .. }) in tables.samples.iter().enumerate() {
        let [u, w] = [x, y].map(|shape| size(shape, q));
        let [a, b] = [profile.samples[t][0].norm() + u, profile.samples[t][1].norm() + w];
        let of = errors.membrane[t] + SUM * stress.membrane[t].abs();
        for i in 0..VECTORS {
            let (x, y) = (x[i].abs(), y[i].abs());
            bound[i] += of
                * match component {
                    0 => x * a,
                    1 => y * b,
                    _ => y * a + x * b,
                };
        }
    }
    for k in 0..POINTS {
        let (point, shapes, reference) =
            (state.points.at(k), &tables.points[k], profile.points.at(k).reference);
        let sizes = shapes.each_ref().map(|shape| size(&shape.0, q));
        let dual = point.dual.map(|a| a.norm());
        let amplified = 1.0 + sizes[0] * dual[0] + sizes[1] * dual[1];
        for i in 0..3 {
            let error = VOIGT[i] * (errors.bending[k][i] + SUM * amplified * stress.bending(k)[i].abs());
            let second = reference[i + 2].norm() + sizes[i + 2];
            for a in 0..VECTORS {
                let tangential = dual[0] * shapes[0].0[a].abs() + dual[1] * shapes[1].0[a].abs();
                bound[a] += error * (shapes[i + 2].0[a].abs() + second * tangential);
            }
        }
    }
}
