package org.maestro.console.members;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.maestro.console.questions.RefusalException;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.Term;

/** The parameters of a call as JSON has them, read as the feature means them. */
final class HandedValues {
  private HandedValues() {}

  /**
   * @throws RefusalException when one is unknown, missing, or of a kind that no parameter has
   */
  static Map<String, Term> read(FeatureType feature, JsonNode given) {
    Map<String, Parameter> known = new TreeMap<>();
    feature.inputs().forEach(parameter -> known.put(parameter.name(), parameter));
    feature.binds().forEach(parameter -> known.put(parameter.name(), parameter));
    Map<String, Term> values = new TreeMap<>();
    for (Map.Entry<String, JsonNode> one : given.properties()) {
      Parameter parameter = known.get(one.getKey());
      if (parameter == null) {
        throw RefusalException.badInput(
            "%s has no parameter %s; it has %s."
                .formatted(
                    feature.name(),
                    one.getKey(),
                    known.isEmpty() ? "none" : String.join(", ", known.keySet())));
      }
      values.put(one.getKey(), value(parameter, one.getValue()));
    }
    feature.inputs().stream()
        .filter(parameter -> !parameter.optional() && !values.containsKey(parameter.name()))
        .filter(parameter -> !parameter.types().contains(Parameter.NEXT_PLACE))
        .findFirst()
        .ifPresent(
            missing -> {
              throw RefusalException.badInput(
                  "%s needs the parameter %s.".formatted(feature.name(), missing.name()));
            });
    return values;
  }

  private static Term value(Parameter parameter, JsonNode given) {
    if (given.isNumber()) {
      return new Term.Number(given.asDouble());
    }
    if (given.isBoolean()) {
      return new Term.Truth(given.asBoolean());
    }
    if (given.isArray()) {
      List<String> numbers = new ArrayList<>();
      given.forEach(number -> numbers.add(number.asText()));
      return new Term.Text(String.join(" ", numbers));
    }
    if (given.isTextual()) {
      String text = given.asText();
      boolean named = !parameter.oneOf().isEmpty() || parameter.hasChoice();
      return named && Term.Variable.isName(text) ? new Term.Name(text) : new Term.Text(text);
    }
    throw RefusalException.badInput(
        "The parameter %s is a number, a truth, a text, or an array of numbers; it is %s."
            .formatted(parameter.name(), given));
  }
}
