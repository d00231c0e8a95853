use std::fs;
use std::path::{Path, PathBuf};

use toml::Value;

use super::fault::Fault;
use crate::interface::{INTERFACE, Interface, MODEL};

/// Contents of the resources of an FMU.
#[derive(Debug)]
pub(crate) struct Resources {
    pub(crate) interface: Interface,
    /// Data of the model.
    pub(crate) data: Value,
}

impl Resources {
    /// Reads the resources in a folder and compares the token with that of the importer.
    pub(crate) fn read(folder: &Path, token: &str) -> Result<Self, Fault> {
        let read = |name: &str| {
            let path = folder.join(name);
            fs::read_to_string(&path).map_err(|error| Fault::error(format!("{}: {error}", path.display())))
        };
        let interface: Interface = toml::from_str(&read(INTERFACE)?)
            .map_err(|error| Fault::error(format!("{INTERFACE}: {error}")))?;
        if interface.token != token {
            let text =
                format!("the token {token} of the importer is not that of the FMU, {}", interface.token);
            return Err(Fault::error(text));
        }
        let data =
            toml::from_str(&read(MODEL)?).map_err(|error| Fault::error(format!("{MODEL}: {error}")))?;
        Ok(Self { interface, data })
    }
}

/// Folder of a location, which is a path (FMI 3) or an URI of the scheme `file` (FMI 2).
pub(crate) fn folder_of(location: &str) -> Result<PathBuf, Fault> {
    let Some(rest) = location.strip_prefix("file:") else {
        return match location.contains("://") {
            true => Err(Fault::error(format!("resources: found {location}, expected a location in files"))),
            false => Ok(location.into()),
        };
    };
    let path = match rest.strip_prefix("//") {
        Some(rest) => rest.strip_prefix("localhost").unwrap_or(rest),
        None => rest,
    };
    let path = unescaped(path)
        .ok_or_else(|| Fault::error(format!("resources: found {location}, expected an URI in UTF-8")))?;
    // `/C:/folder` of Windows.
    let is_drive = path.as_bytes().get(2) == Some(&b':');
    Ok(PathBuf::from(if is_drive { path.trim_start_matches('/') } else { &path }))
}

/// Replaces `%20` and so on.
fn unescaped(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((first, after)) = rest.split_first() {
        let code = (*first == b'%').then(|| after.get(..2)).flatten();
        let code = code.and_then(|hex| u8::from_str_radix(std::str::from_utf8(hex).ok()?, 16).ok());
        bytes.push(code.unwrap_or(*first));
        rest = if code.is_some() { &after[2..] } else { after };
    }
    String::from_utf8(bytes).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn locations_are_paths_or_uris() {
        for (location, path) in [
            ("file:///tmp/a%20b/resources", "/tmp/a b/resources"),
            ("file:/tmp/r%C3%A9s", "/tmp/rés"),
            ("file://localhost/tmp/100%", "/tmp/100%"),
            ("file:///C:/fmu/resources", "C:/fmu/resources"),
            ("/tmp/resources/", "/tmp/resources/"),
        ] {
            assert_eq!(folder_of(location).unwrap(), PathBuf::from(path), "{location}");
        }
        assert!(folder_of("https://host/resources").is_err());
    }
}
