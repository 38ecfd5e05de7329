//! Arithmetic against big fractions, on numbers around every border.

use super::*;
use nalgebra::{SMatrix, SVector};
use num_bigint::Sign;
use num_rational::BigRational;
use num_traits::Signed;
use proptest::prelude::*;
use std::hash::{BuildHasher, BuildHasherDefault, DefaultHasher};

/// Integers around everything that could go wrong: zero, the ends of a word, powers of two, and far beyond.
pub(super) fn integer() -> impl Strategy<Value = BigInt> {
    let huge = prop::collection::vec(any::<u32>(), 1..14).prop_map(|digits| BigInt::new(Sign::Plus, digits));
    let power = (0..200u32, -1..=1i64).prop_map(|(k, n)| (BigInt::one() << k) + n);
    let border = (62..=65u32, -2..=2i64).prop_map(|(k, n)| (BigInt::one() << k) + n);
    let extreme =
        prop::sample::select(vec![i64::MIN, i64::MIN + 1, i64::MAX - 1, i64::MAX]).prop_map(BigInt::from);
    let word = (any::<i64>(), 0..63).prop_map(|(n, k)| BigInt::from(n >> k));
    let few = (-12..=12i64).prop_map(BigInt::from);
    let size = prop_oneof![4 => few, 2 => extreme, 3 => border, 2 => power, 3 => word, 1 => huge];
    (size, any::<bool>()).prop_map(|(n, minus)| if minus { -n } else { n })
}

/// Fractions of such integers, integers, and images of machine numbers.
pub(super) fn rational() -> impl Strategy<Value = BigRational> {
    let fraction =
        (integer(), integer()).prop_map(|(p, q)| if q.is_zero() { p.into() } else { BigRational::new(p, q) });
    let dyadic = (integer(), 0..140u32).prop_map(|(p, k)| BigRational::new(p, BigInt::one() << k));
    let float = (-1e6..1e6f64).prop_map(|x| BigRational::from_float(x).unwrap());
    prop_oneof![2 => integer().prop_map(BigRational::from), 4 => fraction, 2 => dyadic, 2 => float]
}

/// The value is right, and so is the form, which a detour must not change.
pub(super) fn check(q: &Q, r: &BigRational) {
    assert_eq!((&q.numer(), &q.denom()), (r.numer(), r.denom()));
    let fits = |n: &BigInt| n.magnitude().to_i64().is_some();
    assert_eq!(matches!(q.0, Small { .. }), fits(r.numer()) && fits(r.denom()), "form of {r}");
    let hash = |q: &Q| BuildHasherDefault::<DefaultHasher>::default().hash_one(q);
    let same = Q::from(r.clone());
    assert!(*q == same && hash(q) == hash(&same) && q.cmp(&same).is_eq());
    assert_eq!((q.is_zero(), q.is_one(), q.is_integer()), (r.is_zero(), r.is_one(), r.is_integer()));
    assert_eq!((q.is_negative(), q.bits()), (r.is_negative(), r.numer().bits() + r.denom().bits()));
}

macro_rules! check_forms {
    ($x:ident $y:ident $r:ident $s:ident; $($op:tt $assign:tt)*) => {$(
        let expected = &$r $op &$s;
        check(&(&$x $op &$y), &expected);
        check(&(&$x $op $y.clone()), &expected);
        check(&($x.clone() $op &$y), &expected);
        check(&($x.clone() $op $y.clone()), &expected);
        let (mut by_value, mut by_reference) = ($x.clone(), $x.clone());
        by_value $assign $y.clone();
        by_reference $assign &$y;
        check(&by_value, &expected);
        check(&by_reference, &expected);
    )*};
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn arithmetic_is_that_of_big_fractions(r in rational(), s in rational()) {
        let (x, y) = (Q::from(r.clone()), Q::from(s.clone()));
        check_forms!(x y r s; + += - -= * *=);
        if !s.is_zero() {
            check_forms!(x y r s; / /=);
            check(&y.recip(), &s.recip());
        }
        check(&-&x, &-&r);
        check(&-x.clone(), &-&r);
        check(&x.abs(), &r.abs());
        check(&x.magnitude(), &r.abs());
        prop_assert_eq!(x.cmp(&y), r.cmp(&s));
        prop_assert_eq!(x == y, r == s);
    }

    #[test]
    fn what_is_added_can_be_taken_away(r in rational(), s in rational()) {
        let (x, y) = (Q::from(r.clone()), Q::from(s.clone()));
        check(&(&(&x + &y) - &y), &r);
        check(&(&x - &x), &BigRational::zero());
        if !s.is_zero() {
            check(&(&(&x * &y) / &y), &r);
            check(&(&y / &y), &BigRational::one());
        }
    }

    #[test]
    fn neighbours_are_ordered(r in rational(), k in 1..200u32) {
        let (x, gap) = (Q::from(r), Q::from(BigRational::new(1.into(), BigInt::one() << k)));
        prop_assert!(x < &x + &gap && &x - &gap < x);
    }

    #[test]
    fn sums_and_products_fold(rs in prop::collection::vec(rational(), 0..5)) {
        let qs: Vec<_> = rs.iter().cloned().map(Q::from).collect();
        let (sum, product) = (rs.iter().sum(), rs.iter().product());
        check(&qs.iter().sum(), &sum);
        check(&qs.iter().product(), &product);
        check(&qs.iter().cloned().sum(), &sum);
        check(&qs.into_iter().product(), &product);
    }

    #[test]
    fn words_make_fractions(p in integer(), q in integer(), n: i32) {
        if let (Some(p), Some(q)) = (p.to_i64(), q.to_i64()) {
            check(&Q::int(p), &BigRational::from(BigInt::from(p)));
            match Q::new(p, q) {
                Ok(x) => check(&x, &BigRational::new(p.into(), q.into())),
                Err(e) => prop_assert!(q == 0 && e.to_string().contains("the denominator is zero")),
            }
        }
        check(&Q::from(p.clone()), &p.into());
        check(&Q::from(n), &BigRational::from(BigInt::from(n)));
    }
}

#[test]
fn the_ends_of_a_word_have_one_form() {
    let end = Q::int(i64::MIN);
    check(&-&end, &BigRational::from(-BigInt::from(i64::MIN)));
    check(&-(-&end), &BigRational::from(BigInt::from(i64::MIN)));
    check(&Q::frac(i64::MIN, i64::MIN), &BigRational::one());
    check(&Q::frac(1, i64::MIN), &BigRational::new(1.into(), i64::MIN.into()));
    assert_eq!(Q::default(), Q::zero());
    assert!(Q::EXACT && Scalar::is_finite(&end));
}

#[test]
#[should_panic(expected = "division of a rational number by zero")]
fn division_by_zero_panics() {
    let _ = Q::one() / Q::zero();
}

#[test]
#[should_panic(expected = "the denominator of a fraction is not zero")]
fn a_fraction_over_zero_panics() {
    let _ = Q::frac(1, 0);
}

#[test]
fn vectors_and_matrices_work() {
    let v = |x: [i64; 3]| SVector::<Q, 3>::from(x.map(|n| Q::frac(n, 6)));
    let (a, b) = (v([1, 2, 3]), v([6, 0, -3]));
    assert_eq!(&a + &b, v([7, 2, 0]));
    assert_eq!(a.clone() - &b, v([-5, 2, 6]));
    assert_eq!(&a * Q::int(2), v([2, 4, 6]));
    assert_eq!(&a / Q::frac(1, 2), v([2, 4, 6]));
    assert_eq!(a.dot(&b), Q::frac(-1, 12));
    assert_eq!(SMatrix::<Q, 3, 3>::identity() * &a, a);
    assert_eq!(-&a, a.map(|x| -x));
}
