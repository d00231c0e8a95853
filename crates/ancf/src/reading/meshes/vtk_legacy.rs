//! Legacy files of VTK.

use vtkio::model::{Attribute, DataSet, IOBuffer, Piece, ScalarType, VertexNumbers};
use vtkio::parser::parse_be;

use super::vtk_piece::{Labels, VtkPiece, grid_cells, lists, polygon_cells};

/// Start of a legacy file.
const LEGACY: &[u8] = b"# vtk";

/// Returns true for the start of a legacy file.
pub(super) fn is_legacy(bytes: &[u8]) -> bool {
    bytes.starts_with(LEGACY)
}

/// Reads an unstructured grid or polygons.
pub(super) fn read(bytes: &[u8]) -> Result<Vec<VtkPiece>, String> {
    let text = with_known_types(bytes);
    let (rest, file) = parse_be(&text).map_err(|error| match error {
        nom_error if nom_error.is_incomplete() => "it ends too early".to_owned(),
        _ => "a header or a number in it is not known".to_owned(),
    })?;
    // The reader ends at the first unknown attribute.
    if let Some(start) = rest.iter().position(|byte| !byte.is_ascii_whitespace()) {
        let word = rest[start..].split(u8::is_ascii_whitespace).next().unwrap_or_default();
        return Err(format!("data of the kind \"{}\"", String::from_utf8_lossy(&word[..word.len().min(40)])));
    }
    let data = file.data;
    let mut all = Vec::new();
    match data {
        DataSet::UnstructuredGrid { pieces, .. } => {
            for piece in pieces {
                let Piece::Inline(piece) = piece else { continue };
                let types = piece.cells.types.iter().map(|kind| *kind as u8);
                all.push(VtkPiece {
                    points: numbers(&piece.points)?,
                    cells: grid_cells(types, cells(&piece.cells.cell_verts)?)?,
                    of_points: labels(&piece.data.point),
                    of_cells: labels(&piece.data.cell),
                });
            }
        }
        DataSet::PolyData { pieces, .. } => {
            for piece in pieces {
                let Piece::Inline(piece) = piece else { continue };
                let of = |own: &Option<VertexNumbers>| own.as_ref().map_or_else(|| Ok(Vec::new()), cells);
                let [verts, lines, polys, strips] =
                    [&piece.verts, &piece.lines, &piece.polys, &piece.strips].map(of);
                all.push(VtkPiece {
                    points: numbers(&piece.points)?,
                    cells: polygon_cells([verts?, lines?, polys?, strips?]),
                    of_points: labels(&piece.data.point),
                    of_cells: labels(&piece.data.cell),
                });
            }
        }
        _ => return Err("neither an unstructured grid nor polygons".into()),
    }
    Ok(all)
}

/// Returns a file of version 5 with the older names of 64-bit integers in the headers of its arrays. The reader supports the new one in
/// lists of cells only.
fn with_known_types(bytes: &[u8]) -> Vec<u8> {
    const NEW: [(&[u8], &[u8]); 2] = [(b" vtktypeint64", b" long"), (b" vtktypeuint64", b" unsigned_long")];
    let (mut known, mut rest) = (Vec::with_capacity(bytes.len()), bytes);
    while let Some((first, after)) = rest.split_first() {
        let is_of_cells = known.ends_with(b"OFFSETS") || known.ends_with(b"CONNECTIVITY");
        match NEW.iter().find(|(name, _)| *first == b' ' && rest.starts_with(name) && !is_of_cells) {
            Some((name, old)) => {
                known.extend_from_slice(old);
                rest = &rest[name.len()..];
            }
            None => {
                known.push(*first);
                rest = after;
            }
        }
    }
    known
}

/// Decodes a name, in which special characters are written as % and two hexadecimal digits.
fn decoded(name: &str) -> String {
    let (mut bytes, mut rest) = (Vec::new(), name.as_bytes());
    while let Some((first, after)) = rest.split_first() {
        let digits = after.get(..2).and_then(|digits| std::str::from_utf8(digits).ok());
        match digits.filter(|_| *first == b'%').and_then(|digits| u8::from_str_radix(digits, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                rest = &after[2..];
            }
            None => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn numbers(points: &IOBuffer) -> Result<Vec<f64>, String> {
    points.cast_into().ok_or_else(|| "points whose coordinates are not numbers".to_owned())
}

/// Returns the lists of points of cells.
fn cells(cells: &VertexNumbers) -> Result<Vec<Vec<u64>>, String> {
    let mut all = Vec::new();
    match cells {
        VertexNumbers::Legacy { vertices, num_cells } => {
            let mut rest = &vertices[..];
            while let Some((count, following)) = rest.split_first() {
                let list = following.get(..*count as usize).ok_or("a list of cells that ends too early")?;
                all.push(list.iter().map(|k| u64::from(*k)).collect());
                rest = &following[list.len()..];
            }
            let expected = *num_cells as usize;
            if all.len() == expected {
                Ok(all)
            } else {
                Err(format!("{} cells instead of {expected}", all.len()))
            }
        }
        VertexNumbers::XML { connectivity, offsets } => lists(connectivity, offsets),
    }
}

/// Returns the arrays of integers with one component.
fn labels(attributes: &[Attribute]) -> Vec<Labels> {
    let mut labels = Vec::new();
    let mut add = |name: &str, components: usize, data: &IOBuffer| {
        let is_integer = !matches!(data.scalar_type(), ScalarType::Bit | ScalarType::F32 | ScalarType::F64);
        if let Some(values) = data.cast_into::<i64>().filter(|_| is_integer && components == 1) {
            labels.push((decoded(name), values));
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
