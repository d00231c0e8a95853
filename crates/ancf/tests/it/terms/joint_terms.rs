//! Terms of joints, springs and drives between two bodies.

use ancf::mechanics::bodies::BeamMesh;
use ancf::mechanics::constraints::{
    BilinearMeasure, HingeAngle, MeasureConstraint, MeasureFactor, MeasureTarget, SlideConstraint,
};
use ancf::mechanics::forces::{Friction, Spring, Strut};
use ancf::mechanics::functions::Function;
use ancf::mechanics::kinematics::BodyVector;
use ancf::solver::equations::Term;
use nalgebra::Vector3;

use super::kind::TermKind;

/// Coordinate that belongs to no body.
const OWN: usize = 100;

/// Returns terms between two bodies with their names. Terms named "preloaded" are stressed in the reference state.
pub(super) fn joint_terms(a: &BeamMesh, b: &BeamMesh) -> Vec<(&'static str, Box<dyn Term>, TermKind)> {
    let (along, across) = (Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.48, 0.8, -0.36));
    let [point, other] = [a.point(0.31), b.point(0.7)].map(BodyVector::from);
    let relative = BodyVector::combined([(1.0, &point), (-1.0, &other)]);
    let [p, second] = [across, along].map(|x| BodyVector::from(a.direction(0.31, x)));
    let [q, u, v] = [along, across, along.cross(&across)].map(|x| BodyVector::from(b.direction(0.9, x)));
    let along_line =
        || BilinearMeasure::new([(1.0, MeasureFactor::Other(&q), MeasureFactor::Point(&relative))]);
    let square =
        || BilinearMeasure::new([(0.7, MeasureFactor::Point(&relative), MeasureFactor::Point(&relative))]);
    let turn = || {
        let half = |c, x, y| (c, MeasureFactor::Direction(x), MeasureFactor::Other(y));
        BilinearMeasure::new([half(0.5, &p, &q), half(-0.5, &second, &u)])
    };
    let sum = || BilinearMeasure::coordinate(OWN).plus(OWN + 2, -2.5);
    let sine = || Function::Sine { frequency: 0.4, phase: 0.3 };
    let set = || MeasureTarget::new(0.3, sine());
    let slides = SlideConstraint::along(a.element_axes(), &other, OWN, 0.31, 5);
    let crossed = SlideConstraint::along(a.element_axes(), &other, OWN, 1.1, 5);
    let boxed =
        |slides: Vec<SlideConstraint>| slides.into_iter().map(|slide| Box::new(slide) as Box<dyn Term>);
    let [mut slides, mut crossed] = [boxed(slides), boxed(crossed)];
    let mut next = || slides.next().expect("two elements");
    vec![
        ("point in a plane", Box::new(MeasureConstraint::new(along_line(), 5)), TermKind::Polynomial),
        (
            "driven displacement",
            Box::new(MeasureConstraint::driven(along_line(), set(), 5)),
            TermKind::Polynomial,
        ),
        (
            "rod",
            Box::new(MeasureConstraint::driven(square(), MeasureTarget::of_length(0.5, 0.1, sine()), 5)),
            TermKind::Polynomial,
        ),
        ("displacement", Box::new(MeasureConstraint::defining(OWN, along_line(), 5)), TermKind::Polynomial),
        ("coupling", Box::new(MeasureConstraint::driven(sum(), set(), 5)), TermKind::Polynomial),
        ("angle", Box::new(HingeAngle::new(OWN, &p, [&u, &v], 5)), TermKind::Smooth),
        ("spring of a coordinate", Box::new(Spring::new(sum(), 2.0, 0.3)), TermKind::Polynomial),
        ("bushing, translation", Box::new(Spring::new(along_line(), 2.0, 0.0)), TermKind::Polynomial),
        ("bushing, rotation", Box::new(Spring::new(turn(), 2.0, 0.0)), TermKind::Polynomial),
        ("bushing, damped", Box::new(Spring::new(turn(), 2.0, 0.3)), TermKind::Damped),
        ("preloaded spring", Box::new(Spring::with_set_point(turn(), 2.0, 0.0, set())), TermKind::Polynomial),
        ("friction", Box::new(Friction::new(turn(), 0.4, 0.9)), TermKind::Damped),
        ("strut", Box::new(Strut::new(&point, &other, 2.0, 0.0, 0.0).unstressed()), TermKind::Smooth),
        ("strut, damped", Box::new(Strut::new(&point, &other, 2.0, 0.7, 0.0).unstressed()), TermKind::Damped),
        ("preloaded strut", Box::new(Strut::new(&point, &other, 2.0, 0.0, 0.1)), TermKind::Smooth),
        (
            "preloaded rope",
            Box::new(Strut::new(&point, &other, 2.0, 0.1, 0.1).tension_only()),
            TermKind::Damped,
        ),
        ("slack rope", Box::new(Strut::new(&point, &other, 2.0, 0.1, 20.0).tension_only()), TermKind::Smooth),
        ("slide, own element", next(), TermKind::Smooth),
        ("slide, other element", next(), TermKind::Smooth),
        ("slide in the last element", crossed.nth(1).expect("two elements"), TermKind::Smooth),
    ]
}
