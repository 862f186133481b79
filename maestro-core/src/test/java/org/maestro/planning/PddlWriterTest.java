package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.math.BigDecimal;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import org.junit.jupiter.api.Test;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.Patience;
import org.maestro.planning.pddl.PddlReader;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;

/** What is written as PDDL costs, solved by the other planner, what the platform's planner says. */
class PddlWriterTest {
  private final OptimalPlanner planner = new OptimalPlanner(20_000);

  @Property(tries = 40, shrinking = ShrinkingMode.OFF)
  void homesLikeBobs(@ForAll long seed) {
    check(OptimalityPropertyTest.homeTask(new Random(seed)));
  }

  @Property(tries = 200, shrinking = ShrinkingMode.OFF)
  void arbitraryFeatures(@ForAll long seed) {
    check(OptimalityPropertyTest.puzzleTask(new Random(seed)));
  }

  @Test
  void bobsCupInTheDark() {
    PddlWriter.Texts texts = check(BobsHome.dark().task("(nextTo Cup Bob)"));
    assertThat(texts.domain()).contains("(:action place__rose__cup__bob__zone-");
    assertThat(texts.notCarried()).anyMatch(sentence -> sentence.contains("looked for"));
  }

  /** A task that PDDL cannot carry is refused with a reason, never written wrongly. */
  private PddlWriter.Texts check(PlanningTask task) {
    PlanningResult result = planner.optimistic(task);
    PddlWriter.Texts texts;
    try {
      texts = PddlWriter.write(task, "written");
    } catch (NotCarriedException e) {
      assertThat(e).hasMessageStartingWith("PDDL cannot carry ");
      return new PddlWriter.Texts("", "", java.util.List.of());
    }
    GroundTask ground =
        org.maestro.planning.ground.Grounder.ground(
            PddlReader.parse("domain", texts.domain(), "problem", texts.problem()),
            Patience.endless());
    Solution solution =
        new AnytimePlanner(ground, 200_000_000, line -> {})
            .solve(Patience.seconds(20, () -> false));
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
