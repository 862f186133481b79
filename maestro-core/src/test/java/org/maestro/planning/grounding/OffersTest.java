package org.maestro.planning.grounding;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.BobsHome;
import org.maestro.planning.SmallWorld;
import org.maestro.planning.api.PricedFeature;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** Which features are asked for a way to something: those that may bring it about. */
class OffersTest {
  private final SmallWorld world =
      BobsHome.dark().individuals("Thing Device Place", "tulip").offer("tulip", "move", "5");
  private final Offers offers =
      new Offers(
          world.offer("tulip", "pick", "4").task("(in Cup zone-a)").features(), "nextTo"::equals);

  @Test
  void whereAThingIsWhoeverCarriesChanges() {
    assertThat(changing("in", "Cup", "zone-a"))
        .containsExactly("cam-a observeObject", "cam-b observeObject", "rose place");
  }

  @Test
  void inAHandIsWhatItsOwnerPicks() {
    assertThat(changing("in", "Cup", "tulip")).contains("tulip pick").doesNotContain("rose pick");
  }

  @Test
  void whereARobotIsItChangesItself() {
    assertThat(changing("in", "tulip", "zone-a"))
        .contains("tulip move")
        .doesNotContain("rose move", "rose pick", "tulip pick");
  }

  @Test
  void whatIsNotNamedMayBeAny() {
    assertThat(changing("in", "Cup")).contains("rose pick", "tulip pick", "rose place");
    assertThat(changing("level")).contains("lamp-a1 adjustLight", "lamp-b3 adjustLight");
    assertThat(changing("level", "lamp-b3")).containsExactly("lamp-b3 adjustLight");
    assertThat(changing("illuminance", "zone-a"))
        .as("who shines how far is not told by names")
        .contains("lamp-a1 adjustLight", "lamp-b3 adjustLight", "lux-b measureIllumination");
  }

  @Test
  void whatHoldsBothWaysNamesNobodyByItsPlace() {
    SmallWorld greeters =
        new SmallWorld()
            .word("nextTo", "observable symmetric", "?a - Thing", "?b - Thing")
            .feature("approach", "whom:Thing", "(not (nextTo ?self ?whom))", "(nextTo ?self ?whom)")
            .individuals("Thing Device", "rose", "tulip")
            .offer("rose", "approach", "1")
            .offer("tulip", "approach", "1");
    List<PricedFeature> features = greeters.task("(nextTo rose tulip)").features();

    assertThat(numbers(new Offers(features, "nextTo"::equals), "nextTo", "Bob", "rose")).hasSize(2);
    assertThat(numbers(new Offers(features, name -> false), "nextTo", "Bob", "rose")).isEmpty();
  }

  @Test
  void theirOrderIsThatOfTheTask() {
    List<PricedFeature> features = world.task("(in Cup zone-a)").features();
    PricedFeature dearer =
        new PricedFeature(
            "cam-a", features.get(0).type(), new Price.Stated(SlParser.expression("9")), Map.of());
    List<PricedFeature> next =
        features.stream().map(f -> f.equals(features.get(0)) ? dearer : f).toList();
    offers.become(next);

    assertThat(changing("in", "Cup", "zone-a"))
        .containsExactly("cam-a observeObject", "cam-b observeObject", "rose place");
  }

  private List<String> changing(String name, String... arguments) {
    return numbers(offers, name, arguments).stream()
        .map(offers::feature)
        .map(feature -> feature.member() + " " + feature.type().name())
        .toList();
  }

  private static List<Integer> numbers(Offers offers, String name, String... arguments) {
    return offers.changing(
        name,
        List.of(arguments).stream().<Term>map(Term.Name::new).toList(),
        UnaryOperator.identity());
  }
}
