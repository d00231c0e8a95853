//! Mesh files of shear-deformable shells, one file for each format.
//!
//! [`Model::read_text`](crate::Model::read_text) replaces the path of a mesh file by the text of the file, so that the text of a model
//! contains all of its data. Reading of the text replaces the text of the mesh by lists of nodes, elements and groups.

mod file_mesh;
mod gmsh;
mod vtk;
mod vtk_legacy;
mod vtk_piece;
mod vtk_xml;

use std::fs;
use std::io::Read;
use std::path::Path;

use toml::{Table, Value};

use self::file_mesh::{FileMesh, MeshGroup};
use crate::errors::{Finding, ModelError, ModelErrors, finding, quoted};
use crate::schema::{Document, position};

/// First words of lists.
const LISTS: &str = "nodes = [";
/// Maximum size of a mesh file in bytes.
const MAX_BYTES: u64 = 100_000_000;

/// Meshes of the bodies of some data, with their paths.
fn meshes(data: &mut Table) -> impl Iterator<Item = (String, &mut Table)> {
    let bodies = data.get_mut("bodies").and_then(Value::as_array_mut).into_iter().flatten();
    bodies.enumerate().filter_map(|(i, body)| {
        let mesh = body.get_mut("mesh").and_then(Value::as_table_mut)?;
        Some((format!("bodies[{i}].mesh"), mesh))
    })
}

/// Replaces the paths of mesh files in the text of a model by the texts of the files. Lines keep their numbers.
///
/// # Errors
/// One error for each file that cannot be read.
pub(super) fn embed_meshes(mut text: String, folder: &Path) -> Result<String, ModelErrors> {
    if !["mesh", "file"].iter().all(|word| text.contains(word)) {
        return Ok(text);
    }
    let mut document = Document::parse(&text);
    let mut data = std::mem::take(&mut document.data);
    let (mut errors, mut replaced) = (Vec::new(), Vec::new());
    for (path, mesh) in meshes(&mut data) {
        let Some(read) = mesh_file(&path, mesh, folder) else { continue };
        let bytes = document.find(&format!("{path}.file"), false);
        match read {
            Ok(content) => replaced.push((bytes, content)),
            Err(error) => errors.push(ModelError { at: Some(position(&text, bytes)), ..error }),
        }
    }
    if !errors.is_empty() {
        return Err(ModelErrors(errors));
    }
    // The last one first, so that the places of the others stay valid.
    replaced.sort_by_key(|(bytes, _)| std::cmp::Reverse(bytes.start));
    for (bytes, mesh) in replaced {
        text.replace_range(bytes, &in_a_line(&mesh));
    }
    Ok(text)
}

/// Replaces the paths of mesh files in the data of a model by the contents of the files, relative to a folder.
///
/// # Errors
/// One error for each file that cannot be read.
pub fn embed_mesh_files(data: &mut Value, folder: &Path) -> Result<(), ModelErrors> {
    let mut errors = Vec::new();
    for (path, mesh) in data.as_table_mut().into_iter().flat_map(meshes) {
        match mesh_file(&path, mesh, folder) {
            Some(Ok(content)) => _ = mesh.insert("file".into(), Value::String(content)),
            Some(Err(error)) => errors.push(error),
            None => {}
        }
    }
    if errors.is_empty() { Ok(()) } else { Err(ModelErrors(errors)) }
}

/// Reads the file of a mesh with a path in a model. `None` for a mesh without one.
fn mesh_file(path: &str, mesh: &Table, folder: &Path) -> Option<Result<String, ModelError>> {
    let file = mesh.get("file")?.as_str().filter(|file| !is_content(file))?;
    Some(read(&folder.join(file)).map_err(|found| {
        let found = format!("{}: {found}", quoted(file));
        ModelError::new(format!("{path}.file"), found, "a mesh file of Gmsh as text or of VTK")
    }))
}

/// Returns true for the content of a mesh file in place of its path.
fn is_content(file: &str) -> bool {
    file.starts_with(gmsh::START) || file.starts_with(LISTS)
}

/// Returns the content of a mesh file: the text of a file of Gmsh, or the lists of a file of VTK as TOML. Errors are descriptions of what
/// was found.
fn read(path: &Path) -> Result<String, String> {
    let file = fs::File::open(path).map_err(|error| error.to_string())?;
    let mut bytes = Vec::new();
    file.take(MAX_BYTES + 1).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err("more than 100 MB".into());
    }
    if let Some(start) = gmsh::start(&bytes) {
        return String::from_utf8(bytes.split_off(start))
            .map_err(|_| "a binary file; export it as text (in Gmsh: Mesh.Binary = 0)".into());
    }
    if vtk::is_vtk(&bytes) {
        let mesh = vtk::parse(&bytes)?;
        return toml::to_string(&mesh).map_err(|error| error.to_string());
    }
    Err(format!("a file that starts neither with {} nor as a file of VTK", gmsh::START))
}

/// Returns the mesh of the content of a file.
fn parse(content: &str) -> Result<FileMesh, String> {
    if content.starts_with(gmsh::START) {
        gmsh::parse(content)
    } else {
        toml::from_str(content).map_err(|error| error.to_string())
    }
}

/// Basic string of TOML in one line.
fn in_a_line(text: &str) -> String {
    let mut line = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => line.push_str("\\\""),
            '\\' => line.push_str("\\\\"),
            '\n' => line.push_str("\\n"),
            '\t' => line.push_str("\\t"),
            '\r' => line.push_str("\\r"),
            c if c.is_control() => line.push_str(&format!("\\u{:04X}", u32::from(c))),
            c => line.push(c),
        }
    }
    line + "\""
}

/// Replaces the texts of mesh files in the data of a model by lists. Returns findings about meshes that cannot be read.
pub(super) fn read_meshes(data: &mut Value) -> Vec<Finding> {
    let Some(data) = data.as_table_mut() else { return Vec::new() };
    let mut findings = Vec::new();
    for (path, mesh) in meshes(data) {
        let text = match mesh.get("file") {
            Some(Value::String(text)) if is_content(text) => text.clone(),
            _ => continue,
        };
        if let Some(key) =
            ["nodes", "elements", "directors", "groups"].into_iter().find(|key| mesh.contains_key(*key))
        {
            let expected = "no lists: the mesh is that of the file";
            findings.push(finding(format!("{path}.{key}"), "a list and a file", expected));
            continue;
        }
        let scale = match mesh.get("scale") {
            None => 1.0,
            Some(Value::Integer(scale)) => *scale as f64,
            Some(Value::Float(scale)) => *scale,
            Some(_) => continue,
        };
        if scale <= 0.0 || !scale.is_finite() {
            findings.push(finding(format!("{path}.scale"), scale.to_string(), "a number above 0"));
            continue;
        }
        match parse(&text) {
            Ok(read) => {
                mesh.remove("scale");
                mesh.remove("file");
                mesh.extend(lists(read, scale));
            }
            Err(found) => {
                let expected =
                    "a mesh of quadrilaterals and triangles, of Gmsh in version 2.2 or 4.1 or of VTK";
                findings.push(finding(format!("{path}.file"), found, expected));
            }
        }
    }
    findings
}

/// Lists of a mesh as data of a model.
fn lists(mesh: FileMesh, scale: f64) -> Table {
    let numbers = |all: Vec<usize>| Value::Array(all.into_iter().map(|k| Value::Integer(k as i64)).collect());
    let nodes = mesh
        .nodes
        .into_iter()
        .map(|node| Value::Array(node.iter().map(|x| Value::Float(x * scale)).collect()));
    let elements = mesh.elements.into_iter().map(numbers);
    let group = |group: MeshGroup| {
        let (key, value) = match group {
            MeshGroup::Nodes(nodes) => ("nodes", numbers(nodes)),
            MeshGroup::Edges(chains) => ("edges", Value::Array(chains.into_iter().map(numbers).collect())),
            MeshGroup::Elements(elements) => ("elements", numbers(elements)),
        };
        Value::Table(Table::from_iter([(key.to_owned(), value)]))
    };
    let groups: Table = mesh.groups.into_iter().map(|(name, own)| (name, group(own))).collect();
    let mut lists = Table::from_iter([
        ("nodes".to_owned(), Value::Array(nodes.collect())),
        ("elements".to_owned(), Value::Array(elements.collect())),
    ]);
    if !groups.is_empty() {
        lists.insert("groups".to_owned(), Value::Table(groups));
    }
    lists
}
