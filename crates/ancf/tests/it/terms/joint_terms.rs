//! Terms of joints, springs and drives between two bodies.

use ancf::mechanics::bodies::BeamMesh;
use ancf::mechanics::constraints::{
    BilinearMeasure, HingeAngle, MeasureConstraint, MeasureFactor, MeasureTarget, SlideConstraint,
};
use std::sync::Arc;

use ancf::mechanics::forces::{CoordinateForce, Friction, Spring, StateForce, Strut};
use ancf::mechanics::functions::Function;
use ancf::mechanics::kinematics::BodyVector;
use ancf::mechanics::laws::{
    FrictionCurve, LawExpression, LawStateVariable, LawUnits, LawVariables, Resistance, StateLaw,
};
use ancf::solver::equations::Term;
use nalgebra::Vector3;

use super::kind::TermKind;

/// Friction with a peak.
const STRIBECK: FrictionCurve = FrictionCurve { creep: 0.9, peak: 1.4, decay: 0.7 };

/// Coordinate that belongs to no body.
const OWN: usize = 100;

/// Units of a law that differ from those of the term.
const UNITS: LawUnits = LawUnits { position: 1.5, time: 0.8, force: 2.0 };

fn formula(text: &str) -> Arc<LawExpression> {
    let variables = LawVariables { position: "length", rate: "speed" };
    Arc::new(LawExpression::parse(text, &variables, &[]).unwrap())
}

/// Tension that increases with the elongation and its rate.
fn tension(text: &str) -> Resistance {
    Resistance::tensile(formula(text), UNITS, 0.05)
}

/// Law with two states that depend on the time.
fn with_states() -> StateForce {
    let variables = LawVariables { position: "angle", rate: "rate" };
    let state = |name, rate| LawStateVariable { name, rate, start: 0.2 };
    let states = [state("a", "t - 0.5*a - a^3"), state("b", "sin(t) - b")];
    let law = StateLaw::parse("-2*x - 3*x^3 + t", &states, &[], &variables, &[]).unwrap();
    StateForce::new(vec![OWN, OWN + 1, OWN + 2], Arc::new(law), UNITS, vec![0.7, 1.3], &[])
}

/// Forces by laws of a coordinate and of a length.
fn law_terms(point: &BodyVector, other: &BodyVector) -> Vec<(&'static str, Box<dyn Term>, TermKind)> {
    let of_coordinate = |text| Box::new(CoordinateForce::new(OWN, Resistance::acting(formula(text), UNITS)));
    let of_length = |text| Box::new(Strut::with_law(point, other, tension(text)));
    vec![
        ("law of a coordinate", of_coordinate("-2*x - 3*x^3 - 0.2*v - 0.1*v^3"), TermKind::Smooth),
        ("law of a coordinate and time", of_coordinate("0.3*t - 2*x - 0.2*v"), TermKind::NonConservative),
        ("law with states", Box::new(with_states()), TermKind::NonConservative),
        ("preloaded law of a length", of_length("x + 0.2*length"), TermKind::Smooth),
        ("preloaded law of a length, damped", of_length("x + 0.3*v + 0.1*v^3"), TermKind::Damped),
        ("law of a length and time", of_length("x*t + 0.4"), TermKind::NonConservative),
    ]
}

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
    let laws = law_terms(&point, &other);
    let mut terms: Vec<(&'static str, Box<dyn Term>, TermKind)> = vec![
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
        ("friction", Box::new(Friction::new(turn(), 0.4, STRIBECK)), TermKind::Damped),
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
    ];
    terms.extend(laws);
    terms
}
