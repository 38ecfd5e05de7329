//! Classes of named results.

/// A class of named results: what it is made from is what it holds.
macro_rules! record {
    ($module:literal $(#[$doc:meta])* $name:ident { $($(#[$field_doc:meta])* $field:ident: $type:ty,)+ }) => {
        $(#[$doc])*
        #[pyo3::pyclass(frozen, get_all, eq, module = $module, from_py_object)]
        #[derive(Clone, Debug, PartialEq)]
        pub struct $name {
            $($(#[$field_doc])* pub $field: $type,)+
        }

        #[pyo3::pymethods]
        impl $name {
            #[new]
            #[allow(clippy::too_many_arguments, reason = "as many as fields")]
            fn new($($field: $type),+) -> Self {
                Self { $($field),+ }
            }

            /// The class and what it holds: nothing is lost.
            #[allow(clippy::type_complexity, reason = "it is the tuple that pickle asks for")]
            fn __reduce__<'py>(slf: &pyo3::Bound<'py, Self>) -> (pyo3::Bound<'py, pyo3::PyAny>, ($($type,)+)) {
                use pyo3::types::PyAnyMethods as _;
                (slf.get_type().into_any(), ($(slf.get().$field.clone(),)+))
            }

            fn __repr__(slf: &pyo3::Bound<'_, Self>) -> pyo3::PyResult<String> {
                use pyo3::types::PyAnyMethods as _;
                let fields: Vec<String> =
                    vec![$(format!("{}={}", stringify!($field), slf.getattr(stringify!($field))?.repr()?)),+];
                Ok(format!("{}({})", stringify!($name), fields.join(", ")))
            }
        }
    };
}
pub(crate) use record;
