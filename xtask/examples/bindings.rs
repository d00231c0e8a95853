//! Writes a WebAssembly module and its JavaScript into a folder: `bindings MODULE FOLDER`. Called by `cargo xtask playground`.

use std::env;
use std::error::Error;

use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [module, folder] = arguments.as_slice() else {
        return Err("expected the module and the folder".into());
    };
    // Names of functions are a tenth of the transferred module.
    let mut bindings = Bindgen::new();
    bindings.input_path(module).web(true)?.typescript(false).remove_name_section(true);
    bindings.generate(folder)?;
    Ok(())
}
