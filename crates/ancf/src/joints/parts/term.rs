use ancf_mechanics::constraints::{
    CoincidenceConstraint, ConstantAngle, HingeAngle, LinearConstraint, MeasureConstraint, RotationDrive,
    SectionDrive, SlideConstraint, TwistAngle, Wrench,
};
use ancf_mechanics::forces::{Friction, Spring, Strut, SwingSpring};
use ancf_solver::equations::{State, Term};

/// Term of a joint: a constraint or a force with a reaction.
pub trait JointTerm: Term {
    /// Force and moment that the term exerts on the end `a` in a state.
    fn reaction(&self, s: &State) -> Wrench;

    /// Copies the term for the system of equations.
    fn boxed(&self) -> Box<dyn Term>;
}

macro_rules! joint_terms {
    ($($term:ty),* $(,)?) => {
        $(impl JointTerm for $term {
            fn reaction(&self, s: &State) -> Wrench {
                Self::reaction(self, s)
            }

            fn boxed(&self) -> Box<dyn Term> {
                Box::new(self.clone())
            }
        })*
    };
}

joint_terms! { HingeAngle, LinearConstraint, CoincidenceConstraint, RotationDrive, SectionDrive, Friction, ConstantAngle, SlideConstraint, Spring, Strut, SwingSpring, TwistAngle, MeasureConstraint }
