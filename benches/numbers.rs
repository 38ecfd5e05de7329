//! What the benches run on: uneven knots and wavy coefficients, over `f64` and twice over `Q`.

use criterion::{BenchmarkGroup, Criterion, measurement::WallTime};
use nalgebra::SVector;
use std::time::Duration;
use symspline::{Coeff, Curve, Function, Q, Result, Scalar, SplineSpace, Surface, TensorSpline};

/// Where the measurements of a question go.
pub type Group<'a> = BenchmarkGroup<'a, WallTime>;

/// A question asked of every kind of number.
pub trait Question {
    /// What the question is called.
    const NAME: &'static str;
    /// How large a case is: a number of spans, points, both.
    type Size: Copy + 'static;
    /// The sizes over `f64`.
    const FLOATS: &'static [Self::Size];
    /// The sizes over small fractions.
    const FRACTIONS: &'static [Self::Size];
    /// The sizes over the images of `f64`.
    const IMAGES: &'static [Self::Size] = Self::FRACTIONS;

    /// Checks the results, then measures.
    fn ask<T: Scalar>(group: &mut Group<'_>, numbers: &Numbers<T>, size: Self::Size) -> Result<()>;
}

/// Asks a question of all sizes over `f64` and over `Q`.
pub fn ask<A: Question>(criterion: &mut Criterion) -> Result<()> {
    let group = &mut criterion.benchmark_group(A::NAME);
    A::FLOATS.iter().try_for_each(|size| A::ask(group, &FLOATS, *size))?;
    A::FRACTIONS.iter().try_for_each(|size| A::ask(group, &FRACTIONS, *size))?;
    A::IMAGES.iter().try_for_each(|size| A::ask(group, &IMAGES, *size))
}

/// The `main` of a bench of one question.
pub fn run<A: Question>() -> Result<()> {
    let mut criterion = criterion();
    ask::<A>(&mut criterion)?;
    criterion.final_summary();
    Ok(())
}

/// A field with a way to make knots and coefficients in it.
#[derive(Debug)]
pub struct Numbers<T> {
    /// What the field is called.
    pub name: &'static str,
    /// Break `i`, about `i`.
    pub knot: fn(usize) -> T,
    /// Coefficient `i`, at most 1 in magnitude.
    pub value: fn(usize) -> T,
    /// The unit of rounding errors.
    pub epsilon: fn() -> T,
}

/// Knots and coefficients as floats.
pub const FLOATS: Numbers<f64> = Numbers { name: "f64", knot: uneven, value: wave, epsilon: || f64::EPSILON };

/// Knots and coefficients with one-digit denominators.
pub const FRACTIONS: Numbers<Q> = Numbers {
    name: "Q small",
    knot: |i| Q::frac((5 * i + i * i % 3) as i64, 5),
    value: |i| Q::frac((7 * i % 11) as i64 - 5, 6),
    epsilon: || Q::int(0),
};

/// The lossless images of [`FLOATS`].
pub const IMAGES: Numbers<Q> = Numbers {
    name: "Q images",
    knot: |i| Q::try_from(uneven(i)).expect("knots are finite"),
    value: |i| Q::try_from(wave(i)).expect("coefficients are finite"),
    epsilon: || Q::int(0),
};

fn uneven(i: usize) -> f64 {
    i as f64 + 0.3 * (i as f64).sin()
}

fn wave(i: usize) -> f64 {
    (0.7 * i as f64).cos()
}

/// Numbers in `[0, 1)` from a congruential generator: no cache or predictor follows it.
pub fn random(count: usize) -> impl Iterator<Item = f64> {
    let next =
        |s: &u64| Some(s.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407));
    let states = std::iter::successors(Some(1), next).skip(1).take(count);
    states.map(|s: u64| (s >> 11) as f64 / (1_u64 << 53) as f64)
}

impl<T: Scalar> Numbers<T> {
    /// The clamped space with `spans` spans and simple knots.
    pub fn space(&self, degree: usize, spans: usize) -> Result<SplineSpace<T>> {
        SplineSpace::clamped(degree, (0..=spans).map(self.knot))
    }

    /// A function with `spans` spans.
    pub fn function(&self, degree: usize, spans: usize) -> Result<Function<T>> {
        let space = self.space(degree, spans)?;
        let coeffs = (0..space.dim()).map(self.value).collect();
        Function::new(space, coeffs)
    }

    /// A curve with `spans` spans.
    pub fn curve<const N: usize>(&self, degree: usize, spans: usize) -> Result<Curve<T, N>> {
        let space = self.space(degree, spans)?;
        let point = |i: usize| SVector::from_fn(|axis, _| (self.value)(N * i + axis));
        let coeffs = (0..space.dim()).map(point).collect();
        Curve::new(space, coeffs)
    }

    /// A scalar surface with `spans` spans in both directions.
    pub fn field(&self, degree: usize, spans: usize) -> Result<TensorSpline<T>> {
        let space = self.space(degree, spans)?;
        let coeffs = (0..space.dim() * space.dim()).map(self.value).collect();
        TensorSpline::new(space.clone(), space, coeffs)
    }

    /// A surface with `spans` spans in both directions.
    pub fn surface<const N: usize>(&self, degree: usize, spans: usize) -> Result<Surface<T, N>> {
        let space = self.space(degree, spans)?;
        let point = |i: usize| SVector::from_fn(|axis, _| (self.value)(N * i + axis));
        let coeffs = (0..space.dim() * space.dim()).map(point).collect();
        Surface::new(space.clone(), space, coeffs)
    }

    /// About `count` parameters all over the domain of `spans` spans, for checks.
    pub fn samples(&self, spans: usize, count: usize) -> Vec<T> {
        let step = spans.div_ceil(count);
        let part = |i: usize| {
            let [a, b] = [i, i + 1].map(self.knot);
            (a * T::int(2) + b) / T::int(3)
        };
        (0..spans).step_by(step).map(part).collect()
    }
}

/// Requires equal vectors: over an exact field exactly, else up to `accuracy` a component.
pub fn assert_close<T: Scalar, C: Coeff<T>>(found: &C, expected: &C, accuracy: T) {
    let limit = if T::EXACT { T::zero() } else { accuracy };
    let error = found.minus(expected);
    assert!(error.components().all(|e| e.magnitude() <= limit), "{found:?} instead of {expected:?}");
}

/// Short runs: the whole of `cargo bench` is meant to take three minutes.
pub fn criterion() -> Criterion {
    Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(100))
        .measurement_time(Duration::from_millis(400))
        .configure_from_args()
}
