//! Functions of time: values, rates against differences, breaks, and formulas as they are written.

use std::collections::BTreeSet;
use std::f64::consts::PI;
use std::sync::{Arc, Mutex};

use ancf::function::{Expression, External, Function, Instant, Table};
use ancf::model::{At, Load, Place, TimeFunction, Varying, schema};
use ancf::{Model, Scales};
use proptest::prelude::*;
use serde_json::Value as Json;

fn formula(text: &str) -> Function {
    let formula = Expression::parse(text).unwrap_or_else(|error| panic!("{text}: {error}"));
    Function::Expression { formula: Arc::new(formula), unit: 1.0 }
}

/// e^(−t) sin 3t as a program computes it.
fn program() -> External {
    External::new(|t: f64| {
        let (decay, (sin, cos)) = ((-t).exp(), (3.0 * t).sin_cos());
        Instant {
            value: decay * sin,
            rate: decay * (3.0 * cos - sin),
            acceleration: decay * (-8.0 * sin - 6.0 * cos),
        }
    })
}

fn value(text: &str, t: f64) -> f64 {
    formula(text).value(t)
}

/// Everyday notation: a sign binds less than a power, numbers have exponents, calls nest.
#[test]
fn formulas_mean_what_they_say() {
    for (text, wanted) in [
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
        assert!((found - wanted).abs() < 1e-14 * wanted.abs().max(1.0), "{text}: {found}, not {wanted}");
    }
}

#[test]
fn what_is_no_formula_is_said_with_its_place() {
    for (text, at, wanted) in [
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
            Ok(_) => assert_eq!(wanted, "", "{text} is read"),
            Err(error) => {
                assert_eq!(error.at, at, "{text}: {error}");
                assert!(!wanted.is_empty() && error.wanted.starts_with(wanted), "{text}: {error}");
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
        Function::Table(Table::new([[0.0, 1.0], [1.0, 3.0], [1.0, -1.0], [2.5, 0.5]])),
        Function::Ramp { start: 0.5, end: 2.0 },
        Function::Step { at: 1.0, until: Some(2.0) },
        Function::Sine { frequency: 0.7, phase: 0.3 },
        Function::External { function: program(), unit: 1.3 },
        formula("0.4*(t^2/2 + (15/(2*pi))^2*(cos(2*pi*t/15) - 1))"),
        formula("if(t < 1, t^3, exp(-t)*sin(3*t)) + tanh(t)*sqrt(t + 1) - ln(t + 2)/atan(t + 0.1)"),
        formula("max(t, 2 - t) + min(t^2, 2) + abs(t - 0.7) + t^(t + 1) + (t - 9)^-3*asin(t/9)"),
    ]
}

#[test]
fn rates_are_those_of_the_values() {
    let h = 1e-3;
    for function in every_function() {
        let difference = |f: &dyn Fn(f64) -> f64, t: f64| {
            (8.0 * (f(t + h) - f(t - h)) - (f(t + 2.0 * h) - f(t - 2.0 * h))) / (12.0 * h)
        };
        for t in [0.2, 0.45, 0.88, 1.3, 1.7, 2.3, 3.1] {
            let Instant { value, rate, acceleration } = function.at(t);
            assert_eq!(value, function.value(t));
            let slope = difference(&|t| function.value(t), t);
            assert!(
                (rate - slope).abs() < 1e-8 * (1.0 + slope.abs()),
                "{function:?} at {t}: {rate}, {slope}"
            );
            let bend = difference(&|t| function.at(t).rate, t);
            assert!(
                (acceleration - bend).abs() < 1e-7 * (1.0 + bend.abs()),
                "{function:?} at {t}: {acceleration}, {bend}"
            );
        }
    }
}

/// Jumps and kinks belong to what follows; a float earlier there is what was before.
#[test]
fn breaks() {
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
    assert_eq!(table.at(1.75), Instant { value: -0.25, rate: 1.0, acceleration: 0.0 });
}

/// The spin-up of Simo & Vu-Quoc (1986): at rest at 0, at 15 s by 45 rad and 6 rad/s on, and no blow there.
#[test]
fn spin_up() {
    let text = "0.4*if(t < 15, t^2/2 + (15/(2*pi))^2*(cos(2*pi*t/15) - 1), 15*t - 112.5)";
    let function = formula(text);
    assert_eq!(function.at(0.0), Instant::default());
    let near = |a: Instant, b: [f64; 3]| {
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
        (number(), 0.1..2.0).prop_map(|(start, more)| Varying::Ramp { start, end: start + more }),
        (number(), 0.1..2.0).prop_map(|(at, more)| Varying::Step { at, until: Some(at + more) }),
        (0.0..3.0, number()).prop_map(|(frequency, phase)| Varying::Sine { frequency, phase }),
        (0.1..9.0).prop_map(|unit| Varying::Expression { text: "sin(t) + t^2".into(), unit }),
        (0.1..9.0).prop_map(|unit| {
            Varying::External { name: "program".into(), unit, supplied: Some(program()) }
        }),
    ]
}

/// Where the schema has functions of time, by the keys that lead there.
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

/// Whoever adds a function of time to the model adds it here, and sees whether it is supplied.
#[test]
fn functions_are_supplied_wherever_there_can_be_one() {
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
  {{ kind = "fluid", bodies = ["b"], density = 1, drag = [1, 1], {time} }},
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
    let waiting = |model: &Model| format!("{model:?}").matches("supplied: None").count();
    let schema = schema().to_value();
    let mut places = BTreeSet::new();
    places_of_functions(&schema, &schema, "", &mut places);
    assert_eq!(waiting(&model), places.len(), "{places:#?}");
    assert_eq!(model.check_supplies().unwrap_err().len(), places.len());
    assert!(model.supply("f", program()));
    assert_eq!(waiting(&model), 0);
    let scales = Scales { length: 2.0, time: 3.0, force: 4.0 };
    assert_eq!(waiting(&model.scaled(&scales)), 0);
    assert_eq!(model.scaled(&scales).scaled(&scales.inverse()), model);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// In other units a function is the same function: f*(t/T) = f(t), df*/dt* = T df/dt.
    #[test]
    fn units(varying in varying(), power in -4.0..4.0_f64, t in 0.0..3.0_f64) {
        let scales = Scales { length: 3.0, time: 10.0_f64.powf(power), force: 0.1 };
        let time = TimeFunction::Varying(varying);
        let mut model = Model::parse(include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/models/good/minimal.toml"))).unwrap();
        let on = Place::new("rod", At::Length(0.5));
        model.loads = vec![Load::Force { on, force: [1.0; 3], follower: false, time: time.clone() }];
        let scaled = model.scaled(&scales).loads[0].time().unwrap().compile().unwrap().at(t / scales.time);
        let own = time.compile().unwrap().at(t);
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-9 * (1.0 + b.abs());
        prop_assert!(near(scaled.value, own.value));
        prop_assert!(near(scaled.rate / scales.time, own.rate));
        prop_assert!(near(scaled.acceleration / scales.time.powi(2), own.acceleration));
    }

    /// No text makes the reader of formulas panic.
    #[test]
    fn any_text(text in "[-+*/^<>=(),.0-9a-fint ex\u{e9}]{0,60}") {
        if let Err(error) = Expression::parse(&text) {
            prop_assert!(error.at <= text.chars().count());
        }
    }
}

/// Of several threads that ask for one time, one calls the program.
#[test]
fn one_call_for_all_threads() {
    let calls = Arc::new(Mutex::new(0));
    let count = Arc::clone(&calls);
    let slow = External::new(move |t| {
        *count.lock().unwrap() += 1;
        std::thread::yield_now();
        Instant { value: t, ..Instant::default() }
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
