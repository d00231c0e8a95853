use ancf_mechanics::constraints::{
    CoincidenceConstraint, ConstantAngle, GroupedConstraint, HingeAngle, LinearConstraint, MeasureConstraint,
    RotationDrive, SectionDrive, SlideConstraint, TwistAngle, Wrench,
};
use ancf_mechanics::forces::{
    CoordinateForce, Friction, MatrixBushing, ReactionFriction, Spring, StateForce, Strut, SwingSpring,
};
use ancf_mechanics::shells::{EnclosedVolume, GasPressure};
use ancf_solver::equations::{State, Term};

/// Term of a joint: a constraint or a force with a reaction.
pub trait JointTerm: Term {
    /// Force and moment that the term exerts on the end `a` in a state; none by default.
    fn reaction(&self, _s: &State) -> Wrench {
        Wrench::default()
    }

    /// Copies the term for the system of equations.
    fn boxed(&self) -> Box<dyn Term>;

    /// Copies the term as a part of one term with other constraints of the joint, if it is a quadratic constraint.
    fn grouped(&self) -> Option<GroupedConstraint> {
        None
    }
}

macro_rules! joint_terms {
    ($($term:ty $(: $grouped:path)?),* $(,)?) => {
        $(impl JointTerm for $term {
            fn reaction(&self, s: &State) -> Wrench {
                Self::reaction(self, s)
            }

            fn boxed(&self) -> Box<dyn Term> {
                Box::new(self.clone())
            }

            $(fn grouped(&self) -> Option<GroupedConstraint> {
                $grouped(self)
            })?
        })*
    };
}

joint_terms! {
    CoincidenceConstraint: Self::grouped,
    ConstantAngle: Self::grouped,
    MeasureConstraint: Self::grouped,
    CoordinateForce,
    Friction,
    HingeAngle,
    LinearConstraint,
    MatrixBushing,
    ReactionFriction,
    RotationDrive,
    SectionDrive,
    SlideConstraint,
    Spring,
    StateForce,
    Strut,
    SwingSpring,
    TwistAngle,
}

impl<const N: usize> JointTerm for EnclosedVolume<N> {
    fn boxed(&self) -> Box<dyn Term> {
        Box::new(self.clone())
    }
}

impl JointTerm for GasPressure {
    fn boxed(&self) -> Box<dyn Term> {
        Box::new(self.clone())
    }
}
