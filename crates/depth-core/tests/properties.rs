//! What holds for every problem, however odd: nothing that is computed is ever NaN, infinite or negative.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

use depth_core::agreement::{Comparison, Verdict};
use depth_core::judge;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Outcome, Problem, Solution};
use depth_core::quantity::{Length, Pixels};
use depth_core::uncertainty::Model;
use depth_generators::{all_but_equal, any_f64, any_problem, cancelling, delicate_problem, measured};
use proptest::prelude::*;

/// Every number of a solution is what it should be.
fn check(solution: &Solution) -> Result<(), TestCaseError> {
    for width in [solution.estimated_width.map(Length::m), solution.estimated_width_px.map(Pixels::px)] {
        prop_assert!(width.is_none_or(|width| width.is_normal() && width > 0.0), "{:?}", width);
    }
    for method in Method::ALL {
        let distance = solution.outcome(method).distance().map(Length::m);
        prop_assert!(distance.is_none_or(|distance| distance.is_normal() && distance > 0.0));
        let Some(uncertainty) = solution.uncertainty(method) else {
            continue;
        };
        let distance = distance.unwrap();
        let (near, far) = (uncertainty.interval.near.m(), uncertainty.interval.far.map(Length::m));
        prop_assert!(uncertainty.sigma.m().is_finite() && uncertainty.sigma.m() >= 0.0);
        prop_assert!(0.0 <= near && near <= distance, "{} {}", near, distance);
        prop_assert!(far.is_none_or(|far| far.is_finite() && far >= distance), "{:?} {}", far, distance);
        prop_assert!(uncertainty.bias.is_none_or(|bias| bias.m().is_finite() && bias.m() >= 0.0));
        let sum: f64 = uncertainty.budget.iter().map(|share| share.share).sum();
        prop_assert!((sum - 1.0).abs() < 1e-12, "{}", sum);
    }
    if let Some(comparison) = solution.comparison {
        let combined = solution.combined.map(Measured::to_base);
        let distances = Method::ALL.map(|method| solution.outcome(method).distance().unwrap().m());
        if let Some(combined) = combined {
            let between = distances[0].min(distances[1])..=distances[0].max(distances[1]);
            prop_assert!(between.contains(&combined.value), "{} {:?}", combined.value, distances);
            prop_assert!(combined.sigma.is_finite() && combined.sigma >= 0.0);
        }
        let agreement = comparison.agreement;
        prop_assert!(agreement.is_none_or(|agreement| agreement.z.is_finite() && agreement.z >= 0.0));
        if agreement.is_some_and(|agreement| agreement.verdict == Verdict::Agree) {
            prop_assert_eq!(solution.suspects(), []);
        }
        prop_assert!(combined.is_none() || !comparison.contradict());
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn no_solution_of_any_problem_holds_a_number_that_is_none(problem in any_problem()) {
        check(&problem.solve())?;
    }

    #[test]
    fn no_solution_of_a_delicate_problem_holds_a_number_that_is_none(problem in delicate_problem()) {
        check(&problem.solve())?;
    }

    /// The two judges of a value, the one before and the one while solving, say the same.
    #[test]
    fn a_problem_whose_inputs_pass_is_refused_only_as_a_whole(problem in any_problem()) {
        let solution = problem.solve();
        for method in Method::ALL {
            match solution.outcome(method) {
                Outcome::Distance(_) => for field in method.fields().into_iter().chain(method.optional_fields()) {
                    prop_assert_eq!(problem.check(field), Ok(()));
                },
                Outcome::Refused { field, refusal } => if let Err(found) = problem.check(field) {
                    prop_assert_eq!(found, refusal);
                },
                Outcome::Incomplete => {
                    let missing = |field: &Field| problem.get(*field).is_none();
                    prop_assert!(method.fields().iter().any(missing));
                }
            }
        }
    }

    #[test]
    fn what_is_set_is_what_is_got(problem in any_problem()) {
        let mut copy = Problem::default();
        for field in Field::ALL {
            copy.set(field, problem.get(field));
            copy.set_sigma(field, problem.sigma(field));
        }
        for field in Field::ALL {
            prop_assert_eq!(copy.get(field).map(f64::to_bits), problem.get(field).map(f64::to_bits));
            prop_assert_eq!(copy.sigma(field).to_bits(), problem.sigma(field).to_bits());
        }
    }

    #[test]
    fn every_f64_is_judged_once(value in any_f64()) {
        prop_assert_eq!(judge::finite(value).is_ok(), value.is_finite());
        prop_assert_eq!(judge::positive(value).is_ok(), value.is_normal() && value > 0.0);
    }

    /// Z·(d + δ) = f·b, also where d + δ is all rounding.
    #[test]
    fn what_all_but_cancels_is_divided_by_exactly((d, o) in cancelling()) {
        let exact = |value: f64| Measured::from_base(value, 0.0);
        let model = Model::stereo(exact(1.0), Measured::from_base(1.0, 0.0), exact(d), exact(o));
        match model {
            Ok(model) => prop_assert_eq!(model.depth().m(), 1.0 / (d + o)),
            Err(_) => prop_assert!(d + o <= 0.0 || !(1.0 / (d + o)).is_normal() || !(d + o).is_normal()),
        }
    }

    /// However alike two distances are, the result lies between them.
    #[test]
    fn distances_that_all_but_agree_are_combined_to_one_of_their_size(
        (first, second) in all_but_equal(1e-3..1e3_f64), r in measured::<f64>(Just(1.0)),
    ) {
        let model = |z: f64| Model::monocular(Measured::from_base(1.0, 0.0), Measured::from_base(z, z * r.sigma), Measured::from_base(1.0, 0.0));
        let (Ok(a), Ok(b)) = (model(first), model(second)) else { return Ok(()) };
        if let Some(combined) = depth_core::agreement::combine(&a, &b) {
            prop_assert!(combined.value.m() >= first.min(second) && combined.value.m() <= first.max(second));
        }
        let comparison = Comparison::of(&a, &b);
        prop_assert!(comparison.agreement.is_none_or(|agreement| agreement.z.is_finite()));
        prop_assert!((comparison.ratio.unwrap() - 1.0).abs() < 64.0 * f64::EPSILON);
    }
}
