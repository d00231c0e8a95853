use std::collections::BTreeSet;
use std::fs::File;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{self, BufWriter, Write};
use std::path::Path;

use ancf::units::{Dimension, UnitQuantity, Units};
use ancf::{InputUse, Model, ModelError, ModelErrors, Stepper};
use flate2::Compression;
use flate2::write::DeflateEncoder;
use rawzip::{CompressionMethod, ZipArchiveWriter};
use toml::Value;

use super::description::{Description, IDENTIFIER};
use super::library;
use super::options::{ExportError, Options};
use super::parameters::parameters;
use super::units::{Unit, unit_of};
use crate::interface::{INTERFACE, Input, Interface, MODEL, model_with};

/// Contents of an FMU that was written.
#[derive(Clone, Debug, PartialEq)]
pub struct Exported {
    /// Names of the inputs.
    pub inputs: Vec<String>,
    /// Paths and values of the parameters.
    pub parameters: Vec<(String, f64)>,
    /// Number of outputs.
    pub outputs: usize,
    /// True if the FMU provides directional derivatives.
    pub has_derivatives: bool,
    /// Warnings of the model.
    pub warnings: Vec<String>,
}

/// Writes a model file as an FMU.
///
/// # Errors
/// If the model cannot be advanced step by step, an option is not valid, or the file cannot be written.
pub fn export(text: &str, options: &Options, file: &Path) -> Result<Exported, ExportError> {
    let model = Model::parse(text)?;
    if let Some(folder) = model.starts_from() {
        let found = format!("the results folder {folder:?}");
        let error = ModelError::new("initial.from", found, "\"undeformed\" or \"equilibrium\" in an FMU");
        return Err(ModelErrors(vec![error]).into());
    }
    let mut data: Value = toml::from_str(text)
        .map_err(|error| ModelErrors(vec![ModelError::new("", error.to_string(), "a model file")]))?;
    let parameters = parameters(&mut data, options.parameters)?;
    let inputs = model.inputs.iter().map(|one| Input { name: one.name.clone(), start: one.value });
    let mut interface =
        Interface { token: String::new(), inputs: inputs.collect(), parameters, outputs: Vec::new() };
    let values: Vec<f64> = interface.parameters.iter().map(|one| one.start).collect();
    let input_values: Vec<f64> = interface.inputs.iter().map(|one| one.start).collect();
    // The parameters as real numbers must be valid.
    let model = model_with(&data, &interface, &values, &input_values)?;
    let stepper = Stepper::new(&model)?;
    let columns: Vec<_> = stepper.columns().into_iter().skip(1).collect();
    interface.outputs = columns.iter().map(|column| column.name.clone()).collect();
    check_names(&interface)?;
    let bytes = library::read(options.library)?;
    interface.token = token(text, &interface);

    let settings = model.analysis.dynamics();
    let words = Units::in_words();
    let meaning = |column: &ancf::Column| match column.unit(&words) {
        Some(unit) if unit != "1" => format!("Column of the run, unit {unit}"),
        _ => "Column of the run".to_owned(),
    };
    let is_load = |input: &Input| stepper.input_use(&input.name).is_ok_and(|one| one == InputUse::Load);
    let description = Description {
        name: options.name,
        title: model.title.as_deref(),
        time: time_unit(model.units.as_ref()),
        outputs: columns.iter().map(|one| (unit_of(one, model.units.as_ref()), meaning(one))).collect(),
        duration: settings.map_or(1.0, |own| own.duration),
        step: settings.and_then(|own| own.step.fixed()),
        has_derivatives: !interface.inputs.is_empty() && interface.inputs.iter().all(is_load),
        interface: &interface,
    };
    let files = [
        ("modelDescription.xml".to_owned(), description.document(options.version)?),
        (format!("resources/{MODEL}"), text.as_bytes().to_vec()),
        (
            format!("resources/{INTERFACE}"),
            toml::to_string(&interface).map_err(io::Error::other)?.into_bytes(),
        ),
        (library::path_in(options.version, IDENTIFIER), bytes),
    ];
    let mut writer = BufWriter::new(File::create(file)?);
    write(&mut writer, &files).map_err(io::Error::other)?;
    writer.flush()?;
    Ok(Exported {
        outputs: interface.outputs.len(),
        has_derivatives: description.has_derivatives,
        warnings: stepper.summary().warnings,
        inputs: interface.inputs.into_iter().map(|one| one.name).collect(),
        parameters: interface.parameters.into_iter().map(|one| (one.path, one.start)).collect(),
    })
}

fn time_unit(units: Option<&Units>) -> Option<Unit> {
    let column = ancf::Column {
        name: String::new(),
        dimension: Some(Dimension::new(0, 1, 0)),
        quantity: UnitQuantity::Other,
    };
    unit_of(&column, units)
}

fn check_names(interface: &Interface) -> Result<(), ExportError> {
    let mut known = BTreeSet::new();
    match interface.variables().map(|variable| interface.name(variable)).find(|name| !known.insert(*name)) {
        Some(twice) => Err(ExportError::Name(twice.to_owned())),
        None => Ok(()),
    }
}

/// Token in the form of an UUID, which differs between models and variables.
fn token(text: &str, interface: &Interface) -> String {
    let hash = |first: u8| {
        let mut hasher = DefaultHasher::new();
        (first, text, env!("CARGO_PKG_VERSION"), &interface.outputs).hash(&mut hasher);
        for parameter in &interface.parameters {
            (&parameter.path, parameter.start.to_bits()).hash(&mut hasher);
        }
        hasher.finish()
    };
    let digits = format!("{:016x}{:016x}", hash(0), hash(1));
    let (a, b, c) = (&digits[..8], &digits[8..12], &digits[12..16]);
    format!("{{{a}-{b}-{c}-{}-{}}}", &digits[16..20], &digits[20..])
}

/// Writes an archive of files with their paths.
fn write(to: impl Write, files: &[(String, Vec<u8>)]) -> Result<(), rawzip::Error> {
    let mut archive = ZipArchiveWriter::new(to);
    for (path, bytes) in files {
        let file = archive.new_file(path.as_str()).compression_method(CompressionMethod::DEFLATE);
        let (mut entry, config) = file.unix_permissions(0o755).start()?;
        let mut writer = config.wrap(DeflateEncoder::new(&mut entry, Compression::default()));
        writer.write_all(bytes)?;
        let (encoder, descriptor) = writer.finish()?;
        encoder.finish()?;
        entry.finish(descriptor)?;
    }
    archive.finish()?;
    Ok(())
}
