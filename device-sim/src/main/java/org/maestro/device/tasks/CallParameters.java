package org.maestro.device.tasks;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.maestro.hal.Position;
import org.maestro.sl.Term;

/** The parameters of a call or a cost question, read with a plain word about what is wrong. */
record CallParameters(Map<String, Object> values) {

  /**
   * @throws InvalidCallException when it is missing or none
   */
  double number(String name) {
    return optionalNumber(name)
        .orElseThrow(
            () ->
                new InvalidCallException("The parameter " + name + " is missing; it is a number."));
  }

  OptionalDouble optionalNumber(String name) {
    Object value = values.get(name);
    if (value == null) {
      return OptionalDouble.empty();
    }
    if (value instanceof Number number && Double.isFinite(number.doubleValue())) {
      return OptionalDouble.of(number.doubleValue());
    }
    throw new InvalidCallException("The parameter " + name + " is a number, not " + value + ".");
  }

  /**
   * @throws InvalidCallException when it is missing, empty or none
   */
  String text(String name) {
    return optionalText(name)
        .filter(text -> !text.isBlank())
        .orElseThrow(
            () -> new InvalidCallException("The parameter " + name + " is missing; it is a text."));
  }

  Optional<String> optionalText(String name) {
    Object value = values.get(name);
    if (value == null || value instanceof String) {
      return Optional.ofNullable((String) value);
    }
    throw new InvalidCallException("The parameter " + name + " is a text, not " + value + ".");
  }

  /** A number from 0 to 1, or another one where there is none. */
  double share(String name, double usual) {
    return values.get(name) == null ? usual : share(name);
  }

  /** A number from 0 to 1. */
  double share(String name) {
    double share = number(name);
    if (share < 0 || share > 1) {
      throw new InvalidCallException(
          "The parameter " + name + " lies between 0 and 1, but is " + share + ".");
    }
    return share;
  }

  /**
   * @throws InvalidCallException when it is missing or none
   */
  Pointer pointer(String name) {
    return optionalPointer(name)
        .orElseThrow(
            () ->
                new InvalidCallException(
                    "The parameter " + name + " is missing; it is a pointer with a ref."));
  }

  Optional<Pointer> optionalPointer(String name) {
    Object value = values.get(name);
    return value == null ? Optional.empty() : Optional.of(Pointer.of(name, value));
  }

  /** A position that is no thing's: x, y and perhaps z, in metres. */
  Optional<Position> optionalPosition(String name) {
    Object value = values.get(name);
    return value == null
        ? Optional.empty()
        : new Pointer(name, Map.of("position", value)).position();
  }

  /** Every parameter that can stand in a fact. */
  Map<String, Term> terms() {
    Map<String, Term> terms = new TreeMap<>();
    values.forEach(
        (name, value) -> {
          if (value instanceof Number number) {
            terms.put(name, new Term.Number(number.doubleValue()));
          } else if (value instanceof Boolean truth) {
            terms.put(name, new Term.Truth(truth));
          } else if (value instanceof String text) {
            terms.put(name, new Term.Text(text));
          } else if (value instanceof Map) {
            terms.put(name, new Term.Name(Pointer.of(name, value).name()));
          }
        });
    return terms;
  }
}
