//! The committed header agrees with the source.

use std::fs;
use std::path::Path;

/// With the variable `ANCF_HEADER` the header is written.
#[test]
fn header_is_that_of_the_source() {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_root_or_default(own);
    let mut sources: Vec<_> = fs::read_dir(own.join("src"))
        .expect("the folder of the sources")
        .map(|entry| entry.expect("a file").path())
        // The modules that it declares are read one by one.
        .filter(|path| !path.ends_with("lib.rs"))
        .collect();
    sources.sort();
    let builder = sources.iter().fold(cbindgen::Builder::new(), |builder, source| builder.with_src(source));
    let mut text = Vec::new();
    builder.with_config(config).generate().expect("the source has a header").write(&mut text);
    let text = String::from_utf8(text).expect("the header is a text").replace("# Safety", "Conditions:");
    let path = own.join("include/ancf.h");
    if std::env::var_os("ANCF_HEADER").is_some() {
        fs::write(&path, &text).expect("the header can be written");
    }
    let committed = fs::read_to_string(&path).unwrap_or_default();
    assert!(committed == text, "run: ANCF_HEADER=1 cargo test -p ancf-c --test it header");
}
