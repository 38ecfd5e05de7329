//! Reading `cases.json`: every exact number is a text `p/q`, read as `Q` and handed out in the field asked for.

use nalgebra::SVector;
use serde_json::Value;
use std::sync::LazyLock;
use symspline::{Curve, Function, Q, Result, Scalar, SplineSpace};

static FILE: LazyLock<Value> =
    LazyLock::new(|| serde_json::from_str(include_str!("cases.json")).expect("cases.json is JSON"));

/// A field the numbers of the file can be brought into.
pub trait Field: Scalar {
    /// The number `q`, rounded to nearest where the field cannot hold it.
    fn of(q: &Q) -> Self;
}

impl Field for Q {
    fn of(q: &Q) -> Self {
        q.clone()
    }
}

impl Field for f64 {
    fn of(q: &Q) -> Self {
        q.to_f64()
    }
}

/// One case: an object of numbers, lists of numbers and lists of points.
#[derive(Clone, Copy, Debug)]
pub struct Case(&'static Value);

/// The names of the categories in the file, with the number of cases the file's header promises.
pub fn categories() -> Vec<(&'static str, usize)> {
    let counts = FILE["header"]["counts"].as_object().expect("the header counts the cases");
    counts.iter().map(|(name, count)| (name.as_str(), count.as_u64().expect("a count") as usize)).collect()
}

/// The cases of a category.
pub fn cases(category: &str) -> Vec<Case> {
    let list = FILE["cases"][category].as_array().unwrap_or_else(|| panic!("no category {category}"));
    list.iter().map(Case).collect()
}

impl Case {
    /// The name of the case.
    pub fn id(self) -> &'static str {
        self.0["id"].as_str().expect("every case has an id")
    }

    /// The entry `key`.
    pub fn get(self, key: &str) -> Self {
        Self(self.0.get(key).unwrap_or_else(|| panic!("no entry {key} in {}", self.0)))
    }

    /// A word.
    pub fn text(self) -> &'static str {
        self.0.as_str().unwrap_or_else(|| panic!("{} is no text", self.0))
    }

    /// Whether there is an entry `key`.
    pub fn has(self, key: &str) -> bool {
        self.0.get(key).is_some()
    }

    /// A yes or no.
    pub fn flag(self) -> bool {
        self.0.as_bool().unwrap_or_else(|| panic!("{} is no yes or no", self.0))
    }

    /// Whether the entry `key` is null: what is asked for must be refused.
    pub fn refused(self, key: &str) -> bool {
        self.get(key).0.is_null()
    }

    /// The entries of a list.
    pub fn list(self) -> impl ExactSizeIterator<Item = Self> {
        self.0.as_array().unwrap_or_else(|| panic!("{} is no list", self.0)).iter().map(Self)
    }

    /// The entries of an object whose keys are indices.
    pub fn entries(self) -> impl Iterator<Item = (usize, Self)> {
        let object = self.0.as_object().unwrap_or_else(|| panic!("{} is no object", self.0));
        object.iter().map(|(key, value)| (key.parse().expect("an index"), Self(value)))
    }

    /// An index, degree or count.
    pub fn integer(self) -> usize {
        self.0.as_u64().unwrap_or_else(|| panic!("{} is no index", self.0)) as usize
    }

    /// A number.
    pub fn number<T: Field>(self) -> T {
        let text = self.0.as_str().unwrap_or_else(|| panic!("{} is no number", self.0));
        T::of(&text.parse().unwrap_or_else(|error| panic!("{error}")))
    }

    /// A number of a floating-point case.
    pub fn float(self) -> f64 {
        self.0.as_f64().unwrap_or_else(|| panic!("{} is no float", self.0))
    }

    /// A list of numbers.
    pub fn numbers<T: Field>(self) -> Vec<T> {
        self.list().map(Self::number).collect()
    }

    /// A list of lists of numbers: points, or the rows of a matrix.
    pub fn rows<T: Field>(self) -> Vec<Vec<T>> {
        self.list().map(Self::numbers).collect()
    }

    /// A list of points in `N` dimensions.
    pub fn points<T: Field, const N: usize>(self) -> Vec<SVector<T, N>> {
        let point = |row: Vec<T>| {
            assert_eq!(row.len(), N, "{} has points of another dimension", self.0);
            SVector::from_vec(row)
        };
        self.rows().into_iter().map(point).collect()
    }

    /// The number of coordinates of the points `P` (or of the vertices `polygon`).
    pub fn dimension(self) -> usize {
        let points = self.0.get("P").or(self.0.get("polygon")).expect("a case with points");
        points[0].as_array().expect("a point").len()
    }

    /// The space of degree `degree` over the full knot vector `knots`, both given as keys.
    pub fn space<T: Field>(self, degree: &str, knots: &str) -> Result<SplineSpace<T>> {
        SplineSpace::new(self.get(degree).integer(), self.get(knots).numbers::<T>())
    }

    /// The curve with degree `degree`, knots `U` and control points `P`.
    pub fn curve<T: Field, const N: usize>(self, degree: &str) -> Result<Curve<T, N>> {
        Curve::new(self.space(degree, "U")?, self.get("P").points())
    }

    /// The function of degree `q` with knots `V` and coefficients `coeffs`.
    pub fn function<T: Field>(self, coeffs: &str) -> Result<Function<T>> {
        Function::new(self.space("q", "V")?, self.get(coeffs).numbers())
    }
}
