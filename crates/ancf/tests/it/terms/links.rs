//! What joints, springs and drives between two bodies are made of, for the laws of terms.

use ancf::function::{Function, Table};
use ancf::mechanics::{Angle, BeamMesh, Friction, Marker, Measure, Part, Slide, Spring, Strut, Target, Tie};
use ancf::system::Term;
use nalgebra::Vector3;

use super::kind::Kind;

/// A coordinate that no body has.
const OWN: usize = 100;

/// Terms between two bodies by name; those named "preloaded" are stressed in the reference state.
pub(crate) fn links(a: &BeamMesh, b: &BeamMesh) -> Vec<(&'static str, Box<dyn Term>, Kind)> {
    let (along, across) = (Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.48, 0.8, -0.36));
    let (point, other) = (a.point(0.31), b.point(0.7));
    let apart = Marker::combined([(1.0, &point), (-1.0, &other)]);
    let (p, q) = (a.direction(0.31, across), b.direction(0.9, along));
    let [u, v] = [b.direction(0.9, across), b.direction(0.9, along.cross(&across))];
    let along_line = || Measure::new([(1.0, Part::Other(&q), Part::Point(&apart))]);
    let square = || Measure::new([(0.7, Part::Point(&apart), Part::Point(&apart))]);
    let turn = || {
        let half = |c, x, y| (c, Part::Direction(x), Part::Other(y));
        Measure::new([half(0.5, &p, &q), half(-0.5, &a.direction(0.31, along), &u)])
    };
    let sum = || Measure::coordinate(OWN).plus(OWN + 2, -2.5);
    let sine = || Function::Sine { frequency: 0.4, phase: 0.3 };
    let set = || Target::new(0.3, sine());
    let slides = Slide::along(a.element_axes(), &other, OWN, 0.31, 5);
    let crossed = Slide::along(a.element_axes(), &other, OWN, 1.1, 5);
    let boxed = |slides: Vec<Slide>| slides.into_iter().map(|slide| Box::new(slide) as Box<dyn Term>);
    let [mut slides, mut crossed] = [boxed(slides), boxed(crossed)];
    let mut next = || slides.next().expect("two elements");
    vec![
        ("point in a plane", Box::new(Tie::new(along_line(), 5)), Kind::Polynomial),
        ("driven displacement", Box::new(Tie::driven(along_line(), set(), 5)), Kind::Polynomial),
        ("rod", Box::new(Tie::driven(square(), Target::of_length(0.5, 0.1, sine()), 5)), Kind::Polynomial),
        ("displacement", Box::new(Tie::defining(OWN, along_line(), 5)), Kind::Polynomial),
        ("coupling", Box::new(Tie::driven(sum(), set(), 5)), Kind::Polynomial),
        ("angle", Box::new(Angle::new(OWN, &p, [&u, &v], 5)), Kind::Smooth),
        ("spring of a coordinate", Box::new(Spring::new(sum(), 2.0, 0.3)), Kind::Polynomial),
        ("bushing, sliding", Box::new(Spring::new(along_line(), 2.0, 0.0)), Kind::Polynomial),
        ("bushing, turning", Box::new(Spring::new(turn(), 2.0, 0.0)), Kind::Polynomial),
        ("bushing, damped", Box::new(Spring::new(turn(), 2.0, 0.3)), Kind::Damped),
        ("preloaded spring", Box::new(Spring::set(turn(), 2.0, 0.0, set())), Kind::Polynomial),
        ("friction", Box::new(Friction::new(turn(), 0.4, 0.9)), Kind::Damped),
        ("strut", Box::new(Strut::new(&point, &other, 2.0, 0.0, 0.0).neutral()), Kind::Smooth),
        ("strut, damped", Box::new(Strut::new(&point, &other, 2.0, 0.7, 0.0).neutral()), Kind::Damped),
        ("preloaded strut", Box::new(Strut::new(&point, &other, 2.0, 0.0, 0.1)), Kind::Smooth),
        ("preloaded rope", Box::new(Strut::new(&point, &other, 2.0, 0.1, 0.1).rope()), Kind::Damped),
        ("slack rope", Box::new(Strut::new(&point, &other, 2.0, 0.1, 20.0).rope()), Kind::Smooth),
        ("slide, here", next(), Kind::Smooth),
        ("slide, elsewhere", next(), Kind::Smooth),
        ("slide in the last element", crossed.nth(1).expect("two elements"), Kind::Smooth),
    ]
}

/// Integrals from 0 on have their functions as rates, and are 0 at 0.
#[test]
fn integrals_of_functions() {
    let table = |points: &[[f64; 2]]| Function::Table(Table::new(points.iter().copied()));
    let functions = [
        Function::Constant(0.7),
        Function::Ramp { start: -0.5, end: 1.5 },
        Function::Ramp { start: 0.5, end: 1.5 },
        Function::Step { at: 0.5, until: Some(1.5) },
        Function::Step { at: -0.5, until: None },
        Function::Sine { frequency: 0.3, phase: 0.4 },
        Function::Sine { frequency: 0.0, phase: 0.4 },
        table(&[[0.2, 1.0], [0.7, -2.0], [0.7, 1.0], [1.6, 3.0]]),
        table(&[[-3.0, 1.0], [1.6, 3.0]]),
    ];
    for function in functions {
        let integral = function.clone().integral().expect("a closed form");
        assert_eq!(integral.value(0.0), 0.0);
        let (mut sum, h) = (0.0, 1e-4);
        for k in 0..20_000 {
            let t = (f64::from(k) + 0.5) * h;
            sum += h * function.value(t);
            let now = integral.at(t + 0.5 * h - 1e-12);
            assert!((now.value - sum).abs() < 1e-7, "{function:?} at {t}: {} and {sum}", now.value);
            assert_eq!(integral.at(t).rate, function.value(t));
        }
    }
}
