package org.maestro.members;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.maestro.coordination.api.Argument;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Translates between terms of MAESTRO-SL and the JSON values of the bus. */
public final class JsonTerms {

  private JsonTerms() {}

  /** A parameter: a plain value, or a pointer with the properties that travel along. */
  public static Object json(Argument argument) {
    if (argument.iri().isEmpty()) {
      return json(argument.value());
    }
    Map<String, Object> pointer = new LinkedHashMap<>();
    pointer.put("ref", argument.iri().get());
    argument
        .properties()
        .forEach(
            (property, values) ->
                pointer.put(
                    property,
                    values.size() == 1
                        ? json(values.get(0))
                        : values.stream().map(JsonTerms::json).toList()));
    return pointer;
  }

  public static Object json(Term term) {
    if (term instanceof Term.Number number) {
      return number.value();
    }
    if (term instanceof Term.Truth truth) {
      return truth.value();
    }
    if (term instanceof Term.Text text) {
      return json(text.value());
    }
    return term instanceof Term.Name name
        ? name.text()
        : term instanceof Term.Iri iri ? iri.text() : SlPrinter.print(term);
  }

  /**
   * {@code "x y z"} becomes an array of numbers, {@code "x y, x y"} an array of such; any other
   * text stays text.
   */
  private static Object json(String text) {
    List<Object> rows = new ArrayList<>();
    for (String row : text.split(",")) {
      String[] cells = row.trim().split("\\s+");
      if (cells.length < 2 || !Arrays.stream(cells).allMatch(JsonTerms::isNumber)) {
        return text;
      }
      rows.add(Arrays.stream(cells).map(Double::valueOf).toList());
    }
    return rows.size() == 1 ? rows.get(0) : rows;
  }

  private static boolean isNumber(String cell) {
    return cell.matches("[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?");
  }

  /** What a member told, but for what stands under no name: no description can ask for that. */
  public static Map<String, Term> terms(Map<String, Object> values) {
    Map<String, Term> terms = new TreeMap<>();
    values.forEach(
        (name, value) -> {
          if (value != null && Term.Variable.isName(name)) {
            terms.put(name, term(value));
          }
        });
    return terms;
  }

  public static Term term(Object value) {
    if (value instanceof Number number) {
      return new Term.Number(number.doubleValue());
    }
    if (value instanceof Boolean truth) {
      return new Term.Truth(truth);
    }
    if (value instanceof List<?> list) {
      return new Term.Text(
          list.stream()
              .map(item -> plain(term(item)))
              .collect(
                  Collectors.joining(list.stream().anyMatch(List.class::isInstance) ? ", " : " ")));
    }
    if (value instanceof Map<?, ?> map && map.get("ref") instanceof String iri) {
      return Term.named(iri.substring(Math.max(iri.lastIndexOf('#'), iri.lastIndexOf('/')) + 1));
    }
    return new Term.Text(String.valueOf(value));
  }

  private static String plain(Term term) {
    return term instanceof Term.Text text ? text.value() : SlPrinter.print(term);
  }
}
