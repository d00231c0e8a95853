//! Check sums of the packages, in the form that `sha256sum --check` reads.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use sha2::{Digest, Sha256};

use crate::system::shell::{Done, say};

/// Name of the list.
pub(crate) const LIST: &str = "SHA256SUMS";

/// Writes the check sums of all files in a folder.
pub(crate) fn write(folder: &Path) -> Done {
    let mut list = String::new();
    for name in names(folder)? {
        // Writing to a string cannot fail.
        let _ = writeln!(list, "{}  {name}", of(&folder.join(&name))?);
    }
    let file = folder.join(LIST);
    fs::write(&file, list).map_err(|error| format!("{}: {error}", file.display()))
}

/// Checks that each file of a folder is listed and has its check sum.
pub(crate) fn check(folder: &Path) -> Done {
    let text = fs::read_to_string(folder.join(LIST)).map_err(|error| format!("{LIST}: {error}"))?;
    let listed: Vec<_> = text.lines().filter_map(|line| line.split_once("  ")).collect();
    for name in names(folder)? {
        let sum = listed.iter().find(|(_, listed)| *listed == name);
        let (sum, _) = sum.ok_or_else(|| format!("{LIST} does not list {name}"))?;
        if *sum != of(&folder.join(&name))? {
            return Err(format!("{name} has another check sum than in {LIST}"));
        }
    }
    say(&format!("{} files, check sums in {LIST}", listed.len()));
    Ok(())
}

fn names(folder: &Path) -> Result<Vec<String>, String> {
    let entries = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut names: Vec<_> =
        entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.retain(|name| name != LIST);
    names.sort();
    Ok(names)
}

fn of(file: &Path) -> Result<String, String> {
    let bytes = fs::read(file).map_err(|error| format!("{}: {error}", file.display()))?;
    Ok(Sha256::digest(bytes).iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    }))
}

#[cfg(test)]
mod tests {
    use super::{LIST, check, of, write};

    /// Check sum of the text `abc`: FIPS 180-2, appendix B.1.
    const ABC: &str = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";

    #[test]
    fn changed_and_unlisted_files_are_found() {
        let folder = std::env::temp_dir().join(format!("ancf check sums {}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let put = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
        put("package", "abc");
        assert_eq!(of(&folder.join("package")).unwrap(), ABC);
        write(&folder).unwrap();
        assert_eq!(std::fs::read_to_string(folder.join(LIST)).unwrap(), format!("{ABC}  package\n"));
        check(&folder).unwrap();
        put("other", "abc");
        assert!(check(&folder).unwrap_err().contains("does not list other"));
        write(&folder).unwrap();
        put("package", "abd");
        assert!(check(&folder).unwrap_err().contains("package has another check sum"));
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
