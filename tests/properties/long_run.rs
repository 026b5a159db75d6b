//! The process in closed form against its path on very many contacts: by intervals, and exactly
//! where intervals are in doubt.
//!
//! Two enclosures that overlap do not prove equality; `process` proves that on fewer contacts. Here
//! enclosures that do not overlap would prove a difference, and an enclosure of the energy below
//! zero proves that there is no gain. The long run is
//!
//! ```sh
//! cargo test --release --test properties ten_million -- --ignored --nocapture
//! ```

use kane_impact::laws::{Keller1986, Stronge1990};
use kane_impact::oracle::integrate;
use kane_impact::{Contact, Delassus, Law};
use kane_number::{Algebraic, Interval, Ordered as _, decode};

use crate::random::Random;

impl Random {
    /// 2 to a power between −10 and 10.
    fn magnitude(&mut self) -> f64 {
        (20.0 * self.unit() - 10.0).exp2()
    }

    /// A contact that couples; restitution at an end one time in eight.
    fn contact(&mut self) -> Option<Contact<f64>> {
        let (tt, nn) = (self.magnitude(), self.magnitude());
        let tn = (2.0 * self.unit() - 1.0) * (tt * nn).sqrt();
        let slip = self.magnitude() * if self.bits() & 1 == 0 { 1.0 } else { -1.0 };
        let restitution = match self.bits() % 16 {
            0 => 0.0,
            1 => 1.0,
            _ => self.unit(),
        };
        let delassus = Delassus::new(tt, tn, nn).ok()?;
        Contact::new(slip, self.magnitude(), delassus, self.magnitude(), restitution).ok()
    }
}

#[derive(Debug, Default)]
struct Count {
    contacts: u64,
    by_intervals: u64,
    exactly: u64,
}

impl Count {
    fn ask(&mut self, law: &Law, contact: &Contact<f64>) {
        let enclosed = contact.map(|&x| Interval::from(x));
        let overlap = |a: &Interval, b: &Interval| a.intersection(b).is_some();
        let closed = law.over().resolve(&enclosed).ok();
        let path = integrate(&enclosed, law.info.restitution).ok();
        let decided = closed.zip(path).is_some_and(|(closed, path)| {
            let (mine, end) = (&closed.impulse, &path.end().impulse);
            assert!(
                overlap(&mine.tangential, &end.tangential) && overlap(&mine.normal, &end.normal),
                "{}: {mine:?} against {end:?} at {contact:?}",
                law.info.id
            );
            let loss = end_energy(&path).sign().is_at_most();
            assert!(loss != Some(false), "{} gains energy at {contact:?}", law.info.id);
            loss == Some(true)
        });
        self.contacts += 1;
        if decided {
            self.by_intervals += 1;
            return;
        }
        let exact = contact.map(|&x| Algebraic::from(decode(x).expect("a finite float")));
        let closed = law.over().resolve(&exact).expect("exact numbers decide");
        let path = integrate(&exact, law.info.restitution).expect("exact numbers decide");
        assert_eq!(closed.impulse, path.end().impulse, "{} at {contact:?}", law.info.id);
        let gains = closed.work.total().sign().is_greater() == Some(true);
        assert!(!gains, "{} gains energy at {contact:?}", law.info.id);
        self.exactly += 1;
    }
}

fn end_energy<N: kane_number::Real>(path: &kane_impact::oracle::Path<N>) -> N {
    path.end().normal_work.clone() + &path.end().tangential_work
}

fn run(contacts: u64) -> Count {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut count = Count::default();
    let (keller, stronge) = (Law::from(Keller1986), Law::from(Stronge1990));
    while count.contacts < 2 * contacts {
        let Some(contact) = random.contact() else { continue };
        count.ask(&keller, &contact);
        count.ask(&stronge, &contact);
    }
    count
}

#[test]
fn poisson_and_energetic_restitution_follow_their_path_and_gain_nothing() {
    let count = run(20_000);
    println!("{count:?}");
    assert!(count.by_intervals > 9 * count.exactly, "{count:?}");
}

#[test]
#[ignore = "minutes: the long run"]
fn the_same_on_ten_million_contacts() {
    println!("{:?}", run(10_000_000));
}
