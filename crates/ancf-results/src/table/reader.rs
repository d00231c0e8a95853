use std::fs::File;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use parquet::basic::Type as Physical;
use parquet::column::reader::{ColumnReader, get_typed_column_reader};
use parquet::data_type::DoubleType;
use parquet::errors::ParquetError;
use parquet::file::metadata::ColumnChunkMetaData;
use parquet::file::reader::{FileReader, RowGroupReader, SerializedFileReader};
use parquet::schema::types::SchemaDescriptor;

use super::checksums::{self, Checksums};
use super::layout::Layout;
use super::parts::part;
use crate::folder::with_path;

/// Maximum number of values of a column in a row group, 8 GB. Larger counts are assumed to be damaged.
const MAX_VALUES: usize = 1 << 30;

/// Reads the rows of a part of a table; `None` beyond the last part.
///
/// Parts are separate files until the table is finished and row groups of one file afterwards, in the same order. A table can be
/// read while it is being finished.
pub(crate) fn rows_of_part(path: &Path, layout: &Layout, number: usize) -> io::Result<Option<Vec<f64>>> {
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

/// Reads a value of the key-value metadata of a table; `None` if there is no table or no such key.
pub(crate) fn metadata_of_table(path: &Path, key: &str) -> io::Result<Option<String>> {
    Ok(first_file(path)?.and_then(|reader| reader.metadata(key)))
}

/// True if the files of a table have checksums; `None` if there is no table.
pub(crate) fn has_checksums(path: &Path) -> io::Result<Option<bool>> {
    Ok(first_file(path)?.map(|reader| reader.checksums.is_some()))
}

/// True if a table has a column of a name; `None` if there is no table.
pub(crate) fn has_column(path: &Path, name: &str) -> io::Result<Option<bool>> {
    Ok(first_file(path)?.map(|reader| reader.names().iter().any(|own| own == name)))
}

/// Verifies the checksums of a table, in parts or merged.
pub(crate) fn verify(path: &Path) -> io::Result<()> {
    let mut number = 0;
    while if_exists(verify_checksums(&part(path, number)))?.is_some() {
        number += 1;
    }
    if number > 0 { Ok(()) } else { if_exists(verify_checksums(path)).map(|_| ()) }
}

/// Verifies the checksums of a Parquet file, if it has any. Files of earlier versions have none.
///
/// # Errors
/// If the file cannot be read, or is damaged. The message contains its path.
pub fn verify_checksums(path: &Path) -> io::Result<()> {
    let reader = Reader::open(path)?;
    (0..reader.groups()).try_for_each(|group| reader.verify(group))
}

/// Converts the absence of a file to `None`.
fn if_exists<T>(read: io::Result<T>) -> io::Result<Option<T>> {
    match read {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        read => read.map(Some),
    }
}

/// Opens the first part of a table, or the merged file.
fn first_file(path: &Path) -> io::Result<Option<Reader>> {
    match if_exists(Reader::open(&part(path, 0)))? {
        Some(reader) => Ok(Some(reader)),
        None => if_exists(Reader::open(path)),
    }
}

/// Reader of a Parquet file with columns and lists in double precision.
pub(super) struct Reader {
    file: SerializedFileReader<File>,
    path: PathBuf,
    /// The same file, for the checksums.
    bytes: File,
    checksums: Option<Checksums>,
}

impl Reader {
    /// Opens a file.
    pub(super) fn open(path: &Path) -> io::Result<Self> {
        let open = || {
            let bytes = File::open(path)?;
            // Before the metadata are interpreted.
            let checksums = checksums::read(&bytes)?;
            let file = SerializedFileReader::new(bytes.try_clone()?)?;
            Ok(Self { file, path: path.to_owned(), bytes, checksums })
        };
        open().map_err(|error| with_path(&error, path))
    }

    /// Verifies the checksum of a row group, if the file has checksums.
    pub(super) fn verify(&self, group: usize) -> io::Result<()> {
        let Some(checksums) = &self.checksums else { return Ok(()) };
        let verified = checksums.verify(&self.bytes, self.file.metadata(), group);
        verified.map_err(|error| with_path(&error, &self.path))
    }

    /// Names of the columns. A list has the name of the list, not that of its elements.
    fn names(&self) -> Vec<String> {
        let columns = self.schema().columns().iter();
        columns.filter_map(|column| column.path().parts().first().cloned()).collect()
    }

    fn schema(&self) -> &SchemaDescriptor {
        self.file.metadata().file_metadata().schema_descr()
    }

    /// Value of the key-value metadata.
    fn metadata(&self, key: &str) -> Option<String> {
        let all = self.file.metadata().file_metadata().key_value_metadata()?;
        all.iter().find(|one| one.key == key).and_then(|one| one.value.clone())
    }

    /// Number of row groups.
    pub(super) fn groups(&self) -> usize {
        self.file.num_row_groups()
    }

    /// Number of rows of a row group.
    pub(super) fn rows(&self, group: usize) -> usize {
        usize::try_from(self.file.metadata().row_group(group).num_rows()).unwrap_or_default()
    }

    /// Reads the rows of a row group in order; `None` beyond the last group.
    fn rows_of(&self, group: usize, layout: &Layout) -> io::Result<Option<Vec<f64>>> {
        let wrong = |text: &str| with_path(&io::Error::new(io::ErrorKind::InvalidData, text), &self.path);
        let names = layout.numbers.iter().chain(layout.lists.iter().map(|(name, _)| name));
        if !names.eq(self.names().iter()) {
            return Err(wrong("columns of another run"));
        }
        if group >= self.groups() {
            return Ok(None);
        }
        self.verify(group)?;
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

    /// Reads the values of a column in a row group.
    fn column(&self, group: usize, column: usize) -> io::Result<Vec<f64>> {
        self.doubles(group, column).map_err(|error| with_path(&error.into(), &self.path))
    }

    fn doubles(&self, group: usize, column: usize) -> Result<Vec<f64>, ParquetError> {
        let wrong = |text: &str| Err(ParquetError::General(text.to_owned()));
        if self.schema().column(column).physical_type() != Physical::DOUBLE {
            return wrong("a column that is not in double precision");
        }
        let reader = self.file.get_row_group(group)?;
        let chunk = reader.metadata().column(column);
        let count = usize::try_from(chunk.num_values()).unwrap_or(usize::MAX);
        if count > MAX_VALUES || reader.metadata().num_rows() > chunk.num_values() || !is_sound(chunk) {
            return wrong("invalid number or offset of values of a column");
        }
        // Parquet's decoder panics for some damaged pages. Files with checksums never get here with such pages.
        let decoded = catch_unwind(AssertUnwindSafe(|| read(&*reader, column, count)));
        decoded.unwrap_or_else(|_| wrong("damaged values of a column"))
    }
}

/// True if offset and size of a column are not negative. The reader of Parquet does not check that.
pub(super) fn is_sound(chunk: &ColumnChunkMetaData) -> bool {
    let first = chunk.dictionary_page_offset().unwrap_or_else(|| chunk.data_page_offset());
    let numbers = [first, chunk.data_page_offset(), chunk.compressed_size(), chunk.num_values()];
    numbers.iter().all(|number| *number >= 0)
}

fn read(group: &dyn RowGroupReader, column: usize, count: usize) -> Result<Vec<f64>, ParquetError> {
    let reader = group.get_column_reader(column)?;
    if !matches!(reader, ColumnReader::DoubleColumnReader(_)) {
        return Err(ParquetError::General("a column that is not in double precision".to_owned()));
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
