//! Model files: valid ones are read, invalid ones are rejected with the messages in their comments.

use std::fs;
use std::path::{Path, PathBuf};

use ancf::Model;
use ancf::model::{Body, ModelError, ScaleChoice, Scheme, Step};
use ancf::reading::AnalysisSequence;
use ancf::schema::schema_text;
use proptest::prelude::*;

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models").join(name)
}

fn files(name: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder(name))
        .expect("the folder exists")
        .map(|entry| entry.expect("the entry is readable").path());
    let mut files: Vec<_> =
        entries.filter(|path| path.extension().is_some_and(|end| end == "toml")).collect();
    files.sort();
    assert!(!files.is_empty());
    files
}

fn texts(errors: &[ModelError]) -> Vec<String> {
    errors.iter().map(ToString::to_string).collect()
}

#[test]
fn valid_models_are_read_and_printed() {
    for path in files("good") {
        let model =
            Model::read(&path).unwrap_or_else(|errors| panic!("{}: {:#?}", path.display(), texts(&errors)));
        model.check().unwrap_or_else(|errors| panic!("{}: {:#?}", path.display(), texts(&errors)));
        let printed = toml::to_string(&model).unwrap();
        assert_eq!(Model::parse(&printed).unwrap(), model, "{}: printed model differs", path.display());
    }
}

/// Every TOML block of `docs/model-file.md` and of the pages in `docs/model-file` is a complete model, or a sequence of analyses.
#[test]
fn examples_of_the_manual_are_valid() {
    let overview = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/model-file.md");
    let sections = fs::read_dir(overview.with_extension("")).expect("the folder of the sections");
    let pages = sections.map(|entry| entry.expect("the entry is readable").path()).chain([overview]);
    let mut number = 0;
    for page in pages {
        let text = fs::read_to_string(page).unwrap().replace("\r\n", "\n");
        for block in text.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()) {
            let read = AnalysisSequence::parse(block).and_then(|sequence| match sequence {
                Some(_) => Ok(()),
                None => Model::parse(block).map(|_| ()),
            });
            read.unwrap_or_else(|errors| panic!("{:#?}\n{block}", texts(&errors)));
            number += 1;
        }
    }
    assert!(number >= 13, "the manual has {number} models");
}

#[test]
fn invalid_models_are_rejected_with_their_messages() {
    let mut wrong = Vec::new();
    for path in files("bad") {
        let text = String::from_utf8_lossy(&fs::read(&path).unwrap()).into_owned();
        let expected: Vec<_> = text.lines().filter_map(|line| line.strip_prefix("#! ")).collect();
        let found = texts(&Model::read(&path).map(|_| ()).expect_err("the model is invalid"));
        if found != expected {
            let lines: String = found.iter().map(|line| format!("#! {line}\n")).collect();
            wrong.push(format!("{}: expected the messages\n{lines}", path.display()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn unreadable_files_are_reported() {
    let messages = |path: &Path| texts(&Model::read(path).expect_err("this is no model"));
    assert_eq!(messages(&folder("no.toml")), ["no such file"]);
    assert_eq!(messages(&folder("good")), ["a directory, not a model file"]);
    assert_eq!(Model::parse("").expect_err("this is no model").len(), 2, "one error per required key");
}

#[test]
fn line_ends_and_byte_order_marks_do_not_change_positions() {
    for path in files("bad").iter().filter(|path| !path.ends_with("not_utf8.toml")) {
        let text = fs::read_to_string(path).unwrap();
        let messages = |text: &str| texts(&Model::parse(text).expect_err("the model is invalid"));
        assert_eq!(messages(&text.replace('\n', "\r\n")), messages(&text), "{}", path.display());
        assert_eq!(messages(&format!("\u{feff}{text}")), messages(&text), "{}", path.display());
    }
}

/// Models built in Rust are rejected with the messages of files, without positions.
#[test]
fn models_built_in_rust_are_checked() {
    let mut model = Model::read(folder("good/every_key.toml")).unwrap();
    model.gravity[2] = f64::NEG_INFINITY;
    let dynamics = model.analysis.dynamics_mut().unwrap();
    (dynamics.step, dynamics.scheme) = (Step::Fixed(-0.5), Scheme::CentralDifference);
    model.scales = ScaleChoice::Given { length: 1.0, force: 1.0, time: Some(f64::NAN) };
    let Body::Beam(beam) = &mut model.bodies[1] else { panic!("the body is a beam") };
    beam.material = "soft ruber".into();
    beam.elements = 0;
    model.probes[0].name.clear();
    let mut found = texts(&model.check().expect_err("the model is invalid"));
    found.sort();
    let expected = [
        "analysis.scheme: found \"central_difference\", which has β = 0, expected β > 0, as in \
         \"average_acceleration\" or \"adams\" (an explicit scheme leaves the reactions of joints undetermined, \
         since their rows β h² Φ_q vanish)",
        "analysis.step: found -0.5, expected a number > 0",
        "bodies[1].elements: found 0, expected an integer >= 1",
        "bodies[1].material: found \"soft ruber\", expected the name of a material: \"soft rubber\" or \
         \"steel\" (did you mean \"soft rubber\"?)",
        "gravity[2]: found -inf, expected a finite number",
        "probes[0].name: found \"\", expected a text that is not empty",
        "scales.time: found nan, expected a finite number > 0",
    ];
    assert_eq!(found, expected);
}

/// `docs/model.schema.json` equals the schema of the types.
#[test]
fn schema_file_is_up_to_date() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/model.schema.json");
    let text = fs::read_to_string(path).unwrap_or_default();
    let found: serde_json::Value = serde_json::from_str(&text).unwrap_or_default();
    assert!(
        found == serde_json::from_str::<serde_json::Value>(&schema_text()).unwrap(),
        "docs/model.schema.json is out of date: update it by `cargo xtask schema`"
    );
}

/// Typing error: a number of characters is replaced at some position.
fn typing_error() -> impl Strategy<Value = (prop::sample::Index, usize, String)> {
    let pieces = [
        "", "", "[", "]", "{", "}", "\"", "'''", "=", ",", ".", "\n", "#", "-", "e9", "nan", "é", "\u{0}",
        "[[", "x",
    ];
    (any::<prop::sample::Index>(), 0_usize..20, prop::sample::select(pieces.map(String::from).to_vec()))
}

proptest! {
    /// Damaged files are valid models or rejected with positions inside the text.
    #[test]
    fn parser_does_not_panic(
        file in any::<prop::sample::Index>(),
        typing_errors in prop::collection::vec(typing_error(), 1..6),
        keep in prop::option::weighted(0.2, any::<prop::sample::Index>()),
    ) {
        let files = [files("good"), files("bad")].concat();
        let bytes = fs::read(file.get(&files)).unwrap();
        let mut text: Vec<char> = String::from_utf8_lossy(&bytes).chars().collect();
        if let Some(keep) = keep {
            text.truncate(keep.index(text.len() + 1));
        }
        for (at, count, piece) in typing_errors {
            let at = at.index(text.len() + 1);
            let end = text.len().min(at + count);
            text.splice(at..end, piece.chars());
        }
        let text: String = text.into_iter().collect();
        match Model::parse(&text) {
            Ok(model) => prop_assert_eq!(model.check(), Ok(())),
            Err(errors) => for error in errors {
                let at = error.at.clone().expect("errors of a text have a position");
                let inside = text.get(at.bytes).is_some() && at.line <= text.matches('\n').count() + 1;
                prop_assert!(inside, "{error}");
            },
        }
    }
}
