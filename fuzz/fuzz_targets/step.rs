#![no_main]

#[path = "../../files/tests/fuzz/law.rs"]
mod law;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    law::holds(bytes, symspline_files::Format::Step);
});
