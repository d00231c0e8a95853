//! File formats of figures.

use std::path::Path;

/// File format of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureFormat {
    /// Vector graphics.
    Svg,
    /// Pixels.
    Png,
    /// Vector graphics on a page.
    Pdf,
}

impl FigureFormat {
    /// Returns the format of a file by its extension.
    ///
    /// # Errors
    /// If the extension is unknown; the error is a message.
    pub fn from_path(file: &Path) -> Result<Self, String> {
        let extension = file.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        match extension.as_deref() {
            Some("svg") => Ok(Self::Svg),
            Some("png") => Ok(Self::Png),
            Some("pdf") => Ok(Self::Pdf),
            _ => Err(format!("{}: expected a file with the extension .svg, .png or .pdf", file.display())),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_have_formats() {
        assert_eq!(FigureFormat::from_path(Path::new("a.b/tip.SVG")), Ok(FigureFormat::Svg));
        assert_eq!(FigureFormat::from_path(Path::new("tip.png")), Ok(FigureFormat::Png));
        assert_eq!(FigureFormat::from_path(Path::new("tip.pdf")), Ok(FigureFormat::Pdf));
        assert!(
            FigureFormat::from_path(Path::new("tip")).is_err()
                && FigureFormat::from_path(Path::new("tip.eps")).is_err()
        );
    }
}
