use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

use parquet::basic::Type as Physical;
use parquet::column::reader::{ColumnReader, get_typed_column_reader};
use parquet::data_type::DoubleType;
use parquet::errors::ParquetError;
use parquet::file::metadata::ColumnChunkMetaData;
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
use parquet::schema::types::SchemaDescriptor;

use crate::folder::about;
use crate::layout::Layout;
use crate::table::part;

/// The most numbers of a row group that are believed: 8 GB.
const NUMBERS: usize = 1 << 30;

/// The rows of a table's part of a number; none beyond the last one.
///
/// Parts are files of their own until the table is finished, row groups of one file from then on, in the same order: a
/// table can be read while that happens.
pub(crate) fn rows_of(path: &Path, layout: &Layout, number: usize) -> io::Result<Option<Vec<f64>>> {
    let read = |at: &Path, group| Reader::open(at).and_then(|reader| reader.rows_of(group, layout));
    match read(&part(path, number), 0) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => {}
        rows => return rows,
    }
    match read(path, number) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        rows => rows,
    }
}

/// What a table says about itself.
pub(crate) fn about_table(path: &Path, key: &str) -> io::Result<Option<String>> {
    let reader = match Reader::open(&part(path, 0)) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Reader::open(path),
        reader => reader,
    };
    match reader {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        reader => Ok(reader?.about(key)),
    }
}

/// A Parquet file of doubles and lists of doubles.
pub(crate) struct Reader {
    file: SerializedFileReader<File>,
    path: PathBuf,
}

impl Reader {
    pub(crate) fn open(path: &Path) -> io::Result<Self> {
        let file = File::open(path).and_then(|file| Ok(SerializedFileReader::new(file)?));
        Ok(Self { file: file.map_err(|error| about(&error, path))?, path: path.to_owned() })
    }

    /// Names of the columns, lists by their own name.
    fn names(&self) -> Vec<String> {
        let columns = self.schema().columns().iter();
        columns.filter_map(|column| column.path().parts().first().cloned()).collect()
    }

    fn schema(&self) -> &SchemaDescriptor {
        self.file.metadata().file_metadata().schema_descr()
    }

    /// A text of the metadata.
    fn about(&self, key: &str) -> Option<String> {
        let all = self.file.metadata().file_metadata().key_value_metadata()?;
        all.iter().find(|one| one.key == key).and_then(|one| one.value.clone())
    }

    pub(crate) fn groups(&self) -> usize {
        self.file.num_row_groups()
    }

    /// Rows of a row group.
    pub(crate) fn rows(&self, group: usize) -> usize {
        usize::try_from(self.file.metadata().row_group(group).num_rows()).unwrap_or_default()
    }

    /// The rows of a row group, one after the other; none beyond the last group.
    fn rows_of(&self, group: usize, layout: &Layout) -> io::Result<Option<Vec<f64>>> {
        let wrong = |text: &str| about(&io::Error::new(io::ErrorKind::InvalidData, text), &self.path);
        let names = layout.numbers.iter().chain(layout.lists.iter().map(|(name, _)| name));
        if !names.eq(self.names().iter()) {
            return Err(wrong("columns of another run"));
        }
        if group >= self.groups() {
            return Ok(None);
        }
        let (columns, count): (Vec<_>, _) = (layout.columns().collect(), self.rows(group));
        let read = (0..columns.len()).map(|column| self.column(group, column));
        let values = read.collect::<io::Result<Vec<_>>>()?;
        let fits = |((_, length), values): (&(usize, Option<usize>), &Vec<f64>)| {
            values.len() == count * length.unwrap_or(1)
        };
        if !columns.iter().zip(&values).all(fits) {
            return Err(wrong("columns of different lengths"));
        }
        let mut rows = vec![0.0; count * layout.width()];
        for (row, to) in rows.chunks_exact_mut(layout.width().max(1)).enumerate() {
            for ((first, length), values) in columns.iter().zip(&values) {
                let length = length.unwrap_or(1);
                to[*first..first + length].copy_from_slice(&values[row * length..(row + 1) * length]);
            }
        }
        Ok(Some(rows))
    }

    /// All numbers of a column in a row group.
    fn column(&self, group: usize, column: usize) -> io::Result<Vec<f64>> {
        self.doubles(group, column).map_err(|error| about(&error.into(), &self.path))
    }

    fn doubles(&self, group: usize, column: usize) -> Result<Vec<f64>, ParquetError> {
        let wrong = |text: &str| Err(ParquetError::General(text.to_owned()));
        if self.schema().column(column).physical_type() != Physical::DOUBLE {
            return wrong("a column that is not of doubles");
        }
        let reader = self.file.get_row_group(group)?;
        let chunk = reader.metadata().column(column);
        let count = usize::try_from(chunk.num_values()).unwrap_or(usize::MAX);
        if count > NUMBERS || reader.metadata().num_rows() > chunk.num_values() || !is_sound(chunk) {
            return wrong("a count or place of values that cannot be");
        }
        read(&*reader, column, count)
    }
}

/// Whether the place of a column can be one in a file: its readers take that for granted.
pub(crate) fn is_sound(chunk: &ColumnChunkMetaData) -> bool {
    let first = chunk.dictionary_page_offset().unwrap_or_else(|| chunk.data_page_offset());
    let places = [first, chunk.data_page_offset(), chunk.compressed_size(), chunk.num_values()];
    places.iter().all(|place| *place >= 0)
}

fn read(group: &dyn RowGroupReader, column: usize, count: usize) -> Result<Vec<f64>, ParquetError> {
    let reader = group.get_column_reader(column)?;
    if !matches!(reader, ColumnReader::DoubleColumnReader(_)) {
        return Err(ParquetError::General("a column that is not of doubles".to_owned()));
    }
    let mut reader = get_typed_column_reader::<DoubleType>(reader);
    let (mut values, mut definition, mut repetition) = (Vec::new(), Vec::new(), Vec::new());
    while values.len() < count {
        let (rows, read, _) =
            reader.read_records(count, Some(&mut definition), Some(&mut repetition), &mut values)?;
        if rows == 0 && read == 0 {
            break;
        }
    }
    Ok(values)
}
