//! How many times `f64` does exact arithmetic take, and how many times that do plain big fractions take?
//!
//! The same generic text runs over all of them, in turn in one process. Small fractions and lossless images of `f64` are
//! what knots and points are in practice.

#![allow(clippy::print_stdout, reason = "a bench reports")]

mod plain;
mod ratios;

use numbers::{FLOATS, FRACTIONS, IMAGES, Numbers};
use plain::Plain;
use ratios::{Candidate, candidate, compare};
use symspline::{Curve, Function, Q, Result, Scalar};

/// Of the curve and the factors.
const SPANS: usize = 100;

/// Parameters, ten a span: few, as other work on the machine disturbs long rounds.
const PARAMETERS: usize = 200;

fn main() -> Result<()> {
    let floats = Case::new(&FLOATS)?;
    let small = Case::new(&FRACTIONS)?;
    let images = Case { parameters: exact(&floats.parameters)?, ..Case::new(&IMAGES)? };
    let (plain_small, plain_images) = (small.plain()?, images.plain()?);
    for (i, (what, _)) in floats.questions().into_iter().enumerate() {
        let candidates = vec![
            floats.question(i, "f64"),
            small.question(i, "small"),
            images.question(i, "images"),
            plain_small.question(i, "plain small"),
            plain_images.question(i, "plain images"),
        ];
        let times = compare(what, candidates);
        println!(
            "{:>26} faster than plain: small {:.1}, images {:.1}",
            "",
            times[3] / times[1],
            times[4] / times[2]
        );
    }
    growth("small", &small)?;
    growth("images", &images)
}

fn exact(parameters: &[f64]) -> Result<Vec<Q>> {
    parameters.iter().map(|x| Q::try_from(*x)).collect()
}

/// A cubic space curve with parameters, ten a span in order, and cubic functions.
struct Case<T: Scalar> {
    curve: Curve<T, 3>,
    parameters: Vec<T>,
    function: Function<T>,
}

type Ask<T> = fn(&Case<T>) -> Result<()>;

impl<T: Scalar> Case<T> {
    fn new(numbers: &Numbers<T>) -> Result<Self> {
        let inside = |i: usize| {
            let [a, b] = [i / 10, i / 10 + 1].map(numbers.knot);
            (b - &a) * T::frac((i % 10) as i64, 10) + a
        };
        let parameters = (0..PARAMETERS).map(inside).collect();
        Ok(Self { curve: numbers.curve(3, SPANS)?, parameters, function: numbers.function(3, SPANS)? })
    }

    fn questions(&self) -> [(&'static str, Ask<T>); 6] {
        [
            ("at", |case| case.parameters.iter().try_for_each(|x| keep(case.curve.at(x)))),
            ("eval", |case| keep(case.curve.eval(&case.parameters))),
            ("elevation", |case| keep(case.curve.elevated(1))),
            ("elevation 3 -> 7", |case| keep(case.function.elevated(4))),
            ("product", |case| keep(case.function.times(&case.function))),
            ("product with a curve", |case| keep(case.curve.times(&case.function))),
        ]
    }

    fn question<'a>(&'a self, index: usize, name: &str) -> Candidate<'a> {
        let ask = self.questions()[index].1;
        candidate(name, move || ask(self))
    }
}

fn keep<R>(result: Result<R>) -> Result<()> {
    std::hint::black_box(result).map(drop)
}

impl Case<Q> {
    fn plain(&self) -> Result<Case<Plain>> {
        let plain = |q: &Q| Ok(Plain::from(q.clone()));
        Ok(Case {
            curve: self.curve.map_scalars(plain)?,
            parameters: self.parameters.iter().map(plain).collect::<Result<_>>()?,
            function: self.function.map_scalars(plain)?,
        })
    }
}

/// Prints how many bits the coefficients of results have, at most and in the mean, and checks them against plain fractions.
fn growth(name: &str, case: &Case<Q>) -> Result<()> {
    let plain = case.plain()?;
    let (f, g) = (&case.function, &plain.function);
    let pairs = [
        ("coefficients", f.clone(), g.clone()),
        ("elevation 3 -> 7", f.elevated(4)?, g.elevated(4)?),
        ("product", f.times(f)?, g.times(g)?),
    ];
    for (what, exact, plain) in pairs {
        let bits: Vec<u64> = exact.coeffs().iter().map(Q::bits).collect();
        let mean = bits.iter().sum::<u64>() / bits.len() as u64;
        println!("bits of {what}, {name}: at most {}, mean {mean}", bits.iter().max().expect("coefficients"));
        assert!(exact.coeffs().iter().zip(plain.coeffs()).all(|(q, p)| Plain::from(q.clone()) == *p));
    }
    let values = case.curve.eval(&case.parameters)?;
    let most = values.iter().flat_map(|c| c.iter().map(Q::bits)).max();
    println!("bits of a value, {name}: at most {}", most.expect("values"));
    assert_eq!(values, case.parameters.iter().map(|x| case.curve.at(x)).collect::<Result<Vec<_>>>()?);
    Ok(())
}
