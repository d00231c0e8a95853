//! Terms on the frames of sections, inside elements, with unequal weights.

use ancf::mechanics::bodies::BeamMesh;
use ancf::mechanics::constraints::{
    BilinearMeasure, CoincidenceConstraint, HingeAngle, MeasureConstraint, MeasureFactor, MeasureTarget,
    SectionDrive, SlideConstraint, TwistAngle,
};
use ancf::mechanics::forces::{
    Bearing, BushingMatrices, ExternalForce, FollowerForce, Force, Friction, FrictionLaw, MatrixBushing,
    Moment, ReactionFriction, Slip, Spring, Strut, SwingSpring, TurnAxis,
};
use ancf::mechanics::functions::{ForceFunction, Function};
use ancf::mechanics::kinematics::{BodyVector, SectionFrame};
use ancf::mechanics::laws::FrictionCurve;
use ancf::solver::equations::Term;
use nalgebra::{Matrix6, Vector3, Vector6};

use super::kind::TermKind;

/// Friction with a peak.
const STRIBECK: FrictionCurve = FrictionCurve { creep: 0.9, peak: 1.4, decay: 0.7 };

/// Coordinate that belongs to no body.
const OWN: usize = 100;

/// Frame of a section inside an element, with the weight 0.3.
fn frame(mesh: &BeamMesh, s: f64) -> SectionFrame {
    let [_, d, e] = mesh.axes(s);
    SectionFrame::new([&d, &e], 0.3)
}

/// Point at an arm of a section.
fn arm(mesh: &BeamMesh, frame: &SectionFrame, s: f64) -> BodyVector {
    let arm = BodyVector::turned(frame, Vector3::new(0.2, -0.5, 0.4));
    BodyVector::combined([(1.0, &mesh.point(s).into()), (1.0, &arm)])
}

fn external(t: f64, x: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    let [x, v] = [x, v].map(Vector3::from);
    let field = Vector3::new(0.3 * t, -2.0, 0.7);
    (field - x * 3.0 - v * 0.4 + field.cross(&v) + x * x.dot(&v) * 0.2).into()
}

type Case = (&'static str, Box<dyn Term>, TermKind);

/// Returns friction of the slip between two frames.
fn friction_terms(frames: [&SectionFrame; 2], axes: [Vector3<f64>; 3], along: BilinearMeasure) -> [Case; 3] {
    let triads = frames.map(|frame| axes.map(|x| BodyVector::turned(frame, x)));
    let turn = |axis: TurnAxis, arm: f64| Slip::Turn { triads: Box::new(triads.clone()), axis, arm };
    let ball = [Vector3::x(), Vector3::y(), Vector3::z()]
        .map(|axis| turn(TurnAxis::Direction(BodyVector::fixed(axis)), 1.0));
    let arms = Box::new([triads[0][0].clone(), triads[1][1].clone()]);
    let about = turn(TurnAxis::Direction(triads[1][2].clone()), 0.7);
    [
        ("friction of a ball", ball.into()),
        ("friction of a cross", vec![turn(TurnAxis::ArmOfCross(arms), 1.0)]),
        ("friction of a sleeve", vec![Slip::Rate(along), about]),
    ]
    .map(|(name, slip)| {
        let law = FrictionLaw { amount: 0.4, coefficient: 0.0, curve: STRIBECK };
        let term: Box<dyn Term> = Box::new(ReactionFriction::new(slip, 5, Bearing::Plane, law));
        (name, term, TermKind::IncompleteStiffness)
    })
}

/// Returns terms between the frames of two bodies with their names.
pub(super) fn frame_terms(a: &BeamMesh, b: &BeamMesh) -> Vec<Case> {
    let (fa, fb) = (frame(a, 0.31), frame(b, 0.9));
    let axes = [Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.48, 0.8, -0.36), Vector3::new(-0.64, 0.6, 0.48)];
    let [p, q, normal] = axes.map(|x| BodyVector::turned(&fa, x));
    let [u, v, w] = axes.map(|x| BodyVector::turned(&fb, x));
    let (point, other) = (arm(a, &fa, 0.31), arm(b, &fb, 0.9));
    let apart = BodyVector::combined([(1.0, &point), (-1.0, &other)]);
    let d = BodyVector::from(&fa.directors()[0]);
    let turn = || BilinearMeasure::new([(0.8, MeasureFactor::Direction(&p), MeasureFactor::Other(&v))]);
    let along = || BilinearMeasure::new([(1.0, MeasureFactor::Other(&w), MeasureFactor::Point(&apart))]);
    let row = BilinearMeasure::new([(0.7, MeasureFactor::Direction(&d), MeasureFactor::Other(&v))]);
    let positive = BilinearMeasure::new([(1.0, MeasureFactor::Direction(&normal), MeasureFactor::Other(&w))]);
    let swing = || {
        [&u, &v, &w].map(|axis| {
            BilinearMeasure::new([(1.0, MeasureFactor::Direction(&p), MeasureFactor::Other(axis))])
        })
    };
    let sine = || Function::Sine { frequency: 0.4, phase: 0.3 };
    let slide = SlideConstraint::along(a.element_axes(), &other, OWN, 0.31, 5).swap_remove(0);
    let ramp = Function::Ramp { start: 0.0, end: 2.0 };
    let constraints: Vec<Case> = vec![
        (
            "frames: row of a clamp",
            Box::new(MeasureConstraint::new(row, 5).where_positive(&positive)),
            TermKind::Smooth,
        ),
        ("frames: axis of a hinge", Box::new(MeasureConstraint::new(turn(), 5)), TermKind::Smooth),
        (
            "frames: driven displacement",
            Box::new(MeasureConstraint::driven(along(), MeasureTarget::new(0.3, sine()), 5)),
            TermKind::Smooth,
        ),
        ("frames: angle", Box::new(HingeAngle::new(OWN, &p, [&u, &v], 5)), TermKind::Smooth),
        ("frames: points", Box::new(CoincidenceConstraint::points(&point, &other, 5)), TermKind::Smooth),
        ("frames: drive", Box::new(SectionDrive::new(&fa, axes[1], 2.0, ramp, 5)), TermKind::Smooth),
        ("frames: spring", Box::new(Spring::new(turn(), 2.0, 0.0)), TermKind::Smooth),
        ("frames: damped spring", Box::new(Spring::new(along(), 2.0, 0.3)), TermKind::Damped),
        ("frames: friction", Box::new(Friction::new(turn(), 0.4, STRIBECK)), TermKind::Damped),
        ("frames: strut", Box::new(Strut::new(&point, &other, 2.0, 0.7, 0.0).unstressed()), TermKind::Damped),
        (
            "frames: twist",
            Box::new(TwistAngle::new(OWN, [p.clone(), q.clone()], [u.clone(), v.clone()], 5)),
            TermKind::Smooth,
        ),
        ("frames: swing", Box::new(SwingSpring::new(swing(), [2.0, 0.7], [0.0; 2])), TermKind::Smooth),
        (
            "frames: damped swing",
            Box::new(SwingSpring::new(swing(), [2.0, 0.7], [0.3, 0.2])),
            TermKind::Damped,
        ),
        ("frames: slide", Box::new(slide), TermKind::Smooth),
    ];
    // The axes of both bodies coincide in the reference state, as those of a bushing.
    let own = fb.reference().map(|axis| BodyVector::turned(&fa, axis));
    let others = fb.reference().map(|axis| BodyVector::turned(&fb, axis));
    let bushings = bushings(own.each_ref(), others.each_ref(), &apart);
    let friction = friction_terms([&fa, &fb], axes, along()).into();
    [constraints, friction, bushings, frame_loads(&fa, &point, &p)].into_iter().flatten().collect()
}

/// Matrix of small integers plus a multiple of the identity.
fn symmetric(factor: f64, diagonal: f64) -> Matrix6<f64> {
    let entry = |i: usize, j: usize| factor * (((i * j + i + j) % 5) as f64 - 2.0);
    Matrix6::from_fn(|i, j| entry(i, j) + if i == j { diagonal } else { 0.0 })
}

/// Returns bushings by matrices, of which one has damping and one a preload.
fn bushings(a: [&BodyVector; 3], b: [&BodyVector; 3], apart: &BodyVector) -> Vec<Case> {
    let product =
        |factor, i: usize, j: usize| (factor, MeasureFactor::Direction(a[i]), MeasureFactor::Other(b[j]));
    let bushing = |stiffness, damping, preload| {
        let along =
            |k: usize| BilinearMeasure::new([(1.0, MeasureFactor::Other(b[k]), MeasureFactor::Point(apart))]);
        let cosine = BilinearMeasure::new([0, 1, 2].map(|k| product(0.5, k, k)));
        let sine = |k: usize| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            BilinearMeasure::new([product(0.5, i, j), product(-0.5, j, i)])
        };
        let matrices = BushingMatrices { stiffness, damping, preload };
        Box::new(MatrixBushing::new([0, 1, 2].map(along), cosine, [0, 1, 2].map(sine), matrices))
    };
    let (none, rest, load) =
        (Matrix6::zeros(), Vector6::zeros(), Vector6::new(0.3, -0.2, 0.1, 0.4, 0.2, -0.5));
    vec![
        ("frames: matrix bushing", bushing(symmetric(0.3, 4.0), none, rest), TermKind::Smooth),
        (
            "preloaded matrix bushing between frames",
            bushing(symmetric(0.3, 4.0), none, load),
            TermKind::Smooth,
        ),
        (
            "frames: damped matrix bushing",
            bushing(symmetric(0.02, 0.3), symmetric(0.008, 0.08), rest),
            TermKind::Damped,
        ),
    ]
}

/// Returns loads on the frame of a section, on a point at an arm and along a direction of the section.
fn frame_loads(frame: &SectionFrame, point: &BodyVector, along: &BodyVector) -> Vec<Case> {
    let force = Vector3::new(0.3, -2.0, 0.7);
    vec![
        ("frames: force", Box::new(Force::new(point, force)), TermKind::Smooth),
        ("frames: moment", Box::new(Moment::new(frame, force, Function::ONE)), TermKind::NonConservative),
        (
            "frames: follower",
            Box::new(FollowerForce::new(point, along, Function::ONE)),
            TermKind::NonConservative,
        ),
        (
            "frames: external force",
            Box::new(ExternalForce::new(point, ForceFunction::new(external), 1e6)),
            TermKind::NonConservative,
        ),
    ]
}
