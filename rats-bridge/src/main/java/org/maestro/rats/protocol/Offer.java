package org.maestro.rats.protocol;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * The parameters of {@code $offer} (Three-layered architecture, 3.2.1; M43): a member tells the
 * holder of a contract that it could do what another is at.
 *
 * @param task the id of the call that the other is at
 * @param cost in cost units, from where the member is now
 * @param seconds how long it would take it
 */
public record Offer(String task, String feature, double cost, double seconds) {

  public Map<String, Object> parameters() {
    Map<String, Object> parameters = new LinkedHashMap<>();
    parameters.put("task", task);
    parameters.put("f", feature);
    parameters.put("cost", cost);
    parameters.put("seconds", seconds);
    return parameters;
  }

  /** Empty when these are no parameters of {@code $offer}. */
  public static Optional<Offer> of(Map<String, Object> parameters) {
    if (parameters.get("task") instanceof String task
        && parameters.get("f") instanceof String feature
        && parameters.get("cost") instanceof Number cost
        && cost.doubleValue() >= 0) {
      double seconds =
          parameters.get("seconds") instanceof Number number && number.doubleValue() >= 0
              ? number.doubleValue()
              : cost.doubleValue();
      return Optional.of(new Offer(task, feature, cost.doubleValue(), seconds));
    }
    return Optional.empty();
  }
}
