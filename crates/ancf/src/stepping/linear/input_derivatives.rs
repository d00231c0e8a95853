use nalgebra::DVector;

/// Steps of the differences, relative to the larger of the input and 1: 1, 1/4, ... down to 4e-9.
const LEVELS: usize = 15;
const RATIO: f64 = 0.25;
/// Largest change of a derivative between two steps, relative to its largest value.
const DEVIATION: f64 = 1e-3;
/// Multiple of the rounding errors that a difference may have.
const ROUNDING: f64 = 8.0;

/// Differences of one component over all steps.
struct Differences {
    steps: Vec<f64>,
    forward: Vec<f64>,
    backward: Vec<f64>,
    /// Bound of the rounding errors of a value.
    rounding: f64,
}

/// Returns the derivatives of functions of an input at the value `u`, or the number of a component without one.
///
/// `of` computes the functions at u + h, and `rounding` states their rounding errors, given their values at u. If these are strict bounds,
/// kinks are found (`has_bounds`). The functions may depend on the input in any way, at any scale: of central differences with steps from 4e-9 to 1, extrapolated to zero, each component takes the
/// one that differs least from that of the next smaller step. The steps increase as long as the differences agree better.
pub(super) fn input_derivatives(
    u: f64,
    mut of: impl FnMut(f64) -> DVector<f64>,
    (rounding, has_bounds): (impl Fn(&DVector<f64>) -> DVector<f64>, bool),
) -> Result<DVector<f64>, usize> {
    let (centre, size) = (of(0.0), u.abs().max(1.0));
    let bounds = rounding(&centre);
    // A step that the floating-point input resolves.
    let steps = (0..LEVELS).rev().map(|k| (u + size * RATIO.powi(k as i32)) - u);
    let values: Vec<_> = steps.map(|h| (h, of(h), of(-h))).collect();
    let component = |i: usize| {
        // Functions may be undefined at larger steps.
        let is_finite = |at: &&(f64, DVector<f64>, DVector<f64>)| at.1[i].is_finite() && at.2[i].is_finite();
        let mut differences =
            Differences { steps: Vec::new(), forward: Vec::new(), backward: Vec::new(), rounding: bounds[i] };
        for (h, after, before) in values.iter().take_while(is_finite) {
            differences.steps.push(*h);
            differences.forward.push((after[i] - centre[i]) / h);
            differences.backward.push((centre[i] - before[i]) / h);
        }
        differences.derivative(has_bounds).ok_or(i)
    };
    let derivatives = (0..centre.len()).map(component).collect::<Result<Vec<_>, _>>()?;
    Ok(DVector::from_vec(derivatives))
}

impl Differences {
    fn central(&self, level: usize) -> f64 {
        0.5 * (self.forward[level] + self.backward[level])
    }

    /// Returns the rounding error of the difference with a step and the next smaller one.
    fn noise(&self, level: usize) -> f64 {
        ROUNDING * self.rounding / self.steps[level - 1]
    }

    /// Returns the derivative; `None` if the differences do not converge, or have two limits.
    fn derivative(&self, has_bounds: bool) -> Option<f64> {
        let levels = self.steps.len();
        let largest = (0..levels).map(|k| self.central(k).abs()).fold(0.0, f64::max);
        let change = |k: usize| (self.central(k) - self.central(k - 1)).abs();
        let error = |k: usize| change(k) + self.noise(k);
        let mut best = (levels > 1).then_some(1)?;
        let mut worse = 0;
        for k in 2..levels {
            if error(k) <= error(best) {
                (best, worse) = (k, 0);
            } else {
                worse += 1;
            }
            if worse == 2 {
                break;
            }
        }
        let is_limit = change(best) <= DEVIATION * largest + self.noise(best);
        (is_limit && !(has_bounds && self.has_kink(largest)))
            .then(|| self.central(best - 1) + (self.central(best - 1) - self.central(best)) / 15.0)
    }

    /// Returns true if the one-sided differences have two limits: they differ by as much with the next smaller step.
    fn has_kink(&self, largest: f64) -> bool {
        let gap = |k: usize| (self.forward[k] - self.backward[k]).abs();
        let one_sided = self.forward.iter().chain(&self.backward).fold(largest, |a, b| a.max(b.abs()));
        let resolved = |k: &usize| 4.0 * self.noise(*k) <= 0.1 * DEVIATION * one_sided;
        let Some(k) = (1..self.steps.len()).find(resolved) else { return false };
        gap(k - 1) > DEVIATION * one_sided && gap(k - 1) > 0.5 * gap(k)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn derivative(u: f64, f: impl Fn(f64) -> f64) -> Result<f64, usize> {
        let of = |h: f64| DVector::from_element(1, f(u + h));
        let rounding = |f: &DVector<f64>| f.map(|f| f64::EPSILON * f.abs());
        input_derivatives(u, of, (rounding, true)).map(|derivatives| derivatives[0])
    }

    /// Derivatives of smooth functions at any scale of the input, also near the ends of their domains.
    #[test]
    fn derivatives_of_smooth_functions() {
        let check = |u: f64, f: &dyn Fn(f64) -> f64, exact: f64, tolerance: f64| {
            let found = derivative(u, f).unwrap();
            assert!((found - exact).abs() <= tolerance * exact.abs().max(1e-6), "{u}: {found} for {exact}");
        };
        check(0.5, &|u| u * u * u, 0.75, 1e-9);
        check(0.02, &|u| u * u * u, 0.0012, 1e-8);
        check(0.5, &f64::exp, 0.5_f64.exp(), 1e-9);
        check(0.02, &f64::sin, 0.02_f64.cos(), 1e-9);
        check(0.5, &|u| 1e3 + 2.0 * u.sqrt(), 2.0_f64.sqrt(), 1e-6);
        check(0.02, &|u| 100.0 * (u / 0.01).tanh(), 1e4 / 2.0_f64.cosh().powi(2), 1e-7);
        check(0.05, &|u| 24.0 * u * u.abs(), 2.4, 1e-8);
        check(-3e6, &|u| 2.0 * u + 1e7, 2.0, 1e-12);
        check(0.0, &|u| u * u.abs(), 0.0, 1e-1);
        check(
            0.3,
            &|u| (std::f64::consts::TAU * u).sin(),
            std::f64::consts::TAU * (0.6 * std::f64::consts::PI).cos(),
            1e-8,
        );
        check(0.0, &|u| 1e12 + 0.0 * u, 0.0, 1e-12);
        check(0.0, &|u| 1e6 + 1e-3 * u, 1e-3, 1e-5);
    }

    /// Kinks, jumps and ends of the domain have no derivative.
    #[test]
    fn kinks_have_no_derivative() {
        assert_eq!(derivative(0.0, f64::abs), Err(0));
        assert_eq!(derivative(0.0, |u| u.max(0.0)), Err(0));
        assert_eq!(derivative(2.0, |u| 5.0 + (u - 2.0).abs() + u), Err(0));
        assert_eq!(derivative(0.0, f64::sqrt), Err(0));
        assert_eq!(derivative(0.0, f64::signum), Err(0));
    }
}
