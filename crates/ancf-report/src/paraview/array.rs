use std::io::{self, Write};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use rayon::prelude::*;

/// Named array of numbers or texts, as in VTK.
#[derive(Clone, Debug)]
pub(super) struct Array {
    pub name: String,
    /// Components per point or cell.
    pub width: usize,
    pub values: Values,
}

/// Values of an array.
#[derive(Clone, Debug)]
pub(super) enum Values {
    /// Double precision.
    F64(Vec<f64>),
    /// Single precision.
    F32(Vec<f32>),
    /// Indices of points.
    I64(Vec<i64>),
    /// Kinds of cells.
    U8(Vec<u8>),
    /// Texts.
    Text(Vec<String>),
}

/// Array as the text of an XML file.
#[derive(Clone, Debug)]
pub(super) struct EncodedArray {
    pub name: String,
    pub width: usize,
    /// Name of the type in VTK.
    pub kind: &'static str,
    /// Number of points or cells.
    pub count: usize,
    pub text: String,
}

impl Array {
    pub fn new(name: impl Into<String>, width: usize, values: Values) -> Self {
        Self { name: name.into(), width, values }
    }

    /// Encodes the values.
    pub fn encoded(&self) -> io::Result<EncodedArray> {
        Ok(EncodedArray {
            name: self.name.clone(),
            width: self.width,
            kind: self.values.kind(),
            count: self.values.len() / self.width.max(1),
            text: self.values.encoded()?,
        })
    }
}

/// Encodes arrays in parallel.
pub(super) fn encoded(arrays: &[Array]) -> io::Result<Vec<EncodedArray>> {
    arrays.par_iter().map(Array::encoded).collect()
}

/// Name of the type of texts in VTK.
pub(super) const TEXT: &str = "String";

impl Values {
    /// Name of the type in VTK.
    const fn kind(&self) -> &'static str {
        match self {
            Self::F64(_) => "Float64",
            Self::F32(_) => "Float32",
            Self::I64(_) => "Int64",
            Self::U8(_) => "UInt8",
            Self::Text(_) => TEXT,
        }
    }

    /// Number of values.
    fn len(&self) -> usize {
        match self {
            Self::F64(x) => x.len(),
            Self::F32(x) => x.len(),
            Self::I64(x) => x.len(),
            Self::U8(x) => x.len(),
            Self::Text(x) => x.len(),
        }
    }

    fn bytes(&self) -> Vec<u8> {
        match self {
            Self::F64(x) => x.iter().map(|x| x.to_le_bytes()).collect::<Vec<_>>().into_flattened(),
            Self::F32(x) => x.iter().map(|x| x.to_le_bytes()).collect::<Vec<_>>().into_flattened(),
            Self::I64(x) => x.iter().map(|x| x.to_le_bytes()).collect::<Vec<_>>().into_flattened(),
            Self::U8(x) => x.clone(),
            // Each text ends with a zero byte; zero bytes within texts are removed.
            Self::Text(x) => x.iter().flat_map(|x| x.bytes().filter(|byte| *byte != 0).chain([0])).collect(),
        }
    }

    /// Encodes the values for an XML file: base64 of a head, then base64 of one block compressed by zlib.
    ///
    /// The head has 64-bit integers: number of blocks, bytes of a block, bytes of a shorter last block, compressed bytes.
    fn encoded(&self) -> io::Result<String> {
        let bytes = self.bytes();
        let head = |numbers: &[usize]| -> String {
            STANDARD.encode(numbers.iter().flat_map(|x| (*x as u64).to_le_bytes()).collect::<Vec<_>>())
        };
        if bytes.is_empty() {
            return Ok(head(&[0, 0, 0]));
        }
        let mut packed = ZlibEncoder::new(Vec::new(), Compression::fast());
        packed.write_all(&bytes)?;
        let packed = packed.finish()?;
        let mut text = head(&[1, bytes.len(), 0, packed.len()]);
        STANDARD.encode_string(&packed, &mut text);
        Ok(text)
    }
}
