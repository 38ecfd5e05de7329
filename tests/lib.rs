//! Nothing but a place for tests of the library: see the folders beside this file.
