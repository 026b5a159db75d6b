//! temp
fn main() {
    let p = std::env::args().nth(1).unwrap();
    let bytes = std::fs::read(&p).unwrap();
    let d = kane_audit::read(&p, &bytes).unwrap();
    let labels: Vec<String> = d.statements.iter().map(|s| s.label.clone()).collect();
    let mut last = std::time::Instant::now();
    let mut times = vec![];
    let mut prev: Option<usize> = None;
    let a = kane_audit::audit(d, &Default::default(), &mut |i, _| {
        if let Some(p) = prev { times.push((last.elapsed().as_secs_f64()*1e3, p)); }
        prev = Some(i); last = std::time::Instant::now();
    });
    times.push((last.elapsed().as_secs_f64()*1e3, prev.unwrap()));
    let total: f64 = times.iter().map(|t| t.0).sum();
    times.sort_by(|a,b| b.0.total_cmp(&a.0));
    println!("total {total:.0} ms");
    for (t, i) in times.iter().take(22) { println!("{t:8.2} ms {:16} {} {}", labels[*i], a.judgements[*i].verdict, a.judgements[*i].links.iter().map(|l| l.cost).sum::<u64>()); }
}
