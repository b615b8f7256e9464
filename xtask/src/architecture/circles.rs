//! Circles in a graph.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// Which node leads to which.
pub(super) type Graph = BTreeMap<usize, BTreeSet<usize>>;

/// For each node that leads back to itself a shortest circle, from its smallest node to the last one before it: each circle once.
pub(super) fn circles(graph: &Graph) -> BTreeSet<Vec<usize>> {
    graph
        .keys()
        .filter_map(|&node| shortest(graph, node))
        .map(from_the_smallest)
        .collect()
}

/// A shortest way from `start` back to it, without its return.
fn shortest(graph: &Graph, start: usize) -> Option<Vec<usize>> {
    let mut came_from: BTreeMap<usize, usize> = BTreeMap::new();
    let mut queue = VecDeque::from([start]);
    while let Some(node) = queue.pop_front() {
        for &next in graph.get(&node).into_iter().flatten() {
            if next == start {
                return Some(way(&came_from, node));
            }
            if let Entry::Vacant(entry) = came_from.entry(next) {
                entry.insert(node);
                queue.push_back(next);
            }
        }
    }
    None
}

/// From where the search began to `end`.
fn way(came_from: &BTreeMap<usize, usize>, end: usize) -> Vec<usize> {
    let mut way: Vec<usize> = std::iter::successors(Some(end), |node| came_from.get(node).copied()).collect();
    way.reverse();
    way
}

fn from_the_smallest(mut circle: Vec<usize>) -> Vec<usize> {
    let smallest = circle.iter().enumerate().min_by_key(|(_, node)| **node).map_or(0, |(at, _)| at);
    circle.rotate_left(smallest);
    circle
}

#[cfg(test)]
mod tests {
    use super::{Graph, circles};

    fn found(edges: &[(usize, usize)]) -> Vec<Vec<usize>> {
        let mut graph = Graph::new();
        for &(from, to) in edges {
            graph.entry(from).or_default().insert(to);
        }
        circles(&graph).into_iter().collect()
    }

    #[test]
    fn what_only_goes_down_has_no_circle() {
        assert_eq!(found(&[(0, 1), (0, 2), (1, 3), (2, 3)]), Vec::<Vec<usize>>::new());
    }

    #[test]
    fn each_circle_is_found_once_whatever_node_it_is_entered_by() {
        assert_eq!(found(&[(9, 2), (2, 1), (1, 0), (0, 2)]), [vec![0, 2, 1]]);
        assert_eq!(found(&[(0, 1), (1, 0), (1, 2), (2, 1)]), [vec![0, 1], vec![1, 2]]);
    }
}
