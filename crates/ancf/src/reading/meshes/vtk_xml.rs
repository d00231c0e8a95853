//! XML files of VTK.
//!
//! Arrays are text, or binary data in base64 in place or in a section at the end, there also without base64. Blocks of binary data start
//! with their sizes and may be compressed by zlib or LZ4.
//!
//! Source: VTK documentation, section "VTK XML file formats".

use std::cell::Cell;
use std::io::Read;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::bufread::ZlibDecoder;
use roxmltree::{Document, Node};

use super::vtk_piece::{Labels, VtkPiece, grid_cells, lists, polygon_cells};

/// Name of the root element.
const ROOT: &str = "<VTKFile";
/// Name of the section of data at the end.
const APPENDED: &[u8] = b"<AppendedData";
/// Largest size of all data of a file in bytes.
const MAX_BYTES: usize = 200_000_000;

/// Returns true for the start of an XML file.
pub(super) fn is_xml(bytes: &[u8]) -> bool {
    String::from_utf8_lossy(&bytes[..bytes.len().min(1000)]).contains(ROOT)
}

/// Reads an unstructured grid or polygons.
pub(super) fn read(bytes: &[u8]) -> Result<Vec<VtkPiece>, String> {
    let (text, appended) = divide(bytes)?;
    let document = Document::parse(&text).map_err(|error| format!("XML: {error}"))?;
    let root = document.root_element();
    let file = File {
        is_big_endian: root.attribute("byte_order") == Some("BigEndian"),
        word: if root.attribute("header_type") == Some("UInt64") { 8 } else { 4 },
        compressor: root.attribute("compressor").map(str::to_owned),
        appended,
        left: Cell::new(MAX_BYTES),
    };
    let kind = root.attribute("type").unwrap_or("no type");
    let data = child(root, kind).filter(|_| ["UnstructuredGrid", "PolyData"].contains(&kind));
    let data = data.ok_or_else(|| format!("{kind}, which is neither UnstructuredGrid nor PolyData"))?;
    let pieces = data.children().filter(|node| node.has_tag_name("Piece"));
    pieces.map(|piece| file.piece(piece, kind == "PolyData")).collect()
}

/// Returns the text of a file without the data at its end, and these data.
fn divide(bytes: &[u8]) -> Result<(String, Option<Block<'_>>), String> {
    let utf8 = |bytes: &[u8]| {
        std::str::from_utf8(bytes).map(str::to_owned).map_err(|_| "text that is not UTF-8".to_owned())
    };
    let Some(start) = bytes.windows(APPENDED.len()).position(|part| part == APPENDED) else {
        return Ok((utf8(bytes)?, None));
    };
    let section = &bytes[start..];
    let end = section.iter().position(|byte| *byte == b'>').ok_or("AppendedData without an end")?;
    let is_base64 = !utf8(&section[..end])?.contains("\"raw\"");
    // An underscore is before the first byte.
    let first = section[end..].iter().position(|byte| *byte == b'_').ok_or("AppendedData without data")?;
    Ok((utf8(&bytes[..start])? + "</VTKFile>", Some(Block { data: &section[end + first + 1..], is_base64 })))
}

fn child<'a>(of: Node<'a, 'a>, name: &str) -> Option<Node<'a, 'a>> {
    of.children().find(|node| node.has_tag_name(name))
}

/// Settings of a file that apply to all of its arrays.
struct File<'a> {
    is_big_endian: bool,
    /// Size of the numbers in the headers of blocks.
    word: usize,
    compressor: Option<String>,
    appended: Option<Block<'a>>,
    /// Bytes that further arrays may have.
    left: Cell<usize>,
}

/// Numbers of an array.
enum Numbers {
    Integers(Vec<i64>),
    Floats(Vec<f64>),
}

impl File<'_> {
    fn piece(&self, piece: Node<'_, '_>, is_polygons: bool) -> Result<VtkPiece, String> {
        let points = child(piece, "Points").and_then(|points| child(points, "DataArray"));
        let points = match self.numbers(points.ok_or("no Points")?)? {
            Numbers::Floats(points) => points,
            Numbers::Integers(points) => points.into_iter().map(|x| x as f64).collect(),
        };
        let expected = piece.attribute("NumberOfPoints").and_then(|count| count.parse::<usize>().ok());
        if let Some(expected) = expected.filter(|count| points.len() != 3 * count) {
            return Err(format!("{} points instead of {expected}", points.len() / 3));
        }
        let cells = if is_polygons {
            let of = |name| child(piece, name).map_or_else(|| Ok(Vec::new()), |own| self.cells(own));
            polygon_cells([of("Verts")?, of("Lines")?, of("Polys")?, of("Strips")?])
        } else {
            let own = child(piece, "Cells").ok_or("no Cells")?;
            let types = self.indices(own, "types")?.into_iter();
            grid_cells(types.map(|kind| u8::try_from(kind).unwrap_or(u8::MAX)), self.cells(own)?)?
        };
        Ok(VtkPiece {
            points,
            cells,
            of_points: self.labels(piece, "PointData")?,
            of_cells: self.labels(piece, "CellData")?,
        })
    }

    fn cells(&self, of: Node<'_, '_>) -> Result<Vec<Vec<u64>>, String> {
        lists(&self.indices(of, "connectivity")?, &self.indices(of, "offsets")?)
    }

    /// Returns an array of integers by its name. An element without any array has no cells.
    fn indices(&self, of: Node<'_, '_>, name: &str) -> Result<Vec<u64>, String> {
        let arrays = || of.children().filter(|node| node.has_tag_name("DataArray"));
        let Some(array) = arrays().find(|array| array.attribute("Name") == Some(name)) else {
            return if arrays().next().is_none() { Ok(Vec::new()) } else { Err(format!("no array {name}")) };
        };
        let wrong = || format!("an array {name} that does not contain numbers of points or cells");
        let Numbers::Integers(numbers) = self.numbers(array)? else { return Err(wrong()) };
        numbers.into_iter().map(|k| u64::try_from(k).map_err(|_| wrong())).collect()
    }

    /// Returns the arrays of integers with one component.
    fn labels(&self, piece: Node<'_, '_>, name: &str) -> Result<Vec<Labels>, String> {
        let mut labels = Vec::new();
        let arrays = child(piece, name).into_iter().flat_map(|data| data.children());
        for array in arrays.filter(|node| node.has_tag_name("DataArray")) {
            let is_scalar = array.attribute("NumberOfComponents").is_none_or(|count| count == "1");
            let is_integer = array.attribute("type").is_some_and(|kind| kind.contains("Int"));
            let Some(name) = array.attribute("Name").filter(|_| is_scalar && is_integer) else { continue };
            if let Numbers::Integers(numbers) = self.numbers(array)? {
                labels.push((name.to_owned(), numbers));
            }
        }
        Ok(labels)
    }

    /// Returns the numbers of an array.
    fn numbers(&self, array: Node<'_, '_>) -> Result<Numbers, String> {
        let kind = array.attribute("type").unwrap_or("");
        let text = || array.text().unwrap_or("").trim();
        let bytes = match array.attribute("format") {
            Some("ascii") | None => return written(kind, text()),
            Some("binary") => self.decoded(Block { data: text().as_bytes(), is_base64: true })?,
            Some("appended") => {
                let offset = array.attribute("offset").and_then(|offset| offset.parse::<usize>().ok());
                let Block { data, is_base64 } = self.appended.ok_or("appended data that are missing")?;
                let data = offset.and_then(|offset| data.get(offset..));
                self.decoded(Block { data: data.ok_or("an offset outside the appended data")?, is_base64 })?
            }
            Some(format) => return Err(format!("data of the format {format}")),
        };
        let Self { is_big_endian, .. } = self;
        macro_rules! all {
            ($of:ty, $kind:ident) => {{
                let number = |bytes: &[u8]| {
                    let own = bytes.try_into().unwrap_or_default();
                    if *is_big_endian { <$of>::from_be_bytes(own) } else { <$of>::from_le_bytes(own) }
                };
                Numbers::$kind(bytes.chunks_exact(size_of::<$of>()).map(|own| number(own) as _).collect())
            }};
        }
        Ok(match kind {
            "Int8" => all!(i8, Integers),
            "UInt8" => all!(u8, Integers),
            "Int16" => all!(i16, Integers),
            "UInt16" => all!(u16, Integers),
            "Int32" => all!(i32, Integers),
            "UInt32" => all!(u32, Integers),
            "Int64" => all!(i64, Integers),
            "UInt64" => all!(u64, Integers),
            "Float32" => all!(f32, Floats),
            "Float64" => all!(f64, Floats),
            _ => return Err(format!("numbers of the type \"{kind}\"")),
        })
    }

    /// Decodes a block of binary data.
    fn decoded(&self, data: Block<'_>) -> Result<Vec<u8>, String> {
        if data.data.is_empty() {
            return Ok(Vec::new());
        }
        let Some(compressor) = &self.compressor else {
            let size = self.word(&data.bytes(0, self.word)?, 0)?;
            self.spend(size)?;
            return Ok(data.bytes(0, self.word.saturating_add(size))?.split_off(self.word));
        };
        // Number of blocks, their size, the size of a shorter last one, and the sizes of the compressed blocks.
        let count = self.word(&data.bytes(0, 3 * self.word)?, 0)?;
        let length = count.saturating_add(3).saturating_mul(self.word);
        let header = data.bytes(0, length)?;
        let [block, last] = [self.word(&header, 1)?, self.word(&header, 2)?];
        let sizes = (0..count).map(|k| self.word(&header, 3 + k)).collect::<Result<Vec<_>, _>>()?;
        let total = sizes.iter().fold(0, |sum: usize, size| sum.saturating_add(*size));
        let compressed = data.bytes(data.place(length), total)?;
        let (mut rest, mut all) = (&compressed[..], Vec::new());
        for (k, size) in sizes.into_iter().enumerate() {
            let expected = if k + 1 == count && last > 0 { last } else { block };
            self.spend(expected)?;
            let (own, others) = rest.split_at(size);
            all.extend(decompressed(compressor, own, expected)?);
            rest = others;
        }
        Ok(all)
    }

    /// Counts bytes of data.
    fn spend(&self, bytes: usize) -> Result<(), String> {
        self.left.set(self.left.get().checked_sub(bytes).ok_or("more than 200 MB of data")?);
        Ok(())
    }

    /// Returns a number of a header.
    fn word(&self, header: &[u8], k: usize) -> Result<usize, String> {
        let mut own =
            header.get(k * self.word..(k + 1) * self.word).ok_or("a block that ends too early")?.to_vec();
        if self.is_big_endian {
            own.reverse();
        }
        own.resize(8, 0);
        let number = own.try_into().map(u64::from_le_bytes).unwrap_or(u64::MAX);
        usize::try_from(number).map_err(|_| "a block that is too large".to_owned())
    }
}

/// Binary data, in base64 or not.
#[derive(Clone, Copy)]
struct Block<'a> {
    data: &'a [u8],
    is_base64: bool,
}

impl Block<'_> {
    /// Returns the place after the code of `count` bytes.
    fn place(&self, count: usize) -> usize {
        if self.is_base64 { count.div_ceil(3).saturating_mul(4) } else { count }
    }

    /// Returns `count` bytes whose code starts at a place.
    fn bytes(&self, at: usize, count: usize) -> Result<Vec<u8>, String> {
        let end = at.saturating_add(self.place(count));
        let code = self.data.get(at..end).ok_or("a block that ends too early")?;
        if !self.is_base64 {
            return Ok(code.to_vec());
        }
        let mut bytes = STANDARD.decode(code).map_err(|error| format!("base64: {error}"))?;
        bytes.truncate(count);
        if bytes.len() == count { Ok(bytes) } else { Err("a block that ends too early".into()) }
    }
}

/// Decompresses a block of a given size.
fn decompressed(compressor: &str, block: &[u8], expected: usize) -> Result<Vec<u8>, String> {
    let bytes = match compressor {
        "vtkZLibDataCompressor" => {
            let mut bytes = Vec::new();
            let read = ZlibDecoder::new(block).take(expected as u64 + 1).read_to_end(&mut bytes);
            read.map(|_| bytes).map_err(|error| format!("zlib: {error}"))
        }
        "vtkLZ4DataCompressor" => {
            lz4_flex::block::decompress(block, expected).map_err(|error| format!("LZ4: {error}"))
        }
        _ => Err(format!("the compressor {compressor}; zlib, LZ4 and none are supported")),
    }?;
    if bytes.len() == expected { Ok(bytes) } else { Err("a compressed block of another size".into()) }
}

/// Returns numbers that are written as text.
fn written(kind: &str, text: &str) -> Result<Numbers, String> {
    fn all<T: std::str::FromStr>(text: &str) -> Result<Vec<T>, String> {
        let number = |word: &str| word.parse().map_err(|_| format!("\"{word}\" where a number is expected"));
        text.split_whitespace().map(number).collect()
    }
    if kind.starts_with("Float") { all(text).map(Numbers::Floats) } else { all(text).map(Numbers::Integers) }
}
