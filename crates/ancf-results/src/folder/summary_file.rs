use std::io;
use std::path::Path;

use ancf::Summary;
use serde::{Deserialize, Serialize};

use super::checksum::damaged;
use super::whole_file::replace;

/// Contents of `summary.json`: program, model, outcome and counts of a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SummaryFile {
    /// Program and its version.
    pub program: String,
    /// Name of the model file.
    pub model: String,
    /// Wall-clock time in seconds. After a resumption, it is the time of the last part of the run.
    pub wall_seconds: f64,
    /// Summary of the simulation.
    #[serde(flatten)]
    pub summary: Summary,
}

/// Summary with the checksum of the file.
#[derive(Serialize)]
struct CheckedSummary<'a> {
    #[serde(flatten)]
    contents: &'a SummaryFile,
    checksum: &'static str,
}

/// Checksum of a file without checksum. The digits count as zeros in the CRC-32 of the file.
const NO_CHECKSUM: &str = "crc32:00000000";
/// End of a file, up to the digits.
const LAST_KEY: &str = "\"checksum\": \"crc32:";
/// Number of digits.
const DIGITS: usize = 8;

/// Writes `summary.json`.
pub(crate) fn write_summary(path: &Path, contents: &SummaryFile) -> io::Result<()> {
    let checked = CheckedSummary { contents, checksum: NO_CHECKSUM };
    let text = serde_json::to_string_pretty(&checked).map_err(io::Error::other)? + "\n";
    let sum = format!("crc32:{:08x}", crc32fast::hash(text.as_bytes()));
    let head = text.rfind(NO_CHECKSUM).unwrap_or_default();
    replace(path, (text[..head].to_owned() + &text[head..].replacen(NO_CHECKSUM, &sum, 1)).as_bytes())
}

/// Position of the digits of the checksum; `None` in files of earlier versions.
fn digits(bytes: &[u8]) -> Option<usize> {
    let key = bytes.windows(LAST_KEY.len()).rposition(|bytes| bytes == LAST_KEY.as_bytes())?;
    Some(key + LAST_KEY.len()).filter(|start| start + DIGITS <= bytes.len())
}

/// True if a summary has a checksum.
pub(crate) fn has_summary_checksum(bytes: &[u8]) -> bool {
    digits(bytes).is_some()
}

/// Verifies and reads the contents of `summary.json`.
pub(crate) fn read_summary(bytes: &[u8]) -> io::Result<SummaryFile> {
    if let Some(start) = digits(bytes) {
        let mut plain = bytes.to_vec();
        plain[start..start + DIGITS].fill(b'0');
        let sum = format!("{:08x}", crc32fast::hash(&plain));
        if sum.as_bytes() != &bytes[start..start + DIGITS] {
            return Err(damaged("wrong checksum"));
        }
    }
    serde_json::from_slice(bytes).map_err(|error| damaged(&error.to_string()))
}
