package org.maestro.planning.optimal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.BobsHome;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.SmallWorld;
import org.maestro.planning.api.OpenPrice;
import org.maestro.planning.api.PlanningResult.Found;
import org.maestro.planning.api.PricedFeature.ExactPrice;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** Whose prices may make another plan the cheapest. */
class RivalStepsTest {
  private static final String FETCH = "(nextTo Cup Bob)";

  private final SmallWorld world =
      BobsHome.dark().facts("(in Cup zone-a)", "(in Bob zone-b)", "(in rose zone-b)");

  private void robot(String name, String zone) {
    world
        .individuals("Thing Device Place", name)
        .facts("(in %s %s)".formatted(name, zone), "(= (payload %s) 0.5)".formatted(name))
        .offer(name, "move", new Price.Asked(SlParser.expression("0.5")))
        .offer(name, "pick", "4")
        .offer(name, "place", "3");
  }

  private List<String> rivals() {
    Found found = (Found) new OptimalPlanner().solve(world.task(FETCH));
    return found.rivals().stream().map(RivalStepsTest::text).toList();
  }

  private static String text(OpenPrice price) {
    return "%s %s %s to %s"
        .formatted(
            price.step().member(),
            price.step().feature(),
            ((Term.Name) price.step().bindings().get("from")).text(),
            ((Term.Name) price.step().bindings().get("to")).text());
  }

  @Test
  void anotherThatMayCostNoMoreIsOne() {
    robot("tulip", "zone-b");
    robot("daisy", "zone-b");

    assertThat(rivals()).contains("daisy move zone-b to zone-a", "daisy move zone-a to zone-b");
  }

  @Test
  void whatCanBeDoneNowComesFirst() {
    robot("tulip", "zone-b");
    robot("daisy", "zone-b");

    assertThat(rivals().get(0)).isEqualTo("daisy move zone-b to zone-a");
  }

  @Test
  void whoCostsMoreThanThePlanInAnyCaseIsNone() {
    robot("tulip", "zone-b");

    assertThat(rivals()).as("rose's moves cost 5").noneMatch(text -> text.startsWith("rose"));
  }

  @Test
  void whereAllPricesOfThePlanAreKnownNobodyIs() {
    robot("tulip", "zone-b");
    robot("daisy", "zone-b");
    world.told("tulip", "move", Map.of("from", "zone-b", "to", "zone-a"), new ExactPrice(0.5, 1));
    world.told("tulip", "move", Map.of("from", "zone-a", "to", "zone-b"), new ExactPrice(0.5, 1));

    assertThat(rivals()).isEmpty();
  }
}
