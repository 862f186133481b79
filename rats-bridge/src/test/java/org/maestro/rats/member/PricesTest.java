package org.maestro.rats.member;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;

/** Prices are told within 50 ms, or why they are not (Three-layered architecture, 3.2.2; M54). */
class PricesTest extends MemberOnABus {

  private static final Duration HOP = Duration.ofMillis(2);

  /** Finds out what it costs in so many milliseconds. */
  private final class FindsOut implements Procedure {
    @Override
    public void start(Execution execution) {
      execution.succeed(Map.of());
    }

    @Override
    public CostAnswer cost(Map<String, Object> parameters) {
      throw new IllegalStateException("meant to break: it is asked the other way");
    }

    @Override
    public void cost(Map<String, Object> parameters, Consumer<CostAnswer> answer) {
      int millis = (Integer) parameters.get("millis");
      double price = ((Number) parameters.getOrDefault("price", 2)).doubleValue();
      clock.schedule(
          Duration.ofMillis(millis),
          "rose",
          () -> {
            answer.accept(new CostAnswer(Optional.of(price), Optional.of(1.0), Optional.empty()));
            answer.accept(new CostAnswer(Optional.of(99.0), Optional.of(1.0), Optional.empty()));
          });
    }
  }

  /** Has no price at all. */
  private static final class Breaks implements Procedure {
    private final double price;

    private Breaks(double price) {
      this.price = price;
    }

    @Override
    public void start(Execution execution) {
      execution.succeed(Map.of());
    }

    @Override
    public CostAnswer cost(Map<String, Object> parameters) {
      if (price < 0) {
        throw new IllegalStateException("meant to break");
      }
      return new CostAnswer(Optional.of(price), Optional.of(1.0), Optional.empty());
    }
  }

  @Override
  MemberProfile profile() {
    return new MemberProfile(
        "rose",
        "{}",
        Set.of("standby"),
        "standby",
        Set.of("standby"),
        MemberProfile.byId(
            List.of(
                feature("search", new FindsOut()),
                feature("break", new Breaks(-1)),
                feature("endless", new Breaks(Double.POSITIVE_INFINITY)))));
  }

  private static MemberProfile.Feature feature(String id, Procedure procedure) {
    return new MemberProfile.Feature(
        id, Set.of(), Set.of(), false, Optional.empty(), "standby", procedure);
  }

  @Test
  void whatIsFoundOutInTimeIsToldInTheOrderOfTheQuestion() {
    ask("search", List.of(Map.of("millis", 30, "price", 7), Map.of("millis", 10)));
    run(1);

    assertThat(only().values())
        .isEqualTo(
            Map.of(
                "costs",
                List.of(Map.of("cost", 7.0, "seconds", 1.0), Map.of("cost", 2.0, "seconds", 1.0))));
  }

  @Test
  void whoDoesNotKnowItsPriceWithin50MillisecondsSaysSo() {
    Duration asked = clock.now();
    ask("search", List.of(Map.of("millis", 10), Map.of("millis", 80)));
    run(1);

    assertThat(only().outcome()).isEqualTo(Outcome.TIMED_OUT);
    assertThat(only().error().orElseThrow().code()).isEqualTo(ErrorCode.TIMEOUT);
    assertThat(only().error().orElseThrow().message())
        .contains("rose", "search", "50 ms", "1 of 2 parameter sets");
    assertThat(resultTimes.get(0).minus(asked))
        .isLessThanOrEqualTo(Duration.ofMillis(50).plus(HOP));
  }

  @Test
  void whileItSearchesItListens() {
    ask("search", List.of(Map.of("millis", 40)));
    send(call("p1", "$ping", Map.of()));
    run(1);
    assertThat(results).extracting(Result::id).containsExactly("p1", "c1");
  }

  @Test
  void whoseReckoningBreaksOffOrGivesNoAmountSaysSo() {
    for (String feature : List.of("break", "endless")) {
      List<CostAnswer> answers = answers(feature, Map.of());
      assertThat(answers).hasSize(1);
      assertThat(answers.get(0).cost()).isEmpty();
      assertThat(answers.get(0).reason().orElseThrow()).startsWith("the price ");
    }
  }

  @Test
  void aCallerTakesALatePriceForUnansweredAndNotForARefusal() {
    List<CostAnswer> answers = answers("search", Map.of("millis", 80));
    assertThat(answers).hasSize(1);
    assertThat(answers.get(0).answered()).isFalse();
    assertThat(answers.get(0).reason().orElseThrow()).contains("50 ms");
  }

  private List<CostAnswer> answers(String feature, Map<String, Object> set) {
    List<CostAnswer> answers = new ArrayList<>();
    try (RatsLink link = BusLink.connect("planner", "test", bus.client("planner"), clock)) {
      run(1);
      link.cost("rose", feature, List.of(set), answers::addAll);
      run(1);
    }
    return answers;
  }

  private void ask(String feature, List<Map<String, Object>> sets) {
    send(call("c1", "$cost", Map.of("feature", feature, "sets", sets)));
  }
}
