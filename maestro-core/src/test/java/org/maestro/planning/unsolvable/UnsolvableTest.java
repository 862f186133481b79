package org.maestro.planning.unsolvable;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.ground.LiftedTask;
import org.maestro.planning.pddl.PddlReader;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;

/** Why a problem of parcels, of which no road leads to d, has no plan. */
class UnsolvableTest {
  private static final String DOMAIN =
      """
      (define (domain parcels) (:types truck parcel - thing place)
        (:predicates (at ?t - thing ?p - place) (in ?k - parcel ?t - truck) (road ?a ?b - place)
          (sealed ?k - parcel))
        (:functions (fuel))
        (:action drive :parameters (?t - truck ?a ?b - place)
          :precondition (and (at ?t ?a) (road ?a ?b) (>= (fuel) 1))
          :effect (and (not (at ?t ?a)) (at ?t ?b) (decrease (fuel) 1)))
        (:action load :parameters (?k - parcel ?t - truck ?p - place)
          :precondition (and (at ?t ?p) (at ?k ?p))
          :effect (and (in ?k ?t) (not (at ?k ?p))))
        (:action unload :parameters (?k - parcel ?t - truck ?p - place)
          :precondition (and (at ?t ?p) (in ?k ?t) (not (sealed ?k)))
          :effect (and (at ?k ?p) (not (in ?k ?t)))))
      """;

  private static final String PROBLEM =
      """
      (define (problem p) (:domain parcels)
        (:objects t1 - truck k1 k2 k3 - parcel a b c d - place)
        (:init (at t1 a) (at k1 b) (at k2 c) (in k3 t1) (sealed k3)
          (road a b) (road b a) (road b c) (road c b) (= (fuel) 9))
        (:goal GOAL))
      """;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(at k1 d) | needed: (road ? d), for (drive ? ? d), for (unload k1 ? d); nothing brings it about",
        "(and (at k1 a) (at k2 d)) | needed: (road ? d), for (drive ? ? d), for (unload k2 ? d); nothing brings it about",
        "(exists (?t - truck) (at ?t d)) | needed: (road ? d), for (drive ? ? d); nothing brings it about",
        "(at k3 a) | needed: (not (sealed k3)), for (unload k3 ? a); nothing brings it about",
        "(>= (fuel) 10) | needed: (>= (fuel) 10); no order of steps brings it about",
        "(and (at t1 a) (at k2 c) (at t1 b)) | needed together: (at t1 a) and (at t1 b); without any one of them there is a plan",
        "(and (at k1 c) (>= (fuel) 8)) | needed together: (at k1 c) and (>= (fuel) 8); without any one of them there is a plan",
        "(road a d) | the goal contradicts what no step changes"
      })
  void namesWhatNothingBringsAbout(String goal, String reason) {
    assertThat(Unsolvable.reasons(unsolvable(goal), GroundingBudget.endless()))
        .containsExactly(reason);
  }

  @Test
  void namesEachPartThatIsOutOfReach() {
    assertThat(
            Unsolvable.reasons(
                unsolvable("(forall (?k - parcel) (at ?k d))"), GroundingBudget.endless()))
        .hasSize(3)
        .allMatch(reason -> reason.endsWith("nothing brings it about"));
  }

  @Test
  void saysNothingWhenTimeIsOver() {
    assertThat(Unsolvable.reasons(unsolvable("(at k1 d)"), GroundingBudget.seconds(0, () -> false)))
        .isEmpty();
  }

  private static LiftedTask unsolvable(String goal) {
    LiftedTask task = PddlReader.parse("d", DOMAIN, "p", PROBLEM.replace("GOAL", goal));
    Solution solution =
        new AnytimePlanner(
                Grounder.growing(task, GroundingBudget.endless()), 100_000_000, line -> {})
            .first(GroundingBudget.endless());
    assertThat(solution.verdict()).isEqualTo(Solution.Verdict.UNSOLVABLE);
    return task;
  }
}
