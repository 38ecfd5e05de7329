//! Running the program in a folder of its own.

use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

/// A folder for the files of one test.
pub struct Folder(pub PathBuf);

/// What the program said.
#[derive(Debug, PartialEq)]
pub struct Said {
    pub out: String,
    pub err: String,
    pub code: i32,
}

impl From<Output> for Said {
    fn from(output: Output) -> Self {
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        Self {
            out: text(&output.stdout),
            err: text(&output.stderr),
            code: output.status.code().unwrap_or(-1),
        }
    }
}

/// A search path on which the program is the first.
pub fn path() -> String {
    let program = std::path::Path::new(env!("CARGO_BIN_EXE_symspline")).parent().unwrap();
    format!("{}:{}", program.display(), std::env::var("PATH").unwrap())
}

impl Folder {
    /// An empty folder.
    pub fn new(test: &str) -> Self {
        let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
        drop(std::fs::remove_dir_all(&path));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// The program with arguments, before it is started.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_symspline"));
        command.current_dir(&self.0).args(arguments);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    /// What the program says with these arguments, given this to read.
    pub fn given(&self, input: &str, arguments: &[&str]) -> Said {
        let mut child = self.command(arguments).spawn().unwrap();
        // A program that does not read its input may close it.
        drop(child.stdin.take().unwrap().write_all(input.as_bytes()));
        child.wait_with_output().unwrap().into()
    }

    /// What the program says with these arguments.
    pub fn run(&self, arguments: &[&str]) -> Said {
        self.given("", arguments)
    }

    /// The data it gives, if all is well.
    pub fn out(&self, arguments: &[&str]) -> String {
        let said = self.run(arguments);
        assert_eq!(said.code, 0, "{arguments:?}: {}", said.err);
        said.out
    }

    /// Writes what an expression is to a file.
    pub fn make(&self, file: &str, name: &str, expression: &str) {
        self.out(&["calc", expression, "--called", name, "-o", file]);
    }

    /// The value of an expression over the entries of files, as it is shown.
    pub fn value(&self, expression: &str, files: &[&str]) -> String {
        self.out(&[&["calc", expression][..], files].concat()).trim_end().to_owned()
    }

    /// What is refused, and the exit code.
    pub fn refused(&self, arguments: &[&str]) -> (String, i32) {
        let said = self.run(arguments);
        assert_eq!(said.out, "", "{arguments:?}");
        (said.err, said.code)
    }

    pub fn write(&self, file: &str, text: &str) {
        std::fs::write(self.0.join(file), text).unwrap();
    }
}

/// (u, v, u v) over the unit square.
pub const SADDLE: &str = r#"{"format": "symspline", "version": 1, "items": [{"name": "S", "value": {"surface": {"field": "exact",
    "u": {"degree": 1, "knots": ["0", "0", "1", "1"]}, "v": {"degree": 1, "knots": ["0", "0", "1", "1"]},
    "points": [["0", "0", "0"], ["0", "1", "0"], ["1", "0", "0"], ["1", "1", "1"]]}}}]}"#;

/// The cube whose corners have coordinates 1 and -1.
pub const CUBE: &str = r#"{"format": "symspline", "version": 1, "items": [{"value": {"mesh": {"field": "exact",
    "points": [[-1,-1,-1],[1,-1,-1],[-1,1,-1],[1,1,-1],[-1,-1,1],[1,-1,1],[-1,1,1],[1,1,1]],
    "faces": [[0,2,3,1],[4,5,7,6],[0,1,5,4],[1,3,7,5],[3,2,6,7],[2,0,4,6]]}}}]}"#;
