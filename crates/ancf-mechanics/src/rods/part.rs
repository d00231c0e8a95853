use std::fmt;

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::section::RodSection;

/// Position and orientation of a cross-section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Point of the axis.
    pub position: Vector3<f64>,
    /// Axes x (the normal of the section), y and z as columns.
    pub frame: Matrix3<f64>,
}

impl Placement {
    /// Creates a placement of orthonormal axes.
    pub fn new(position: Vector3<f64>, axes: [Vector3<f64>; 3]) -> Self {
        Self { position, frame: Matrix3::from_columns(&axes) }
    }

    /// Returns the rotation vector from another placement to this one, accurate for small rotations.
    pub fn rotation_from(&self, other: &Self) -> Vector3<f64> {
        let turn = self.frame * other.frame.transpose();
        let sine = Vector3::new(
            turn[(2, 1)] - turn[(1, 2)],
            turn[(0, 2)] - turn[(2, 0)],
            turn[(1, 0)] - turn[(0, 1)],
        ) * 0.5;
        let (size, cosine) = (sine.norm(), 0.5 * (turn.trace() - 1.0));
        if size == 0.0 { sine } else { sine * (size.atan2(cosine) / size) }
    }

    /// Returns the smallest rotation vector that turns the axis x of another placement to that of this one.
    pub fn axis_rotation_from(&self, other: &Self) -> Vector3<f64> {
        let [from, to] = [other, self].map(|placement| placement.frame.column(0).into_owned());
        let normal = from.cross(&to);
        let sine = normal.norm();
        if sine == 0.0 { normal } else { normal * (sine.atan2(from.dot(&to)) / sine) }
    }
}

/// Force and moment at a point of a rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLoad {
    /// Place ξ in [0, 1].
    pub xi: f64,
    /// Force.
    pub force: Vector3<f64>,
    /// Moment about the axis.
    pub moment: Vector3<f64>,
}

/// Section forces of a part of a rod: the force is a quartic of the arc length but for point loads, the couple per
/// length a quadratic polynomial.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RodLoads {
    /// Forces at the start and at the end of the element, the latter without the point loads.
    pub forces: [Vector3<f64>; 2],
    /// Deviations from a linear force, as factors of ξ − ξ², ξ − ξ³ and ξ − ξ⁴.
    pub deviations: [Vector3<f64>; 3],
    /// Moment at the start of the element.
    pub moment: Vector3<f64>,
    /// Rate m' + r' × n of the moment, the negative of the couple per length: factors of the shifted Legendre polynomials 1, 2ξ − 1
    /// and 6ξ² − 6ξ + 1.
    pub couples: [Vector3<f64>; 3],
    /// Point loads between the nodes, in ascending order.
    pub points: Vec<PointLoad>,
}

impl RodLoads {
    /// Returns the section force at ξ. At a point load it is the one before the load.
    pub fn force(&self, xi: f64) -> Vector3<f64> {
        let before: Vector3<f64> = self.until(xi).map(|point| point.force).sum();
        self.smooth_force(xi) - before
    }

    /// Returns the section force at ξ without the point loads.
    fn smooth_force(&self, xi: f64) -> Vector3<f64> {
        let square = xi * xi;
        self.forces[0] * (1.0 - xi)
            + self.forces[1] * xi
            + self.deviations[0] * (xi - square)
            + self.deviations[1] * (xi - square * xi)
            + self.deviations[2] * (xi - square * square)
    }

    /// Returns the distributed load −dn/dξ at ξ, multiplied by the length of the element.
    pub fn distributed(&self, xi: f64) -> Vector3<f64> {
        let [second, third, fourth] = self.deviations;
        let square = xi * xi;
        self.forces[0]
            - self.forces[1]
            - second * (1.0 - 2.0 * xi)
            - third * (1.0 - 3.0 * square)
            - fourth * (1.0 - 4.0 * square * xi)
    }

    /// Returns m' + r' × n at ξ.
    pub fn couple(&self, xi: f64) -> Vector3<f64> {
        let [constant, linear, quadratic] = self.couples;
        constant + linear * (2.0 * xi - 1.0) + quadratic * (6.0 * xi * xi - 6.0 * xi + 1.0)
    }

    /// Returns the integral of [`couple`](Self::couple) between 0 and ξ.
    pub fn couple_until(&self, xi: f64) -> Vector3<f64> {
        let [constant, linear, quadratic] = self.couples;
        (constant + linear * (xi - 1.0) + quadratic * (2.0 * xi * xi - 3.0 * xi + 1.0)) * xi
    }

    /// Returns the point loads between the start and ξ.
    pub fn until(&self, xi: f64) -> impl Iterator<Item = &PointLoad> {
        self.points.iter().take_while(move |point| point.xi < xi)
    }

    /// Returns the parts of [0, ξ] between point loads.
    pub fn parts(&self, xi: f64) -> impl Iterator<Item = [f64; 2]> {
        let ends = self.until(xi).map(|point| point.xi).chain([xi]);
        ends.scan(0.0, |start, end| Some([std::mem::replace(start, end), end])).filter(|[from, to]| to > from)
    }
}

/// Part of a rod between the nodes of an element, with known section forces.
///
/// r' = Λ ((1 + ε⁰) e₁ + C_n⁻¹ Λᵀ n),  Λ' = Λ [κ⁰ + C_m⁻¹ Λᵀ m]×,  m' = −r' × n − c.
///
/// Source: Reissner (1981); Simo (1985).
pub struct RodPart<'a> {
    /// Length of the element.
    pub length: f64,
    /// Section at ξ in [0, 1].
    pub section: &'a dyn Fn(f64) -> RodSection,
    /// Loads.
    pub loads: &'a RodLoads,
}

impl fmt::Debug for RodPart<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RodPart")
            .field("length", &self.length)
            .field("loads", &self.loads)
            .finish_non_exhaustive()
    }
}

/// Length of a step, relative to an element.
const STEP: f64 = 0.5;

/// Explicit Runge-Kutta method of order six with seven stages. Gaps decrease with the fifth power of the length of an element.
///
/// Source: Butcher (1964).
const STAGES: usize = 7;
const NODES: [f64; STAGES] = [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0, 0.5, 0.5, 1.0];
const STAGE_WEIGHTS: [[f64; STAGES - 1]; STAGES] = [
    [0.0; 6],
    [1.0 / 3.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 2.0 / 3.0, 0.0, 0.0, 0.0, 0.0],
    [1.0 / 12.0, 1.0 / 3.0, -1.0 / 12.0, 0.0, 0.0, 0.0],
    [-1.0 / 16.0, 9.0 / 8.0, -3.0 / 16.0, -3.0 / 8.0, 0.0, 0.0],
    [0.0, 9.0 / 8.0, -3.0 / 8.0, -3.0 / 4.0, 0.5, 0.0],
    [9.0 / 44.0, -9.0 / 11.0, 63.0 / 44.0, 18.0 / 11.0, 0.0, -16.0 / 11.0],
];
const WEIGHTS: [f64; STAGES] =
    [11.0 / 120.0, 0.0, 27.0 / 40.0, 27.0 / 40.0, -4.0 / 15.0, -4.0 / 15.0, 11.0 / 120.0];

/// Unknowns of a step: position, rotation vector from the start of the step, moment.
#[derive(Clone, Copy)]
struct Unknowns {
    position: Vector3<f64>,
    rotation: Vector3<f64>,
    moment: Vector3<f64>,
}

impl Unknowns {
    fn plus(&self, rate: &Self, factor: f64) -> Self {
        Self {
            position: self.position + rate.position * factor,
            rotation: self.rotation + rate.rotation * factor,
            moment: self.moment + rate.moment * factor,
        }
    }
}

impl RodPart<'_> {
    /// Integrates from the start of the element to ξ. Returns the placement and the moment there.
    ///
    /// Each step has a rotation vector of its own.
    pub fn end(&self, start: &Placement, xi: f64) -> (Placement, Vector3<f64>) {
        let (mut placement, mut moment) = (*start, self.loads.moment);
        let mut points = self.loads.until(xi).peekable();
        for [from, to] in self.loads.parts(xi) {
            let before: Vector3<f64> =
                self.loads.points.iter().filter(|point| point.xi <= from).map(|point| point.force).sum();
            let force = |xi: f64| self.loads.smooth_force(xi) - before;
            let steps = ((to - from) / STEP).ceil().max(1.0);
            let step = (to - from) / steps;
            for k in 0..steps as u32 {
                let (placed, end) = self.step(&placement, moment, from + step * f64::from(k), step, &force);
                (placement, moment) = (placed, end);
            }
            while let Some(point) = points.next_if(|point| point.xi <= to) {
                moment -= point.moment;
            }
        }
        (placement, moment)
    }

    fn step(
        &self,
        start: &Placement,
        moment: Vector3<f64>,
        from: f64,
        step: f64,
        force: &dyn Fn(f64) -> Vector3<f64>,
    ) -> (Placement, Vector3<f64>) {
        let zero = Unknowns { position: start.position, rotation: Vector3::zeros(), moment };
        let h = step * self.length;
        let sum = |rates: &[Unknowns], weights: &[f64]| {
            rates.iter().zip(weights).fold(zero, |sum, (rate, weight)| sum.plus(rate, weight * h))
        };
        let mut rates = [zero; STAGES];
        for stage in 0..STAGES {
            let xi = from + NODES[stage] * step;
            let at = sum(&rates[..stage], &STAGE_WEIGHTS[stage]);
            rates[stage] = self.rate(&start.frame, &at, xi, &force(xi));
        }
        let end = sum(&rates, &WEIGHTS);
        let turn = Rotation3::from_scaled_axis(end.rotation);
        (Placement { position: end.position, frame: start.frame * turn.matrix() }, end.moment)
    }

    fn rate(&self, from: &Matrix3<f64>, u: &Unknowns, xi: f64, force: &Vector3<f64>) -> Unknowns {
        let frame = from * Rotation3::from_scaled_axis(u.rotation).matrix();
        let section = (self.section)(xi);
        let [stretch, bend] = section.strains(&frame.tr_mul(force), &frame.tr_mul(&u.moment));
        let tangent = frame * (Vector3::x() * (1.0 + section.strain) + stretch);
        Unknowns {
            position: tangent,
            rotation: rotation_rate(&u.rotation, &(section.curvature + bend)),
            moment: self.loads.couple(xi) - tangent.cross(force),
        }
    }
}

/// Returns θ' of Λ = exp θ with Λ' = Λ [κ]×: κ + ½ θ × κ + c θ × (θ × κ), c = (1 − ½θ cot ½θ)/θ².
fn rotation_rate(rotation: &Vector3<f64>, curvature: &Vector3<f64>) -> Vector3<f64> {
    let angle = rotation.norm();
    let c = if angle < 1e-2 {
        1.0 / 12.0 + angle * angle / 720.0
    } else {
        (1.0 - 0.5 * angle / (0.5 * angle).tan()) / (angle * angle)
    };
    let first = rotation.cross(curvature);
    curvature + first * 0.5 + rotation.cross(&first) * c
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::super::section::AxialLaw;
    use super::*;

    fn part(length: f64, loads: RodLoads, section: RodSection) -> Placement {
        let start = Placement { position: Vector3::zeros(), frame: Matrix3::identity() };
        RodPart { length, section: &|_| section, loads: &loads }.end(&start, 1.0).0
    }

    /// EA = 1000, k_y GA = 500, k_z GA = 250, GJ = 2, EI_y = 4, EI_z = 8.
    fn section() -> RodSection {
        RodSection {
            stretch: Vector3::new(1e-3, 2e-3, 4e-3),
            bend: Vector3::new(0.5, 0.25, 0.125),
            curvature: Vector3::zeros(),
            strain: 0.0,
            gyration: Vector3::zeros(),
            law: AxialLaw::Linear,
        }
    }

    #[test]
    fn end_moment_bends_to_a_circle() {
        let moment = Vector3::new(0.0, 0.0, 4.0);
        let end = part(1.0, RodLoads { moment, ..RodLoads::default() }, section());
        // κ = M/EI_z = 4/8; r = (sin κ, 1 − cos κ)/κ.
        let expected = Vector3::new(0.5_f64.sin(), 1.0 - 0.5_f64.cos(), 0.0) / 0.5;
        assert!((end.position - expected).norm() < 1e-5, "{}", end.position);
        let turned = Rotation3::from_scaled_axis(Vector3::z() * 0.5);
        assert!((end.frame - turned.matrix()).norm() < 1e-12);
    }

    #[test]
    fn reference_curvature_is_that_of_the_arc() {
        let arc = section().curved(Vector3::new(0.0, 0.0, FRAC_PI_2 * 0.2));
        let end = part(1.0, RodLoads::default(), arc);
        let kappa = FRAC_PI_2 * 0.2;
        let expected = Vector3::new(kappa.sin(), 1.0 - kappa.cos(), 0.0) / kappa;
        assert!((end.position - expected).norm() < 1e-6);
    }

    #[test]
    fn small_tip_force_bends_and_shears_as_a_timoshenko_beam() {
        let force = Vector3::new(0.0, 1e-5, 0.0);
        let moment = Vector3::new(0.0, 0.0, 1e-5);
        let end = part(1.0, RodLoads { forces: [force; 2], moment, ..RodLoads::default() }, section());
        // P l³/3EI + P l/kGA.
        let expected = 1e-5 * (0.125 / 3.0 + 2e-3);
        assert!((end.position.y / expected - 1.0).abs() < 1e-9, "{}", end.position.y / expected);
    }
}
