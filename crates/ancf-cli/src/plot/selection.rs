//! Selection of columns by names and patterns.

use ancf::errors::nearest;

use super::panel::{PanelCurve, PlotPanel};
use super::source::{PlotQuantity, PlotSource};

/// Selected columns.
#[derive(Debug)]
pub struct ColumnSelection {
    /// Name of the first column: time, load factor or mode.
    first: String,
    against: PlotQuantity,
    columns: Vec<PlotQuantity>,
}

impl ColumnSelection {
    /// Selects columns of a source by names, against another column or the default one.
    ///
    /// # Errors
    /// If there is no column of a name; the error is a message.
    pub fn new(source: &PlotSource, names: &[String], against: Option<&str>) -> Result<Self, String> {
        let against = against.unwrap_or(&source.abscissa);
        Self::among(&source.quantities, names, Some(against))
    }

    fn among(all: &[PlotQuantity], names: &[String], against: Option<&str>) -> Result<Self, String> {
        let first = all.first().ok_or("there are no columns")?.clone();
        let against = match against {
            Some(name) => all.iter().find(|one| one.name == name).ok_or_else(|| unknown(name, all))?.clone(),
            None => first.clone(),
        };
        if names.is_empty() {
            return Err("no columns given; `ancf plot DIR` lists them".to_owned());
        }
        let mut columns: Vec<PlotQuantity> = Vec::new();
        for name in names {
            let found = matching(name, all);
            if found.is_empty() {
                return Err(unknown(name, all));
            }
            for column in found {
                if !columns.contains(column) {
                    columns.push(column.clone());
                }
            }
        }
        Ok(Self { first: first.name, against, columns })
    }

    /// Returns the panels, with the rows whose first value is in a range.
    pub fn panels(&self, source: &PlotSource, [from, to]: [f64; 2]) -> Vec<PlotPanel> {
        let PlotSource { series, is_connected, shares_panels, .. } = source;
        let values = |name: &str| series.column(name).unwrap_or_default();
        let kept: Vec<bool> = values(&self.first).iter().map(|t| (from..=to).contains(t)).collect();
        let keep = |name: &str| -> Vec<f64> {
            values(name).iter().zip(&kept).filter(|(_, kept)| **kept).map(|(x, _)| *x).collect()
        };
        let mut panels: Vec<PlotPanel> = Vec::new();
        for column in &self.columns {
            let curve =
                PanelCurve { name: column.name.clone(), x: keep(&self.against.name), y: keep(&column.name) };
            match panels.iter_mut().find(|panel| *shares_panels && panel.unit == column.unit) {
                Some(panel) => panel.curves.push(curve),
                None => panels.push(PlotPanel {
                    x: self.against.label(),
                    is_discrete: !*is_connected,
                    unit: column.unit.clone(),
                    curves: vec![curve],
                }),
            }
        }
        panels
    }
}

/// Returns the columns of a name: the column, the position of a point, all columns of a probe or joint, or of a pattern.
fn matching<'a>(word: &str, all: &'a [PlotQuantity]) -> Vec<&'a PlotQuantity> {
    let select = |fits: &dyn Fn(&str) -> bool| all.iter().filter(|one| fits(&one.name)).collect::<Vec<_>>();
    let exact = select(&|name| name == word);
    if !exact.is_empty() {
        return exact;
    }
    let axes = ["x", "y", "z"].map(|axis| format!("{word}.{axis}"));
    let point = select(&|name| axes.iter().any(|axis| axis == name));
    if !point.is_empty() {
        return point;
    }
    let own = select(&|name| name.strip_prefix(word).is_some_and(|rest| rest.starts_with('.')));
    if !own.is_empty() {
        return own;
    }
    let pattern: Vec<char> = word.chars().collect();
    select(&|name| matches(&pattern, &name.chars().collect::<Vec<_>>()))
}

/// True if a name matches a pattern. `*` matches any characters, `?` one character.
fn matches(pattern: &[char], name: &[char]) -> bool {
    let mut reached = vec![false; pattern.len() + 1];
    reached[0] = true;
    pass_stars(pattern, &mut reached);
    for character in name {
        let mut next = vec![false; reached.len()];
        for (place, own) in pattern.iter().enumerate().filter(|(place, _)| reached[*place]) {
            match own {
                '*' => next[place] = true,
                own if *own == '?' || own == character => next[place + 1] = true,
                _ => {}
            }
        }
        pass_stars(pattern, &mut next);
        reached = next;
    }
    reached[pattern.len()]
}

/// Adds the places after stars that match no character. A place is an index of the pattern.
fn pass_stars(pattern: &[char], reached: &mut [bool]) {
    for (place, own) in pattern.iter().enumerate() {
        reached[place + 1] |= *own == '*' && reached[place];
    }
}

fn unknown(name: &str, all: &[PlotQuantity]) -> String {
    let owners = all.iter().filter_map(|one| one.name.split_once('.')).map(|(owner, _)| owner);
    let near = nearest(name, all.iter().map(|one| one.name.as_str()).chain(owners));
    let hint = near.map_or_else(
        || "`ancf plot DIR` lists the columns".to_owned(),
        |near| format!("did you mean `{near}`?"),
    );
    format!("there is no column `{name}`; {hint}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all() -> Vec<PlotQuantity> {
        let of = |(name, unit): (&str, &str)| PlotQuantity { name: name.into(), unit: unit.into() };
        let columns = [
            ("t", "s"),
            ("tip.x", "m"),
            ("tip.y", "m"),
            ("tip.z", "m"),
            ("tip.vy", "m/s"),
            ("root.fx", "N"),
            ("root.fy", "N"),
            ("kinetic", "N m"),
        ];
        columns.map(of).to_vec()
    }

    fn names(words: &[&str]) -> Result<Vec<String>, String> {
        let words: Vec<String> = words.iter().map(|&word| word.to_owned()).collect();
        ColumnSelection::among(&all(), &words, None)
            .map(|chosen| chosen.columns.into_iter().map(|column| column.name).collect())
    }

    #[test]
    fn words_mean_columns() {
        assert_eq!(names(&["tip.y"]).unwrap(), ["tip.y"]);
        assert_eq!(names(&["tip"]).unwrap(), ["tip.x", "tip.y", "tip.z"], "the place, not the velocity");
        assert_eq!(names(&["root"]).unwrap(), ["root.fx", "root.fy"]);
        assert_eq!(names(&["*.?y", "tip.*y"]).unwrap(), ["tip.vy", "root.fy", "tip.y"], "each once");
        assert_eq!(names(&["*"]).unwrap().len(), 8);
    }

    #[test]
    fn unknown_columns_are_refused_with_the_nearest() {
        assert_eq!(names(&["tpi.y"]).unwrap_err(), "there is no column `tpi.y`; did you mean `tip.y`?");
        assert_eq!(names(&["rot"]).unwrap_err(), "there is no column `rot`; did you mean `root`?");
        assert!(names(&["*.q"]).unwrap_err().starts_with("there is no column `*.q`; "));
        assert!(ColumnSelection::among(&all(), &["t".into()], Some("tip")).is_err(), "one column only");
    }

    #[test]
    fn patterns_of_many_stars_are_quick() {
        let pattern: Vec<char> = "*a".repeat(50).chars().collect();
        assert!(!matches(&pattern, &['a'; 49]) && matches(&pattern, &['a'; 200]));
    }

    #[test]
    fn columns_of_one_unit_share_a_panel_and_rows_are_chosen_by_the_first_column() {
        use ancf::record::{Series, Sink};
        let mut series = Series::new();
        series.begin(&all().into_iter().map(|one| one.name).collect::<Vec<_>>()).unwrap();
        for t in 0..5 {
            let _ = series.record(&[f64::from(t), 1.0, 2.0, 3.0, 4.0, 5.0, f64::from(t * t), 7.0]).unwrap();
        }
        let words = ["tip.y", "root", "tip.x"].map(str::to_owned);
        let mut source = PlotSource {
            quantities: all(),
            series,
            status: "ended",
            abscissa: "t".to_owned(),
            is_connected: true,
            shares_panels: true,
        };
        let selection = ColumnSelection::new(&source, &words, Some("root.fy")).unwrap();
        let panels = selection.panels(&source, [1.0, 3.0]);
        let names: Vec<Vec<_>> =
            panels.iter().map(|panel| panel.curves.iter().map(|curve| &*curve.name).collect()).collect();
        assert_eq!(names, [vec!["tip.y", "tip.x"], vec!["root.fx", "root.fy"]]);
        assert_eq!((panels[0].unit.as_str(), panels[0].x.as_str()), ("m", "root.fy (N)"));
        assert_eq!(panels[0].curves[0].x, [1.0, 4.0, 9.0]);
        source.shares_panels = false;
        assert_eq!(selection.panels(&source, [1.0, 3.0]).len(), 4);
    }
}
