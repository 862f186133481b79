package org.maestro.planning.grounding;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.BobsHome;
import org.maestro.planning.SmallWorld;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.PricedFeature.ExactPrice;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Operator;
import org.maestro.sl.SlParser;

/** What is kept of instances while prices are told. */
class GroundingCacheTest {
  private static final int ANSWERS = 20;
  private static final NumberVector NO_NUMBERS = new NumberVector(new double[0]);

  private final SmallWorld world = BobsHome.dark().facts("(in rose zone-b)", "(in Cup zone-a)");
  private final PlanningTask task = world.task("(in Cup zone-b)");
  private final GroundingCache cache = new GroundingCache(task);

  private static PricedFeature told(PricedFeature move, double cost) {
    return new PricedFeature(
        move.member(),
        move.type(),
        move.price(),
        Map.of(
            Map.of("to", SlParser.term("zone-a"), "from", SlParser.term("zone-b")),
            new ExactPrice(cost, 1)));
  }

  private static PricedFeature reckoned(PricedFeature move, double cost) {
    return new PricedFeature(
        move.member(),
        move.type(),
        new Price.Asked(SlParser.expression("(max 0.5 %s)".formatted(cost))),
        Map.of());
  }

  private PlanningTask with(UnaryOperator<PricedFeature> changed) {
    List<PricedFeature> features =
        task.features().stream()
            .map(feature -> feature.type().name().equals("move") ? changed.apply(feature) : feature)
            .toList();
    return task.withFeatures(features);
  }

  private List<Operator> moves(PlanningTask next) {
    return new Grounder(cache, next)
        .ground().operators().stream()
            .filter(operator -> operator.feature().type().name().equals("move"))
            .toList();
  }

  @Test
  void answersToQuestionsForPricesLeaveNothingBehind() {
    int before = 0;
    for (int cost = 1; cost <= ANSWERS; cost++) {
      double price = cost;
      PlanningTask next = with(move -> told(move, price));
      assertThat(cache.renew(next)).isTrue();

      assertThat(moves(next))
          .hasSize(2)
          .filteredOn(move -> move.bindings().get("to").equals(SlParser.term("zone-a")))
          .singleElement()
          .satisfies(move -> assertThat(move.price().cost(NO_NUMBERS)).isEqualTo(price));
      assertThat(cache.size()).isGreaterThan(0);
      before = before == 0 ? cache.size() : before;
      assertThat(cache.size()).isEqualTo(before);
    }
  }

  @Test
  void aStepHasThePriceThatIsReckonedNow() {
    moves(task);
    for (int cost : List.of(7, 3, 7)) {
      PlanningTask next = with(move -> reckoned(move, cost));
      assertThat(cache.renew(next)).isTrue();

      assertThat(moves(next))
          .hasSize(2)
          .allSatisfy(
              move -> {
                assertThat(move.price().exact()).isFalse();
                assertThat(move.price().cost(NO_NUMBERS)).isEqualTo(cost);
              });
    }
  }
}
