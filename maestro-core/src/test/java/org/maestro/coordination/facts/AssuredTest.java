package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.PretendHouse;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/** What is not to be so has to be known not to be so. */
class AssuredTest {
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = AssuredTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private static String assured(String goal) {
    return SlPrinter.print(
        Assured.of(SlParser.formula(goal, home.vocabulary()::isFluent), home.vocabulary()));
  }

  @Test
  void whatCanBeSeenHasToBeKnownNotToBeSo() {
    assertThat(assured("(not (in Cup zone-a))"))
        .isEqualTo("(and (not (in Cup zone-a)) (not (unknown (in Cup zone-a))))");
  }

  @Test
  void aNumberThatIsNotToBeReachedHasToBeMeasured() {
    assertThat(assured("(not (>= (illuminance zone-a) 100))"))
        .isEqualTo("(< (illuminance zone-a) 100)");
  }

  @Test
  void negationsGoInwards() {
    assertThat(assured("(not (exists (?x - Item) (in ?x zone-a)))"))
        .isEqualTo(
            "(forall (?x - Item) (and (not (in ?x zone-a)) (not (unknown (in ?x zone-a)))))");
    assertThat(assured("(imply (not (in Cup zone-a)) (in Bob zone-a))"))
        .isEqualTo("(or (in Cup zone-a) (in Bob zone-a))");
  }

  @Test
  void eachComparisonHasItsOpposite() {
    assertThat(assured("(not (< (illuminance zone-a) 1))"))
        .isEqualTo("(>= (illuminance zone-a) 1)");
    assertThat(assured("(not (<= (illuminance zone-a) 1))"))
        .isEqualTo("(> (illuminance zone-a) 1)");
    assertThat(assured("(not (> (illuminance zone-a) 1))"))
        .isEqualTo("(<= (illuminance zone-a) 1)");
    assertThat(assured("(not (= (illuminance zone-a) 1))"))
        .isEqualTo("(or (< (illuminance zone-a) 1) (> (illuminance zone-a) 1))");
    assertThat(assured("(not (= Cup Bob))")).as("of no numbers").isEqualTo("(not (= Cup Bob))");
  }

  @Test
  void eachKindOfFormulaIsTurnedRound() {
    assertThat(assured("(not (and (open door-ab) (locked door-ab)))"))
        .isEqualTo("(or (not (open door-ab)) (not (locked door-ab)))");
    assertThat(assured("(not (or (open door-ab) (locked door-ab)))"))
        .isEqualTo("(and (not (open door-ab)) (not (locked door-ab)))");
    assertThat(assured("(not (not (in Cup zone-a)))")).isEqualTo("(in Cup zone-a)");
    assertThat(assured("(not (imply (in Cup zone-a) (open door-ab)))"))
        .isEqualTo("(and (in Cup zone-a) (not (open door-ab)))");
    assertThat(assured("(not (forall (?d - Door) (open ?d)))"))
        .isEqualTo("(exists (?d - Door) (not (open ?d)))");
  }

  @Test
  void partsOfEachKindOfFormulaAreAssured() {
    String not = "(not (in Cup zone-a))";
    String known = "(and (not (in Cup zone-a)) (not (unknown (in Cup zone-a))))";

    for (String whole :
        List.of(
            "(and %s (open door-ab))",
            "(or %s (open door-ab))",
            "(exists (?d - Door) %s)",
            "(forall (?d - Door) %s)",
            "(keep %s)")) {
      assertThat(assured(whole.formatted(not))).isEqualTo(whole.formatted(known));
    }
  }

  @Test
  void theRestStaysAsItIs() {
    String goal = "(and (nextTo Cup Bob) (>= (illuminance zone-a) 100))";

    assertThat(assured(goal)).isEqualTo(goal);
  }

  @Test
  void whatNobodyHasLookedForIsNotCalledAway() {
    PretendHouse house = new PretendHouse(home);
    house.ambientLux.put("zone-a", 100.0);
    house.place.put("Cup", "zone-a");

    GoalOutcome outcome = house.achieve("(not (in Cup zone-a))");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).contains("observeObject cam-a");
    assertThat(house.place.get("Cup")).isNotEqualTo("zone-a");
  }
}
