//! Report of the verification: `results.json` and the HTML page.

use anyhow::Result;

use super::page::page;
use super::record::VerificationRecord;
use super::verdict::ProblemVerdict;
use crate::page::ReportFolder;

/// Writes the report of verdicts that took `seconds` in total, and returns the content of `results.json`.
///
/// # Errors
/// If a file cannot be written.
pub fn write_verification(
    folder: &ReportFolder,
    verdicts: &[ProblemVerdict],
    seconds: f64,
) -> Result<VerificationRecord> {
    let record = VerificationRecord::new(verdicts, seconds);
    folder.write("results.json", serde_json::to_string_pretty(&record)? + "\n")?;
    folder.write("index.html", page(verdicts, &record))?;
    Ok(record)
}
