//! Legacy files of VTK.

use std::panic::{AssertUnwindSafe, catch_unwind};

use vtkio::Vtk;
use vtkio::model::{Attribute, DataSet, IOBuffer, Piece, ScalarType, VertexNumbers};

use super::vtk_piece::{Labels, VtkPiece, kinds, lists};

/// Start of a legacy file.
const LEGACY: &[u8] = b"# vtk";

/// Returns true for the start of a legacy file.
pub(super) fn is_legacy(bytes: &[u8]) -> bool {
    bytes.starts_with(LEGACY)
}

/// Reads an unstructured grid or polygons.
pub(super) fn read(bytes: &[u8]) -> Result<Vec<VtkPiece>, String> {
    let read = || Vtk::parse_legacy_be(&with_known_types(bytes)[..]);
    let data = match catch_unwind(AssertUnwindSafe(read)) {
        Ok(Ok(file)) => file.data,
        Ok(Err(error)) => return Err(error.to_string()),
        Err(_) => return Err("its data do not fit together".into()),
    };
    let mut all = Vec::new();
    match data {
        DataSet::UnstructuredGrid { pieces, .. } => {
            for piece in pieces {
                let Piece::Inline(piece) = piece else { continue };
                let lists = cells(&piece.cells.cell_verts)?;
                if lists.len() != piece.cells.types.len() {
                    return Err(format!("{} cells with {} types", lists.len(), piece.cells.types.len()));
                }
                let types = piece.cells.types.iter().map(|kind| *kind as u8);
                all.push(VtkPiece {
                    points: numbers(&piece.points)?,
                    cells: types.zip(lists).collect(),
                    of_points: labels(&piece.data.point),
                    of_cells: labels(&piece.data.cell),
                });
            }
        }
        DataSet::PolyData { pieces, .. } => {
            for piece in pieces {
                let Piece::Inline(piece) = piece else { continue };
                let mut of_kinds = Vec::new();
                // Data of the cells have this order.
                for (own, kind) in [
                    (&piece.verts, kinds::VERTICES),
                    (&piece.lines, kinds::LINES),
                    (&piece.polys, kinds::POLYGON),
                    (&piece.strips, kinds::STRIP),
                ] {
                    let own = own.as_ref().map_or_else(|| Ok(Vec::new()), cells)?;
                    of_kinds.extend(own.into_iter().map(|list| (kind, list)));
                }
                all.push(VtkPiece {
                    points: numbers(&piece.points)?,
                    cells: of_kinds,
                    of_points: labels(&piece.data.point),
                    of_cells: labels(&piece.data.cell),
                });
            }
        }
        _ => return Err("neither an unstructured grid nor polygons".into()),
    }
    Ok(all)
}

/// Returns a file of version 5 with the older name of 64-bit integers in the headers of its arrays. The reader knows the new one in
/// lists of cells only.
fn with_known_types(bytes: &[u8]) -> Vec<u8> {
    const NEW: &[u8] = b" vtktypeint64";
    let (mut known, mut rest) = (Vec::with_capacity(bytes.len()), bytes);
    while let Some(at) = rest.windows(NEW.len()).position(|part| part == NEW) {
        let (before, after) = (&rest[..at], &rest[at + NEW.len()..]);
        let is_of_cells = before.ends_with(b"OFFSETS") || before.ends_with(b"CONNECTIVITY");
        known.extend_from_slice(before);
        known.extend_from_slice(if is_of_cells { NEW } else { b" long" });
        rest = after;
    }
    known.extend_from_slice(rest);
    known
}

fn numbers(points: &IOBuffer) -> Result<Vec<f64>, String> {
    points.cast_into().ok_or_else(|| "points that are no numbers".to_owned())
}

/// Returns the lists of points of cells.
fn cells(cells: &VertexNumbers) -> Result<Vec<Vec<u64>>, String> {
    let mut all = Vec::new();
    match cells {
        VertexNumbers::Legacy { vertices, .. } => {
            let mut rest = &vertices[..];
            while let Some((count, following)) = rest.split_first() {
                let list = following.get(..*count as usize).ok_or("a list of cells that ends too early")?;
                all.push(list.iter().map(|k| u64::from(*k)).collect());
                rest = &following[list.len()..];
            }
            Ok(all)
        }
        VertexNumbers::XML { connectivity, offsets } => lists(connectivity, offsets),
    }
}

/// Returns the arrays of integers with one component.
fn labels(attributes: &[Attribute]) -> Vec<Labels> {
    let mut labels = Vec::new();
    let mut add = |name: &str, components: usize, data: &IOBuffer| {
        let is_integer = !matches!(data.scalar_type(), ScalarType::F32 | ScalarType::F64);
        if let Some(values) = data.cast_into::<i64>().filter(|_| is_integer && components == 1) {
            labels.push((name.to_owned(), values));
        }
    };
    for attribute in attributes {
        match attribute {
            Attribute::DataArray(array) => add(&array.name, array.num_comp(), &array.data),
            Attribute::Field { data_array, .. } => {
                data_array.iter().for_each(|array| add(&array.name, array.num_comp(), &array.data));
            }
        }
    }
    labels
}
