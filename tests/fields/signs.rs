//! All operator signs of a field from five methods: `plus`, `minus`, `times`, `over` and `negative`, with references.

macro_rules! signs {
    ($type:ty: $($sign:ident $name:ident $assign:ident $assign_name:ident $method:ident),* $(,)?) => {
        $(
            impl std::ops::$sign for $type {
                type Output = Self;

                fn $name(self, other: Self) -> Self {
                    self.$method(&other)
                }
            }

            impl std::ops::$sign<&$type> for $type {
                type Output = Self;

                fn $name(self, other: &Self) -> Self {
                    self.$method(other)
                }
            }

            impl std::ops::$assign for $type {
                fn $assign_name(&mut self, other: Self) {
                    *self = self.$method(&other);
                }
            }

            impl std::ops::$assign<&$type> for $type {
                fn $assign_name(&mut self, other: &Self) {
                    *self = self.$method(other);
                }
            }
        )*

        impl std::ops::Neg for $type {
            type Output = Self;

            fn neg(self) -> Self {
                self.negative()
            }
        }

        impl num_traits::Zero for $type {
            fn zero() -> Self {
                <Self as symspline::Scalar>::int(0)
            }

            fn is_zero(&self) -> bool {
                *self == Self::zero()
            }
        }

        impl num_traits::One for $type {
            fn one() -> Self {
                <Self as symspline::Scalar>::int(1)
            }
        }
    };
    ($type:ty) => {
        signs! {
            $type:
            Add add AddAssign add_assign plus,
            Sub sub SubAssign sub_assign minus,
            Mul mul MulAssign mul_assign times,
            Div div DivAssign div_assign over,
        }
    };
}

/// The same, and `Display`, for a tuple struct around another field.
macro_rules! wrapped {
    ($type:ty) => {
        impl $type {
            fn plus(&self, other: &Self) -> Self {
                Self(&self.0 + &other.0)
            }

            fn minus(&self, other: &Self) -> Self {
                Self(&self.0 - &other.0)
            }

            fn times(&self, other: &Self) -> Self {
                Self(&self.0 * &other.0)
            }

            fn over(&self, other: &Self) -> Self {
                Self(&self.0 / &other.0)
            }

            fn negative(&self) -> Self {
                Self(-&self.0)
            }
        }

        signs!($type);

        impl std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                self.0.fmt(f)
            }
        }
    };
}
pub(crate) use {signs, wrapped};
