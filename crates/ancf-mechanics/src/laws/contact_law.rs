use nalgebra::{Matrix3, Vector3};

use crate::kinematics::Real;

/// Contact law: forces per length of beam or per area of shell as a function of the gap g and the relative velocity w.
///
/// The pressure follows from a potential U(d) of the penetration depth d = −g, zero for d ≤ 0:
///
/// p = U′ = k d²/(2δ) for d ≤ δ,  k (d − δ/2) beyond.
///
/// The normal force is N = p h with the damping factor h = √(1 + x²) − x, x = c ġ. The factor is 1 at rest, smaller
/// during separation and larger during approach. It is positive, so N is never tensile and damping only dissipates
/// energy. For small c ġ it is p (1 − c ġ) (Hunt & Crossley 1975), and for fast approach twice that.
///
/// Friction is a smoothed Coulomb law: −μ N w_t/√(w_t² + v₀²) with the tangential sliding velocity w_t. Below v₀ it is
/// viscous, so sticking is approximated by creep with v₀ T/√(μ²N² − T²) under a force T.
///
/// Tangents treat N in the friction force as constant, so that ∂f_t/∂v is symmetric. The omitted part −μ t ∂N/∂q is not
/// symmetric. It maps errors in the normal direction to the tangential direction only. Its symmetric part would also
/// map them back. Newton's method converges linearly where bodies slide.
///
/// Units: k force/length², of shells force/length³, δ length, c time/length, v₀ length/time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactLaw {
    /// Stiffness k, pressure per depth.
    pub stiffness: f64,
    /// Depth δ over which the stiffness increases from zero.
    pub transition: f64,
    /// Damping c.
    pub damping: f64,
    /// Friction coefficient μ.
    pub friction: f64,
    /// Sliding velocity v₀ at which friction reaches 1/√2 of its limit.
    pub slip_speed: f64,
}

/// Multiple of the rounding errors of energies and gaps below which the work of a step is that of the force in its middle.
const DISCRETE_ROUNDING: f64 = 8.0;

impl ContactLaw {
    /// Returns the potential U at a gap.
    pub fn energy(&self, gap: f64) -> f64 {
        let (k, delta, depth) = (self.stiffness, self.transition, -gap);
        match depth {
            d if d <= 0.0 => 0.0,
            d if d < delta => k * d.powi(3) / (6.0 * delta),
            d => k * (0.5 * d * (d - delta) + delta * delta / 6.0),
        }
    }

    /// Returns the pressure p at a gap.
    pub fn pressure<D: Real>(&self, gap: D) -> D {
        let (k, delta, depth) = (self.stiffness, self.transition, -gap);
        match depth.re() {
            d if d <= 0.0 => D::from(0.0),
            d if d < delta => depth * depth * (0.5 * k / delta),
            _ => (depth - 0.5 * delta) * k,
        }
    }

    /// Returns the excess of the normal force −ΔU/Δg of a step between two energies over that of its middle, for a change of the gap
    /// along the normal of the middle.
    ///
    /// `forces` are the forces at the start, in the middle and at the end. The normal force is at most twice the largest one.
    /// The limit applies to grazing motion only, where the direction of the normal changes more than the gap. The excess is zero if its
    /// work is a rounding error, as at rest; `size` are the lengths whose rounding errors the gap has.
    pub(crate) fn discrete_excess([before, now]: [f64; 2], moved: f64, forces: [f64; 3], size: f64) -> f64 {
        let largest = forces.into_iter().fold(0.0, f64::max);
        let work = (before - now) - forces[1] * moved;
        if work.abs() <= DISCRETE_ROUNDING * f64::EPSILON * (before + now + largest * size) {
            return 0.0;
        }
        ((before - now) / moved).clamp(0.0, 2.0 * largest) - forces[1]
    }

    /// Returns dp/d(depth), at most k.
    pub fn slope(&self, gap: f64) -> f64 {
        (-gap / self.transition).clamp(0.0, 1.0) * self.stiffness
    }

    /// Returns the normal force N at a gap and its rate.
    pub fn normal<D: Real>(&self, gap: D, rate: D) -> D {
        self.pressure(gap) * damping_factor(rate * self.damping)
    }

    /// Returns the friction force of a normal force N on the body with the given relative velocity.
    pub fn tangential<D: Real>(
        &self,
        normal: D,
        direction: &Vector3<D>,
        velocity: &Vector3<D>,
    ) -> Vector3<D> {
        if self.friction == 0.0 {
            return Vector3::from_element(D::from(0.0));
        }
        let along = direction.dot(velocity);
        let sliding = velocity - direction.map(|x| x * along);
        let factor = -(normal * self.friction) / (sliding.dot(&sliding) + self.slip_speed.powi(2)).sqrt();
        sliding.map(|x| x * factor)
    }

    /// Returns true if forces depend on velocities.
    pub(crate) fn is_damped(&self) -> bool {
        self.damping != 0.0 || self.friction != 0.0
    }

    /// Returns the force N n + friction at a gap, for the relative velocity w.
    pub(crate) fn force(&self, gap: f64, n: &Vector3<f64>, w: &Vector3<f64>) -> Vector3<f64> {
        let normal = self.normal(gap, n.dot(w));
        n * normal + self.tangential(normal, n, w)
    }

    /// Returns ∂/∂d and ∂/∂w of the [`force`](Self::force), with constant N in the friction.
    ///
    /// n is the gradient of the gap by d, and `bend` its derivative ∂n/∂d.
    pub(crate) fn slopes(
        &self,
        gap: f64,
        n: &Vector3<f64>,
        bend: &Matrix3<f64>,
        w: &Vector3<f64>,
    ) -> [Matrix3<f64>; 2] {
        let (closing, turning) = (n.dot(w), bend * w);
        let x = self.damping * closing;
        let (pressure, factor) = (self.pressure(gap), damping_factor(x));
        let normal = pressure * factor;
        // d/dx (√(1 + x²) − x) = −(√(1 + x²) − x)/√(1 + x²).
        let by_rate = -normal * self.damping / (1.0 + x * x).sqrt();
        let by_place = n * (-self.slope(gap) * factor) + turning * by_rate;
        let slopes = [n * by_place.transpose() + bend * normal, n * (n * by_rate).transpose()];
        if self.friction == 0.0 {
            return slopes;
        }
        let sliding = w - n * closing;
        let speed = (sliding.norm_squared() + self.slip_speed.powi(2)).sqrt();
        let direction = sliding / speed;
        let by_sliding =
            (direction * direction.transpose() - Matrix3::identity()) * (normal * self.friction / speed);
        let [place, velocity] = slopes;
        // The sliding velocity is w − n (n·w).
        let across = Matrix3::identity() - n * n.transpose();
        let tilted = n * turning.transpose() + bend * closing;
        [place - by_sliding * tilted, velocity + by_sliding * across]
    }

    /// Bounds the rounding error of the force at a gap and a speed.
    ///
    /// The gap, the direction and the velocities have errors of ε times the given numbers.
    pub(crate) fn rounding(
        &self,
        gap: f64,
        speed: f64,
        [of_gap, of_direction, of_velocity]: [f64; 3],
    ) -> f64 {
        let pressure = self.pressure(gap);
        let approach = 1.0 + 2.0 * self.damping * speed;
        let velocity = of_velocity + speed * of_direction;
        let normal = (self.slope(gap) * of_gap + pressure * of_direction) * approach
            + pressure * self.damping * 2.0 * velocity;
        let sliding = pressure * approach * self.friction * velocity / self.slip_speed;
        2.0 * f64::EPSILON * (normal * (1.0 + self.friction) + sliding)
    }
}

/// Computes √(1 + x²) − x without cancellation.
fn damping_factor<D: Real>(x: D) -> D {
    let root = (x * x + 1.0).sqrt();
    if x.re() > 0.0 { (root + x).recip() } else { root - x }
}
