//! What the reader makes of documents, good and bad.

mod hostile;
#[path = "../../../../tests/shared/many.rs"]
#[expect(dead_code, reason = "here are no random statements")]
mod many;

use kane_algebra::syntax::{Notation, Scope, parse_sentence};
use kane_audit::{Body, Content, Diagnostic, MAX_FILE_BYTES, MAX_STATEMENTS, Verdict, read};
use kane_kernel::Sentence;

const GOOD: &str = r"# Oblique *collision*

Some prose, with `code`.

```kane
var m > 0, r > 0, J > 0, mu >= 0, jp                 # constants
var 0 <= e <= 1
var alpha                                           # the limit variable
var vx0(alpha), w0(alpha), vx(alpha), vpx0(alpha), vpx(alpha)
var Ix(alpha), Iy(alpha), k(alpha), ix(alpha)
given slip0: vpx0 = vx0 - w0*r
given (2): m*(vx - vx0) = -Ix
given (5): k = vpx/vpx0
```

More prose.

~~~kane
given dom: alpha > 0
given (9): k = 1 - ix*2*alpha  # comment
  when alpha > 0,
       m != 1
given (15): ix = 1/(1 + alpha)
claim (16): k = (1 - alpha)/(1 + alpha)          from (9), (15), dom
claim k-range: −1 < k ≤ 1                        from (16), dom expect refuted
claim (10v): k → -1 as α → ∞      from (16)
claim ind: not implied (16) from (9), (5) by k := 1/(1 + 2*alpha), ix := 1/(1 + 2*alpha)
claim no: contradiction from (9) expect ill-defined
let kK := cases { alpha < 3/4: 1 - 4/3*alpha; alpha > 3/4: 1/2 - 2/3*alpha }
let (W) kW := kK^2
claim lim: kK -> 1 as alpha -> 0+ when m > 1 from (W)
~~~
";

#[test]
fn the_example_of_the_language_page_is_read() {
    let document = read("good.md", GOOD.as_bytes()).unwrap_or_else(|errors| {
        panic!("{}", errors.iter().map(ToString::to_string).collect::<String>())
    });
    assert_eq!(document.title.as_deref(), Some("Oblique collision"));
    assert_eq!(document.statements.len(), 14);
    let by_label = |label: &str| {
        let found = document.statements.iter().find(|s| s.label == label);
        found.unwrap_or_else(|| panic!("no statement {label}"))
    };
    let nine = by_label("(9)");
    assert_eq!(nine.line, 20);
    let Body::Given(sentence) = &nine.body else { panic!("(9) is a given") };
    assert_eq!(sentence.plain(&document.context), "k = 1 - ix*2*alpha when alpha > 0, m != 1");
    assert!(document.source(nine).ends_with("m != 1"));
    let Body::Claim(range) = &by_label("k-range").body else { panic!("k-range is a claim") };
    assert_eq!(range.expect, Some(Verdict::Refuted));
    let Content::Links(links) = &range.content else { panic!("k-range has links") };
    assert_eq!(links.len(), 2);
    assert_eq!(&document.text[links[1].1.clone()], "k ≤ 1");
}

#[test]
fn the_parts_of_a_statement_are_known_by_their_places() {
    let text = "```kane
var x, y
let (2 by 2) f := x # from nowhere
given (as taken from a table):
  x = y   # by hand
  when x > 0
claim c: x = y when y > 0 from (2 by 2) using x - y, f expect proved
claim free: not implied (as taken from a table) by x := 1, y := 2 expect refuted
```
";
    let document = read("parts.md", text.as_bytes()).expect("it is well formed");
    let shown: Vec<Vec<String>> = document
        .statements
        .iter()
        .map(|s| {
            let parts = &s.parts;
            let clauses = [&parts.when, &parts.from, &parts.using, &parts.by, &parts.expect];
            let clauses = clauses.into_iter().flatten();
            let all = [&parts.label, &parts.content].into_iter().chain(clauses);
            all.map(|place| document.on_one_line(place.clone())).collect()
        })
        .collect();
    assert_eq!(
        shown,
        [
            vec!["(2 by 2)", "f := x"],
            vec!["(as taken from a table)", "x = y", "when x > 0"],
            vec!["c", "x = y", "when y > 0", "from (2 by 2)", "using x - y, f", "expect proved"],
            vec![
                "free",
                "not implied (as taken from a table)",
                "by x := 1, y := 2",
                "expect refuted"
            ],
        ]
    );
    let given = &document.statements[1].parts;
    assert_eq!(document.on_one_line(given.saying()), "x = y when x > 0");
}

/// The declarations before every statement of the table below; the statement begins on line 7.
const PRELUDE: &str = "```kane
var alpha, 0 <= x <= 1, k(alpha), m, n
let f := x^2
given (1): x = m
claim no: contradiction from (1)
given dom: alpha > 0
";

/// All diagnostics of a document with this statement in a block after the prelude.
fn faults(statement: &str) -> Vec<Diagnostic> {
    let text = format!("{PRELUDE}{statement}\n```\n");
    read("bad.md", text.as_bytes()).expect_err(statement)
}

#[test]
fn each_bad_input_is_told_at_its_place() {
    // statement, line from its first, column, start of the message
    let table: &[(&str, usize, usize, &str)] = &[
        // the list of the issue
        ("claim (2): y = 1", 1, 12, "unknown symbol `y`"),
        ("claim (2): x = 1\n  from (1),\n  (9)", 3, 3, "undeclared label `(9)`"),
        ("claim (2): x = 1 from (3)\ngiven (3): m = 1", 1, 23, "premise below its use: `(3)`"),
        ("claim (2): x = 1 from (2)", 1, 23, "cycle: `(2)` cites itself"),
        ("let g := 1 + g", 1, 14, "cycle: `g` is defined in terms of itself"),
        ("given (1): m = 1", 1, 7, "duplicate label `(1)`"),
        ("given 1: m = 1", 1, 7, "duplicate label `1`"),
        ("claim (2): (x = 1", 1, 12, "unbalanced: `(` is never closed"),
        ("claim (2): x) = 1", 1, 13, "unbalanced: `)` closes nothing"),
        ("claim (2): 1.2.3 = x", 1, 12, "malformed number `1.2.3`"),
        ("claim (2): x = 1e", 1, 16, "malformed number `1e`"),
        ("claim (2): x = 1e3e2", 1, 16, "malformed number `1e3e2`"),
        ("claim (2): x = 1e-3.5", 1, 16, "malformed number `1e-3.5`"),
        ("claim (2): x = 1e-99999", 1, 16, "number with more than 10000 digits"),
        ("claim (2): |x = 1", 1, 12, "unbalanced: `|` is never closed"),
        ("claim (2): max(x, 1, 2) = 1", 1, 20, "expected `)` after two arguments"),
        ("claim (2): x| = 1", 1, 13, "expected a relation, found `|`"),
        ("claim (2): x²⁻ = 1", 1, 13, "the exponent is not an integer"),
        ("claim (2): x²^3 = 1", 1, 14, "expected"),
        ("claim (2): = x", 1, 12, "relation without a left side"),
        ("claim (2): x = from (1)", 1, 14, "relation without a right side"),
        ("claim (2): x + 1", 1, 12, "an expression alone is not a relation"),
        ("claim (2): x^0.5 = 1", 1, 14, "the exponent is not an integer"),
        ("claim (2): x^m = 1", 1, 14, "the exponent is not an integer"),
        // names
        ("var m", 1, 5, "`m` is already declared"),
        ("var f", 1, 5, "`f` is already declared"),
        ("let k := 1", 1, 5, "`k` is already declared"),
        ("var μ, mu", 1, 8, "`mu` is already declared"),
        ("var min", 1, 5, "`min` is a reserved word"),
        ("let d := 1", 1, 5, "`d` is a reserved word"),
        ("claim from: x = 1", 1, 7, "`from` is a reserved word"),
        ("var 1a", 1, 5, "malformed number `1a`"),
        ("var u(v)", 1, 7, "unknown symbol `v`"),
        ("var u(k)", 1, 7, "`k` is itself a function"),
        ("var u(f)", 1, 7, "`f` is a definition"),
        // domains
        ("var 1 <= u < 1", 1, 5, "the domain of `u` is empty"),
        ("var u > 2, 3 < v <= 2", 1, 12, "the domain of `v` is empty"),
        ("var u < -oo", 1, 5, "the domain of `u` is empty"),
        ("var 0 < u > 1", 1, 5, "`u` has two lower bounds"),
        ("var u = 1", 1, 7, "expected `<`, `<=`, `>` or `>=`"),
        ("var u < k", 1, 9, "the bound of `u` speaks of `k`: it is a function"),
        ("var u < v", 1, 9, "unknown symbol `v`"),
        ("var u < u", 1, 9, "unknown symbol `u`"),
        ("var m < u < 2, 0 < u", 1, 20, "`u` is already declared"),
        ("var m < u, m < v < m", 1, 5, "`m` is already declared"),
        ("var 0 < u > m", 1, 5, "`u` has two lower bounds"),
        ("var u < pi + m", 1, 9, "the bound of `u` speaks of `pi`: a multiple of it"),
        ("var u < d(m^2, m)", 1, 9, "the bound of `u` speaks of a derivative"),
        ("var u in N < m", 1, 12, "expected an operator or the end"),
        ("var u w", 1, 7, "an operator is missing before `w`"),
        // limits
        ("claim (2): k -> 1", 1, 18, "a limit needs `as x -> a`"),
        ("claim (2): k -> 1 as f -> 0", 1, 22, "`f` is not a plain `var`"),
        ("claim (2): k -> 1 as k -> 0", 1, 22, "`k` is not a plain `var`"),
        ("claim (2): k -> 1 as q -> 0", 1, 22, "unknown symbol `q`"),
        ("claim (2): k -> k as alpha -> 0", 1, 17, "the limit must be free of `alpha`"),
        ("claim (2): x -> 2*f as x -> 0", 1, 17, "the limit must be free of `x`"),
        ("claim (2): f -> 2 as x -> 2", 1, 27, "the domain of `x` does not reach"),
        ("claim (2): f -> 2 as x -> 1+", 1, 27, "the domain of `x` does not reach"),
        ("claim (2): f -> 2 as x -> 0-", 1, 27, "the domain of `x` does not reach"),
        ("claim (2): f -> 2 as x -> oo", 1, 27, "the domain of `x` does not reach"),
        ("claim (2): k -> 1 as alpha -> 0 when m > 1, 2*k > 0", 1, 45, "the `when` of a limit"),
        // derivatives
        ("claim (2): d(alpha*k, alpha) = 0", 1, 14, "a derivative by `alpha` is not taken where"),
        ("claim (2): d(pi*k, alpha) = 0", 1, 14, "`pi` is an angle, and no number"),
        ("claim (2): d(pi*x, x) = 0", 1, 14, "`pi` is an angle, and no number"),
        ("claim (2): d(x, f) = 0", 1, 17, "`f` is no symbol"),
        ("claim (2): x = 1 from d(dom, alpha)", 1, 23, "`dom` is no equation"),
        ("claim (2): x = 1 from d((1), x)", 1, 23, "`(1)` speaks of `x` itself"),
        ("claim (2): x = 1 from d((1), k)", 1, 23, "`k` is not a plain `var`"),
        ("claim (2): x = 1 from d(no, alpha)", 1, 23, "`no` is no `given`"),
        ("claim (2): x = 1 from d(nope, alpha)", 1, 23, "undeclared label `d(nope, alpha)`"),
        ("claim (2): d(x*m, x) = m from (1)", 1, 31, "`(1)` ties `m` to `x`"),
        // citations
        ("claim (2): x = 1 from no", 1, 23, "`no` states nothing that could be used"),
        ("claim (2): not implied no from (1)", 1, 24, "`no` states nothing"),
        ("claim (2): not implied f from (1)", 1, 24, "`f` is a definition"),
        ("claim (2): not implied (1) by q := 1", 1, 31, "unknown symbol `q`"),
        ("claim (2): not implied (1) by m := 1, m := 2", 1, 39, "`m` is given twice"),
        // clauses
        ("claim (2): x = 1 from (1) when m > 1", 1, 27, "expected the clauses once each"),
        ("claim (2): x = 1 by m := 1", 1, 21, "expected `induction` (only `exists` and"),
        ("claim (2): x = 1 using m from (1)", 1, 26, "expected the clauses once each"),
        ("claim (2): x = 1 using", 1, 23, "expected an expression"),
        ("claim (2): x = 1 using m,", 1, 26, "expected an expression"),
        ("claim (2): x = 1 using m > 1", 1, 26, "expected an operator or the end"),
        ("claim (2): x = using m", 1, 14, "relation without a right side"),
        ("claim (2): x = 1 using q", 1, 24, "unknown symbol `q`"),
        ("claim (2): k -> 1 as alpha -> 0 using m", 1, 33, "expected the end (only a claim about"),
        ("claim (2): not implied (1) using m", 1, 28, "expected the end (only a claim about"),
        ("given (2): x = 1 using m", 1, 18, "expected the end (only a claim about"),
        ("given (2): x = 1 from (1)", 1, 18, "expected the end (only a claim"),
        ("claim (2): x = 1 expect right", 1, 25, "expected `proved`, `refuted`"),
        ("claim (2) x = 1", 1, 11, "expected `:` after the label"),
        ("claim : x = 1", 1, 7, "expected a label"),
        ("let g = 1", 1, 7, "expected `:=` after the name"),
        ("let g 2 := 1", 1, 7, "expected `:=` after the name"),
        ("lemma (2): x = 1", 1, 1, "expected `var`, `let`, `given` or `claim`"),
    ];
    for (statement, line, column, message) in table {
        let found = faults(statement);
        let first = &found[0];
        assert!(first.message.starts_with(message), "{statement}: {first}");
        assert_eq!((first.line, first.column), (line + 6, *column), "{statement}: {first}");
        assert_eq!(found.len(), 1, "{statement}: {found:?}");
    }
}

#[test]
fn all_faults_of_a_document_are_told_at_once() {
    let found = faults("claim (2): y/0 = z^0.5 from (7)\nvar m\nclaim (1): = 2");
    let places: Vec<(usize, usize)> = found.iter().map(|f| (f.line, f.column)).collect();
    assert_eq!(places, [(7, 12), (7, 18), (7, 20), (8, 5), (9, 7), (9, 12)]);
}

#[test]
fn a_fault_causes_no_others() {
    // the label of a broken statement and the name of a broken definition stay known
    let found = faults("let g := y\nclaim (2): = 1\nclaim (3): g = 1 from (2)");
    assert_eq!(found.len(), 2, "{found:?}");
}

#[test]
fn a_diagnostic_shows_the_line_with_a_caret() {
    let found = faults("claim (2): Ω*alfa = 1   # comment");
    let shown: String = found.iter().map(ToString::to_string).collect();
    let expected = "\
error: unknown symbol `Ω`
 --> bad.md:7:12
  |
7 | claim (2): Ω*alfa = 1   # comment
  |            ^
  = a symbol is declared above its first use: `var Ω`
error: unknown symbol `alfa`
 --> bad.md:7:14
  |
7 | claim (2): Ω*alfa = 1   # comment
  |              ^^^^
  = did you mean `alpha`?
";
    assert_eq!(shown, expected);
}

#[test]
fn hints_say_where_to_look() {
    let note = |statement: &str| faults(statement)[0].note.clone().unwrap_or_default();
    assert_eq!(note("claim (2): q = 1\nvar q"), "it is declared below its use, on line 8");
    assert_eq!(note("claim (2): q = 1"), "a symbol is declared above its first use: `var q`");
    assert!(note("claim (2): zeta(1) = 1").starts_with("functions are `abs`, `min`, "));
    assert_eq!(note("claim (2): x = 1 from (dom1)"), "did you mean `dom`?");
    assert_eq!(note("given (1): x = 1"), "`(1)` on line 4 has it already");
    assert!(note("let d := 1").starts_with("`d(f, x)` is a derivative"));
    assert!(note("claim (2): 2x = 1").contains("a product needs its `*`"));
}

#[test]
fn a_mark_of_the_byte_order_is_no_part_of_the_text() {
    let text = "\u{feff}# Title\n\n```kane\nvar x\n```\n";
    let document = read("good.md", text.as_bytes()).expect("well-formed");
    assert_eq!(document.title.as_deref(), Some("Title"));
    let found = read("bad.md", "\u{feff}```kane\nclaim a: y = 1\n```\n".as_bytes());
    let found = found.expect_err("nothing declares y");
    assert_eq!((found[0].line, found[0].column), (2, 10));
}

#[test]
fn a_block_whose_tag_is_nearly_that_of_statements_is_a_fault() {
    for tag in ["Kane", "KANE", "{kane}", ".kane", "kane:", "Kane title"] {
        let text = format!("# T\n\n```{tag}\nclaim (2): 1 = 2\n```\n");
        let found = read("bad.md", text.as_bytes()).expect_err(tag);
        assert_eq!((found.len(), found[0].line, found[0].column), (1, 3, 1), "{found:?}");
        assert!(found[0].message.contains("would be passed over"), "{found:?}");
    }
    for tag in ["", "rust", "kane,ignore", "kanex", "arcane", "text kane"] {
        read("good.md", format!("```{tag}\nvar x\n```\n").as_bytes()).expect(tag);
    }
}

#[test]
fn an_open_block_is_one_fault() {
    let read_faults = |text: &str| read("bad.md", text.as_bytes()).expect_err("an open block");
    let found = read_faults("# T\n\n```kane\nvar x\n\nprose goes on (and on\n");
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!((found[0].line, found[0].column), (3, 1));
    assert!(found[0].message.starts_with("unbalanced block"));
    let found = read_faults("```kane\nvar x\n\nprose\n\n```kane\nvar y\n```\nmore\n");
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(found[0].note.as_deref(), Some("another fence opens inside it, on line 6"));
    let found = read_faults("> ```kane\n> var x\n\nprose\n");
    assert_eq!((found.len(), found[0].column), (1, 3), "{found:?}");
    read("good.md", b"> ~~~ kane\n> var x\n>   , y\n> ~~~~~").expect("a closed block");
    read("good.md", b"- item\n\n  ```kane\n  var x\n    , y\n  ```\r\n").expect("a closed block");
}

#[test]
fn indentation_continues_statements() {
    let text = "```kane\n  # a remark\n\tvar x\n```\n";
    let found = read("bad.md", text.as_bytes()).expect_err("nothing to continue");
    assert!(found[0].message.contains("continues a statement"), "{}", found[0]);
    let text = "```kane\r\nvar x,\r\n\r\n# remark\r\n    y\r\ngiven a: x\r\n  = y\r\n```\r\n";
    let document = read("good.md", text.as_bytes()).expect("well-formed");
    assert_eq!(document.context.vars.len(), 2);
    assert_eq!(document.source(&document.statements[0]), "given a: x\r\n  = y");
}

#[test]
fn other_bytes_than_utf8_are_refused_at_their_place() {
    let found = read("bad.md", b"# T\n\n```kane\nvar \xff\n```\n").expect_err("not UTF-8");
    assert_eq!((found[0].line, found[0].column), (4, 5));
    assert_eq!(found[0].message, "the file is not UTF-8");
    assert!(found[0].to_string().contains("4 | var \u{fffd}"));
}

#[test]
fn documents_without_statements_are_read() {
    for text in ["", "# Only prose\n", "```rust\nvar\n```\n", "```kane\n```\n", "    var x\n"] {
        let document = read("empty.md", text.as_bytes()).expect(text);
        assert!(document.statements.is_empty());
    }
}

#[test]
fn size_limits_are_told() {
    let found = read("big.md", &vec![b'a'; MAX_FILE_BYTES + 1]).expect_err("too big");
    assert!(found[0].message.contains("16777217 bytes"), "{}", found[0]);
    let mut text = "```kane\nvar x\n".to_owned();
    for i in 0..=MAX_STATEMENTS {
        text.push_str(&format!("given a{i}: x=1\n"));
    }
    text.push_str("```\n");
    let found = read("long.md", text.as_bytes()).expect_err("too long");
    assert_eq!(found[0].line, 2 + MAX_STATEMENTS);
    assert_eq!(found[0].message, "more than 100000 statements");
}

#[test]
fn a_flood_of_faults_is_cut_off() {
    let text = format!("```kane\n{}```\n", "claim a: nope = nope\n".repeat(100_000));
    let found = read("bad.md", text.as_bytes()).expect_err("many faults");
    assert!(found.len() <= 201, "{}", found.len());
    assert!(found.last().is_some_and(|f| f.message.contains("there may be more")));
}

/// Logic, definitions with arguments, vectors and matrices.
const LOWERED: &str = r"
```kane
var x, y > 0, t, v in R^3, r(t) in R^2, A in R^2x2
let f(u) := u^2 + 1
let g(u, w) := cases { w > 0: u; else: w }
let L := cross(v, [1, 2, x])
given a: x > 1 or (x < -1 and y > 2)
given n: d(d(r, t), t) = A*r
claim b: x > 2 implies f(x) > 5, x*y = 0 iff x = 0 when x != 3 from a
claim c: exists s, q: s + q = x, s - q = y by s := (x + y)/2, q := (x - y)/2
claim d: inverse(A)*A*r = r when det(A) != 0
claim e: |v|^2 = dot(v, v), L_x = v_y*x - 2*v_z, L != v or norm(v) >= 0
claim h: g(1/x, f(y)) = 1/x from a
claim i: transpose(A) = [[A_xx, A_yx], [A_xy, A_yy]]
```
";

#[test]
fn a_document_with_vectors_and_logic_is_read() {
    let document = read("lowered.md", LOWERED.as_bytes()).expect("well-formed");
    let links = |label: &str| {
        let statement = document.statements.iter().find(|s| s.label == label).expect("it is there");
        match &statement.body {
            Body::Claim(claim) => match &claim.content {
                Content::Links(links) => links.len(),
                _ => 0,
            },
            Body::Defined(parts) => parts.len(),
            _ => 0,
        }
    };
    assert_eq!(["L", "f", "b", "c", "d", "e", "i"].map(links), [3, 0, 2, 2, 2, 3, 4]);
}

#[test]
fn shipped_documents_print_back_as_they_were_read() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/derivations");
    let mut sentences = 0;
    for entry in std::fs::read_dir(folder).expect("the documents are in the checkout") {
        let path = entry.expect("a readable folder").path();
        let bytes = std::fs::read(&path).expect("a readable file");
        let document = read(&path.to_string_lossy(), &bytes).unwrap_or_else(|errors| {
            panic!("{}", errors.iter().map(ToString::to_string).collect::<String>())
        });
        let scope = Scope::of(&document.context);
        for statement in &document.statements {
            let sentence = match &statement.body {
                Body::Given(sentence) => sentence.clone(),
                Body::Claim(claim) => {
                    let Content::Links(links) = &claim.content else {
                        continue;
                    };
                    let links = links.iter().map(|(link, _)| link.clone()).collect();
                    let when = claim.when.clone();
                    Sentence { when, links }
                }
                Body::Let(_) | Body::Defined(_) => continue,
            };
            sentences += 1;
            let text = sentence.plain(&document.context);
            assert_eq!(parse_sentence(&text, &scope), Ok(sentence), "{text}");
        }
    }
    assert!(sentences > 100, "{sentences}");
}

#[test]
fn what_a_newcomer_types_is_told_with_what_to_write() {
    let told = |statement: &str| {
        let found = faults(statement);
        assert_eq!(found.len(), 1, "{statement}: {found:?}");
        format!("{}\n{}", found[0].message, found[0].note.clone().unwrap_or_default())
    };
    for (statement, written) in [
        ("claim (2): x = 1 <=> m = 1", "`<=>` means nothing here: it is written `iff`"),
        ("claim (2): x < 1 <-> m < 1", "written `iff`"),
        ("claim (2): x < 1 ==> m < 1", "written `implies`"),
        ("claim (2): x != 0 || m != 0", "written `or`"),
        ("claim (2): x != 0 ∧ m != 0", "written `and`"),
        ("claim (2): x = √(m)", "written `sqrt(f)`"),
        ("claim (2): x ≈ m", "`abs(a - b) <= c`"),
        ("claim (2): x = 1 from dom and m", "`,` and another label"),
        ("claim (2): x = 1 from dom, m = 1", "a condition stands behind `when`"),
        ("claim (2): x = 1 if m = 1", "a condition stands behind `when`"),
        ("claim (2): x = exp(m*n + 1)", "a symbol that is equal to it"),
        ("claim (2): x = log(m)", "declare it so: `var y > 0`"),
        ("claim (2): x = ln(m)", "the natural logarithm is `log(x)`"),
        ("claim (2): x = sinh(m)", "`(exp(x) - exp(-x))/2`"),
        ("claim (2): x = arctan(m)", "`given slope: tan(theta) = y/x`"),
        ("claim (2): sum(m) = x", "`sum(f for k in 1..n)`"),
        ("claim (2): sin^2(m) = x", "its square is `sin(x)^2`"),
        ("claim (2): sin(m*x) = x", "`given rate: d(phi, t) = omega`"),
        ("claim (2): x^(1/3) = 1", "`given root: r^3 = f`"),
        ("claim (2): k' = 1", "`d(k, alpha)`"),
        ("claim (2): dk = 1", "did you mean `k`?"),
        ("claim (2): dk/m = 1", "a derivative is written `d(f, x)`"),
        ("claim (2): x = 1 by dom", "labels stand behind `from`"),
    ] {
        let told = told(statement);
        assert!(told.contains(written), "{statement}: {told}");
    }
    for (word, meant) in
        [("Var", "var"), ("assume", "given"), ("define", "let"), ("prove", "claim")]
    {
        let told = told(&format!("{word} a: y = z\nclaim (2): y = 1 from a"));
        assert!(told.ends_with(&format!("did you mean `{meant}`?")), "{word}: {told}");
    }
}

#[test]
fn what_a_statement_that_cannot_be_read_declares_is_not_missing_besides() {
    for statements in [
        "let R = x^2\nclaim (2): R >= 0",
        "var beta, |gamma| < 1\nclaim (2): beta = gamma",
        "given lens 1/x = 1\nclaim (2): x = 1 from lens",
    ] {
        assert_eq!(faults(statements).len(), 1, "{statements}: {:?}", faults(statements));
    }
    assert_eq!(faults("let R = x^2\nclaim (2): Q = 1").len(), 2, "what it does not name is");
}
