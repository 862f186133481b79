package org.maestro.rats.gateway;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Optional;

/**
 * A light as zigbee2mqtt exposes it.
 *
 * @param address the IEEE address, which never changes
 * @param name the friendly name, which topics have; it may hold slashes
 * @param on what {@code state} is when it is on
 * @param off what {@code state} is when it is off
 * @param fullBrightness of a dimmable one; empty: on or off only
 */
public record ZigbeeLamp(
    String address, String name, String on, String off, Optional<Integer> fullBrightness) {

  /** A device of the bridge's list; empty when it is no light, or the bridge does not know it. */
  static Optional<ZigbeeLamp> of(JsonNode device) {
    for (JsonNode exposed : device.path("definition").path("exposes")) {
      if (exposed.path("type").asText().equals("light")) {
        return Optional.of(lamp(device, exposed.path("features")));
      }
    }
    return Optional.empty();
  }

  private static ZigbeeLamp lamp(JsonNode device, JsonNode features) {
    String on = "ON";
    String off = "OFF";
    Optional<Integer> full = Optional.empty();
    for (JsonNode feature : features) {
      String property = feature.path("property").asText();
      if (property.equals("state")) {
        on = feature.path("value_on").asText(on);
        off = feature.path("value_off").asText(off);
      } else if (property.equals("brightness")) {
        full = Optional.of(Math.max(1, feature.path("value_max").asInt(254)));
      }
    }
    return new ZigbeeLamp(
        device.path("ieee_address").asText(), device.path("friendly_name").asText(), on, off, full);
  }

  /**
   * What to publish to have the lamp give this share of its light.
   *
   * @param level 0 to 1
   */
  ObjectNode order(double level) {
    ObjectNode order = JsonNodeFactory.instance.objectNode();
    if (isOff(level)) {
      return order.put("state", off);
    }
    order.put("state", on);
    fullBrightness.ifPresent(
        full -> order.put("brightness", Math.max(1, Math.round(level * full))));
    return order;
  }

  /** The share of its light that the lamp says it gives; empty when it does not say. */
  Optional<Double> level(JsonNode state) {
    if (!state.path("state").isTextual()) {
      return Optional.empty();
    }
    if (state.path("state").asText().equals(off)) {
      return Optional.of(0.0);
    }
    return fullBrightness.isEmpty()
        ? Optional.of(1.0)
        : Optional.of(state.path("brightness"))
            .filter(JsonNode::isNumber)
            .map(brightness -> brightness.asDouble() / fullBrightness.get());
  }

  /** Whether the lamp says what such an order has it say. */
  boolean follows(double level, double said) {
    double step = fullBrightness.map(full -> 1.5 / full).orElse(0.5);
    return isOff(level) ? said == 0 : said > 0 && Math.abs(said - wanted(level)) <= step;
  }

  private double wanted(double level) {
    return fullBrightness.isPresent() ? level : 1;
  }

  private boolean isOff(double level) {
    return fullBrightness.isPresent() ? level <= 0 : level < 0.5;
  }
}
