use ancf_solver::equations::{LOCAL, State};
use nalgebra::Vector3;

use crate::constraints::{BilinearMeasure, Wrench};
use crate::kinematics::BodyVector;

/// Component of the slip of a bearing: a rate s = J(q) v that is linear in the velocities.
#[derive(Clone, Debug)]
pub enum Slip {
    /// Rate of a measure.
    Rate(BilinearMeasure),
    /// Relative angular velocity of two orthonormal triads about an axis, times a lever arm.
    Turn {
        /// Triads of the first and the second body.
        triads: Box<[[BodyVector; 3]; 2]>,
        /// Axis.
        axis: TurnAxis,
        /// Lever arm; 1 for the angular velocity itself.
        arm: f64,
    },
}

/// Axis of a relative angular velocity.
#[derive(Clone, Debug)]
pub enum TurnAxis {
    /// Direction of a body or of the ground.
    Direction(BodyVector),
    /// Arm e of a cross whose other arm is e′: the angular velocity α e + α′ e′ has the rate α.
    ArmOfCross(Box<[BodyVector; 2]>),
}

impl TurnAxis {
    fn vectors(&self) -> &[BodyVector] {
        match self {
            Self::Direction(direction) => std::slice::from_ref(direction),
            Self::ArmOfCross(arms) => &arms[..],
        }
    }

    /// Returns d with the rate d·ω, from the values of the vectors.
    fn dual(&self, value: impl Fn(&BodyVector) -> Vector3<f64>) -> Vector3<f64> {
        match self {
            Self::Direction(direction) => value(direction),
            Self::ArmOfCross(arms) => {
                let [arm, other] = arms.each_ref().map(value);
                let cosine = arm.dot(&other);
                (arm - other * cosine) / (1.0 - cosine * cosine)
            }
        }
    }

    fn within(&self, coordinates: &[usize]) -> Self {
        match self {
            Self::Direction(direction) => Self::Direction(direction.within(coordinates)),
            Self::ArmOfCross(arms) => {
                Self::ArmOfCross(Box::new(arms.each_ref().map(|arm| arm.within(coordinates))))
            }
        }
    }
}

impl Slip {
    /// Returns the coordinates that the component depends on.
    pub(super) fn coordinates(&self) -> Vec<usize> {
        match self {
            Self::Rate(measure) => measure.coordinates(),
            Self::Turn { triads, axis, .. } => {
                BodyVector::union_coordinates(triads.iter().flatten().chain(axis.vectors()))
            }
        }
    }

    /// Expresses the component in places of a list of coordinates.
    pub(super) fn within(&self, coordinates: &[usize]) -> Self {
        match self {
            Self::Rate(measure) => Self::Rate(measure.within(coordinates)),
            Self::Turn { triads, axis, arm } => {
                let triads = triads.each_ref().map(|triad| triad.each_ref().map(|x| x.within(coordinates)));
                Self::Turn { triads: Box::new(triads), axis: axis.within(coordinates), arm: *arm }
            }
        }
    }

    /// Returns the row of J.
    ///
    /// The angular velocity of an orthonormal triad is ½ Σ a_i × ȧ_i, so that d·ω has the gradient ½ d × a_i by ȧ_i.
    pub(super) fn row(&self, q: &[f64]) -> [f64; LOCAL] {
        let mut row = [0.0; LOCAL];
        match self {
            Self::Rate(measure) => measure.add_gradient(q, 1.0, &mut row[..q.len()]),
            Self::Turn { triads, axis, arm } => {
                let dual = axis.dual(|vector| vector.at(q));
                for (triad, factor) in triads.iter().zip([0.5 * arm, -0.5 * arm]) {
                    for x in triad {
                        x.add(q, dual.cross(&x.at(q)) * factor, &mut row[..q.len()]);
                    }
                }
            }
        }
        row
    }

    /// Returns the force and moment on the first body by a generalised force on the component.
    pub(super) fn wrench(&self, s: &State, f: f64) -> Wrench {
        match self {
            Self::Rate(measure) => measure.wrench(s, f),
            Self::Turn { axis, arm, .. } => {
                Wrench { moment: axis.dual(|vector| vector.value(s)) * (arm * f), ..Wrench::default() }
            }
        }
    }
}
