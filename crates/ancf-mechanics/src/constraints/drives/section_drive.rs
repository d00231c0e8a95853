use std::ops::Range;

use ancf_solver::equations::{Inadmissibility, Level, Local, LocalMatrix, State, Term, Weights};
use nalgebra::Vector3;

use crate::constraints::Wrench;
use crate::functions::{Function, FunctionValue};
use crate::kinematics::{Marker, SectionFrame, relative_driven_rotation};

/// Three equations that prescribe the frame of a section by rotation of its reference axes about an axis.
///
/// With X, Y, Z = R(k, θ) (x₀, y₀, z₀) and the directors d, e of the [`SectionFrame`]: X·d = 0, X·e = 0,
/// w_y Z·d = w_z Y·e. The angle is θ = s α f(t). f is a function of time and s the load factor, which differs from 1 in
/// statics only. The section may change its size and shape. The equations also hold half a turn away. That state is
/// inadmissible.
///
/// Units: none for the directors; λ is a moment, α an angle in radians.
#[derive(Clone, Debug)]
pub struct SectionDrive {
    global: SectionFrame,
    frame: SectionFrame,
    coordinates: Vec<usize>,
    first: usize,
    axis: Vector3<f64>,
    angle: f64,
    function: Function,
}

/// Axes X, Y and Z with their changes from the reference state.
struct DrivenAxes {
    values: [Vector3<f64>; 3],
    changes: [Vector3<f64>; 3],
}

impl SectionDrive {
    /// Rotates a frame about a unit vector by an angle times a function of time. Uses the three multipliers from `first`.
    pub fn new(
        frame: &SectionFrame,
        axis: Vector3<f64>,
        angle: f64,
        function: Function,
        first: usize,
    ) -> Self {
        let coordinates = Marker::union_coordinates(frame.directors());
        Self {
            global: frame.clone(),
            frame: frame.within(&coordinates),
            coordinates,
            first,
            axis,
            angle,
            function,
        }
    }

    /// Returns the contribution to the reaction of the drive on the section.
    pub fn reaction(&self, s: &State) -> Wrench {
        let lambda = &s.lambda[self.first..self.first + 3];
        let angle = s.load * self.angle * self.function.value(s.t);
        let forces = self.forces(&self.axes(angle).values, lambda);
        let directors = self.global.directors().each_ref().map(|director| director.value(s));
        let moment = directors.iter().zip(forces).map(|(director, force)| -director.cross(&force)).sum();
        Wrench { moment, ..Wrench::default() }
    }

    /// Returns the rotated axes, with 1 − cos θ free of cancellation.
    fn axes(&self, angle: f64) -> DrivenAxes {
        let (sin, versine) = (angle.sin(), 2.0 * (0.5 * angle).sin().powi(2));
        let changes = self.frame.reference().map(|axis| {
            let once = self.axis.cross(&axis);
            once * sin + self.axis.cross(&once) * versine
        });
        let reference = self.frame.reference();
        DrivenAxes { values: [0, 1, 2].map(|k| reference[k] + changes[k]), changes }
    }

    /// Returns the forces Φ_qᵀ λ on d and e.
    fn forces(&self, [x, y, z]: &[Vector3<f64>; 3], lambda: &[f64]) -> [Vector3<f64>; 2] {
        let [w_y, w_z] = self.frame.weights();
        [x * lambda[0] + z * (w_y * lambda[2]), x * lambda[1] - y * (w_z * lambda[2])]
    }

    /// Returns the products of the equations for axes and directors or their rates.
    fn products(&self, [x, y, z]: &[Vector3<f64>; 3], [d, e]: &[Vector3<f64>; 2]) -> Vector3<f64> {
        let [w_y, w_z] = self.frame.weights();
        Vector3::new(x.dot(d), x.dot(e), w_y * z.dot(d) - w_z * y.dot(e))
    }

    fn now(&self, at: &Local<'_>) -> DrivenAxes {
        self.axes(at.load * self.angle * self.function.value(at.t))
    }

    /// Returns Φ without cancellation.
    fn position(&self, at: &Local<'_>) -> Vector3<f64> {
        let DrivenAxes { values, changes } = self.now(at);
        let reference = self.frame.directors().each_ref().map(Marker::reference);
        self.products(&changes, &reference) + self.products(&values, &self.frame.rates(at.q))
    }

    /// Returns the directors in a state, and the first and second time derivatives of the axes at full load.
    fn motion(&self, at: &Local<'_>) -> ([Vector3<f64>; 2], [[Vector3<f64>; 3]; 2]) {
        let FunctionValue { value, rate, acceleration } = self.function.at(at.t);
        let [angle, omega, alpha] = [value, rate, acceleration].map(|x| self.angle * x);
        let DrivenAxes { values, .. } = self.axes(angle);
        let rates = values.map(|axis| self.axis.cross(&axis) * omega);
        let slopes =
            [0, 1, 2].map(|k| self.axis.cross(&values[k]) * alpha + self.axis.cross(&rates[k]) * omega);
        let moved = self.frame.directors().each_ref().map(|d| d.reference() + d.sum(at.q));
        (moved, [rates, slopes])
    }
}

impl Term for SectionDrive {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn multipliers(&self) -> Range<usize> {
        self.first..self.first + 3
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn constraint_name(&self, k: usize) -> String {
        if k < 2 { "driven normal of the section" } else { "driven rotation about the normal" }.to_owned()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let (rows, equations) = r.split_at_mut(at.q.len());
        self.frame.add(self.forces(&self.now(at).values, at.lambda), rows);
        equations.iter_mut().zip(&self.position(at)).for_each(|(row, value)| *row += value);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (rows, equations) = floor.split_at_mut(at.q.len());
        let angle = at.load * self.angle * self.function.value(at.t);
        let force: f64 = at.lambda.iter().map(|lambda| lambda.abs()).sum();
        // The rounding error of an angle of many turns is ε times its value.
        let turn = f64::EPSILON * (1.0 + angle.abs());
        let mut moved = 0.0;
        for director in self.frame.directors() {
            moved += director.sum_of_sizes(at.q) + director.reference().norm() * angle.abs().min(2.0);
            for &(first, w) in director.parts() {
                rows[first..first + 3].iter_mut().for_each(|row| *row += 4.0 * turn * (w * force).abs());
            }
        }
        equations.iter_mut().for_each(|row| *row += 4.0 * turn * moved);
    }

    fn tangent(&self, at: &Local<'_>, _: Weights, k: &mut LocalMatrix<'_>) {
        let (n, axes) = (at.q.len(), self.now(at).values);
        for row in 0..3 {
            let mut unit = [0.0; 3];
            unit[row] = 1.0;
            for (director, slope) in self.frame.directors().iter().zip(self.forces(&axes, &unit)) {
                for &(first, w) in director.parts() {
                    (0..3).for_each(|i| k.add(n + row, first + i, w * slope[i]));
                }
            }
        }
    }

    fn constraints(&self, at: &Local<'_>, level: Level, phi: &mut [f64]) {
        let row = if level == Level::Position {
            self.position(at)
        } else {
            let (directors, [rates, slopes]) = self.motion(at);
            let DrivenAxes { values, .. } = self.axes(self.angle * self.function.value(at.t));
            let moving = self.frame.rates(at.v);
            match level {
                Level::Acceleration => {
                    self.products(&rates, &moving) * 2.0 + self.products(&slopes, &directors)
                }
                _ => self.products(&values, &moving) + self.products(&rates, &directors),
            }
        };
        (0..3).for_each(|k| phi[k] += row[k]);
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let ([x, y, z], [w_y, w_z]) = (self.now(at).values, self.frame.weights());
        let [d, e] = self.frame.directors().each_ref().map(|d| d.reference() + d.sum(at.q));
        let is_admissible = x.dot(&d.cross(&e)) > 0.0 && w_y * y.dot(&d) + w_z * z.dot(&e) > 0.0;
        (!is_admissible).then_some(Inadmissibility::HalfTurn)
    }

    /// The equations are linear in the coordinates.
    fn stress_stiffness(&self, _: &Local<'_>, _: &Local<'_>, _: &mut LocalMatrix<'_>) {}

    fn rotation(&self, from: &Local<'_>, to: &Local<'_>) -> f64 {
        let angle = |at: &Local<'_>| at.load * self.angle * self.function.value(at.t);
        relative_driven_rotation(angle(to) - angle(from))
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        let (directors, [rates, _]) = self.motion(at);
        let rate = self.products(&rates, &directors);
        (0..3).map(|k| at.lambda[k] * rate[k]).sum()
    }
}
