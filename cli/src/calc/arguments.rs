//! The arguments of a function, taken apart by kind.

use symspline::limits::MAX_DEGREE;
use symspline_dynamic::{AnySpline, Coords, Error, Number, Over, Value};

/// Why a function has no value.
#[derive(Debug, PartialEq)]
pub struct Refusal {
    /// The argument that is at fault; none if all are together.
    pub argument: Option<usize>,
    /// Why.
    pub problem: String,
}

impl<E: Into<Error>> From<E> for Refusal {
    fn from(error: E) -> Self {
        Self { argument: None, problem: error.into().to_string() }
    }
}

/// What a function gives.
pub type Given<T> = Result<T, Refusal>;

/// The arguments of a call, and what is to be told about its result.
#[derive(Debug)]
pub struct Arguments<'a> {
    values: &'a [Value],
    /// Remarks, such as the bound of an approximation.
    pub notes: Vec<String>,
}

impl<'a> Arguments<'a> {
    /// These values.
    pub fn new(values: &'a [Value]) -> Self {
        Self { values, notes: Vec::new() }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.values.len()
    }

    /// One of them.
    pub fn value(&self, i: usize) -> &'a Value {
        &self.values[i]
    }

    /// That an argument is of the wrong kind.
    pub fn wrong<T>(&self, i: usize, wanted: &str) -> Given<T> {
        let problem = format!("{wanted} is expected, not this {}", self.value(i).kind());
        Err(Refusal { argument: Some(i), problem })
    }

    /// A number.
    pub fn number(&self, i: usize) -> Given<&'a Number> {
        match self.value(i) {
            Value::Number(x) => Ok(x),
            _ => self.wrong(i, "a number"),
        }
    }

    /// A whole number that is not negative, and no more than degrees can be.
    pub fn count_of(&self, i: usize) -> Given<usize> {
        let whole = match self.number(i)? {
            Over::Exact(x) => x.to_string().parse().ok(),
            Over::Float(x) if x.fract() == 0.0 && (0.0..=MAX_DEGREE as f64).contains(x) => Some(*x as usize),
            Over::Float(_) => None,
        };
        whole.filter(|n| *n <= MAX_DEGREE).ok_or_else(|| Refusal {
            argument: Some(i),
            problem: format!("a whole number from 0 to {MAX_DEGREE} is expected"),
        })
    }

    /// The numbers from an argument on, of the field of floats if one of them is.
    pub fn numbers_from(&self, first: usize) -> Given<Coords> {
        let numbers = (first..self.count()).map(|i| self.number(i)).collect::<Given<Vec<_>>>()?;
        Ok(gathered(&numbers)?)
    }

    /// A polynomial spline of one parameter.
    pub fn spline(&self, i: usize) -> Given<&'a AnySpline> {
        match self.value(i) {
            Value::Spline(s) => Ok(s),
            _ => self.wrong(i, "a polynomial function or curve"),
        }
    }
}

/// Numbers as coordinates of one field: floats if one of them is.
pub fn gathered(numbers: &[&Number]) -> symspline_dynamic::Result<Coords> {
    use symspline_dynamic::Field;
    if numbers.iter().all(|x| x.is_exact()) {
        return Ok(Over::Exact(numbers.iter().map(|x| Field::of(x)).collect::<Result<_, _>>()?));
    }
    Ok(Over::Float(numbers.iter().map(|x| Field::of(x)).collect::<Result<_, _>>()?))
}
