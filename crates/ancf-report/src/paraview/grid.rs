use std::fs;
use std::io;
use std::path::Path;

use nalgebra::Vector3;
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesText, Event};

use super::array::{Array, Values};

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

/// Unstructured grid with data at its points.
#[derive(Clone, Debug)]
pub(super) struct Grid<'a> {
    pub points: Vec<Vector3<f64>>,
    pub cells: &'a Cells,
    /// Name of the array of owners: `body` or `obstacle`.
    pub owner: &'a str,
    pub point_data: Vec<Array>,
}

impl Grid<'_> {
    /// Writes a file as a whole.
    pub fn write(&self, path: &Path, tags: &[Array]) -> io::Result<()> {
        let xml = self.xml(tags)?;
        replace(path, &xml)
    }

    fn xml(&self, tags: &[Array]) -> io::Result<Vec<u8>> {
        let Cells { connectivity, offsets, kinds, owners } = self.cells;
        let points = self.points.iter().flat_map(|x| [x[0], x[1], x[2]]).collect();
        let points = [Array::new("Points", 3, Values::F64(points))];
        let cells = [
            Array::new("connectivity", 1, Values::I64(connectivity.clone())),
            Array::new("offsets", 1, Values::I64(offsets.clone())),
            Array::new("types", 1, Values::U8(kinds.clone())),
        ];
        let owners = [Array::new(self.owner, 1, Values::I64(owners.clone()))];
        let counts =
            [("NumberOfPoints", self.points.len().to_string()), ("NumberOfCells", kinds.len().to_string())];
        document("UnstructuredGrid", |writer| {
            let grid = writer.create_element("UnstructuredGrid");
            grid.write_inner_content(|writer| {
                field_data(writer, tags)?;
                let piece = writer.create_element("Piece");
                let piece = piece.with_attributes(counts.iter().map(|(name, count)| (*name, count.as_str())));
                piece.write_inner_content(|writer| {
                    group(writer, "PointData", &self.point_data)?;
                    group(writer, "CellData", &owners)?;
                    group(writer, "Points", &points)?;
                    group(writer, "Cells", &cells)
                })?;
                Ok(())
            })?;
            Ok(())
        })
    }
}

type Xml = Writer<Vec<u8>>;

/// Returns an XML file of VTK with some content.
pub(super) fn document(kind: &str, content: impl FnOnce(&mut Xml) -> io::Result<()>) -> io::Result<Vec<u8>> {
    let mut writer = Writer::new_with_indent(Vec::new(), b' ', 1);
    writer.write_event(Event::Decl(BytesDecl::new("1.0", None, None)))?;
    let file = writer.create_element("VTKFile").with_attributes([
        ("type", kind),
        ("version", "1.0"),
        ("byte_order", "LittleEndian"),
        ("header_type", "UInt64"),
        ("compressor", "vtkZLibDataCompressor"),
    ]);
    file.write_inner_content(content)?;
    Ok(writer.into_inner())
}

fn group(writer: &mut Xml, name: &str, arrays: &[Array]) -> io::Result<()> {
    writer.create_element(name).write_inner_content(|writer| {
        for array in arrays {
            let width = array.width.to_string();
            let element = writer.create_element("DataArray").with_attributes([
                ("type", array.values.kind()),
                ("Name", &array.name),
                ("NumberOfComponents", &width),
                ("format", "binary"),
            ]);
            element.write_text_content(BytesText::new(&array.values.encoded()?))?;
        }
        Ok(())
    })?;
    Ok(())
}

fn field_data(writer: &mut Xml, tags: &[Array]) -> io::Result<()> {
    writer.create_element("FieldData").write_inner_content(|writer| {
        for tag in tags {
            let name = if matches!(tag.values, Values::Text(_)) { "Array" } else { "DataArray" };
            let count = (tag.values.len() / tag.width.max(1)).to_string();
            let element = writer.create_element(name).with_attributes([
                ("type", tag.values.kind()),
                ("Name", &tag.name),
                ("NumberOfTuples", &count),
                ("format", "binary"),
            ]);
            element.write_text_content(BytesText::new(&tag.values.encoded()?))?;
        }
        Ok(())
    })?;
    Ok(())
}

/// Writes a file under another name and renames it, so that it is complete or absent.
pub(super) fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let part = path.with_extension("part");
    let written = fs::write(&part, bytes).and_then(|()| fs::rename(&part, path));
    written.map_err(|error| {
        // An error of removing the incomplete file adds no information.
        let _ = fs::remove_file(&part);
        with_path("write", path, &error)
    })
}

/// Adds an action and a path to an error.
pub(super) fn with_path(what: &str, path: &Path, error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), format!("cannot {what} {}: {error}", path.display()))
}
