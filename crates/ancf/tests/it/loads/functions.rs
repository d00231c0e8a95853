//! Functions of time: values, rates against differences, breaks, parser of formulas.

use std::collections::BTreeSet;
use std::f64::consts::PI;
use std::sync::{Arc, Mutex};

use ancf::mechanics::functions::{Expression, ExternalFunction, Function, FunctionValue, TimeTable};
use ancf::model::{At, Load, Place, PointForce, TimeFunction, Varying};
use ancf::schema::schema;
use ancf::units::ScaleChoice;
use ancf::{Model, Scales};
use proptest::prelude::*;
use serde_json::Value as Json;

fn formula(text: &str) -> Function {
    let formula = Expression::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    Function::Expression { formula: Arc::new(formula), unit: 1.0 }
}

/// e^(−t) sin 3t as a function of a program.
fn external() -> ExternalFunction {
    ExternalFunction::new(|t: f64| {
        let (decay, (sin, cos)) = ((-t).exp(), (3.0 * t).sin_cos());
        FunctionValue {
            value: decay * sin,
            rate: decay * (3.0 * cos - sin),
            acceleration: decay * (-8.0 * sin - 6.0 * cos),
        }
    })
}

fn value(text: &str, t: f64) -> f64 {
    formula(text).value(t)
}

/// Precedence of signs and powers, exponents of numbers, nested calls.
#[test]
fn formulas_have_the_usual_precedence() {
    for (text, expected) in [
        ("-2^2", -4.0),
        ("(-2)^2", 4.0),
        ("2^-1", 0.5),
        ("2 * -3 ^ 2", -18.0),
        ("1e-3 + .5 + 2. + 1E1", 12.501),
        ("10 - 4 - 3", 3.0),
        ("8 / 4 / 2", 1.0),
        ("8 / 4 * 2", 4.0),
        ("1 + 2 * 3 < 8 - 0.5", 1.0),
        ("2 >= 3", 0.0),
        ("min(1, max(2, 3)) + max(min(1, 2), min(3, 4))", 4.0),
        ("if(2 < 3, 4, 1/0)", 4.0),
        ("abs(-2) + sign(-3) + sign(0)", 1.0),
        ("sin(pi/6)^2 + cos ( pi / 6 )^2", 1.0),
        ("exp(ln(5)) * sqrt(4)\n\t+ tan(atan(0.5))", 10.5),
        ("t^0 + t^3 + t^2.5 + 2^t", 1.0 + 64.0 + 32.0 + 16.0),
    ] {
        let found = value(text, 4.0);
        assert!(
            (found - expected).abs() < 1e-14 * expected.abs().max(1.0),
            "{text}: {found}, not {expected}"
        );
    }
}

#[test]
fn invalid_formulas_are_rejected_with_their_position() {
    for (text, at, expected) in [
        ("", 0, "a number"),
        ("2 +", 3, "a number"),
        ("2 3", 2, "an operator"),
        ("2(3)", 1, "an operator"),
        ("2^3^2", 3, "an operator or the end; powers of powers in brackets"),
        ("1 < t < 2", 6, "an operator"),
        ("--t", 1, "a number"),
        ("2 - -t", 7, ""),
        ("(1 + 2", 6, "`)`"),
        ("1 + 2)", 5, "an operator"),
        ("sin t", 0, "`t`, `pi` or a function"),
        ("tt + 1", 0, "`t`, `pi` or a function"),
        ("3*min(1)", 2, "one argument"),
        ("sin(1, 2)", 0, "one argument"),
        ("if(1, 2, 3, 4)", 10, "`)`"),
        (".", 0, "a finite number"),
        ("1e999", 0, "a finite number"),
        ("é", 0, "a number"),
        ("π*é", 0, "a number"),
        ("sin()", 4, "a number"),
        ("t = 2", 2, "an operator"),
    ] {
        match Expression::parse(text) {
            Ok(_) => assert_eq!(expected, "", "{text} is accepted"),
            Err(error) => {
                assert_eq!(error.at, at, "{text}: {error}");
                assert!(!expected.is_empty() && error.expected.starts_with(expected), "{text}: {error}");
            }
        }
    }
    let deep = |n| format!("{}t{}", "(".repeat(n), ")".repeat(n));
    assert!(Expression::parse(&deep(40)).is_ok() && Expression::parse(&deep(41)).is_err());
    let powers = format!("2{}", "^-2".repeat(300));
    assert!(Expression::parse(&powers).is_ok());
    assert!(Expression::parse(&format!("1{}", "+1".repeat(500))).is_err());
}

fn every_function() -> Vec<Function> {
    vec![
        Function::Constant(3.0),
        Function::Table(TimeTable::new([[0.0, 1.0], [1.0, 3.0], [1.0, -1.0], [2.5, 0.5]])),
        Function::Ramp { start: 0.5, end: 2.0 },
        Function::Step { at: 1.0, until: Some(2.0) },
        Function::Sine { frequency: 0.7, phase: 0.3 },
        Function::External { function: external(), unit: 1.3 },
        formula("0.4*(t^2/2 + (15/(2*pi))^2*(cos(2*pi*t/15) - 1))"),
        formula("if(t < 1, t^3, exp(-t)*sin(3*t)) + tanh(t)*sqrt(t + 1) - ln(t + 2)/atan(t + 0.1)"),
        formula("max(t, 2 - t) + min(t^2, 2) + abs(t - 0.7) + t^(t + 1) + (t - 9)^-3*asin(t/9)"),
    ]
}

#[test]
fn rates_are_derivatives_of_the_values() {
    let h = 1e-3;
    for function in every_function() {
        let difference = |f: &dyn Fn(f64) -> f64, t: f64| {
            (8.0 * (f(t + h) - f(t - h)) - (f(t + 2.0 * h) - f(t - 2.0 * h))) / (12.0 * h)
        };
        for t in [0.2, 0.45, 0.88, 1.3, 1.7, 2.3, 3.1] {
            let FunctionValue { value, rate, acceleration } = function.at(t);
            assert_eq!(value, function.value(t));
            let slope = difference(&|t| function.value(t), t);
            assert!(
                (rate - slope).abs() < 1e-8 * (1.0 + slope.abs()),
                "{function:?} at {t}: {rate}, {slope}"
            );
            let curvature = difference(&|t| function.at(t).rate, t);
            assert!(
                (acceleration - curvature).abs() < 1e-7 * (1.0 + curvature.abs()),
                "{function:?} at {t}: {acceleration}, {curvature}"
            );
        }
    }
}

/// At a break the function has its right-hand limit; one float earlier it has the left-hand limit.
#[test]
fn functions_have_right_hand_limits_at_breaks() {
    let [table, ramp, step] = [1, 2, 3].map(|i| every_function().swap_remove(i));
    assert_eq!(table.breaks(), [0.0, 1.0, 2.5]);
    assert_eq!(ramp.breaks(), [0.5, 2.0]);
    assert_eq!(step.breaks(), [1.0, 2.0]);
    assert_eq!(Function::Step { at: 1.0, until: None }.breaks(), [1.0]);
    let sides = |function: &Function, t: f64| [function.value(t.next_down()), function.value(t)];
    assert_eq!(sides(&step, 1.0), [0.0, 1.0]);
    assert_eq!(sides(&step, 2.0), [1.0, 0.0]);
    let [before, after] = sides(&table, 1.0);
    assert!((before - 3.0).abs() < 1e-14 && after == -1.0);
    assert_eq!([table.value(-5.0), table.value(9.0)], [1.0, 0.5]);
    assert_eq!([ramp.value(0.0), ramp.value(1.25), ramp.value(7.0)], [0.0, 0.5, 1.0]);
    assert_eq!(table.at(1.75), FunctionValue { value: -0.25, rate: 1.0, acceleration: 0.0 });
}

/// Spin-up of Simo & Vu-Quoc (1986): at rest at t = 0, at 15 s 45 rad and 6 rad/s without a velocity jump.
#[test]
fn spin_up_of_simo_and_vu_quoc_is_smooth() {
    let text = "0.4*if(t < 15, t^2/2 + (15/(2*pi))^2*(cos(2*pi*t/15) - 1), 15*t - 112.5)";
    let function = formula(text);
    assert_eq!(function.at(0.0), FunctionValue::default());
    let near = |a: FunctionValue, b: [f64; 3]| {
        let a = [a.value, a.rate, a.acceleration];
        a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12 * (1.0 + b.abs()))
    };
    assert!(near(function.at(15.0_f64.next_down()), [45.0, 6.0, 0.0]));
    assert!(near(function.at(15.0), [45.0, 6.0, 0.0]));
    assert!(near(function.at(7.5), [0.4 * (28.125 - 2.0 * (7.5 / PI).powi(2)), 3.0, 0.8]));
}

fn varying() -> impl Strategy<Value = Varying> {
    let number = || -3.0..3.0;
    prop_oneof![
        prop::collection::vec((0.0..2.0, number()), 1..5).prop_map(|mut points| {
            points.sort_by(|a, b| f64::total_cmp(&a.0, &b.0));
            let (times, values) = points.into_iter().unzip();
            Varying::Table { times, values }
        }),
        (number(), 0.1..2.0).prop_map(|(start, length)| Varying::Ramp { start, end: start + length }),
        (number(), 0.1..2.0).prop_map(|(at, length)| Varying::Step { at, until: Some(at + length) }),
        (0.0..3.0, number()).prop_map(|(frequency, phase)| Varying::Sine { frequency, phase }),
        (0.1..9.0).prop_map(|unit| Varying::Expression { text: "sin(t) + t^2".into(), unit }),
        (0.1..9.0).prop_map(|unit| {
            Varying::External { name: "program".into(), unit, supplied: Some(external()) }
        }),
    ]
}

/// Collects the paths of all functions of time in the schema.
fn places_of_functions(root: &Json, schema: &Json, path: &str, found: &mut BTreeSet<String>) {
    match schema {
        Json::Object(keys) => {
            if let Some(name) = keys.get("$ref").and_then(Json::as_str) {
                let name = name.trim_start_matches("#/$defs/");
                if name == "TimeFunction" {
                    found.insert(path.to_owned());
                } else {
                    places_of_functions(root, &root["$defs"][name], &format!("{path}/{name}"), found);
                }
            }
            for (key, inner) in keys.iter().filter(|(key, _)| *key != "$defs") {
                let tag = inner["properties"]["kind"]["const"].as_str().unwrap_or_default();
                places_of_functions(root, inner, &format!("{path}/{key}{tag}"), found);
            }
        }
        Json::Array(items) => {
            for item in items {
                let tag = item["properties"]["kind"]["const"].as_str().unwrap_or_default();
                places_of_functions(root, item, &format!("{path}/{tag}"), found);
            }
        }
        _ => {}
    }
}

/// New functions of time of the model are added here; the test checks that they can be supplied.
#[test]
fn functions_can_be_supplied_at_every_path_of_the_schema() {
    let time = "time = { kind = \"external\", name = \"f\" }";
    let (on, a) = ("on = { body = \"b\", at = \"end\" }", "name = \"j\", a = { body = \"b\", at = \"end\" }");
    let axis = "axis = [0, 0, 1]";
    let text = format!(
        r#"
loads = [
  {{ kind = "force", {on}, force = [0, 0, 1], {time} }},
  {{ kind = "moment", {on}, moment = [0, 0, 1], {time} }},
  {{ kind = "distributed_force", body = "b", force = [0, 0, 1], {time} }},
  {{ kind = "distributed_moment", body = "b", moment = [0, 0, 1], {time} }},
  {{ kind = "base_acceleration", acceleration = [0, 0, 1], {time} }},
  {{ kind = "base_rotation", angular_velocity = [0, 0, 1], {time} }},
  {{ kind = "fluid", bodies = ["b"], density = 1, drag = [1, 1], {time} }},
  {{ kind = "prestrain", body = "b", strain = 0.1, {time} }},
  {{ kind = "edge_force", body = "b", edge = "u_end", force = [0, 0, 1], {time} }},
  {{ kind = "edge_moment", body = "b", edge = "u_end", moment = [0, 0, 1], {time} }},
  {{ kind = "surface_force", body = "b", force = [0, 0, 1], {time} }},
  {{ kind = "surface_pressure", body = "b", pressure = 1, {time} }},
  {{ kind = "gas", name = "g", surfaces = [{{ body = "b" }}], pressure = 1, {time} }},
  {{ kind = "surface_prestrain", body = "b", strain = [0.1, 0, 0], {time} }},
  {{ kind = "surface_fluid", body = "b", density = 1, drag = [1, 1], {time} }},
]
joints = [
  {{ kind = "drive", {a}, {time} }},
  {{ kind = "distance", {a}, b = {{ point = [0, 0, 0] }}, {time} }},
  {{ kind = "revolute", {a}, {axis}, drive = {{ {time} }} }},
  {{ kind = "cylindrical", {a}, {axis}, drive = {{ {time} }}, feed = {{ {time} }} }},
  {{ kind = "prismatic", {a}, {axis}, drive = {{ {time} }} }},
  {{ kind = "slide", {a}, b = {{ body = "b", at = 0 }}, drive = {{ {time} }} }},
]
bodies = []
analysis = {{ kind = "dynamics", duration = 1, step = 1 }}
"#
    );
    let mut model: Model = toml::from_str(&text).unwrap();
    model.scales = ScaleChoice::None;
    let missing = |model: &Model| format!("{model:?}").matches("supplied: None").count();
    let schema = schema().to_value();
    let mut places = BTreeSet::new();
    places_of_functions(&schema, &schema, "", &mut places);
    assert_eq!(missing(&model), places.len(), "{places:#?}");
    assert_eq!(model.check_supplies().unwrap_err().len(), places.len());
    assert!(model.supply("f", external()));
    assert_eq!(missing(&model), 0);
    let scales = Scales { length: 2.0, time: 3.0, force: 4.0 };
    assert_eq!(missing(&model.scaled(&scales)), 0);
    assert_eq!(model.scaled(&scales).scaled(&scales.inverse()), model);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Scaled functions: f*(t/T) = f(t), df*/dt* = T df/dt.
    #[test]
    fn scaled_functions_have_scaled_rates(varying in varying(), power in -4.0..4.0_f64, t in 0.0..3.0_f64) {
        let scales = Scales { length: 3.0, time: 10.0_f64.powf(power), force: 0.1 };
        let time = TimeFunction::Varying(varying);
        let mut model = Model::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/good/minimal.toml"))).unwrap();
        let on = Place::new("rod", At::Length(0.5));
        model.loads = vec![Load::Force(PointForce { on, force: [1.0; 3], follower: false, time: time.clone() })];
        let scaled = model.scaled(&scales).loads[0].time().unwrap().compile().unwrap().at(t / scales.time);
        let own = time.compile().unwrap().at(t);
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * (1.0 + b.abs());
        prop_assert!(near(scaled.value, own.value));
        prop_assert!(near(scaled.rate / scales.time, own.rate));
        prop_assert!(near(scaled.acceleration / scales.time.powi(2), own.acceleration));
    }

    /// The parser returns an error inside the text and does not panic.
    #[test]
    fn parser_does_not_panic(text in "[-+*/^<>=(),.0-9a-fint ex\u{e9}]{0,60}") {
        if let Err(error) = Expression::parse(&text) {
            prop_assert!(error.at <= text.chars().count());
        }
    }
}

/// Integrals start at t = 0 with the value 0.
#[test]
fn the_rate_of_an_integral_is_the_function() {
    let table = |points: &[[f64; 2]]| Function::Table(TimeTable::new(points.iter().copied()));
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
        let integral = function.clone().integral().expect("the function has an integral in closed form");
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

/// Of several threads that evaluate one instant, one calls the function of the program.
#[test]
fn threads_share_one_call_per_instant() {
    let calls = Arc::new(Mutex::new(0));
    let count = Arc::clone(&calls);
    let slow = ExternalFunction::new(move |t| {
        *count.lock().unwrap() += 1;
        std::thread::yield_now();
        FunctionValue { value: t, ..FunctionValue::default() }
    });
    for t in 1..=20 {
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| assert_eq!(slow.at(f64::from(t)).value, f64::from(t)));
            }
        });
        assert_eq!(*calls.lock().unwrap(), t);
    }
}
