package org.maestro.planning.pddl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.math.BigDecimal;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;

/** Conditions of any kind and conditional effects, as domains of others have them. */
class AdlTest {
  private static final String BRIEFCASE =
      """
      (define (domain briefcase)
        (:requirements :adl)
        (:types thing place)
        (:predicates (at?t - thing ?p -place) (in ?t -thing) (here ?p - place))
        (:functions (total-cost))
        (:action move
          :parameters (?from ?to -place)
          :precondition (here ?from)
          :effect (and (here ?to) (not (here ?from)) (increase (total-cost) 1)
            (forall (?t - thing) (when (in ?t) (and (at ?t ?to) (not (at ?t ?from)))))))
        (:action put :parameters (?t - thing ?p - place)
          :precondition (and (here ?p) (at ?t ?p) (not (in ?t)))
          :effect (and (in?t) (increase (total-cost) 1)))
        (:action take :parameters (?t - thing) :precondition (in ?t)
          :effect (and (not (in ?t)) (increase (total-cost) 1))))
      """;

  @Test
  void whatIsInTheBriefcaseMovesWithIt() {
    assertThat(
            plan(
                BRIEFCASE,
                briefcase(
                    "(and (at pen office) (at book home) (forall (?t - thing) (not (in ?t))))"),
                "6"))
        .containsSubsequence("(put pen home)", "(move home office)", "(take pen)");
  }

  @Test
  void theCheapestOfSeveralGoalsIsReached() {
    String problem =
        briefcase("(or (and (at pen office) (at book home)) (exists (?t - thing) (in ?t)))");

    assertThat(plan(BRIEFCASE, problem, "1")).hasSize(1).allMatch(step -> step.startsWith("(put "));
  }

  @Test
  void aGoalThatNothingChangesIsDecidedAtOnce() {
    String domain = BRIEFCASE.replace("(:functions", "(:constants home - place) (:functions");
    String never = briefcase("(imply (not (= home office)) (= office home))");
    String already = briefcase("(or (= home office) (not (= office home)))");

    assertThat(solution(domain, never).verdict()).isEqualTo(Solution.Verdict.UNSOLVABLE);
    assertThat(plan(domain, already, "0")).isEmpty();
  }

  /** A product is shipped when all that it includes is made: of twenty parts each has a few. */
  @Test
  void whatNoActionChangesIsDecidedForEachObject() {
    String domain =
        """
        (define (domain orders)
          (:requirements :typing :universal-preconditions :disjunctive-preconditions)
          (:types part order)
          (:predicates (includes ?o - order ?p - part) (made ?p - part) (shipped ?o - order))
          (:functions (total-cost))
          (:action make :parameters (?p - part) :precondition (not (made ?p))
            :effect (and (made ?p) (increase (total-cost) 1)))
          (:action ship :parameters (?o - order)
            :precondition (forall (?p - part) (imply (includes ?o ?p) (made ?p)))
            :effect (and (shipped ?o) (increase (total-cost) 1))))
        """;
    String problem =
        "(define (problem p) (:domain orders) (:objects o1 o2 - order %s - part) (:init (= (total-cost) 0) %s) (:goal (forall (?o - order) (shipped ?o))) (:metric minimize (total-cost)))"
            .formatted(
                names("p", 20),
                "(includes o1 p1) (includes o1 p2) (includes o2 p2) (includes o2 p19)");

    assertThat(plan(domain, problem, "5"))
        .contains("(make p1)", "(make p2)", "(make p19)", "(ship o1)", "(ship o2)");
  }

  @Test
  void anActionThatCanGoInTooManyWaysIsNamed() {
    String problem =
        briefcase("(at pen office)").replace("pen book", "pen book " + names("thing", 13));

    assertThatThrownBy(() -> PddlReader.parse("d", BRIEFCASE, "p", problem))
        .isInstanceOf(PddlException.class)
        .hasMessage(
            "d:6:12: move can go in more than 4096 ways by its or, forall and when; divide it into"
                + " several.");
  }

  private static String names(String name, int count) {
    return IntStream.range(0, count).mapToObj(i -> name + i).collect(Collectors.joining(" "));
  }

  private static String briefcase(String goal) {
    return "(define (problem p) (:domain briefcase) (:objects pen book - thing home office - place) (:init (here office) (at pen home) (at book office) (= (total-cost) 0)) (:goal %s) (:metric minimize (total-cost)))"
        .formatted(goal);
  }

  private static List<String> plan(String domain, String problem, String cost) {
    GroundTask task = ground(domain, problem);
    Solution solution = solve(task);
    assertThat(solution.verdict()).isEqualTo(Solution.Verdict.OPTIMAL);
    List<String> steps =
        solution.operators().stream()
            .map(task.names()::operator)
            .filter(step -> !step.isEmpty())
            .toList();
    assertThat(BigDecimal.valueOf(solution.cost()).divide(task.unit())).isEqualByComparingTo(cost);
    return steps;
  }

  private static Solution solution(String domain, String problem) {
    return solve(ground(domain, problem));
  }

  private static GroundTask ground(String domain, String problem) {
    return Grounder.ground(PddlReader.parse("d", domain, "p", problem), GroundingBudget.endless());
  }

  private static Solution solve(GroundTask task) {
    return new AnytimePlanner(task, 200_000_000, line -> {}).solve(GroundingBudget.endless());
  }
}
