//! Checksums of a Parquet file, in its key-value metadata.
//!
//! The value of the key `checksums` is `crc32:` and hexadecimal numbers of eight digits: CRC-32 of the footer, then of each
//! segment. The segments are the bytes before the footer, divided at the starts of the row groups. The digits count as zeros in the
//! footer. The footer includes its length and the last four bytes of the file. So every byte of the file has a checksum.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::ops::Range;

use parquet::file::metadata::{KeyValue, ParquetMetaData, ParquetMetaDataReader, RowGroupMetaData};

use crate::folder::damaged;

/// Key of the metadata.
const KEY: &str = "checksums";
/// Start of the value.
const METHOD: &str = "crc32:";
/// Maximum number of bytes between key and value: type and length.
const MAX_GAP: usize = 6;
/// Digits of a checksum.
const DIGITS: usize = 8;
/// Bytes after the metadata: length of the metadata and `PAR1`.
const TAIL: u64 = 8;
/// Buffer of [`crc_of`].
const BUFFER: usize = 1 << 16;

/// Checksums of the segments of a file, read from its footer.
#[derive(Debug)]
pub(super) struct Checksums {
    segments: Vec<u32>,
    /// Start of the footer.
    footer: u64,
}

/// Returns metadata of a Parquet file with a number of row groups, without checksums yet. They are the last key-value metadata.
pub fn checksum_placeholder(groups: usize) -> KeyValue {
    KeyValue::new(KEY.to_owned(), METHOD.to_owned() + &"0".repeat(DIGITS * (1 + groups.max(1))))
}

/// Writes the checksums into a complete file with a [placeholder](checksum_placeholder). The file must be open for reading and writing.
///
/// # Errors
/// If the file cannot be read or written, or has no placeholder for this number of row groups.
pub fn write_checksums(file: &File) -> io::Result<()> {
    let metadata = ParquetMetaDataReader::new().parse_and_finish(file)?;
    let footer = Footer::read(file)?;
    let digits = footer.digits().ok_or_else(|| damaged("checksums are missing"))?;
    let groups = metadata.num_row_groups().max(1);
    let mut all = vec![crc32fast::hash(&footer.bytes)];
    for group in 0..groups {
        all.push(crc_of(file, segment(&metadata, group, footer.start)?)?);
    }
    let text: String = all.iter().map(|sum| format!("{sum:08x}")).collect();
    if text.len() != digits.len() {
        return Err(damaged("invalid number of checksums"));
    }
    let mut writer = file;
    writer.seek(SeekFrom::Start(footer.start + digits.start as u64))?;
    writer.write_all(text.as_bytes())
}

/// Reads the checksums and verifies the footer; `None` for a file without checksums, of an earlier version.
pub(super) fn read(file: &File) -> io::Result<Option<Checksums>> {
    let mut footer = Footer::read(file)?;
    let Some(digits) = footer.digits() else { return Ok(None) };
    let text = String::from_utf8_lossy(&footer.bytes[digits.clone()]).into_owned();
    let numbers =
        (0..text.len() / DIGITS).map(|k| u32::from_str_radix(&text[k * DIGITS..(k + 1) * DIGITS], 16));
    let numbers: Vec<u32> = numbers.collect::<Result<_, _>>().map_err(|_| damaged("invalid checksums"))?;
    footer.bytes[digits].fill(b'0');
    match numbers.split_first() {
        Some((own, segments)) if *own == crc32fast::hash(&footer.bytes) => {
            Ok(Some(Checksums { segments: segments.to_vec(), footer: footer.start }))
        }
        _ => Err(damaged("wrong checksum of the footer")),
    }
}

impl Checksums {
    /// Verifies the segment of a row group.
    pub(super) fn verify(&self, file: &File, metadata: &ParquetMetaData, group: usize) -> io::Result<()> {
        let own = self.segments.get(group).copied();
        if own == Some(crc_of(file, segment(metadata, group, self.footer)?)?) {
            return Ok(());
        }
        let rows = |group: &RowGroupMetaData| group.num_rows();
        let first: i64 = metadata.row_groups().iter().take(group).map(rows).sum();
        let count = metadata.row_groups().get(group).map_or(0, rows);
        Err(damaged(&format!("wrong checksum of rows {first} to {}", (first + count - 1).max(first))))
    }
}

/// Bytes between the start of a row group and the next one. The first segment starts at 0, the last one ends at the footer.
fn segment(metadata: &ParquetMetaData, group: usize, footer: u64) -> io::Result<Range<u64>> {
    let start = |group: usize| {
        let columns = metadata.row_groups().get(group)?.columns().iter();
        let offset = columns.map(|column| column.data_page_offset()).min()?;
        u64::try_from(offset).ok()
    };
    let first = if group == 0 { Some(0) } else { start(group) };
    let last = if group + 1 < metadata.num_row_groups() { start(group + 1) } else { Some(footer) };
    match (first, last) {
        (Some(first), Some(last)) if first <= last && last <= footer => Ok(first..last),
        _ => Err(damaged("invalid offset of a column")),
    }
}

/// CRC-32 of a range of bytes.
fn crc_of(mut file: &File, range: Range<u64>) -> io::Result<u32> {
    file.seek(SeekFrom::Start(range.start))?;
    let mut bytes = file.take(range.end - range.start);
    let (mut hash, mut buffer) = (crc32fast::Hasher::new(), vec![0; BUFFER]);
    loop {
        match bytes.read(&mut buffer) {
            Ok(0) => return Ok(hash.finalize()),
            Ok(count) => hash.update(&buffer[..count]),
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
}

/// Metadata at the end of a file, with their length and the last four bytes.
struct Footer {
    start: u64,
    bytes: Vec<u8>,
}

impl Footer {
    fn read(mut file: &File) -> io::Result<Self> {
        let size = file.metadata()?.len();
        let short = || damaged("it is not a complete Parquet file");
        file.seek(SeekFrom::Start(size.checked_sub(TAIL).ok_or_else(short)?))?;
        let mut tail = [0; TAIL as usize];
        file.read_exact(&mut tail)?;
        let [a, b, c, d, magic @ ..] = tail;
        let length = u64::from(u32::from_le_bytes([a, b, c, d])) + TAIL;
        let start = size.checked_sub(length).filter(|_| magic == *b"PAR1").ok_or_else(short)?;
        file.seek(SeekFrom::Start(start))?;
        let mut bytes = Vec::new();
        file.take(length).read_to_end(&mut bytes)?;
        Ok(Self { start, bytes })
    }

    /// Positions of the digits of the checksums. They are in the last entry of the metadata, after the text of the model.
    fn digits(&self) -> Option<Range<usize>> {
        let key = self.bytes.windows(KEY.len()).rposition(|bytes| bytes == KEY.as_bytes())? + KEY.len();
        let near = &self.bytes[key..self.bytes.len().min(key + MAX_GAP + METHOD.len())];
        let start =
            key + near.windows(METHOD.len()).position(|bytes| bytes == METHOD.as_bytes())? + METHOD.len();
        let count = self.bytes[start..].iter().take_while(|byte| byte.is_ascii_hexdigit()).count();
        Some(start..start + count)
    }
}
