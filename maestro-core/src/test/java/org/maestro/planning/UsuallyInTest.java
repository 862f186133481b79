package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.sl.Term;

/** Among places at which a look costs the same, the one where a thing usually is comes first. */
class UsuallyInTest {

  @ParameterizedTest
  @CsvSource({"2", "3", "12"})
  void itIsLookedForFirstWhereItUsuallyIs(int zones) {
    for (String goal : List.of("(exists (?z - Zone) (in Cup ?z))", "(canSee ?agent Cup)")) {
      for (int usual = 1; usual <= zones; usual++) {
        assertThat(firstLookFor("Cup", home(zones, usual), goal))
            .as("%s, usually in zone-%d of %d", goal, usual, zones)
            .isEqualTo("zone-" + usual);
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"2", "3", "12"})
  void alsoWhenItIsToBeBroughtByOneWhoHasToBeSoughtToo(int zones) {
    for (int usual = 1; usual <= zones; usual++) {
      SmallWorld home = home(zones, usual).individuals("Thing", "Bob");
      robot(home);

      assertThat(firstLookFor("Cup", home, "(nextTo Cup Bob)"))
          .as("usually in zone-%d of %d", usual, zones)
          .isEqualTo("zone-" + usual);
    }
  }

  /** Nobody knows where it stands. */
  private static void robot(SmallWorld home) {
    home.individuals("Thing Device Place", "rose")
        .facts("(= (payload rose) 0.5)")
        .offer("rose", "move", "0.5")
        .offer("rose", "pick", "4")
        .offer("rose", "place", "3");
  }

  private static SmallWorld home(int zones, int usual) {
    String[] names =
        IntStream.rangeClosed(1, zones).mapToObj(i -> "zone-" + i).toArray(String[]::new);
    SmallWorld home = BobsHome.words().individuals("Zone Place", names);
    home.individuals("Thing Item", "Cup")
        .facts("(= (mass Cup) 0.25)", "(usuallyIn Cup zone-" + usual + ")");
    for (String zone : names) {
      home.facts("(= (illuminance " + zone + ") 100)");
      BobsHome.camera(home, "cam-" + zone, zone);
      for (String other : names) {
        home.facts("(adjoins " + zone + " " + other + ")");
      }
    }
    return home;
  }

  private static String firstLookFor(String thing, SmallWorld home, String goal) {
    PlanningResult result = new OptimalPlanner().plan(home.task(goal));
    assertThat(result).isInstanceOf(PlanningResult.Found.class);
    Plan plan = ((PlanningResult.Found) result).plan();
    return plan.steps().stream()
        .filter(step -> new Term.Name(thing).equals(step.bindings().get("object")))
        .filter(step -> step.feature().name().equals("observeObject"))
        .map(step -> ((Term.Name) step.bindings().get("zone")).text())
        .findFirst()
        .orElse("nowhere");
  }
}
