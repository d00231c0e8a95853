use std::fs::{self, File};
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use bytes::Bytes;
use parquet::column::writer::ColumnCloseResult;
use parquet::errors::{ParquetError, Result as ParquetResult};
use parquet::file::metadata::{PageIndexPolicy, ParquetMetaData, ParquetMetaDataReader, RowGroupMetaData};
use parquet::file::properties::WriterPropertiesPtr;
use parquet::file::reader::{ChunkReader, Length};
use parquet::file::writer::SerializedFileWriter;

use super::checksums::{self, checksum_placeholder, write_checksums};
use super::collected::Collected;
use super::layout::Layout;
use super::parts::part;
use super::reader::is_sound;
use crate::folder::{create, part_path, rename, with_path, write_atomically};

/// Merges files into one by copying their row groups in order.
pub(crate) fn merge(
    from: &[PathBuf],
    to: &Path,
    layout: &Layout,
    properties: &WriterPropertiesPtr,
) -> io::Result<()> {
    let write = |file: &File| {
        let mut writer =
            SerializedFileWriter::new(Collected::new(file), layout.schema()?, Arc::clone(properties))?;
        let mut groups = 0;
        for path in from {
            let (file, metadata) = open(path).map_err(|error| with_path(&error, path))?;
            for group in 0..metadata.num_row_groups() {
                copy(&file, &metadata, group, &mut writer)?;
            }
            groups += metadata.num_row_groups();
        }
        writer.append_key_value_metadata(checksum_placeholder(groups));
        writer.into_inner()?.finish()?;
        write_checksums(file)
    };
    write_atomically(to, write).map_err(|error| with_path(&error, to))
}

/// Splits a merged file into its parts.
pub(crate) fn split(
    from: &Path,
    to: &Path,
    layout: &Layout,
    properties: &WriterPropertiesPtr,
) -> io::Result<()> {
    // The folder gets its name when it is complete.
    let unfinished = part_path(to);
    let _ = fs::remove_dir_all(&unfinished);
    let write = || {
        fs::create_dir_all(&unfinished)?;
        let (file, metadata) = open(from)?;
        for group in 0..metadata.num_row_groups() {
            let name = part(from, group).file_name().map(PathBuf::from).unwrap_or_default();
            let own = create(&unfinished.join(name))?;
            let mut writer =
                SerializedFileWriter::new(Collected::new(&own), layout.schema()?, Arc::clone(properties))?;
            copy(&file, &metadata, group, &mut writer)?;
            writer.append_key_value_metadata(checksum_placeholder(1));
            writer.into_inner()?.finish()?;
            write_checksums(&own)?;
        }
        rename(&unfinished, to)
    };
    write().map_err(|error| with_path(&error, from))
}

/// Opens a file and verifies its checksums.
fn open(path: &Path) -> io::Result<(File, ParquetMetaData)> {
    let file = File::open(path)?;
    let reader = ParquetMetaDataReader::new().with_page_index_policy(PageIndexPolicy::Optional);
    let checksums = checksums::read(&file)?;
    let metadata = reader.parse_and_finish(&file)?;
    if let Some(checksums) = checksums {
        let mut groups = 0..metadata.num_row_groups();
        groups.try_for_each(|group| checksums.verify(&file, &metadata, group))?;
    }
    Ok((file, metadata))
}

/// Copies a row group without decoding it.
fn copy(
    file: &File,
    metadata: &ParquetMetaData,
    group: usize,
    writer: &mut SerializedFileWriter<Collected<'_>>,
) -> io::Result<()> {
    let from = metadata.row_group(group);
    let index = metadata.page_index();
    if !from.columns().iter().all(is_sound) {
        return Err(io::Error::new(io::ErrorKind::InvalidData, "invalid offset of a column"));
    }
    let bytes = GroupBytes::read(file, from)?;
    let mut to = writer.next_row_group()?;
    for (place, column) in from.columns().iter().enumerate() {
        let close = ColumnCloseResult {
            bytes_written: u64::try_from(column.compressed_size()).unwrap_or_default(),
            rows_written: u64::try_from(from.num_rows()).unwrap_or_default(),
            metadata: column.clone(),
            bloom_filter: None,
            column_index: index.and_then(|index| index.column_index(group, place)).cloned(),
            offset_index: index.and_then(|index| index.offset_index(group, place)).cloned(),
        };
        to.append_column(&bytes, close)?;
    }
    to.close()?;
    Ok(())
}

/// Bytes of a row group: thousands of columns of a few kilobytes each are read at once.
struct GroupBytes {
    /// Place of the first byte in the file.
    first: u64,
    bytes: Bytes,
}

impl GroupBytes {
    fn read(mut file: &File, group: &RowGroupMetaData) -> io::Result<Self> {
        let ranges = || group.columns().iter().map(|column| column.byte_range());
        let first = ranges().map(|(start, _)| start).min().unwrap_or_default();
        let end = ranges().map(|(start, length)| start.saturating_add(length)).max().unwrap_or_default();
        if end > file.metadata()?.len() {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        let mut bytes = vec![0; usize::try_from(end - first).map_err(|_| io::ErrorKind::InvalidData)?];
        file.seek(SeekFrom::Start(first))?;
        file.read_exact(&mut bytes)?;
        Ok(Self { first, bytes: bytes.into() })
    }

    /// Bytes from a place in the file on.
    fn from(&self, start: u64) -> ParquetResult<Bytes> {
        let place = start.checked_sub(self.first).and_then(|place| usize::try_from(place).ok());
        let place = place.filter(|place| *place <= self.bytes.len());
        Ok(self.bytes.slice(place.ok_or_else(|| ParquetError::EOF("beyond the row group".to_owned()))?..))
    }
}

impl Length for GroupBytes {
    fn len(&self) -> u64 {
        self.first + self.bytes.len() as u64
    }
}

impl ChunkReader for GroupBytes {
    type T = Cursor<Bytes>;

    fn get_read(&self, start: u64) -> ParquetResult<Self::T> {
        self.from(start).map(Cursor::new)
    }

    fn get_bytes(&self, start: u64, length: usize) -> ParquetResult<Bytes> {
        let bytes = self.from(start)?;
        if length <= bytes.len() {
            Ok(bytes.slice(..length))
        } else {
            Err(ParquetError::EOF("beyond the row group".to_owned()))
        }
    }
}
