//! The Python package `symspline`.
