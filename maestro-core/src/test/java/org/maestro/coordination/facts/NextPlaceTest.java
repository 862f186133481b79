package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.PretendHouse;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallArguments;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.api.Step;
import org.maestro.sl.Term;

/** What a robot is told of where its plan takes it next. */
class NextPlaceTest {
  private PretendHouse house;

  @BeforeEach
  void furnish() throws IOException {
    try (InputStream turtle = NextPlaceTest.class.getResourceAsStream("/bob.ttl")) {
      house =
          new PretendHouse(
              new HomeLoader()
                  .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl"));
    }
  }

  @Test
  void itIsWhereTheThingIsOfWhichItsNextStepHasToKnow() {
    house.knowledge.state(
        new Source(Source.Kind.OBSERVED, "cam-a"), List.of("(position Bob \"0.8 2.1 0\")"));
    Step move = step(1, "move", Map.of("from", "zone-b", "to", "zone-a"));
    Step place = step(2, "place", Map.of("object", "Cup", "target", "Bob", "zone", "zone-a"));

    assertThat(told(move, List.of(move, place)))
        .containsExactly(
            Map.entry(
                "onward", new Argument(new Term.Text("0.8 2.1 0"), Optional.empty(), Map.of())));
    assertThat(told(place, List.of(move, place))).as("it does not ask").isEmpty();
    assertThat(told(move, List.of(move))).as("it is the last step").isEmpty();
  }

  @Test
  void nothingIsGuessed() {
    Step move = step(1, "move", Map.of("from", "zone-b", "to", "zone-a"));
    Step pick = step(2, "pick", Map.of("object", "Cup", "zone", "zone-a"));
    Step place = step(3, "place", Map.of("object", "Cup", "target", "Bob", "zone", "zone-a"));
    house.knowledge.state(
        new Source(Source.Kind.OBSERVED, "cam-a"), List.of("(position Bob \"0.8 2.1 0\")"));

    assertThat(told(move, List.of(move, pick, place)))
        .as("where the cup is, nobody knows")
        .isEmpty();
  }

  private Map<String, Argument> told(Step step, List<Step> planned) {
    return new NextPlace(new CallArguments(house.knowledge.home(), house.knowledge.snapshot()))
        .of(step, planned);
  }

  private Step step(int number, String feature, Map<String, String> names) {
    Map<String, Term> bindings = new TreeMap<>();
    names.forEach((parameter, name) -> bindings.put(parameter, new Term.Name(name)));
    return new Step(
        number,
        "rose",
        house.knowledge.home().devices().get("rose").features().stream()
            .filter(type -> type.name().equals(feature))
            .findFirst()
            .orElseThrow(),
        bindings,
        1,
        1,
        true,
        Set.of());
  }
}
