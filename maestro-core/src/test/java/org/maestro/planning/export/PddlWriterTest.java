package org.maestro.planning.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.statistics.Statistics;
import org.junit.jupiter.api.Test;
import org.maestro.planning.BobsHome;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.OptimalityPropertyTest;
import org.maestro.planning.SmallWorld;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.cases.NotCarriedException;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.pddl.PddlReader;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;

/**
 * What is written as PDDL costs, solved by the other planner, what the platform's planner says;
 * what cannot be written is a small part.
 */
class PddlWriterTest {
  private final OptimalPlanner planner = new OptimalPlanner(20_000);

  @Property(tries = 40)
  void homesLikeBobs(@ForAll Random random) {
    compared(OptimalityPropertyTest.homeTask(random), 90);
  }

  @Property(tries = 200)
  void arbitraryFeatures(@ForAll Random random) {
    compared(OptimalityPropertyTest.puzzleTask(random), 90);
  }

  /**
   * The number is set to nothing, and one is taken from it: to neither of what each gives alone.
   */
  @Test
  void aStepThatChangesANumberTwice() {
    SmallWorld world =
        new SmallWorld()
            .individuals("Thing", "a")
            .individuals("Agent", "agent")
            .word("n", "fluent", "?x - Thing")
            .feature(
                "f",
                "x:Thing ; y:Thing",
                "(>= (n ?x) 0)",
                "(and (assign (n ?y) 0) (decrease (n ?x) (min 1 (n ?x))))")
            .offer("agent", "f", "1")
            .facts("(= (n a) 1)");

    assertThat(check(world.task("(< (n a) 0)")).domain()).contains("(:action f__agent__a__a");
  }

  /**
   * Where a thing is was known and is not known any more: said twice, it does not mean that the
   * thing is no longer there.
   */
  @Test
  void aStepThatForgetsTheSameTwice() {
    SmallWorld world =
        new SmallWorld()
            .individuals("Thing", "a", "b")
            .individuals("Agent", "agent")
            .word("at", "observable functional", "?x - Thing", "?y - Thing")
            .word("seen", "", "?x - Thing")
            .feature(
                "forget",
                "x:Thing ; y:Thing",
                "(at ?x ?y)",
                "(and (not (at ?x ?y)) (not (at ?x ?y)))")
            .feature("look", "x:Thing ; y:Thing", "(unknown (at ?x ?y))", "(seen ?x)")
            .offer("agent", "forget", "1")
            .offer("agent", "look", "1")
            .facts("(at a b)");
    PlanningTask task = world.task("(and (seen a) (unknown (at a b)))");

    assertThat(planner.optimistic(task)).isInstanceOf(PlanningResult.Found.class);
    check(task);
  }

  @Test
  void bobsCupInTheDark() {
    PddlWriter.Texts texts = check(BobsHome.dark().task("(nextTo Cup Bob)"));
    assertThat(texts.domain()).contains("(:action place__rose__cup__bob__zone-");
    assertThat(texts.notCarried()).anyMatch(sentence -> sentence.contains("looked for"));
  }

  /**
   * A task that PDDL cannot carry is refused with a reason, never written wrongly.
   *
   * @param percent of all tasks that have to be written and solved by both, at least
   */
  private void compared(PlanningTask task, int percent) {
    boolean isCompared = !(planner.optimistic(task) instanceof PlanningResult.GaveUp);
    if (isCompared) {
      try {
        check(task);
      } catch (NotCarriedException e) {
        assertThat(e).hasMessageStartingWith("PDDL cannot carry ");
        isCompared = false;
      }
    }
    Statistics.label("written and solved by both")
        .collect(isCompared)
        .coverage(coverage -> coverage.check(true).percentage(share -> share >= percent));
  }

  private PddlWriter.Texts check(PlanningTask task) {
    PlanningResult result = planner.optimistic(task);
    PddlWriter.Texts texts = PddlWriter.write(task, "written");
    GroundTask ground =
        org.maestro.planning.ground.Grounder.ground(
            PddlReader.parse("domain", texts.domain(), "problem", texts.problem()),
            GroundingBudget.endless());
    Solution solution =
        new AnytimePlanner(ground, 200_000_000, line -> {})
            .solve(GroundingBudget.seconds(20, () -> false));
    if (result instanceof PlanningResult.Found found) {
      assertThat(solution.verdict()).isEqualTo(Solution.Verdict.OPTIMAL);
      assertThat(BigDecimal.valueOf(solution.cost()).divide(ground.unit()).doubleValue())
          .isCloseTo(found.plan().cost(), within(1e-6));
    } else if (result instanceof PlanningResult.Impossible) {
      assertThat(solution.verdict()).isEqualTo(Solution.Verdict.UNSOLVABLE);
    }
    return texts;
  }
}
