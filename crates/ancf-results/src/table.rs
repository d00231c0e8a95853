use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use parquet::basic::Compression;
use parquet::data_type::DoubleType;
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use parquet::file::writer::SerializedFileWriter;

use crate::folder::{about, remove, remove_all, whole};
use crate::layout::Layout;
use crate::merge::{merge, split};
use crate::provenance::Provenance;
use crate::read::{Reader, rows_of};

/// A table that grows, in parts of so many rows each, until it is finished: then it is one Parquet file.
///
/// The rows of the part that is not full yet are in memory. [`Table::flush`] puts them on the disk too, in the place of what
/// was flushed of them before, so that the parts are the same however often that is done.
#[derive(Debug)]
pub(crate) struct Table {
    path: PathBuf,
    layout: Layout,
    properties: WriterPropertiesPtr,
    /// Rows of a full part.
    most: usize,
    /// Full parts.
    full: usize,
    /// Numbers of the rows of the last part.
    open: Vec<f64>,
    /// Rows of it that are on the disk.
    flushed: usize,
}

/// Numbers of a full part, unless a row has more: 4 MB.
const NUMBERS: usize = 1 << 19;
/// The most rows of a full part.
const ROWS: usize = 1 << 16;

impl Table {
    /// An empty table that is to be the file `path`.
    pub(crate) fn create(path: &Path, layout: Layout, about: &Provenance) -> io::Result<Self> {
        let table = Self::new(path, layout, about);
        fs::create_dir_all(parts(path)).map_err(|error| self::about(&error, path))?;
        Ok(table)
    }

    /// The first rows of a table that is there, whole or in parts, to be continued.
    pub(crate) fn reopen(path: &Path, layout: Layout, about: &Provenance, rows: u64) -> io::Result<Self> {
        let mut table = Self::new(path, layout, about);
        if !parts(path).is_dir() {
            split(path, &parts(path), &table.layout, &table.properties)?;
        }
        remove(path)?;
        let rows = usize::try_from(rows).map_err(|_| missing(path))?;
        table.full = rows / table.most;
        if (0..table.full).any(|number| count(&part(path, number)).ok() != Some(table.most)) {
            return Err(missing(path));
        }
        let left = rows % table.most;
        if left > 0 {
            table.open = rows_of(path, &table.layout, table.full)?.ok_or_else(|| missing(path))?;
            let numbers = left * table.layout.width();
            if table.open.len() < numbers {
                return Err(missing(path));
            }
            table.open.truncate(numbers);
            // In the place of the longer one at once: a run may be killed here too.
            table.flush()?;
        }
        let beyond =
            numbers_of(path)?.into_iter().filter(|number| *number >= table.full + usize::from(left > 0));
        // From behind, so that there is never a gap.
        beyond.rev().try_for_each(|number| remove(&part(path, number)))?;
        Ok(table)
    }

    fn new(path: &Path, layout: Layout, about: &Provenance) -> Self {
        let properties = WriterProperties::builder()
            .set_created_by(crate::provenance::PROGRAM.to_owned())
            .set_compression(Compression::SNAPPY)
            // Doubles hardly repeat.
            .set_dictionary_enabled(false)
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_key_value_metadata(Some(about.metadata()))
            .build();
        let most = (NUMBERS / layout.width().max(1)).clamp(1, ROWS);
        let properties = Arc::new(properties);
        Self { path: path.to_owned(), layout, properties, most, full: 0, open: Vec::new(), flushed: 0 }
    }

    /// Rows so far.
    pub(crate) fn rows(&self) -> u64 {
        (self.full * self.most + self.open_rows()) as u64
    }

    fn open_rows(&self) -> usize {
        self.open.len() / self.layout.width().max(1)
    }

    /// Adds a row, given in pieces.
    pub(crate) fn push(&mut self, row: &[&[f64]]) -> io::Result<()> {
        row.iter().for_each(|piece| self.open.extend_from_slice(piece));
        if self.open_rows() == self.most {
            self.flush()?;
            self.full += 1;
            self.open.clear();
            self.flushed = 0;
        }
        Ok(())
    }

    /// Puts all rows on the disk.
    pub(crate) fn flush(&mut self) -> io::Result<()> {
        if self.open_rows() == self.flushed {
            return Ok(());
        }
        let path = part(&self.path, self.full);
        whole(&path, |file| self.write(file)).map_err(|error| about(&error, &path))?;
        self.flushed = self.open_rows();
        Ok(())
    }

    /// Writes the rows of the last part.
    fn write(&self, file: &File) -> io::Result<()> {
        let mut writer =
            SerializedFileWriter::new(file, self.layout.schema()?, Arc::clone(&self.properties))?;
        let mut group = writer.next_row_group()?;
        let rows = || self.open.chunks_exact(self.layout.width());
        let mut values = Vec::new();
        for (first, length) in self.layout.columns() {
            let Some(mut column) = group.next_column()? else { break };
            values.clear();
            values.extend(rows().flat_map(|row| &row[first..first + length.unwrap_or(1)]));
            let levels = length.map(|length| levels(rows().count(), length));
            let (definition, repetition) = levels.as_ref().map(|(d, r)| (d.as_slice(), r.as_slice())).unzip();
            column.typed::<DoubleType>().write_batch(&values, definition, repetition)?;
            column.close()?;
        }
        group.close()?;
        writer.close()?;
        Ok(())
    }

    /// Makes one file of the parts.
    pub(crate) fn finish(&mut self) -> io::Result<()> {
        self.flush()?;
        let count = self.full + usize::from(self.flushed > 0);
        let all: Vec<PathBuf> = (0..count).map(|number| part(&self.path, number)).collect();
        merge(&all, &self.path, &self.layout, &self.properties)?;
        // A folder that is not gone as a whole would be taken for the table.
        let (parts, done) = (parts(&self.path), self.path.with_extension("parquet.done"));
        remove_all(&done)?;
        fs::rename(&parts, &done)
            .and_then(|()| fs::remove_dir_all(&done))
            .map_err(|error| about(&error, &parts))
    }
}

fn missing(path: &Path) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, format!("{}: rows are missing", path.display()))
}

/// Rows of a part.
fn count(path: &Path) -> io::Result<usize> {
    let reader = Reader::open(path)?;
    Ok((0..reader.groups()).map(|group| reader.rows(group)).sum())
}

/// Numbers of the parts that are there, ascending.
fn numbers_of(path: &Path) -> io::Result<Vec<usize>> {
    let number = |name: &str| name.strip_prefix("part-")?.strip_suffix(".parquet")?.parse().ok();
    let folder = parts(path);
    let entries = fs::read_dir(&folder).map_err(|error| about(&error, &folder))?;
    let mut numbers: Vec<usize> =
        entries.flatten().filter_map(|entry| number(&entry.file_name().to_string_lossy())).collect();
    numbers.sort_unstable();
    Ok(numbers)
}

/// Definition and repetition levels of full lists.
fn levels(rows: usize, length: usize) -> (Vec<i16>, Vec<i16>) {
    let repetition = (0..rows * length).map(|i| i16::from(!i.is_multiple_of(length))).collect();
    (vec![1; rows * length], repetition)
}

/// Where the parts of a table stand.
pub(crate) fn parts(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".parts");
    path.with_file_name(name)
}

/// A part of a table.
pub(crate) fn part(path: &Path, number: usize) -> PathBuf {
    parts(path).join(format!("part-{number:06}.parquet"))
}
