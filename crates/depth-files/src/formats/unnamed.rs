//! Camera matrices that have no name: of an array in a file of its own, of `np.savez(file, mtx, dist)`, and of a list in JSON.

use super::matrix::of_columns;
use crate::format::Format;
use crate::node::{Node, Value};

/// The one camera matrix in these documents as `K`, or the two in their order as `K1` and `K2`, each as a document; nothing where there are
/// others, of which nobody knows which is which.
pub(super) fn matrices<'a>(documents: impl Iterator<Item = &'a Node>) -> Vec<Node> {
    let mut all = Vec::new();
    documents.for_each(|document| collect(document, &mut all));
    let names: &[&str] = match all.len() {
        1 => &["K"],
        2 => &["K1", "K2"],
        _ => &[],
    };
    let named = names.iter().zip(all).map(|(name, matrix)| Node {
        place: matrix.place,
        value: Value::Map(vec![((*name).to_owned(), matrix.clone())]),
    });
    named.collect()
}

fn collect<'a>(node: &'a Node, all: &mut Vec<&'a Node>) {
    if is_matrix(node) {
        all.push(node);
        return;
    }
    node.entries().for_each(|(_, part)| collect(part, all));
    node.items().iter().for_each(|part| collect(part, all));
}

/// Whether it is (fx s cx; 0 fy cy; 0 0 1), or that column by column.
fn is_matrix(node: &Node) -> bool {
    // Lists of points are not all read for this.
    let is_short = |node: &Node| matches!(node.items().len(), 3 | 9);
    let Some([fx, a, c, b, fy, f, x, y, one]) = Some(node)
        .filter(|node| is_short(node))
        .and_then(|node| node.array::<9>(Format::OpenCv, "", "9").ok())
    else {
        return false;
    };
    let is_by_rows = [b, x, y, one] == [0.0, 0.0, 0.0, 1.0];
    (is_by_rows || of_columns([fx, a, c, b, fy, f, x, y, one]).is_some()) && fx > 1.0 && fy > 1.0
}
