package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.protocol.Outcome;

/** Things that a robot puts into a cupboard, and takes out again. */
class ContainersTest {
  private static final String BOXES =
      """
      home:box a :Cupboard ; rdfs:label "the box"@en ; :in home:zone-b ; maestro:position "5.2 1.0 0.3" .
      home:chest a :Cupboard ; rdfs:label "the chest"@en ; :in home:zone-b ; maestro:position "3.6 2.4 0.3" .
      """;

  private static Homes homes() {
    Home home =
        new HomeLoader()
            .load(
                Homes.text("bob")
                        .replace(
                            "home:rose a :MobileRobot ;",
                            "home:rose a :ServingRobot ; maestro:viewAngle 75 ; :minimumIlluminance 72 ; :maximumIlluminance 2000 ;")
                    + BOXES,
                "bob.ttl");
    return new Homes(home, Homes.scene("bob-lit", home), 1);
  }

  private static Map<String, Object> at(String name, double... place) {
    return Map.of(
        "ref",
        "https://w3id.org/maestro/home/bob#" + name,
        "position",
        List.of(place[0], place[1], place[2]));
  }

  private static final Map<String, Object> BOX = at("box", 5.2, 1.0, 0.3);
  private static final Map<String, Object> CHEST = at("chest", 3.6, 2.4, 0.3);

  private static Outcome outcome(Homes.Answer answer) {
    return answer.result().orElseThrow().outcome();
  }

  @Test
  void whatIsPutIntoOneIsOutOfSightUntilItIsTakenOut() {
    try (Homes homes = homes()) {
      Map<String, Object> cup = homes.at("Cup");
      assertThat(outcome(homes.call("rose", "pick", Map.of("object", cup))))
          .isEqualTo(Outcome.SUCCEEDED);
      assertThat(
              outcome(
                  homes.call("rose", "putInto", Map.of("object", Homes.ref("Cup"), "target", BOX))))
          .isEqualTo(Outcome.SUCCEEDED);
      assertThat(homes.world().isHidden("Cup")).isTrue();
      assertThat(homes.world().held("rose")).isEmpty();

      assertThat(outcome(homes.call("rose", "pick", Map.of("object", cup))))
          .as("it is not where it was")
          .isEqualTo(Outcome.FAILED);
      assertThat(
              outcome(
                  homes.call(
                      "rose", "takeOut", Map.of("object", Homes.ref("Cup"), "container", CHEST))))
          .as("it is in another one")
          .isEqualTo(Outcome.FAILED);
      assertThat(
              outcome(
                  homes.call(
                      "rose", "takeOut", Map.of("object", Homes.ref("Cup"), "container", BOX))))
          .isEqualTo(Outcome.SUCCEEDED);
      assertThat(homes.world().held("rose")).contains("Cup");
      assertThat(homes.world().isHidden("Cup")).isFalse();
    }
  }
}
