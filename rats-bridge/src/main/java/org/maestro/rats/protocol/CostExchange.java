package org.maestro.rats.protocol;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The content of {@code $cost} (Three-layered architecture, 3.2.2; M54): a feature and parameter
 * sets on the way there, one answer for each set, in order, on the way back.
 */
public record CostExchange(String feature, List<Map<String, Object>> sets) {

  public Map<String, Object> parameters() {
    Map<String, Object> parameters = new LinkedHashMap<>();
    parameters.put("feature", feature);
    parameters.put("sets", sets);
    return parameters;
  }

  /** Empty when these are no parameters of {@code $cost}. */
  public static Optional<CostExchange> of(Map<String, Object> parameters) {
    if (!(parameters.get("feature") instanceof String feature)
        || !(parameters.get("sets") instanceof List<?> items)) {
      return Optional.empty();
    }
    List<Map<String, Object>> sets = new ArrayList<>();
    for (Object item : items) {
      if (!(item instanceof Map<?, ?> map)) {
        return Optional.empty();
      }
      Map<String, Object> set = new LinkedHashMap<>();
      map.forEach((name, value) -> set.put(String.valueOf(name), value));
      sets.add(set);
    }
    return Optional.of(new CostExchange(feature, List.copyOf(sets)));
  }

  /** The result's values. */
  public static Map<String, Object> values(List<CostAnswer> answers) {
    List<Map<String, Object>> costs = new ArrayList<>();
    for (CostAnswer answer : answers) {
      Map<String, Object> cost = new LinkedHashMap<>();
      answer.cost().ifPresent(value -> cost.put("cost", value));
      answer.seconds().ifPresent(value -> cost.put("seconds", value));
      answer.reason().ifPresent(value -> cost.put("reason", value));
      costs.add(cost);
    }
    Map<String, Object> values = new LinkedHashMap<>();
    values.put("costs", costs);
    return values;
  }

  /** Only what the member itself rejects is declined. */
  public List<CostAnswer> answers(Result result) {
    String reason = result.error().map(RatsError::message).orElse("no reason given");
    return switch (result.outcome()) {
      case SUCCEEDED -> answers(result.values());
      case REJECTED -> refused(reason);
      default -> unanswered(reason);
    };
  }

  /** What the result's values say; what is missing in them was not answered. */
  public List<CostAnswer> answers(Map<String, Object> values) {
    List<?> costs = values.get("costs") instanceof List<?> list ? list : List.of();
    List<CostAnswer> answers = new ArrayList<>();
    for (int index = 0; index < sets.size(); index++) {
      answers.add(
          index < costs.size() && costs.get(index) instanceof Map<?, ?> cost
              ? answer(cost)
              : CostAnswer.unanswered("the member gave no answer for this parameter set"));
    }
    return List.copyOf(answers);
  }

  /** The same reason for every set. */
  public List<CostAnswer> refused(String reason) {
    return sets.stream().map(set -> none(reason)).toList();
  }

  /** Nothing came for any set. */
  public List<CostAnswer> unanswered(String reason) {
    return sets.stream().map(set -> CostAnswer.unanswered(reason)).toList();
  }

  private static CostAnswer none(String reason) {
    return new CostAnswer(Optional.empty(), Optional.empty(), Optional.of(reason));
  }

  private static CostAnswer answer(Map<?, ?> cost) {
    return new CostAnswer(
        number(cost.get("cost")),
        number(cost.get("seconds")),
        cost.get("reason") instanceof String reason ? Optional.of(reason) : Optional.empty());
  }

  private static Optional<Double> number(@Nullable Object value) {
    return value instanceof Number number ? Optional.of(number.doubleValue()) : Optional.empty();
  }
}
