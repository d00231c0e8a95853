use ancf_solver::equations::{EquationsOfMotion, State};

/// Displacement of a shape, in solver units.
const DIFFERENCE: f64 = 1e-6;
/// Jump of the slope of a force, relative to the largest slope, above which a force has a kink.
const JUMP: f64 = 1e-3;
/// Multiple of the rounding errors of a residual that a second difference may have.
const ROUNDING: f64 = 16.0;

/// Returns true if forces have a kink in a state: their slopes along a shape differ in both directions.
///
/// The second difference over the step h is then proportional to h, and that of smooth forces to h².
pub(super) fn has_kink(system: &dyn EquationsOfMotion, s: &State, shape: &[f64]) -> bool {
    let (n, largest) = (s.q.len(), shape.iter().fold(0.0_f64, |largest, x| largest.max(x.abs())));
    if largest == 0.0 {
        return false;
    }
    let size = n + s.lambda.len();
    let moved = |h: f64| {
        let mut there = s.clone();
        there.q.iter_mut().zip(shape).for_each(|(q, x)| *q += h * x);
        there
    };
    let residual = |h: f64| {
        let mut r = vec![0.0; size];
        system.residual(&moved(h), &mut r);
        r
    };
    let (h, centre) = (DIFFERENCE / largest, residual(0.0));
    let [[after, before], [nearer, behind]] = [h, 0.25 * h].map(|h| [residual(h), residual(-h)]);
    let mut floor = vec![0.0; size];
    system.rounding(&moved(h), &mut floor);
    let slope = (0..n).map(|i| (after[i] - before[i]).abs()).fold(0.0, f64::max) / 8.0;
    (0..n).any(|i| {
        let [far, near] =
            [(&after, &before), (&nearer, &behind)].map(|(a, b)| (a[i] - centre[i]) + (b[i] - centre[i]));
        let limit = JUMP * slope.max(near.abs()) + ROUNDING * floor[i];
        near.abs() > limit && near.abs() > 0.5 * 0.25 * far.abs()
    })
}
