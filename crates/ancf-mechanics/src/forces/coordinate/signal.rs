use ancf_solver::equations::{LOCAL, Local};

use crate::constraints::BilinearMeasure;
use crate::kinematics::BodyVector;

/// Quantity of the state that a force law of another coordinate reads, such as a controller: a value, or its rate.
///
/// Units: those of the law, by a factor and an offset: offset + factor s, or offset + factor ds/dt.
#[derive(Clone, Debug)]
pub struct Signal {
    source: SignalSource,
    /// True for the rate ds/dt.
    is_rate: bool,
    factor: f64,
    offset: f64,
}

/// Quantity s of a signal.
#[derive(Clone, Debug)]
pub enum SignalSource {
    /// Coordinate, such as the angle of a joint.
    Coordinate(usize),
    /// Change of a measure from the reference state, such as a displacement.
    Measure(BilinearMeasure),
    /// Magnitude of a vector, such as the distance of two points.
    Norm(BodyVector),
}

impl Signal {
    /// Creates the signal of a value.
    pub const fn value(source: SignalSource, factor: f64, offset: f64) -> Self {
        Self { source, is_rate: false, factor, offset }
    }

    /// Creates the signal of a rate.
    pub const fn rate(source: SignalSource, factor: f64, offset: f64) -> Self {
        Self { source, is_rate: true, factor, offset }
    }

    /// Returns the coordinates of the signal, with repetitions.
    pub fn coordinates(&self) -> Vec<usize> {
        match &self.source {
            SignalSource::Coordinate(coordinate) => vec![*coordinate],
            SignalSource::Measure(measure) => measure.coordinates(),
            SignalSource::Norm(vector) => vector.coordinates().collect(),
        }
    }

    /// Renumbers the coordinates for a term with the given coordinate list.
    pub(super) fn within(&self, coordinates: &[usize]) -> Self {
        let source = match &self.source {
            SignalSource::Coordinate(own) => {
                let place = coordinates.iter().position(|other| other == own);
                SignalSource::Coordinate(place.expect("the coordinate list contains all coordinates"))
            }
            SignalSource::Measure(measure) => SignalSource::Measure(measure.within(coordinates)),
            SignalSource::Norm(vector) => SignalSource::Norm(vector.within(coordinates)),
        };
        Self { source, ..*self }
    }

    /// Returns the value.
    pub(super) fn at(&self, at: &Local<'_>) -> f64 {
        let own = match (&self.source, self.is_rate) {
            (SignalSource::Coordinate(c), false) => at.q[*c],
            (SignalSource::Coordinate(c), true) => at.v[*c],
            (SignalSource::Measure(measure), false) => measure.change(at.q),
            (SignalSource::Measure(measure), true) => measure.slope(at.q, at.v),
            (SignalSource::Norm(vector), false) => vector.at(at.q).norm(),
            (SignalSource::Norm(vector), true) => vector.at(at.q).normalize().dot(&vector.rate(at.q, at.v)),
        };
        self.offset + self.factor * own
    }

    /// Returns a bound of the rounding error of the value.
    pub(super) fn rounding(&self, at: &Local<'_>) -> f64 {
        let sum = |x: &[f64]| x.iter().map(|x| x.abs()).sum::<f64>();
        let own = match (&self.source, self.is_rate) {
            (SignalSource::Coordinate(c), false) => at.q[*c].abs(),
            (SignalSource::Coordinate(c), true) => at.v[*c].abs(),
            (SignalSource::Measure(measure), false) => {
                measure.add_rounding(at.q, 0.0, &mut [0.0; LOCAL][..at.q.len()]) / f64::EPSILON
            }
            (SignalSource::Norm(vector), false) => vector.size(at.q),
            (SignalSource::Measure(_) | SignalSource::Norm(_), true) => {
                let mut by_rates = [0.0; LOCAL];
                self.add_derivative(at, Variable::Rates, 1.0, &mut by_rates[..at.q.len()]);
                sum(&by_rates) * at.v.iter().fold(0.0, |size: f64, v| size.max(v.abs())) / self.factor.abs()
            }
        };
        8.0 * f64::EPSILON * (self.offset.abs() + self.factor.abs() * own)
    }

    /// Adds f ∂s/∂q or f ∂s/∂v.
    pub(super) fn add_derivative(&self, at: &Local<'_>, by: Variable, f: f64, rows: &mut [f64]) {
        let f = f * self.factor;
        match (by, self.is_rate) {
            (Variable::Coordinates, false) | (Variable::Rates, true) => self.add_gradient(at.q, f, rows),
            (Variable::Coordinates, true) => self.add_gradient_slope(at, f, rows),
            (Variable::Rates, false) => {}
        }
    }

    fn add_gradient(&self, q: &[f64], f: f64, rows: &mut [f64]) {
        match &self.source {
            SignalSource::Coordinate(c) => rows[*c] += f,
            SignalSource::Measure(measure) => measure.add_gradient(q, f, rows),
            SignalSource::Norm(vector) => vector.add(q, vector.at(q).normalize() * f, rows),
        }
    }

    /// Adds f times the derivative of the gradient along v.
    fn add_gradient_slope(&self, at: &Local<'_>, f: f64, rows: &mut [f64]) {
        match &self.source {
            SignalSource::Coordinate(_) => {}
            SignalSource::Measure(measure) => measure.add_gradient_slope(at.q, at.v, f, rows),
            SignalSource::Norm(vector) => {
                let (d, rate) = (vector.at(at.q), vector.rate(at.q, at.v));
                let n = d.normalize();
                vector.add(at.q, (rate - n * n.dot(&rate)) * (f / d.norm()), rows);
                vector.add_slope(at.q, at.v, n * f, rows);
            }
        }
    }
}

/// Variables of a derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Variable {
    /// Coordinates q.
    Coordinates,
    /// Rates v.
    Rates,
}
