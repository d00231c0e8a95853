use crate::sections::{DIRECTORS, PAIRS, STRAINS, SectionMatrix};

/// Sparsity of a section law, as index lists for its evaluation.
///
/// Strains are numbered among those with stiffness, and D_kl among the nonzero entries.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Plan {
    /// Number of directors.
    pub reach: usize,
    /// Directors of the strains ½(g·g − g⁰·g⁰), which come first.
    pub equal: Vec<u8>,
    /// Pairs of directors of the other strains.
    pub mixed: Vec<[u8; 2]>,
    /// Range of `coupled` for the resultant of each strain: l and the index of D_kl.
    pub resultants: Vec<(u16, u16)>,
    pub coupled: Vec<(u8, u16)>,
    /// Range of `pulls` for the force of each director: Σ n_k g_x.
    pub forces: Vec<(u16, u16)>,
    pub force_terms: Vec<(u8, u8)>,
    /// Blocks H_αβ of the stiffness: those on the diagonal, and those below it by rows.
    pub diagonal: Vec<StiffnessBlock>,
    pub below: Vec<StiffnessBlock>,
    pub groups: Vec<ProductGroup>,
    pub products: Vec<(u8, u16)>,
    /// Section strains k ≥ l of each D_kl.
    entries: Vec<(usize, usize)>,
}

/// Block H_αβ = n_αβ I + Σ_y (Σ_x D g_x) g_yᵀ: the strain of α and β, if any, and the groups.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StiffnessBlock {
    pub stress: Option<u8>,
    pub groups: (u16, u16),
}

/// Director y with the products (x, index of D) that are summed before multiplication by g_y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ProductGroup {
    pub y: u8,
    pub products: (u16, u16),
}

impl Plan {
    /// Creates the plan of the entries that are nonzero in any of the forms.
    pub fn new(forms: &[SectionMatrix]) -> Self {
        let counts = |k: usize, l: usize| forms.iter().any(|d| d[k][l] != 0.0);
        let used: Vec<usize> = (0..STRAINS).filter(|&k| counts(k, k)).collect();
        let pairs: Vec<(usize, usize)> = used.iter().map(|&k| PAIRS[k]).collect();
        let reach = pairs.iter().map(|(i, j)| i.max(j) + 1).max().unwrap_or(0).max(5);
        let mut plan = Self {
            reach,
            equal: pairs.iter().filter(|(i, j)| i == j).map(|&(i, _)| i as u8).collect(),
            mixed: pairs.iter().filter(|(i, j)| i != j).map(|&(i, j)| [i as u8, j as u8]).collect(),
            resultants: Vec::new(),
            coupled: Vec::new(),
            forces: Vec::new(),
            force_terms: Vec::new(),
            diagonal: Vec::new(),
            below: Vec::new(),
            groups: Vec::new(),
            products: Vec::new(),
            entries: Vec::new(),
        };
        let lower = used.iter().flat_map(|&k| used.iter().map(move |&l| (k, l)));
        plan.entries = lower.filter(|&(k, l)| k >= l && counts(k, l)).collect();
        plan.find_forces(&used, &pairs);
        for i in 0..DIRECTORS {
            for j in 0..i {
                let block = plan.block(i, j, &used, &pairs);
                plan.below.push(block);
            }
            let block = plan.block(i, i, &used, &pairs);
            plan.diagonal.push(block);
        }
        plan.diagonal.truncate(reach);
        plan.below.truncate(reach * (reach - 1) / 2);
        plan
    }

    /// Returns the coefficients D_kl of a form.
    pub fn coefficients<'a>(&'a self, d: &'a SectionMatrix) -> impl Iterator<Item = f64> + 'a {
        self.entries.iter().map(|&(k, l)| d[k][l])
    }

    /// Returns the index of an entry in either order.
    fn entry(&self, k: usize, l: usize) -> Option<u16> {
        let entry = (k.max(l), k.min(l));
        self.entries.iter().position(|&e| e == entry).map(|at| at as u16)
    }

    fn find_forces(&mut self, used: &[usize], pairs: &[(usize, usize)]) {
        for &k in used {
            let start = self.coupled.len() as u16;
            for (l, &other) in used.iter().enumerate() {
                let entry = self.entry(k, other);
                self.coupled.extend(entry.map(|entry| (l as u8, entry)));
            }
            self.resultants.push((start, self.coupled.len() as u16));
        }
        for i in 0..self.reach {
            let start = self.force_terms.len() as u16;
            let of =
                pairs.iter().enumerate().filter_map(|(k, &pair)| Some((k as u8, partner(pair, i)? as u8)));
            self.force_terms.extend(of);
            self.forces.push((start, self.force_terms.len() as u16));
        }
    }

    fn block(&mut self, i: usize, j: usize, used: &[usize], pairs: &[(usize, usize)]) -> StiffnessBlock {
        let stress = pairs.iter().position(|&pair| pair == (j, i)).map(|k| k as u8);
        let start = self.groups.len() as u16;
        for (l, &of_j) in pairs.iter().enumerate() {
            let Some(y) = partner(of_j, j) else { continue };
            let first = self.products.len() as u16;
            for (k, &of_i) in pairs.iter().enumerate() {
                let product = partner(of_i, i).zip(self.entry(used[k], used[l]));
                self.products.extend(product.map(|(x, entry)| (x as u8, entry)));
            }
            let products = (first, self.products.len() as u16);
            if products.0 < products.1 {
                self.groups.push(ProductGroup { y: y as u8, products });
            }
        }
        StiffnessBlock { stress, groups: (start, self.groups.len() as u16) }
    }
}

/// Returns the other director of a pair.
fn partner((i, j): (usize, usize), of: usize) -> Option<usize> {
    if i == of { Some(j) } else { (j == of).then_some(i) }
}

/// Returns a range of a list.
#[inline(always)]
pub(crate) fn part<T>(list: &[T], (start, end): (u16, u16)) -> &[T] {
    &list[usize::from(start)..usize::from(end)]
}
