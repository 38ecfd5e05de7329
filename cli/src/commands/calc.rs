//! `calc`: expressions over splines.

use crate::calc::evaluate::{Names, evaluate};
use crate::calc::functions::FUNCTIONS;
use crate::failure::{Failure, Result};
use crate::input::{self, FieldChoice, format};
use crate::output::{self, Output};
use clap::Args;
use std::path::Path;
use std::str::FromStr;
use symspline_dynamic::{Value, both};
use symspline_files::{Entry, Format};

/// Compute with splines: `P0 + integral(alpha * diff(C))`
#[derive(Args, Debug)]
#[command(after_help = after_help())]
pub struct Calc {
    /// The expression
    #[arg(allow_hyphen_values = true)]
    expression: String,
    /// Files whose entries are bound to their names; `-` is standard input; `NAME=FILE[:ENTRY]` as with --let
    #[arg(value_name = "FILE")]
    files: Vec<String>,
    /// Bind a name to the entry of a file, or to one of several, by its name or number: `C=file.json:name`
    #[arg(long = "let", value_name = "NAME=FILE[:ENTRY]")]
    bindings: Vec<Binding>,
    /// The format of all files, if the endings of names do not tell it
    #[arg(long, value_name = "FORMAT", value_parser = format)]
    from: Option<Format>,
    /// The name of the result in the file that is written
    #[arg(long, value_name = "NAME")]
    called: Option<String>,
    /// Write numbers and points as JSON too
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    field: FieldChoice,
    #[command(flatten)]
    output: Output,
}

/// A name for an entry of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Binding {
    name: String,
    file: String,
}

impl Binding {
    /// The entry that `file` or `file:name` means, whatever it is called.
    pub fn of_file(file: &str) -> Self {
        Self { name: "NAME".to_owned(), file: file.to_owned() }
    }
}

impl FromStr for Binding {
    type Err = String;

    fn from_str(text: &str) -> std::result::Result<Self, String> {
        let (name, file) = text.split_once('=').ok_or("NAME=FILE is expected")?;
        let mut letters = name.chars();
        let first = letters.next().is_some_and(|c| c.is_alphabetic() || c == '_');
        if !first || !letters.all(|c| c.is_alphanumeric() || c == '_') {
            return Err(format!("'{name}' is no name: letters, digits and '_' are, not a digit first"));
        }
        Ok(Self { name: name.to_owned(), file: file.to_owned() })
    }
}

impl Calc {
    /// Runs the command.
    pub fn run(&self) -> Result<()> {
        let (value, notes) = evaluate(&self.expression, &self.names()?).map_err(Failure::Expression)?;
        let value = if self.field.float { value.to_float()? } else { value };
        notes.iter().for_each(output::note);
        let plain = !self.json && self.output.output.is_none() && self.output.to.is_none();
        match &value {
            Value::Number(x) if plain => output::text(&format!("{x}\n")),
            Value::Point(p) if plain => {
                let all: Vec<String> = both!(p, p => p.iter().map(ToString::to_string).collect());
                output::text(&format!("({})\n", all.join(", ")))
            }
            _ => self.output.write(&[Entry { name: self.called.clone(), value }]),
        }
    }

    fn names(&self) -> Result<Names> {
        let mut names = Names::new();
        let mut bindings = Vec::new();
        for file in &self.files {
            match file.parse() {
                // A file may have `=` in its name.
                Ok(binding) if !Path::new(file).exists() => bindings.push(binding),
                _ => self.bind_all(&mut names, Path::new(file))?,
            }
        }
        bindings.extend(self.bindings.iter().cloned());
        for (i, binding) in bindings.iter().enumerate() {
            if bindings[..i].iter().any(|earlier| earlier.name == binding.name) {
                return Err(Failure::Usage(format!("'{}' is bound twice", binding.name)));
            }
            let entry = bound_entry(binding, self.from)?;
            names.remove(&binding.name);
            self.bind(&mut names, binding.name.clone(), entry, &binding.file)?;
        }
        Ok(names)
    }

    /// Binds the entries of a file that have names.
    fn bind_all(&self, names: &mut Names, file: &Path) -> Result<()> {
        for entry in input::read(file, self.from)? {
            if let Some(name) = entry.name.clone() {
                self.bind(names, name, entry, &input::file_name(file))?;
            }
        }
        Ok(())
    }

    /// Binds a name that is not bound yet, to the value in the field that was chosen.
    fn bind(&self, names: &mut Names, name: String, entry: Entry, place: &str) -> Result<()> {
        if names.contains_key(&name) {
            return Err(
                Failure::refused(format!("there are two entries called '{name}': use --let")).at(place)
            );
        }
        let value = self.field.convert(entry.value).map_err(|error| Failure::from(error).at(place))?;
        names.insert(name, value);
        Ok(())
    }
}

/// The entry that `file`, `file:name` or `file:number` means; numbers count from 0.
pub fn bound_entry(binding: &Binding, from: Option<Format>) -> Result<Entry> {
    let (file, name) = match binding.file.rsplit_once(':') {
        Some((front, name)) if !Path::new(&binding.file).exists() => (front, Some(name)),
        _ => (binding.file.as_str(), None),
    };
    let mut entries = input::read(Path::new(file), from)?;
    let listed: Vec<String> = entries.iter().enumerate().map(|(i, e)| input::entry_name(i, e)).collect();
    if let Some(name) = name {
        let is_called = |entry: &Entry| entry.name.as_deref() == Some(name);
        match name.parse().ok().filter(|_| !entries.iter().any(is_called)) {
            Some(number) => entries = entries.into_iter().skip(number).take(1).collect(),
            None => entries.retain(is_called),
        }
    }
    if entries.len() == 1 {
        return Ok(entries.remove(0));
    }
    let there = if listed.is_empty() { "nothing".to_owned() } else { listed.join(", ") };
    let problem = match name {
        Some(name) => format!("there is no one entry called '{name}'; there is {there}"),
        None => format!("tell which entry, as in {file}:NAME or {file}:0; there is {there}"),
    };
    Err(Failure::refused(problem).at(file))
}

fn after_help() -> String {
    let functions =
        FUNCTIONS.iter().map(|f| format!("  {:<26} {}\n", format!("{}({})", f.name, f.usage), f.meaning));
    format!(
        "Operators, from the loosest: + -, * /, unary -, @ (composition). (a, b) is a point.\n\
         Numbers are fractions until they meet floats; fractions and floats of splines do not mix.\n\n\
         Functions:\n{}\n\
         Examples:\n  \
         symspline calc 'integral(bezier(0, 0, 1), 0, 1)'\n  \
         symspline calc 'P0 + integral(alpha * diff(C))' P0=start.json C=curve.json alpha=scales.json:soft -o tuned.json\n  \
         symspline calc 'same(diff(f * g), diff(f) * g + f * diff(g))' functions.json",
        functions.collect::<String>()
    )
}
