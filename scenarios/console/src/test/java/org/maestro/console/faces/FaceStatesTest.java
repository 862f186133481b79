package org.maestro.console.faces;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Message;

class FaceStatesTest {
  private static final String SITE = "faces";
  private static final String FACE = "screen-living";

  private Home home;
  private FaceStates states;

  @BeforeEach
  void load() throws IOException {
    try (InputStream text = getClass().getResourceAsStream("/homes/rooms.ttl")) {
      home =
          new HomeLoader()
              .load(new String(text.readAllBytes(), StandardCharsets.UTF_8), "rooms.ttl");
    }
    states = new FaceStates(SITE, () -> home, () -> ReadingRights.ALL);
  }

  @Test
  void aSentenceThatWasOverBeforeAnybodyAskedIsToldAllTheSame() {
    tells();
    assertThat(told().has("sentence")).isFalse();

    tells("(isSaying screen-living \"One.\")");
    tells("(isSaying screen-living \"One.\")", "(= (expressionStrength screen-living) 1)");
    tells("(= (expressionStrength screen-living) 1)");
    tells("(isSaying screen-living \"Two.\")");
    tells();

    assertThat(told().path("sentences").asInt()).isEqualTo(2);
    assertThat(told().path("sentence").asText()).isEqualTo("Two.");
    assertThat(told().path("facts")).isEmpty();
  }

  @Test
  void theSameSentenceSaidAgainIsAnotherOne() {
    tells("(isSaying screen-living \"One.\")");
    tells();
    tells("(isSaying screen-living \"One.\")");

    assertThat(told().path("sentences").asInt()).isEqualTo(2);
  }

  @Test
  void whatNotAllMayReadIsNotToldAfterwardsEither() {
    states =
        new FaceStates(SITE, () -> home, () -> new ReadingRights(Set.of("isSaying"), Set.of()));
    tells("(isSaying screen-living \"One.\")");
    tells();

    assertThat(told().path("sentences").asInt()).isEqualTo(1);
    assertThat(told().has("sentence")).isFalse();
  }

  private JsonNode told() {
    return states.all().at("/faces/0");
  }

  private void tells(String... facts) {
    MemberState state =
        new MemberState(
            FACE, "boot", "ready", List.of(facts), List.of(), List.of(), List.of(), List.of());
    states.heard(
        new Message(
            new Topics(SITE).state(FACE), new WireFormat().encode(state), true, Optional.empty()));
  }
}
