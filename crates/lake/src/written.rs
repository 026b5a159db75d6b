//! A row of a log as bytes.

use kane_impact::bodies::Shape;
use kane_records::row::Row;

use crate::bytes::{Reader, Writer};
use crate::fault::LakeFault;

/// The row, with the name of its pair of materials.
pub(crate) fn written(row: &Row, pair: &str) -> Box<[u8]> {
    let mut out = Writer::default();
    out.count(row.numbers().count() as u64);
    for (place, value) in row.numbers() {
        out.count(place as u64);
        out.float(value);
    }
    for shape in row.shapes {
        out.text(shape.map_or("", Shape::name));
    }
    out.text(pair);
    out.text(&row.id);
    out.0.into_boxed_slice()
}

/// A row that was written, and the name of its pair.
pub(crate) fn read(bytes: &[u8]) -> Result<(Row, &str), LakeFault> {
    let mut from = Reader(bytes);
    let mut row = Row::empty(0);
    for _ in 0..from.length()? {
        let place = usize::try_from(from.count()?).unwrap_or(usize::MAX);
        row.set_place(place, from.float()?);
    }
    for shape in &mut row.shapes {
        let name = from.text()?;
        *shape = Shape::ALL.into_iter().find(|shape| shape.name() == name);
    }
    let pair = from.text()?;
    from.text()?.clone_into(&mut row.id);
    Ok((row, pair))
}

#[cfg(test)]
mod tests {
    use kane_records::schema::Column;

    use super::*;

    #[test]
    fn a_row_is_read_as_it_was_written() {
        let mut row = Row::empty(0);
        row.set(Column::Dt, 0.25);
        row.set(Column::Restitution, -0.0);
        row.shapes[1] = Some(Shape::Hoop);
        row.id = "first".to_owned();
        let bytes = written(&row, "steel");
        let (again, pair) = read(&bytes).expect("it was written");
        assert_eq!((pair, again.id.as_str(), again.shapes), ("steel", "first", row.shapes));
        let bits = |row: &Row| row.numbers().map(|(at, x)| (at, x.to_bits())).collect::<Vec<_>>();
        assert_eq!(bits(&again), bits(&row));
        for end in 0..bytes.len() {
            assert!(read(&bytes[..end]).is_err(), "{end}");
        }
    }
}
