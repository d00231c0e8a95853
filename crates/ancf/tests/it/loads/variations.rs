//! Enclosures of functions of time: no variation within an interval is missed.

use std::sync::Arc;

use ancf::mechanics::functions::{Expression, Function, Variation};

use crate::common::random::Random;

fn formula(text: &str) -> Function {
    Function::Expression { formula: Arc::new(Expression::parse(text).unwrap()), unit: 1.0 }
}

fn unseen(f: &Function, from: f64, to: f64) -> Option<Variation> {
    f.unseen_variation(from, to, 1e-3)
}

fn between(random: &mut Random, a: f64, b: f64) -> f64 {
    a + 0.5 * (b - a) * (1.0 + random.number())
}

/// Random formula of some depth.
fn random_formula(random: &mut Random, depth: u32) -> String {
    let number = |random: &mut Random| format!("{:.3}", between(random, 0.2, 3.0));
    if depth == 0 {
        return match random.bits() % 3 {
            0 => "t".into(),
            1 => format!("(t - {})", number(random)),
            _ => number(random),
        };
    }
    let part = |random: &mut Random| random_formula(random, depth - 1);
    let (a, b) = (part(random), part(random));
    match random.bits() % 16 {
        0 => format!("({a} + {b})"),
        1 => format!("({a} - {b})"),
        2 | 3 => format!("({a})*({b})"),
        4 => format!("({a})/(1 + ({b})^2)"),
        5 => format!("sin({}*({a}))", number(random)),
        6 => format!("cos({a})*({b})"),
        7 => format!("exp(-({a})^2)"),
        8 => format!("abs({a})"),
        9 => format!("max({a}, {b})"),
        10 => format!("if({a} < {b}, {a}, {b})"),
        11 => format!("sqrt(1 + ({a})^2)"),
        12 => format!("tanh({a}) - atan({b})"),
        13 => format!("(1 + abs({a}))^1.5"),
        14 => format!("sign({a})*({b})"),
        _ => format!("ln(1 + ({a})^2)"),
    }
}

/// Formulas at random: where nothing is unseen, samples confirm it; otherwise the integral of the deviation is bounded.
#[test]
fn unseen_variations_of_random_formulas_agree_with_samples() {
    let mut random = Random(77);
    let random = &mut random;
    let (mut seen, mut found) = (0, 0);
    for case in 0..400 {
        let text = random_formula(random, 1 + case % 4);
        if text.len() > 900 {
            continue;
        }
        let f = formula(&text);
        let from = between(random, 0.0, 3.0);
        let h = 10.0_f64.powf(between(random, -3.0, 0.7));
        let (a, b) = (f.at(from), f.at(from + h));
        let count = 4000;
        let samples: Vec<(f64, f64)> = (0..count)
            .map(|i| (f64::from(i) + 0.5) / f64::from(count))
            .map(|x| (x, f.value(from + h * x)))
            .collect();
        let cubic = |x: f64| {
            let y = 1.0 - x;
            a.value * y * y * (1.0 + 2.0 * x)
                + b.value * x * x * (3.0 - 2.0 * x)
                + h * x * y * (a.rate * y - b.rate * x)
        };
        let shown = (b.value - a.value).abs() + 0.25 * h * a.rate.abs().max(b.rate.abs());
        let largest = samples.iter().map(|(x, f)| (f - cubic(*x)).abs()).fold(0.0, f64::max);
        let size = samples.iter().map(|(_, f)| f.abs()).fold(0.0, f64::max);
        match unseen(&f, from, from + h) {
            None => {
                seen += 1;
                assert!(
                    largest <= 0.151 * shown + 1e-11 * size,
                    "{text} in {from} + {h}: {largest} of {shown}"
                );
            }
            Some(variation) => {
                found += 1;
                assert!(largest >= 0.09 * shown, "{text} in {from} + {h}: {largest} of {shown}");
                let line = |x: f64| a.value + x * (b.value - a.value);
                let sum: f64 = samples.iter().map(|(x, f)| (f - line(*x)).abs()).sum();
                let (bound, integral) = (variation.deviation * variation.width, h * sum / f64::from(count));
                assert!(bound > 0.97 * integral && bound < 2.3 * integral, "{text}: {bound} for {integral}");
            }
        }
    }
    assert!(seen > 60 && found > 25, "{seen}, {found}");
}

/// Pulses of a billionth of the interval are found at their time, with their area.
#[test]
fn narrow_pulses_are_found() {
    let root = std::f64::consts::PI.sqrt();
    for width in [1e-3, 1e-6, 1e-9] {
        let pulses = [
            (format!("exp(-((t - 0.537)/{width})^2)"), root * width),
            (format!("1/(1 + ((t - 0.537)/{width})^2)"), std::f64::consts::PI * width),
            (format!("max(0, 1 - abs(t - 0.537)/{width})"), width),
            (format!("if(abs(t - 0.537) < {width}, 1, 0)"), 2.0 * width),
            (format!("(t > 0.537 - {width})*(t <= 0.537 + {width})"), 2.0 * width),
        ];
        for (text, area) in pulses {
            let found = unseen(&formula(&text), 0.0, 1.1).unwrap();
            let own = found.deviation * found.width;
            assert!((found.at - 0.537).abs() < 4.0 * width, "{text}: {found:?}");
            assert!(own > 0.95 * area && own < 2.3 * area, "{text}: {own} for {area}");
        }
    }
}

/// Resolved functions have no unseen variation, and a sine whose period divides the interval has one.
#[test]
fn smooth_functions_are_seen() {
    for text in
        ["sin(3*t)", "t^3 - 2*t", "exp(-t)", "1/(1 + t)", "sqrt(1 + t)", "tanh(t)", "2.5", "0*t", "t^0.5"]
    {
        assert_eq!(unseen(&formula(text), 0.3, 0.7), None, "{text}");
    }
    let sine = Function::Sine { frequency: 20.0, phase: 0.3 };
    let integral = sine.clone().integral().unwrap();
    for f in [&sine, &integral] {
        assert_eq!(unseen(f, 0.2, 0.205), None);
        assert!(unseen(f, 0.2, 0.3).is_some());
    }
    for f in [Function::ONE, Function::Ramp { start: 0.4, end: 0.5 }] {
        assert_eq!(unseen(&f, 0.5, 0.7), None);
    }
}

/// Jumps and kinks of formulas, to the last digit.
#[test]
fn switches_of_formulas_are_found() {
    let at = |text: &str| formula(text).switches(2.0);
    assert_eq!(at("if(t < 0.7, t^2, 1)"), [0.7]);
    assert_eq!(at("(t >= 0.3)*(t < 0.302)"), [0.3, 0.302]);
    let close = |found: Vec<f64>, expected: &[f64]| {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
    };
    close(at("abs(t - 0.4) + max(t, 1.3)"), &[0.4, 1.3]);
    close(at("sign(sin(pi*t))*(t < 1.5)"), &[0.0, 1.0, 1.5]);
    close(at("min(1, 4*t^2)"), &[0.5]);
    close(at("if(t < 1, t^3, 1 + 3*(t - 1) + 2*(t - 1)^2)"), &[1.0]);
    for text in [
        "sin(t)",
        "exp(-((t - 1)/1e-9)^2)",
        "(1 + t)^2.5 + 1/(1 + t)",
        "ln(1 + t)",
        "sqrt(2 - t/3)",
        "if(t < 1, t^3, 1 + 3*(t - 1) + 3*(t - 1)^2)",
    ] {
        assert_eq!(at(text), Vec::<f64>::new(), "{text}");
    }
    // Either side of a jump has its own value.
    for text in ["if(t < 1/3, 0, 1)", "if(3*t - 1 > 0, 1, 0)", "if((t - 0.1)/7 <= 0.2, 0, 1)"] {
        let (f, found) = (formula(text), at(text));
        assert_eq!([f.value(found[0].next_down()), f.value(found[0])], [0.0, 1.0], "{text}");
    }
}

/// Steps of a fixed size end at kinks. The arc from kink to kink is unresolved, since its ends are zero; four steps per arc resolve it.
#[test]
fn arcs_between_kinks_are_unresolved() {
    let arcs = formula("abs(sin(100*pi*t))");
    for step in [0.01, 0.02, 0.013] {
        let found = arcs.unresolved_variation([0.0, 1.0], step).unwrap();
        assert!((found.deviation - 1.0).abs() < 0.05 && found.width < 0.01, "{step}: {found:?}");
    }
    assert_eq!(arcs.unresolved_variation([0.0, 1.0], 2.5e-3), None);
    for (steps, is_resolved) in [(2.0, false), (5.0, true)] {
        let sine = Function::Sine { frequency: 1.0, phase: 0.0 };
        let found = sine.unresolved_variation([0.0, 10.0], 1.0 / steps);
        assert_eq!(found.is_none(), is_resolved, "{steps} steps per period: {found:?}");
    }
    // A pulse between jumps is resolved, since steps end there.
    assert_eq!(formula("(t >= 0.3)*(t < 0.302)").unresolved_variation([0.0, 1.0], 0.1), None);
}

/// A pulse narrower than a step has the effect of a whole step if its peak is at the end of a step.
#[test]
fn pulses_at_ends_of_steps_are_unresolved() {
    let found = |text: &str| formula(text).unresolved_variation([0.0, 1.0], 0.01);
    for (text, at, width) in [
        ("exp(-((t - 0.5)/1e-3)^2)", 0.5, 1.665e-3),
        ("-exp(-((t - 0.5)/1e-4)^2)", 0.5, 1.665e-4),
        ("exp(-((t - 0.5)/3e-3)^2)", 0.5, 5.0e-3),
        ("exp(-((t - 0.5003)/1e-3)^2)", 0.5, 2.0e-3),
        ("3 - 2/(1 + ((t - 0.5)/1e-3)^2)", 0.5, 2e-3),
        ("if(t < 0.503, 0, exp(-(t - 0.503)/1e-4))", 0.503, 0.7e-4),
        ("if(t < 0.5, exp((t - 0.5)/1e-3), 0)", 0.5, 0.7e-3),
        ("exp(-t/1e-4)", 0.0, 0.7e-4),
    ] {
        let variation = found(text).unwrap_or_else(|| panic!("{text}"));
        assert!((variation.at - at).abs() < 1e-12, "{text}: {variation:?}");
        let ratio = variation.width / width;
        assert!(ratio > 0.5 && ratio < 2.0, "{text}: {variation:?}");
    }
    for text in [
        "exp(-((t - 0.5)/1e-2)^2)",
        "tanh((t - 0.503)/1e-4)",
        "tanh((t - 0.5)/1e-4)",
        "if(t < 0.503, 0, exp(-(t - 0.503)/2e-2))",
        "exp(-t/2e-2)",
        "max(0, 1 - abs(t - 0.5)/0.01)",
        "abs(sin(20*pi*t))",
    ] {
        assert_eq!(found(text), None, "{text}");
    }
}
