//! Developer tasks of the workspace. `cargo xtask test` runs all tests.

mod commands;
mod documents;
mod layers;
mod packages;
mod python;
mod system;
mod trials;

use std::env;
use std::process::ExitCode;

use commands::release::{dry_run, platforms};
use commands::{
    benchmark, dependencies, fuzz, hunt, importers, package, pictures, playground, schema, test, viewer,
};
use packages::interface;
use system::shell::say;

const HELP: &str = "\
cargo xtask test            all tests: format, layers, lints, tests, documentation, instruction counts, dependencies,
                            the viewer in a browser, Python, FMUs in importers
cargo xtask layers          module structure by layers.toml: folders, imports, cycles, sizes; --tree PATH, --root DIR
cargo xtask python          the Python package alone: installed, checked, tested, its site built
cargo xtask wheel           the wheel with the program inside, tried in an empty environment
cargo xtask fmi             FMUs in FMPy, Ecos and libcosim: validated, compared with own runs
cargo xtask docs            the documentation site, into target/site
cargo xtask schema          docs/model.schema.json, the Python classes and the key tables of the documentation, after a
                            change of the model types
cargo xtask viewer          the viewer of results, built into the crate that embeds it
cargo xtask playground      the page that runs models in the browser, into target/playground
cargo xtask pictures        the pictures of the documentation, recorded from models/ in the viewer
cargo xtask deny            licences, sources, duplicates and known vulnerabilities of dependencies, by deny.toml
cargo xtask fuzz [SECONDS]  random input for the readers of models and formulas, 600 s each by default
cargo xtask hunt [SEED] [N] random models beside their twins in other frames, units, orders; FOLDER as third argument keeps
                            the findings, SHARE of the laws as fourth; file FILE, show SEED NUMBER, one SEED NUMBER
cargo xtask bench           times per element beside their targets; --quick, --rows TEXT, --json FILE
cargo xtask instructions    instruction counts of fixed work beside the recorded ones; --update records them
cargo xtask release --dry-run
                            all packages, each tried from its package alone, with check sums and bill of materials, into
                            target/packages; --profile NAME, --only PART,... of: interface, crates, program, wheel, musl,
                            windows, container, materials
cargo xtask windows         the program for Windows, tried in Wine; --profile NAME
cargo xtask musl            the static program for Linux, tried; --profile NAME
cargo xtask try FILE        the trials of a program that exists, one of Windows in Wine; a second argument is the folder of an
                            earlier trial, for comparison; --quick before FILE shortens motions
cargo xtask arm             the kernels on ARM, tested in an emulator
cargo xtask interface       public items of the libraries beside the recorded ones; --update records them
cargo xtask peers           EXUDYN and MuJoCo beside ancf, into bench/peers/results; rods or structures selects a part;
                            needs Python and the network
";

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let (command, options) =
        arguments.split_first().map_or(("", &[][..]), |(command, rest)| (command.as_str(), rest));
    let done = match command {
        "test" => test::all(),
        "layers" => layers::check(options),
        "python" => package::test(),
        "wheel" => package::wheel(),
        "fmi" => importers::test(),
        "docs" => package::docs(),
        "schema" => schema::refresh(),
        "deny" => dependencies::deny(),
        "fuzz" => fuzz::fuzz(options),
        "hunt" => hunt::hunt(options),
        "bench" => benchmark::bench(options),
        "instructions" => benchmark::instructions(options),
        "viewer" => viewer::build(),
        "playground" => playground::build(),
        "pictures" => pictures::record(),
        "release" => dry_run::all(options),
        "windows" => platforms::windows(options),
        "musl" => platforms::musl(options),
        "try" => platforms::try_file(options),
        "arm" => platforms::arm(),
        "interface" => interface::check(options),
        "peers" => benchmark::peers(options),
        "" => Err(format!("expected a command\n\n{HELP}")),
        unknown => Err(format!("unknown command `{unknown}`\n\n{HELP}")),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            say(&why);
            ExitCode::FAILURE
        }
    }
}
