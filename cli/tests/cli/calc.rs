//! `calc`: expressions over files.

use crate::program::{Folder, SADDLE};

#[test]
fn values_that_closed_forms_tell() {
    let folder = Folder::new("calc_values");
    folder.make("arch.json", "C", "bezier((0, 0), (1, 2), (2, 0))");
    // C(t) = (2 t, 4 t (1 - t)).
    assert_eq!(folder.value("at(C, 1/4)", &["arch.json"]), "(1/2, 3/4)");
    assert_eq!(folder.value("at(diff(C, 2), 1/7)", &["arch.json"]), "(0, -8)");
    assert_eq!(folder.value("inner(C, C)", &["arch.json"]), "28/15"); // 4/3 + 16 (1/3 - 1/2 + 1/5)
    assert_eq!(folder.value("-y(C) @ bezier(0, 1/2)", &["arch.json", "--json"]).matches("\"-1\"").count(), 2);
    folder.write("saddle.json", SADDLE);
    assert_eq!(folder.value("at(S, 1/2, 1/3)", &["saddle.json"]), "(1/2, 1/3, 1/6)");
    assert_eq!(folder.value("at(iso_u(S, 1/2), 1/3)", &["saddle.json"]), "(1/2, 1/3, 1/6)");
    assert_eq!(folder.value("at(cross(du(S), dv(S)), 1/2, 1/3)", &["saddle.json"]), "(-1/3, -1/2, 1)");
    // The diagonal of the saddle is a parabola.
    let diagonal = "same(z(S @ curve(param(0, 1), param(0, 1))), bezier(0, 0, 1))";
    assert_eq!(folder.value(diagonal, &["saddle.json"]), "1");
}

#[test]
fn fields_are_chosen_and_do_not_mix() {
    let folder = Folder::new("calc_fields");
    folder.make("q.json", "f", "bezier(0, 1)");
    folder.make("x.json", "g", "float(bezier(0, 1))");
    assert_eq!(folder.value("at(f, 1/3)", &["q.json"]), "1/3");
    assert_eq!(folder.value("at(g, 1/3)", &["x.json"]), "0.3333333333333333");
    assert_eq!(folder.value("at(f, 1/3)", &["q.json", "--float"]), "0.3333333333333333");
    assert_eq!(folder.value("at(g, 1/3)", &["x.json", "--exact"]), "1/3");
    let (error, code) = folder.refused(&["calc", "1 + f * g", "q.json", "x.json"]);
    assert_eq!(code, 1);
    assert_eq!(
        error,
        "symspline: expression:1:5: exact and float values do not mix: convert one of them\n  1 + f * g\n      ^^^^^\n"
    );
    assert_eq!(folder.value("at(exact(g) - f, 1/3)", &["q.json", "x.json"]), "0");
}

#[test]
fn fine_tuning_as_it_is_written() {
    let folder = Folder::new("calc_tuning");
    // D = P0 + ∫ (1 + t) (2, 4 - 8 t) = (2 t + t², 4 t - 2 t² - 8/3 t³), from (5, 7).
    folder.make("c.json", "C", "bezier((0, 0), (1, 2), (2, 0))");
    folder.make("scale.json", "alpha", "bezier(1, 2)");
    folder.make("start.json", "P0", "(5, 7)");
    let tuned =
        ["calc", "P0 + integral(alpha * diff(C))", "start.json", "scale.json", "c.json", "-o", "d.json"];
    assert_eq!(folder.out(&tuned), "");
    assert_eq!(folder.value("at(D, 1/2)", &["D=d.json"]), "(25/4, 49/6)");
    let named = ["calc", "P0 + integral(alpha * diff(C))", "P0=start.json", "alpha=scale.json", "C=c.json"];
    assert_eq!(folder.out(&named), std::fs::read_to_string(folder.0.join("d.json")).unwrap());
    // The same as the command for it, from where the curve starts.
    let command = folder.out(&["tune", "--alpha", "scale.json", "c.json"]);
    let same = folder.given(&command, &["calc", "same(T, D - P0)", "T=-", "D=d.json", "start.json"]);
    assert_eq!(same.out, "1\n", "{}", same.err);
}

#[test]
fn errors_point_at_characters() {
    let folder = Folder::new("calc_errors");
    let cases = [
        (
            "1 + (2 * ",
            4,
            "symspline: expression:1:10: a number, a name or '(' is expected, not the end\n  1 + (2 * \n           ^\n",
        ),
        ("1 ? 2", 4, "symspline: expression:1:3: '?' means nothing here\n  1 ? 2\n    ^\n"),
        ("1 +\n  2 / 0", 1, "symspline: expression:2:3: division by zero\n    2 / 0\n    ^^^^^\n"),
        (
            "at(bezier(0, 1), 3)",
            1,
            "symspline: expression:1:1: parameter 3 is outside the domain [0, 1]\n  at(bezier(0, 1), 3)\n  ^^^^^^^^^^^^^^^^^^^\n",
        ),
    ];
    for (expression, code, error) in cases {
        assert_eq!(folder.refused(&["calc", expression]), (error.to_owned(), code));
    }
    let deep = format!("{}1{}", "(".repeat(5000), ")".repeat(5000));
    assert_eq!(folder.refused(&["calc", &deep]).1, 4);
    assert_eq!(folder.value(&format!("0{}", "+1".repeat(20_000)), &[]), "20000");
}

#[test]
fn names_come_from_files_and_bindings() {
    let folder = Folder::new("calc_names");
    folder.make("f.json", "f", "bezier(0, 1)");
    folder.make("g.json", "f", "bezier(0, 2)");
    let (error, code) = folder.refused(&["calc", "f", "f.json", "g.json"]);
    assert_eq!(
        (error.as_str(), code),
        ("symspline: g.json: there are two entries called 'f': use --let\n", 1)
    );
    assert_eq!(folder.value("at(f * h, 1)", &["f.json", "--let", "h=g.json:f"]), "2");
    assert_eq!(folder.value("at(f, 1)", &["f.json", "--let", "f=g.json"]), "2");
    let (error, _) = folder.refused(&["calc", "f", "--let", "f=g.json:h"]);
    assert_eq!(error, "symspline: g.json: there is no one entry called 'h'; there is item 0 (f)\n");
    assert_eq!(folder.refused(&["calc", "f", "--let", "2=g.json"]).1, 2);
    // A binding among the files; by number where names do not tell.
    assert_eq!(folder.value("at(f * h, 1)", &["h=g.json:f", "f.json"]), "2");
    folder.write(
        "two.json",
        r#"{"format": "symspline", "version": 1, "items": [{"name": "o", "value": {"number": "3"}}, {"name": "o", "value": {"number": "5"}}]}"#,
    );
    assert_eq!(folder.value("a - b", &["a=two.json:0", "b=two.json:1"]), "-2");
    let listed = "there is item 0 (o), item 1 (o)\n";
    for (entry, problem) in [
        (":2", "no one entry called '2'"),
        (":o", "no one entry called 'o'"),
        ("", "two.json:NAME or two.json:0"),
    ] {
        let (error, code) = folder.refused(&["calc", "a", &format!("a=two.json{entry}")]);
        assert!(code == 1 && error.contains(problem) && error.ends_with(listed), "{error}");
    }
    let (error, code) = folder.refused(&["calc", "f", "f=f.json", "--let", "f=g.json"]);
    assert_eq!((error.as_str(), code), ("symspline: 'f' is bound twice\n", 2));
    // A file with `=` in its name is a file.
    folder.make("x=f.json", "g", "bezier(1, 3)");
    assert_eq!(folder.value("at(g, 1)", &["x=f.json"]), "3");
    // An entry without a name, from a pipe.
    let pipe = folder.out(&["calc", "bezier(1, 3)"]);
    assert_eq!(folder.given(&pipe, &["calc", "at(p, 1/2)", "--let", "p=-"]).out, "2\n");
}

#[test]
fn approximations_tell_their_bounds_on_standard_error() {
    let folder = Folder::new("calc_bounds");
    let said = folder.run(&["calc", "at(reduce(bezier(0, 0, 1), 1), 0)"]);
    assert_eq!(said.code, 0);
    let bound: symspline::Q = said.err.trim().strip_prefix("reduce: within ").unwrap().parse().unwrap();
    // The best line is off by 1/8; no bound is less.
    assert!(bound >= "1/8".parse().unwrap());
}
