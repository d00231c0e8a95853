use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::time::SystemTime;

use serde::{Deserialize, Serialize};

use super::counts::{WORK, count};
use crate::Result;
use crate::measure::compiler;

/// Allowed relative growth of counts with the recorded compiler.
const TOLERANCE: f64 = 0.05;
/// Allowed relative growth with another compiler, which generates different code.
const TOLERANCE_OTHER_COMPILER: f64 = 0.15;

/// Recorded instruction counts.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct InstructionRecord {
    /// Compiler.
    pub compiler: String,
    /// Instruction set of the processor.
    pub architecture: String,
    /// Date.
    pub date: String,
    /// Instructions by name of the work.
    pub counts: BTreeMap<String, u64>,
}

const HEAD: &str = "\
# Instructions of fixed work, counted by valgrind in a release build. Written by `cargo xtask instructions --update`;
# `cargo xtask instructions` and `cargo xtask test` fail if one has grown by more than 5 %.

";

/// Path of the recorded counts.
pub fn record_file() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/instructions.toml"))
}

impl InstructionRecord {
    /// Counts the instructions of all work. `report` is called with each count.
    ///
    /// # Errors
    /// If valgrind is missing or fails.
    pub fn new(mut report: impl FnMut(&str, u64)) -> Result<Self> {
        let mut counts = BTreeMap::new();
        for (name, _) in WORK {
            let count = count(name)?;
            report(name, count);
            counts.insert(name.to_owned(), count);
        }
        let architecture = std::env::consts::ARCH.to_owned();
        Ok(Self { compiler: compiler(), architecture, date: today(), counts })
    }

    /// Reads the recorded counts.
    ///
    /// # Errors
    /// If the file is missing or invalid.
    pub fn read() -> Result<Self> {
        let path = record_file();
        let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        toml::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))
    }

    /// Records these counts.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self) -> Result<()> {
        let text = toml::to_string(self).map_err(|error| error.to_string())?;
        let path = record_file();
        fs::write(&path, HEAD.to_owned() + &text).map_err(|error| format!("{}: {error}", path.display()))
    }

    /// Compares counts with the recorded ones. Returns messages, and true if no count has grown beyond the tolerance.
    pub fn compare(&self, now: &Self) -> (Vec<String>, bool) {
        if self.architecture != now.architecture {
            let (then, here) = (&self.architecture, &now.architecture);
            return (vec![format!("recorded counts are for {then}, not for {here}: not compared")], true);
        }
        let mut messages = Vec::new();
        let mut tolerance = TOLERANCE;
        if self.compiler != now.compiler {
            tolerance = TOLERANCE_OTHER_COMPILER;
            let (then, here) = (&self.compiler, &now.compiler);
            let allowed = 100.0 * tolerance;
            messages.push(format!(
                "recorded counts are for {then}, not for {here}: a growth of up to {allowed} % is allowed"
            ));
        }
        let mut holds = true;
        for (name, &after) in &now.counts {
            let Some(&before) = self.counts.get(name) else {
                messages.push(format!("{name}: {after} is not recorded; cargo xtask instructions --update"));
                holds = false;
                continue;
            };
            let growth = after as f64 / before as f64 - 1.0;
            if growth > tolerance {
                messages.push(format!("{name}: {before} before, {after} now, {:+.1} %", 100.0 * growth));
                holds = false;
            } else if growth < -tolerance {
                let hint = "less than recorded; cargo xtask instructions --update";
                messages
                    .push(format!("{name}: {before} before, {after} now, {:+.1} %: {hint}", 100.0 * growth));
            }
        }
        (messages, holds)
    }
}

/// Date of today in UTC.
fn today() -> String {
    let seconds = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0, |time| time.as_secs());
    let [year, month, day] = date(seconds / 86400);
    format!("{year:04}-{month:02}-{day:02}")
}

/// Year, month and day of a number of days after 1 January 1970.
fn date(mut days: u64) -> [u64; 3] {
    let leap = |year: u64| year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    let mut year = 1970;
    while days >= 365 + u64::from(leap(year)) {
        days -= 365 + u64::from(leap(year));
        year += 1;
    }
    let lengths = [31, 28 + u64::from(leap(year)), 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let mut month = 0;
    while days >= lengths[month] {
        days -= lengths[month];
        month += 1;
    }
    [year, month as u64 + 1, days + 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(compiler: &str, count: u64) -> InstructionRecord {
        let counts = BTreeMap::from([("work".to_owned(), count)]);
        InstructionRecord { compiler: compiler.into(), architecture: "x86_64".into(), date: today(), counts }
    }

    #[test]
    fn growth_beyond_the_tolerance_is_found() {
        let before = record("rustc 1", 1000);
        let holds = |after: &InstructionRecord| before.compare(after).1;
        assert!(holds(&record("rustc 1", 1049)) && !holds(&record("rustc 1", 1051)));
        assert!(holds(&record("rustc 2", 1149)) && !holds(&record("rustc 2", 1151)));
        assert_eq!(before.compare(&record("rustc 1", 1000)), (Vec::new(), true));
        assert_eq!(before.compare(&record("rustc 2", 1000)).0.len(), 1, "another compiler is reported");
        assert_eq!(before.compare(&record("rustc 1", 900)).0.len(), 1, "less work is reported");
    }

    #[test]
    fn work_that_is_not_on_record_is_found() {
        let mut now = record("rustc 1", 1000);
        now.counts.insert("more".into(), 1);
        assert!(!record("rustc 1", 1000).compare(&now).1);
    }

    #[test]
    fn days_of_the_calendar() {
        assert_eq!(date(0), [1970, 1, 1]);
        assert_eq!(date(11016), [2000, 2, 29]);
        assert_eq!(date(20454), [2026, 1, 1]);
    }
}
