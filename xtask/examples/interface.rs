//! Lists the public items in a description by rustdoc: `interface FILE`.

use std::io::{self, Write};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let file = std::env::args().nth(1).ok_or("expected the JSON file of rustdoc")?;
    let items = public_api::Builder::from_rustdoc_json(file)
        .omit_blanket_impls(true)
        .omit_auto_trait_impls(true)
        .omit_auto_derived_impls(true)
        .build()?;
    let mut output = io::stdout().lock();
    for item in items.items() {
        writeln!(output, "{item}")?;
    }
    Ok(())
}
