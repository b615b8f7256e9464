//! Which cameras of a file belong together, and choosing others than those that are taken.

use crate::baseline::Baseline;
use crate::camera::Camera;
use crate::checks;
use crate::format::Format;
use crate::found::Found;
use crate::pair::Pair;
use crate::refusal::Refusal;
use crate::warning::Warning;
use depth_core::quantity::Length;
use std::collections::HashMap;

/// A chain of eleven cameras has 55 pairs; nobody chooses among more.
const MOST_PAIRS: usize = 64;
/// COLMAP has a camera for each image where somebody says so.
const MOST_CAMERAS: usize = 2_000;

impl Pair {
    /// What `found` says of its pair, whose cameras are at `places` of another.
    fn of(found: &Found, places: [usize; 2]) -> Self {
        let [first, second] = places;
        let is_turned = found.pair == Some([1, 0]);
        Self {
            cameras: if is_turned { [second, first] } else { [first, second] },
            is_vertical: found.is_vertical,
            baseline: found.baseline,
            baseline_origin: found.baseline_origin.clone(),
            doffs: found.doffs,
            doffs_origin: found.doffs_origin.clone(),
            warnings: found.warnings.iter().filter(|warning| warning.is_of_pair()).cloned().collect(),
        }
    }
}

impl Found {
    /// Adds a camera, or refuses the files where they have more than anybody chooses among.
    pub(crate) fn add(&mut self, camera: Camera) -> Result<(), Refusal> {
        if self.cameras.len() >= MOST_CAMERAS {
            return Err(Refusal::ManyCameras { format: self.format });
        }
        self.cameras.push(camera);
        Ok(())
    }

    /// Gives cameras of the same name their size behind it, or their number where that is the same too.
    pub(crate) fn tell_apart(&mut self) {
        let sized = |camera: &Camera| camera.size.map(|[width, height]| format!("{} {width}x{height}", camera.name));
        let name = |camera: &Camera| camera.name.clone();
        for new in [&sized as &dyn Fn(&Camera) -> Option<String>, &|_| None] {
            let names: Vec<String> = self.cameras.iter().map(name).collect();
            let mut count = HashMap::new();
            names.iter().for_each(|name| *count.entry(name.as_str()).or_insert(0_usize) += 1);
            let mut number = HashMap::new();
            for (camera, name) in self.cameras.iter_mut().zip(&names) {
                if count.get(name.as_str()).is_some_and(|count| *count > 1) {
                    let number: &mut usize = number.entry(name.as_str()).or_default();
                    *number += 1;
                    camera.name = new(camera).unwrap_or_else(|| format!("{name} {number}"));
                }
            }
        }
    }

    /// Whether there are as many pairs as are listed.
    pub(crate) const fn has_all_pairs(&self) -> bool {
        self.pairs.len() >= MOST_PAIRS
    }

    /// Adds the pair of the cameras at `places`. `measure` fills in what is between them, in a `Found` of these two.
    pub(crate) fn pair_up(&mut self, places: [usize; 2], measure: impl FnOnce(&mut Self) -> Result<(), Refusal>) -> Result<(), Refusal> {
        let [Some(first), Some(second)] = places.map(|at| self.cameras.get(at)) else {
            return Ok(());
        };
        // A damaged file may name one camera for both sides.
        if self.has_all_pairs() || places.first() == places.last() {
            return Ok(());
        }
        let mut two = Self {
            cameras: vec![first.clone(), second.clone()],
            pair: Some([0, 1]),
            ..Self::of(self.format)
        };
        measure(&mut two)?;
        self.pairs.push(Pair::of(&two, places));
        Ok(())
    }

    /// Takes the first of the pairs, if there is one.
    pub(crate) fn take_first_pair(&mut self) {
        if let Some(pair) = self.pairs.first().cloned() {
            let places = pair.cameras;
            self.take(pair, places);
        }
    }

    /// Makes `pair` the one that is taken, of which the cameras are at `places`.
    fn take(&mut self, pair: Pair, places: [usize; 2]) {
        self.pair = Some(places);
        self.is_vertical = pair.is_vertical;
        self.baseline = pair.baseline;
        self.baseline_origin = pair.baseline_origin;
        self.doffs = pair.doffs;
        self.doffs_origin = pair.doffs_origin;
        self.warnings.extend(pair.warnings);
    }

    /// Lists the pair of a format that knows only one, and says where a choice is left.
    pub(crate) fn complete(&mut self) {
        if let (true, Some(places)) = (self.pairs.is_empty(), self.pair) {
            let pair = Pair::of(self, [0, 1]);
            self.pairs.push(Pair { cameras: places, ..pair });
        }
        let cameras = self.cameras.len();
        // Those of a photograph are ways to the focal length of one.
        if self.format != Format::Exif && (cameras > 2 || (cameras == 2 && self.pair.is_none())) {
            let name = |at: usize| self.cameras.get(at).map(|camera| camera.name.clone()).unwrap_or_default();
            let pair = self.pair.map(|places| places.map(name));
            self.warnings.push(Warning::Many { cameras, pair });
        }
    }

    /// The same of one camera alone or of two, by their places in `cameras`: baseline and doffs are those of the two, if the files say
    /// anything between them. `None` where there are no such cameras, or more than two are asked for.
    pub fn choose(&self, places: &[usize]) -> Option<Self> {
        let pair = match *places {
            [_] => None,
            [one, other] if one != other => {
                let known = |pair: &&Pair| pair.cameras == [one, other] || pair.cameras == [other, one];
                Some(self.pairs.iter().find(known))
            }
            _ => return None,
        };
        // The left one comes first.
        let order = pair.flatten().map_or(places, |pair| &pair.cameras);
        let cameras = order.iter().map(|at| self.cameras.get(*at).cloned()).collect::<Option<Vec<_>>>()?;
        if self.cameras.len() == cameras.len() {
            return Some(self.clone());
        }
        let is_kept = |warning: &&Warning| {
            let is_chosen = |name: &str| cameras.iter().any(|camera| camera.name == name);
            !warning.is_of_pair() && !warning.follows() && warning.camera().is_none_or(is_chosen)
        };
        let mut found = Self {
            warnings: self.warnings.iter().filter(is_kept).cloned().collect(),
            ignored: self.ignored.clone(),
            cameras,
            ..Self::of(self.format)
        };
        match pair {
            Some(Some(pair)) => {
                found.pairs = vec![Pair {
                    cameras: [0, 1],
                    ..pair.clone()
                }];
                found.take_first_pair();
            }
            Some(None) => found.warnings.push(Warning::NoBaseline { format: self.format }),
            None => {}
        }
        checks::remark(&mut found);
        Some(found)
    }

    /// [`Found::choose`] by names: as the file has them, or their last word where that is of one camera alone.
    ///
    /// # Errors
    /// [`Refusal::NoSuchCamera`]; [`Refusal::TwoCameras`] also where the two are no pair in files that have some.
    pub fn choose_named(&self, names: &[&str]) -> Result<Self, Refusal> {
        let places = names.iter().map(|name| self.place_of(name)).collect::<Result<Vec<_>, _>>()?;
        if let [one, other] = *places
            && !self.pairs.is_empty()
            && !self
                .pairs
                .iter()
                .any(|pair| pair.cameras == [one, other] || pair.cameras == [other, one])
        {
            return Err(Refusal::TwoCameras);
        }
        self.choose(&places).ok_or(Refusal::TwoCameras)
    }

    fn place_of(&self, name: &str) -> Result<usize, Refusal> {
        let name = name.trim();
        let only = |is_it: &dyn Fn(&str) -> bool| {
            let mut all = self.cameras.iter().enumerate().filter(|(_, camera)| is_it(&camera.name));
            all.next().filter(|_| all.next().is_none()).map(|(at, _)| at)
        };
        let by_name = only(&|of| of.eq_ignore_ascii_case(name));
        let by_word = || {
            only(&|of| {
                of.split_whitespace()
                    .next_back()
                    .is_some_and(|word| word.eq_ignore_ascii_case(name))
            })
        };
        by_name.or_else(by_word).ok_or_else(|| Refusal::NoSuchCamera {
            name: name.to_owned(),
            cameras: self.cameras.iter().map(|camera| camera.name.clone()).collect(),
        })
    }

    /// The same where one unit of a file that does not say it is `unit`: nothing is asked, and a baseline of so much may be implausible.
    #[must_use]
    pub fn in_unit(mut self, unit: Length) -> Self {
        self.warnings.retain(|warning| !matches!(warning, Warning::UnitUnknown { .. }));
        if let Some(baseline @ Baseline::InFileUnits { .. }) = self.baseline {
            self.warnings.extend(baseline.length(Some(unit)).and_then(checks::implausible));
        }
        self
    }
}
