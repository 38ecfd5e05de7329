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
pub(crate) use signs;
