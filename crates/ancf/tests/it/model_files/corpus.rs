//! Replay of the corpora of the fuzz targets (`fuzz/`).

use std::fs;
use std::path::Path;

use crate::common::anything;

fn replay(target: &str, what: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus").join(target);
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    assert!(!files.is_empty());
    for file in files {
        let bytes = fs::read(&file).unwrap();
        let result = std::panic::catch_unwind(|| what(&bytes));
        assert!(result.is_ok(), "{} panics", file.display());
    }
}

#[test]
fn model_corpus_is_replayed() {
    replay("model", anything::model);
}

#[test]
fn expression_corpus_is_replayed() {
    replay("expression", anything::expression);
}

/// Formulas have bounded length and depth; large exponents are accepted.
#[test]
fn formulas_have_bounded_length_and_depth() {
    let deep = |n: usize| format!("{}t{}", "(".repeat(n), ")".repeat(n));
    let signs = |n: usize| format!("{}t", "-(".repeat(n));
    let calls = |n: usize| format!("{}t{}", "sin(".repeat(n), ")".repeat(n));
    for text in [
        deep(100_000),
        signs(100_000),
        calls(400),
        "t^".repeat(500) + "t",
        "1e".to_owned() + &"9".repeat(900),
    ] {
        assert!(ancf::mechanics::functions::Expression::parse(&text).is_err(), "{}", &text[..20]);
    }
    for text in
        [deep(40), "t+".repeat(499) + "t", "(((t^1e308)^1e308)^1e308)".into(), "exp(exp(exp(1e308)))".into()]
    {
        anything::expression(text.as_bytes());
        assert!(ancf::mechanics::functions::Expression::parse(&text).is_ok(), "{text}");
    }
}
