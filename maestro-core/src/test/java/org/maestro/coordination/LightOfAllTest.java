package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** What all of a kind are to be is measured of each, not reckoned. */
class LightOfAllTest {
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = LightOfAllTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  @Test
  void weakLampsAreNoticedBeforeAllZonesAreCalledLit() {
    PretendHouse house = new PretendHouse(home);
    house.weak.add("lamp-b1");
    house.weak.add("lamp-b2");

    GoalOutcome outcome = house.achieve("(forall (?z - Zone) (>= (illuminance ?z) 60))");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.lux("zone-a")).isGreaterThanOrEqualTo(60);
    assertThat(house.lux("zone-b")).isGreaterThanOrEqualTo(60);
  }
}
