//! What does fine tuning cost? The three plane curves of [Miura] Table 1, by their sizes: degree and number of
//! control points of the curve, degree and number of values of the scale function; uniform clamped knots.
//!
//! Whole, that is differentiation, product and integration; while a value of the scale is dragged, with each hold and under
//! conditions; and whole by the recurrence for products of B-splines, written as it stands: the way of the paper.

use nalgebra::SVector;
use numbers::{Group, Numbers, Question, assert_close};
use std::hint::black_box;
use symspline::{Condition, Curve, FineTuner, Function, Hold, Norm, Result, Scalar, SplineSpace};

fn main() -> Result<()> {
    numbers::run::<FineTuning>()
}

struct FineTuning;

impl Question for FineTuning {
    const NAME: &'static str = "fine tune";
    type Size = [(usize, usize); 2];
    const FLOATS: &'static [Self::Size] = &[[(2, 181), (1, 2)], [(3, 72), (2, 6)], [(3, 159), (2, 3)]];
    const FRACTIONS: &'static [Self::Size] = Self::FLOATS;

    fn ask<T: Scalar>(
        group: &mut Group<'_>,
        numbers: &Numbers<T>,
        [(degree, points), (alpha_degree, values)]: Self::Size,
    ) -> Result<()> {
        let epsilon = (numbers.epsilon)();
        let control = |i: usize| SVector::from_fn(|axis, _| (numbers.value)(2 * i + axis));
        let curve = Curve::<T, 2>::new(uniform(degree, points)?, (0..points).map(control).collect())?;
        // Between 1 and 3, so that the tangent keeps its direction.
        let scale = (0..values).map(|i| (numbers.value)(i) + T::int(2)).collect();
        let alpha = Function::new(uniform(alpha_degree, values)?, scale)?;

        let tuned = curve.fine_tuned(&alpha)?;
        for x in (0..20).map(|i| T::frac(3 * i + 1, 60)) {
            let expected = curve.derivative_at(&x, 1)? * alpha.at(&x)?;
            assert_close(
                &tuned.derivative_at(&x, 1)?,
                &expected,
                epsilon.clone() * T::int(100 * points as i64),
            );
        }
        let name = format!("degree {degree}, {points} points/{}", numbers.name);
        group.bench_function(name, |b| b.iter(|| black_box(&curve).fine_tuned(&alpha)));

        let reference = by_recurrence(&curve, &alpha)?;
        for x in (0..20).map(|i| T::frac(3 * i + 1, 60)) {
            assert_close(&reference.at(&x)?, &tuned.at(&x)?, epsilon.clone() * T::int(1000 * points as i64));
        }
        let name = format!("degree {degree}, {points} points, by recurrence/{}", numbers.name);
        group.bench_function(name, |b| b.iter(|| by_recurrence(black_box(&curve), &alpha)));

        // While a value of the scale is dragged.
        let scales = alpha.space();
        let kept = [Condition::Coefficient { index: 0, value: T::int(2) }];
        let end = [Condition::End];
        let conditions = if scales.dim() > 2 { &end } else { &kept };
        let tuners = [
            ("start held", FineTuner::free(&curve, scales)?),
            ("ends held", FineTuner::prepare(&curve, scales, Hold::Points)?),
            ("curvatures held", FineTuner::prepare(&curve, scales, Hold::Curvatures)?),
            ("under a condition", FineTuner::constrained(&curve, scales, conditions, Norm::L2)?.signed()),
        ];
        for (what, tuner) in tuners {
            let mut places = tuner.tuned(alpha.coeffs())?.into_coeffs();
            let name = format!("degree {degree}, {points} points, a drag, {what}/{}", numbers.name);
            group.bench_function(name, |b| {
                b.iter(|| tuner.tune_into(black_box(alpha.coeffs()), &mut places));
            });
        }
        Ok(())
    }
}

/// The clamped space of dimension `dim` over uniform knots from 0 to 1.
fn uniform<T: Scalar>(degree: usize, dim: usize) -> Result<SplineSpace<T>> {
    let spans = (dim - degree) as i64;
    SplineSpace::clamped(degree, (0..=spans).map(|i| T::frac(i, spans)))
}

/// The curve fine-tuned with the product by recurrence.
fn by_recurrence<T: Scalar>(curve: &Curve<T, 2>, alpha: &Function<T>) -> Result<Curve<T, 2>> {
    let speed = curve.derivative()?;
    let space = speed.space().product_space(alpha.space())?;
    let (tau, r) = (space.knots(), space.degree());
    let coefficient = |k: usize| {
        // A span of the support, and the spans of the factors that hold it.
        let on = (k..=k + r).find(|&l| tau[l] < tau[l + 1]).expect("a support has a span");
        let [f, g] = [speed.space(), alpha.space()].map(|space| Factor::on(space, &tau[on]));
        let mut sum = SVector::zeros();
        for i in f.span - f.degree..=f.span {
            for j in g.span - g.degree..=g.span {
                let weight = weight(&tau[k + 1..=k + r], &f.basis(i), &g.basis(j));
                sum += speed.coeffs()[i].map(|x| x * &alpha.coeffs()[j] * &weight);
            }
        }
        sum
    };
    let product = Curve::new(space.clone(), (0..space.dim()).map(coefficient).collect())?;
    product.antiderivative()?.translated(&curve.coeffs()[0])
}

/// A factor of a product, looked at on one of its spans.
struct Factor<'a, T> {
    knots: &'a [T],
    degree: usize,
    span: usize,
}

/// B-spline `index` of some degree of a factor.
struct Basis<'a, T> {
    knots: &'a [T],
    degree: usize,
    index: usize,
    span: usize,
}

impl<'a, T: Scalar> Factor<'a, T> {
    fn on(space: &'a SplineSpace<T>, x: &T) -> Self {
        let span = space.locate(x).expect("inside");
        Self { knots: space.knots(), degree: space.degree(), span }
    }

    fn basis(&self, index: usize) -> Basis<'a, T> {
        Basis { knots: self.knots, degree: self.degree, index, span: self.span }
    }
}

impl<T: Scalar> Basis<'_, T> {
    /// The B-splines of one degree less that this one is made of at `x`, with their weights.
    fn parts(&self, x: &T) -> [(T, Self); 2] {
        let share = |i: usize| {
            let (t, p) = (self.knots, self.degree);
            let width = t[i + p].clone() - &t[i];
            (!width.is_zero()).then(|| (x.clone() - &t[i]) / width)
        };
        let one = |index: usize| Basis { knots: self.knots, degree: self.degree - 1, index, span: self.span };
        let rising = share(self.index).unwrap_or_else(T::zero);
        let falling = share(self.index + 1).map_or_else(T::zero, |share| T::one() - share);
        [(rising, one(self.index)), (falling, one(self.index + 1))]
    }
}

/// What the product of two B-splines has of the B-spline with the knots `args` inside: the recurrence over both degrees.
fn weight<T: Scalar>(args: &[T], f: &Basis<'_, T>, g: &Basis<'_, T>) -> T {
    let Some((x, args)) = args.split_last() else {
        return if f.index == f.span && g.index == g.span { T::one() } else { T::zero() };
    };
    let order = (f.degree + g.degree) as i64;
    let mut sum = T::zero();
    if f.degree > 0 {
        for (share, part) in f.parts(x) {
            sum += share * T::frac(f.degree as i64, order) * weight(args, &part, g);
        }
    }
    if g.degree > 0 {
        for (share, part) in g.parts(x) {
            sum += share * T::frac(g.degree as i64, order) * weight(args, f, &part);
        }
    }
    sum
}
