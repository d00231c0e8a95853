//! Counts of instructions beside those on record: work that has grown is found out.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::time::SystemTime;

use serde::{Deserialize, Serialize};

use crate::counts::{WORK, count};
use crate::machine::compiler;
use crate::measure::Result;

/// What counts may grow by with the compiler on record.
const TOLERANCE: f64 = 0.05;
/// With another compiler, which writes other code from the same source.
const TOLERANCE_ELSE: f64 = 0.15;

/// The file of counts.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Record {
    /// The compiler.
    pub compiler: String,
    /// The processor's instruction set.
    pub architecture: String,
    /// The day.
    pub date: String,
    /// Instructions by work.
    pub counts: BTreeMap<String, u64>,
}

const HEAD: &str = "\
# Instructions of fixed work, counted by valgrind in a release build. Written by `cargo xtask instructions --update`;
# `cargo xtask instructions` and `cargo xtask test` fail if one has grown by more than 5 %.

";

/// Where the counts are on record.
pub fn file() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/instructions.toml"))
}

impl Record {
    /// Counts everything anew; `report` is told each count.
    ///
    /// # Errors
    /// If valgrind cannot count.
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

    /// Reads those on record.
    ///
    /// # Errors
    /// If the file is missing or is no record.
    pub fn read() -> Result<Self> {
        let path = file();
        let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        toml::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))
    }

    /// Puts these on record.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self) -> Result<()> {
        let text = toml::to_string(self).map_err(|error| error.to_string())?;
        fs::write(file(), HEAD.to_owned() + &text).map_err(|error| format!("{}: {error}", file().display()))
    }

    /// Compares counts with those on record: what is worth knowing in words, then whether anything has grown too much.
    pub fn compare(&self, now: &Self) -> (Vec<String>, bool) {
        if self.architecture != now.architecture {
            let (then, here) = (&self.architecture, &now.architecture);
            return (vec![format!("counts on record are of {then}, not of {here}: not compared")], true);
        }
        let mut words = Vec::new();
        let mut tolerance = TOLERANCE;
        if self.compiler != now.compiler {
            tolerance = TOLERANCE_ELSE;
            let (then, here) = (&self.compiler, &now.compiler);
            let allowed = 100.0 * tolerance;
            words.push(format!(
                "counts on record are of {then}, not of {here}: up to {allowed} % more will do"
            ));
        }
        let mut holds = true;
        for (name, &after) in &now.counts {
            let Some(&before) = self.counts.get(name) else {
                words.push(format!("{name}: {after} is not on record; cargo xtask instructions --update"));
                holds = false;
                continue;
            };
            let growth = after as f64 / before as f64 - 1.0;
            if growth > tolerance {
                words.push(format!("{name}: {before} before, {after} now, {:+.1} %", 100.0 * growth));
                holds = false;
            } else if growth < -tolerance {
                let renew = "less than on record; cargo xtask instructions --update";
                words
                    .push(format!("{name}: {before} before, {after} now, {:+.1} %: {renew}", 100.0 * growth));
            }
        }
        (words, holds)
    }
}

/// Today by the calendar, in Greenwich.
fn today() -> String {
    let seconds = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0, |time| time.as_secs());
    let [year, month, day] = date(seconds / 86400);
    format!("{year:04}-{month:02}-{day:02}")
}

/// Year, month and day so many days after 1 January 1970.
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

    fn record(compiler: &str, count: u64) -> Record {
        let counts = BTreeMap::from([("work".to_owned(), count)]);
        Record { compiler: compiler.into(), architecture: "x86_64".into(), date: today(), counts }
    }

    #[test]
    fn growth_beyond_the_tolerance_is_found() {
        let before = record("rustc 1", 1000);
        let holds = |after: &Record| before.compare(after).1;
        assert!(holds(&record("rustc 1", 1049)) && !holds(&record("rustc 1", 1051)));
        assert!(holds(&record("rustc 2", 1149)) && !holds(&record("rustc 2", 1151)));
        assert_eq!(before.compare(&record("rustc 1", 1000)), (Vec::new(), true));
        assert_eq!(before.compare(&record("rustc 2", 1000)).0.len(), 1, "another compiler is told of");
        assert_eq!(before.compare(&record("rustc 1", 900)).0.len(), 1, "so is less work");
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
