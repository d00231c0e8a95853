//! Pictures of the documentation, recorded from the viewer.

use std::process::Command;

use super::viewer;
use crate::system::shell::{Done, cargo, root, run, say};

/// Records the pictures of `docs/pictures/pictures.json` from the models with the present viewer.
pub(crate) fn record() -> Done {
    viewer::build()?;
    viewer::browser()?;
    cargo("program", &["build", "--package", "ancf-cli"], &[])?;
    run("pictures", Command::new("node").arg("pictures.mjs").current_dir(root().join("viewer")))?;
    say("the pictures are in docs/pictures");
    Ok(())
}
