package org.maestro.agents;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.centre.HostedReasoners;
import org.maestro.coordination.api.Reasoner;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.platform.BareJade;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/** A rule engine of somebody else's beside the planner (ADE, 3; A16). */
class HostedReasonersTest {
  private static final Duration SOON = Duration.ofSeconds(30);

  @TempDir Path files;

  /** One that fails each time, and one that wants what nobody knows. */
  private record Wrong(String name, List<Formula> wanted) implements Reasoner {
    @Override
    public List<Formula> wanted(Snapshot known) {
      if (wanted.isEmpty()) {
        throw new IllegalStateException("The engine has no rules.");
      }
      return wanted;
    }
  }

  @Test
  void whatARuleEngineConcludesIsPlannedAndDoneOnce() {
    List<Reasoner> found = HostedReasoners.found();
    assertThat(found).hasExactlyElementsOfTypes(ProductionRules.class);
    List<Reasoner> all =
        List.of(
            new Wrong("empty", List.of()),
            new Wrong("foreign", List.of(SlParser.formula("(danced Bob)"))),
            found.get(0));
    try (BareJade jade = new BareJade("reasoners", files);
        Society society = new Society(jade, all)) {
      Actor usher = society.add("usher", Actor.Part.at(1));
      society.seen("(not (greeted Bob))");
      society.pass(Duration.ofSeconds(5));
      assertThat(usher.heard()).as("it concludes nothing yet").doesNotContain("request");

      society.seen("(guided Bob)");
      society.await(() -> society.told().contains("greet"), SOON);
      society.await(() -> usher.heard().contains("request"), SOON);
      society.pass(Duration.ofSeconds(10));

      assertThat(usher.heard().stream().filter("request"::equals)).hasSize(1);
      assertThat(society.leftover()).isEmpty();

      society.seen("(greeted Bob)");
      society.pass(Duration.ofSeconds(5));
      society.seen("(not (greeted Bob))");
      society.await(() -> usher.heard().stream().filter("request"::equals).count() == 2, SOON);
    }
  }
}
