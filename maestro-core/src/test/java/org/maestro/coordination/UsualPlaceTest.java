package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.ontology.home.HomeLoader;

/**
 * Of two places into which it costs the same to look, the usual one comes first, wherever it is.
 */
class UsualPlaceTest {
  private static final String CUP = "home:Cup a :Item ;";

  @ParameterizedTest
  @CsvSource({"a,a", "a,b", "b,a", "b,b"})
  void isLookedIntoFirst(String usual, String actual) {
    PretendHouse house = litHouse(usual);
    house.place.put("Cup", "zone-" + actual);

    assertThat(house.achieve("(nextTo Cup Bob)").reached())
        .as(String.join("\n", house.story))
        .isTrue();

    assertThat(house.story)
        .filteredOn(told -> told.contains("looks for Cup"))
        .first()
        .asString()
        .contains("zone-" + usual);
  }

  private static PretendHouse litHouse(String usual) {
    try (InputStream turtle = UsualPlaceTest.class.getResourceAsStream("/bob.ttl")) {
      String home = new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
      assertThat(home).contains(CUP);
      PretendHouse house =
          new PretendHouse(
              new HomeLoader()
                  .load(
                      home.replace(CUP, CUP + " :usuallyIn home:zone-" + usual + " ;"), "bob.ttl"));
      for (String lamp : new String[] {"lamp-a1", "lamp-a2", "lamp-b1", "lamp-b2", "lamp-b3"}) {
        house.setLevel(lamp, 1);
      }
      return house;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
