//! Formulas as papers of the field print them, beside what the language says for them.

use kane_latex::{Names, Unreadable, statement};
use proptest::prelude::*;

fn read(latex: &str) -> Result<String, Unreadable> {
    statement(latex, &mut Names::default()).map(|statement| statement.text())
}

#[test]
fn formulas_become_statements() {
    for (latex, text) in [
        (r"m(v_y - v_{y0}) = I_y", "m*(v_y - v_y0) = I_y"),
        (r"J_c(\omega-\omega_0)=rI_x,", "J_c*(omega - omega_0) = r*I_x"),
        (r"v_y=-e\,v_{y0}.", "v_y = -e*v_y0"),
        (
            r"\alpha=\frac12\,\frac{(J_c+mr^2)\mu(1+e)v_{y0}}{J_cv_{px0}}",
            "alpha = 1/2*((J_c + m*r^2)*mu*(1 + e)*v_y0/(J_c*v_px0))",
        ),
        (r"k \to -\infty \quad\text{as } \alpha \to \infty", "k -> -oo as alpha -> oo"),
        (r"\lim_{\alpha\to 0^+} k = 1", "k -> 1 as alpha -> 0+"),
        (r"\lim_{x \to -\frac{1}{2}} f = \frac{a}{b}", "f -> a/b as x -> -1/2"),
        (r"E = \tfrac{1}{2} m v^2 + \frac{1}{2} J \omega^{2}", "E = 1/2*m*v^2 + 1/2*J*omega^2"),
        (r"E = 1/2 m v^2", "E = 1/2*m*v^2"),
        (r"m\ddot{x} = -k x - c \dot x", "m*d(d(x, t), t) = -k*x - c*d(x, t)"),
        (
            r"m \frac{d^2 x}{d t^2} + \frac{\mathrm{d}}{\mathrm{d}t}\left(J \omega\right) = 0",
            "m*d(d(x, t), t) + d(J*omega, t) = 0",
        ),
        (r"\frac{\partial L}{\partial \theta} = 0", "d(L, theta) = 0"),
        (r"\dot{x}_0 = 0", "d(x_0, t) = 0"),
        (r"v^+ = -e v^-", "v_plus = -e*v_minus"),
        (r"v_n^{\prime} = v_n'", "v_n' = v_n'"),
        (r"0 \le e \leqslant 1", "0 <= e <= 1"),
        (r"e \in [0, 1)", "0 <= e < 1"),
        (r"x \in (0, \infty)", "x > 0"),
        (r"|v_t| \neq 0 \quad (\mu > 0)", "abs(v_t) != 0 when mu > 0"),
        (
            r"x = \begin{cases} a & \text{if } a > b, \\ b & \text{otherwise} \end{cases}",
            "x = cases { a > b: a; else: b }",
        ),
        (r"p_t = \min\left\{\mu p_n, \frac{m v_t}{2}\right\}", "p_t = min(mu*p_n, m*v_t/2)"),
        (r"T = 2\pi\sqrt{\frac{l}{g}}", "T = 2*pi*sqrt(l/g)"),
        (r"F = K\delta^{3/2}", "F = K*sqrt(delta)^3"),
        (r"y = x^{-\frac{1}{2}}", "y = sqrt(x)^-1"),
        (r"\sin^2\theta + \cos^2\theta = 1", "sin(theta)^2 + cos(theta)^2 = 1"),
        (r"\sin 2\theta = 2\sin\theta\cos\theta", "sin(2*theta) = 2*sin(theta)*cos(theta)"),
        (r"\cot\theta = \sec 2\theta", "cos(theta)/sin(theta) = 1/cos(2*theta)"),
        (r"\vert x \vert = \lvert y \rvert", "abs(x) = abs(y)"),
        (r"\tan(\theta + \pi/4) > 0", "tan(theta + pi/4) > 0"),
        (
            r"\mathbf{p} = m\mathbf{v}, \quad \vec{L} = \vec r \times \mathbf{p}",
            "p = m*v, L = cross(r, p)",
        ),
        (r"P = \mathbf F \cdot \mathbf v", "P = dot(F, v)"),
        (r"|\mathbf{v}|^2 = v_x^2", "norm(v)^2 = v_x^2"),
        (
            r"\begin{pmatrix} a & b \\ c & d_1 \end{pmatrix} \mathbf{x} = \begin{pmatrix} 0 \\ 1 \end{pmatrix}",
            "[[a, b], [c, d_1]]*x = [0, 1]",
        ),
        (r"x > 0 \implies x^2 > 0", "x > 0 implies x^2 > 0"),
        (r"\Delta E \le 0", "DeltaE <= 0"),
        (r"v_{\text{rel}} = \mathrm{Re} \, x", "v_rel = Re*x"),
        (r"v_{n,0} = 0.35 u", "v_n0 = 0.35*u"),
        (r"a - (b - c) = a - b + c", "a - (b - c) = a - b + c"),
        (r"\frac{a}{\frac{b}{c}} = \frac{ac}{b}", "a/(b/c) = a*c/b"),
        (r"-x^2 = -(x)^2", "-x^2 = -x^2"),
        (r"(-x)^2 = x^2", "(-x)^2 = x^2"),
        (r"a/b \cdot c = 1", "a/b*c = 1"),
        (r"x(t) = v t", "x = v*t"),
        (r"k(1 - x) = m(x + 1)", "k*(1 - x) = m*(x + 1)"),
        (r"\frac{d_1}{d_{2}} = d", "d_1/d_2 = dist"),
        (r"v_x = v_{x}", "v_x = v_x"),
        (r"\lim_{x \to 0} (f + x) = 1", "f + x -> 1 as x -> 0"),
        (r"\ln x = 1", "log(x) = 1"),
        (r"\log\left(\frac{p}{q}\right) = \ln p - \ln q", "log(p/q) = log(p) - log(q)"),
        (r"\exp(-\lambda x) = 1/y", "exp(-lambda*x) = 1/y"),
        (r"\sum_{k=1}^{n} k^2 = 1", "sum(k^2 for k in 1..n) = 1"),
        (r"\sum\limits_{k=0}^{n+1} a q^k = s", "sum(a*q^k for k in 0..n + 1) = s"),
        (r"(1 - q)\sum_{k=0}^n q^{k+1} = 1", "(1 - q)*sum(q^(k + 1) for k in 0..n) = 1"),
        (r"\prod_{k=1}^{3} \left(1 + \frac{1}{k}\right) = 4", "prod(1 + 1/k for k in 1..3) = 4"),
        (r"\sum_{i=1}^{3}\sum_{j=1}^{i} j = 10", "sum(sum(j for j in 1..i) for i in 1..3) = 10"),
    ] {
        assert_eq!(read(latex).as_deref(), Ok(text), "{latex}");
    }
}

#[test]
fn what_plain_tex_and_careful_hands_write_is_read() {
    for (latex, text) in [
        (r"k = {1 - \alpha \over 1 + \alpha}", "k = (1 - alpha)/(1 + alpha)"),
        (r"E = {1 \over 2} m v^2", "E = 1/2*m*v^2"),
        (r"x^{1 \over 2} = \sqrt{a \over b}", "sqrt(x) = sqrt(a/b)"),
        (r"m{dv \over dt} = F", "m*d(v, t) = F"),
        (r"{{a \over b} \over c} = {a \over bc}", "a/b/c = a/(b*c)"),
        (r"F = m\cdot{}a", "F = m*a"),
        (r"\alpha{} \le{} \beta{} + 1", "alpha <= beta + 1"),
        (r"x ={}& a{}b", "x = a*b"),
        (r"x = {}-a", "x = -a"),
        (r"x = m\cdot{}(a + b)", "x = m*(a + b)"),
    ] {
        assert_eq!(read(latex).as_deref(), Ok(text), "{latex}");
    }
}

#[test]
fn what_plain_tex_leaves_open_is_refused() {
    for latex in [
        // the one divides all that stands before it, the other is two fractions in one
        r"x = a \over b",
        r"x = {a \over b \over c}",
        r"x = {\left( a \over b \right) + c}",
        r"x = {\left. a \over b \right. + c}",
        r"x = {\over b}",
        r"x = 1{1 \over 2}",
        // an argument that is missing, an index of nothing, a number that is printed with two digits
        r"x = \frac{}{b}",
        r"x = \sqrt{}",
        r"x = a{}^2",
        r"x = {}_2 a",
        r"x = 2{}3",
        r"x = {}",
        // a value or a product, and a differential
        r"x = U{}(y)",
        r"T\, d{}s = d{}u",
    ] {
        assert!(read(latex).is_err(), "{latex}: {:?}", read(latex));
    }
}

#[test]
fn what_has_two_readings_or_none_is_refused() {
    for latex in [
        r"x = a/bc",
        r"\sin\theta r = 1",
        r"\sin^{-1} x = 1",
        r"x = e^{-\lambda t}",
        r"x^n = 1",
        r"x \approx 1",
        r"\int_0^1 f \, dx = 1",
        r"\sum_{i} x_i = 0",
        r"T\, ds = du",
        r"x \pm y = 1",
        r"x + y",
        r"x = ",
        r"x = \frac{1}{2",
        r"x = y \text{ by symmetry}",
        r"\mathbf{v} + 1 = 0",
        r"\mathbf{v}^2 = 1",
        r"v = \mathbf{v}",
        r"x = \left. y \right|_{t=0}",
        r"\sum_{k=1}^{n} k + 1 = 1",
        r"\sum_{k=1} k = 1",
        r"\sum_{1}^{n} x = 1",
        r"\sum_{k=1}^{n} q^m = 1",
        r"\log_2 x = 1",
        r"x = (y",
        r"\sqrt[3]{x} = 1",
        r"x = {y",
        r"x_{i+1} = x_i",
        r"E = T + U(x)",
        r"v(0) = v_0",
        r"F(x, y) = 0",
        r"\sin x/2 = 1",
        r"\lim_{x \to 0} f + x = 1",
        r"\varphi + \phi = 0",
        r"x_{12} = x_{1,2}",
        r"d = \mathrm{dist}",
        r"|x|y|z| = 1",
        r"x = 1\frac{1}{2}",
        r"x = 2{3}",
        r"x^23 = 1",
        r"x = y^{1{2}}",
        r"x_12 = 1",
        r"\vec a \cdot \vec b \times \vec c = 1",
        r"\vec a \times \vec b \times \vec c = \vec x",
        r"\exp t(x + 1) = 1",
        r"\sin\theta\frac{x}{2} = 1",
        "",
    ] {
        assert!(read(latex).is_err(), "{latex}: {:?}", read(latex));
    }
}

#[test]
fn bars_that_are_said_to_open_and_close_do_so() {
    for (latex, read_as) in [
        (r"\left|x\left|y\right|z\right| = 1", "abs(x*abs(y)*z) = 1"),
        (r"\left|x\right|y\left|z\right| = 1", "abs(x)*y*abs(z) = 1"),
        (r"\left\vert x + \lvert y\rvert z\right\vert = 1", "abs(x + abs(y)*z) = 1"),
        (r"||x| - |y|| = |x - y|", "abs(abs(x) - abs(y)) = abs(x - y)"),
        (r"|x||y| = |x| \cdot y \cdot |z|", "abs(x)*abs(y) = abs(x)*y*abs(z)"),
    ] {
        assert_eq!(read(latex).unwrap(), read_as, "{latex}");
    }
}

#[test]
fn a_formula_that_is_refused_leaves_no_symbols() {
    let mut names = Names::default();
    statement("a = b", &mut names).unwrap();
    statement(r"c = \int x", &mut names).unwrap_err();
    let met: Vec<&str> = names.symbols().iter().map(|symbol| symbol.name.as_str()).collect();
    assert_eq!(met, ["a", "b"]);
}

proptest! {
    #[test]
    fn nothing_makes_the_reader_panic(text in r"(\\(frac|sqrt|sin|exp|ln|sum|prod|dot|left|begin\{cases\}|end\{cases\}|lim|to|text|mathbf|vec|in|alpha)|[{}()|_^=<>+*/&,.'dxt0-9 -]|\\\\){0,40}") {
        let _ = read(&text);
    }

    #[test]
    fn nothing_of_any_characters_makes_the_reader_panic(text in any::<String>()) {
        let _ = read(&text);
    }
}
