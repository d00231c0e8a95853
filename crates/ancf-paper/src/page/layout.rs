//! A report as one self-contained HTML page, in light and dark.

use maud::{DOCTYPE, Markup, PreEscaped, html};

/// A page with a heading, a table of contents and sections.
pub struct Page<'a> {
    /// Heading and title of the window.
    pub title: &'a str,
    /// What it is, below the heading.
    pub subtitle: Markup,
    /// Its parts.
    pub sections: Vec<Section>,
}

/// A part of a page with an entry in the table of contents.
pub struct Section {
    /// Its place in links.
    pub id: String,
    /// Its heading.
    pub title: String,
    /// What it says.
    pub body: Markup,
}

impl Page<'_> {
    /// The page as a file.
    pub fn into_text(self) -> String {
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    title { (self.title) }
                    style { (PreEscaped(include_str!("../../assets/report.css"))) }
                }
                body {
                    header { h1 { (self.title) } p { (self.subtitle) } }
                    nav aria-label="Contents" { h2 { "Contents" } (contents(&self.sections)) }
                    main { @for section in &self.sections { (section.markup()) } }
                }
            }
        };
        page.into_string()
    }
}

impl Section {
    /// A part of a page.
    pub fn new(id: impl Into<String>, title: impl Into<String>, body: Markup) -> Self {
        Self { id: id.into(), title: title.into(), body }
    }

    fn markup(&self) -> Markup {
        html! { section id=(self.id) { h2 { (self.title) } (self.body) } }
    }
}

fn contents(sections: &[Section]) -> Markup {
    html! { ol { @for section in sections { li { a href={ "#" (section.id) } { (section.title) } } } } }
}

/// A picture, one SVG element, with its caption.
pub fn figure(id: &str, svg: String, caption: &Markup) -> Markup {
    html! {
        figure id=(id) {
            div.card tabindex="0" { (PreEscaped(svg)) }
            figcaption { (caption) }
        }
    }
}
