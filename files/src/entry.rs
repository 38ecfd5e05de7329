//! One thing in a file.

use symspline_dynamic::Value;

/// A value and the name it has in its file.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The name, if it has one.
    pub name: Option<String>,
    /// The value.
    pub value: Value,
}

impl Entry {
    /// A value with a name.
    pub fn named(name: impl Into<String>, value: impl Into<Value>) -> Self {
        Self { name: Some(name.into()), value: value.into() }
    }
}

/// A value without a name.
impl<V: Into<Value>> From<V> for Entry {
    fn from(value: V) -> Self {
        Self { name: None, value: value.into() }
    }
}
