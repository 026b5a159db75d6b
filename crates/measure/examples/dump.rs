fn main() {
    let path = std::env::args().nth(1).unwrap();
    let bytes = std::fs::read(&path).unwrap();
    let document = kane_audit::read(&path, &bytes)
        .map_err(|e| e.iter().map(ToString::to_string).collect::<String>())
        .unwrap();
    let t = std::time::Instant::now();
    let s = kane_measure::examine(&document, true, &mut |_, _| {});
    for (i, f) in s.subject.formulas.iter().enumerate() {
        println!(
            "{i} {} {:?} {} := {} by {:?} in {:?} eq {:?}",
            f.label,
            f.also,
            f.quantity,
            f.text,
            f.by,
            f.inputs.iter().map(|i| &i.name).collect::<Vec<_>>(),
            s.subject.equal[i]
        );
    }
    println!("larger {:?}", s.subject.larger);
    for l in &s.lines {
        println!(
            "#{} {} worst {} {} tried {}",
            l.formula, l.format, l.worst.0.text, l.worst.1, l.tried
        );
        for r in &l.ranges {
            println!(
                "    {} [{} .. {}] {:?} worst {} {} got {} exact {} | {} | better {:?}",
                r.fault,
                r.from.text,
                r.to.text,
                r.open,
                r.worst.text,
                r.lost,
                r.computed,
                r.exact,
                r.cause,
                r.better
            );
        }
    }
    for p in &s.planes {
        println!(
            "plane #{} {} cells {} worst {:?} {:?}",
            p.formula,
            p.format,
            p.cells.len(),
            p.worst,
            p.faults.iter().map(|f| (f.0, f.1, &f.2.0.text, &f.2.1.text)).collect::<Vec<_>>()
        );
    }
    eprintln!("{:?}", t.elapsed());
}
