package org.maestro.device.tasks;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;

/**
 * A pointer into the knowledge base as it travels in a call (Three-layered architecture, 3.2.3;
 * M58): an individual, and the properties of it that the feature needs.
 *
 * @param name the individual's local name
 */
record Pointer(String name, Map<String, Object> properties) {

  static Pointer of(String parameter, Object value) {
    if (!(value instanceof Map<?, ?> map) || !(map.get("ref") instanceof String ref)) {
      throw new InvalidCallException(
          "The parameter " + parameter + " is a pointer with a ref, not " + value + ".");
    }
    Map<String, Object> properties = new TreeMap<>();
    map.forEach((key, property) -> properties.put(String.valueOf(key), property));
    properties.remove("ref");
    return new Pointer(
        ref.substring(Math.max(ref.lastIndexOf('#'), ref.lastIndexOf('/')) + 1), properties);
  }

  Target target() {
    return new Target(name, properties);
  }

  /** Where it is known to be, if the caller knows. */
  Optional<Position> position() {
    return point("position");
  }

  /** The same of any property that is a point. */
  Optional<Position> point(String property) {
    Object value = properties.get(property);
    if (value == null) {
      return Optional.empty();
    }
    List<Double> numbers = numbers(value, " ");
    if (numbers.size() < 2) {
      throw new InvalidCallException(
          "The " + property + " of " + name + " is [x, y, z], not " + value + ".");
    }
    return Optional.of(
        new Position(numbers.get(0), numbers.get(1), numbers.size() > 2 ? numbers.get(2) : 0));
  }

  /** A property that is a number. */
  OptionalDouble number(String property) {
    Object value = properties.get(property);
    return value == null ? OptionalDouble.empty() : OptionalDouble.of(numbers(value, " ").get(0));
  }

  Optional<Polygon> outline() {
    Object value = properties.get("outline");
    if (value == null) {
      return Optional.empty();
    }
    try {
      if (value instanceof String text) {
        return Optional.of(Polygon.parse(text));
      }
      List<Point2> corners = new ArrayList<>();
      if (value instanceof List<?> list) {
        for (Object corner : list) {
          List<Double> numbers = numbers(corner, " ");
          if (numbers.size() == 2) {
            corners.add(new Point2(numbers.get(0), numbers.get(1)));
          }
        }
      }
      return Optional.of(new Polygon(corners));
    } catch (IllegalArgumentException e) {
      throw new InvalidCallException("The outline of " + name + " is none. " + e.getMessage());
    }
  }

  private List<Double> numbers(Object value, String separator) {
    List<Double> numbers = new ArrayList<>();
    List<?> parts =
        value instanceof List<?> list ? list : List.of(String.valueOf(value).split(separator));
    for (Object part : parts) {
      try {
        numbers.add(
            part instanceof Number number
                ? number.doubleValue()
                : Double.valueOf(String.valueOf(part)));
      } catch (NumberFormatException e) {
        throw new InvalidCallException(
            "A coordinate of " + name + " is a number, not " + part + ".");
      }
    }
    return numbers;
  }
}
