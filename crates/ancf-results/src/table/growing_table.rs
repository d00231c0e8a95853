use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use parquet::basic::Compression;
use parquet::data_type::DoubleType;
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use parquet::file::writer::SerializedFileWriter;

use super::checksums::{checksum_placeholder, write_checksums};
use super::collected::Collected;
use super::layout::Layout;
use super::merge::{merge, split};
use super::parts::{part, part_numbers, parts_folder};
use super::provenance::{PROGRAM, Provenance};
use super::reader::{Reader, rows_of_part};
use crate::folder::{remove, remove_all, rename, with_path, write_atomically};

/// Table that grows in parts with a fixed number of rows. A finished table is one Parquet file.
///
/// The rows of the last, incomplete part are in memory. [`GrowingTable::flush`] replaces their file, so that the parts do not
/// depend on the number of flushes.
#[derive(Debug)]
pub(crate) struct GrowingTable {
    path: PathBuf,
    layout: Layout,
    properties: WriterPropertiesPtr,
    /// Rows of a complete part.
    rows_per_part: usize,
    /// Number of complete parts.
    complete: usize,
    /// Values of the rows of the last part.
    open: Vec<f64>,
    /// Rows of the last part that are on the disk.
    flushed: usize,
}

/// Minimum and maximum number of values of a complete part, unless a row has more: 4 MB and 64 MB.
const VALUES_PER_PART: [usize; 2] = [1 << 19, 1 << 23];
/// Values of a column in a complete part. Each column of each part has a writer and metadata of about a kilobyte.
const VALUES_PER_COLUMN: usize = 1 << 9;
/// Maximum number of rows of a part.
const MAX_ROWS_PER_PART: usize = 1 << 16;

impl GrowingTable {
    /// Creates an empty table, which will be the file `path`.
    pub(crate) fn create(path: &Path, layout: Layout, provenance: &Provenance) -> io::Result<Self> {
        let table = Self::new(path, layout, provenance);
        fs::create_dir_all(parts_folder(path)).map_err(|error| with_path(&error, path))?;
        Ok(table)
    }

    /// Reopens an existing table, merged or in parts, and truncates it to its first rows.
    pub(crate) fn reopen(
        path: &Path,
        layout: Layout,
        provenance: &Provenance,
        rows: u64,
    ) -> io::Result<Self> {
        let mut table = Self::new(path, layout, provenance);
        if !parts_folder(path).is_dir() {
            split(path, &parts_folder(path), &table.layout, &table.properties)?;
        }
        remove(path)?;
        let rows = usize::try_from(rows).map_err(|_| missing(path))?;
        table.complete = rows / table.rows_per_part;
        for number in 0..table.complete {
            match count(&part(path, number)) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
                rows if rows.as_ref().ok() == Some(&table.rows_per_part) => {}
                _ => return Err(missing(path)),
            }
        }
        let left = rows % table.rows_per_part;
        if left > 0 {
            table.open = rows_of_part(path, &table.layout, table.complete)?.ok_or_else(|| missing(path))?;
            let values = left * table.layout.width();
            if table.open.len() < values {
                return Err(missing(path));
            }
            table.open.truncate(values);
            // Replaces the longer part at once, because the run may be killed here.
            table.flush()?;
        }
        let beyond = part_numbers(path)?
            .into_iter()
            .filter(|number| *number >= table.complete + usize::from(left > 0));
        // In descending order, so that there is never a gap.
        beyond.rev().try_for_each(|number| remove(&part(path, number)))?;
        Ok(table)
    }

    fn new(path: &Path, layout: Layout, provenance: &Provenance) -> Self {
        let properties = WriterProperties::builder()
            .set_created_by(PROGRAM.to_owned())
            .set_compression(Compression::SNAPPY)
            // Values in double precision rarely repeat.
            .set_dictionary_enabled(false)
            .set_statistics_enabled(EnabledStatistics::Chunk)
            // A column of a row group has few pages.
            .set_offset_index_disabled(true)
            .set_key_value_metadata(Some(provenance.metadata()))
            .build();
        let rows_per_part = rows_per_part(&layout);
        let properties = Arc::new(properties);
        Self {
            path: path.to_owned(),
            // Memory of a part is reserved at once, because growth would copy it.
            open: Vec::with_capacity(rows_per_part * layout.width()),
            layout,
            properties,
            rows_per_part,
            complete: 0,
            flushed: 0,
        }
    }

    /// Number of rows.
    pub(crate) fn rows(&self) -> u64 {
        (self.complete * self.rows_per_part + self.open_rows()) as u64
    }

    fn open_rows(&self) -> usize {
        self.open.len() / self.layout.width().max(1)
    }

    /// Adds a row, given as consecutive slices.
    pub(crate) fn push(&mut self, row: &[&[f64]]) -> io::Result<()> {
        row.iter().for_each(|piece| self.open.extend_from_slice(piece));
        if self.open_rows() == self.rows_per_part {
            self.flush()?;
            self.complete += 1;
            self.open.clear();
            self.flushed = 0;
        }
        Ok(())
    }

    /// Writes all rows to the disk.
    pub(crate) fn flush(&mut self) -> io::Result<()> {
        if self.open_rows() == self.flushed {
            return Ok(());
        }
        let path = part(&self.path, self.complete);
        write_atomically(&path, |file| self.write(file)).map_err(|error| with_path(&error, &path))?;
        self.flushed = self.open_rows();
        Ok(())
    }

    /// Writes the rows of the last part.
    fn write(&self, file: &File) -> io::Result<()> {
        let mut writer = SerializedFileWriter::new(
            Collected::new(file),
            self.layout.schema()?,
            Arc::clone(&self.properties),
        )?;
        let mut group = writer.next_row_group()?;
        let rows = || self.open.chunks_exact(self.layout.width());
        let mut values = Vec::new();
        for (first, length) in self.layout.columns() {
            let Some(mut column) = group.next_column()? else { break };
            values.clear();
            match length {
                None => values.extend(rows().map(|row| row[first])),
                Some(length) => values.extend(rows().flat_map(|row| &row[first..first + length])),
            }
            let levels = length.map(|length| levels(rows().count(), length));
            let (definition, repetition) = levels.as_ref().map(|(d, r)| (d.as_slice(), r.as_slice())).unzip();
            column.typed::<DoubleType>().write_batch(&values, definition, repetition)?;
            column.close()?;
        }
        group.close()?;
        writer.append_key_value_metadata(checksum_placeholder(1));
        writer.into_inner()?.finish()?;
        write_checksums(file)
    }

    /// Merges the parts into one file.
    pub(crate) fn finish(&mut self) -> io::Result<()> {
        self.flush()?;
        let count = self.complete + usize::from(self.flushed > 0);
        // The merge requires memory for the metadata of all columns.
        self.open = Vec::new();
        let all: Vec<PathBuf> = (0..count).map(|number| part(&self.path, number)).collect();
        merge(&all, &self.path, &self.layout, &self.properties)?;
        // The folder is renamed first. If it were removed partially, its rest would be taken for the table.
        let (parts, done) = (parts_folder(&self.path), self.path.with_extension("parquet.done"));
        remove_all(&done)?;
        rename(&parts, &done)
            .and_then(|()| fs::remove_dir_all(&done))
            .map_err(|error| with_path(&error, &parts))
    }
}

/// Number of rows of a complete part. It depends on the columns only, so that a run can be resumed.
fn rows_per_part(layout: &Layout) -> usize {
    let [least, most] = VALUES_PER_PART;
    let values = (layout.columns().count() * VALUES_PER_COLUMN).clamp(least, most);
    (values / layout.width().max(1)).clamp(1, MAX_ROWS_PER_PART)
}

fn missing(path: &Path) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, format!("{}: rows are missing", path.display()))
}

/// Number of rows of a part with correct checksums.
fn count(path: &Path) -> io::Result<usize> {
    let reader = Reader::open(path)?;
    (0..reader.groups()).try_for_each(|group| reader.verify(group))?;
    Ok((0..reader.groups()).map(|group| reader.rows(group)).sum())
}

/// Definition and repetition levels of lists of equal length.
fn levels(rows: usize, length: usize) -> (Vec<i16>, Vec<i16>) {
    let repetition = (0..rows * length).map(|i| i16::from(!i.is_multiple_of(length))).collect();
    (vec![1; rows * length], repetition)
}
