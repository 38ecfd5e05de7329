//! The signs `+`, `-` and `*` by a number, for values and references, from the named operators.

/// Implements `Add`, `Sub`, `Neg` and `Mul` by a scalar through `sum`, `difference` and `scaled`.
macro_rules! signs {
    ([$($parameters:tt)*] $type:ty, $scalar:ty) => {
        $crate::ops::signs::signs!(@pair [$($parameters)*] $type, Add add sum, "The sum");
        $crate::ops::signs::signs!(@pair [$($parameters)*] $type, Sub sub difference, "The difference");

        impl<$($parameters)*> std::ops::Neg for &$type {
            type Output = $type;

            fn neg(self) -> $type {
                self.scaled(&-<$scalar as num_traits::One>::one())
                    .expect("finite coefficients have finite negatives")
            }
        }

        impl<$($parameters)*> std::ops::Neg for $type {
            type Output = $type;

            fn neg(self) -> $type {
                -&self
            }
        }

        impl<$($parameters)*> std::ops::Mul<$scalar> for &$type {
            type Output = $type;

            /// The multiple.
            ///
            /// # Panics
            /// With the text of the error of `scaled`.
            fn mul(self, factor: $scalar) -> $type {
                self.scaled(&factor).unwrap_or_else(|error| panic!("{error}"))
            }
        }

        impl<$($parameters)*> std::ops::Mul<$scalar> for $type {
            type Output = $type;

            fn mul(self, factor: $scalar) -> $type {
                &self * factor
            }
        }
    };
    (@pair [$($parameters:tt)*] $type:ty, $sign:ident $operator:ident $named:ident, $what:literal) => {
        impl<$($parameters)*> std::ops::$sign for &$type {
            type Output = $type;

            #[doc = $what]
            ///
            /// # Panics
            /// With the text of the error of the named operator.
            fn $operator(self, other: Self) -> $type {
                self.$named(other).unwrap_or_else(|error| panic!("{error}"))
            }
        }

        impl<$($parameters)*> std::ops::$sign for $type {
            type Output = $type;

            fn $operator(self, other: Self) -> $type {
                std::ops::$sign::$operator(&self, &other)
            }
        }

        impl<$($parameters)*> std::ops::$sign<&$type> for $type {
            type Output = $type;

            fn $operator(self, other: &$type) -> $type {
                std::ops::$sign::$operator(&self, other)
            }
        }

        impl<$($parameters)*> std::ops::$sign<$type> for &$type {
            type Output = $type;

            fn $operator(self, other: $type) -> $type {
                std::ops::$sign::$operator(self, &other)
            }
        }
    };
}

pub(crate) use signs;
