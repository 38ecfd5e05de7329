//! The rows of the table: inputs, exact values, and who takes part.

pub mod curves;
pub mod operators;
pub mod products;
pub mod surfaces;

/// Enters all kinds that are compiled in: `enter!(call(race, ..): Kind, ..; "feature" => Kind, ..)`.
#[macro_export]
macro_rules! enter {
    ($call:ident $arguments:tt: $($kind:ty),*; $($feature:literal => $peer:ty),* $(,)?) => {
        $( $call::<$kind> $arguments; )*
        $( #[cfg(feature = $feature)] $call::<$peer> $arguments; )*
    };
}

/// Some fifty indices below `count`, the last one included.
pub fn spread(count: usize) -> Vec<usize> {
    (0..50).map(|i| i * (count - 1) / 49).collect()
}
