use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::slice;

use nalgebra::Vector3;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};

use super::array::{Array, EncodedArray, TEXT, Values, encoded};

/// Type of a cell with its number in VTK.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cell {
    Vertex = 1,
    Polyline = 4,
    Triangle = 5,
    Polygon = 7,
    Quad = 9,
}

/// Cells between points given by their indices.
#[derive(Clone, Debug, Default)]
pub(super) struct Cells {
    connectivity: Vec<i64>,
    /// End of each cell in the connectivity.
    offsets: Vec<i64>,
    kinds: Vec<u8>,
    /// Index of the body or obstacle of each cell.
    owners: Vec<i64>,
}

impl Cells {
    pub fn push(&mut self, kind: Cell, points: impl IntoIterator<Item = usize>, owner: usize) {
        self.connectivity.extend(points.into_iter().map(|point| point as i64));
        self.offsets.push(self.connectivity.len() as i64);
        self.kinds.push(kind as u8);
        self.owners.push(owner as i64);
    }
}

/// Encoded cells, which are the same in all frames.
#[derive(Clone, Debug)]
pub(super) struct EncodedCells {
    /// Connectivity, offsets and types.
    cells: Vec<EncodedArray>,
    /// Index of the body or obstacle of each cell.
    owners: EncodedArray,
}

impl Cells {
    /// Encodes the cells. `owner` is the name of the array of owners: `body` or `obstacle`.
    pub fn encoded(self, owner: &str) -> io::Result<EncodedCells> {
        let Self { connectivity, offsets, kinds, owners } = self;
        let cells = [
            Array::new("connectivity", 1, Values::I64(connectivity)),
            Array::new("offsets", 1, Values::I64(offsets)),
            Array::new("types", 1, Values::U8(kinds)),
        ];
        let owners = Array::new(owner, 1, Values::I64(owners)).encoded()?;
        Ok(EncodedCells { cells: encoded(&cells)?, owners })
    }
}

/// Unstructured grid with data at its points.
#[derive(Clone, Debug)]
pub(super) struct Grid<'a> {
    pub points: Vec<Vector3<f64>>,
    pub cells: &'a EncodedCells,
    pub point_data: Vec<Array>,
}

impl Grid<'_> {
    /// Writes a file as a whole.
    pub fn write(self, path: &Path, tags: &[EncodedArray]) -> io::Result<()> {
        let Self { points, cells: EncodedCells { cells, owners }, point_data } = self;
        let counts =
            [("NumberOfPoints", points.len().to_string()), ("NumberOfCells", owners.count.to_string())];
        let points = points.iter().flat_map(|x| [x[0], x[1], x[2]]).collect();
        let points = [Array::new("Points", 3, Values::F64(points)).encoded()?];
        let point_data = encoded(&point_data)?;
        write_document(path, "UnstructuredGrid", |writer| {
            let grid = writer.create_element("UnstructuredGrid");
            grid.write_inner_content(|writer| {
                field_data(writer, tags)?;
                let piece = writer.create_element("Piece");
                let piece = piece.with_attributes(counts.iter().map(|(name, count)| (*name, count.as_str())));
                piece.write_inner_content(|writer| {
                    group(writer, "PointData", &point_data)?;
                    group(writer, "CellData", slice::from_ref(owners))?;
                    group(writer, "Points", &points)?;
                    group(writer, "Cells", cells)
                })?;
                Ok(())
            })?;
            Ok(())
        })
    }
}

type Xml = Writer<BufWriter<File>>;

/// Writes an XML file of VTK under another name and renames it, so that it is complete or absent.
pub(super) fn write_document(
    path: &Path,
    kind: &str,
    content: impl FnOnce(&mut Xml) -> io::Result<()>,
) -> io::Result<()> {
    let part = path.with_extension("part");
    let written = document(&part, kind, content).and_then(|()| fs::rename(&part, path));
    written.map_err(|error| {
        // An error of removing the incomplete file adds no information.
        let _ = fs::remove_file(&part);
        with_path("write", path, &error)
    })
}

fn document(path: &Path, kind: &str, content: impl FnOnce(&mut Xml) -> io::Result<()>) -> io::Result<()> {
    let mut writer = Writer::new_with_indent(BufWriter::new(File::create(path)?), b' ', 1);
    writer.write_event(Event::Decl(BytesDecl::new("1.0", None, None)))?;
    let file = writer.create_element("VTKFile").with_attributes([
        ("type", kind),
        ("version", "1.0"),
        ("byte_order", "LittleEndian"),
        ("header_type", "UInt64"),
        ("compressor", "vtkZLibDataCompressor"),
    ]);
    file.write_inner_content(content)?;
    writer.into_inner().flush()
}

fn group(writer: &mut Xml, name: &str, arrays: &[EncodedArray]) -> io::Result<()> {
    writer.create_element(name).write_inner_content(|writer| {
        for array in arrays {
            let width = array.width.to_string();
            let element = writer.create_element("DataArray").with_attributes([
                ("type", array.kind),
                ("Name", &array.name),
                ("NumberOfComponents", &width),
                ("format", "binary"),
            ]);
            element.write_text_content(BytesText::from_escaped(&array.text))?;
        }
        Ok(())
    })?;
    Ok(())
}

fn field_data(writer: &mut Xml, tags: &[EncodedArray]) -> io::Result<()> {
    writer.create_element("FieldData").write_inner_content(|writer| {
        for tag in tags {
            let name = if tag.kind == TEXT { "Array" } else { "DataArray" };
            let count = tag.count.to_string();
            let element = writer.create_element(name).with_attributes([
                ("type", tag.kind),
                ("Name", &tag.name),
                ("NumberOfTuples", &count),
                ("format", "binary"),
            ]);
            element.write_text_content(BytesText::from_escaped(&tag.text))?;
        }
        Ok(())
    })?;
    Ok(())
}

/// Adds an action and a path to an error.
pub(super) fn with_path(what: &str, path: &Path, error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("cannot {what} {}: {error}", path.display()))
}
