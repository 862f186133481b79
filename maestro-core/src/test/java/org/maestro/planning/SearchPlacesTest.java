package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Comparator;
import java.util.List;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlannedSearch;
import org.maestro.planning.api.PlannedSearch.Place;
import org.maestro.planning.api.PlanningResult;
import org.maestro.sl.Term;

/** What a plan tells of the places between which it had the choice. */
class SearchPlacesTest {
  private static final Offset<Double> ROUNDING = Offset.offset(1e-9);

  /** A look costs 2 everywhere; into the cellar nobody can look. */
  @Test
  void theyComeByWhatItIsExpectedToCostToBeginThere() {
    Plan plan = plan(home().facts("(usuallyIn Cup hall)"));

    PlannedSearch search = plan.searches().get(0);
    assertThat(search.predicate()).isEqualTo("in");
    assertThat(search.arguments()).containsExactly(new Term.Name("Cup"));
    assertThat(search.places())
        .extracting(place -> ((Term.Name) place.value()).text())
        .containsExactly("hall", "kitchen", "attic", "cellar");
    // 0.8 for where it usually is; the rest by floor area: 40, 10 and 10 of 60.
    assertThat(search.places())
        .extracting(Place::chance)
        .usingElementComparator(Comparator.comparingDouble(chance -> Math.rint(chance * 1e9)))
        .containsExactly(0.8, 0.2 * 40 / 60, 0.2 * 10 / 60, 0.2 * 10 / 60);
    List<Place> inView = search.places().subList(0, 3);
    assertThat(inView).allMatch(place -> place.lookCost() == 2);
    assertThat(inView)
        .isSortedAccordingTo(Comparator.comparingDouble(Place::expectedCost))
        .allMatch(place -> place.expectedCost() > 2);
    assertThat(search.places().get(3).lookCost()).isInfinite();
    assertThat(search.places().get(3).expectedCost()).isInfinite();
  }

  /** Of those in view: a second look with what is left of the chances, and then a third. */
  @Test
  void theExpectedCostIsThatOfAllLooksByTheirChances() {
    Plan plan = plan(home().facts("(usuallyIn Cup hall)"));

    double all = 0.8 + 0.2 * 50 / 60;
    double hall = 0.8 / all;
    double kitchen = 0.2 * 40 / 60 / all;
    assertThat(plan.searches().get(0).places().get(0).expectedCost())
        .isCloseTo(2 + (1 - hall) * 2 + (1 - hall - kitchen) * 2, ROUNDING);
  }

  @Test
  void whatIsExcludedIsNoPlaceToLook() {
    Plan plan = plan(home().facts("(not (in Cup hall))"));

    assertThat(plan.searches().get(0).places())
        .extracting(place -> ((Term.Name) place.value()).text())
        .containsExactly("kitchen", "attic", "cellar");
    assertThat(plan.searches().get(0).places().get(0).chance()).isCloseTo(40.0 / 60, ROUNDING);
  }

  private static SmallWorld home() {
    SmallWorld home =
        BobsHome.words()
            .word("floorArea", "fluent", "?z - Zone")
            .individuals("Zone Place", "attic", "cellar", "hall", "kitchen")
            .individuals("Thing Item", "Cup")
            .facts("(= (floorArea hall) 40)", "(= (floorArea kitchen) 40)")
            .facts("(= (floorArea attic) 10)", "(= (floorArea cellar) 10)");
    for (String zone : List.of("attic", "hall", "kitchen")) {
      home.facts("(= (illuminance " + zone + ") 100)");
      BobsHome.camera(home, "cam-" + zone, zone);
    }
    return home;
  }

  private static Plan plan(SmallWorld home) {
    PlanningResult result =
        new OptimalPlanner().plan(home.task("(exists (?z - Zone) (in Cup ?z))"));
    assertThat(result).isInstanceOf(PlanningResult.Found.class);
    return ((PlanningResult.Found) result).plan();
  }
}
