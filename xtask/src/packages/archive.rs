//! Archives of folders: `.tar.gz` by tar, `.zip` by Python.

use std::path::Path;
use std::process::Command;

use super::release::create_empty;
use crate::system::shell::{Done, run};

/// Writes a folder as an archive, whose ending selects the format. Files have no owner and one order.
pub(crate) fn write(folder: &Path, archive: &Path) -> Done {
    let parent = folder.parent().unwrap_or(folder);
    let name = folder.file_name().unwrap_or_default();
    let is_zip = archive.extension().is_some_and(|ending| ending == "zip");
    let mut command = Command::new(if is_zip { "python3" } else { "tar" });
    command.current_dir(parent);
    if is_zip {
        command.args(["-m", "zipfile", "-c"]).arg(archive).arg(name);
    } else {
        command.args(["--sort=name", "--owner=0", "--group=0", "--numeric-owner", "-czf"]);
        command.arg(archive).arg(name);
    }
    run(&format!("archive {}", archive.display()), &mut command)
}

/// Unpacks an archive into an empty folder. Files have the time of unpacking, so that cargo compiles them.
pub(crate) fn unpack(archive: &Path, folder: &Path) -> Done {
    create_empty(folder)?;
    let is_zip = archive.extension().is_some_and(|ending| ending == "zip");
    let mut command = Command::new(if is_zip { "python3" } else { "tar" });
    if is_zip {
        command.args(["-m", "zipfile", "-e"]).arg(archive).arg(folder);
    } else {
        command.args(["--touch", "-xzf"]).arg(archive).arg("-C").arg(folder);
    }
    run(&format!("unpacking of {}", archive.display()), &mut command)
}
