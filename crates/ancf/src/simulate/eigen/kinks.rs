use ancf_solver::equations::{EquationsOfMotion, State};

/// Displacement of a shape, in solver units.
const DIFFERENCE: f64 = 1e-6;
/// Jump of the slope of a force, relative to the largest slope, above which a force has a kink.
const JUMP: f64 = 1e-3;
/// Multiple of the rounding errors of a residual that a second difference may have.
const ROUNDING: f64 = 16.0;

/// Search for kinks of the forces in a state.
pub(crate) struct Kinks<'a> {
    system: &'a dyn EquationsOfMotion,
    s: &'a State,
    /// Residual in the state.
    centre: Vec<f64>,
}

impl<'a> Kinks<'a> {
    pub(crate) fn new(system: &'a dyn EquationsOfMotion, s: &'a State) -> Self {
        Self { system, s, centre: residual(system, s) }
    }

    /// Returns true if forces have a kink along a shape: their slopes differ in both directions.
    ///
    /// The second difference over the step h is then proportional to h, and that of smooth forces to h².
    pub(crate) fn has_kink(&self, shape: &[f64]) -> bool {
        let Self { system, s, centre } = self;
        let largest = shape.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        if largest == 0.0 {
            return false;
        }
        let n = s.q.len();
        let moved = |h: f64| {
            let mut there = (*s).clone();
            there.q.iter_mut().zip(shape).for_each(|(q, x)| *q += h * x);
            there
        };
        let pair = |h: f64| [h, -h].map(|h| residual(*system, &moved(h)));
        let second =
            |[after, before]: &[Vec<f64>; 2], i: usize| (after[i] - centre[i]) + (before[i] - centre[i]);
        let h = DIFFERENCE / largest;
        let near = pair(0.25 * h);
        let slope = (0..n).map(|i| (near[0][i] - near[1][i]).abs()).fold(0.0, f64::max) / 2.0;
        let is_bent = |i: &usize| second(&near, *i).abs() > JUMP * slope;
        if !(0..n).any(|i| is_bent(&i)) {
            return false;
        }
        let (far, mut floor) = (pair(h), vec![0.0; centre.len()]);
        system.rounding(&moved(h), &mut floor);
        (0..n).filter(is_bent).any(|i| {
            let (near, far) = (second(&near, i).abs(), second(&far, i).abs());
            near > JUMP * slope + ROUNDING * floor[i] && near > 0.5 * 0.25 * far
        })
    }
}

fn residual(system: &dyn EquationsOfMotion, s: &State) -> Vec<f64> {
    let mut r = vec![0.0; s.q.len() + s.lambda.len()];
    system.residual(s, &mut r);
    r
}
