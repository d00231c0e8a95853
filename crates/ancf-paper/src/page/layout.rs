//! Self-contained HTML page with light and dark colours.

use maud::{DOCTYPE, Markup, PreEscaped, html};

/// HTML page with a heading, a table of contents and sections.
#[derive(Debug)]
pub struct HtmlPage<'a> {
    /// Heading, and title of the window.
    pub title: &'a str,
    /// Text below the heading.
    pub subtitle: Markup,
    /// Sections.
    pub sections: Vec<PageSection>,
}

/// Section with an entry in the table of contents.
#[derive(Debug)]
pub struct PageSection {
    /// Anchor of links.
    pub id: String,
    /// Heading.
    pub title: String,
    /// Content.
    pub body: Markup,
}

impl HtmlPage<'_> {
    /// Returns the text of the HTML file.
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

impl PageSection {
    /// Creates a section.
    pub fn new(id: impl Into<String>, title: impl Into<String>, body: Markup) -> Self {
        Self { id: id.into(), title: title.into(), body }
    }

    fn markup(&self) -> Markup {
        html! { section id=(self.id) { h2 { (self.title) } (self.body) } }
    }
}

fn contents(sections: &[PageSection]) -> Markup {
    html! { ol { @for section in sections { li { a href={ "#" (section.id) } { (section.title) } } } } }
}

/// Returns a figure, one SVG element, with its caption.
pub fn figure(id: &str, svg: String, caption: &Markup) -> Markup {
    html! {
        figure id=(id) {
            div.card tabindex="0" { (PreEscaped(svg)) }
            figcaption { (caption) }
        }
    }
}
