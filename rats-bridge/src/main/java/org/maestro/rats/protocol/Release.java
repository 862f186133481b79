package org.maestro.rats.protocol;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * The parameters of {@code $release} (Three-layered architecture, 3.2.1; M44): a member gives a
 * task back before its time is over.
 *
 * @param task the id of the call
 * @param reason one sentence
 */
public record Release(String task, String reason) {

  public Map<String, Object> parameters() {
    Map<String, Object> parameters = new LinkedHashMap<>();
    parameters.put("task", task);
    parameters.put("reason", reason);
    return parameters;
  }

  /** Empty when these are no parameters of {@code $release}. */
  public static Optional<Release> of(Map<String, Object> parameters) {
    return parameters.get("task") instanceof String task
            && parameters.get("reason") instanceof String reason
        ? Optional.of(new Release(task, reason))
        : Optional.empty();
  }
}
