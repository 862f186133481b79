package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
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
