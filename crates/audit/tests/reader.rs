//! What the reader makes of documents, good and bad.

use kane_algebra::syntax::Notation;
use kane_audit::{Body, Content, Verdict, read};

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
    let Body::Given(sentence) = &nine.body else {
        panic!("(9) is a given")
    };
    assert_eq!(
        sentence.plain(&document.context),
        "k = 1 - ix*2*alpha when alpha > 0, m != 1"
    );
    assert!(document.source(nine).ends_with("m != 1"));
    let Body::Claim(range) = &by_label("k-range").body else {
        panic!("k-range is a claim")
    };
    assert_eq!(range.expect, Some(Verdict::Refuted));
    let Content::Links(links) = &range.content else {
        panic!("k-range has links")
    };
    assert_eq!(links.len(), 2);
    assert_eq!(&document.text[links[1].1.clone()], "k ≤ 1");
}
