//! Where the nodes of a derivation's graph are drawn: one band a section, within it one column a layer.
//!
//! A claim stands to the right of everything in its section that it cites; citations across sections do not move it.
//! The document's order, and integer arithmetic, make the picture the same in every run.

/// What is to be placed: the nodes in the order of the document.
#[derive(Debug)]
pub(crate) struct Node {
    /// the band that it belongs to; bands do not interleave
    pub(crate) band: usize,
    /// its width
    pub(crate) width: u32,
    /// earlier nodes that it cites
    pub(crate) cites: Vec<usize>,
}

/// The upper left corner of a node, and the width of its column.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Place {
    pub(crate) x: u32,
    pub(crate) y: u32,
    pub(crate) width: u32,
}

/// Measures of the drawing, in pixels.
#[derive(Debug)]
pub(crate) struct Measures {
    /// from one row to the next
    pub(crate) row: u32,
    /// between columns
    pub(crate) gap: u32,
    /// above the first row of a band, for its title
    pub(crate) head: u32,
    /// below the last row of a band
    pub(crate) foot: u32,
    /// left and right of a band
    pub(crate) margin: u32,
    /// the most rows of a column; a longer layer takes several
    pub(crate) rows: usize,
}

/// A finished layout.
#[derive(Debug)]
pub(crate) struct Layout {
    /// one a node
    pub(crate) places: Vec<Place>,
    /// top of each band, and after the last one the height of the whole
    pub(crate) tops: Vec<u32>,
    pub(crate) width: u32,
}

/// Places the nodes; there are `bands` bands, of which some may be empty.
pub(crate) fn layout(nodes: &[Node], bands: usize, measures: &Measures) -> Layout {
    let mut places = vec![Place::default(); nodes.len()];
    let (mut tops, mut top, mut width) = (vec![0], 0, 0);
    for band in 0..bands {
        let mut x = measures.margin;
        let mut rows = 0;
        for layer in layers(nodes, band) {
            for column in columns(&layer, nodes, band, &places, measures.rows) {
                let widest = column.iter().map(|node| nodes[*node].width).max().unwrap_or(0);
                let mut y = top + measures.head;
                for node in &column {
                    places[*node] = Place { x, y, width: widest };
                    y += measures.row;
                }
                rows = rows.max(column.len());
                x += widest + measures.gap;
            }
        }
        if rows > 0 {
            width = width.max(x - measures.gap + measures.margin);
            let rows = u32::try_from(rows).unwrap_or(u32::MAX);
            top += measures.head + rows * measures.row + measures.foot;
        }
        tops.push(top);
    }
    Layout { places, tops, width }
}

/// The nodes of a band by layer: 0 for those that cite nothing in it, else one more than the greatest cited.
fn layers(nodes: &[Node], band: usize) -> Vec<Vec<usize>> {
    let mut layers: Vec<Vec<usize>> = Vec::new();
    let mut layer_of = vec![0; nodes.len()];
    for (index, node) in nodes.iter().enumerate().filter(|(_, node)| node.band == band) {
        let inside = node.cites.iter().filter(|&&cited| cited < index && nodes[cited].band == band);
        let layer = inside.map(|&cited| layer_of[cited] + 1).max().unwrap_or(0);
        layer_of[index] = layer;
        if layers.len() <= layer {
            layers.resize_with(layer + 1, Vec::new);
        }
        layers[layer].push(index);
    }
    layers
}

/// The columns of a layer: nodes near the rows of what they cite, which keeps lines short.
fn columns(
    layer: &[usize],
    nodes: &[Node],
    band: usize,
    places: &[Place],
    most: usize,
) -> Vec<Vec<usize>> {
    let mut order = layer.to_vec();
    // the mean row of what a node cites in its band, in thousandths of a pixel; without any, the document's order
    let mean = |node: usize| {
        let cited: Vec<u64> = nodes[node]
            .cites
            .iter()
            .filter(|&&cited| nodes[cited].band == band)
            .map(|&cited| u64::from(places[cited].y))
            .collect();
        let count = u64::try_from(cited.len()).unwrap_or(1).max(1);
        1000 * cited.iter().sum::<u64>() / count
    };
    order.sort_by_key(|&node| (mean(node), node));
    let count = order.len().div_ceil(most.max(1)).max(1);
    // columns of nearly equal length look calmer than full ones and a rest
    let each = order.len().div_ceil(count).max(1);
    order.chunks(each).map(<[usize]>::to_vec).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const MEASURES: Measures = Measures { row: 10, gap: 5, head: 7, foot: 3, margin: 2, rows: 2 };

    fn node(band: usize, cites: &[usize]) -> Node {
        Node { band, width: 20, cites: cites.to_vec() }
    }

    #[test]
    fn what_is_cited_in_a_section_stands_to_the_left() {
        let nodes = [node(0, &[]), node(0, &[0]), node(0, &[1, 0]), node(1, &[2])];
        let layout = layout(&nodes, 2, &MEASURES);
        let xs: Vec<u32> = layout.places.iter().map(|place| place.x).collect();
        assert_eq!(xs, [2, 27, 52, 2], "the last one cites another section and starts its own");
        assert_eq!(layout.tops, [0, 20, 40]);
        assert_eq!(layout.width, 74);
    }

    #[test]
    fn no_two_nodes_share_a_place_and_a_long_layer_is_divided() {
        let nodes: Vec<Node> = (0..9).map(|_| node(0, &[])).collect();
        let layout = layout(&nodes, 1, &MEASURES);
        let mut places: Vec<_> = layout.places.iter().map(|place| (place.x, place.y)).collect();
        places.sort_unstable();
        places.dedup();
        assert_eq!(places.len(), 9);
        assert!(layout.places.iter().all(|place| place.y < 7 + 2 * 10));
    }

    #[test]
    fn an_empty_band_takes_no_room() {
        let layout = layout(&[node(1, &[])], 3, &MEASURES);
        assert_eq!(layout.tops, [0, 0, 20, 20]);
    }
}
